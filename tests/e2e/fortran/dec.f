c     What compilers of the time took from VAX Fortran.
      program dec
      integer*4 i, j, k
      real x /1.5/
      structure /point/
        integer a
        real b
      end structure
      record /point/ p
      p.a = 3
      p.b = x
      i = 5
      j = i .and. 3
      k = i .xor. j
d     print *, 'a line for debugging'
      k = ieor(k, 'f0'x)
      type *, i, j, k, p.a
      print 10, imod(-5), p.b
 10   format (' ', i3, f4.1)
      end
      integer function imod(n)
      imod = 100 + n
      end
