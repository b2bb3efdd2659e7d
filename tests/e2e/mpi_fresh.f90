! mpi_fresh.f90 - a program of Fortran 2008 with the module mpi_f08: a ring, a halo of derived types, reductions, communicators.
! Each thing that is wrong is printed; rank 0 ends with the sum and the time.
module halo
    use mpi_f08
    implicit none
    type :: grid
        type(MPI_Comm) :: comm = MPI_COMM_NULL
        type(MPI_Datatype) :: row
        integer :: before, behind
        real(8) :: cell(0:9, 0:17) = 0
    end type
contains
    subroutine begin(g, on)
        class(grid), intent(inout) :: g
        type(MPI_Comm), intent(in) :: on
        integer :: n
        call MPI_Comm_size(on, n)
        call MPI_Cart_create(comm_old=on, ndims=1, dims=[n], periods=[.true.], reorder=.false., comm_cart=g%comm)
        call MPI_Cart_shift(g%comm, direction=0, disp=1, rank_source=g%before, rank_dest=g%behind)
        call MPI_Type_create_subarray(2, array_of_sizes=[10, 18], array_of_subsizes=[1, 16], array_of_starts=[0, 1], &
                                      order=MPI_ORDER_FORTRAN, oldtype=MPI_DOUBLE_PRECISION, newtype=g%row)
        call MPI_Type_commit(g%row)
    end subroutine

    subroutine exchange(g)
        class(grid), intent(inout) :: g
        type(MPI_Request) :: r(4)
        type(MPI_Status) :: s(4)
        integer :: elements
        call MPI_Irecv(g%cell(0, 0), 1, g%row, g%before, 1, g%comm, r(1))
        call MPI_Irecv(g%cell(9, 0), count=1, datatype=g%row, source=g%behind, tag=2, comm=g%comm, request=r(2))
        call MPI_Isend(g%cell(1, 0), 1, g%row, g%before, 2, g%comm, r(3))
        call MPI_Isend(g%cell(8, 0), 1, g%row, g%behind, 1, g%comm, r(4))
        call MPI_Waitall(4, array_of_statuses=s, array_of_requests=r)
        call MPI_Get_elements(s(1), MPI_DOUBLE_PRECISION, elements)
        call expect("waitall", all(same(r, MPI_REQUEST_NULL)) .and. s(1)%MPI_SOURCE == g%before .and. s(2)%MPI_TAG == 2)
        call expect("get_elements", elements == 16)
    end subroutine

    elemental logical function same(a, b)
        type(MPI_Request), intent(in) :: a, b
        same = a == b
    end function

    subroutine expect(what, holds)
        character(len=*), intent(in) :: what
        logical, intent(in) :: holds
        integer :: rank
        call MPI_Comm_rank(MPI_COMM_WORLD, rank)
        if (.not. holds) print *, "wrong: ", what, " on", rank
    end subroutine

    subroutine later(invec, inoutvec, len, datatype)
        use iso_c_binding
        type(c_ptr), value :: invec, inoutvec
        integer :: len
        type(MPI_Datatype) :: datatype
        integer, pointer :: a(:), b(:)
        call c_f_pointer(invec, a, [len])
        call c_f_pointer(inoutvec, b, [len])
        call expect("the type that an operation is given", datatype == MPI_INTEGER)
        b = a
    end subroutine
end module

