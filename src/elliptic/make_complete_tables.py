#!/usr/bin/env python3
"""Writes complete_tables.inc: the real64 polynomials of the complete integrals K, E, D, B.

With x = 1 - m the complementary parameter:
* 1/16 <= x <= 1: every octave of x is cut into 8 equal parts; on each the function is a polynomial of degree 10 in
  x - centre, the interpolant at the Chebyshev nodes. The only singularity is x = 0, 17 half widths from the nearest
  centre, so the coefficients fall like (17 + sqrt(17**2 - 1))**-n = 34**-n.
* 0 < x < 1/16: value = start + slope L + x (P(x) + L Q(x)), L = -log(x), with the exact split
  K = P_K + L K'/pi, E = P_E + L (K'-E')/pi, D = (K-E)/m, B = K - D  (K' = K(x), E' = E(x); DLMF 19.12.1, Legendre's relation),
  P and Q interpolated at the Chebyshev nodes of [0, 1/16]; their nearest singularity is x = 1.
The script checks the truncation error of every polynomial. Needs mpmath.
"""
import sys
from mpmath import mp, mpf, ellipk, ellipe, log, pi, cos, matrix, lu_solve, polyval

mp.dps = 70
DEGREE, LOG_DEGREE, OCTAVES, PARTS = 10, 8, 4, 8
LIMIT = mpf(1)/16


def legendre(x):
    k, e = ellipk(1 - x), ellipe(1 - x)
    d = (k - e)/(1 - x)
    return dict(k=k, e=e, d=d, b=k - d)


def log_factor(x):
    k, e = ellipk(x), ellipe(x)
    q = dict(k=k/pi, e=(k - e)/pi, d=e/pi/(1 - x))
    q['b'] = q['k'] - q['d']
    return q


def nodes(a, b, n):
    return [(a + b)/2 + (b - a)/2*cos(pi*(2*i + 1)/(2*n)) for i in range(n)]


def interpolate(points, values, centre):
    n = len(points)
    a = matrix(n, n)
    for i, x in enumerate(points):
        for j in range(n):
            a[i, j] = (x - centre)**j
    return list(lu_solve(a, matrix(values)))


def value(coefficients, t):
    return polyval(coefficients[::-1], t)


START = dict(k=log(mpf(4)), e=mpf(1), d=log(mpf(4)) - 1, b=mpf(1))
SLOPE = dict(k=mpf(1)/2, e=mpf(0), d=mpf(1)/2, b=mpf(0))
worst = mpf(0)
tables = {f: [] for f in 'kedb'}
for octave in range(OCTAVES):
    low = LIMIT*2**octave
    for part in range(PARTS):
        a, b = low*(1 + mpf(part)/PARTS), low*(1 + mpf(part + 1)/PARTS)
        centre = (a + b)/2
        points = nodes(a, b, DEGREE + 1)
        values = [legendre(x) for x in points]
        checks = [a + (b - a)*(2*i + 1)/46 for i in range(23)]
        truth = [legendre(x) for x in checks]
        for f in 'kedb':
            c = interpolate(points, [v[f] for v in values], centre)
            tables[f].append([centre] + c)
            worst = max([worst] + [abs(value(c, x - centre)/t[f] - 1) for x, t in zip(checks, truth)])
logs = {}
print('worst relative truncation error, pieces:', mp.nstr(worst, 3), file=sys.stderr)
points = nodes(mpf(0), LIMIT, LOG_DEGREE + 1)
truths = [legendre(x) for x in points]
factors = [log_factor(x) for x in points]
for f in 'kedb':
    q = interpolate(points, [(t[f] - SLOPE[f])/x for x, t in zip(points, factors)], mpf(0))
    p = interpolate(points, [(v[f] + log(x)*t[f] - START[f])/x for x, v, t in zip(points, truths, factors)], mpf(0))
    logs[f] = (p, q)
    for i in range(200):
        x = LIMIT*mpf(2)**(-i/mpf(4))
        y = -log(x)
        ours = START[f] + SLOPE[f]*y + x*(value(p, x) + y*value(q, x))
        worst = max(worst, abs(ours/legendre(x)[f] - 1))
print('worst relative truncation error:', mp.nstr(worst, 3), file=sys.stderr)
assert worst < mpf(2)**-56, worst


def listed(values):
    words = [mp.nstr(v, 18, min_fixed=0, max_fixed=0) + '_wp' for v in values]
    return ', &\n      '.join(', '.join(words[i:i + 4]) for i in range(0, len(words), 4))


with open('complete_tables.inc', 'w') as out:
    out.write('   ! Written by make_complete_tables.py; the largest relative truncation error is '
              + mp.nstr(worst, 2) + '.\n')
    out.write(f'   integer, parameter :: degree = {DEGREE}, log_degree = {LOG_DEGREE}, parts = {OCTAVES*PARTS}\n')
    for f in 'kedb':
        for half in range(2):
            for rank in range(OCTAVES//2):
                name = f'{f}_{half}{rank}'
                rows = tables[f][(2*half + rank)*PARTS:(2*half + rank + 1)*PARTS]
                out.write(f'   real(wp), parameter :: {name}((degree + 2)*{PARTS}) = [ &\n      '
                          + ', &\n      '.join(listed(row) for row in rows) + ']\n')
        out.write(f'   real(wp), parameter :: table_{f}(-1:degree, 0:parts-1) = reshape( &\n'
                  f'      [{f}_00, {f}_01, {f}_10, {f}_11], [degree + 2, parts])\n')
    for f in 'kedb':
        out.write(f'   real(wp), parameter :: start_{f} = {mp.nstr(START[f], 20)}_wp, slope_{f} = {mp.nstr(SLOPE[f], 20)}_wp\n')
        out.write(f'   real(wp), parameter :: plain_{f}(0:log_degree) = [ &\n      {listed(logs[f][0])}]\n')
        out.write(f'   real(wp), parameter :: log_{f}(0:log_degree) = [ &\n      {listed(logs[f][1])}]\n')
