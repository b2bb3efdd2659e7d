! f90_funloc.f90 - the address of a procedure as an argument: c_funloc(f). It differs from node to node.
! run: -m delta -n 3
module procedures
  use iso_c_binding
  implicit none
contains
  integer(c_int) function twice(x) bind(c)
    integer(c_int), value :: x
    twice = 2 * x
  end function

  integer function call_by_value(p, x)
    type(c_funptr), value :: p
    integer, intent(in) :: x
    procedure(twice), pointer :: f
    call c_f_procpointer(p, f)
    call_by_value = f(x)
  end function

  integer function call_by_reference(p, x)
    type(c_funptr), intent(in) :: p
    integer, intent(in) :: x
    procedure(twice), pointer :: f
    call c_f_procpointer(p, f)
    call_by_reference = f(x)
  end function
end module

program f90_funloc
  use procedures
  implicit none
  integer mynode
  external mynode
  print '(a, i0, a, i0, 1x, i0)', 'node ', mynode(), ': ', &
    call_by_value(c_funloc(twice), 10 + mynode()), call_by_reference(c_funloc(twice), 20 + mynode())
end program
