! parts.f90 - what the operations of ops.def do in Fortran (family fortran): calls of NX, common blocks, array
! functions, formatted and list-directed transfers within memory, functions of characters. parts.h calls them;
! they hand each thing that they observe to f_note.

! Sends what lies in the common block.
subroutine f_send(type, length, node)
  implicit none
  include 'fcube.h'
  integer :: type, length, node, count
  double precision :: box(4000)
  common /box/ box, count
  count = count + 1
  box(1 + mod(count, 4000)) = count + mynode()
  call csend(type, box, length, mod(node, numnodes()), 0)
end subroutine

! Receives into the common block what is there.
subroutine f_receive(type)
  implicit none
  include 'fcube.h'
  integer :: type, count
  double precision :: box(4000)
  common /box/ box, count
  if (iprobe(type) == 0) return
  call crecv(type, box, 8 * size(box))
  call f_note(infocount())
  call f_note(infonode())
end subroutine

subroutine f_post(type, kind, clocks)
  implicit none
  include 'fcube.h'
  integer :: type, kind, clocks, id, here(100)
  here = kind
  id = isend(type, here, 4 * size(here), mynode(), 0)
  call f_compute(kind, clocks)
  call msgwait(id)
  id = irecv(type, here, 4 * size(here))
  if (msgdone(id) == 0) call msgcancel(id)
  call f_note(infocount())
end subroutine

subroutine f_sum(n)
  implicit none
  include 'fcube.h'
  integer :: n
  double precision :: x(8), work(8)
  x = mynode() + 1
  call gdsum(x, n + 1, work)
  call f_note(int(sum(x)))
end subroutine

subroutine f_clock()
  implicit none
  include 'fcube.h'
  call f_note(int(mod(dclock() * 1d9, 1d9)))
  call f_note(mclock())
end subroutine

subroutine f_compute(kind, clocks)
  implicit none
  integer :: kind, clocks, i
  double precision :: sums(3)
  common /sums/ sums
  do i = 1, clocks / 40
    if (mod(i, 3) == kind) cycle
    sums(1 + mod(i, 3)) = sums(1 + mod(i, 3)) * 0.5d0 + sqrt(dble(i))
  end do
  call f_note(int(sums(1)))
end subroutine

! Their costs depend on extents, and on which arguments are there.
subroutine f_arrays(kind, n)
  implicit none
  integer :: kind, n, i, at(1)
  double precision :: x(n + 1), y(n + 1, 3), z(3, n + 1), s
  x = [(mod(i * 37, 101) * 0.5d0, i = 1, n + 1)]
  s = n
  y = 0
  z = 0
  select case (kind)
  case (0)
    x = spread(sum(x), 1, n + 1)
  case (1)
    y = spread(x, 2, 3)
    z = spread(x, 1, 3)
  case (2)
    z = transpose(spread(x, 2, 3))
    y = matmul(spread(x, 2, 3), reshape([(dble(i), i = 1, 9)], [3, 3]))
  case (3)
    x = cshift(x, n / 2)
    x = eoshift(x, 1, s)
  case (4)
    x = merge(x, s, x > 20)
    s = dot_product(x, x) + count(x > 30) + maxval(x) - minval(x)
  case (5)
    x = unpack(pack(x, x > 25), x > 25, x)
  case (6)
    at = maxloc(x, x < 40)
    s = at(1) + product(x(1:2)) + sum(x, x > 10)
    at = minloc(x)
    s = s + at(1)
  case (7)
    y = reshape(x, [n + 1, 3], [s])
    s = sum(sum(y, 2)) + sum(maxval(y, 1))
  case (8)
    y = cshift(spread(x, 2, 3), 1, 2)
    z = eoshift(transpose(y), 1)
    if (any(y > 49) .and. .not. all(z > 1)) s = s + 1
  case default
    call random_number(x)
    x = x + sin(s) ** 2 + mod(s, 3d0) ** n
  end select
  call f_note(int(mod(s + sum(x) + sum(y) + sum(z), 1d9)))
end subroutine

! Formatted and list-directed transfers, within memory and to standard output.
subroutine f_text(kind, n)
  implicit none
  include 'fcube.h'
  integer :: kind, n, i, k
  double precision :: x
  character(len=80) :: line
  character(len=20) :: lines(3)
  logical :: flag
  x = n / 7d0
  k = n
  line = 'no number'
  lines = line(1:20)
  select case (kind)
  case (0)
    write (line, '(i6,f12.4,1x,a)') n, x, 'end'
    read (line, '(i6,f12.4)') k, x
  case (1)
    write (line, *) n, x, n > 3
    read (line, *) k, x, flag
    if (flag) k = k + 1
  case (2)
    write (line, '(es14.6,g12.4,z9,l2)') x, x * 1000, n, n > 3
    read (line, '(e14.6,g12.4,z9)') x, x, k
  case (3)
    write (lines, '(3(i5,a/))') (i * n, 'x', i = 1, 2)
    read (lines(1), '(i5)') k
    line = lines(2)
  case (4)
    lines(1) = '12 3.5 yes'
    read (lines(1), *) k, x, line
  case (5)
    write (line, '(8f9.3)') (x * i, i = 1, 8)
    read (line, '(8f9.3)') (x, i = 1, 8)
  case (6)
    read (lines(1), '(i9)', iostat=i) k
    write (line, '(i3,l2)') min(i, 1), i > 0
  case default
    print '(a,i3,i7,f14.9)', 'in Fortran:', mynode(), n, dclock()
  end select
  call f_note(k)
  call f_note(int(x * 100))
  call f_note_text(line)
end subroutine

subroutine f_note_text(text)
  implicit none
  character(len=*) :: text
  integer :: i
  do i = 1, len_trim(text)
    call f_note(ichar(text(i:i)))
  end do
end subroutine

character(len=30) function f_greeting(name, n)
  implicit none
  character(len=*) :: name
  integer :: n
  f_greeting = repeat('<', mod(n, 4)) // trim(adjustl(name)) // char(97 + mod(n, 26))
end function

subroutine f_characters(kind, n)
  implicit none
  integer :: kind, n, k
  character(len=30) :: f_greeting, text, other
  character(len=3), parameter :: NAMES(4) = ['one', 'two', 'six', 'ten']
  external f_greeting
  text = f_greeting(' ' // NAMES(1 + mod(n, 4)), n)
  other = adjustr(text)
  select case (kind)
  case (0)
    k = index(text, 'o') + index(text // other, 'e', .true.)
  case (1)
    k = scan(text, 'aeiou') + verify(text, '<')
  case (2)
    k = len_trim(text // other(1:mod(n, 30) + 1))
  case (3)
    k = merge(1, 2, text < other) + merge(3, 4, lle(text, 'two'))
  case (4)
    text = max(text, other, 'nine')
    k = ichar(text(1:1))
  case default
    text(mod(n, 20) + 1:) = other
    k = iachar(text(20:20))
  end select
  call f_note(k)
  call f_note_text(text)
end subroutine

! Reads what was never set.
subroutine f_never_set(n)
  implicit none
  integer :: n, k
  integer :: some(16)
  character(len=8) :: text
  if (n > 2) k = n
  some(n + 1) = n
  call f_note(k)
  call f_note(sum(some))
  call f_note_text(text)
end subroutine
