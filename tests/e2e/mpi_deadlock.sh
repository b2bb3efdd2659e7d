#!/bin/bash
# mpi_deadlock.sh - deadlocks on MPI: each kind is found, and explained in the words of `touchstone run`; and what is none is left
# alone.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
. "$tests/mpi.bash"

# What remains of a report when times are left out. Only on MPI it is known where an irecv was made; where a handler interrupted
# the program depends on times. In which order messages of different nodes have come is left to MPI.
without_times() { # FILE
    sed -n '/deadlock: every program waits/,/^\(--------\|[a-z].*:\)/{/^ /p}' "$1" |
        sed -E 's/ (since|at) [0-9.]+ [mun]?s( to [0-9.]+ [mun]?s)?//g; s/(irecv\([0-9]+\)) at [a-z_]+\.c:[0-9]+/\1/
                s/(called from main\(\) at in_handler\.c):.*/\1/' |
        perl -pe 's/(messages are here: )(.*)\./$1 . join(", ", sort split(", ", $2)) . "."/e'
}

# Compares the report of a program on both back ends.
same_report() { # NAME NODES SOURCE [OPTIONS]
    local name=$1 nodes=$2 source=$3
    "$BUILD/nxcc" -O2 -g "${@:4}" -o "$name" "$source" 2>compile.err
    "$BUILD/nxcc" --mpi -O2 -g -fno-inline-functions-called-once -fno-inline-small-functions "${@:4}" -o "$name-mpi" "$source" 2>compile.err
    run -q -m ipsc860 -n "$nodes" "$name"
    without_times err >simulated
    on_mpi "$nodes" "./$name-mpi"
    without_times err >real
    check "$name: the job ends" ended_with 2
    check "$name: something is told" grep -q '^  node' simulated
    check "$name: the same report as of simulated nodes" diff simulated real
}

export NX_DEADLOCK=0.2
for source in "$tests"/deadlocks/*.c "$tests"/deadlocks/*.f; do
    name=$(basename "$source" | tr . _)
    case $name in
    buffers_c | exited_c | random_c) continue ;; # a send never waits for room on MPI; exit(1) ends all nodes; below
    esac
    same_report "$name" "$(sed -n "s/^\\([2-4]\\) $(basename "$source")\$/\\1/p" "$tests/deadlocks.sh" | grep . || echo 2)" "$source"
done
same_report mixed 7 "$tests/deadlock.c"

# Programs that send and receive at random, with handlers: each ends, or ends in a deadlock; none hangs.
"$BUILD/nxcc" --mpi -O2 -g -o random "$tests/deadlocks/random.c" 2>compile.err
for seed in 1 2 3 4 5 6 7 8; do
    NX_DEADLOCK=0 on_mpi 5 ./random $seed
    echo "$status" >>random.statuses
    [ "$status" = 0 ] || [ "$status" = 2 ] || sed "s/^/# seed $seed, status $status: /" out err
done
check "random programs end, well or in a deadlock" [ "$(grep -cE '^[02]$' random.statuses)" = 8 ]
check "most of them in a deadlock" [ "$(grep -c '^2$' random.statuses)" -ge 4 ]

# --- what a report needs ---
"$BUILD/nxcc" --mpi -O2 -g -o ring "$tests/deadlocks/cycle.c"
NX_DEADLOCK_JSON=report.json on_mpi 2 ./ring
check "the report as JSON" python3 -c '
import json
w = json.load(open("report.json"))
assert w["clock"] == "time since the program began" and len(w["nodes"]) == 2 and sorted(w["cycle"]) == [0, 1], w
for n in w["nodes"]:
    assert n["cause"] == "cycle" and n["line"].startswith("cycle.c:") and 0 < n["since_ps"] <= w["now_ps"], n'
NX_DEADLOCK_JSON=missing/report.json on_mpi 2 ./ring
check "a file that cannot be written is named" said '^nx: NX_DEADLOCK_JSON: missing/report.json cannot be written: No such'
check "and the report is told all the same" said '^nx: deadlock: every program waits'
strip -g -o ring0 ring
NX_DEADLOCK_JSON=report.json on_mpi 2 ./ring0
check "without -g functions are known" grep -q '"line": null, "stack": \["main()"\]' report.json
on_mpi 2 env PATH=/nowhere ./ring
check "without addr2line there is a report, too" said '^  node.*: crecv'

# --- the time it takes ---
export NX_DEADLOCK=
"$BUILD/nxcc" --mpi -O2 -g -o many "$tests/deadlock.c"
on_mpi 16 ./many
check "a job of 16 processes ends" ended_with 2
check "with a report" said '^  nodes 3-15: gsync'
NX_DEADLOCK=0.2 on_busy 2 ./ring
check "waiting nodes leave a busy processor to others within a second" said 'crecvx\(7\) since [0-9.]+ [mu]s to [0-9.]+ [mu]s'
# Of two jobs in the same deadlock the second is found.
echo '#include <stdio.h>
#include <nx.h>
int main(void) { printf("node %ld\n", mynode()); crecv(1, NULL, 0); return 0; }' >waits.c
"$BUILD/nxcc" --mpi -O2 -o waits waits.c
NX_DEADLOCK=off mpirun -np 2 ./waits >off.out 2>off.err </dev/null &
have_begun() { [ "$(wc -l <off.out)" = 2 ]; }
awaited have_begun
NX_DEADLOCK=0.2 on_mpi 2 ./waits
check "NX_DEADLOCK: a job ends" ended_with 2
hangs() { kill -0 $! && [ ! -s off.err ]; }
check "NX_DEADLOCK=off: a job hangs" hangs
kill $!
wait $! 2>wait.err
NX_DEADLOCK=soon on_mpi 2 ./ring
check "NX_DEADLOCK: nonsense is an error" said "^nx: node 0, at .* NX_DEADLOCK is 'soon', but should be a number of seconds, or off"

# --- what is no deadlock: even if one is looked for without a pause ---
export NX_DEADLOCK=0
"$BUILD/nxcc" --mpi -O2 -g -Wall -o calm "$tests/mpi/calm.c" 2>compile.err
calm() { [ "$status" = 0 ] && [ "$(cat out)" = "$1" ] && [ ! -s err ]; }
for how in computes sleeps "waits for the system" polls dies handles "sends much"; do
    on_mpi 4 ./calm "$how"
    check "no deadlock: $how" calm done
done
on_mpi 4 ./calm alarm
check "no deadlock: alarm" calm $'done\nwoken'
# The line comes when a deadlock that began later has been found.
mkfifo input
limited mpirun -np 4 ./calm reads >reads.out 2>reads.err <input &
exec 3>input
asks() { grep -q asks reads.out; }
awaited asks
on_mpi 2 ./ring
check "a deadlock is found while another job reads" ended_with 2
echo "a line" >&3
wait $!
status=$?
mv reads.out out && mv reads.err err
check "no deadlock: reads" calm $'asks\nread a line\ndone'
