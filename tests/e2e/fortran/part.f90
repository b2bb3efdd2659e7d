! part.f90 - the other half of mixed.c
integer function twice(n)
  integer, intent(in) :: n
  twice = 2 * n
end function

subroutine compute
  common /totals/ count, sum
  integer :: count
  double precision :: sum
  call store('two', 2d0)
  call store('and a half', 0.5d0)
  print '(a, i2, f5.1)', 'Fortran has', count, sum
end subroutine
