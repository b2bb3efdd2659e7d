c     f77_files.f - each node has its units to itself, for files on the Concurrent File System, scratch files and texts in
c     memory; sequential and direct, formatted and not; shared access by gopen, setiomode, cread and cwrite.
c run: -m ipsc860 -n 1
c run: -m ipsc860 -n 4
c run: -m delta -n 6
      program files
      implicit none
      include 'fcube.h'
      integer errors, work
      common /result/ errors
      errors = 0
      call own
      call direct
      call shared
      call scratc
      call status
      call gisum(errors, 1, work)
      if (mynode() .eq. 0) write (*, 100) errors
  100 format ('errors', i3)
      end

      subroutine check(ok, where)
      implicit none
      logical ok
      integer errors, where, mynode
      common /result/ errors
      if (ok) return
      errors = errors + 1
      write (0, *) 'node', mynode(), ' check', where
      end

c     the same unit number is another file on each node; two are open at once
      subroutine own
      implicit none
      include 'fcube.h'
      character*16 name, raw
      integer i, k, n, there
      real x
      n = mynode()
      write (name, '(a, i3.3)') '/cfs/own.', n
      open (10, file=name, status='new', form='formatted')
      raw = '/cfs/raw.'//name(10:12)
      open (11, file=raw, form='unformatted')
      do 10 i = 1, 200
         write (10, '(2i8, f10.3)') n, i, i / 8.0
         write (11) i, n * i
   10 continue
      close (11)
      rewind 10
      do 20 i = 1, 200
         read (10, *) there, k, x
         if (there .ne. n .or. k .ne. i .or. x .ne. i / 8.0) goto 30
   20 continue
      there = 0
      read (10, *, end=40) k
      there = -1
   40 call check(there .eq. 0, 1)
      backspace 10
      backspace 10
      write (10, '(a)') 'the end'
      rewind 10
      k = 0
   50 read (10, '(a)', end=60) name
      k = k + 1
      goto 50
   60 call check(k .eq. 200 .and. name .eq. 'the end', 2)
      close (10)
      open (11, file=raw, form='unformatted', status='old')
      k = 0
      do 70 i = 1, 200
         read (11) k, there
         if (k .ne. i .or. there .ne. n * i) goto 30
   70 continue
      close (11, status='delete')
      return
   30 call check(.false., 3)
      end

c     one file of records, written by all nodes, each its own
      subroutine direct
      implicit none
      include 'fcube.h'
      integer i, n, me, k(32)
      me = mynode()
      n = numnodes()
      if (me .eq. 0) open (20, file='/cfs/records', access='direct',
     1   recl=128, form='unformatted')
      call gsync
      if (me .ne. 0) open (20, file='/cfs/records', access='direct',
     1   recl=128, form='unformatted', status='old')
      do 10 i = me + 1, 8 * n, n
         k(1) = i
         k(32) = -i
   10 write (20, rec=i) k
      close (20)
      call gsync
c     a unit knows of the others' records once it is opened anew
      open (20, file='/cfs/records', access='direct', recl=128,
     1   form='unformatted', status='old')
      do 20 i = 1, 8 * n
         read (20, rec=i) k
   20 call check(k(1) .eq. i .and. k(32) .eq. -i, 11)
      close (20)
      end

c     in the order of the nodes, whoever is first
      subroutine shared
      implicit none
      include 'fcube.h'
      integer i, k(256), n, me, id
      me = mynode()
      n = numnodes()
      call gopen(30, '/cfs/shared', m_sync)
      call check(iomode(30) .eq. m_sync, 21)
      do 10 i = 1, 256
   10 k(i) = me
      do 15 i = 1, 100 * (n - me)
   15 call flick
      call cwrite(30, k, 4 * (me + 1))
      call gsync
      call setiomode(30, m_unix)
      call check(lseek(30, 0, seek_end) .eq. 2 * n * (n + 1), 22)
      call check(iseof(30) .eq. 1, 23)
      call check(lseek(30, 0, seek_set) .eq. 0, 24)
      id = iread(30, k, 4)
      call iowait(id)
      call check(k(1) .eq. 0, 25)
      call cread(30, k, 8 * n)
      if (n .gt. 1) call check(k(1) .eq. 1 .and. k(2) .eq. 1, 26)
      call check(lsize(30, 0, size_cur) .ge. 2 * n * (n + 1), 27)
      close (30)
      end

      subroutine scratc
      implicit none
      integer i, k
      character*30 line
      open (40, status='scratch')
      write (40, *) (i, i = 1, 30)
      rewind 40
      read (40, *) (k, i = 1, 30)
      call check(k .eq. 30, 31)
      close (40)
      write (line, '(3i10)') 1, 22, 333
      read (line, '(20x, i10)') k
      call check(k .eq. 333, 32)
      end

c     errors that the program asks for
      subroutine status
      implicit none
      integer k, ios
      character*80 line
      logical there
      open (50, file='/cfs/nowhere', status='old', iostat=ios)
      call check(ios .ne. 0, 41)
      inquire (file='/cfs/records', exist=there)
      call check(there, 42)
      line = 'twelve'
      read (line, *, iostat=ios) k
      call check(ios .gt. 0, 43)
      read (line, '(i6)', err=10) k
      call check(.false., 44)
   10 inquire (unit=50, opened=there)
      call check(.not. there, 45)
      end
