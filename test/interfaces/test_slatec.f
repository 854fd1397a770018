C     SLATEC's elliptic integrals, as a program of its time calls them.
C     Values: Carlson, Numer. Algorithms 10 (1995) 13, section 3, to the
C     14 digits printed there; PI and LOG(2) for DRC. Error numbers,
C     limits: the prologues of SLATEC 4.1.
      PROGRAM TSLATC
      DOUBLE PRECISION DRC, DRF, DRD, DRJ, R, XNAN, XLIM
      REAL RC, RF, RD, RJ, S, SLIM
      INTEGER IER, NFAIL
      CHARACTER*3 TEXT
      COMMON /COUNT/ NFAIL
      NFAIL = 0
      TEXT = 'NaN'
      READ (TEXT, '(F3.0)') XNAN
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
C     NaN is error 1 and gives NaN
      R = DRC(1.0D0, XNAN, IER)
      CALL NOTNUM('DRC', R, IER)
      R = DRF(XNAN, 1.0D0, 1.0D0, IER)
      CALL NOTNUM('DRF', R, IER)
      R = DRD(1.0D0, 1.0D0, XNAN, IER)
      CALL NOTNUM('DRD', R, IER)
      R = DRJ(1.0D0, 1.0D0, 1.0D0, XNAN, IER)
      CALL NOTNUM('DRJ', R, IER)
C     An argument that is negative where it must not be
      R = DRC(1.0D0, 0.0D0, IER)
      CALL ERROR('DRC', R, IER, 1)
      R = DRF(1.0D0, -1.0D0, 1.0D0, IER)
      CALL ERROR('DRF', R, IER, 1)
      R = DRF(0.0D0, 0.0D0, 1.0D0, IER)
      CALL ERROR('DRF', R, IER, 2)
      R = DRD(1.0D0, 1.0D0, 0.0D0, IER)
      CALL ERROR('DRD', R, IER, 2)
      R = DRJ(1.0D0, 1.0D0, 1.0D0, -1.0D0, IER)
      CALL ERROR('DRJ', R, IER, 2)
