c     f77_element_fault.f - main gives element 3 of an array to a subroutine that adds to it, and the
c     handler adds to the same element; main does not mask the handler.
c     variable: load|k
      program elemnt
      include 'fnx.h'
      integer load(4), more, i
      external onmore
      common /loads/ load, more
      if (mynode() .eq. 0) then
         load = 0
         call hrecv(5, more, 4, onmore)
         do 10 i = 1, 5
   10    call add(load(3), i)
         call crecv(6, i, 0)
         print *, load(3) + load(4)
      else
         call csend(5, 100, 4, 0, 0)
      endif
      end

      subroutine add(k, n)
      integer k, n
      k = k + n                                                           ! RACE
      end

      subroutine onmore(type, count, node, pid)
      include 'fnx.h'
      integer type, count, node, pid, load(4), more
      common /loads/ load, more
      load(3) = load(3) + more                                            ! RACE
      call csend(6, more, 0, mynode(), 0)
      end
