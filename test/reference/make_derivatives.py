"""Writes the references of the derivatives: python3 make_derivatives.py [NAME]...

Needs mpmath and python-flint. Central differences of the motion of exact_pendulum.py at the exact binary arguments, 160 digits,
steps of 1e-40 of each argument's scale: the error is that of the square, 1e-80. Nothing here differentiates a formula. A result
is written with 20 digits; there are no conditions (0), the test takes them from the library by moving the arguments.

derivatives_state_REGIME.dat: l g x y z vx vy vz t -> 54 numbers, rows x y z vx vy vz, columns x y z vx vy vz l g t.
derivatives_INPUT.dat:        l g a b t -> 30 numbers, the same rows, columns l g a b t (t = 0 at the upper turning height).
periods_INPUT.dat:            l g a b -> dT/dl dT/dg dT/da dT/db, then the same of lambda T.
"""
import random
import sys

import mpmath as mp
from mpmath import mpf

import exact_pendulum as exact
import make_orbit

ROWS = 100
STEP = mpf(10)**-40


def rounded(x):
    return make_orbit.rounded(x, 64)


def difference(function, arguments, scales):
    """Columns of the central differences of a function of several results."""
    columns = []
    for i, scale in enumerate(scales):
        step = scale*STEP
        ends = []
        for side in (1, -1):
            moved = list(arguments)
            moved[i] += side*step
            ends.append(function(*moved))
        columns.append([(a-b)/(2*step) for a, b in zip(*ends)])
    return columns


def row(name, arguments, columns):
    results = [columns[j][i] for i in range(len(columns[0])) for j in range(len(columns))]
    values = [make_orbit.argument_text(x, 64) for x in arguments]
    values += [make_orbit.text(x, 20) for x in results]
    return ' '.join([name, '64']+values+['0']*len(results))


def write(name, header, arguments, results, lines):
    with open(name+'.dat', 'w') as file:
        file.write('# %s\n# Written by make_derivatives.py\ncolumns %d %d\n' % (header, arguments, results))
        file.write('\n'.join(lines)+'\n')


# ------------------------------------------------------------------------------------------------- from a state
def start(regime, pick):
    """A position on the unit sphere and a velocity in units of sqrt(g l)."""
    def vector():
        while True:
            v = [pick.uniform(-1, 1) for _ in range(3)]
            if 0.01 < sum(u*u for u in v) < 1:
                return v

    def unit(v):
        size = sum(u*u for u in v)**0.5
        return [u/size for u in v]

    def tangent(v, x, size=None):
        along = sum(a*b for a, b in zip(v, x))
        v = [a-along*b for a, b in zip(v, x)]
        if size is not None:
            v = [a*size for a in unit(v)]
        return v

    x = unit(vector())
    v = tangent(vector(), x)
    across = (x[0]**2+x[1]**2)**0.5
    around = [-x[1]/across, x[0]/across, 0.0]
    small = 10**pick.uniform(-7, -1)
    if regime == 'generic':
        return x, [2*u for u in v]
    if regime == 'conical':
        x[2] = -abs(x[2])
        speed = across/abs(x[2])**0.5*(1+pick.choice([0, 1])*10**pick.uniform(-15, -2))
        return x, [speed*u for u in around]
    if regime == 'plane':
        if pick.random() < 0.5:      # along an axis: exactly in a plane
            size = (x[0]**2+x[2]**2)**0.5
            x = [x[0]/size, 0.0, x[2]/size]
            speed = pick.uniform(-3, 3)
            return x, [-x[2]*speed, 0.0, x[0]*speed]
        up = [x[0]*x[2]/across, x[1]*x[2]/across, -across]
        speed = pick.uniform(-3, 3)
        return x, [speed*a+small**2*b for a, b in zip(up, around)]
    if regime == 'small':
        x = unit([small*pick.uniform(-1, 1), small*pick.uniform(-1, 1), -1.0])
        return x, tangent([small*pick.uniform(-1, 1) for _ in range(3)], x)
    if regime == 'separatrix':
        if pick.random() < 0.2:
            return [0.0, 0.0, -1.0], [2.0, 0.0, 0.0]
        return x, tangent(v, x, (2*(1-x[2]))**0.5*(1+pick.choice([0, 1])*10**pick.uniform(-8, -2)))
    if regime == 'upright':
        if pick.random() < 0.1:
            return [0.0, 0.0, 1.0], [0.0, 0.0, 0.0]
        x = unit([small*pick.uniform(-1, 1), small*pick.uniform(-1, 1), 1.0])
        return x, tangent([small*pick.uniform(-1, 1) for _ in range(3)], x)
    if regime == 'energetic':
        return x, tangent(v, x, pick.uniform(3, 10))
    return x, [1.5*u for u in v]     # long


