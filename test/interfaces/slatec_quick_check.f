C     What SLATEC's quick checks do with DRC, DRF, DRD, DRJ, RC, RF, RD
C     and RJ, written from the prologues of these and of XERMSG, NUMXER
C     and XERCLR: each error is forced, and its number must have come to
C     NUMXER; then a value is compared. The handler is a stand-in at the
C     end of this file, which counts and prints nothing.
      PROGRAM SQUICK
      DOUBLE PRECISION DRC, DRF, DRD, DRJ, D, TINYD, HUGED
      REAL RC, RF, RD, RJ, S, TINYS, HUGES
      INTEGER IER, NFAIL
      COMMON /COUNT/ NFAIL
      NFAIL = 0
      TINYD = 2.0D0**(-1022)
      HUGED = (2.0D0 - 2.0D0**(-52))*2.0D0**1023
      TINYS = 2.0E0**(-126)
      HUGES = (2.0E0 - 2.0E0**(-23))*2.0E0**127
C     Error 1, 2 and 3 of each
      D = DRC(-1.0D0, -1.0D0, IER)
      CALL FORCED('DRC', D, IER, 1, 'X.LT.0 .OR. Y.LE.0 WHERE X = ')
      D = DRC(TINYD, TINYD, IER)
      CALL FORCED('DRC', D, IER, 2, 'X+Y.LT.LOLIM WHERE X = ')
      D = DRC(HUGED, HUGED, IER)
      CALL FORCED('DRC', D, IER, 3, 'MAX(X,Y).GT.UPLIM WHERE X = ')
      D = DRF(-1.0D0, -1.0D0, -1.0D0, IER)
      CALL FORCED('DRF', D, IER, 1, 'MIN(X,Y,Z).LT.0 WHERE X = ')
      D = DRF(TINYD, TINYD, TINYD, IER)
      CALL FORCED('DRF', D, IER, 2, 'MIN(X+Y,X+Z,Y+Z).LT.LOLIM WHERE')
      D = DRF(HUGED, HUGED, HUGED, IER)
      CALL FORCED('DRF', D, IER, 3, 'MAX(X,Y,Z).GT.UPLIM WHERE X = ')
      D = DRD(-1.0D0, -1.0D0, -1.0D0, IER)
      CALL FORCED('DRD', D, IER, 1, 'MIN(X,Y).LT.0 WHERE X = ')
      D = DRD(1.0D0, 1.0D0, -1.0D0, IER)
      CALL FORCED('DRD', D, IER, 2, 'MIN(X+Y,Z).LT.LOLIM WHERE X = ')
      D = DRD(HUGED, HUGED, HUGED, IER)
      CALL FORCED('DRD', D, IER, 3, 'MAX(X,Y,Z).GT.UPLIM WHERE X = ')
      D = DRJ(-1.0D0, -1.0D0, -1.0D0, -1.0D0, IER)
      CALL FORCED('DRJ', D, IER, 1, 'MIN(X,Y,Z).LT.0 WHERE X = ')
      D = DRJ(TINYD, TINYD, TINYD, TINYD, IER)
      CALL FORCED('DRJ', D, IER, 2, 'MIN(X+Y,X+Z,Y+Z,P).LT.LOLIM')
      D = DRJ(HUGED, HUGED, HUGED, HUGED, IER)
      CALL FORCED('DRJ', D, IER, 3, 'MAX(X,Y,Z,P).GT.UPLIM WHERE X')
      S = RC(-1.0E0, -1.0E0, IER)
      CALL FORCED('RC', DBLE(S), IER, 1, 'X.LT.0 .OR. Y.LE.0 WHERE')
      S = RC(TINYS, TINYS, IER)
      CALL FORCED('RC', DBLE(S), IER, 2, 'X+Y.LT.LOLIM WHERE X = ')
      S = RC(HUGES, HUGES, IER)
      CALL FORCED('RC', DBLE(S), IER, 3, 'MAX(X,Y).GT.UPLIM WHERE')
      S = RF(-1.0E0, -1.0E0, -1.0E0, IER)
      CALL FORCED('RF', DBLE(S), IER, 1, 'MIN(X,Y,Z).LT.0 WHERE X = ')
      S = RF(TINYS, TINYS, TINYS, IER)
      CALL FORCED('RF', DBLE(S), IER, 2, 'MIN(X+Y,X+Z,Y+Z).LT.LOLIM')
      S = RF(HUGES, HUGES, HUGES, IER)
      CALL FORCED('RF', DBLE(S), IER, 3, 'MAX(X,Y,Z).GT.UPLIM WHERE')
      S = RD(-1.0E0, -1.0E0, -1.0E0, IER)
      CALL FORCED('RD', DBLE(S), IER, 1, 'MIN(X,Y).LT.0 WHERE X = ')
      S = RD(1.0E0, 1.0E0, -1.0E0, IER)
      CALL FORCED('RD', DBLE(S), IER, 2, 'MIN(X+Y,Z).LT.LOLIM WHERE')
      S = RD(HUGES, HUGES, HUGES, IER)
      CALL FORCED('RD', DBLE(S), IER, 3, 'MAX(X,Y,Z).GT.UPLIM WHERE')
      S = RJ(-1.0E0, -1.0E0, -1.0E0, -1.0E0, IER)
      CALL FORCED('RJ', DBLE(S), IER, 1, 'MIN(X,Y,Z).LT.0 WHERE X = ')
      S = RJ(TINYS, TINYS, TINYS, TINYS, IER)
      CALL FORCED('RJ', DBLE(S), IER, 2, 'MIN(X+Y,X+Z,Y+Z,P).LT.LOLIM')
      S = RJ(HUGES, HUGES, HUGES, HUGES, IER)
      CALL FORCED('RJ', DBLE(S), IER, 3, 'MAX(X,Y,Z,P).GT.UPLIM WHERE')
