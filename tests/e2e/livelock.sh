#!/bin/bash
# livelock.sh - programs that poll for what nobody sends, or stand still for handlers, are named at limits, in the summary and in
# the JSON file, alike in both engines; programs that come to their ends are not.
# without: touchstone-lab
. "$(dirname "$0")/common.bash"
compile livelock
line_of() { grep -n "line of $1 " "$tests/livelock.c" | cut -d: -f1; }
of_json() { jq -r "$1" f.json; }

# --- polls, at a limit of virtual time ---
run --json f.json -n 4 --max-virtual-time 0.2 livelock iprobe
check "iprobe: who, how long, where, how often, and that nobody has sent it" said "^  nodes 1-3 poll: [78][0-9]\\.[0-9] % of the last \
200\\.0 ms in iprobe\\(7\\) \\(livelock.c:$(line_of iprobe)\\), [0-9]+ times without an answer; no message of type 7 has come to any node$"
check "iprobe: the summary does not say it again" test "$(grep -c 'in iprobe(7)' err)" = 1
check "iprobe: the JSON file has it" test "$(of_json '.node[1].livelock | .kind, .call, .type, .goes_on')" = $'polls\niprobe\n7\ntrue'
check "iprobe: with its line" test "$(of_json '.node[3].livelock.line')" = "livelock.c:$(line_of iprobe)"
check "iprobe: a node that waits has none" test "$(of_json '.node[0].livelock')" = null
# Of so long a time, so many polls of a known time each: the share is what a call takes on the Delta.
check "iprobe: the share is that of the calls" jq -e '.node[1].livelock | .count * 5e-6 / (.until_s - .since_s) - .share | fabs < 0.001' f.json
run -n 3 --max-virtual-time 0.2 livelock two
check "two polls in turn: one is named, and the other's part" said "in iprobex?\\([78]\\)( from node 1)? \\(livelock.c:$(line_of two)\\), [0-9]+ times without an answer; \
and [0-9.]+ % in other polls"
run -n 3 --max-virtual-time 0.2 livelock msgdone
check "msgdone: the receive's type" said "in msgdone of a receive of type 11 \\(livelock.c:$(line_of msgdone)\\), [0-9]+ times without an answer; no message of type 11"
run -n 3 --max-virtual-time 0.2 livelock flick
check "flick" said "in flick \\(livelock.c:$(line_of flick)\\), [0-9]+ times, and no message or handler came$"
cat >tests.c <<'END'
#include <mpi.h>
int main(int argc, char **argv)
{
    MPI_Request r;
    int x, rank, done = 0;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Irecv(&x, 1, MPI_INT, MPI_ANY_SOURCE, 12, MPI_COMM_WORLD, &r);
    while (!done && rank == 0)
        MPI_Test(&r, &done, MPI_STATUS_IGNORE);
    MPI_Finalize();
    return 0;
}
END
"$BUILD/nxcc" -g -O2 -o tests tests.c -lmpi 2>compile.err || cat compile.err
for machine in delta paragon cluster2026; do
    run -q -m $machine -n 2 --max-virtual-time 0.05 tests
    check "MPI_Test on $machine: its library's time is the poll's" said "node 0 polls: (9[0-9]|100)\\.[0-9] % of the last [0-9.]+ ms in MPI_Test\\(12\\) \\(tests.c:10\\), .*; no message of tag 12 has come to any node$"
done
cat >gives_up.c <<'END'
#include <stdlib.h>
#include "nx.h"
int main(void)
{
    if (mynode() == 1)
        exit(4);
    while (!iprobe(7))
        ;
    return 0;
}
END
"$BUILD/nxcc" -O2 -o gives_up gives_up.c 2>compile.err || cat compile.err
run -q -n 3 --max-virtual-time 0.2 gives_up
check "an exit with an error is told at once" test "$(head -1 err)" = "$(grep -E '^touchstone run: node 1 ended at [0-9.]+ [mun]?s with exit\(4\) \(gives_up\.c:[0-9]+\)$' err)"
check "it is in the node's line" said '^  node 1: ended with exit\(4\) at [0-9.]+ [mun]?s \(gives_up\.c:[0-9]+\)$'
check "and named to those that poll for ever" said '^  nodes 0, 2 poll: .*; look at node 1 first, which ended with exit\(4\)$'
cat >behind.c <<'END'
#include "nx.h"
int main(void)
{
    double work, x = 1;
    for (volatile long i = 1; mynode() == 1; i++)
        ;
    gdsum(&x, 1, &work);
    return 0;
}
END
"$BUILD/nxcc" -O2 -o behind behind.c 2>compile.err || cat compile.err
run -q -n 3 --max-virtual-time 0.2 behind
check "at a limit, a node in a global operation is in the call that the program made" said '^  node 2: gdsum since [0-9.]+ [mun]?s \(behind\.c:7\)$'
run -n 3 --max-wall-time 1 livelock iprobe
check "a limit of wall time names them, too" said "^  nodes 1, 2 poll: .* in iprobe\\(7\\) \\(livelock.c:$(line_of iprobe)\\)"
env --default-signal=INT "$BUILD/touchstone" run -n 3 livelock iprobe >out 2>err &
awaited has_computed $! 60
kill -INT $!
wait $!
check "SIGINT, too" said "^  nodes 1, 2 poll: .* in iprobe\\(7\\) \\(livelock.c:$(line_of iprobe)\\)"

