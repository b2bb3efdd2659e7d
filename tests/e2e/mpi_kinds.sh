#!/bin/bash
# mpi_kinds.sh - nxcc --mpi with each kind of MPI that is installed (NXCC_MPICC), and programs that define names of MPI's and the
# C library's.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"
. "$tests/mpi.bash"
printed() { [ "$(cat out)" = "$1" ]; }
with_mpi() { # N PROGRAM ARGS
    limited "mpirun.$kind" -np "$@" >out 2>err
    status=$?
}

for kind in openmpi mpich; do
    if ! command -v mpicc.$kind mpirun.$kind >/dev/null || [ ! -d "$BUILD/node/mpi/$kind" ]; then
        echo "skip $kind: it is not installed, or was not when nxcc was built"
        continue
    fi
    export NXCC_MPICC=mpicc.$kind
    for program in interrupts own_names ends places crashes; do
        check "$kind: $program.c compiles" "$BUILD/nxcc" --mpi -O2 -g -o $program-$kind "$tests/mpi/$program.c"
    done
    with_mpi 2 ./interrupts-$kind
    check "$kind: a handler interrupts a computing program" printed "200 handled"
    with_mpi 3 ./own_names-$kind
    check "$kind: no name of the program's is called by the library" printed "sum 3"
    with_mpi 2 ./ends-$kind exits
    check "$kind: exit's status" ended_with 3
    with_mpi 2 ./crashes-$kind node
    check "$kind: an error, and its line" said '^  called from .*\(crashes\.c:[0-9]+\)'
    rm -rf cfs
    NX_RECORD=order.$kind with_mpi 3 ./places-$kind
    check "$kind: files are shared" [ "$(head -1 out)" = "$(hostname | cut -c1-16) $(hostname | cut -c1-16) $(hostname | cut -c1-16)" ]
    check "$kind: the order is recorded" grep -q '^match 0 ' order.$kind
    NX_DEADLOCK=0.2 with_mpi 3 ./places-$kind waits
    check "$kind: a deadlock ends the program" ended_with 2
    check "$kind: and is explained" said '^  nodes 0-2: crecv\(7\)'

    sed 's/progress/PMPI_Isend/; s/MPID_Send/PMPI_Test/' "$tests/mpi/own_names.c" >bad.c
    "$BUILD/nxcc" --mpi -O2 -w -o bad bad.c >out 2>err
    status=$?
    check "$kind: a program that defines PMPI_Isend and PMPI_Test is refused" ended_with 1
    check "$kind: they are named" said '^nxcc: --mpi: the program defines PMPI_Isend, PMPI_Test, by which NX calls MPI'
    check "$kind: there is no program" [ ! -e bad ]
done

if [ -e interrupts-openmpi ] && [ -e interrupts-mpich ]; then
    kind=openmpi with_mpi 2 ./interrupts-mpich
    check "started by another MPI's mpirun: an error" [ "$status" != 0 ]
    check "that says so" said "^nx: node 0, at .*: Open MPI's mpirun has started 2 processes, but the program's MPI knows only this one"
    kind=mpich with_mpi 2 ./interrupts-openmpi
    check "and the other way round" grep -q 'has started 2 processes, but' err out
fi

NXCC_MPICC=nowhere "$BUILD/nxcc" --mpi -o none "$tests/mpi/masks.c" >out 2>err
check "NXCC_MPICC that is not there: is named" said '^nxcc: --mpi: NXCC_MPICC is nowhere, which is not to be found'
NXCC_MPICC=gcc "$BUILD/nxcc" --mpi -o none "$tests/mpi/masks.c" >out 2>err
check "NXCC_MPICC that is no MPI's: is refused" said "^nxcc: --mpi: /.*/gcc is neither Open MPI's nor MPICH's"
"$BUILD/nxcc" --mpi -static -o none "$tests/mpi/masks.c" >out 2>err
check "-static is refused" said '^nxcc: -static: '
