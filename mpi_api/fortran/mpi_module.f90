! mpi_module.f90 - use mpi: the constants of mpif.h. The calls have no explicit interfaces: buffers are of any type. But MPI_Sizeof is
! given what its variable is.
module mpi
    implicit none
    include 'mpif.h'
    integer(kind=MPI_ADDRESS_KIND), external :: MPI_AINT_ADD, MPI_AINT_DIFF, PMPI_AINT_ADD, PMPI_AINT_DIFF
    interface
        subroutine MPI_SIZEOF(x, size, ierror)
            type(*), dimension(..), intent(in) :: x
            integer, intent(out) :: size, ierror
        end subroutine
    end interface
    procedure(MPI_SIZEOF) :: PMPI_SIZEOF
end module mpi