C     The limits, as SLATEC computes them: they are allowed, the numbers
C     next to them are not
      XLIM = 1.11253692925360069D-307
      R = DRC(0.0D0, XLIM, IER)
      CALL FINE('DRC', R, IER)
      XLIM = XLIM*(1.0D0 - 2.0D0**(-53))
      R = DRC(0.0D0, XLIM, IER)
      CALL ERROR('DRC', R, IER, 2)
      XLIM = 3.59538626972463152D+307
      R = DRC(XLIM, 1.0D0, IER)
      CALL FINE('DRC', R, IER)
      XLIM = XLIM/(1.0D0 - 2.0D0**(-53))
      R = DRC(XLIM, 1.0D0, IER)
      CALL ERROR('DRC', R, IER, 3)
      XLIM = 1.11253692925360069D-307
      R = DRF(0.0D0, XLIM, 1.0D0, IER)
      CALL FINE('DRF', R, IER)
      XLIM = XLIM*(1.0D0 - 2.0D0**(-53))
      R = DRF(0.0D0, XLIM, 1.0D0, IER)
      CALL ERROR('DRF', R, IER, 2)
      XLIM = 3.59538626972463152D+307
      R = DRF(1.0D0, 1.0D0, XLIM, IER)
      CALL FINE('DRF', R, IER)
      XLIM = XLIM/(1.0D0 - 2.0D0**(-53))
      R = DRF(1.0D0, 1.0D0, XLIM, IER)
      CALL ERROR('DRF', R, IER, 3)
      XLIM = 6.27893936364702926D-206
      R = DRD(1.0D0, 1.0D0, XLIM, IER)
      CALL FINE('DRD', R, IER)
      XLIM = XLIM*(1.0D0 - 2.0D0**(-53))
      R = DRD(1.0D0, 1.0D0, XLIM, IER)
      CALL ERROR('DRD', R, IER, 2)
      XLIM = 4.06784204816647115D+202
      R = DRD(XLIM, 1.0D0, 1.0D0, IER)
      CALL FINE('DRD', R, IER)
      XLIM = XLIM/(1.0D0 - 2.0D0**(-53))
      R = DRD(XLIM, 1.0D0, 1.0D0, IER)
      CALL ERROR('DRD', R, IER, 3)
      XLIM = 4.80955407431174137D-103
      R = DRJ(1.0D0, 1.0D0, 1.0D0, XLIM, IER)
      CALL FINE('DRJ', R, IER)
      XLIM = XLIM*(1.0D0 - 2.0D0**(-53))
      R = DRJ(1.0D0, 1.0D0, 1.0D0, XLIM, IER)
      CALL ERROR('DRJ', R, IER, 2)
      XLIM = 9.90154821491653725D+101
      R = DRJ(1.0D0, 1.0D0, 1.0D0, XLIM, IER)
      CALL FINE('DRJ', R, IER)
      XLIM = XLIM/(1.0D0 - 2.0D0**(-53))
      R = DRJ(1.0D0, 1.0D0, 1.0D0, XLIM, IER)
      CALL ERROR('DRJ', R, IER, 3)
      SLIM = 5.87747175E-38
      S = RC(0.0E0, SLIM, IER)
      CALL FINE('RC', DBLE(S), IER)
      SLIM = SLIM*(1.0E0 - 2.0E0**(-24))
      S = RC(0.0E0, SLIM, IER)
      CALL ERROR('RC', DBLE(S), IER, 2)
      SLIM = 6.80564693E+37
      S = RC(SLIM, 1.0E0, IER)
      CALL FINE('RC', DBLE(S), IER)
      SLIM = SLIM/(1.0E0 - 2.0E0**(-24))
      S = RC(SLIM, 1.0E0, IER)
      CALL ERROR('RC', DBLE(S), IER, 3)
      SLIM = 5.87747175E-38
      S = RF(0.0E0, SLIM, 1.0E0, IER)
      CALL FINE('RF', DBLE(S), IER)
      SLIM = SLIM*(1.0E0 - 2.0E0**(-24))
      S = RF(0.0E0, SLIM, 1.0E0, IER)
      CALL ERROR('RF', DBLE(S), IER, 2)
      SLIM = 6.80564693E+37
      S = RF(1.0E0, 1.0E0, SLIM, IER)
      CALL FINE('RF', DBLE(S), IER)
      SLIM = SLIM/(1.0E0 - 2.0E0**(-24))
      S = RF(1.0E0, 1.0E0, SLIM, IER)
      CALL ERROR('RF', DBLE(S), IER, 3)
      SLIM = 4.10332841E-26
      S = RD(1.0E0, 1.0E0, SLIM, IER)
      CALL FINE('RD', DBLE(S), IER)
      SLIM = SLIM*(1.0E0 - 2.0E0**(-24))
      S = RD(1.0E0, 1.0E0, SLIM, IER)
      CALL ERROR('RD', DBLE(S), IER, 2)
      SLIM = 5.80889484E+23
      S = RD(SLIM, 1.0E0, 1.0E0, IER)
      CALL FINE('RD', DBLE(S), IER)
      SLIM = SLIM/(1.0E0 - 2.0E0**(-24))
      S = RD(SLIM, 1.0E0, 1.0E0, IER)
      CALL ERROR('RD', DBLE(S), IER, 3)
      SLIM = 3.88803193E-13
      S = RJ(1.0E0, 1.0E0, 1.0E0, SLIM, IER)
      CALL FINE('RJ', DBLE(S), IER)
      SLIM = SLIM*(1.0E0 - 2.0E0**(-24))
      S = RJ(1.0E0, 1.0E0, 1.0E0, SLIM, IER)
      CALL ERROR('RJ', DBLE(S), IER, 2)
      SLIM = 1.22483651E+12
      S = RJ(1.0E0, 1.0E0, 1.0E0, SLIM, IER)
      CALL FINE('RJ', DBLE(S), IER)
      SLIM = SLIM/(1.0E0 - 2.0E0**(-24))
      S = RJ(1.0E0, 1.0E0, 1.0E0, SLIM, IER)
      CALL ERROR('RJ', DBLE(S), IER, 3)
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
      IF (IER .EQ. KIND .AND. GOT .EQ. 0.0D0) RETURN
      WRITE (*, *) 'FAIL ', NAME, ' IER', IER, KIND, GOT
      NFAIL = NFAIL + 1
      END

      SUBROUTINE NOTNUM(NAME, GOT, IER)
      CHARACTER*(*) NAME
      DOUBLE PRECISION GOT
      INTEGER IER, NFAIL
      COMMON /COUNT/ NFAIL
      IF (IER .EQ. 1 .AND. GOT .NE. GOT) RETURN
      WRITE (*, *) 'FAIL ', NAME, ' IER', IER, GOT
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
