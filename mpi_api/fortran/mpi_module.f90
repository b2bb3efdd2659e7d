! mpi_module.f90 - use mpi: the constants of mpif.h. The calls have no explicit interfaces: buffers are of any type.
module mpi
    implicit none
    include 'mpif.h'
    integer(kind=MPI_ADDRESS_KIND), external :: MPI_AINT_ADD, MPI_AINT_DIFF, PMPI_AINT_ADD, PMPI_AINT_DIFF
end module mpi
