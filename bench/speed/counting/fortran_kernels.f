c     fortran_kernels.f - the counting benchmark's kernels in Fortran: LINPACK's elimination of order 100, an integer sort,
c     and the forces of a molecular dynamics program. counting.mk gives the three functions the names of their side.

      double precision function f_linpack()
      double precision a(100,100), b(100), s
      integer ipvt(100), i, j
      save a, b, ipvt
      do 10 j = 1, 100
         do 10 i = 1, 100
   10       a(i,j) = mod(3125*(i + 100*j) + i*j*j, 65536)/16384d0 - 2d0
      do 20 i = 1, 100
   20    b(i) = i
      call dgefa(a, 100, 100, ipvt)
      call dgesl(a, 100, 100, ipvt, b)
      s = 0
      do 30 i = 1, 100
   30    s = s + b(i)
      f_linpack = s
      end

      subroutine dgefa(a, lda, n, ipvt)
      integer lda, n, ipvt(n), j, k, l, i
      double precision a(lda,n), t
      do 60 k = 1, n - 1
         l = k
         do 10 i = k + 1, n
   10       if (abs(a(i,k)) .gt. abs(a(l,k))) l = i
         ipvt(k) = l
         t = a(l,k)
         a(l,k) = a(k,k)
         a(k,k) = t
         t = -1d0/t
         do 20 i = k + 1, n
   20       a(i,k) = t*a(i,k)
         do 50 j = k + 1, n
            t = a(l,j)
            a(l,j) = a(k,j)
            a(k,j) = t
            call daxpy(n - k, t, a(k+1,k), a(k+1,j))
   50    continue
   60 continue
      ipvt(n) = n
      end

      subroutine dgesl(a, lda, n, ipvt, b)
      integer lda, n, ipvt(n), k, l
      double precision a(lda,n), b(n), t
      do 20 k = 1, n - 1
         l = ipvt(k)
         t = b(l)
         b(l) = b(k)
         b(k) = t
         call daxpy(n - k, t, a(k+1,k), b(k+1))
   20 continue
      do 40 k = n, 1, -1
         b(k) = b(k)/a(k,k)
         call daxpy(k - 1, -b(k), a(1,k), b(1))
   40 continue
      end

      subroutine daxpy(n, t, x, y)
      integer n, i
      double precision t, x(*), y(*)
      do 10 i = 1, n
   10    y(i) = y(i) + t*x(i)
      end

c     Shell's sort of 5000 integers
      double precision function f_sort()
      integer k(5000), n, i, j, gap, t, seed
      parameter (n = 5000)
      save k
      seed = 4711
      do 10 i = 1, n
         seed = mod(seed*1366 + 150889, 714025)
   10    k(i) = seed
      gap = n/2
   20 continue
         do 40 i = gap + 1, n
            t = k(i)
            j = i
   30       if (j .gt. gap) then
               if (k(j-gap) .gt. t) then
                  k(j) = k(j-gap)
                  j = j - gap
                  goto 30
               endif
            endif
            k(j) = t
   40    continue
         gap = gap/2
      if (gap .gt. 0) goto 20
      f_sort = k(1) + 3d0*k(n/3) + k(n)
      end

c     forces among 256 atoms, all pairs
      double precision function f_forces()
      integer n, i, j, k, seed, cell
      parameter (n = 256)
      double precision x(3,n), f(3,n), d(3), r2, s2, s6, ff, e, box
      parameter (box = 7d0)
      save x, f
      seed = 1
      do 12 i = 1, n
         cell = i
         do 10 k = 1, 3
            seed = mod(seed*1366 + 150889, 714025)
            x(k,i) = 1.1d0*mod(cell, 7) + seed/7.14025d6
            cell = cell/7
   10       f(k,i) = 0
   12 continue
      e = 0
      do 50 i = 1, n - 1
         do 40 j = i + 1, n
            r2 = 0
            do 20 k = 1, 3
               d(k) = x(k,i) - x(k,j)
               if (d(k) .gt. 0.5d0*box) d(k) = d(k) - box
               if (d(k) .lt. -0.5d0*box) d(k) = d(k) + box
   20          r2 = r2 + d(k)*d(k)
            if (r2 .gt. 6.25d0) goto 40
            s2 = 1d0/r2
            s6 = s2*s2*s2
            e = e + 4d0*s6*(s6 - 1d0)
            ff = 48d0*s2*s6*(s6 - 0.5d0)
            do 30 k = 1, 3
               f(k,i) = f(k,i) + ff*d(k)
   30          f(k,j) = f(k,j) - ff*d(k)
   40    continue
   50 continue
      f_forces = e + f(1,1) + f(2,17)
      end
