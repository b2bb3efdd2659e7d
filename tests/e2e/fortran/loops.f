c     loops.f - the loops of costs.c
      subroutine axpy(n, a, x, y)
      double precision a, x(*), y(*)
      do 10 i = 1, n
   10 y(i) = y(i) + a * x(i)
      end
      subroutine pairs(n, x, f)
      double precision x(*), f(*), d, r, s
      do 20 i = 2, n
      do 10 j = 1, i - 1
         d = x(i) - x(j)
         if (d * d .lt. 0.3d0) then
            r = 1 / (d * d + 0.01d0)
            s = r * r * r
            f(i) = f(i) + d * s * (s - 0.5d0)
            f(j) = f(j) - d * s * (s - 0.5d0)
         endif
   10 continue
   20 continue
      end
      subroutine count(n, k)
      integer k(*)
      do 10 i = 0, n - 1
      j = mod(i * 37, n) + 1
   10 k(j) = k(j) + i / 3
      end
