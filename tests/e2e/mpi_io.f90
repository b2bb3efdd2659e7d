! mpi_io.f90 - MPI's files from Fortran: a view of a distributed array, places, requests, the shared pointer, errors.
program files
    use mpi
    implicit none
    integer :: ierr, rank, n, fh, kind, request, count, i, status(MPI_STATUS_SIZE), own(6), back(6), whole(64)
    integer(kind=MPI_OFFSET_KIND) :: place, bytes, displacement
    integer :: etype, filetype
    character(len=MPI_MAX_DATAREP_STRING) :: representation
    call MPI_INIT(ierr)
    call MPI_COMM_RANK(MPI_COMM_WORLD, rank, ierr)
    call MPI_COMM_SIZE(MPI_COMM_WORLD, n, ierr)
    call MPI_TYPE_CREATE_DARRAY(n, rank, 1, [6 * n], [MPI_DISTRIBUTE_CYCLIC], [2], [n], MPI_ORDER_FORTRAN, MPI_INTEGER, kind, ierr)
    call MPI_TYPE_COMMIT(kind, ierr)
    call MPI_FILE_OPEN(MPI_COMM_WORLD, '/cfs/fortran  ', MPI_MODE_RDWR + MPI_MODE_CREATE, MPI_INFO_NULL, fh, ierr)
    displacement = 4
    call MPI_FILE_SET_VIEW(fh, displacement, MPI_INTEGER, kind, 'native', MPI_INFO_NULL, ierr)
    own = [(10 * rank + i, i = 1, 6)]
    call MPI_FILE_WRITE_ALL(fh, own, 6, MPI_INTEGER, status, ierr)
    call MPI_GET_COUNT(status, MPI_INTEGER, count, ierr)
    call MPI_FILE_GET_POSITION(fh, place, ierr)
    place = place - 3
    call MPI_FILE_IREAD_AT(fh, place, back, 3, MPI_INTEGER, request, ierr)
    call MPI_WAIT(request, MPI_STATUS_IGNORE, ierr)
    call MPI_FILE_GET_VIEW(fh, displacement, etype, filetype, representation, ierr)
    if (rank == n - 1) print '(4i4,l2,1x,a)', count, back(1:3), etype == MPI_INTEGER, trim(representation)
    call MPI_BARRIER(MPI_COMM_WORLD, ierr)
    call MPI_FILE_GET_SIZE(fh, bytes, ierr)
    displacement = 4
    call MPI_FILE_SET_VIEW(fh, displacement, MPI_INTEGER, MPI_INTEGER, 'native', MPI_INFO_NULL, ierr)
    whole = 0
    if (rank == 0) call MPI_FILE_READ(fh, whole, 6 * n, MPI_INTEGER, MPI_STATUS_IGNORE, ierr)
    if (rank == 0) print '(i4,16i4)', bytes, whole(1:4 * n)
    call MPI_FILE_WRITE_ORDERED(fh, rank, 1, MPI_INTEGER, status, ierr)
    call MPI_FILE_GET_POSITION_SHARED(fh, place, ierr)
    call MPI_FILE_CLOSE(fh, ierr)
    call MPI_FILE_OPEN(MPI_COMM_WORLD, '/cfs/missing', MPI_MODE_RDONLY, MPI_INFO_NULL, i, ierr)
    if (rank == 0) print '(i4,2l2)', place, fh == MPI_FILE_NULL, ierr == MPI_ERR_NO_SUCH_FILE
    call MPI_FINALIZE(ierr)
end program files
