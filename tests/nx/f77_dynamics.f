C     f77_dynamics.f - molecular dynamics of a Lennard-Jones fluid, as Fortran programs of 1990 do it: a share of the atoms on
C     each node; their positions and the forces on them travel round a ring of all nodes, half the way (Newton's third
C     law), then home. Velocity Verlet. The energy is the same on any number of nodes, to the digits printed.
C run: -m ipsc860 -n 1
C run: -m ipsc860 -n 4
C run: -m delta -n 5
C run: -m paragon -n 8
      PROGRAM MOLDYN
      IMPLICIT DOUBLE PRECISION (A-H, O-Z)
      PARAMETER (MAXN = 256, NSIDE = 4, NATOM = 4*NSIDE**3)
      COMMON /ATOMS/ X(3,MAXN), V(3,MAXN), F(3,MAXN), NLOC, NFIRST
      COMMON /CELL/ BOX, RCUT2
      COMMON /PARALL/ ME, NODES
      DIMENSION E(2), EWORK(2)
      DATA DT /0.004D0/, NSTEP /20/, DENS /0.8442D0/
C
      ME = MYNODE()
      NODES = NUMNODES()
      BOX = (DBLE(NATOM)/DENS)**(1D0/3D0)
      RCUT2 = MIN(2.5D0, 0.5D0*BOX)**2
      CALL LATTIC(NSIDE)
      CALL VELOCI
      CALL FORCES(EPOT)
      IF (ME .EQ. 0) WRITE (6, 1000) NATOM, BOX
 1000 FORMAT (' ATOMS', I6, '  BOX', F9.5)
C
      DO 100 ISTEP = 0, NSTEP
         IF (MOD(ISTEP, 5) .EQ. 0) THEN
            EKIN = 0D0
            DO 10 I = 1, NLOC
   10       EKIN = EKIN + 0.5D0*(V(1,I)**2 + V(2,I)**2 + V(3,I)**2)
            E(1) = EKIN
            E(2) = EPOT
            CALL GDSUM(E, 2, EWORK)
            IF (ME .EQ. 0) WRITE (6, 1010) ISTEP, E(1)/NATOM,
     1         E(2)/NATOM, (E(1)+E(2))/NATOM
         ENDIF
 1010    FORMAT (I6, 3F12.6)
         DO 30 I = 1, NLOC
            DO 20 K = 1, 3
               V(K,I) = V(K,I) + 0.5D0*DT*F(K,I)
               X(K,I) = X(K,I) + DT*V(K,I)
               IF (X(K,I) .LT. 0D0) X(K,I) = X(K,I) + BOX
               IF (X(K,I) .GE. BOX) X(K,I) = X(K,I) - BOX
   20       CONTINUE
   30    CONTINUE
         CALL FORCES(EPOT)
         DO 50 I = 1, NLOC
            DO 40 K = 1, 3
   40       V(K,I) = V(K,I) + 0.5D0*DT*F(K,I)
   50    CONTINUE
  100 CONTINUE
      CALL GSYNC
      END
C
C     Atoms on a face-centred lattice; this node's are NFIRST+1 to NFIRST+NLOC.
C
      SUBROUTINE LATTIC(NSIDE)
      IMPLICIT DOUBLE PRECISION (A-H, O-Z)
      PARAMETER (MAXN = 256)
      COMMON /ATOMS/ X(3,MAXN), V(3,MAXN), F(3,MAXN), NLOC, NFIRST
      COMMON /CELL/ BOX, RCUT2
      COMMON /PARALL/ ME, NODES
      DIMENSION BASIS(3,4)
      DATA BASIS /0D0,0D0,0D0, .5D0,.5D0,0D0, .5D0,0D0,.5D0,
     1            0D0,.5D0,.5D0/
      NATOM = 4*NSIDE**3
      NFIRST = ME*NATOM/NODES
      NLOC = (ME+1)*NATOM/NODES - NFIRST
      A = BOX/NSIDE
      N = 0
      DO 40 IX = 0, NSIDE-1
      DO 40 IY = 0, NSIDE-1
      DO 40 IZ = 0, NSIDE-1
      DO 40 IB = 1, 4
         N = N + 1
         I = N - NFIRST
         IF (I .GE. 1 .AND. I .LE. NLOC) THEN
            X(1,I) = (IX + BASIS(1,IB))*A
            X(2,I) = (IY + BASIS(2,IB))*A
            X(3,I) = (IZ + BASIS(3,IB))*A
         ENDIF
   40 CONTINUE
      END
C
C     The same velocities whatever the number of nodes: every node draws all of them.
C
      SUBROUTINE VELOCI
      IMPLICIT DOUBLE PRECISION (A-H, O-Z)
      PARAMETER (MAXN = 256)
      COMMON /ATOMS/ X(3,MAXN), V(3,MAXN), F(3,MAXN), NLOC, NFIRST
      COMMON /PARALL/ ME, NODES
      DIMENSION P(3), W(3)
      DO 20 N = 1, MAXN
      DO 20 K = 1, 3
         R = RANF()
         I = N - NFIRST
         IF (I .GE. 1 .AND. I .LE. NLOC) V(K,I) = 2.5D0*(R - 0.5D0)
   20 CONTINUE
      DO 30 K = 1, 3
      P(K) = 0D0
      DO 30 I = 1, NLOC
   30 P(K) = P(K) + V(K,I)
      CALL GDSUM(P, 3, W)
      DO 40 I = 1, NLOC
      DO 40 K = 1, 3
   40 V(K,I) = V(K,I) - P(K)/MAXN
      END
