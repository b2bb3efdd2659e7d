#!/bin/bash
# mpi_win.sh - MPI programs on simulated nodes access each other's memory: equal in both engines and with all workers.
. "$(dirname "$0")/common.bash"

"$BUILD/nxcc" --as-mpi bin >links
check "mpicc compiles" bin/mpicc -O2 -g -Wall -o mpi_win "$tests/mpi_win.c"

for on in "delta -n 4" "delta -n 9" "paragon -n 7" "ipsc860 -n 2" "delta -n 1"; do
    # shellcheck disable=SC2086
    run -q -m $on mpi_win
    check "$on: all holds" test "$status:$(grep -c ': yes$' out):$(grep -c NO out)" = 0:6:0
    # shellcheck disable=SC2086
    equal_results "$on" -m $on mpi_win
done
run -q -m delta -n 4 --set mpi_eager_limit=0 mpi_win
check "no send is eager: all holds" test "$status:$(grep -c ': yes$' out)" = 0:6
run -q -n 4 mpi_win outside
check "an access outside of the window: rank, call and what there is" said \
    "node [0-3], at [0-9.]+ [mun]?s: MPI_Get: rank 1's window has 8 bytes in units of 4"
check "and the program's line" said "main.*mpi_win\.c:$(grep -n 'MPI_Get(&rank' "$tests/mpi_win.c" | cut -d: -f1)"

check "mpif90 compiles" bin/mpif90 -O2 -o fortran "$tests/mpi_win.f90"
run -q -m delta -n 4 fortran
check "Fortran's calls" test "$(xargs <out)" = "3 6 0 100 104 32 T"
equal_results "Fortran" -m delta -n 4 fortran

# A program that uses neither files nor windows carries neither.
check "a program without them compiles" bin/mpicc -O2 -o mpi_nodes "$tests/mpi_nodes.c"
nm mpi_nodes >names
check "it has no files and no windows" bash -c 'grep -q PMPI_Allreduce names && ! grep -qE "File_|Win_|file_of|win_of" names'
