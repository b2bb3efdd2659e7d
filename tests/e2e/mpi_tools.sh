#!/bin/bash
# mpi_tools.sh - the tools and MPI programs: races on buffers under way, accesses of calls (nxcc --asan), what is left over and what does
# not fit (--mpi-checks), traces, errors. All speak of MPI's calls and the program's lines, and none changes a virtual time.
# without: app
. "$(dirname "$0")/common.bash"
"$BUILD/nxcc" --as-mpi bin >links

build() { # NAME OPTIONS...: mpi_tools/NAME.c
    local name=$1
    shift
    check "$name.c compiles $*" bin/mpicc -g -Wall "$@" -o "$name" "$tests/mpi_tools/$name.c"
}
line() { # FILE TEXT: "FILE:LINE" of the first line with the text
    echo "$1:$(grep -nF -- "$2" "$tests/mpi_tools/$1" | head -1 | cut -d: -f1)"
}
# told FILE TEXT...: what the run has said has a line with all of these
told() {
    local text lines
    lines=$(cat err)
    for text in "$@"; do
        lines=$(grep -F -- "$text" <<<"$lines")
    done
    [ -n "$lines" ]
}
times() { grep -E '^(virtual time|digest) ' err; }
same_times() { # ARGS OF RUN: as the program built plainly, whose times are in `plain`
    run "$@"
    check "the same times: $*" diff plain <(times)
}

# --- races ---
build under_way -O0
run -m delta -n 4 under_way
times >plain
cp out plain.out
run -m delta -n 4 under_way well
times >plain.well
build under_way -O0 --races
run -m delta -n 4 under_way
check "races are found" ended_with 3
check "with the times that it has without --races" diff plain <(times)
check "and the output" cmp plain.out out
what=$(line under_way.c 'out = in')
check "a receive under way is read" told "race on in: main program reads at $what the buffer of MPI_Irecv at $(line under_way.c '&in, 1, MPI_INT, left, 3')"
check "a send under way is written to, also one that has left" told "race on out: main program writes at $what the buffer of MPI_Isend at $(line under_way.c '&out, 1')"
check "a piece of a column is written to" told "race on grid[19]: main program writes at $(line under_way.c 'grid[19] = 2')" "of MPI_Isend at $(line under_way.c '&grid[9], 1, column')"
check "a collective's buffer is written to" told "race on kept: main program writes at $(line under_way.c 'kept = 3')" "of MPI_Iallreduce at $(line under_way.c 'MPI_Iallreduce')"
check "a buffer that comes from neighbours is written to" told "race on ends[1]: main program writes at $(line under_way.c 'ends[1] = 1')" "of MPI_Ineighbor_allgather at $(line under_way.c 'MPI_Ineighbor')"
check "a buffer of two groups' root is written to" told "race on all[1]: main program writes at $(line under_way.c 'all[1] = 1')" "of MPI_Igather at $(line under_way.c 'MPI_Igather')"
check "a persistent send's buffer is written to" told "at $(line under_way.c 'kept = 6')" "of MPI_Start at $(line under_way.c 'MPI_Start')"
check "that is all, one report a variable" [ "$(grep -c '^race ' err)" = 6 ]
check "how long it is under way" said 'until MPI_Wait, or a call like it, has completed its request'
check "nothing is of NX" [ "$(grep -cE 'msgwait|csend|irecv\(' err)" = 0 ]
run -m delta -n 4 under_way well
check "a program that waits has no races" ended_with 0
check "nor other times" diff plain.well <(times)