C
      DOUBLE PRECISION FUNCTION RANF()
      INTEGER ISEED
      SAVE ISEED
      DATA ISEED /4711/
      ISEED = MOD(ISEED*1366 + 150889, 714025)
      RANF = ISEED/714025D0
      END
C
C     Forces and this node's share of the potential energy. A packet of a node's atoms visits the next NODES/2 nodes.
C     With an even number of nodes the last of these meets its own visitor: each does half of the atoms.
C
      SUBROUTINE FORCES(EPOT)
      IMPLICIT DOUBLE PRECISION (A-H, O-Z)
      PARAMETER (MAXN = 256)
      COMMON /ATOMS/ X(3,MAXN), V(3,MAXN), F(3,MAXN), NLOC, NFIRST
      COMMON /PARALL/ ME, NODES
      COMMON /PACKET/ Y(3,MAXN), G(3,MAXN), NPACK, MPACK
      COMMON /NEWS/ YIN(3,MAXN), GIN(3,MAXN), NPIN, MPIN
      INTEGER ISEND, IRECV, INFOCOUNT
      LENGTH = 2*3*MAXN*8 + 8
      EPOT = 0D0
      DO 10 I = 1, NLOC
      DO 10 K = 1, 3
      F(K,I) = 0D0
      Y(K,I) = X(K,I)
   10 G(K,I) = 0D0
      NPACK = NLOC
      MPACK = ME
      CALL INNER(EPOT)
      NEXT = MOD(ME+1, NODES)
      DO 40 ISTEP = 1, NODES/2
         MID = IRECV(1000+ISTEP, YIN, LENGTH)
         MSID = ISEND(1000+ISTEP, Y, LENGTH, NEXT, 0)
         CALL MSGWAIT(MSID)
         CALL MSGWAIT(MID)
         IF (INFOCOUNT() .NE. LENGTH) STOP 'SHORT PACKET'
         CALL UNPACK
         IHALF = 0
         IF (2*ISTEP .EQ. NODES) IHALF = 1
         CALL OUTER(EPOT, IHALF)
   40 CONTINUE
      IF (NODES .GT. 1) THEN
         CALL CSEND(2000, Y, LENGTH, MPACK, 0)
         CALL CRECV(2000, YIN, LENGTH)
         DO 50 I = 1, NLOC
         DO 50 K = 1, 3
   50    F(K,I) = F(K,I) + GIN(K,I)
      ENDIF
      END
C
      SUBROUTINE UNPACK
      IMPLICIT DOUBLE PRECISION (A-H, O-Z)
      PARAMETER (MAXN = 256)
      COMMON /PACKET/ Y(3,MAXN), G(3,MAXN), NPACK, MPACK
      COMMON /NEWS/ YIN(3,MAXN), GIN(3,MAXN), NPIN, MPIN
      NPACK = NPIN
      MPACK = MPIN
      DO 10 I = 1, NPACK
      DO 10 K = 1, 3
      Y(K,I) = YIN(K,I)
   10 G(K,I) = GIN(K,I)
      END
C
C     Pairs within this node.
C
      SUBROUTINE INNER(EPOT)
      IMPLICIT DOUBLE PRECISION (A-H, O-Z)
      PARAMETER (MAXN = 256)
      COMMON /ATOMS/ X(3,MAXN), V(3,MAXN), F(3,MAXN), NLOC, NFIRST
      DIMENSION D(3)
      DO 30 I = 1, NLOC-1
      DO 20 J = I+1, NLOC
         CALL PAIR(X(1,I), X(1,J), D, E, *20)
         EPOT = EPOT + E
         DO 10 K = 1, 3
         F(K,I) = F(K,I) + D(K)
   10    F(K,J) = F(K,J) - D(K)
   20 CONTINUE
   30 CONTINUE
      END
C
C     This node's atoms with the packet's.
C
      SUBROUTINE OUTER(EPOT, IHALF)
      IMPLICIT DOUBLE PRECISION (A-H, O-Z)
      PARAMETER (MAXN = 256)
      COMMON /ATOMS/ X(3,MAXN), V(3,MAXN), F(3,MAXN), NLOC, NFIRST
      COMMON /PARALL/ ME, NODES
      COMMON /PACKET/ Y(3,MAXN), G(3,MAXN), NPACK, MPACK
      DIMENSION D(3)
      LOGICAL MINE
      DO 30 I = 1, NLOC
      DO 20 J = 1, NPACK
         MINE = MOD(I+J, 2) .EQ. 0 .EQV. ME .LT. MPACK
         IF (IHALF .EQ. 1 .AND. .NOT. MINE) GOTO 20
         CALL PAIR(X(1,I), Y(1,J), D, E, *20)
         EPOT = EPOT + E
         DO 10 K = 1, 3
         F(K,I) = F(K,I) + D(K)
   10    G(K,J) = G(K,J) - D(K)
   20 CONTINUE
   30 CONTINUE
      END
C
C     The force of atom b on atom a, and their energy; the alternate return when they are too far apart.
C
      SUBROUTINE PAIR(A, B, D, E, *)
      IMPLICIT DOUBLE PRECISION (A-H, O-Z)
      COMMON /CELL/ BOX, RCUT2
      DIMENSION A(3), B(3), D(3)
      R2 = 0D0
      DO 10 K = 1, 3
         D(K) = A(K) - B(K)
         D(K) = D(K) - BOX*ANINT(D(K)/BOX)
   10 R2 = R2 + D(K)*D(K)
      IF (R2 .GE. RCUT2) RETURN 1
      S2 = 1D0/R2
      S6 = S2*S2*S2
      E = 4D0*S6*(S6 - 1D0)
      FF = 48D0*S2*S6*(S6 - 0.5D0)
      DO 20 K = 1, 3
   20 D(K) = FF*D(K)
      END
