#!/bin/bash
# mpi_io.sh - MPI programs on simulated nodes read and write files: of the machine's file system and of this computer, equal in both
# engines and with all workers.
. "$(dirname "$0")/common.bash"

"$BUILD/nxcc" --as-mpi bin >links
check "mpicc compiles" bin/mpicc -O2 -g -Wall -o mpi_io "$tests/mpi_io.c"

holds() { test "$status:$(grep -c ': yes$' out):$(grep -c NO out)" = 0:11:0; }
for on in "delta -n 4" "delta -n 9" "paragon -n 6" "ipsc860 -n 2"; do
    # shellcheck disable=SC2086
    run -q -m $on mpi_io /cfs
    check "$on: all holds" holds
    # shellcheck disable=SC2086
    equal_results "$on" -m $on mpi_io /cfs
done
check "files of the machine take its time" awk '/^after/ { exit !($2 > 0.1) }' out
run -q -m delta -n 4 --cfs kept mpi_io /cfs
check "they are plain files" test "$(od -An -td4 -j8 -N16 kept/square | xargs)" = "1 2 3 4"
mkdir here
run -q -m delta -n 4 mpi_io here
check "files of this computer: all holds" holds
check "and they are equal" cmp here/square kept/square
rm -r here/*
run -q -m delta -n 4 mpi_io here fatal
check "a fatal error: rank, call, file and line" said \
    "^touchstone run: node [0-3], at [0-9.]+ [mun]?s: MPI_File_read: here/fatal is open for writing only"
check "and the program's line" said "main.*mpi_io\.c:$(grep -n 'MPI_File_read(file, &rank' "$tests/mpi_io.c" | cut -d: -f1)"

check "mpif90 compiles" bin/mpif90 -O2 -o fortran "$tests/mpi_io.f90"
run -q -m delta -n 4 fortran
check "Fortran's calls" cmp out - <<'END'
   6  34  35  36 T native
 100   1   2  11  12  21  22  31  32   3   4  13  14  23  24  33  34
   4 T T
END
equal_results "Fortran" -m delta -n 4 fortran
