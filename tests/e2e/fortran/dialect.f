      options /extend_source
c     What compilers of the time took beyond the standard, and GNU Fortran refuses with any option.
      program dialect
      implicit none
      integer i, j, k, n, key(3), records
      logical same
      character*12 c
      virtual key2(4)
      integer key2
      data key /'abcd', 'ef  ', 0/
      n = 8
c     ENCODE and DECODE, in texts and in arrays of numbers, with counts that are expressions
      c = 'xxxxxxxxxxxx'
      encode (n + 2, 100, c) 12, 3.5
 100  format (i4, f6.2)
      print *, c
      decode (4, 110, c) i
 110  format (i4)
      encode (8, 120, key(2)) 'gh', 7
 120  format (a2, i6)
      print '(i3,3a4)', i, key
      if (n .eq. 8) encode (4, 125, c(3:6)) n + i,
     1  n
 125  format (2i2)
 130  decode (6, 140, c, err=900) j
 140  format (2x, i4)
      print *, c, j
c     integers as conditions, of which the last bit counts
      i = 3
      j = 2
      if (i) print *, 'odd'
      if (j) then
         print *, 'even'
      else if (i .and. 1) then
         print *, 'odd, too'
      endif
      if (.not. j) print *, 'the other way round'
      k = 0
      do while (i - 2 * k .gt. 0 .and. .true.)
         k = k + 1
      end do
      do while (mod(k, 2) .eq. 1 .or. k / 2)
         k = k - 1
      end do
      do while (i)
         i = i - 1
      end do
      print *, i, k
c     numbers that are texts
      if (key(1) .eq. 'abcd' .and. key(2) .ne. 'abcd') print *,    'Hollerith'
c     files
      open (unit=10, name='dialect.dat', type='new', form='unformatted', access='direct', recordsize=8, maxrec=10,
     1      err=900)
      write (10'3) 5, 6
      write (10'2, err=900) 7, 8
      find (10'3)
      read (10'k + 3) i, j
      print *, i, j
      close (10, dispose='delete')
      inquire (file='dialect.dat', exist=same)
      print *, same
      accept *, i
      if (i .gt. 0) accept 110, j
      print *, i, j
      call again(2)
      call fails
 900  stop 'wrong'
      end
      subroutine again(n)
      integer n
      external fails, again
      external again
      print *, 'again', n
      end
      subroutine fails
      if (1) open (7,
     1  name='/nowhere/at/all',
     2  type='old')
      end
