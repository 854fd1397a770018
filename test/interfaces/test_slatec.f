C     SLATEC's elliptic integrals, as a program of its time calls them.
C     Values: Carlson, Numer. Algorithms 10 (1995) 13, section 3, to the
C     14 digits printed there; PI and LOG(2) for DRC. Error numbers: the
C     prologues of SLATEC 4.1.
      PROGRAM TSLATC
      DOUBLE PRECISION DRC, DRF, DRD, DRJ, R, ZERO, XNAN
      INTEGER IER, NFAIL
      COMMON /COUNT/ NFAIL
      NFAIL = 0
      ZERO = 0.0D0
      XNAN = ZERO/ZERO
      R = DRC(0.0D0, 0.25D0, IER)
      CALL VALUE('DRC 1', R, IER, 3.14159265358979D0)
      R = DRC(2.25D0, 2.0D0, IER)
      CALL VALUE('DRC 2', R, IER, 0.693147180559945D0)
      R = DRF(1.0D0, 2.0D0, 0.0D0, IER)
      CALL VALUE('DRF 1', R, IER, 1.3110287771461D0)
      R = DRF(2.0D0, 3.0D0, 4.0D0, IER)
      CALL VALUE('DRF 2', R, IER, 0.58408284167715D0)
      R = DRD(0.0D0, 2.0D0, 1.0D0, IER)
      CALL VALUE('DRD 1', R, IER, 1.7972103521034D0)
      R = DRD(2.0D0, 3.0D0, 4.0D0, IER)
      CALL VALUE('DRD 2', R, IER, 0.16510527294261D0)
      R = DRJ(0.0D0, 1.0D0, 2.0D0, 3.0D0, IER)
      CALL VALUE('DRJ 1', R, IER, 0.77688623778582D0)
      R = DRJ(2.0D0, 3.0D0, 4.0D0, 5.0D0, IER)
      CALL VALUE('DRJ 2', R, IER, 0.14297579667157D0)
C     Every error number of every function, at both sides of a limit
      R = DRC(-1.0D0, 1.0D0, IER)
      CALL ERROR('DRC', R, IER, 1)
      R = DRC(1.0D0, 0.0D0, IER)
      CALL ERROR('DRC', R, IER, 1)
      R = DRC(1.0D0, XNAN, IER)
      CALL ERROR('DRC', R, IER, 1)
      R = DRC(0.0D0, 1.1D-307, IER)
      CALL ERROR('DRC', R, IER, 2)
      R = DRC(0.0D0, 1.2D-307, IER)
      CALL FINE('DRC', R, IER)
      R = DRC(3.6D307, 1.0D0, IER)
      CALL ERROR('DRC', R, IER, 3)
      R = DRC(3.5D307, 1.0D0, IER)
      CALL FINE('DRC', R, IER)
      R = DRF(1.0D0, -1.0D0, 1.0D0, IER)
      CALL ERROR('DRF', R, IER, 1)
      R = DRF(XNAN, 1.0D0, 1.0D0, IER)
      CALL ERROR('DRF', R, IER, 1)
      R = DRF(0.0D0, 1.1D-307, 1.0D0, IER)
      CALL ERROR('DRF', R, IER, 2)
      R = DRF(0.0D0, 0.0D0, 1.0D0, IER)
      CALL ERROR('DRF', R, IER, 2)
      R = DRF(0.0D0, 1.2D-307, 1.0D0, IER)
      CALL FINE('DRF', R, IER)
      R = DRF(1.0D0, 1.0D0, 3.6D307, IER)
      CALL ERROR('DRF', R, IER, 3)
      R = DRF(1.0D0, 1.0D0, 3.5D307, IER)
      CALL FINE('DRF', R, IER)
      R = DRD(-1.0D0, 1.0D0, 1.0D0, IER)
      CALL ERROR('DRD', R, IER, 1)
      R = DRD(1.0D0, 1.0D0, XNAN, IER)
      CALL ERROR('DRD', R, IER, 1)
      R = DRD(1.0D0, 1.0D0, 0.0D0, IER)
      CALL ERROR('DRD', R, IER, 2)
      R = DRD(1.0D0, 1.0D0, 6.2D-206, IER)
      CALL ERROR('DRD', R, IER, 2)
      R = DRD(1.0D0, 1.0D0, 6.4D-206, IER)
      CALL FINE('DRD', R, IER)
      R = DRD(4.1D202, 1.0D0, 1.0D0, IER)
      CALL ERROR('DRD', R, IER, 3)
      R = DRD(4.0D202, 1.0D0, 1.0D0, IER)
      CALL FINE('DRD', R, IER)
      R = DRJ(1.0D0, 1.0D0, -1.0D0, 1.0D0, IER)
      CALL ERROR('DRJ', R, IER, 1)
      R = DRJ(1.0D0, 1.0D0, 1.0D0, XNAN, IER)
      CALL ERROR('DRJ', R, IER, 1)
      R = DRJ(1.0D0, 1.0D0, 1.0D0, -1.0D0, IER)
      CALL ERROR('DRJ', R, IER, 2)
      R = DRJ(1.0D0, 1.0D0, 1.0D0, 4.7D-103, IER)
      CALL ERROR('DRJ', R, IER, 2)
      R = DRJ(1.0D0, 1.0D0, 1.0D0, 4.9D-103, IER)
      CALL FINE('DRJ', R, IER)
      R = DRJ(1.0D0, 1.0D0, 1.0D0, 1.0D102, IER)
      CALL ERROR('DRJ', R, IER, 3)
      R = DRJ(1.0D0, 1.0D0, 1.0D0, 9.8D101, IER)
      CALL FINE('DRJ', R, IER)
      IF (NFAIL .NE. 0) STOP 1
      WRITE (*, *) 'all as SLATEC documents'
      END

C     Half a unit of the 14th digit is what the table leaves open.
      SUBROUTINE VALUE(NAME, GOT, IER, WANT)
      CHARACTER*(*) NAME
      DOUBLE PRECISION GOT, WANT
      INTEGER IER, NFAIL
      COMMON /COUNT/ NFAIL
      IF (IER .EQ. 0 .AND. ABS(GOT - WANT) .LE. 6.0D-14*WANT) RETURN
      WRITE (*, *) 'FAIL ', NAME, IER, GOT, WANT
      NFAIL = NFAIL + 1
      END

      SUBROUTINE ERROR(NAME, GOT, IER, KIND)
      CHARACTER*(*) NAME
      DOUBLE PRECISION GOT
      INTEGER IER, KIND, NFAIL
      COMMON /COUNT/ NFAIL
      IF (IER .EQ. KIND .AND. GOT .NE. GOT) RETURN
      WRITE (*, *) 'FAIL ', NAME, ' IER', IER, KIND, GOT
      NFAIL = NFAIL + 1
      END

      SUBROUTINE FINE(NAME, GOT, IER)
      CHARACTER*(*) NAME
      DOUBLE PRECISION GOT
      INTEGER IER, NFAIL
      COMMON /COUNT/ NFAIL
      IF (IER .EQ. 0 .AND. GOT .GT. 0.0D0) RETURN
      WRITE (*, *) 'FAIL ', NAME, ' IER', IER, GOT
      NFAIL = NFAIL + 1
      END
