! f90_quad.f90 - REAL(16): 33 digits of what is read, computed by libquadmath, sent, printed and classified.
! run: -m delta -n 1
! run: -m paragon -n 3
program quad
    use, intrinsic :: ieee_arithmetic
    implicit none
    integer, parameter :: k = selected_real_kind(30)
    real(k) :: x, y
    character(len=60) :: line
    integer :: mynode, numnodes
    external mynode, numnodes
    if (mynode() == 0) then
        line = '1.1'
        read (line, *) x
        print '(f45.34, es45.34)', x, x
        print '(f42.32)', sqrt(x), sin(x), exp(x), x**0.3_k, log_gamma(-x)
        write (line, *) x
        read (line, *) y
        print *, x == y
        call csend(1, x, 16, mod(1, numnodes()), 0)
    end if
    if (mynode() == mod(1, numnodes())) then
        call crecv(1, y, 16)
        print '(f42.32)', y*10
        print *, ieee_class(-y) == ieee_negative_normal, ieee_is_nan(ieee_value(y, ieee_quiet_nan))
    end if
end program quad
