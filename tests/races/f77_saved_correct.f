c     f77_saved_correct.f - main and the handler call one function with a saved variable; main masks the
c     handler around its call.
      program saved
      include 'fnx.h'
      integer next, i, iold, k
      external onask
      if (mynode() .eq. 0) then
         call hrecv(5, i, 0, onask)
         do 10 i = 1, 5
            iold = masktrap(1)
            k = next()
            iold = masktrap(iold)
   10    continue
         call crecv(7, i, 0)
         if (k .gt. 0) print *, next()
      else
         call csend(5, i, 0, 0, 0)
         call crecv(6, k, 4)
         call csend(7, i, 0, 0, 0)
      endif
      end

      integer function next()
      integer seed
      save seed
      data seed /1/
      seed = mod(seed * 171, 30269)
      next = seed
      end

      subroutine onask(type, count, node, pid)
      include 'fnx.h'
      integer type, count, node, pid, next
      call csend(6, next(), 4, node, 0)
      end
