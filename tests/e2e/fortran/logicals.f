c     Logicals compared with .eq. and .ne., in all the places where a compiler of 1990 took them.
      program logics
      logical a, b, f, v(3), t(4)
      logical*1 s
      integer i, k
      character*30 text
      external f
      data v /.true., .false., .true./
      i = 1
      a = .true.
      b = .false.
      s = .true.
c     precedence: below .not. and above .and.
      t(1) = a .ne. b .and. b
      t(2) = i .eq. 1 .and. a .eq. b .or. a
      t(3) = .not. a .eq. b
      t(4) = b .or. v(i + 1) .EQ. f(k - k .eq. 0 .and. i .eq. 2)
      print '(4l2)', t
      t(1) = (a .and. b) .eq. (b .or. b)
      t(2) = (i .eq. 1) .eq. (a .neqv. b) .and. .true. .ne. b
      t(3) = b
     1  .eq.
c       a comment within
     2  v(2) ! and behind
      t(4) = s .eq. a
      print '(4l2)', t
 100  if (a .eq. b .or. b .eq. a) stop 'wrong'
C     A line that grows beyond column 72, with a text across two lines.
      if (a .eq. .true. .and. v(1) .ne. v(2)) print *,    'it is .eq. to
     + b', a .eq. .true.
	t(1) = a == b
	1 .or. a /= b
      if (t(1)) call fails(i)
      end
      logical function f(x)
      logical x
      f = x .eq. .true.
      end
      subroutine fails(i)
      open (7, file='/nowhere/at/all', status='old')
      end
