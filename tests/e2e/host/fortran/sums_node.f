c     sums_node.f - node: adds up what the host sends.
      program node
      include 'fcube.h'
      double precision part(2)
      call crecv(1, part, 16)
      part(1) = part(1) + part(2)
      call csend(2, part, 8, myhost(), infopid())
      end
