! mpi_win.f90 - MPI's windows from Fortran: fences, a lock, attributes.
program windows
    use mpi
    implicit none
    integer :: ierr, rank, n, win, memory(8), got(2), before
    integer(kind=MPI_ADDRESS_KIND) :: bytes, place, value
    logical :: flag
    call MPI_INIT(ierr)
    call MPI_COMM_RANK(MPI_COMM_WORLD, rank, ierr)
    call MPI_COMM_SIZE(MPI_COMM_WORLD, n, ierr)
    memory = 100 * rank
    bytes = 32
    call MPI_WIN_CREATE(memory, bytes, 4, MPI_INFO_NULL, MPI_COMM_WORLD, win, ierr)
    call MPI_WIN_FENCE(0, win, ierr)
    place = 2
    call MPI_PUT(rank, 1, MPI_INTEGER, mod(rank + 1, n), place, 1, MPI_INTEGER, win, ierr)
    place = 3
    call MPI_ACCUMULATE(rank, 1, MPI_INTEGER, 0, place, 1, MPI_INTEGER, MPI_SUM, win, ierr)
    call MPI_WIN_FENCE(0, win, ierr)
    place = 2
    call MPI_GET(got, 2, MPI_INTEGER, 0, place, 2, MPI_INTEGER, win, ierr)
    call MPI_WIN_FENCE(MPI_MODE_NOSUCCEED, win, ierr)
    call MPI_WIN_LOCK(MPI_LOCK_SHARED, 1, 0, win, ierr)
    place = 7
    call MPI_FETCH_AND_OP(1, before, MPI_INTEGER, 1, place, MPI_SUM, win, ierr)
    call MPI_WIN_UNLOCK(1, win, ierr)
    call MPI_BARRIER(MPI_COMM_WORLD, ierr)
    call MPI_WIN_GET_ATTR(win, MPI_WIN_SIZE, value, flag, ierr)
    if (rank == 1) print '(6i5,l2)', got, memory(3), memory(4), memory(8), value, flag
    call MPI_WIN_FREE(win, ierr)
    call MPI_FINALIZE(ierr)
end program windows
