! f90_modules.f90 - free form: modules, derived types, allocation, array expressions; a block of rows on each node, edges
! exchanged with irecv, isend and msgwait.
! run: -m delta -n 1
! run: -m ipsc860 -n 4
! run: -m paragon -n 6
module blocks
  implicit none
  type block
    integer :: first, last
    double precision, allocatable :: u(:, :)
  end type
contains
  subroutine make(b, me, nodes, n)
    type(block), intent(out) :: b
    integer, intent(in) :: me, nodes, n
    integer :: i, j
    b%first = me * n / nodes + 1
    b%last = (me + 1) * n / nodes
    allocate (b%u(0:n + 1, b%first - 1:b%last + 1))
    b%u = 0
    do j = b%first, b%last
      do i = 1, n
        b%u(i, j) = modulo(i * 7 + j * 3, 11)
      end do
    end do
  end subroutine

  subroutine exchange(b, me, nodes, n)
    include 'fcube.h'
    type(block), intent(inout) :: b
    integer, intent(in) :: me, nodes, n
    integer :: ids(4), k, bytes
    bytes = 8 * n
    k = 0
    if (me > 0) then
      ids(k + 1) = irecv(me - 1, b%u(1, b%first - 1), bytes)
      ids(k + 2) = isend(10000 + me, b%u(1, b%first), bytes, me - 1, 0)
      k = k + 2
    end if
    if (me < nodes - 1) then
      ids(k + 1) = irecv(10000 + me + 1, b%u(1, b%last + 1), bytes)
      ids(k + 2) = isend(me, b%u(1, b%last), bytes, me + 1, 0)
      k = k + 2
    end if
    do k = 1, k
      call msgwait(ids(k))
    end do
  end subroutine
end module

program smooth
  use blocks
  implicit none
  include 'fcube.h'
  integer, parameter :: n = 24
  type(block) :: b
  double precision, allocatable :: next(:, :)
  double precision :: total, work
  integer :: step, me, nodes, i, j
  me = mynode()
  nodes = numnodes()
  call make(b, me, nodes, n)
  allocate (next(n, b%first:b%last))
  do step = 1, 10
    call exchange(b, me, nodes, n)
    do j = b%first, b%last
      do i = 1, n
        next(i, j) = (b%u(i - 1, j) + b%u(i + 1, j) + b%u(i, j - 1) + b%u(i, j + 1)) / 4
      end do
    end do
    b%u(1:n, b%first:b%last) = next
  end do
  total = sum(b%u(1:n, b%first:b%last))
  call gdsum(total, 1, work)
  if (me == 0) print '(a, f12.6)', 'total', total
end program
