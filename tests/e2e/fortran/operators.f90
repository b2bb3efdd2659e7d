! operators.f90 - an operator that a module defines, in a procedure of another module that uses it.
module algebra
  interface operator(.dot.)
    module procedure dot
  end interface
contains
  real function dot(a, b)
    real, intent(in) :: a(:), b(:)
    dot = sum(a * b)
  end function
end module

module steps
  use algebra
contains
  subroutine step
    real :: y(2) = (/3., 4./)
    print '(f5.1)', y .dot. y
  end subroutine
end module

program operators
  use steps
  call step
end program
