c     f77_cleared_late_fault.f - the buffer is cleared after the receive for it has been posted: the message
c     may be there already, and is lost. In the usual run it comes later.
c     variable: rows
      program clearl
      include 'fnx.h'
      real rows(40)
      integer id, i
      common /table/ rows
      if (mynode() .eq. 0) then
         id = irecv(5, rows, 160)                                         ! RACE
         do 10 i = 1, 40
   10    rows(i) = 0.0                                                    ! RACE
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
