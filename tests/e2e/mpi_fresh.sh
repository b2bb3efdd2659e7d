#!/bin/bash
# mpi_fresh.sh - programs of Fortran 2008, with the module mpi_f08, on simulated nodes: equal in both engines and with all workers; the
# module has all calls.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"

"$BUILD/nxcc" --as-mpi bin >links
check "mpif90 compiles" bin/mpif90 -O2 -g -o mpi_fresh "$tests/mpi_fresh.f90"
for n in 2 5 8; do
    run -q -m delta -n $n mpi_fresh
    check "on $n nodes all holds" test "$status:$(xargs <out)" = "0:$((64 * n * (n - 1))).0 T"
done
equal_results "Fortran 2008" -m delta -n 6 mpi_fresh
check "optimized, too" bin/mpif90 -O3 -o fast "$tests/mpi_fresh.f90"
run -q -m delta -n 4 fast
check "all holds" test "$status:$(xargs <out)" = "0:768.0 T"

printf '%s\n' 'use mpi_f08' 'call MPI_Barrier(257)' end >number.f90
bin/mpif90 number.f90 >out 2>err
check "a number is no communicator" said 'Type mismatch in argument .comm.'

# But for MPI-1's that MPI-3 has removed.
nm "$BUILD/node/libmpi.a" | sed -nE 's/.* [TW] (mpi_.*)_$/\1/p' | grep -vxE 'mpi_(attr_.*|.*_fn|keyval_.*|errhandler_(create|set|get)|address|type_(extent|lb|ub|hvector|hindexed|struct))' | sort >calls
gzip -dc "$BUILD/node/mpi_include/mpi_f08.mod" | grep -oE "'mpi_[a-z0-9_]*'" | tr -d "'" | sort -u >known
check "the module has all calls" test "$(comm -23 calls known | xargs)" = ""
