c     f77_no_order_fault.f - main reads what the handler has computed after a message of node 1, which node
c     1 sends behind the handler's: that does not say that the handler has run.
c     variable: total
      program order
      include 'fnx.h'
      double precision total, part
      external onpart
      integer i
      common /sums/ total, part
      if (mynode() .eq. 0) then
         total = 1d0
         call hrecv(5, part, 8, onpart)
         call crecv(7, i, 4)
         print *, total                                                   ! RACE
      else
         call csend(5, 2.5d0, 8, 0, 0)
         do 10 i = 1, 100
   10    call flick
         call csend(7, i, 4, 0, 0)
      endif
      end

      subroutine onpart(type, count, node, pid)
      include 'fnx.h'
      integer type, count, node, pid
      double precision total, part
      common /sums/ total, part
      total = total + part                                                ! RACE
      call csend(6, part, 0, 1, 0)
      end
