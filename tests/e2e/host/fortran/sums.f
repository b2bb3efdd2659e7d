c     sums.f - host: has the nodes add up what it sends them.
      program sums
      include 'fcube.h'
      integer i, node, pid, status
      double precision part(2), total
      call setpid(100)
      call getcube('sums  ', '4', ' ', 0)
      call load('sums_node', -1, 3)
      do 10 i = 0, numnodes() - 1
         part(1) = i
         part(2) = 10 * i
         call csend(1, part, 16, i, 3)
 10   continue
      total = 0
      do 20 i = 1, numnodes()
         call crecv(2, part, 8)
         total = total + part(1)
 20   continue
      do 30 i = 1, numnodes()
         call waitone(-1, -1, node, pid, status)
         if (pid .ne. 3 .or. status .ne. 0) write(*,*) node, pid, status
 30   continue
      write(*,100) numnodes(), total
 100  format(i2, ' nodes, ', f6.1)
      call relcube('sums')
      end
