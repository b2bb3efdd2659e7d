c     f77_send_loop_correct.f - each turn of the loop fills the one buffer, isends it, and waits for this
c     send.
      program sloop
      include 'fnx.h'
      integer plane(300), id(4), i, k, isum
      common /planes/ plane
      if (mynode() .eq. 0) then
         do 20 k = 1, 4
            do 10 i = 1, 300
   10       plane(i) = k
            id(k) = isend(5, plane, 1200, 1, 0)
            call msgwait(id(k))
   20    continue
      else
         isum = 0
         do 40 k = 1, 4
            call crecv(5, plane, 1200)
   40    isum = isum + plane(300)
         print *, isum
      endif
      end
