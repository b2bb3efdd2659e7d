C     CHAIN - beads on springs. All arrays are in one common block or, when they do not fit, in memory that GETMEM finds, as
C     offsets from it.
      PROGRAM CHAIN
      INCLUDE 'fcube.h'
      INTEGER IX, IV, IF, N, I, ISTEP
      REAL*8 HEAP(1), ENERGY, WORK
      COMMON /STORE/ HEAP
D     PRINT *, 'for debugging'
      N = 64 / NUMNODES()
      CALL GETMEM(HEAP, N + 2, IX)
      CALL GETMEM(HEAP, N, IV)
      CALL GETMEM(HEAP, N, IF)
      CALL START(N, HEAP(IX), HEAP(IV))
      DO 10 ISTEP = 1, 100
        CALL SHIFT(N, HEAP(IX))
        CALL FORCES(N, HEAP(IX), HEAP(IF))
        CALL MOVE(N, HEAP(IX), HEAP(IV), HEAP(IF))
   10 CONTINUE
      ENERGY = 0
      DO 20 I = 0, N - 1
   20   ENERGY = ENERGY + 0.5D0 * HEAP(IV + I)**2
      CALL GDSUM(ENERGY, 1, WORK)
      IF (MYNODE() .EQ. 0) WRITE (6, 100) ENERGY
  100 FORMAT ('chain: energy of motion', F10.6)
      END

      SUBROUTINE START(N, X, V)
      REAL*8 X(0:N+1), V(N)
      DO 10 I = 1, N
        V(I) = 0
   10   X(I) = 0
      IF (MYNODE() .EQ. 0) X(1) = 1
      END

C     The neighbours' beads. The ends of the chain are fixed.
      SUBROUTINE SHIFT(N, X)
      REAL*8 X(0:N+1)
      ME = MYNODE()
      X(0) = 0
      X(N+1) = 0
      IF (ME .LT. NUMNODES() - 1) CALL CSEND(1, X(N), 8, ME + 1, 0)
      IF (ME .GT. 0) CALL CSEND(2, X(1), 8, ME - 1, 0)
      IF (ME .GT. 0) CALL CRECV(1, X(0), 8)
      IF (ME .LT. NUMNODES() - 1) CALL CRECV(2, X(N+1), 8)
      END

      SUBROUTINE FORCES(N, X, F)
      REAL*8 X(0:N+1), F(N)
      DO 10 I = 1, N
   10   F(I) = X(I-1) - 2 * X(I) + X(I+1)
      END

      SUBROUTINE MOVE(N, X, V, F)
      REAL*8 X(0:N+1), V(N), F(N), DT
      PARAMETER (DT = 0.1D0)
      DO 10 I = 1, N
        V(I) = V(I) + DT * F(I)
   10   X(I) = X(I) + DT * V(I)
      END
