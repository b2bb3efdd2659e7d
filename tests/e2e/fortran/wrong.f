c     wrong.f - mistakes, by number
      program wrong
      character*8 which
      integer a(4), i
      call getarg(1, which)
      read (which, *) i
      if (mynode() .eq. 1) goto (10, 20, 30, 40), i
      call gsync
   10 read (5, *) a
   20 open (7, file='/nowhere/at/all', status='new')
   30 a(i + mynode() + 1) = 0
      print *, a
   40 call deep
      end
      subroutine deep
      call crecv(5, i, -4)
      end