C     The numbers in the message, once to the letter
      D = DRJ(-1.0D0, 2.0D0, 3.0D-300, 4.0D0, IER)
      CALL FORCED('DRJ', D, IER, 1, 'MIN(X,Y,Z).LT.0 WHERE X =   -1.0000
     100E+00  Y =    2.000000E+00  AND Z =    3.000000-300 ')
C     Values call no handler: pi/4, twice the lemniscate constants A and
C     B, and mpmath's elliprj at 50 digits for RJ(2, 3, 4, 5)
      D = DRC(0.0D0, 4.0D0, IER)
      CALL INRANG('DRC', D, IER, 0.78539816339744831D0, 1.0D-15)
      D = DRF(0.0D0, 1.0D0, 2.0D0, IER)
      CALL INRANG('DRF', D, IER, 1.3110287771460599D0, 1.0D-15)
      D = DRD(0.0D0, 2.0D0, 1.0D0, IER)
      CALL INRANG('DRD', D, IER, 1.7972103521033883D0, 1.0D-15)
      D = DRJ(2.0D0, 3.0D0, 4.0D0, 5.0D0, IER)
      CALL INRANG('DRJ', D, IER, 0.14297579667156754D0, 1.0D-15)
      S = RC(0.0E0, 4.0E0, IER)
      CALL INRANG('RC', DBLE(S), IER, 0.78539816339744831D0, 2.4D-7)
      S = RF(0.0E0, 1.0E0, 2.0E0, IER)
      CALL INRANG('RF', DBLE(S), IER, 1.3110287771460599D0, 2.4D-7)
      S = RD(0.0E0, 2.0E0, 1.0E0, IER)
      CALL INRANG('RD', DBLE(S), IER, 1.7972103521033883D0, 2.4D-7)
      S = RJ(2.0E0, 3.0E0, 4.0E0, 5.0E0, IER)
      CALL INRANG('RJ', DBLE(S), IER, 0.14297579667156754D0, 2.4D-7)
      IF (NFAIL .NE. 0) STOP 1
      WRITE (*, *) 'every error counted, every value right'
      END

C     One error has come: IER, NUMXER, the count, the arguments, 0.
      SUBROUTINE FORCED(NAME, GOT, IER, KIND, START)
      CHARACTER*(*) NAME, START
      DOUBLE PRECISION GOT
      INTEGER IER, KIND, NFAIL, NUMXER, NERR, LAST, NCALLS, LEVEL
      CHARACTER LIBRAR*8, SUBROU*8, MESSG*200
      COMMON /COUNT/ NFAIL
      COMMON /HANDLE/ LAST, NCALLS, LEVEL
      COMMON /HANDLC/ LIBRAR, SUBROU, MESSG
      IF (IER .NE. KIND .OR. NUMXER(NERR) .NE. KIND .OR.
     1    NCALLS .NE. 1 .OR. LEVEL .NE. 1 .OR. LIBRAR .NE. 'SLATEC'
     2    .OR. SUBROU .NE. NAME .OR. GOT .NE. 0.0D0 .OR.
     3    INDEX(MESSG, START) .NE. 1) THEN
         WRITE (*, *) 'FAIL ', NAME, KIND, IER, LAST, NCALLS, GOT,
     1      LIBRAR, SUBROU, MESSG
         NFAIL = NFAIL + 1
      ENDIF
      CALL XERCLR
      END

      SUBROUTINE INRANG(NAME, GOT, IER, WANT, TOL)
      CHARACTER*(*) NAME
      DOUBLE PRECISION GOT, WANT, TOL
      INTEGER IER, NFAIL, LAST, NCALLS, LEVEL
      COMMON /COUNT/ NFAIL
      COMMON /HANDLE/ LAST, NCALLS, LEVEL
      IF (IER .EQ. 0 .AND. NCALLS .EQ. 0 .AND.
     1    ABS(GOT - WANT) .LE. TOL*WANT) RETURN
      WRITE (*, *) 'FAIL ', NAME, IER, NCALLS, GOT, WANT
      NFAIL = NFAIL + 1
      END

C     The handler: what was said last, and how often since XERCLR.
      SUBROUTINE XERMSG(LIBRAR, SUBROU, MESSG, NERR, LEVEL)
      CHARACTER*(*) LIBRAR, SUBROU, MESSG
      INTEGER NERR, LEVEL, LAST, NCALLS, LEV
      CHARACTER LIB*8, SUB*8, MES*200
      COMMON /HANDLE/ LAST, NCALLS, LEV
      COMMON /HANDLC/ LIB, SUB, MES
      LIB = LIBRAR
      SUB = SUBROU
      MES = MESSG
      LAST = NERR
      LEV = LEVEL
      NCALLS = NCALLS + 1
      END

      INTEGER FUNCTION NUMXER(NERR)
      INTEGER NERR, LAST, NCALLS, LEV
      COMMON /HANDLE/ LAST, NCALLS, LEV
      NERR = LAST
      NUMXER = LAST
      END

      SUBROUTINE XERCLR
      INTEGER LAST, NCALLS, LEV
      COMMON /HANDLE/ LAST, NCALLS, LEV
      LAST = 0
      NCALLS = 0
      END

      BLOCK DATA
      INTEGER LAST, NCALLS, LEV
      COMMON /HANDLE/ LAST, NCALLS, LEV
      DATA LAST, NCALLS, LEV /0, 0, 0/
      END