program fresh
    use halo
    use iso_c_binding, only: c_ptr, c_loc, c_associated
    implicit none
    type :: particle
        real(8) :: x
        integer :: id
    end type
    type(grid) :: g
    type(particle) :: p(2)
    type(MPI_Comm) :: half
    type(MPI_Datatype) :: kind
    type(MPI_Op) :: op
    procedure(MPI_User_function), pointer :: called => later
    type(MPI_Status) :: status
    type(MPI_Request) :: request
    integer(MPI_ADDRESS_KIND) :: at(3)
    integer :: rank, n, token, code, length, step, f(MPI_STATUS_SIZE), i
    integer, target :: square(4, 4)
    type(c_ptr) :: buffer
    real(8) :: total, began
    logical :: flag
    character(len=MPI_MAX_PROCESSOR_NAME) :: name
    call MPI_Init()
    began = MPI_Wtime()
    call MPI_Comm_rank(MPI_COMM_WORLD, rank)
    call MPI_Comm_size(MPI_COMM_WORLD, n, ierror=code)
    call expect("ierror", code == MPI_SUCCESS)

    ! A ring of derived types.
    call MPI_Get_address(p(1), at(1))
    call MPI_Get_address(p(1)%id, at(2))
    call MPI_Get_address(p(2), at(3))
    call MPI_Type_create_struct(2, [1, 1], [0_MPI_ADDRESS_KIND, MPI_Aint_diff(at(2), at(1))], [MPI_REAL8, MPI_INTEGER], kind)
    call MPI_Type_create_resized(kind, 0_MPI_ADDRESS_KIND, MPI_Aint_diff(at(3), at(1)), kind)
    call MPI_Type_commit(kind)
    p = [particle(rank + 0.5d0, rank), particle(-rank, -rank)]
    call MPI_Sendrecv_replace(p, 2, kind, dest=mod(rank + 1, n), sendtag=3, source=mod(rank + n - 1, n), recvtag=3, &
                              status=status, comm=MPI_COMM_WORLD)
    token = mod(rank + n - 1, n)
    call expect("a ring", p(1)%x == token + 0.5d0 .and. p(2)%id == -token .and. status%MPI_SOURCE == token)
    call MPI_Type_free(kind)
    call expect("a freed type", kind == MPI_DATATYPE_NULL)
    call MPI_Status_f082f(status, f)
    call expect("a status as mpif.h has it", f(MPI_SOURCE) == token .and. f(MPI_TAG) == 3)

    ! A section that does not lie together.
    square = reshape([(i, i=1, 16)], [4, 4])
    if (rank == 0) call MPI_Ssend(square(2, :), 4, MPI_INTEGER, n - 1, 4, MPI_COMM_WORLD)
    if (rank == n - 1) call MPI_Recv(square(:, 1), 4, MPI_INTEGER, 0, 4, MPI_COMM_WORLD, MPI_STATUS_IGNORE)
    call expect("a section", rank < n - 1 .or. all(square(:, 1) == [2, 6, 10, 14]))

    ! Halves of the ranks.
    call MPI_Comm_split(MPI_COMM_WORLD, key=rank, color=mod(rank, 2), newcomm=half)
    call expect("split", half /= MPI_COMM_NULL)
    call MPI_Comm_rank(half, token)
    call expect("a rank of a half", token == rank / 2)
    call MPI_Allreduce(MPI_IN_PLACE, token, 1, MPI_INTEGER, MPI_MAX, half)
    call expect("allreduce", token == (n - 1 - mod(n - 1 + rank, 2)) / 2)
    call MPI_Comm_free(half)
    call MPI_Op_create(commute=.false., user_fn=called, op=op)
    step = rank + 7
    call MPI_Iallreduce(sendbuf=step, recvbuf=token, count=1, datatype=MPI_INTEGER, op=op, comm=MPI_COMM_WORLD, request=request)
    call MPI_Test(request, flag, MPI_STATUS_IGNORE)
    if (.not. flag) call MPI_Wait(request, MPI_STATUS_IGNORE)
    call MPI_Op_free(op)
    call expect("an operation of the program's", token == 7)

    call begin(g, MPI_COMM_WORLD)
    g%cell(1:8, 1:16) = rank
    do step = 1, 5
        call exchange(g)
        g%cell(1:8, 1:16) = (g%cell(0:7, 1:16) + g%cell(1:8, 1:16) + g%cell(2:9, 1:16)) / 3
    end do
    call MPI_Reduce(sum(g%cell(1:8, 1:16)), total, 1, MPI_DOUBLE_PRECISION, MPI_SUM, 0, g%comm)

    call MPI_Buffer_attach(square, 64)
    call MPI_Buffer_detach(buffer_addr=buffer, size=length)
    call expect("the buffer's address", c_associated(buffer, c_loc(square)) .and. length == 64)
    call MPI_Buffer_attach(square, 64)
    call PMPI_Buffer_detach(buffer, length, code)
    call expect("by its second name", c_associated(buffer, c_loc(square)) .and. code == MPI_SUCCESS)
    call MPI_Get_processor_name(resultlen=length, name=name)
    call expect("a name", name(1:length) == trim(name) .and. length > 0)
    call MPI_Comm_set_errhandler(errhandler=MPI_ERRORS_RETURN, comm=MPI_COMM_WORLD)
    call MPI_Send(token, 1, MPI_INTEGER, n, 0, MPI_COMM_WORLD, code)
    call expect("an error", code == MPI_ERR_RANK)
    if (rank == 0) print "(f8.1, l2)", total, MPI_Wtime() > began
    call MPI_Finalize()
end program
