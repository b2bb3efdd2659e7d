c     f77_read_early_correct.f - main reads its neighbour's edge when msgwait has said that it is there.
      program early
      include 'fnx.h'
      double precision edge(64), mine(64), s
      integer id, other, i
      common /edges/ edge, mine
      other = 1 - mynode()
      do 10 i = 1, 64
         edge(i) = 1d0
   10 mine(i) = 1d0
      id = irecv(5, edge, 8*64)
      call csend(5, mine, 8*64, other, 0)
      call msgwait(id)
      s = 0d0
      do 20 i = 1, 64
   20 s = s + edge(i)
      if (mynode() .eq. 0) print *, s
      end
