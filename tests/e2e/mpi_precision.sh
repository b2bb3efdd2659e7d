#!/bin/bash
# mpi_precision.sh - datatypes for Fortran's numbers of some precision and range (MPI_Type_create_f90_real and kin), from C, and from
# Fortran by both modules.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"

"$BUILD/nxcc" --as-mpi bin >links
check "mpicc compiles" bin/mpicc -O2 -g -Wall -o inquiry "$tests/mpi_precision.c"
run -q -n 1 inquiry
check "what they were made of; they are not freed; there are no other kinds" diff out - <<'END'
real: so, 2 0 0: 7 -32766
complex: so, 2 0 0: 10 100
integer: so, 1 0 0: 9 0
2 received: 1.5 2.5
freed: no
digits: no
range: no
integers: no
neither: no
at most: 128
END

# Handles are INTEGERs in the module mpi, and each call has an error code.
sed -E 's/use mpi_f08/use mpi/; s/type\(MPI_Datatype\)/integer/; s/(call P?MPI_[A-Za-z0-9_]+\()(.*)\)$/\1\2, code)/; s/\(, code/(code/
    s/integer :: i, k/integer :: code, i, k/' "$tests/mpi_precision.f90" >mpi_precision_old.f90
cp "$tests/mpi_precision.f90" mpi_precision.f90
for program in mpi_precision mpi_precision_old; do
    check "$program compiles" bin/mpif90 -O2 -g -o $program $program.f90
    for n in 1 3; do
        run -q -n $n $program
        check "$program, $n ranks: as long as Fortran's kinds, and summed" test "$status:$(cat out)" = 0:100
    done
done
