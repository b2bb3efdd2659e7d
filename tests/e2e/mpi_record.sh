#!/bin/bash
# mpi_record.sh - NX_RECORD: the order of a run on MPI, replayed on simulated nodes.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
. "$tests/mpi.bash"

"$BUILD/nxcc" -O2 -g -Wall -o first_come "$tests/mpi/first_come.c" 2>compile.err
"$BUILD/nxcc" --mpi -O2 -g -Wall -o first_come-mpi "$tests/mpi/first_come.c" 2>compile.err

# An order-dependent program prints on simulated nodes what it has printed on MPI.
for i in 1 2 3 4 5; do
    NX_RECORD=order.$i on_mpi 4 ./first_come-mpi
    cp out recorded.$i
    run -q -n 4 --replay order.$i first_come
    check "run $i: replayed to its end" ended_with 0
    check "run $i: it prints the same" cmp recorded.$i out
done
check "some of the runs were different" [ "$(cat recorded.? | sort | uniq -c | awk '$1 < 5' | wc -l)" -gt 0 ]
run -q -n 4 first_come
check "and so is a run without a schedule" [ "$(cmp recorded.1 out; echo $?)" != "0" ]

counts() { grep -c "^$1 $2 " order.1; }
check "the head" [ "$(head -3 order.1 | tr '\n' ' ')" = "touchstone-schedule 1 nodes 4 orders " ]
check "each receive of node 0 has its message: results, news, those of gsync" [ "$(counts match 0)" = $((120 + 30 + 2)) ]
check "each handler that ran has its line" [ "$(counts handler 0)" = 30 ]

# --- runs that do not end well ---
"$BUILD/nxcc" -O2 -g -Wall -o hapless "$tests/mpi/hapless.c" 2>compile.err
"$BUILD/nxcc" --mpi -O2 -fno-inline-functions-called-once -fno-inline-small-functions -fno-optimize-sibling-calls -g -Wall -o hapless-mpi "$tests/mpi/hapless.c" 2>compile.err
NX_DEADLOCK=0.2 NX_RECORD=order on_mpi 3 ./hapless-mpi waits
sed -n '/deadlock/,/^---/{/^ /p}' err | sed -E 's/ (since|at) [0-9.]+ [mun]?s( to [0-9.]+ [mun]?s)?//g' >real
run -q -n 3 --replay order hapless waits
sed -n '/deadlock/,/^[a-z]/{/^ /p}' err | sed -E 's/ (since|at) [0-9.]+ [mun]?s( to [0-9.]+ [mun]?s)?//g' >simulated
check "a deadlock: replayed" ended_with 2
check "a deadlock: in the same state" cmp real simulated
check "a deadlock: there is one" grep -q '^  node' real

NX_RECORD=order on_mpi 3 ./hapless-mpi errs
said_on_mpi=$(sed -n 's/^nx: node 0, at [0-9.]* s: //p' err)
run -q -n 3 --replay order hapless errs
check "an error: replayed" [ "$status" != 0 ]
check "an error: the same" grep -qF "$said_on_mpi" err

rm -f order order.*
NX_RECORD=order on_mpi 3 ./hapless-mpi crashes
said_on_mpi=$(cat out)
check "a crash: the process that crashed leaves its part" test -s order.0 # (mpirun may end others before they can)
cat order.[0-9]* >order
run -q -n 3 --replay order hapless crashes
check "a crash: replayed" said 'node 0.*(segmentation fault|SIGSEGV|crash)'
check "a crash: after the same" [ "$(cat out)" = "$said_on_mpi" ]

NX_RECORD=missing/order on_mpi 3 ./first_come-mpi
check "a file that cannot be written is named" said '^nx: NX_RECORD: missing/order cannot be written: No such file'
check "and the program runs all the same" ended_with 0
