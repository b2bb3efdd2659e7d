! mpi_nodes.f90 - MPI from Fortran: a ring with wildcards, a reduction in place, a grid, a structure of COMMON's addresses, a graph.
program ring
    use mpi
    implicit none
    integer :: ierr, rank, n, got, which, grid, pair, requests(2), statuses(MPI_STATUS_SIZE, 2), status(MPI_STATUS_SIZE)
    integer :: dims(2), coords(2), lengths(2), kinds(2), number, ends(2), none(1)
    logical :: weighted
    integer(kind=MPI_ADDRESS_KIND) :: places(2)
    double precision :: total, value
    common /data/ value, number
    call MPI_INIT(ierr)
    call MPI_COMM_RANK(MPI_COMM_WORLD, rank, ierr)
    call MPI_COMM_SIZE(MPI_COMM_WORLD, n, ierr)
    call MPI_ISEND(rank, 1, MPI_INTEGER, mod(rank + 1, n), 9, MPI_COMM_WORLD, requests(1), ierr)
    call MPI_IRECV(got, 1, MPI_INTEGER, MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, requests(2), ierr)
    call MPI_WAITALL(2, requests, statuses, ierr)
    total = rank
    call MPI_ALLREDUCE(MPI_IN_PLACE, total, 1, MPI_DOUBLE_PRECISION, MPI_SUM, MPI_COMM_WORLD, ierr)
    dims = 0
    call MPI_DIMS_CREATE(n, 2, dims, ierr)
    call MPI_CART_CREATE(MPI_COMM_WORLD, 2, dims, [.true., .false.], .false., grid, ierr)
    call MPI_CART_COORDS(grid, rank, 2, coords, ierr)
    call MPI_GET_ADDRESS(value, places(1), ierr)
    call MPI_GET_ADDRESS(number, places(2), ierr)
    lengths = 1
    kinds = [MPI_DOUBLE_PRECISION, MPI_INTEGER]
    call MPI_TYPE_CREATE_STRUCT(2, lengths, places, kinds, pair, ierr)
    call MPI_TYPE_COMMIT(pair, ierr)
    value = 0.5d0 + rank
    number = 10 * rank
    call MPI_BCAST(MPI_BOTTOM, 1, pair, 2, MPI_COMM_WORLD, ierr)
    requests = MPI_REQUEST_NULL
    call MPI_WAITANY(2, requests, which, status, ierr)
    if (which /= MPI_UNDEFINED .or. value /= 2.5d0 .or. number /= 20) print *, "wrong on", rank
    call MPI_DIST_GRAPH_CREATE_ADJACENT(MPI_COMM_WORLD, 1, [mod(rank + n - 1, n)], MPI_UNWEIGHTED, 0, none, MPI_WEIGHTS_EMPTY, &
        MPI_INFO_NULL, .false., grid, ierr)
    call MPI_DIST_GRAPH_NEIGHBORS_COUNT(grid, lengths(1), lengths(2), weighted, ierr)
    if (any(lengths /= [1, 0])) print *, "wrong degrees on", rank
    call MPI_DIST_GRAPH_NEIGHBORS(grid, 1, ends, MPI_UNWEIGHTED, 0, none, MPI_UNWEIGHTED, ierr)
    call MPI_TYPE_GET_ENVELOPE(pair, lengths(1), kinds(1), kinds(2), which, ierr)
    if (lengths(1) /= 3 .or. any(kinds /= 2) .or. which /= MPI_COMBINER_STRUCT) print *, "wrong envelope on", rank
    call MPI_ISEND(rank, 1, MPI_INTEGER, mod(rank + 1, n), 9, MPI_COMM_WORLD, requests(1), ierr)
    call MPI_MPROBE(MPI_ANY_SOURCE, 9, MPI_COMM_WORLD, which, status, ierr)
    call MPI_MRECV(number, 1, MPI_INTEGER, which, status, ierr)
    if (number /= status(MPI_SOURCE) .or. number /= got .or. which /= MPI_MESSAGE_NULL) print *, "wrong message on", rank
    call MPI_WAIT(requests(1), status, ierr)
    if (ends(1) /= mod(rank + n - 1, n)) print *, "wrong graph on", rank
    if (rank == n - 1) print "(3i3, f6.1, 2i3)", got, statuses(MPI_SOURCE, 2), statuses(MPI_TAG, 2), total, coords
    call MPI_FINALIZE(ierr)
end program
