c     f77_counter_fault.f - main and the handler count in one variable of a common block, main without
c     masktrap: a count may be lost.
c     variable: ndone
      program counter
      include 'fnx.h'
      integer ndone, ncame, i, iold
      external onjob
      common /work/ ndone, ncame
      if (mynode() .eq. 0) then
         call hrecv(5, i, 0, onjob)
         do 10 i = 1, 8
            call flick
            ndone = ndone + 1                                             ! RACE
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
      ndone = ndone + 1                                                   ! RACE
      ncame = ncame + 1
      if (ncame .lt. 8) call hrecv(5, type, 0, onjob)
      if (ncame .eq. 8) call csend(6, type, 0, mynode(), 0)
      end

      block data
      common /work/ ndone, ncame
      integer ndone, ncame
      data ndone, ncame /0, 0/
      end
