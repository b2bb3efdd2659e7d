#!/bin/bash
# timing.sh - other timings that the machine could have had: --timing, --replay, --record, --until.
. "$(dirname "$0")/common.bash"
compile first_comes

line_of() { grep -n "$1" "$tests/first_comes.c" | head -1 | cut -d: -f1; }
figures() { grep -v wall "$1"; }

# --- drawn timings ---

run -q -n 4 first_comes
check "without a timing, messages sent alike come in the order of nodes" grep -qx '1 2 3 first interrupt by 1' out
cp out usual

for method in random pct; do
    for seed in 1 2 3 4 5 6; do
        timing="$seed,method=$method"
        run_results -q -n 4 --engine reference --timing $timing first_comes >reference
        cp out "out.$method.$seed"
        for workers in 1 2 4; do
            run_results -q -n 4 -w $workers --timing $timing first_comes >fast
            cmp reference fast || echo "$timing, $workers workers"
        done
    done
done >differences 2>&1
check "a timing gives the same results in both engines, with 1, 2 and 4 workers" test ! -s differences
check "random: different seeds show different orders" test "$(cat out.random.* | sort -u | wc -l)" -ge 3
check "pct: and so they do by priorities" test "$(cat out.pct.* | sort -u | wc -l)" -ge 3

run -q -n 4 --timing 4,messages=0,interrupts=0,speed=0%,start=0 --json none.json first_comes
run -q -n 4 --json usual.json first_comes
check "bounds of 0 give the usual timing" cmp <(figures none.json) <(figures usual.json)
run -q -n 4 --timing 4,messages=1ns,interrupts=0,speed=0%,start=0 --history tie first_comes
check "a delay of a nanosecond breaks ties" test "$(head -3 tie | cut -d' ' -f2 | tr -d '\n')" != 123

# Each receive's line is recorded, of however many.
{
    printf '#include <nx.h>\nint main(void)\n{\n    long x = mynode();\n'
    for ((i = 0; i < 90; i++)); do printf '    x ? csend(1, &x, sizeof x, 0, 0)\n      : crecv(1, &x, sizeof x), x = mynode();\n'; done
    printf '    return 0;\n}\n'
} >lines.c
"$BUILD/nxcc" -g -O0 -w -o lines lines.c
run -q -n 2 --record lines.schedule lines
check "--record: 90 receives in 90 lines" test "$(grep -o '^match 0 .* line=lines.c:.*' lines.schedule | sed 's/.*line=//' | sort -u | wc -l)" = 90

# When node 3 has sent its first message, in a run with such a line.
sends() { # LINE
    printf 'touchstone-schedule 1\nnodes 4\n%s\n' "$1" >one
    run -q -n 4 --replay one --record one.schedule first_comes
    sed -n 's/^message 3 0 .* sent=//p' one.schedule
}
usual=$(sends '')
check "start: a program that begins 2 ms later sends that much later" test $(($(sends 'start 3 2000000000') - usual)) = 2000000000
twice=$(($(sends 'speed 3 1000000') - usual)) thrice=$(($(sends 'speed 3 2000000') - usual))
check "speed: a processor of half the speed computes longer" test $twice -gt 1000000
check "speed: one of a third twice as much longer" test $((thrice - 2 * twice)) -ge -1000 -a $((thrice - 2 * twice)) -le 1000

# --- recorded, and replayed ---

for engine in fast reference; do
    run -q -n 4 -w 3 --engine $engine --timing 4 --record $engine.schedule --json $engine.json first_comes
done
check "both engines write the same schedule" cmp fast.schedule reference.schedule
check "a recording counts all receives of node 0" test "$(grep -c '^match 0 ' fast.schedule)" = 7
check "it tells the line and the call of a receive" \
    grep -q "^match 0 2 .* typesel=1 sel=-1 call=crecv line=first_comes.c:$(line_of 'crecv(REPORT')$" fast.schedule
check "it tells which receive a handler is for" grep -q '^handler 0 0 1 .* match=0 line=' fast.schedule
check "and the messages that nobody received" grep -q '^left 0 ' fast.schedule
run -q -n 4 --replay fast.schedule --record again.schedule --json again.json --trace again.trace first_comes
check "a recording replays to the same figures" cmp <(figures fast.json) <(figures again.json)
check "and to the same recording" cmp <(grep -v '^#' fast.schedule) again.schedule
run -q -n 4 --timing 4 --trace drawn.trace first_comes
"$BUILD/touchstone" trace why again.trace >again.why 2>&1
"$BUILD/touchstone" trace why drawn.trace >drawn.why 2>&1
check "and to the same trace" cmp again.why drawn.why
check "which can be explained" grep -q 'critical path' drawn.why

cat >hand <<'END'
touchstone-schedule 1
nodes 4
message 1 0 45000000    # the interrupt of node 1, by 45 us
message 1 1 45000000
END
run -q -n 4 --replay hand first_comes
check "a schedule by hand shows another order" grep -qx '2 3 1 first interrupt by 2' out

# --- orders ---

sed 's/^delays/orders/; /^speed/d; /^start/d; /^message/d; /^interrupt/d' fast.schedule >orders
run -q -n 4 first_comes
usual=$(cat out)
for engine in fast reference; do
    run -q -n 4 --engine $engine --replay orders --record orders.$engine --json orders.$engine.json first_comes
    cp out out.orders.$engine
