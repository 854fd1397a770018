"""Writes eval_answers.txt: a request of every name of `kyvadlo eval`, and its results by mpmath at 40 digits.

The orbit's numbers come from the differential equation: T and phi by quadrature of (5) and (17), the place by a Taylor
series of Newton's equations.
"""
import os
import sys

from mpmath import (mp, mpf, quad, sqrt, pi, ellipk, ellipe, ellipf, ellippi, ellipfun, elliprc, elliprf, elliprd,
                    elliprj, elliprg, jtheta, asin, exp, odefun, findroot, atan2)

mp.dps = 40
h = mpf(1)/2
rows = []


def row(request, *results):
    rows.append(request + ' = ' + ' '.join(mp.nstr(mpf(r), 17, min_fixed=1, max_fixed=0) for r in results))


def incomplete_d(phi, m):
    return (ellipf(phi, m) - ellipe(phi, m))/m


def nome(m):
    return exp(-pi*ellipk(1 - m)/ellipk(m))


q4 = mpf(1)/4
row('rc 1 2', elliprc(1, 2))
row('rf 1 2 3', elliprf(1, 2, 3))
row('rd 1 2 3', elliprd(1, 2, 3))
row('rj 1 2 3 4', elliprj(1, 2, 3, 4))
row('rg 1 2 3', elliprg(1, 2, 3))
r = mpf(1)/4
el1 = elliprf(r, r + q4, r + 1)
row('cel 0.5 2 1 3', elliprf(0, q4, 1) + elliprj(0, q4, 1, 2)/3)
row('el1 2 0.5', el1)
row('el2 2 0.5 1 3', el1 + 2*elliprd(r, r + q4, r + 1)/3)
row('el3 2 0.5 3', el1 - 2*elliprj(r, r + q4, r + 1, r + 3)/3)
for c, m in (('', q4), ('c', 1 - q4)):
    row('K%s 0.25' % c, ellipk(m))
    row('E%s 0.25' % c, ellipe(m))
    row('D%s 0.25' % c, (ellipk(m) - ellipe(m))/m)
    row('B%s 0.25' % c, ellipk(m) - (ellipk(m) - ellipe(m))/m)
    row('Pi%s 0.5 0.25' % c, ellippi(h, m))
    row('F%s 1.5 0.25' % c, ellipf(mpf('1.5'), m))
    row('Einc%s 1.5 0.25' % c, ellipe(mpf('1.5'), m))
    row('Dinc%s 1.5 0.25' % c, incomplete_d(mpf('1.5'), m))
    row('Binc%s 1.5 0.25' % c, ellipf(mpf('1.5'), m) - incomplete_d(mpf('1.5'), m))
    row('Piinc%s 0.5 1.5 0.25' % c, ellippi(h, mpf('1.5'), m))
    row('nome%s 0.25' % c, nome(m))
    sn, cn, dn = (ellipfun(f, mpf(1), m=m) for f in ('sn', 'cn', 'dn'))
    row('jacobi%s 1 0.25' % c, sn, cn, dn, asin(sn))
    row('zeta%s 1 0.25' % c, ellipe(asin(sn), m) - ellipe(m)/ellipk(m))
    # DLMF 19.2.9 and 19.2.10: Heuman's lambda by Legendre's integrals
    phi = mpf(1)
    row('heuman%s 1 0.25' % c, 2/pi*(ellipk(m)*ellipe(phi, 1 - m) - (ellipk(m) - ellipe(m))*ellipf(phi, 1 - m)))
row('theta 2 0.75 0.25', jtheta(2, mpf('0.75'), q4))
row('cubic 1 0 -7 6', 3, -3, 1, 2)

length, gravity, z1, z2 = mpf(1), mpf(2), q4, -3*q4
z3 = -(z1*z2 + length**2)/(z1 + z2)
c1 = gravity*(z1 + z2 + z3)
c2 = sqrt(-2*gravity*(z1 + z2)*(z1 + z3)*(z2 + z3))
swing = z1 - z2


def dt(u):
    return 2*length/sqrt(2*gravity)/sqrt(z3 - z1 + swing*mp.sin(u)**2)


def dphi(u):
    return dt(u)*c2/(length**2 - (z1 - swing*mp.sin(u)**2)**2)


