c     f77_paragon.f - the Paragon's calls as Fortran has them: files at offsets, bytes that IOWAIT tells, one read for all.
c run: -m paragon -n 1
c run: -m paragon95 -n 5
c run: -m ipsc860 -n 8
      program pgon
      implicit none
      include 'fnx.h'
      integer offset(2), back(10), data(10), id, i, n, rows, columns
      integer bad, work, mypart, iowait, cread
      external mypart, iowait, cread
      bad = 0
      do 10 i = 1, 10
   10 data(i) = 100 * mynode() + i
      if (myphysnode() .ne. mynode()) bad = bad + 1
      if (mypart(rows, columns) .ne. 0) bad = bad + 1
      if (rows * columns .ne. numnodes()) bad = bad + 1
      if (nx_pri(0, 5) .ne. 0) bad = bad + 1

      call gopen(10, '/pfs/f77', m_unix)
      offset(1) = 40 * mynode()
      offset(2) = 0
      if (writeoff(10, offset, data, 40) .ne. 40) bad = bad + 1
      call gsync
      n = mod(mynode() + 1, numnodes())
      offset(1) = 40 * n
      id = ireadoff(10, offset, back, 40)
      if (iowait(id) .ne. 40) bad = bad + 1
      if (back(1) .ne. 100 * n + 1) bad = bad + 1
      if (back(10) .ne. 100 * n + 10) bad = bad + 1
      id = iwriteoff(10, offset, back, 40)
      n = iowait(id)
      if (readoff(10, offset, back, 20) .ne. 20) bad = bad + 1
      call gsync

      call setiomode(10, m_global)
      if (iomode(10) .ne. m_global) bad = bad + 1
      n = cread(10, back, 8)
      if (back(1) .ne. 1 .or. back(2) .ne. 2) bad = bad + 1
      call gisum(bad, 1, work)
      if (mynode() .eq. 0) write (*, *) 'wrong:', bad
      close (10)
      end