# --- buffers that are too small ---
build too_small -O1 --asan
for how in "column:read of 8 bytes, just behind a block of 800 bytes:MPI_Bcast" \
    "reduce:read of 808 bytes, the last 8 of them just behind a block of 800 bytes:MPI_Allreduce" \
    "gather:write of 1920 bytes:MPI_Gather"; do
    IFS=: read -r name what call <<<"$how"
    run -n 4 too_small "$name"
    check "$call: a buffer too small is found" told "heap-buffer-overflow: $what"
    check "$call: it is named" grep -qx "  $call" err
    check "$call: so is the program's line, as the first" grep -qx "    in main ($(line too_small.c "$call("))" err
done

# --- what is left over ---
build left_over -O2
run -m delta -n 4 left_over
check "without --mpi-checks nothing is told" [ "$(grep -c MPI: err)" = 0 ]
times >plain
same_times -m delta -n 4 --mpi-checks left_over
check "the run has a status of its own" ended_with 3
while IFS='|' read -r what text; do
    check "$what" told "MPI: $what: " " at $(line left_over.c "$text")" "4 times, on nodes 0-3"
done <<'END'
request never completed|MPI_Irecv(
persistent request not freed|MPI_Send_init(
message never received|MPI_Send(
communicator not freed|MPI_Comm_dup(MPI_COMM_WORLD, &dup
datatype not freed|MPI_Type_contiguous(
group not freed|MPI_Comm_group(
datatypes differ|MPI_Sendrecv(
END
check "that is all" [ "$(grep -c MPI: err)" = 7 ]
check "a message: who, whom, tag, communicator, length" told "node 0 to node 1, tag 5 in communicator 2, 4 bytes"
check "kinds of numbers" told "sends reals" "receives integers" "tag 6 in MPI_COMM_WORLD"
run -q -n 4 --mpi-checks left_over well
check "a program that cleans up has nothing" ended_with 0
check "and nothing is told" [ ! -s err ]
run -q -n 4 --mpi-checks left_over ends
check "an end without MPI_Finalize: MPI_Init's line" told "MPI: MPI_Finalize never called: MPI_Init at $(line left_over.c 'MPI_Init(')" "4 times, on nodes 0-3"
check "what is left over there" told "MPI: communicator not freed: "
run -q -n 4 --mpi-checks left_over callers
check "a line with two callers: one finding" told "MPI: communicator not freed: MPI_Comm_dup at $(line left_over.c 'MPI_Comm_dup(MPI_COMM_WORLD, to')" ", 8 times, on nodes 0-3"
check "and it is told once" [ "$(grep -c MPI: err)" = 1 ]
run -q -n 4 --mpi-checks left_over attributes
check "functions of attributes free communicators, also in MPI_Finalize" ended_with 0
check "and nothing is told of them" [ ! -s err ]
run -q -n 4 --mpi-checks left_over attributes kept
for text in 'MPI_Comm_dup(MPI_COMM_WORLD, &one' 'MPI_Comm_split(' 'MPI_Comm_dup(*(MPI_Comm'; do
    check "functions of attributes free none: $text" told "MPI: communicator not freed: " " at $(line left_over.c "$text")" "4 times, on nodes 0-3"
done
check "that is all of them" [ "$(grep -c MPI: err)" = 3 ]
for workers in 1 2 4; do
    run_results -w $workers -n 9 --mpi-checks left_over >fast
    run_results --engine reference -n 9 --mpi-checks left_over >reference
    check "both engines tell the same, $workers workers" cmp reference fast
done
check "mpif90 compiles" bin/mpif90 -O2 -g -o forgets "$tests/mpi_tools/forgets.f90"
run -q -n 2 --mpi-checks forgets
check "Fortran: the call and its line" told "request never completed: MPI_Irecv at $(line forgets.f90 'call MPI_Irecv'), 2 times"

# --- what does not fit ---
build unfit -O2
while IFS='|' read -r how kind detail; do
    run -q -n 3 --mpi-checks unfit "$how"
    check "$how: $kind" told "MPI: $kind: MPI_" "unfit.c:" "$detail"
    check "$how: it is told once" [ "$(grep -c MPI: err)" = 1 ]
done <<'END'
root|roots differ|root 0 on node 0, 1 on node 1, in collective 1 of MPI_COMM_WORLD
op|operations differ|MPI_SUM on node 0, MPI_MAX on node 1
type|datatypes differ|integers on node 0, reals on node 1
call|collectives differ|node 1 calls MPI_Barrier, node 0 MPI_Bcast
END
run -q -n 8 --mpi-checks unfit stuck
check "what does not fit is told before the deadlock that it leads to" \
    [ "$(sed -n '1,2s/^touchstone run: \([a-zA-Z]*\):.*/\1/p' err | tr '\n' ' ')" = "MPI deadlock " ]
run -q -n 3 --mpi-checks unfit count
check "count: what differs" told "MPI: counts or datatypes differ: MPI_Bcast at" "16 bytes on node 0, 32 on node 1"
run -q -n 3 --mpi-checks unfit caller
check "a line that two callers come to is named once" told "MPI: counts or datatypes differ: MPI_Bcast at $(line unfit.c 'MPI_Bcast(y, count'): 16 bytes"
run -q -n 3 --mpi-checks unfit part
check "a part of a split communicator: what differs" told "MPI: counts or datatypes differ: MPI_Bcast at" "32 bytes on node 2, 16 on node 0"
run -q -n 6 --mpi-checks unfit parts
check "parts of a split communicator are not compared with each other" [ ! -s err ]

build signatures -O2
while IFS='|' read -r how calls detail; do
    run -q -n 2 --mpi-checks signatures $how
    check "$how: other kinds of numbers of the same length" told "MPI: datatypes differ: $calls" "$detail"
    check "$how: it is told once" [ "$(grep -c MPI: err)" = 1 ]
done <<END
halves|MPI_Send at $(line signatures.c 'MPI_Send(') and MPI_Recv at|node 0 sends reals of 8 bytes, node 1 receives reals of 4 bytes, with tag 1
behind|MPI_Send at|node 0 sends reals of 8 bytes as number 3, node 1 receives reals of 4 bytes as number 3
bytes|MPI_Send at|node 0 sends integers, node 1 receives bytes
start|MPI_Startall at|node 0 sends reals of 8 bytes, node 1 receives reals of 4 bytes
all|MPI_Bcast at|reals of 8 bytes on node 0, reals of 4 bytes on node 1
END
run -m delta -n 2 signatures well
times >plain
same_times -m delta -n 2 --mpi-checks signatures well
check "the same kinds by other datatypes: nothing is told" [ "$status:$(grep -c MPI: err)" = 0:0 ]

bin/mpicc -O2 -g -o mpi_nodes "$tests/mpi_nodes.c"
run -q -n 4 --mpi-checks mpi_nodes long
check "a message too long: both calls" grep -qE 'MPI: message longer than its receive: MPI_[A-Z][a-z]+ at mpi_nodes\.c:[0-9]+ and MPI_Recv at mpi_nodes\.c:[0-9]+: node 0 sends 9 bytes, node 1 has room for 2, with tag 9 in MPI_COMM_WORLD' err
run -q -n 2 unfit wait
check "a deadlock: who has come to MPI_Finalize is said to be there" said "node 0: MPI_Finalize\(1\) since .* \($(line unfit.c 'MPI_Finalize')\)"
check "what a collective has sent is no wrong message for a receive" eval '! said "wrong type|message is here"'
run -q -n 4 unfit tag
check "a wrong tag: only the message that has it is named" said "^      1 message is here: tag 5 in MPI_COMM_WORLD from node 0 \(it wants tag 6"
check "who waits in the collective is led to it" said "^    Look at node 1 first \(wrong type\), which does not wait in a collective"
check "no other has a wrong message" [ "$(grep -c '^    wrong ' err)" = 1 ]
for n in 4 8; do
    run -q -n $n unfit end
    check "$n nodes, one of which ends before MPI_Finalize: others' messages of it are no wrong ones" eval '! said "wrong node"'
    check "$n nodes: what the one should have called" said "Before its program ends, each rank has to call .* MPI_Finalize"
done

# --- memory that one call sends and receives in ---
build own_part -O2
run -m delta -n 4 own_part
times >plain
check "own parts that lie in place are gathered and scattered" [ "$status:$(sort out | xargs)" = "0:rank 0 has 16 rank 1 has 32 rank 2 has 48 rank 3 has 64" ]
same_times -m delta -n 4 --mpi-checks own_part
while IFS='|' read -r call nodes; do
    check "$call: memory in which one call sends and receives is reported" told "MPI: a call sends and receives in the same memory: $call at $(line own_part.c "$call(")" "MPI_IN_PLACE" "$nodes"
done <<'END'
MPI_Allgather|4 times, on nodes 0-3
MPI_Iallgather|4 times, on nodes 0-3
MPI_Allgatherv|4 times, on nodes 0-3
MPI_Gather|MPI_IN_PLACE for that
MPI_Scatter|MPI_IN_PLACE for that
END
check "that is all" [ "$(grep -c MPI: err)" = 5 ]
equal_results "own parts" -n 5 --mpi-checks own_part
run -q -n 4 --set mpi_collectives=1995 own_part
check "so they are by the algorithms of 1995" [ "$status:$(sort out | xargs)" = "0:rank 0 has 16 rank 1 has 32 rank 2 has 48 rank 3 has 64" ]
run -q -n 4 --mpi-checks own_part pair
check "MPI_Sendrecv: buffers that overlap in part are told" told "MPI_Sendrecv at $(line own_part.c 'MPI_Sendrecv(')" "MPI_Sendrecv_replace"
run -q -n 4 --mpi-checks own_part well
check "pieces between each other, and calls that say so, are fine" [ "$status:$(cat err)" = "0:" ]
run -q -n 4 own_part whole
check "an own part that lies at another place than it is to lie is an error" said "node [123], at .*MPI_Allgather: .*give MPI_IN_PLACE"

# --- errors ---
run -q -n 4 mpi_nodes long
check "an error's first line is the program's, not the library's" [ "$(grep -m1 -o 'called from .*' err | grep -c '(mpi_nodes\.c:')" = 1 ]

build given -O1
while IFS='|' read -r how call what; do
    run -q -n 2 given "$how"
    check "$how: a fault in MPI's library is the call's" told "crashed at" "in $call: it used an address it may not"
    check "$how: what to look at" told "$what"
    check "$how: the first line is the program's" \
        [ "$(grep -m1 -oE '(called from|in) main.*' err | grep -oE 'given\.c:[0-9]+')" = "$(line given.c "$call(")" ]
    check "$how: no function of the library is named" [ "$(grep -cE '(called from|in) ' err)" = 2 ]
done <<'END'
gather|MPI_Gather|Look at the arguments of MPI_Gather:
counts|MPI_Scatterv|Look at the arguments of MPI_Scatterv:
place|MPI_Bcast|0x1 is MPI_IN_PLACE
status|MPI_Get_count|Look at the arguments of MPI_Get_count:
requests|MPI_Waitall|Look at the arguments of MPI_Waitall:
END
run -q -n 2 given operation
check "a fault of the program's own operation is its own" grep -qE '^  in add.*given\.c:' err
check "with the calls under way" grep -qE '^  called from main.*given\.c:' err

# --- traces ---
run -q -m paragon -n 8 --trace t.trace mpi_nodes
"$BUILD/touchstone" trace why t.trace >why 2>err
check "why: calls have MPI's names" grep -qE '^  MPI_Allreduce at mpi_nodes\.c:[0-9]+' why
check "why: none has the library's names" [ "$(grep -cE 'PMPI_|nxm_|coll_' why)" = 0 ]
check "why: messages are MPI's" grep -qE '^  (tag|collective) [0-9]+ in (MPI_COMM_WORLD|communicator [0-9]+) ' why
check "why: waits are for tags and collectives" grep -qE 'for collectives? [0-9]+' why
"$BUILD/touchstone" trace export -f json -o t.json t.trace
check "export: a call of MPI is one slice around those of the system; messages have communicators" python3 -c '
import json
events = json.load(open("t.json"))["traceEvents"]
open_, around, communicators = {}, 0, set()
for e in events:
    stack = open_.setdefault(e.get("tid"), [])
    if e["ph"] == "B":
        stack.append(e)
        communicators.add(e.get("args", {}).get("communicator"))
        if len(stack) > 1 and e["cat"] == "call" and stack[-2]["cat"] == "MPI":
            around += stack[-2]["name"] == e["name"]
            assert stack[-2]["name"] == e["name"] or e["name"][:5] == "MPI_I", e
    elif e["ph"] == "E":
        assert stack.pop()["name"] == e["name"]
assert around > 20 and "MPI_COMM_WORLD" in communicators, (around, communicators)'
check "the page is made of it" "$BUILD/touchstone" page t.html t.trace

# --- other orders, and a debugger ---
build first_come -O0
"$BUILD/touchstone" explore -j 1 -n 5 --runs 40 -o found ./first_come >explored 2>err
check "explore: another order of messages to MPI_ANY_SOURCE" grep -q 'outcomes\? differs\? from' explored
check "explore: the receive that got another message" grep -q "of node 0 (MPI_Recv, $(line first_come.c 'MPI_Recv('))" explored
schedule=$(echo found/*-1.schedule)
run -q -n 5 --replay "$schedule" first_come
other_order() { [ "$status" = 0 ] && [ "$(tr ' ' '\n' <out | sort | xargs)" = "1 2 3 4" ] && [ "$(cat out)" != "1 2 3 4 " ]; }
check "replay: that order again" other_order
if command -v gdb >gdb.path; then
    TMPDIR=$work gdb -nx -batch -ex 'set breakpoint pending on' -ex 'set debuginfod enabled off' -ex 'set confirm off' -ex 'break MPI_Allreduce' \
        -ex run -ex bt --args "$BUILD/touchstone" run -q -n 1 first_come >bt 2>err </dev/null
    check "gdb: a breakpoint at a call of MPI, called from the program's line" grep -qE "main .* at .*$(line first_come.c 'MPI_Allreduce(')" bt
else
    echo "skip gdb: it is not installed"
fi

# --- calls that there are not ---
cat >spawns.c <<'END'
#include <mpi.h>
int MPI_Comm_spawn_multiple(void), MPI_Session_init(void);
int main(void) { return MPI_Comm_spawn_multiple() + MPI_Session_init(); }
END
bin/mpicc -w -o spawns spawns.c >out 2>err
status=$?
check "calls that there are not are an error when the program is linked" ended_with 1
check "all are named, and where to read more" \
    said '^mpicc: nodes do not have MPI_Comm_spawn_multiple, MPI_Session_init: .*doc/mpi-programs\.md says which calls of MPI there are'

# --- objects that are freed while they are used ---
build freed_early -O2
for n in 1 2 7; do
    run -q -n $n --mpi-checks freed_early
    check "$n nodes: an operation and a datatype last as long as their collective" [ "$status:$(cat out)" = 0:right ]
done
