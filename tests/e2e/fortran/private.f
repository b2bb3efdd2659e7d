c     private.f - all that a program keeps is each node's own: COMMON, SAVE, DATA, BLOCK DATA, units, random numbers.
      program privat
      integer me, i, mynode, numnodes, next
      common /kept/ k(1000), start
      character*20 line
      real r(2), rand
      me = mynode()
      do 10 i = 1, 1000
   10 k(i) = k(i) + me
      call gsync
      n = 0
      do 20 i = 1, 3 + me
   20 n = next(n)
      open (9, status='scratch')
      write (9, '(i20)') me
      call gsync
      rewind 9
      read (9, '(a)') line
      read (line, *) i
      if (me .eq. 0) call srand(7)
      r(1) = rand(0)
      do 30 j = 0, numnodes() - 1
      call gsync
   30 if (me .eq. j) write (*, 100) me, k(1), k(1000), start, n, i,
     1   r(1) .eq. rand(7)
  100 format (i3, 2i5, f6.2, 2i4, l2)
      end
      integer function next(n)
      save count
      integer count
      data count /0/
      count = count + 1
      next = count
      end
      block data
      common /kept/ k(1000), start
      data start /2.5/
      end
