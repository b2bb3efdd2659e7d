c     f77_name_fault.f - the handler assigns a text of 24 characters that main compares and copies without
c     masktrap: it may see half of it. In the usual run the handler comes while main waits in crecv.
c     variable: phase
      program names
      include 'fnx.h'
      character*24 phase, new, copy
      integer i, iold
      external onphas
      common /texts/ phase, new
      if (mynode() .eq. 0) then
         phase = 'reading'
         call hrecv(5, new, 24, onphas)
         copy = phase                                                     ! RACE
         call crecv(6, i, 0)
         if (copy .eq. 'reading') copy = 'writing'
         if (copy .eq. 'writing') print *, phase
      else
         new = 'writing'
         call csend(5, new, 24, 0, 0)
      endif
      end

      subroutine onphas(type, count, node, pid)
      include 'fnx.h'
      integer type, count, node, pid
      character*24 phase, new
      common /texts/ phase, new
      phase = new                                                         ! RACE
      call csend(6, new, 0, mynode(), 0)
      end
