c     owner.f - routines of the program's own by the names of calls
      program owner
      integer gray
      call gsync
      call flick(1)
      call load('this', 2)
      print *, 'gray', gray(5)
      end
      integer function gray(n)
      gray = 1000 + n
      end
      subroutine flick(n)
      print *, 'flick', n
      end
      subroutine load(what, n)
      character*(*) what
      print *, 'load ', what, n
      end
