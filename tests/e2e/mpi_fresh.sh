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

for call in MPI_Barrier PMPI_Barrier; do
    printf '%s\n' 'use mpi_f08' "call $call(257)" end >number.f90
    bin/mpif90 number.f90 >out 2>err
    check "$call: a number is no communicator" said 'Type mismatch in argument .comm.'
done
{
    echo 'use mpi_f08'
    for name in User {Comm,Type,Win}_{copy,delete}_attr {Comm,Win,File}_errhandler Grequest_{query,free,cancel}; do
        echo "procedure(MPI_${name}_function), pointer :: $name"
    done
    echo end
} >called.f90
check "procedures that MPI calls have interfaces" bin/mpif90 -o called called.f90
cat >profile.f90 <<'END'
! A profiling library's call, which stands before MPI's.
subroutine MPI_Sendrecv(sent, n, kind, to, tag, got, room, as, from, select, comm, status, ierror)
    use mpi_f08, only: MPI_Datatype, MPI_Comm, MPI_Status, MPI_Aint_diff, PMPI_Aint_add, PMPI_Sendrecv, PMPI_Get_count
    integer :: sent(*), n, to, tag, got(*), room, from, select, count
    integer, optional :: ierror
    type(MPI_Datatype) :: kind, as
    type(MPI_Comm) :: comm
    type(MPI_Status) :: status
    call PMPI_Sendrecv(sent, n, kind, to, tag, got, room, as, from, select, comm, status, ierror)
    call PMPI_Get_count(status, as, count)
    print "(a, i2, i3)", "profiled:", count, MPI_Aint_diff(PMPI_Aint_add(7_8, 3_8), 1_8)
end subroutine
program profile
    use mpi_f08
    integer :: own(2) = 0, other(2), rank
    type(MPI_Status) :: status
    call MPI_Init()
    call MPI_Comm_rank(MPI_COMM_WORLD, rank)
    own = rank
    call MPI_Sendrecv(own, 2, MPI_INTEGER, 1 - rank, 1, other, 2, MPI_INTEGER, 1 - rank, 1, MPI_COMM_WORLD, status)
    if (any(other /= 1 - rank)) print *, "wrong"
    call MPI_Finalize()
end program
END
check "a profiling library of Fortran 2008 compiles" bin/mpif90 -O2 -o profile profile.f90
run -q -n 2 profile
check "it is called, and calls MPI's by their second names" test "$status:$(xargs <out)" = "0:profiled: 2 9 profiled: 2 9"

# But for MPI-1's that MPI-3 has removed.
nm "$BUILD/node/libmpi.a" | sed -nE 's/.* [TW] (p?mpi_.*)_$/\1/p' | grep -vxE 'p?mpi_(attr_.*|.*_fn|keyval_.*|errhandler_(create|set|get)|address|type_(extent|lb|ub|hvector|hindexed|struct))' | sort >calls
gzip -dc "$BUILD/node/mpi_include/mpi_f08.mod" | grep -oE "'p?mpi_[a-z0-9_]*'" | tr -d "'" | sort -u >known
check "the module has all calls, by both names" test "$(comm -23 calls known | xargs)" = ""
