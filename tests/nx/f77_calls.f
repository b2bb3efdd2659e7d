c     f77_calls.f - every call in its Fortran form once: arguments by reference, INTEGERs of 4 bytes, INFO(8), INTEGER(2)
c     for sizes, CHARACTER for texts and for buffers.
c run: -m ipsc860 -n 4
c run: -m delta -n 6
c run: -m paragon -n 4
      program calls
      implicit none
      include 'fnx.h'
      integer errors, work(8)
      common /result/ errors
      errors = 0
      call plain
      call extend
      call handlers
      call reduce
      call others
      call sizes
      call gisum(errors, 1, work)
      if (mynode() .eq. 0) print *, 'errors', errors
      call waits
      end

      subroutine check(ok, where)
      implicit none
      include 'fnx.h'
      logical ok
      integer errors, where
      common /result/ errors
      if (ok) return
      errors = errors + 1
      write (0, *) 'node', mynode(), ' check', where
      end

c     csend crecv isend irecv msgwait msgdone msgcancel msgignore msgmerge cprobe iprobe info* csendrecv isendrecv gsendx
c     flushmsg
      subroutine plain
      implicit none
      include 'fnx.h'
      character*8 text, answer
      integer me, n, to, from, id, jd, k(2), nodes(2), count
      double precision x
      me = mynode()
      n = numnodes()
      to = mod(me + 1, n)
      from = mod(me + n - 1, n)
      write (text, '(a, i3.3)') 'node', me
      call csend(1, text, 7, to, 0)
      call cprobe(1)
      call check(infocount() .eq. 7 .and. infonode() .eq. from, 1)
      call check(infotype() .eq. 1 .and. infopid() .eq. 0, 2)
      answer = '????????'
      call crecv(1, answer, len(answer))
      read (answer, '(4x, i3)') k(1)
      call check(k(1) .eq. from .and. answer(8:) .eq. '?', 3)
      id = irecv(2, x, 8)
      call gsync
      jd = isend(2, me + 0.5d0, 8, to, mypid())
      call msgwait(jd)
    1 if (msgdone(id) .eq. 0) then
         call flick
         goto 1
      endif
      call check(x .eq. from + 0.5d0, 4)
      id = msgmerge(irecv(3, k, 8), -1)
      call csend(3, (/ me, -me /), 8, to, 0)
      call msgwait(id)
      call check(k(1) .eq. from .and. k(2) .eq. -from, 5)
      id = irecv(4, k, 4)
      call msgcancel(id)
      call msgignore(irecv(5, k, 4))
      call csend(5, me, 4, to, 0)
      call gsync
      call check(k(1) .eq. from, 6)
c     an answer from the next node, which asks the one after it
      if (me .eq. 0) then
         count = csendrecv(6, 21, 4, 1, 0, 7, k, 8)
         call check(count .eq. 4 .and. k(1) .eq. 42, 7)
         call msgwait(isendrecv(6, 4, 4, 1, 0, 7, k, 8))
         call check(k(1) .eq. 8, 8)
      else if (me .eq. 1) then
         call crecv(6, k, 4)
         call csend(7, 2 * k(1), 4, infonode(), 0)
         call crecv(6, k, 4)
         call csend(7, 2 * k(1), 4, infonode(), 0)
      endif
      nodes(1) = 2
      nodes(2) = 3
      if (me .eq. 0) call gsendx(8, 'both', 4, nodes, 2)
      if (me .eq. 2 .or. me .eq. 3) then
         call crecv(8, answer, 8)
         call check(answer(1:4) .eq. 'both', 9)
      endif
      call csend(9, me, 4, to, 0)
      call gsync
      call check(iprobe(9) .eq. 1, 10)
      call flushmsg(9, me, 0)
      call check(iprobe(9) .eq. 0, 11)
      end

