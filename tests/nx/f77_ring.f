c     f77_ring.f - a token round a ring, sums, and a handler, as Fortran programs of 1990 write them.
c run: -m delta -n 1
c run: -m ipsc860 -n 8
c run: -m delta -n 33
      program ring
      integer me, n, token, i, bad
      integer k(4), kw(4)
      double precision x(10), w(10), t0, dclock
      character*12 name
      external arrive
      integer got
      common /arrive1/ got
      data got /0/
      me = mynode()
      n = numnodes()
      bad = 0
      t0 = dclock()
      name = ' '
      call hrecv(77, name, len(name), arrive)
      call gsync
      token = 0
      if (me .eq. 0) then
         call csend(5, token, 4, mod(me+1, n), 0)
         call crecv(5, token, 4)
         if (token .ne. n*(n-1)/2) bad = bad + 1
         if (infonode() .ne. n-1 .or. infocount() .ne. 4) bad = bad + 1
      else
         call crecv(5, token, 4)
         token = token + me
         call csend(5, token, 4, mod(me+1, n), 0)
      endif
c     sums of both kinds; an INTEGER has 4 bytes
      do 10 i = 1, 10
   10 x(i) = me * i
      call gdsum(x, 10, w)
      if (x(10) .ne. 5d0 * n * (n-1)) bad = bad + 1
      k(1) = me
      k(2) = -1
      k(3) = 7
      k(4) = -me
      call gisum(k, 2, kw)
      if (k(1) .ne. n*(n-1)/2 .or. k(2) .ne. -n) bad = bad + 1
      if (k(3) .ne. 7 .or. k(4) .ne. -me) bad = bad + 1
      call gihigh(k(4), 1, kw)
      if (k(4) .ne. 0) bad = bad + 1
c     a handler in each node but 0
      call gsync()
      if (me .eq. 0) then
         do 20 i = 1, n-1
   20    call csend(77, 'message', 7, i, 0)
      else
   30    if (got .eq. 0) then
            call flick
            goto 30
         endif
         if (got .ne. 7707) bad = bad + 1
         if (name .ne. 'message') bad = bad + 1
      endif
      if (dclock() .le. t0) bad = bad + 1
      call gisum(bad, 1, kw)
      if (me .eq. 0) write (6, 100) bad
  100 format (' errors', i4)
      end

      subroutine arrive(type, count, node, pid)
      integer type, count, node, pid, got
      common /arrive1/ got
      if (node .eq. 0 .and. pid .eq. 0) got = type * 100 + count
      end
