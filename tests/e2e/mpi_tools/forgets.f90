! forgets.f90 - a Fortran program that forgets a request, and sends more than it has.
program forgets
  use mpi
  implicit none
  integer :: rank, nprocs, ierr, request
  integer :: here(2)
  call MPI_Init(ierr)
  call MPI_Comm_rank(MPI_COMM_WORLD, rank, ierr)
  call MPI_Comm_size(MPI_COMM_WORLD, nprocs, ierr)
  call MPI_Irecv(here, 2, MPI_INTEGER, MPI_ANY_SOURCE, 5, MPI_COMM_WORLD, request, ierr)
  here(1) = 3
  call MPI_Barrier(MPI_COMM_WORLD, ierr)
  call MPI_Finalize(ierr)
end program
