      program flame
      include 'fnx.h'
      double precision s
      s = 0d0
      call relax(s, 1000)
      call gsync()
      if (mynode() .eq. 0) print *, 'done'
      end

      subroutine relax(s, n)
      double precision s
      integer n, i
      do 10 i = 1, n
         s = s + 1d0 / i
 10   continue
      call exchange(s)
      end

      subroutine exchange(s)
      include 'fnx.h'
      double precision s
      if (mynode() .eq. 0) then
         call crecv(5, s, 8)
      else
         call csend(5, s, 8, 0, 0)
      end if
      end
