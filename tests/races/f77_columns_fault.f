c     f77_columns_fault.f - two receives are posted into one column of a matrix, since the first subscript
c     was meant to be the second.
c     variable: a
      program cols
      include 'fnx.h'
      real a(10, 2)
      integer id1, id2
      common /matrix/ a
      if (mynode() .eq. 0) then
         id1 = irecv(5, a(1, 1), 40)                                      ! RACE
         id2 = irecv(6, a(2, 1), 36)                                      ! RACE
         call msgwait(id1)
         call msgwait(id2)
         print *, a(1, 1)
      else
         a = 3.0
         call csend(5, a, 40, 0, 0)
         call csend(6, a, 36, 0, 0)
      endif
      end
