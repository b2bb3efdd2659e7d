! mpi_precision.f90 - datatypes for numbers of some precision and range are as long as the numbers of the kinds that Fortran chooses, and
! are summed as these. Each thing that is wrong is printed; rank 0 ends with how many datatypes there are.
program precision
    use mpi_f08
    implicit none
    integer, parameter :: fine = selected_real_kind(15, 307), long = selected_int_kind(12)
    integer, parameter :: quad = selected_real_kind(33, 4931), huge = selected_int_kind(38)
    integer, parameter :: digits(9) = [1, 6, 7, 15, 16, 18, 19, 33, MPI_UNDEFINED]
    integer, parameter :: ranges(7) = [1, 37, 38, 307, 308, 4931, MPI_UNDEFINED]
    type(MPI_Datatype) :: real, twice, complex, whole
    integer :: i, k, kind, bytes, rank, n, made, p, r
    real(fine) :: x
    complex(fine) :: z
    real(quad) :: q
    complex(quad) :: zq
    integer(huge) :: sixteen(2)
    integer(long) :: all_ranks
    character(len=3) :: parts(4)
    made = 0
    call MPI_Init()
    call MPI_Comm_rank(MPI_COMM_WORLD, rank)
    call MPI_Comm_size(MPI_COMM_WORLD, n)
    do i = 1, size(digits)
        do k = 1, size(ranges)
            p = digits(i)
            r = ranges(k)
            if (p == MPI_UNDEFINED .and. r == MPI_UNDEFINED) cycle
            kind = selected_real_kind(max(p, 0), max(r, 0))
            call MPI_Type_create_f90_real(p, r, real)
            call MPI_Type_create_f90_real(p, r, twice)
            call MPI_Type_size(real, bytes)
            call expect("a real's bytes", bytes == merge(16, kind, kind > 8))
            call expect("the same datatype", real == twice)
            made = made + 1
        end do
    end do
    do r = 1, 38
        kind = selected_int_kind(r)
        call MPI_Type_create_f90_integer(r, whole)
        call MPI_Type_size(whole, bytes)
        call expect("an integer's bytes", bytes == kind)
        made = made + 1
    end do
    call MPI_Type_create_f90_real(15, 307, real)
    call MPI_Type_create_f90_complex(15, 307, complex)
    call MPI_Type_create_f90_integer(12, whole)
    call MPI_Sizeof(z, bytes)
    call MPI_Type_match_size(MPI_TYPECLASS_COMPLEX, bytes, twice)
    call expect("the size of a variable", bytes == 16 .and. twice == MPI_COMPLEX16)
    call PMPI_Sizeof(parts(::2), bytes)
    call expect("of an element", bytes == 3)
    call MPI_Type_size(complex, bytes)
    call expect("a complex number's bytes", bytes == 16)
    call expect("other datatypes", real /= complex .and. real /= MPI_REAL8)

    x = 0.5_fine + rank
    call MPI_Allreduce(MPI_IN_PLACE, x, 1, real, MPI_SUM, MPI_COMM_WORLD)
    call expect("a sum of reals", x == 0.5_fine*n + n*(n - 1)/2)
    z = cmplx(1, rank, fine)
    call MPI_Allreduce(MPI_IN_PLACE, z, 1, complex, MPI_SUM, MPI_COMM_WORLD)
    call expect("a sum of complex numbers", z == cmplx(n, n*(n - 1)/2, fine))
    q = 1/3.0_quad + rank
    call MPI_Allreduce(MPI_IN_PLACE, q, 1, MPI_REAL16, MPI_MAX, MPI_COMM_WORLD)
    call expect("the largest of 113 bits", q == 1/3.0_quad + (n - 1))
    zq = cmplx(1/3.0_quad, rank, quad)
    call MPI_Allreduce(MPI_IN_PLACE, zq, 1, MPI_COMPLEX32, MPI_SUM, MPI_COMM_WORLD)
    q = zq
    call expect("a sum of 113 bits", abs(q - n/3.0_quad) < n*epsilon(q) .and. aimag(zq) == n*(n - 1)/2)
    sixteen = 2_huge**100 + rank
    call MPI_Allreduce(MPI_IN_PLACE, sixteen, 2, MPI_INTEGER16, MPI_SUM, MPI_COMM_WORLD)
    call expect("a sum of INTEGER(16)", all(sixteen == n*2_huge**100 + n*(n - 1)/2))
    all_ranks = ibset(0_long, 40 + mod(rank, 20))
    call MPI_Allreduce(MPI_IN_PLACE, all_ranks, 1, whole, MPI_BOR, MPI_COMM_WORLD)
    call expect("bits", all_ranks == ishft(2_long**min(n, 20) - 1, 40))
    if (rank == 0) print "(i0)", made
    call MPI_Finalize()

contains
    subroutine expect(what, holds)
        character(len=*), intent(in) :: what
        logical, intent(in) :: holds
        if (.not. holds) print *, "wrong: ", what, p, r
    end subroutine
end program
