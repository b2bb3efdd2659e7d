! mpi_more.f90 - later calls of MPI from Fortran: collectives of neighbours and persistent ones, lists of datatypes, contents of a
! datatype, generalized requests, statuses, memory. Each thing that is wrong is printed.
program more
    use mpi
    use iso_c_binding
    implicit none
    integer :: ierr, i, rank, n, right, left, request, grid, twin, vector, more_kinds(1), ints(3), made(1), got(2), total, known
    integer :: status(MPI_STATUS_SIZE), length, group, info, window, cell, again, file
    integer, allocatable :: out(:), into(:), counts(:), places(:), kinds(:)
    integer(kind=MPI_ADDRESS_KIND) :: extra, none(1), bytes, zero
    integer(kind=8) :: longs(2)
    logical :: flag
    logical(c_bool) :: truth(2)
    type(c_ptr) :: memory
    integer, pointer :: numbers(:)
    character(len=MPI_MAX_LIBRARY_VERSION_STRING) :: version
    external :: query, release, cancel, of_file
    call MPI_INIT(ierr)
    call MPI_COMM_RANK(MPI_COMM_WORLD, rank, ierr)
    call MPI_COMM_SIZE(MPI_COMM_WORLD, n, ierr)
    right = mod(rank + 1, n)
    left = mod(rank + n - 1, n)

    allocate (out(n), into(n), counts(n), places(n), kinds(n))
    out = [(100 * rank + i, i = 0, n - 1)]
    counts = 1
    places = [(4 * i, i = 0, n - 1)]
    kinds = MPI_INTEGER
    call MPI_IALLTOALLW(out, counts, places, kinds, into, counts, places, kinds, MPI_COMM_WORLD, request, ierr)
    call MPI_WAIT(request, MPI_STATUS_IGNORE, ierr)
    call expect("ialltoallw", all(into == [(100 * i + rank, i = 0, n - 1)]))

    call MPI_CART_CREATE(MPI_COMM_WORLD, 1, [n], [.true.], .false., grid, ierr)
    call MPI_NEIGHBOR_ALLGATHER(rank, 1, MPI_INTEGER, got, 1, MPI_INTEGER, grid, ierr)
    call expect("neighbor_allgather", all(got == [left, right]))
    call MPI_INEIGHBOR_ALLTOALLV([rank, -rank], [1, 1], [0, 1], MPI_INTEGER, got, [1, 1], [1, 0], MPI_INTEGER, grid, request, ierr)
    call MPI_WAIT(request, MPI_STATUS_IGNORE, ierr)
    call expect("ineighbor_alltoallv", all(got == [right, -left]))

    call MPI_ALLREDUCE_INIT(rank, total, 1, MPI_INTEGER, MPI_SUM, MPI_COMM_WORLD, MPI_INFO_NULL, request, ierr)
    call MPI_START(request, ierr)
    call MPI_WAIT(request, MPI_STATUS_IGNORE, ierr)
    call MPI_REQUEST_FREE(request, ierr)
    call expect("allreduce_init", total == n * (n - 1) / 2)

    got = [3, 4]
    call MPI_REDUCE_LOCAL([1, 1], got, 2, MPI_INTEGER, MPI_SUM, ierr)
    call MPI_OP_COMMUTATIVE(MPI_SUM, flag, ierr)
    call expect("reduce_local, op_commutative", all(got == [4, 5]) .and. flag)
    longs = [1_8, rank * 10000000000_8]
    call MPI_ALLREDUCE(MPI_IN_PLACE, longs, 2, MPI_LONG_LONG_INT, MPI_MAX, MPI_COMM_WORLD, ierr)
    call expect("MPI_LONG_LONG_INT", longs(2) == (n - 1) * 10000000000_8)
    truth = [.true., rank > 0]
    call MPI_ALLREDUCE(MPI_IN_PLACE, truth, 2, MPI_C_BOOL, MPI_LAND, MPI_COMM_WORLD, ierr)
    call expect("MPI_C_BOOL", logical(truth(1) .and. .not. truth(2)))

    call MPI_TYPE_VECTOR(2, 1, 3, MPI_INTEGER, vector, ierr)
    call MPI_TYPE_GET_CONTENTS(vector, 3, 0, 1, ints, none, more_kinds, ierr)
    call expect("type_get_contents", all(ints == [2, 1, 3]) .and. more_kinds(1) == MPI_INTEGER)
    call MPI_TYPE_FREE(vector, ierr)

    extra = 5
    call MPI_GREQUEST_START(query, release, cancel, extra, request, ierr)
    call MPI_REQUEST_GET_STATUS(request, flag, status, ierr)
    call expect("request_get_status", .not. flag)
    call MPI_CANCEL(request, ierr)
    call MPI_GREQUEST_COMPLETE(request, ierr)
    call MPI_WAIT(request, status, ierr)
    call MPI_GET_COUNT(status, MPI_INTEGER, made(1), ierr)
    call MPI_TEST_CANCELLED(status, flag, ierr)
    call expect("grequest_start", made(1) == 5 .and. extra == 6 .and. flag .and. request == MPI_REQUEST_NULL)
    call MPI_GREQUEST_START(query, release, cancel, extra, request, ierr)
    known = request
    call MPI_REQUEST_FREE(request, ierr)
    call MPI_GREQUEST_COMPLETE(known, ierr)
    call expect("a freed generalized request ends when it is complete", extra == 7 .and. request == MPI_REQUEST_NULL)

    bytes = 40
    call MPI_ALLOC_MEM(bytes, MPI_INFO_NULL, memory, ierr)
    call c_f_pointer(memory, numbers, [10])
    numbers = rank
    call expect("alloc_mem", sum(numbers) == 10 * rank)
    call MPI_FREE_MEM(numbers, ierr)
    call MPI_GET_LIBRARY_VERSION(version, length, ierr)
    call expect("get_library_version", length > 0 .and. len_trim(version) == length)

    call expect("PMPI_WTIME", PMPI_WTIME() > 0 .and. PMPI_WTICK() > 0)

    call MPI_COMM_GROUP(MPI_COMM_WORLD, group, ierr)
    call MPI_COMM_CREATE_GROUP(MPI_COMM_WORLD, group, 7, twin, ierr)
    call MPI_COMM_GET_INFO(twin, info, ierr)
    call MPI_COMM_SET_INFO(twin, info, ierr)
    call MPI_COMM_COMPARE(twin, MPI_COMM_WORLD, known, ierr)
    call expect("comm_create_group", known == MPI_CONGRUENT)
    call MPI_COMM_DISCONNECT(twin, ierr)
    call expect("comm_disconnect", twin == MPI_COMM_NULL)
    call MPI_COMM_GET_PARENT(twin, ierr)
    call expect("comm_get_parent", twin == MPI_COMM_NULL)

    cell = 0
    zero = 0
    bytes = 4
    call MPI_WIN_CREATE(cell, bytes, 4, MPI_INFO_NULL, MPI_COMM_WORLD, window, ierr)
    call MPI_WIN_LOCK(MPI_LOCK_SHARED, right, 0, window, ierr)
    call MPI_RACCUMULATE(rank, 1, MPI_INTEGER, right, zero, 1, MPI_INTEGER, MPI_SUM, window, request, ierr)
    call MPI_WAIT(request, MPI_STATUS_IGNORE, ierr)
    call MPI_WIN_UNLOCK(right, window, ierr)
    call MPI_WIN_FREE(window, ierr)
    call expect("raccumulate", cell == left)

    call MPI_COMM_IDUP(MPI_COMM_WORLD, twin, request, ierr)
    call MPI_WAIT(request, MPI_STATUS_IGNORE, ierr)
    call MPI_COMM_IDUP_WITH_INFO(twin, MPI_INFO_NULL, again, request, ierr)
    call MPI_WAIT(request, MPI_STATUS_IGNORE, ierr)
    call MPI_COMM_COMPARE(again, MPI_COMM_WORLD, known, ierr)
    call expect("comm_idup", known == MPI_CONGRUENT)

    call MPI_ISENDRECV(rank, 1, MPI_INTEGER, right, 3, got, 1, MPI_INTEGER, left, 3, again, request, ierr)
    call MPI_WAIT(request, status, ierr)
    call MPI_GET_ELEMENTS_X(status, MPI_INTEGER, longs(1), ierr)
    call expect("isendrecv, get_elements_x", got(1) == left .and. longs(1) == 1)
    call MPI_ISENDRECV_REPLACE(got, 1, MPI_INTEGER, left, 4, right, 4, again, request, ierr)
    call MPI_WAIT(request, MPI_STATUS_IGNORE, ierr)
    call expect("isendrecv_replace", got(1) == rank)
    call MPI_STATUS_SET_ELEMENTS_X(status, MPI_INTEGER, 3000000000_8, ierr)
    call MPI_GET_ELEMENTS_X(status, MPI_INTEGER, longs(1), ierr)
    call expect("status_set_elements_x", longs(1) == 3000000000_8)

    call MPI_TYPE_CONTIGUOUS(1, MPI_INTEGER, vector, ierr)
    call MPI_TYPE_COMMIT(vector, ierr)
    kinds = vector
    call MPI_ALLTOALLW_INIT(out, counts, places, kinds, into, counts, places, kinds, again, MPI_INFO_NULL, request, ierr)
    call MPI_TYPE_FREE(vector, ierr)
    do i = 1, 3
        out = [(100 * rank + known * i, known = 0, n - 1)]
        call MPI_START(request, ierr)
        call MPI_WAIT(request, MPI_STATUS_IGNORE, ierr)
        call expect("alltoallw_init", all(into == [(100 * known + rank * i, known = 0, n - 1)]))
    end do
    call MPI_REQUEST_FREE(request, ierr)

    got = 0
    call MPI_NEIGHBOR_ALLTOALLW([rank, -rank], [1, 1], [0_8, 4_8], [MPI_INTEGER, MPI_INTEGER], got, [1, 1], [4_8, 0_8], &
        [MPI_INTEGER, MPI_INTEGER], grid, ierr)
    call expect("neighbor_alltoallw", all(got == [right, -left]))
    call MPI_INEIGHBOR_ALLTOALLW([rank, -rank], [1, 1], [0_8, 4_8], [MPI_INTEGER, MPI_INTEGER], got, [1, 1], [0_8, 4_8], &
        [MPI_INTEGER, MPI_INTEGER], grid, request, ierr)
    call MPI_WAIT(request, MPI_STATUS_IGNORE, ierr)
    call expect("ineighbor_alltoallw", all(got == [-left, right]))

    call MPI_TYPE_VECTOR(2, 1, 3, MPI_INTEGER, vector, ierr)
    call MPI_TYPE_SIZE_X(vector, longs(1), ierr)
    call MPI_TYPE_GET_EXTENT_X(vector, zero, longs(2), ierr)
    call expect("type_size_x, type_get_extent_x", all([longs, zero] == [8_8, 16_8, 0_8]))
    call MPI_TYPE_GET_TRUE_EXTENT_X(vector, longs(1), longs(2), ierr)
    call expect("type_get_true_extent_x", all(longs == [0_8, 16_8]))

    call MPI_WIN_ALLOCATE_SHARED(bytes, 4, MPI_INFO_NULL, MPI_COMM_SELF, memory, window, ierr)
    call MPI_WIN_SHARED_QUERY(window, 0, longs(1), known, extra, ierr)
    call expect("win_shared_query", longs(1) == 4 .and. known == 4 .and. extra == transfer(memory, extra))
    call MPI_WIN_FREE(window, ierr)

    extra = 3
    call MPI_REGISTER_DATAREP("thrice", MPI_CONVERSION_FN_NULL, MPI_CONVERSION_FN_NULL, of_file, extra, ierr)
    i = MPI_MODE_CREATE + MPI_MODE_RDWR + MPI_MODE_DELETE_ON_CLOSE
    call MPI_FILE_OPEN(MPI_COMM_WORLD, "thrice", i, MPI_INFO_NULL, file, ierr)
    call MPI_FILE_SET_VIEW(file, 0_8, MPI_INTEGER, MPI_INTEGER, "thrice", MPI_INFO_NULL, ierr)
    call MPI_FILE_GET_TYPE_EXTENT(file, MPI_INTEGER, bytes, ierr)
    call expect("register_datarep", bytes == 12)
    call MPI_FILE_CLOSE(file, ierr)
    if (rank == 0) print "(a)", "done"
    call MPI_COMM_SET_ERRHANDLER(MPI_COMM_WORLD, MPI_ERRORS_RETURN, ierr)
    call MPI_TYPE_CREATE_STRUCT(-1, counts, none, kinds, vector, ierr)
    if (ierr /= MPI_ERR_COUNT) print *, "wrong: a negative count"
    call MPI_FINALIZE(ierr)
