c     f77_common_correct.f - as f77_common_fault.f, up to the end of the block
      program sums
      double precision a(10), b(10)
      common /work/ a, b
      integer i
      do 10 i = 1, 10
         a(i) = i
         b(i) = 2 * i
   10 continue
      call scale(a, 20)
      print *, a(1) + b(10)
      end
      subroutine scale(x, n)
      integer n, i
      double precision x(*)
      do 20 i = 1, n
         x(i) = 2 * x(i)
   20 continue
      end