c     crecvx irecvx cprobex iprobex
      subroutine extend
      implicit none
      include 'fnx.h'
      integer me, n, to, from, k, info(8), other(8), id, jd
      me = mynode()
      n = numnodes()
      to = mod(me + 1, n)
      from = mod(me + n - 1, n)
      info(5) = 4711
      call csend(11, me, 4, to, 0)
      call csend(12, me, 4, to, 0)
      call cprobex(11, from, -1, info)
      call check(info(1) .eq. 11 .and. info(2) .eq. 4, 21)
      call check(info(3) .eq. from .and. info(4) .eq. 0, 22)
      call check(info(5) .eq. 4711, 23)
      call crecvx(11, k, 4, from, 0, msginfo)
      call check(k .eq. from .and. msginfo(3) .eq. from, 24)
      call gsync
      call check(iprobex(12, from, -1, other) .eq. 1, 25)
      call check(other(1) .eq. 12, 26)
      call check(iprobex(12, me, -1, other) .eq. 0, 27)
      info(1) = 0
      id = irecvx(12, k, 4, from, -1, info)
      call msgwait(id)
      call check(info(1) .eq. 12 .and. info(3) .eq. from, 28)
      other(3) = -1
      info(3) = -1
      id = irecvx(13, k, 4, from, -1, info)
      jd = irecvx(14, k, 4, from, -1, other)
      id = msgmerge(id, jd)
      call csend(13, me, 4, to, 0)
      call csend(14, me, 4, to, 0)
      call msgwait(id)
      call check(info(3) .eq. from .and. other(3) .eq. from, 29)
      end

c     hsend hrecv hsendx hrecvx hsendrecv masktrap
      subroutine handlers
      implicit none
      include 'fnx.h'
      external sent, came, sentx, camex
      integer seen(6), k(4), me, n, to, i
      common /seens/ seen
      me = mynode()
      n = numnodes()
      to = mod(me + 1, n)
      do 10 i = 1, 6
   10 seen(i) = 0
      call hrecv(31, k(1), 4, came)
      call hrecvx(32, k(2), 4, -1, -1, camex, 321)
      call check(masktrap(1) .eq. 0, 31)
      call gsync
      call hsend(31, me, 4, to, 0, sent)
      call hsendx(32, me, 4, to, 0, sentx, 322)
      call check(seen(1) .eq. 0, 32)
      call check(masktrap(0) .eq. 1, 33)
   20 if (seen(1) * seen(2) * seen(3) * seen(4) .eq. 0) then
         call flick
         goto 20
      endif
      call check(seen(1) .eq. 31 .and. seen(2) .eq. 32, 34)
      call check(seen(3) .eq. 321 .and. seen(4) .eq. 322, 35)
      if (me .eq. 0) then
         call hsendrecv(33, 5, 4, 1, 0, 34, k(3), 4, came)
   30    if (seen(1) .eq. 31) then
            call flick
            goto 30
         endif
         call check(seen(1) .eq. 34 .and. k(3) .eq. 6, 36)
      else if (me .eq. 1) then
         call crecv(33, i, 4)
         call csend(34, i + 1, 4, 0, 0)
      endif
      end

      subroutine came(type, count, node, pid)
      integer type, count, node, pid, seen(6)
      common /seens/ seen
      if (count .eq. 4 .and. pid .eq. 0) seen(1) = type
      end

      subroutine sent(type, count, node, pid)
      integer type, count, node, pid, seen(6)
      common /seens/ seen
      if (type .eq. 31) seen(2) = 32
      end

      subroutine camex(type, count, node, pid, param)
      integer type, count, node, pid, param, seen(6)
      common /seens/ seen
      if (type .eq. 32) seen(3) = param
      end

      subroutine sentx(type, count, node, pid, param)
      integer type, count, node, pid, param, seen(6)
      common /seens/ seen
      if (type .eq. 32) seen(4) = param
      end

