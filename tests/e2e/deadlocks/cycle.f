c     cycle.f - each node waits for its neighbour before it sends.
      program cycle
      include 'fnx.h'
      integer n
      n = numnodes()
      call swap(mod(mynode() + 1, n), mod(mynode() + n - 1, n))
      end

      subroutine swap(from, to)
      include 'fnx.h'
      integer from, to
      integer info(8)
      double precision x, y
      x = 1
      call crecvx(7, y, 8, from, -1, info)
      call csend(7, x, 8, to, 0)
      end