# --- handlers ---
run --json f.json -n 4 livelock flood
check "handlers: in the summary of a run that ends well" said "^livelock +node 0 stands still: [0-9]+ handlers of hrecv\\(5\\) \
\\(livelock.c:[0-9]+\\) take 9[0-9.]+ % of the time (since|from) [0-9.]+ [mu]?s"
first=$(grep -n '^static void on_message' "$tests/livelock.c" | cut -d: -f1)
check "handlers: the function's first line" grep -qxE "livelock.c:($first|$((first + 1)))" <(of_json .node[0].livelock.line)
check "handlers: no more than the program stood still" jq -e '.node[0].livelock | .kind == "handlers" and .share <= 1 and .share >= 0.8' f.json
run -n 2 --max-virtual-time 0.35 livelock flood
check "handlers: at a limit" said "^  node 0 stands still: [0-9]+ handlers of hrecv\\(5\\)"

# --- what comes to its end is not named ---
for what in served looks naps; do
    run --json f.json -n 3 livelock $what
    check "$what: ends well" ended_with 0
    check "$what: is not named" eval '! said "livelock  |poll"'
    check "$what: nor in the JSON file" test "$(jq '[.node[] | select(.livelock)] | length' f.json)" = 0
done
run -n 8 "$BUILD/app/model" -group 4 -sphere 48 40 9
check "the model is not named" eval '! said "livelock  "'

# --- a loop that waits for a variable, which no volatile keeps in memory: it makes no call any more ---
cat >hoisted.c <<'E'
#include <nx.h>
static int done;
static void on_message(long type, long bytes, long node, long pid)
{
    done = 1;
}
int main(void)
{
    long x = 0;
    if (mynode() == 0)
        hrecv(5, &x, sizeof x, on_message);
    gsync();
    if (mynode() == 1)
        csend(5, &x, sizeof x, 0, 0);
    if (mynode() == 0)
        while (!done)
            ;
    return 0;
}
E
"$BUILD/nxcc" -O2 -g -w -o hoisted hoisted.c
for limit in "--max-virtual-time 0.3" "--engine reference --max-virtual-time 0.3" "--max-wall-time 1"; do
    # shellcheck disable=SC2086
    run -q -n 2 $limit hoisted
    check "a loop without a call, $limit: it is named, and since when" \
        said '^  node 0: computing in one loop, without a call, since [0-9.]+ us \(hoisted\.c:1[56]\)$'
done
sed 's/static int done/static volatile int done/' hoisted.c >kept.c
"$BUILD/nxcc" -O2 -w -o kept kept.c && run -q -n 2 kept
check "with volatile it ends" ended_with 0
"$BUILD/nxcc" -O2 -g -o endless "$tests/endless.c" && run -q --max-virtual-time 0.0005 endless
check "a loop that is just under way is not named" eval 'said "node 0: computing" && ! said loop'

# --- both engines, and any number of workers, tell the same ---
# (Messages take the processor from the loop.)
cat >stolen.c <<'E'
#include <nx.h>
int main(void)
{
    static char bytes[4000];
    for (int i = 1; mynode() == 1 && i <= 5; i++) {
        for (volatile int k = 0; k < 1000 * i; k++)
            ;
        csend(5, bytes, sizeof bytes, 0, 0);
    }
    for (volatile int done = 0; mynode() == 0 && !done;)
        ;
    return 0;
}
E
"$BUILD/nxcc" -O2 -g -o stolen stolen.c
for time in 0.004 0.0123456789 0.05; do
    run_results --engine reference -n 2 --max-virtual-time $time stolen >reference
    check "a loop, $time s: it is named" grep -q 'in one loop' reference
    check "a loop, $time s: as the reference engine" cmp reference <(run_results -w 2 -n 2 --max-virtual-time $time stolen)
done
for what in iprobe two msgdone flick; do
    for time in 0.02 0.1 0.100003 0.0123456789 0.0345678901; do
        how="-n 5 --max-virtual-time $time livelock $what"
        # shellcheck disable=SC2086
        run_results --engine reference $how >reference
        check "$what, $time s: polls are named" grep -q ' poll' reference
        for workers in 1 3; do
            # shellcheck disable=SC2086
            check "$what, $time s, $workers workers: as the reference engine" cmp reference <(run_results -w $workers $how)
        done
    done
done
for how in "livelock flood" "--max-virtual-time 0.35 livelock flood" "--max-virtual-time 0.4000001 livelock flood"; do
    # shellcheck disable=SC2086
    run_results --engine reference -n 4 $how >reference
    # shellcheck disable=SC2086
    check "$how: as the reference engine" cmp reference <(run_results -w 2 -n 4 $how)
done
