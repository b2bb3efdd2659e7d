#!/bin/bash
# mpi_languages.sh - attributes that Fortran attaches and C gets, and the other way round.
# without: touchstone-lab app
. "$(dirname "$0")/common.bash"

"$BUILD/nxcc" --as-mpi bin >links
check "the C half compiles" bin/mpicc -O2 -g -Wall -c "$tests/mpi_languages.c"
check "the Fortran half compiles" bin/mpif90 -O2 -g -o languages "$tests/mpi_languages.f90" mpi_languages.o
run -q -n 1 languages
check "numbers and pointers cross" diff out - <<'END'
C gets -5000000000
C gets -7
widened -7
Fortran copies -5000000000
C copies 9
C gets -4999999999
C gets -7
Fortran gets C's address: yes
C deletes 42
C deletes 9
Fortran gets C's address: yes
tags are large: T
END
