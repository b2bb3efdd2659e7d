#!/bin/bash
# mpi_long.sh - long messages on MPI, which go without a copy if their receiver waits.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
. "$tests/mpi.bash"

printed() { [ "$(cat out)" = "$1" ]; }
check "longs.c compiles" "$BUILD/nxcc" --mpi -O2 -g -Wall -o longs "$tests/mpi/longs.c"
on_mpi 2 ./longs 18
check "two nodes: every byte arrives, in order, when it should" printed "0 wrong"
on_mpi 3 ./longs 5
check "three nodes" printed "0 wrong"
"$BUILD/nxcc" -O2 -g -Wall -o simulated "$tests/mpi/longs.c"
run -q -n 3 simulated 5
check "as on simulated nodes" printed "0 wrong"