contains
    subroutine expect(what, holds)
        character(len=*), intent(in) :: what
        logical, intent(in) :: holds
        if (.not. holds) print *, "wrong: ", what, " on", rank
    end subroutine
end program

subroutine query(extra, status, ierr)
    use mpi
    integer(kind=MPI_ADDRESS_KIND) :: extra
    integer :: status(MPI_STATUS_SIZE), ierr
    call MPI_STATUS_SET_CANCELLED(status, .true., ierr)
    call MPI_STATUS_SET_ELEMENTS(status, MPI_INTEGER, int(extra), ierr)
end subroutine

subroutine release(extra, ierr)
    use mpi
    integer(kind=MPI_ADDRESS_KIND) :: extra
    integer :: ierr
    extra = extra + 1
    ierr = MPI_SUCCESS
end subroutine

subroutine cancel(extra, complete, ierr)
    use mpi
    integer(kind=MPI_ADDRESS_KIND) :: extra
    logical :: complete
    integer :: ierr
    if (complete .or. extra /= 5) print *, "wrong: cancel"
    ierr = MPI_SUCCESS
end subroutine

subroutine of_file(kind, bytes, times, ierr)
    use mpi
    integer(kind=MPI_ADDRESS_KIND) :: bytes, times
    integer :: kind, size, ierr
    call MPI_TYPE_SIZE(kind, size, ierr)
    bytes = times * size
end subroutine
