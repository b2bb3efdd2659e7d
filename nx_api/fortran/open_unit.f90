! open_unit.f90 - opening a unit on all nodes, which all call it: the first creates the file, so that the others find it.
subroutine gopen(unit, path, mode)
  implicit none
  integer, intent(in) :: unit, mode
  character(*), intent(in) :: path
  integer, external :: mynode
  external :: gsync, setiomode

  if (mynode() == 0) open(unit, file=path, form='unformatted')
  call gsync
  if (mynode() /= 0) open(unit, file=path, form='unformatted')
  call setiomode(unit, mode)
  call gsync
end subroutine