T = 2*quad(dt, [0, pi/4, pi/2])
phi_T = 2*quad(dphi, [0, pi/4, pi/2])
k2 = swing/(z3 - z2)
orbit = (T, sqrt(k2), sqrt(1 - k2), ellipk(k2), nome(k2), (phi_T - 2*pi)/T, phi_T, phi_T - pi)
row('orbit 1 2 0.25 -0.75', *orbit)
row('orbit_gaps 1 2 0.75 0.25', *orbit)
row('orbit_rises 1 2 1.25 0.25', *orbit)
release_T = 2*ellipk(h)/sqrt(2)
row('orbit_release 1 2 90 0', release_T, sqrt(h), sqrt(h), ellipk(h), nome(h), -pi/release_T, pi, 0)
turning = (z2, z1, z3, 1 + z2, 1 - z1, swing, z3 - z1, z3 - 1)
# Energy and momentum of decimal form, with the roots of (5) for them: c1 = 2.5, c2 = 2
roots = sorted(mp.polyroots([2*gravity, -2*mpf('2.5'), -2*gravity, 2*mpf('2.5') - 4], maxsteps=200, extraprec=200))
a, b, c = roots
numbers = (a, b, c, 1 + a, 1 - b, b - a, c - b, c - 1)
row('turning 1 2 2.5 2', *numbers)
row('turning_top 1 2 0.5 2', *numbers)
row('turning_bottom 1 2 4.5 2', *numbers)

r1 = sqrt(1 - z1**2)
start = [r1, 0, z1, 0, c2/r1, 0]


def newton(t, s):
    x, v = s[:3], s[3:]
    force = (sum(w*w for w in v) - gravity*x[2])/length**2
    return v + [-force*x[0], -force*x[1], -force*x[2] - gravity]


mp.dps = 30
flow = odefun(newton, 0, start, tol=mpf('1e-25'))
t = mpf('0.5')
there = flow(t)
mp.dps = 40
for name, numbers in (('', '0.25 -0.75'), ('_gaps', '0.75 0.25'), ('_rises', '1.25 0.25')):
    row('azimuth%s 1 2 %s 0.5' % (name, numbers), atan2(there[1], there[0]))
    row('position%s 1 2 %s 0.5' % (name, numbers), *there)
# At the point (0.6, 0, -0.8), velocity (0, 1, 0)
mp.dps = 30
flow2 = odefun(newton, 0, [mpf('0.6'), 0, mpf('-0.8'), 0, mpf(1), 0], tol=mpf('1e-25'))
row('state 1 2 0.6 0 -0.8 0 1 0 0.5', *flow2(t))
row('passage_height 1 2 0.25 -0.75 -0.25', findroot(lambda s: flow(s)[2] + q4, mpf('0.6')))
row('passage_azimuth 1 2 0.25 -0.75 1', findroot(lambda s: atan2(flow(s)[1], flow(s)[0]) - 1, mpf('0.4')))

# Derivatives: central differences of the closed form at 100 digits (test/reference/exact_pendulum.py, which needs python-flint).
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'reference'))
import exact_pendulum as exact  # noqa: E402

mp.dps = 100


def slopes(function, arguments):
    """Rows of the matrix of derivatives."""
    columns = []
    for i in range(len(arguments)):
        ends = []
        for step in (mpf(10)**-30, -mpf(10)**-30):
            ends.append(function(*[a + step*(j == i) for j, a in enumerate(arguments)]))
        columns.append([(a - b)/mpf('2e-30') for a, b in zip(*ends)])
    return [columns[j][i] for i in range(len(columns[0])) for j in range(len(columns))]


for name, solver, a, b in (('', exact.gaps_from_heights, '0.25', '-0.75'), ('_gaps', exact.gaps_from_gaps, '0.75', '0.25'),
                           ('_rises', exact.gaps_from_rises, '1.25', '0.25')):
    def constants(*x):
        values = exact.Orbit(solver(*x)).constants()
        return [values[0], values[7]]

    def place(l, g, u, v, t):
        return exact.Orbit(solver(l, g, u, v)).position(t)
    row('orbit_derivatives%s 1 2 %s %s' % (name, a, b), *slopes(constants, [mpf(1), mpf(2), mpf(a), mpf(b)]))
    row('position_derivatives%s 1 2 %s %s 0.5' % (name, a, b), *slopes(place, [mpf(1), mpf(2), mpf(a), mpf(b), h]))


def state(x, y, z, vx, vy, vz, l, g, t):
    return exact.Motion(l, g, x, y, z, vx, vy, vz).state(t)


# Not 0.6, -0.8: what the program reads are doubles, and 1/4 errors of theirs count here.
row('state_derivatives 1 2 0.6 0 -0.8 0 1 0 0.5',
    *slopes(state, [mpf(0.6), mpf(0), mpf(-0.8), mpf(0), mpf(1), mpf(0), mpf(1), mpf(2), h]))
mp.dps = 40

with open('eval_answers.txt', 'w') as out:
    out.write('# request = results; written by make_eval_answers.py\n')
    out.write('\n'.join(rows) + '\n')
