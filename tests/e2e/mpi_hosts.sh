#!/bin/bash
# mpi_hosts.sh - programs, studies and explorations on two computers (hosts.bash), whose messages go over TCP; and what happens
# when a process is killed, a computer is gone, or the network.
. "$(dirname "$0")/hosts.bash"
. "$(dirname "$0")/common.bash"
. "$tests/mpi.bash"
hosts_begin
export XDG_CACHE_HOME=$work/cache TOUCHSTONE_CFS=$work/cfs
quick="--mca oob_tcp_keepalive_time 1 --mca oob_tcp_keepalive_intvl 1 --mca oob_tcp_keepalive_probes 2"
sent_by() { on "$1" awk '$1 == "eth0:" { print $10 }' /proc/net/dev; }

# --- programs ---
check "places.c compiles" "$BUILD/nxcc" --mpi -O2 -g -Wall -o places-mpi "$tests/mpi/places.c"
before=$(sent_by beta)
NX_RECORD=order NX_SUMMARY_JSON=summary.json across 4 -x TOUCHSTONE_CFS ./places-mpi
check "a program runs on two computers" ended_with 0
check "its messages go over the network" [ $(($(sent_by beta) - before)) -gt 131072 ]
check "its nodes are on both, and share files" [ "$(head -1 out)" = "alpha beta alpha beta" ]
check "the summary says where each node was" [ "$(grep -o '"host": "[a-z]*"' summary.json | cut -d'"' -f4 | xargs)" = "alpha beta alpha beta" ]
cp out recorded
"$BUILD/nxcc" -O2 -g -o places "$tests/mpi/places.c"
run -q -n 4 --replay order places
check "NX_RECORD: the order is replayed" [ "$(tail -1 recorded)" = "$(tail -1 out)" ]
NX_DEADLOCK=0.2 across 4 -x TOUCHSTONE_CFS ./places-mpi waits
check "a deadlock over two computers ends the program" ended_with 2
check "and is explained" said "^  nodes 0-3: crecv\(7\) since .* \(places\.c:$(grep -n 'crecv(7' "$tests/mpi/places.c" | cut -d: -f1)\)"

# --- studies and explorations ---
compile counted
cat >many.cfg <<'END'
program = "counted"; machine = "delta"; arguments = "-log 1";
axes = ( { name = "nodes"; values = ( 1, 2 ); },
         { name = "steps"; values = { from = 20; to = 25; step = 1; }; arguments = "-steps {}"; } );
END
results() { grep -c ' [df] {' "$1/journal" 2>/dev/null; }
same_results() { diff <(grep -v wall_time alone/results.json) <(grep -v wall_time "$1/results.json"); }
# shellcheck disable=SC2086
shares() { across "$@" $quick -x XDG_CACHE_HOME "$BUILD/touchstone" study -j 1 many.cfg -o shared; }
"$BUILD/touchstone" study many.cfg -o alone >out 2>err
rm -rf runs.log cache
shares 4
check "a study on two computers" ended_with 0
check "each point ran once" [ "$(wc -l <runs.log) $(sort runs.log | uniq -d)" = "12 " ]
check "with the results of one" same_results shared

"$BUILD/nxcc" -O2 -g -o first_comes "$tests/first_comes.c" 2>compile.err
explores() { "$@" "$BUILD/touchstone" explore -j 1 -n 4 --runs 10 -o "$folder" ./first_comes; }
report() { sed -E '/^  ([0-9]+ runs made in|no run made: )/,$d' "$1"; }
folder=found explores env >alone.out 2>err
rm -rf found
folder=found explores across 4
check "an exploration on two computers" diff <(report alone.out) <(report out)
check "finds something" grep -q 'outcomes differ from' out

# --- what breaks ---
# (Its messages are those of MPI's launcher.)
printed_places() { [ "$(head -1 out 2>/dev/null)" = "alpha beta alpha beta" ]; }
nothing_left() { ! left_over "$1"; }
# broken COMMAND...: a program works on both computers, and then the command is run.
broken() {
    rm -f out err
    # shellcheck disable=SC2086
    across 4 -x TOUCHSTONE_CFS $quick ./places-mpi works &
    awaited printed_places
    "$@"
    wait $!
    status=$?
}

kill_rank() { # N
    for pid in $(pgrep -f '^./places-mpi works'); do
        grep -qz "^OMPI_COMM_WORLD_RANK=$1$" "/proc/$pid/environ" && kill -9 "$pid"
    done
}
broken kill_rank 1
check "a process killed: the job ends" [ "$status" != 0 ]
check "its number and computer are told" said 'process rank 1 with PID [0-9]+ on node beta exited on signal 9'
check "and no process is left" awaited nothing_left 'places-mpi works'
broken on beta ip link set eth0 down
check "the network gone: the job ends" [ "$status" != 0 ]
check "the computer is named" said 'beta'
check "and no process is left" awaited nothing_left 'places-mpi works'
on beta ip link set eth0 up
broken host_dies beta
check "a computer gone: the job ends" [ "$status" != 0 ]
check "the computer is named" said 'Remote daemon: .* on node beta'
check "and no process is left" awaited nothing_left 'places-mpi works'

# --- a computer gone from a study ---
hosts_again() { # a new computer of the same name
    ip link del beta 2>/dev/null
    rm -f beta.begun
    host_begin beta 10.77.0.2
}
hosts_again
rm -rf shared cache runs.log
shares 4 &
some() { had=$(results shared) && [ "$had" -ge 3 ]; }
awaited some
host_dies beta
wait $!
had=$(results shared)
check "a study whose computer is gone keeps what was finished" [ "$had" -ge 3 ]
check "and no process is left" awaited nothing_left "study -j 1 many.cfg"
hosts_again
shares 4
check "the same command completes it" ended_with 0
check "with the same results" same_results shared
check "and runs no more again than were under way" [ "$(wc -l <runs.log)" -le 16 ]