done
check "orders alone, without times, give each receive its message" cmp out.orders.fast out.random.4
check "which it does not get without" test "$usual" != "$(cat out.orders.fast)"
check "both engines keep orders alike" cmp orders.fast orders.reference
check "to the picosecond" cmp <(figures orders.fast.json) <(figures orders.reference.json)
check "a recording of it must keep orders, too" grep -qx orders orders.fast
check "with the same matches" cmp <(grep ^match orders | cut -d' ' -f1-5 | sort) <(grep ^match orders.fast | cut -d' ' -f1-5 | sort)

cat >narrowed <<'END'
touchstone-schedule 1
nodes 4
orders
match 0 2 3 1
END
run -q -n 4 --replay narrowed first_comes
check "one receive narrowed: node 3's comes first" grep -q '^3 1 2 ' out

sed 's/^handler 0 1 1/handler 0 1 3/' orders >later
for engine in fast reference; do
    run -q -n 4 --engine $engine --replay later --record later.$engine first_comes
done
check "a handler waits until its program has begun so many calls" grep -q '^handler 0 1 3 ' later.fast
check "in both engines" cmp later.fast later.reference
printf 'touchstone-schedule 1\nnodes 4\norders\nhandler 0 0 1\n' >before
run -q -n 4 --replay before --record before.fast first_comes
check "and its program's next call waits for it" grep -q '^handler 0 0 1 ' before.fast

# --- orders that cannot be kept ---

impossible() { # LINE
    printf 'touchstone-schedule 1\nnodes 4\norders\n%s\n' "$1" >impossible
    for engine in reference fast; do
        run -q -n 4 --engine $engine --replay impossible first_comes
        cp err err.$engine
    done
}
impossible 'match 0 2 1 7'
check "a message that is never sent: a deadlock" ended_with 2
check "whose report names the line" said '^  impossible:4: not kept: receive 2 of node 0: the receive was made, but has not got it; node 1 has sent it 3 messages'
check "in both engines" cmp err.reference err.fast
impossible 'match 0 2 1 0'
check "a message that the receive does not select: exit status 1" ended_with 1
check "the error names line, node, receive and message" \
    said "^touchstone run: impossible:4: cannot be kept: receive 2 of node 0 \(crecv, first_comes.c:$(line_of 'crecv(REPORT')\) does not select message 0 from node 1, which has type 2"
check "in both engines" cmp err.reference err.fast
impossible 'handler 0 5 9'
check "a handler that never runs: exit status 1" ended_with 1
check "the error says how many have run" said '^  impossible:4: not kept: handler 5 of node 0: 2 handlers have run, after [0-9]+ calls'
check "in both engines" cmp err.reference err.fast

# --- the end, and errors ---

run -q -n 4 --until 10us first_comes
check "--until: exit status 0" ended_with 0
check "--until: says where each node is" said '^  node 0: computing'
cp err until
run -q -n 4 --until 10us --engine reference first_comes
check "--until: in both engines" cmp err until
run -q -n 4 --until 900s first_comes
check "--until a time that is not reached: as without" cmp out usual

if command -v gdb >/dev/null; then
    run -q -n 4 --gdb 0 --until 10us first_comes
    cat out err >both
    check "--until with --gdb: the debugger stops there" grep -q 'all nodes have come to 10 us; node 0: ' both
else
    echo "skip --until with --gdb: gdb is not installed"
fi

printf 'touchstone-schedule 1\nnodes 4\n\nmessage 9 0 1\n' >bad
run -q -n 4 --replay bad first_comes
check "a wrong schedule: exit status 65" ended_with 65
check "the error names file and line" said '^touchstone run: bad:4: message: there is no node 9'
run -q -n 4 --replay missing.schedule first_comes
check "a schedule that is not there" said '^touchstone run: missing.schedule cannot be read: No such file'
run -q -n 3 --replay hand first_comes
check "a schedule for another number of nodes is refused" said 'hand is the schedule of a run on 4 nodes, and this one has 3'
run -q -n 4 --timing 3,depth=x first_comes
check "a wrong --timing: exit status 64" ended_with 64
check "says what is wrong" said 'depth takes a number from 1 to 100'
run -q -n 4 --timing 3 --replay hand first_comes
check "--timing and --replay exclude each other" ended_with 64
run -q -n 4 --record /nowhere/x first_comes
check "a schedule that cannot be written: exit status 74" ended_with 74

# --- of another program ---
"$BUILD/nxcc" -O2 -o no_g "$tests/first_comes.c"
"$BUILD/nxcc" -O2 -g -o with_g "$tests/first_comes.c"
"$BUILD/nxcc" -O0 -o other "$tests/first_comes.c"
run -q -n 4 --record usual.schedule no_g
run -q -n 4 --replay usual.schedule no_g
check "the recorded program: nothing is said" test ! -s err
run -q -n 4 --replay usual.schedule with_g
check "nor of the same with debugging information" test ! -s err
run -q -n 4 --replay usual.schedule other
check "another program than the recorded one is named, also if the schedule delays nothing" \
    said '^touchstone run: usual.schedule was recorded of another program than other, or of this one compiled otherwise'

cp no_g $'n\xf6 g'
run -q -n 4 --record latin.schedule $'./n\xf6 g'
run -q -n 4 --replay latin.schedule no_g
check "the schedule of a program whose name is not UTF-8 can be read" ended_with 0

# --- doc/replay.md ---

example "$tests/../../doc/replay.md" race.c
block "$tests/../../doc/replay.md" schedule >by_hand
run -q -n 4 --replay by_hand race
check "the schedule by hand of doc/replay.md" grep -qx 'the answer is 30, of node 3' out
