c     f77_info.f - INFO of IRECVX is of its own receive: a handler calls IRECVX while MSGWAIT of another takes a long message,
c     and may get the message id that MSGWAIT gives back.
c run: -m ipsc860 -n 2
c run: -m delta -n 2
c run: -m paragon -n 2
      program infos
      implicit none
      include 'fcube.h'
      integer info(8), buf(20000), id, i
      integer hinfo(8), hbuf(10), hid
      common /h/ hinfo, hbuf, hid
      external hand
      do 10 i = 1, 8
        info(i) = -7
   10   hinfo(i) = -7
      if (mynode() .eq. 0) then
        call hrecv(9, buf, 0, hand)
        call crecv(11, buf, 0)
        call csend(5, buf, 0, 1, 0)
        id = irecvx(1, buf, 80000, -1, -1, info)
        call msgwait(id)
        call crecv(12, buf, 0)
        write (*, *) 'the program:', (info(i), i = 1, 5)
        write (*, *) 'nothing:    ', (hinfo(i), i = 1, 5)
        call csend(6, buf, 0, 1, 0)
        call msgwait(hid)
        write (*, *) 'the handler:', (hinfo(i), i = 1, 5)
      else
        call csend(1, buf, 80000, 0, 0)
        call csend(11, buf, 0, 0, 0)
        call crecv(5, buf, 0)
        call csend(9, buf, 0, 0, 0)
        call csend(12, buf, 0, 0, 0)
        call crecv(6, buf, 0)
        call csend(2, buf, 12, 0, 0)
      end if
      end

      subroutine hand(t, c, n, p)
      implicit none
      include 'fcube.h'
      integer t, c, n, p, hinfo(8), hbuf(10), hid
      common /h/ hinfo, hbuf, hid
      hid = irecvx(2, hbuf, 40, -1, -1, hinfo)
      end
