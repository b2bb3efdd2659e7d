C     f77_server.f - a data server, as message-passing layers built on NX have them: each node owns a part of a shared array;
C     a handler answers requests to fetch and to add while its node computes, and posts itself again. masktrap keeps it out
C     of sections that touch the same data.
C run: -m ipsc860 -n 2
C run: -m delta -n 6
C run: -m paragon -n 8
      PROGRAM SERVER
      INTEGER MINE, NODES, ME
      PARAMETER (MINE = 8)
      DOUBLE PRECISION A(MINE)
      INTEGER IREQ(4), IBUSY, NCLASH, NSERVD
      COMMON /SHARED/ A
      COMMON /SERVE/ IREQ, IBUSY, NCLASH, NSERVD, ME, NODES
      INTEGER I, J, K, IOLD, IW(3)
      DOUBLE PRECISION X, SUM, W, FETCH
      EXTERNAL REQUES
      INTEGER MYNODE, NUMNODES, MASKTRAP
      ME = MYNODE()
      NODES = NUMNODES()
      IBUSY = 0
      NCLASH = 0
      NSERVD = 0
      DO 10 I = 1, MINE
   10 A(I) = 100*ME + I
      CALL HRECV(500, IREQ, 16, REQUES)
      CALL GSYNC
C     every node adds 1 to every element, and changes its own by hand now and then
      DO 30 J = 0, NODES-1
         DO 30 I = 1, MINE
            CALL ADD(MOD(ME+J, NODES), I, 1)
            IOLD = MASKTRAP(1)
            IBUSY = 1
            X = A(I)
            CALL WORK(200)
            A(I) = X
            IBUSY = 0
            K = MASKTRAP(IOLD)
            IF (K .NE. 1 .OR. IOLD .NE. 0) NCLASH = NCLASH + 1
   30 CONTINUE
      CALL GSYNC
C     whoever has been told "added" by all has added
      SUM = 0
      DO 40 J = 0, NODES-1
      DO 40 I = 1, MINE
   40 SUM = SUM + FETCH(J, I)
      CALL GSYNC
      W = 0
      DO 50 J = 0, NODES-1
      DO 50 I = 1, MINE
   50 W = W + 100*J + I + NODES
      IW(1) = 0
      IF (SUM .NE. W) IW(1) = 1
      IW(2) = NCLASH
      IW(3) = NSERVD - 2*MINE*(NODES-1)
      CALL GISUM(IW, 3, IREQ)
      IF (ME .EQ. 0) PRINT '(3(A, I4))', 'wrong sums', IW(1),
     1   '  clashes', IW(2), '  requests missed', IW(3)
      END
C
      SUBROUTINE ADD(NODE, I, INC)
      INTEGER NODE, I, INC, IREQ(4), IOK
      CALL ASK(NODE, 1, I, INC, IOK, 4)
      END
C
      DOUBLE PRECISION FUNCTION FETCH(NODE, I)
      INTEGER NODE, I
      DOUBLE PRECISION X
      CALL ASK(NODE, 2, I, 0, X, 8)
      FETCH = X
      END
C
C     What is asked of one's own server is done at once.
C
      SUBROUTINE ASK(NODE, IWHAT, I, INC, ANSWER, LENGTH)
      INTEGER NODE, IWHAT, I, INC, LENGTH, M(4), IOLD, MASKTRAP, IRECV
      DOUBLE PRECISION A(8)
      REAL ANSWER(*)
      COMMON /SHARED/ A
      INTEGER IREQ(4), IBUSY, NCLASH, NSERVD, ME, NODES
      COMMON /SERVE/ IREQ, IBUSY, NCLASH, NSERVD, ME, NODES
      IF (NODE .EQ. ME) THEN
         IOLD = MASKTRAP(1)
         IF (IWHAT .EQ. 1) A(I) = A(I) + INC
         IF (IWHAT .EQ. 2) CALL COPY(A(I), ANSWER)
         IOLD = MASKTRAP(IOLD)
      ELSE
         M(1) = IWHAT
         M(2) = I
         M(3) = INC
         M(4) = ME
         ID = IRECV(600, ANSWER, LENGTH)
         CALL CSEND(500, M, 16, NODE, 0)
         CALL MSGWAIT(ID)
      ENDIF
      END
C
      SUBROUTINE COPY(X, Y)
      DOUBLE PRECISION X, Y
      Y = X
      END
C
      SUBROUTINE WORK(N)
      INTEGER N, I
      REAL S
      COMMON /NOWHER/ S
      DO 10 I = 1, N
   10 S = S + 1.0/I
      END
C
C     The handler. Its arguments tell who asks.
C
      SUBROUTINE REQUES(ITYPE, ICOUNT, INODE, IPID)
      INTEGER ITYPE, ICOUNT, INODE, IPID
      DOUBLE PRECISION A(8)
      COMMON /SHARED/ A
      INTEGER IREQ(4), IBUSY, NCLASH, NSERVD, ME, NODES
      COMMON /SERVE/ IREQ, IBUSY, NCLASH, NSERVD, ME, NODES
      IF (IBUSY .NE. 0 .OR. ITYPE .NE. 500 .OR. ICOUNT .NE. 16 .OR.
     1   INODE .NE. IREQ(4) .OR. IPID .NE. 0) NCLASH = NCLASH + 1
      NSERVD = NSERVD + 1
      IF (IREQ(1) .EQ. 1) THEN
         A(IREQ(2)) = A(IREQ(2)) + IREQ(3)
         CALL CSEND(600, IREQ(1), 4, INODE, 0)
      ELSE
         CALL CSEND(600, A(IREQ(2)), 8, INODE, 0)
      ENDIF
      CALL HRECV(500, IREQ, 16, REQUES)
      END
