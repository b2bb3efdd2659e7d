c     f77_section_fault.f - main sets the elements 4 to 6 of an array, and the handler 1 to 4: both set
c     element 4. In the usual run the message comes after that.
c     variable: a
      program section
      include 'fnx.h'
      real a(8), x(4)
      integer i
      external onpart
      common /arrays/ a, x
      if (mynode() .eq. 0) then
         call hrecv(5, x, 16, onpart)
         a(4:6) = 2.0                                                     ! RACE
         call crecv(6, i, 0)
         print *, a(1), a(6)
      else
         x(1:4) = 1.0
         call csend(5, x, 16, 0, 0)
      endif
      end

      subroutine onpart(type, count, node, pid)
      include 'fnx.h'
      integer type, count, node, pid
      real a(8), x(4)
      common /arrays/ a, x
      a(1:4) = x(1:4)                                                     ! RACE
      call csend(6, x, 0, mynode(), 0)
      end