c     the global operations
      subroutine reduce
      implicit none
      include 'fnx.h'
      integer me, n, i, k(3), kw(3), total, lens(64)
      double precision d(2), dw(2)
      real s(2), sw(2)
      logical l(2), lw(2)
      character*64 all
      character*1 mine
      external keep
      me = mynode()
      n = numnodes()
      d(1) = me
      d(2) = 1d0
      call gdsum(d, 2, dw)
      call check(d(1) .eq. n*(n-1)/2 .and. d(2) .eq. n, 41)
      d(1) = 2d0
      call gdprod(d, 1, dw)
      call check(d(1) .eq. 2d0**n, 42)
      d(1) = me
      d(2) = me
      call gdhigh(d, 1, dw)
      call gdlow(d(2), 1, dw)
      call check(d(1) .eq. n - 1 .and. d(2) .eq. 0, 43)
      s(1) = me
      s(2) = 2
      call gssum(s, 1, sw)
      call gsprod(s(2), 1, sw)
      call check(s(1) .eq. n*(n-1)/2 .and. s(2) .eq. 2.0**n, 44)
      s(1) = me
      s(2) = me
      call gshigh(s, 1, sw)
      call gslow(s(2), 1, sw)
      call check(s(1) .eq. n - 1 .and. s(2) .eq. 0, 45)
      k(1) = me
      k(2) = -me
      k(3) = 7
      call gisum(k, 2, kw)
      call check(k(1) .eq. n*(n-1)/2 .and. k(2) .eq. -k(1), 46)
      call check(k(3) .eq. 7, 47)
      k(1) = -2
      call giprod(k, 1, kw)
      call check(k(1) .eq. (-2)**n, 48)
      k(1) = me
      k(2) = me
      call gihigh(k, 1, kw)
      call gilow(k(2), 1, kw)
      call check(k(1) .eq. n - 1 .and. k(2) .eq. 0, 49)
      k(1) = -1 - 2**me
      k(2) = 2**me
      k(3) = 1
      call giand(k, 1, kw)
      call gior(k(2), 1, kw)
      call gixor(k(3), 1, kw)
      call check(k(1) .eq. -2**n .and. k(2) .eq. 2**n - 1, 50)
      call check(k(3) .eq. mod(n, 2), 51)
      l(1) = me .eq. 0
      l(2) = me .ge. 0
      call glor(l, 1, lw)
      call gland(l(2), 1, lw)
      call check(l(1) .and. l(2), 52)
      l(1) = me .eq. 0
      call glxor(l, 1, lw)
      call check(l(1), 53)
      k(1) = mod(me + 2, n)
      call gopf(k, 4, kw, keep)
      call check(k(1) .eq. n - 1, 54)
      mine = char(ichar('a') + me)
      all = ' '
      call gcol(mine, 1, all, 64, total)
      call check(total .eq. n .and. all .eq. 'abcdefgh'(1:n), 55)
      do 10 i = 1, n
   10 lens(i) = 1
      all = ' '
      call gcolx(mine, lens, all)
      call check(all .eq. 'abcdefgh'(1:n), 56)
      end

      integer function keep(a, b)
      integer a, b
      a = max(a, b)
      keep = 0
      end

c     the machine
      subroutine others
      implicit none
      include 'fnx.h'
      integer rows, columns, ticks(2), later(2), i
      external never
      call check(myhost() .eq. numnodes(), 61)
      call check(2**nodedim() .ge. numnodes(), 62)
      call check(mypid() .eq. 0 .and. myptype() .eq. 0, 63)
      call check(gray(5) .eq. 7 .and. ginv(7) .eq. 5, 64)
      call mypart(rows, columns)
      call check(rows * columns .eq. numnodes(), 65)
      i = nx_app_rect(rows, columns)
      call check(rows * columns .eq. numnodes() .and. i .eq. 0, 66)
      call hwclock(ticks)
      do 10 i = 1, 100
   10 call flick()
      call hwclock(later)
      call esub(later, ticks, ticks)
      call check(ticks(1) .gt. 0 .and. ticks(2) .eq. 0, 67)
      call check(dclock() .gt. 0d0, 68)
      call check(abs(mclock() - 1d3*dclock()) .lt. 2, 69)
      call led(1)
      call setptype(3)
      call check(myptype() .eq. 3, 70)
      call setpid(0)
      call handler(1, never)
      call check(nx_initve(' ', 0, ' ', 0, 0) .eq. numnodes(), 71)
      call check(nx_waitall() .eq. 0, 72)
      end

      subroutine never
      stop 9
      end

c     extended arithmetic
      subroutine sizes
      implicit none
      include 'fnx.h'
      integer a(2), b(2), c(2)
      character*24 text
      call stoe('8589934597', a)
      call check(a(1) .eq. 5 .and. a(2) .eq. 2, 81)
      call stoe('-3  ', b)
      call eadd(a, b, c)
      call check(c(1) .eq. 2 .and. c(2) .eq. 2, 82)
      call emul(a, 3, c)
      call etos(c, text)
      call check(text .eq. '25769803791', 83)
      call check(ediv(a, 1000) .eq. 8589934, 84)
      call check(emod(a, 1000) .eq. 597, 85)
      call check(ecmp(a, b) .eq. 1 .and. ecmp(b, b) .eq. 0, 86)
      end

c     waitone waitall killproc
      subroutine waits
      implicit none
      include 'fnx.h'
      integer node, pid, status, i
      call gsync
      if (mynode() .ne. 0) then
         if (mynode() .eq. 1) call killproc(1, 0)
         stop
      endif
      do 10 i = 1, 2
      call waitone(-1, -1, node, pid, status)
   10 if (node .lt. 1 .or. status .ne. 0) print *, 'waitone', node
      call waitall(-1, -1)
      print *, 'all have ended'
      call killcube(-1, -1)
      end
