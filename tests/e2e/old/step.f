      SUBROUTINE STEP(T, NEW, N, C)
      INTEGER N
      REAL*8 T(0:N+1), NEW(0:N+1), C
      LOGICAL FIRST, DONE
      DATA FIRST /.TRUE./
      DONE = .FALSE.
C     compared as if77 let one
      IF (FIRST .NE. DONE) FIRST = .FALSE.
      DO 10 I = 1, N
        NEW(I) = T(I) + C * (T(I-1) - 2 * T(I) + T(I+1))                                       ! beyond column 72
10    CONTINUE
      CALL DCOPY(N, NEW(1), 1, T(1), 1)
      END
