c     f77_counter_correct.f - main and the handler count in one variable of a common block; main masks the
c     handler while it counts.
      program counter
      include 'fnx.h'
      integer ndone, ncame, i, iold
      external onjob
      common /work/ ndone, ncame
      if (mynode() .eq. 0) then
         call hrecv(5, i, 0, onjob)
         do 10 i = 1, 8
            call flick
            iold = masktrap(1)
            ndone = ndone + 1
            iold = masktrap(iold)
   10    continue
         call crecv(6, iold, 0)
         print *, ndone, ' jobs'
      else
         do 20 i = 1, 8
   20    call csend(5, i, 0, 0, 0)
      endif
      end

      subroutine onjob(type, count, node, pid)
      include 'fnx.h'
      integer type, count, node, pid, ndone, ncame
      external onjob
      common /work/ ndone, ncame
      ndone = ndone + 1
      ncame = ncame + 1
      if (ncame .lt. 8) call hrecv(5, type, 0, onjob)
      if (ncame .eq. 8) call csend(6, type, 0, mynode(), 0)
      end

      block data
      common /work/ ndone, ncame
      integer ndone, ncame
      data ndone, ncame /0, 0/
      end
