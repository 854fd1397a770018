C     Nanoseconds a call of DRC, DRF, DRD and DRJ, of whichever library
C     this is linked with: the least of 60 passes over 4000 arguments
C     between 0 and 1, in Legendre's form, and over 17 powers of ten.
      PROGRAM STIMES
      INTEGER N
      PARAMETER (N = 4000)
      DOUBLE PRECISION A(N,4,3), T(4), SUM, U, V, W
      CHARACTER*8 NAME(3)
      INTEGER I, J, K, L, IPASS
      DATA NAME /'0 to 1', 'Legendre', 'wide'/
      DO 20 I = 1, N
         U = MOD(0.6180339887498949D0*I, 1.0D0)
         V = MOD(0.7548776662466927D0*I, 1.0D0)
         W = MOD(0.5698402909980532D0*I, 1.0D0)
         A(I,1,1) = U
         A(I,2,1) = V
         A(I,3,1) = W
         A(I,4,1) = MOD(0.3247179572447461D0*I, 1.0D0)
         A(I,1,2) = COS(1.57D0*U)**2
         A(I,2,2) = 1.0D0 - V*SIN(1.57D0*U)**2
         A(I,3,2) = 1.0D0
         A(I,4,2) = 1.0D0 - W*SIN(1.57D0*U)**2
         DO 10 J = 1, 4
   10    A(I,J,3) = 10.0D0**(17.0D0*A(I,J,1) - 8.5D0)
   20 CONTINUE
      SUM = 0.0D0
      WRITE (*, *) 'ns a call     DRC     DRF     DRD     DRJ'
      DO 50 K = 1, 3
         DO 30 L = 1, 4
   30    T(L) = 1.0D9
         DO 40 IPASS = 1, 60
         DO 40 L = 1, 4
   40    CALL PASS(L, N, A(1,1,K), A(1,2,K), A(1,3,K), A(1,4,K),
     1      T(L), SUM)
   50 WRITE (*, '(1X, A8, 1X, 4F8.1)') NAME(K), T
      IF (.NOT. SUM .GT. 0.0D0) STOP 1
      END

      SUBROUTINE PASS(L, N, X, Y, Z, P, T, SUM)
      INTEGER L, N, I, IER
      DOUBLE PRECISION X(N), Y(N), Z(N), P(N), T, SUM, R
      DOUBLE PRECISION DRC, DRF, DRD, DRJ
      DOUBLE PRECISION T0, T1
      CALL CPU_TIME(T0)
      DO 60 I = 1, N
         GOTO (10, 20, 30, 40), L
   10    R = DRC(X(I), Y(I), IER)
         GOTO 60
   20    R = DRF(X(I), Y(I), Z(I), IER)
         GOTO 60
   30    R = DRD(X(I), Y(I), Z(I), IER)
         GOTO 60
   40    R = DRJ(X(I), Y(I), Z(I), P(I), IER)
   60 SUM = SUM + R
      CALL CPU_TIME(T1)
      T = MIN(T, (T1 - T0)*1.0D9/N)
      END
