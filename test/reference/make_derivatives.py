"""Writes the references of the derivatives: python3 make_derivatives.py [NAME]...

Needs mpmath and python-flint. Central differences of the motion of exact_pendulum.py at the exact binary arguments, 160 digits,
steps of 1e-40 of each argument's scale: the error is that of the square, 1e-80. Nothing here differentiates a formula. A result
is written with 20 digits, for real128 with 40; there are no conditions (0), the test takes them from the library by moving the arguments.

derivatives_state_REGIME.dat: l g x y z vx vy vz t -> 54 numbers, rows x y z vx vy vz, columns x y z vx vy vz l g t.
derivatives_INPUT.dat:        l g a b t -> 30 numbers, the same rows, columns l g a b t (t = 0 at the upper turning height, or at
                              the release).
periods_INPUT.dat:            l g a b -> dT/dl dT/dg dT/da dT/db, then the same of lambda T.
Rows for real128 have times to 10 T.
"""
import random
import sys

import mpmath as mp
from mpmath import mpf

import exact_pendulum as exact
import make_orbit

ROWS = {64: 300, 128: 60}
DIGITS = {64: 20, 128: 40}
STEP = mpf(10)**-40


def rounded(x, bits=64):
    return make_orbit.rounded(x, bits)


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


def row(name, arguments, columns, bits):
    results = [columns[j][i] for i in range(len(columns[0])) for j in range(len(columns))]
    values = [make_orbit.argument_text(x, bits) for x in arguments]
    values += [make_orbit.text(x, DIGITS[bits]) for x in results]
    return ' '.join([name, str(bits)]+values+['0']*len(results))


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

    if regime == 'long':
        return start(pick.choice(['generic', 'conical', 'plane', 'small', 'energetic']), pick)
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
    if regime == 'fast':             # half of them near the horizontal plane through the pivot
        if pick.random() < 0.5:
            x = unit([x[0], x[1], across*10**pick.uniform(-6, 0)*pick.choice([-1, 1])])
            v = [a+b*10**pick.uniform(-6, 0) for a, b in zip([-x[1], x[0], 0.0], v)]
        return x, tangent(v, x, 10**pick.uniform(1, 5))
    return x, tangent(v, x, pick.uniform(3, 10))     # energetic


def state_rows(regime, bits):
    pick = random.Random('derivatives '+regime+' 128'*(bits == 128))
    lines = []
    while len(lines) < ROWS[bits]:
        l, g = rounded(mpf(10)**pick.uniform(-1, 1), bits), rounded(mpf(10)**pick.uniform(0, 1.2), bits)
        x, v = start(regime, pick)
        speed = mp.sqrt(g*l)
        arguments = [l, g]+[rounded(l*u, bits) for u in x]+[rounded(speed*u, bits) for u in v]
        if regime in ('plane', 'small') and x[1] == 0:
            arguments[3] = arguments[6] = mpf(0)
        unit_time = mp.sqrt(l/g)
        if regime == 'long':
            t = pick.choice([-1, 1])*10**pick.uniform(3, 9)
        elif regime in ('separatrix', 'upright'):
            t = pick.uniform(-8, 8)
        else:
            t = pick.choice([pick.uniform(-8, 8), pick.choice([-1, 1])*10**pick.uniform(0, 3.4)])
        if bits == 128:
            t = pick.uniform(-60, 60)
        arguments.append(rounded(t*unit_time, bits))
        with mp.workdps(160):
            arguments = [mpf(u) for u in arguments]

            def state(l, g, x, y, z, vx, vy, vz, t):
                return exact.Motion(l, g, x, y, z, vx, vy, vz).state(t)
            try:
                columns = difference(state, arguments, [l, g]+[l]*3+[speed]*3+[unit_time])
            except (exact.Inadmissible, ZeroDivisionError):
                continue
        # exp(3 t) of the third derivative leaves less than 40 digits to a difference.
        is_late = bits == 128 and regime == 'upright' and abs(t) > 20
        lines.append('' if is_late else row(regime, arguments, columns[2:8]+columns[0:2]+columns[8:], bits))
    return [line for line in lines if line]


def write_state(regime):
    lines = state_rows(regime, 64)
    if regime != 'long':
        lines += state_rows(regime, 128)
    write('derivatives_state_'+regime, 'l g x y z vx vy vz t -> rows x y z vx vy vz, columns x y z vx vy vz l g t', 9, 54, lines)


# ------------------------------------------------------------------------------------------------- from turning heights
# Over g l. Above it gravity changes lambda T, by 1/energy**2, by less than 1e-24.
MOST_ENERGY = mpf(10)**12
SETS = {'heights': ['typical', 'near_conical', 'near_plane'],
        'gaps': ['typical', 'near_conical', 'near_plane', 'near_upright'],
        'rises': ['typical', 'near_conical', 'near_plane', 'small'],
        'energy': ['typical', 'near_conical', 'near_plane', 'small', 'energetic']}


def turning_arguments(kind, pick, bits, name):
    if kind == 'energy':
        return make_orbit.energies('energy', name, pick, bits)
    return make_orbit.sampled(kind, pick, bits, name)


