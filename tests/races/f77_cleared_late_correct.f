c     f77_cleared_late_correct.f - the buffer is cleared before the receive for it is posted.
      program clearl
      include 'fnx.h'
      real rows(40)
      integer id, i
      common /table/ rows
      if (mynode() .eq. 0) then
         do 10 i = 1, 40
   10    rows(i) = 0.0
         id = irecv(5, rows, 160)
         call csend(6, i, 0, 1, 0)
         call msgwait(id)
         print *, rows(40)
      else
         do 20 i = 1, 40
   20    rows(i) = i
         call csend(5, rows, 160, 0, 0)
         call crecv(6, i, 0)
      endif
      end