def write_state(regime):
    pick = random.Random('derivatives '+regime)
    lines = []
    while len(lines) < ROWS:
        l, g = rounded(mpf(10)**pick.uniform(-1, 1)), rounded(mpf(10)**pick.uniform(0, 1.2))
        x, v = start(regime, pick)
        speed = mp.sqrt(g*l)
        arguments = [l, g]+[rounded(l*u) for u in x]+[rounded(speed*u) for u in v]
        if regime in ('plane', 'small') and x[1] == 0:
            arguments[3] = arguments[6] = mpf(0)
        unit_time = mp.sqrt(l/g)
        if regime == 'long':
            t = pick.choice([-1, 1])*10**pick.uniform(3, 9)
        elif regime in ('separatrix', 'upright'):
            t = pick.uniform(-8, 8)
        else:
            t = pick.choice([pick.uniform(-8, 8), pick.choice([-1, 1])*10**pick.uniform(0, 3.4)])
        arguments.append(rounded(t*unit_time))
        with mp.workdps(160):
            arguments = [mpf(u) for u in arguments]

            def state(l, g, x, y, z, vx, vy, vz, t):
                return exact.Motion(l, g, x, y, z, vx, vy, vz).state(t)
            try:
                columns = difference(state, arguments, [l, g]+[l]*3+[speed]*3+[unit_time])
            except (exact.Inadmissible, ZeroDivisionError):
                continue
        lines.append(row(regime, arguments, columns[2:8]+columns[0:2]+columns[8:]))
    write('derivatives_state_'+regime, 'l g x y z vx vy vz t -> rows x y z vx vy vz, columns x y z vx vy vz l g t', 9, 54, lines)


# ------------------------------------------------------------------------------------------------- from turning heights
# Next to rotation heights and gaps determine the motion by their last digits alone; the column of l is then a difference.
SETS = {'heights': ['typical', 'near_conical', 'near_plane'],
        'gaps': ['typical', 'near_conical', 'near_plane', 'near_upright'],
        'rises': ['typical', 'near_conical', 'near_plane', 'small']}


def write_turning(kind):
    pick = random.Random('derivatives '+kind)
    _, _, solver = make_orbit.INPUTS[kind]
    moves, periods = [], []
    for name in SETS[kind]:
        for _ in range(25):
            with mp.workdps(50):
                arguments = make_orbit.sampled(kind, pick, 64, name)
            with mp.workdps(400):
                arguments = [mpf(u) for u in arguments]
                gaps = solver(*arguments)
                scales = [min(arguments[0], gaps.d2, gaps.h1, gaps.D)]*2
                if min(scales) <= 0 or (kind == 'gaps' and min(arguments[2:]) < mpf(10)**-100):
                    continue
                scales = [scales[0], arguments[1]]+scales

                def constants(*values):
                    o = exact.Orbit(solver(*values)).constants()
                    return [o[0], o[7]]
                columns = difference(constants, arguments, scales)
                periods.append(' '.join([name, '64']+[make_orbit.argument_text(x, 64) for x in arguments]
                               + [make_orbit.text(columns[j][i], 20) for i in range(2) for j in range(4)]+['0']*8))
                t = rounded(constants(*arguments)[0]*pick.choice([pick.uniform(-2, 2), 10**pick.uniform(0, 3)]))

                def state(l, g, a, b, t):
                    return exact.Orbit(solver(l, g, a, b)).position(t)
                columns = difference(state, arguments+[t], scales+[mp.sqrt(arguments[0]/arguments[1])])
                moves.append(row(name, arguments+[t], columns))
    write('derivatives_'+kind, 'l g a b t -> rows x y z vx vy vz, columns l g a b t', 5, 30, moves)
    write('periods_'+kind, 'l g a b -> dT/dl dT/dg dT/da dT/db, then of lambda T', 4, 8, periods)


WRITERS = {regime: (write_state, regime) for regime in
           ('generic', 'conical', 'plane', 'small', 'separatrix', 'upright', 'energetic', 'long')}
WRITERS.update({kind: (write_turning, kind) for kind in SETS})

if __name__ == '__main__':
    for wanted in sys.argv[1:] or WRITERS:
        writer, argument = WRITERS[wanted]
        writer(argument)
        print(wanted, 'written', flush=True)
