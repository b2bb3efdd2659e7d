c     if77 -Mextend. Linear algebra by -lkmath: right results, and the time of an i860's assembler: for a product of matrices two clocks
c     a multiplication, for others less than the same loops take when they are the program's own.
      program algebra
      integer n, i, j, k, info, pivots(100), c0, c1, got
      parameter (n = 100)
      double precision a(n,n), b(n,n), c(n,n), d(n,n), x(n), t, worst
      double precision ddot, dclock, dzasum, own, kmath, w(n), work(3*n), values(n)
      volatile got
      external answer
      common /handled/ got
      do 10 j = 1, n
        x(j) = 1.0d0 / j
        do 10 i = 1, n
          a(i,j) = 1.0d0 / (i + j)
          if (i .eq. j) a(i,j) = a(i,j) + 2
          b(i,j) = dble(i) - j
          c(i,j) = 0
 10       d(i,j) = 0
      t = dclock()
      call dgemm('N', 'N', n, n, n, 1d0, a, n, b, n, 0d0, c, n)
      kmath = dclock() - t
      t = dclock()
      do 20 j = 1, n
        do 20 k = 1, n
          do 20 i = 1, n
 20         d(i,j) = d(i,j) + b(k,j) * a(i,k)
      own = dclock() - t
      worst = 0
      do 30 j = 1, n
        do 30 i = 1, n
 30       worst = max(worst, abs(c(i,j) - d(i,j)))
      print '(a,l2)', 'dgemm: right', worst .lt. 1d-9
      print '(a,l2)', 'dgemm: two clocks a multiplication', abs(kmath / (2 * n**3 / 40d6) - 1) .lt. 0.1
      t = dclock()
      call dgemm('N', 'N', 0, n, n, 1d0, a, n, b, n, 0d0, c, n)
      print '(a,l2)', 'dgemm: no rows, no time', dclock() - t .lt. 1d-4

      t = dclock()
      w(1) = ddot(n, x, 1, x, 1)
      kmath = dclock() - t
      t = dclock()
      w(2) = 0
      do 40 i = 1, n
 40     w(2) = w(2) + x(i) * x(i)
      own = dclock() - t
      print '(a,l2)', 'ddot: right', abs(w(1) - w(2)) .lt. 1d-12
      print '(a,l2)', 'ddot: three clocks an element', abs(kmath / ((3 * n + 30) / 40d6 + 2d-6) - 1) .lt. 0.2

c     LAPACK: its time is that of the BLAS it calls
      d = a
      call dgemv('N', n, n, 1d0, a, n, x, 1, 0d0, w, 1)
      t = dclock()
      call dgetrf(n, n, d, n, pivots, info)
      kmath = dclock() - t
      call dgetrs('N', n, 1, d, n, pivots, w, n, info)
      print '(a,l2,i2)', 'dgetrf, dgetrs: right', maxval(abs(w - x)) .lt. 1d-12, info
      t = dclock()
      d = a
      do 50 k = 1, n
        do 50 j = k + 1, n
          d(k,j) = d(k,j) / d(k,k)
          do 50 i = k + 1, n
 50         d(i,j) = d(i,j) - d(i,k) * d(k,j)
      own = dclock() - t
      print '(a,l2,2f6.2)', 'dgetrf: faster than elimination', kmath .lt. own / 2 .and. kmath .gt. own / 9
      call dsyev('N', 'U', n, a, n, values, work, 3 * n, info)
      print '(a,l2,i2)', 'dsyev: right', abs(sum(values) - 2 * n - sum((/ (0.5d0 / i, i = 1, n) /))) .lt. 1d-10, info
      t = dzasum(1, x, 1)

c     a handler, while node 0 multiplies
      got = 0
      if (mynode() .eq. 0) call hrecv(1, i, 4, answer)
      call gsync()
      if (mynode() .eq. 0) then
        call dgemm('T', 'N', n, n, n, 1d0, b, n, b, n, 0d0, c, n)
      else if (mynode() .eq. 1) then
        t = dclock()
        call csend(1, i, 4, 0, 0)
        call crecv(2, i, 4)
        t = dclock() - t
        print '(a,l2)', 'a handler runs while a product is made', t .lt. 0.002
      end if
      call gsync()
      end
      subroutine answer(type, count, node, pid)
      integer type, count, node, pid, got
      common /handled/ got
      got = 1
      call csend(2, got, 4, node, 0)
      end
      double precision function dzasum(n, x, i)
      print '(a)', 'the program''s own dzasum'
      dzasum = 0
      end