def gaps_of(kind, arguments):
    if kind == 'energy':
        l, g, energy, momentum = arguments
        return exact.gaps_from_energy(l, g, abs(momentum), energy=energy)
    return make_orbit.INPUTS[kind][2](*arguments)


def turning_rows(kind, name, bits, moves, periods):
    pick = random.Random('derivatives %s %s %d' % (kind, name, bits))
    wanted = ROWS[bits]//len(SETS[kind])
    tried = 0
    while wanted > 0 and tried < 20*ROWS[bits]:
        tried += 1
        with mp.workdps(50):
            arguments = turning_arguments(kind, pick, bits, name)
        with mp.workdps(400):
            arguments = [mpf(u) for u in arguments]
            gaps = gaps_of(kind, arguments)
            if 1+(gaps.e3-gaps.s)/gaps.l > MOST_ENERGY:
                continue
            scales = [min(arguments[0], gaps.d2, gaps.h1, gaps.D)]*2
            if min(scales) <= 0 or (kind == 'gaps' and min(arguments[2:]) < mpf(10)**-100):
                continue
            scales = [scales[0], arguments[1]]+scales
            if kind == 'energy':
                # Of a nearly circular orbit the swing is the root of what the energy is above a circle's.
                scales = [u*(gaps.D/gaps.l)**2*(gaps.d2/gaps.l) for u in arguments[:2]+[mp.sqrt(gaps.l*gaps.g)**2, abs(arguments[3])]]

            def constants(*values):
                o = exact.Orbit(gaps_of(kind, values)).constants()
                return [o[0], o[7]]
            columns = difference(constants, arguments, scales)
            of_period = ' '.join([name, str(bits)]+[make_orbit.argument_text(x, bits) for x in arguments]
                           + [make_orbit.text(columns[j][i], DIGITS[bits]) for i in range(2) for j in range(4)]+['0']*8)
            longest = 3 if bits == 64 else 1
            t = rounded(constants(*arguments)[0]*pick.choice([pick.uniform(-2, 2), 10**pick.uniform(0, longest)]), bits)

            def state(l, g, a, b, t):
                found = exact.Orbit(gaps_of(kind, [l, g, a, b])).position(t)
                return [-found[i] if b < 0 and kind == 'energy' and i in (1, 4) else found[i] for i in range(6)]
            columns = difference(state, arguments+[t], scales+[mp.sqrt(arguments[0]/arguments[1])])
            periods.append(of_period)
            moves.append(row(name, arguments+[t], columns, bits))
        wanted -= 1


def write_turning(kind):
    moves, periods = [], []
    for bits in (64, 128):
        for name in SETS[kind]:
            turning_rows(kind, name, bits, moves, periods)
    write('derivatives_'+kind, 'l g a b t -> rows x y z vx vy vz, columns l g a b t', 5, 30, moves)
    write('periods_'+kind, 'l g a b -> dT/dl dT/dg dT/da dT/db, then of lambda T', 4, 8, periods)


def write_release(kind):
    lines = []
    for bits in (64, 128):
        pick = random.Random('derivatives release %d' % bits)
        for number in range(ROWS[bits]):
            l, g = rounded(mpf(10)**pick.uniform(-1, 1), bits), rounded(mpf(10)**pick.uniform(0, 1.2), bits)
            angle = pick.uniform(-179, 179)
            speed = pick.uniform(-2.5, 2.5)
            if number % 5 == 1:       # nearly circular
                angle = pick.uniform(5, 80)
                speed = mp.sin(mp.radians(angle))/mp.sqrt(mp.cos(mp.radians(angle)))*(1+10**pick.uniform(-8, -2))
            elif number % 5 == 2:     # from rest
                speed = 0
            elif number % 5 == 3:     # small, or next to the top
                angle, speed = 10**pick.uniform(-6, 0), 10**pick.uniform(-6, -1)
                angle = pick.choice([angle, 180-angle])
            arguments = [l, g, rounded(angle, bits), rounded(speed*mp.sqrt(l*g), bits)]
            unit_time = mp.sqrt(l/g)
            t = pick.choice([pick.uniform(-8, 8), pick.uniform(-60, 60)])
            arguments.append(rounded(t*unit_time, bits))
            with mp.workdps(160):
                arguments = [mpf(u) for u in arguments]

                def state(l, g, angle, speed, t):
                    angle = angle*mp.pi/180
                    return exact.Motion(l, g, l*mp.sin(angle), mpf(0), -l*mp.cos(angle), mpf(0), speed, mpf(0)).state(t)
                columns = difference(state, arguments, [l, g, mpf(1), mp.sqrt(l*g), unit_time])
            lines.append(row('release', arguments, columns, bits))
    write('derivatives_release', 'l g angle speed t -> rows x y z vx vy vz, columns l g angle speed t', 5, 30, lines)


WRITERS = {regime: (write_state, regime) for regime in
           ('generic', 'conical', 'plane', 'small', 'separatrix', 'upright', 'energetic', 'fast', 'long')}
WRITERS.update({kind: (write_turning, kind) for kind in SETS})
WRITERS['release'] = (write_release, 'release')

if __name__ == '__main__':
    for wanted in sys.argv[1:] or WRITERS:
        writer, argument = WRITERS[wanted]
        writer(argument)
        print(wanted, 'written', flush=True)
