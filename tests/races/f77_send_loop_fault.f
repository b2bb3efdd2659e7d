c     f77_send_loop_fault.f - each turn of the loop fills the one buffer and isends it; all sends are waited
c     for after the loop: the second turn changes the buffer of the first send.
c     variable: plane
      program sloop
      include 'fnx.h'
      integer plane(300), id(4), i, k, isum
      common /planes/ plane
      if (mynode() .eq. 0) then
         do 20 k = 1, 4
            do 10 i = 1, 300
   10       plane(i) = k                                                  ! RACE
            id(k) = isend(5, plane, 1200, 1, 0)                           ! RACE
   20    continue
         do 30 k = 1, 4
   30    call msgwait(id(k))
      else
         isum = 0
         do 40 k = 1, 4
            call crecv(5, plane, 1200)
   40    isum = isum + plane(300)
         print *, isum
      endif
      end
