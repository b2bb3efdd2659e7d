! fcube.h - NX for Fortran: types of its functions, and constants. Valid in fixed and in free form.
      integer csendrecv, ecmp, ediv, emod, ginv, gray, infocount
      integer infonode, infopid, infoptype, infotype, iodone
      integer iomode, iprobe, iprobex, iread, irecv, irecvx
      integer iseof, isend, isendrecv, iwrite, lseek, lsize
      integer masktrap, mclock, msgdone, msgmerge, myhost, mynode
      integer mypid, myptype, nodedim, numnodes
      integer nx_app_rect, nx_initve, nx_nfork, nx_waitall
      integer ireadoff, iwriteoff, myphysnode, nx_pri
      integer readoff, writeoff
      double precision dclock
      external csendrecv, ecmp, ediv, emod, ginv, gray, infocount
      external infonode, infopid, infoptype, infotype, iodone
      external iomode, iprobe, iprobex, iread, irecv, irecvx
      external iseof, isend, isendrecv, iwrite, lseek, lsize
      external masktrap, mclock, msgdone, msgmerge, myhost, mynode
      external mypid, myptype, nodedim, numnodes
      external nx_app_rect, nx_initve, nx_nfork, nx_waitall
      external ireadoff, iwriteoff, myphysnode, nx_pri
      external readoff, writeoff
      external dclock
! I/O modes, and where LSEEK, ESEEK, LSIZE and ESIZE count from
      integer m_unix, m_log, m_sync, m_record, m_global, m_async
      parameter (m_unix=0, m_log=1, m_sync=2, m_record=3)
      parameter (m_global=4, m_async=5)
      integer seek_set, seek_cur, seek_end
      parameter (seek_set=0, seek_cur=1, seek_end=2)
      integer size_set, size_cur, size_end
      parameter (size_set=0, size_cur=1, size_end=2)
! an INFO for the calls that end in X, for programs that want no array of their own
      integer msginfo(8)
      common /msginfo_/ msginfo
