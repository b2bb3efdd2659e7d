c     f77_columns_correct.f - two receives are posted into two columns of a matrix, which lie one behind the
c     other.
      program cols
      include 'fnx.h'
      real a(10, 2)
      integer id1, id2
      common /matrix/ a
      if (mynode() .eq. 0) then
         id1 = irecv(5, a(1, 1), 40)
         id2 = irecv(6, a(1, 2), 36)
         call msgwait(id1)
         call msgwait(id2)
         print *, a(1, 1)
      else
         a = 3.0
         call csend(5, a, 40, 0, 0)
         call csend(6, a, 36, 0, 0)
      endif
      end
