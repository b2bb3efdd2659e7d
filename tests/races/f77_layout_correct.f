c     f77_layout_correct.f - main and the handler name the parts of a common block otherwise: main's errs is
c     the handler's k(3); the handler sets k(4).
      program layout
      include 'fnx.h'
      integer lines, words, errs, spare, i
      external onset
      common /counts/ lines, words, errs, spare
      if (mynode() .eq. 0) then
         errs = 0
         call hrecv(5, i, 0, onset)
         do 10 i = 1, 6
            call flick
   10    errs = errs + mod(i, 2)
         call crecv(6, i, 0)
         print *, 'done'
      else
         do 20 i = 1, 60
   20    call flick
         call csend(5, i, 0, 0, 0)
      endif
      end

      subroutine onset(type, count, node, pid)
      include 'fnx.h'
      integer type, count, node, pid, k(4)
      common /counts/ k
      k(4) = 7
      call csend(6, k, 0, mynode(), 0)
      end
