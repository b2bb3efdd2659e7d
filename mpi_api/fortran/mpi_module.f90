! mpi_module.f90 - use mpi: the constants of mpif.h. The calls have no explicit interfaces: buffers are of any type.
module mpi
    implicit none
    include 'mpif.h'
end module mpi
