c     f77_name_correct.f - the handler assigns a text of 24 characters; main copies it while the handler is
c     masked, and compares the copy.
      program names
      include 'fnx.h'
      character*24 phase, new, copy
      integer i, iold
      external onphas
      common /texts/ phase, new
      if (mynode() .eq. 0) then
         phase = 'reading'
         call hrecv(5, new, 24, onphas)
         iold = masktrap(1)
         copy = phase
         iold = masktrap(iold)
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
      phase = new
      call csend(6, new, 0, mynode(), 0)
      end
