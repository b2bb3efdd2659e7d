c     f77_common_fault.f - a subroutine goes behind the end of a COMMON block
c     report: global-buffer-overflow: read of 8 bytes, just behind work (160 bytes, 
      program sums
      double precision a(10), b(10)
      common /work/ a, b
      integer i
      do 10 i = 1, 10
         a(i) = i
         b(i) = 2 * i
   10 continue
      call scale(a, 21)
      print *, a(1) + b(10)
      end
      subroutine scale(x, n)
      integer n, i
      double precision x(*)
      do 20 i = 1, n
         x(i) = 2 * x(i) ! FAULT
   20 continue
      end
