"""Writes the references of the pendulum: python3 make_orbit.py [NAME]...

Needs mpmath and python-flint. The values come from exact_pendulum.py at the exact binary arguments, 150 digits or more
(2 digits more for each decade of the smallest gap); every row is computed again with 60 digits more and must agree to 45
digits. Arguments read back exactly with 9, 17 or 36 digits. Conditions: for every argument the larger of the two changes of
the result that half an ulp of it up or down makes (where one side determines no orbit, the other), summed over the
arguments, in ulps of the result; an argument that is zero does not count. In azimuth_*, position_* and passage_* only
the last argument (t, z, phi) counts. The condition of an exact zero is 0 in orbit_*, elsewhere in units of the
smallest subnormal.
"""
import random
import sys

import mpmath as mp
from mpmath import mpf

import exact_pendulum as exact

PRECISION = {32: 24, 64: 53, 128: 113}
SMALLEST = {32: -149, 64: -1074, 128: -16494}
DIGITS = {32: 9, 64: 17, 128: 36}
WIDE = {32: 8, 64: 100, 128: 1000}        # decades of lengths and gravities
TINY = {32: 30, 64: 290, 128: 600}        # decades of gaps
SMALL = {32: 15, 64: 140, 128: 400}       # decades of small rises
ENERGETIC = {32: 12, 64: 100, 128: 400}   # decades of c1/(g l)
LAST = {32: 7, 64: 15.6, 128: 33}         # decades a difference of two heights can be small


def rounded(x, bits):
    """x as a number of that kind (its range is the caller's concern)."""
    with mp.workprec(PRECISION[bits]):
        return +mpf(x)


def ulp(x, bits):
    if x == 0:
        return mpf(2)**SMALLEST[bits]
    _, _, exponent, count = mpf(x)._mpf_
    return mpf(2)**max(exponent+count-PRECISION[bits], SMALLEST[bits])


def text(x, digits):
    if x == 0:
        return '0.0e+0'
    return mp.nstr(x, digits, min_fixed=0, max_fixed=0, show_zero_exponent=True)


def argument_text(x, bits):
    value = '%.16e' % float(x) if bits == 64 else text(x, DIGITS[bits])
    with mp.workdps(200):
        exact_value = mpf(value)
    assert rounded(exact_value, bits) == x, (value, x)
    return value




def evaluated(function, arguments, digits):
    """Results at `digits` digits, verified with 60 more."""
    with mp.workdps(digits):
        low = function(*arguments)
    with mp.workdps(digits+60):
        high = function(*arguments)
        for a, b in zip(low, high):
            if abs(a-b) > abs(b)*mpf(10)**-45:
                raise ArithmeticError('more digits needed: %s %s' % (mp.nstr(a, 30), mp.nstr(b, 30)))
    return high


def row(name, bits, function, arguments, digits=150, varied=None, zero_condition=False):
    # with fewer digits than two gaps are apart, both evaluations could agree on 0
    apart = [abs(mp.log10(abs(a/arguments[0]))) for a in arguments[2:4] if a != 0]
    digits = 50*int((digits+2*max(apart, default=0))/50+1)
    while True:
        try:
            results = evaluated(function, arguments, digits)
            break
        except ArithmeticError:
            digits = digits*3//2
            if digits > 6000:
                raise
    conditions = [mpf(0)]*len(results)
    with mp.workdps(digits+60):
        for i in (varied if varied is not None else range(len(arguments))):
            if arguments[i] == 0:
                continue
            change = [mpf(0)]*len(results)
            for sign in (-1, 1):
                moved = list(arguments)
                moved[i] += sign*ulp(arguments[i], bits)/2
                try:
                    other = function(*moved)
                except exact.Inadmissible:
                    continue
                change = [max(c, abs(a-b)) for c, a, b in zip(change, results, other)]
            conditions = [c+d for c, d in zip(conditions, change)]
        conditions = [mpf(0) if r == 0 and not zero_condition else c/ulp(r, bits) for c, r in zip(conditions, results)]
    return ' '.join([name, str(bits)]+[argument_text(a, bits) for a in arguments]
                    + [text(r, 40) for r in results]+[text(c, 4) for c in conditions])


# ---------------------------------------------------------------------------------------------- arguments
def lengths(pick, bits, wide=False):
    if wide:
        l, g = mpf(10)**pick.uniform(-WIDE[bits], WIDE[bits]), mpf(10)**pick.uniform(-WIDE[bits], WIDE[bits])
    else:
        l, g = pick.choice([mpf(1), mpf(pick.uniform(0.2, 70))]), pick.choice([mpf(1), mpf('9.80665'), mpf(pick.uniform(0.5, 30))])
    return rounded(l, bits), rounded(g, bits)


def power(pick, a, b):
    return mpf(10)**-mpf(pick.uniform(a, b))


def heights(name, pick, bits):
    """l g z1 z2"""
    l, g = lengths(pick, bits, name == 'wide')
    d = LAST[bits]
    if name in ('typical', 'wide'):
        z2 = -mpf(pick.uniform(0.1, 0.99))
        z1 = z2+(-2*z2)*mpf(pick.uniform(0.02, 0.98))
    elif name == 'near_conical':
        z2 = -mpf(pick.uniform(0.1, 0.97))
        z1 = z2+power(pick, 1, d+0.4)
    elif name == 'conical':
        z1 = z2 = -mpf(pick.uniform(0.02, 0.99))
    elif name == 'near_plane':
        z2 = -1+power(pick, 1, d)
        z1 = mpf(pick.uniform(-0.95, 0.95))
    elif name == 'plane':
        z2, z1 = mpf(-1), mpf(pick.uniform(-0.98, 0.98))
    elif name == 'near_upright':
        h = power(pick, 1, d-0.5)
        z1, z2 = 1-h, -1+h*mpf(pick.uniform(0, 0.9))
    elif name == 'near_rotation':
        z2 = -mpf(pick.uniform(0.2, 0.99))
        z1 = -z2-power(pick, 1, d)
    elif name == 'small':
        h = power(pick, 2, d-0.5)
        z1, z2 = -1+h, -1+h*mpf(pick.uniform(0, 1))
    z2 = -l if name == 'plane' else rounded(l*z2, bits)
    z1 = z2 if name == 'conical' else rounded(l*z1, bits)
    if name == 'near_conical' and z1 <= z2:
        z1 = z2+ulp(z2, bits)
    return [l, g, z1, z2]


def gaps(name, pick, bits):
    """l g l-z1 l+z2"""
    l, g = lengths(pick, bits, name == 'wide')
    tiny = TINY[bits]
    if name in ('typical', 'wide'):
        d2 = mpf(pick.uniform(0.01, 0.9))
        h1 = d2+(2-2*d2)*mpf(pick.uniform(0.02, 0.98))
    elif name == 'near_conical':
        d2 = mpf(pick.uniform(0.05, 0.9))
        h1 = 2-d2-power(pick, 1, LAST[bits]-0.3)
    elif name == 'near_plane':
        d2 = power(pick, 2, tiny)
        h1 = mpf(pick.uniform(0.05, 1.95))
    elif name == 'plane':
        d2 = mpf(0)
        h1 = pick.choice([mpf(pick.uniform(0.05, 1.95)), power(pick, 1, tiny)])
    elif name == 'near_upright':
        h1 = power(pick, 1, tiny*0.48)
        d2 = h1*h1*power(pick, -5, 5)
    elif name == 'corner':
        h1 = power(pick, 2, tiny*0.9)
        d2 = h1*pick.choice([mpf(pick.uniform(0.01, 0.99)), power(pick, 0, min(tiny*0.1, 20))])
    elif name == 'near_rotation':
        h1 = power(pick, 0.1, tiny if pick.random() < 0.5 else 8)
        d2 = h1*(1-power(pick, 1, LAST[bits]-0.5))
    elif name == 'energetic':
        h1 = power(pick, 0.1, 3)
        d2 = h1*(1-power(pick, LAST[bits]/2, LAST[bits]))
    h1, d2 = rounded(l*h1, bits), rounded(l*d2, bits)
    if h1 <= d2:
        h1 = d2+ulp(d2, bits)
    return [l, g, h1, d2]


def rises(name, pick, bits):
    """l g l+z1 l+z2"""
    l, g = lengths(pick, bits, name == 'wide')
    if name in ('typical', 'wide'):
        d2 = mpf(pick.uniform(0.01, 0.9))
        d1 = d2+(2-2*d2)*mpf(pick.uniform(0.02, 0.98))
    elif name == 'near_conical':
        d2 = mpf(pick.uniform(0.05, 0.9))
        d1 = d2*(1+power(pick, 1, LAST[bits]-0.3))
    elif name == 'conical':
        d1 = d2 = pick.choice([mpf(pick.uniform(0.01, 0.98)), power(pick, 1, SMALL[bits])])
    elif name == 'near_plane':
        d2 = power(pick, 2, TINY[bits])
        d1 = mpf(pick.uniform(0.05, 1.95))
    elif name == 'plane':
        d2, d1 = mpf(0), pick.choice([mpf(pick.uniform(0.05, 1.95)), power(pick, 1, SMALL[bits])])
    elif name == 'small':
        d1 = power(pick, 2, SMALL[bits])
        d2 = d1*pick.choice([mpf(pick.uniform(0.01, 0.99)), power(pick, 0, 30), 1-power(pick, 1, LAST[bits]-1)])
    d1, d2 = rounded(l*d1, bits), rounded(l*d2, bits)
    if name == 'conical':
        d1 = d2
    return [l, g, d1, d2]


HEIGHTS = ['typical', 'wide', 'near_conical', 'conical', 'near_plane', 'plane', 'near_upright', 'near_rotation', 'small']
GAPS = ['typical', 'wide', 'near_conical', 'near_plane', 'plane', 'near_upright', 'corner', 'near_rotation', 'energetic']
RISES = ['typical', 'wide', 'near_conical', 'conical', 'near_plane', 'plane', 'small']
INPUTS = {'heights': (HEIGHTS, heights, exact.gaps_from_heights), 'gaps': (GAPS, gaps, exact.gaps_from_gaps),
          'rises': (RISES, rises, exact.gaps_from_rises)}


def sampled(kind_of_input, pick, bits, name):
    """Arguments that determine an orbit."""
    _, maker, solver = INPUTS[kind_of_input]
    while True:
        arguments = maker(name, pick, bits)
        try:
            solver(*arguments)
        except exact.Inadmissible:
            continue
        return arguments


def count(name, bits, full, few):
    return full if bits == 64 else few


# ---------------------------------------------------------------------------------------------- energies
def energies(form, name, pick, bits):
    """l g c c2, c in the form asked for: energy, top (c1-gl) or bottom (c1+gl)."""
    d = LAST[bits]
    while True:
        l, g = lengths(pick, bits, name == 'wide')
        if name == 'conical':
            # zc = -l/n^2, g = m^2 l: all exact
            n, m = pick.choice([2, 4]), mpf(2)**pick.randint(-3, 3)
            l = mpf(4)**pick.randint(-3, 3)
            g, zc = m*m*l, -l/(n*n)
            c1 = g*(3*zc*zc-l*l)/(2*zc)
            c2 = (l*l-zc*zc)*n*m
        else:
            if name in ('typical', 'wide'):
                z2 = -mpf(pick.uniform(0.1, 0.99))
                o = exact.gaps_from_heights(mpf(1), mpf(1), z2*mpf(pick.uniform(-0.98, 0.98)), z2)
            elif name == 'near_conical':
                zc = -mpf(pick.uniform(0.1, 0.97))
                o = exact.gaps_from_heights(mpf(1), mpf(1), zc+power(pick, 1, d/2+1), zc)
            elif name == 'near_plane':
                o = exact.gaps_from_gaps(mpf(1), mpf(1), mpf(pick.uniform(0.1, 1.9)), power(pick, 2, TINY[bits]))
            elif name == 'near_upright':
                h = power(pick, 2, TINY[bits]*0.48)
                o = exact.gaps_from_gaps(mpf(1), mpf(1), h, h*pick.choice([mpf(pick.uniform(0.05, 0.999)), h]))
            elif name == 'near_rotation':
                h = power(pick, 0.5, d)
                o = exact.gaps_from_gaps(mpf(1), mpf(1), h, h*(1-power(pick, 0.1, 6)))
            elif name == 'small':
                d1 = power(pick, 2, SMALL[bits] if form == 'bottom' else d)
                o = exact.gaps_from_rises(mpf(1), mpf(1), d1, d1*mpf(pick.uniform(0.05, 0.95)))
            elif name == 'energetic':
                h = mpf(pick.uniform(0.1, 0.9))
                e3 = 1/power(pick, 1, ENERGETIC[bits])
                o = exact.Gaps(mpf(1), mpf(1), 2-h, h, h, 2-h, e3, h*(2-h)/e3, 2-2*h)
            elif name == 'plane':
                o = exact.gaps_from_energy(mpf(1), mpf(1), mpf(0), energy=pick.choice([
                    mpf(pick.uniform(-0.99, 4)), mpf(10)**pick.uniform(0, ENERGETIC[bits]), mpf(1),
                    1+power(pick, 1, d), 1-power(pick, 1, d), -1+power(pick, 1, d), mpf(-1)]))
            c1, c2 = g*l*o.c1, o.c2*mp.sqrt(g*l)*l
            if form == 'top':
                c1 = g*l*(o.e3-o.s)
            elif form == 'bottom':
                c1 = g*l*(o.d3-o.s)
            if form == 'energy' and name == 'plane' and pick.random() < 0.4:
                l, c1 = mpf(1), pick.choice([g, -g])          # exactly the separatrix, exactly at rest
        if name == 'conical' and form != 'energy':
            c1 = c1-g*l if form == 'top' else c1+g*l
        result = [l, g, rounded(c1, bits), rounded(c2, bits)]
        if pick.random() < 0.2:
            result[3] = -result[3]
        try:
            turning(form)(*result)
        except exact.Inadmissible:
            continue
        return result


def turning(form):
    if form == 'energy':
        return lambda l, g, c, c2: exact.gaps_from_energy(l, g, c2, energy=c).turning()
    if form == 'top':
        return lambda l, g, c, c2: exact.gaps_from_energy(l, g, c2, above_top=c).turning()
    return lambda l, g, c, c2: exact.gaps_from_energy(l, g, c2, above_bottom=c).turning()


ENERGY_SETS = {'energy': ['typical', 'wide', 'near_conical', 'conical', 'near_plane', 'plane', 'near_rotation', 'small', 'energetic'],
               'top': ['typical', 'wide', 'near_conical', 'conical', 'near_plane', 'plane', 'near_upright', 'near_rotation', 'energetic'],
               'bottom': ['typical', 'wide', 'near_conical', 'conical', 'near_plane', 'plane', 'small', 'energetic']}


def write_turning(form):
    pick = random.Random('turning '+form)
    lines = []
    for bits in (64, 32, 128):
        for name in ENERGY_SETS[form]:
            for _ in range(10 if bits == 64 else 3):
                lines.append(row(name, bits, turning(form), energies(form, name, pick, bits), zero_condition=True))
    argument = {'energy': 'c1', 'top': 'c1-gl', 'bottom': 'c1+gl'}[form]
    write('turning_'+form, 'l g %s c2 -> z2 z1 z3 l+z2 l-z1 z1-z2 z3-z1 z3-l' % argument, 4, 8, lines)


def write_orbit(kind_of_input):
    pick = random.Random('orbit '+kind_of_input)
    names, _, solver = INPUTS[kind_of_input]

    def constants(*arguments):
        return exact.Orbit(solver(*arguments)).constants()
    lines = []
    for bits in (64, 32, 128):
        for name in names:
            for _ in range(12 if bits == 64 else 4):
                lines.append(row(name, bits, constants, sampled(kind_of_input, pick, bits, name)))
    write('orbit_'+kind_of_input, 'l g %s -> T k k\' K q A phi(T) lambda*T' % LABEL[kind_of_input], 4, 8, lines)


LABEL = {'heights': 'z1 z2', 'gaps': 'l-z1 l+z2', 'rises': 'l+z1 l+z2'}


def times(pick, bits, period, longest):
    """Times of one orbit: the turning points and quarters, and what a run may ask for."""
    choices = [mpf(0), period/4, period/2, 3*period/4, period, period*mpf(pick.uniform(0, 1)), period*mpf(pick.uniform(0, 1)),
               -period*mpf(pick.uniform(0, 2)), period*mpf(pick.uniform(1, 10)), 10*period]
    if bits != 128:
        choices += [period*mpf(pick.uniform(10, 1000)), 1000*period, period*mpf(pick.uniform(100, 1000))]
        if longest > 1000:
            choices += [period*mpf(10)**pick.uniform(3, 9), longest*period]
    return [rounded(t, bits) for t in choices]


def write_motion(what, kind_of_input):
    pick = random.Random(what+' '+kind_of_input)
    names, _, solver = INPUTS[kind_of_input]

    def azimuth(l, g, a, b, t):
        return [exact.Orbit(solver(l, g, a, b)).azimuth(t)]

    def position(l, g, a, b, t):
        return exact.Orbit(solver(l, g, a, b)).position(t)
    function = azimuth if what == 'azimuth' else position
    lines = []
    for bits in (64, 32, 128):
        for name in names:
            # 20 orbits, 300 rows of positions, for each regime: shared by the inputs that have it
            inputs_with_it = sum(name in names_of for names_of, _, _ in INPUTS.values())
            orbits = 1 if bits != 64 else 2 if what == 'azimuth' else -(-20//inputs_with_it)
            for _ in range(orbits):
                arguments = sampled(kind_of_input, pick, bits, name)
                with mp.workdps(60 if bits < 128 else 80):
                    period = exact.Orbit(solver(*arguments)).T
                choices = times(pick, bits, period, 10**9 if what == 'position' else 1000)
                if bits != 64:
                    choices = pick.sample(choices, 4)
                for t in choices:
                    lines.append(row(name, bits, function, arguments+[t], varied=[4], zero_condition=True))
    if what == 'azimuth':
        write('azimuth_'+kind_of_input, 'l g %s t -> phi; condition in t alone' % LABEL[kind_of_input], 5, 1, lines)
    else:
        write('position_'+kind_of_input, 'l g %s t -> x y z vx vy vz; condition in t alone' % LABEL[kind_of_input], 5, 6, lines)


def write(name, columns, arguments, results, lines):
    with open(name+'.dat', 'w') as file:
        file.write('# %s\n# Written by make_orbit.py\ncolumns %d %d\n' % (columns, arguments, results))
        file.write('\n'.join(lines)+'\n')
    print(name, len(lines), flush=True)


WRITERS = {}
for _form in ('energy', 'top', 'bottom'):
    WRITERS['turning_'+_form] = lambda form=_form: write_turning(form)
for _input in ('heights', 'gaps', 'rises'):
    WRITERS['orbit_'+_input] = lambda i=_input: write_orbit(i)
for _input in ('heights', 'gaps', 'rises'):
    WRITERS['azimuth_'+_input] = lambda i=_input: write_motion('azimuth', i)
for _input in ('heights', 'gaps', 'rises'):
    WRITERS['position_'+_input] = lambda i=_input: write_motion('position', i)


# ---------------------------------------------------------------------------------------------- states and passages
STATES = ['generic', 'fast', 'upper_half', 'near_conical', 'near_plane', 'small', 'released_at_rest', 'bottom_pole', 'top_pole', 'near_upright',
          'near_pole', 'off_sphere', 'wide', 'exact']
EXACT_STATES = [  # l g x y z vx vy vz: on the sphere exactly
    (5, 4, 3, 0, -4, 0, 3, 0),        # conical
    (5, 4, 0, 3, -4, 3, 0, 0),        # conical, clockwise
    (1, 1, 0, 0, -1, 2, 0, 0),        # separatrix from the lowest point
    (1, 1, 0, 0, -1, -1.5, 0.5, 0),   # plane libration in an oblique plane
    (1, 1, 0, 0, -1, 3, 4, 0),        # plane rotation
    (1, 4, 0, 0, 1, 0.25, 0, 0),      # over the top
    (5, 1, 3, 0, 4, -4, 0, 3),        # plane rotation through a slanted start
    (5, 1, 3, 4, 0, 0, 0, 0),         # released at the equator
    (5, 1, 3, 4, 0, 4, -3, 1),        # horizontal and upward
    (1, 1, 0, 0, -1, 0, 0, 0),        # rest
    (1, 1, 0, 0, 1, 0, 0, 0),         # rest, upright
    (5, 1, 3, 0, -4, 0, 1e-3, 0),     # at an upper turning point
    (5, 1, 3, 0, -4, 0, 7, 0),        # at a lower turning point
    (25, 1, 15, 12, -16, 0.25, 0.5, 0.609375),
]


def start(name, pick, bits):
    """l g x y z vx vy vz"""
    if name == 'exact':
        l, g, *rest = pick.choice(EXACT_STATES)
        return [rounded(u, bits) for u in (l, g, *rest)]
    l, g = lengths(pick, bits, name == 'wide')
    speed = mp.sqrt(g*l)
    polar, angle = mp.acos(mpf(pick.uniform(-1, 1))), mpf(pick.uniform(-3.1, 3.1))
    along, across = mpf(pick.uniform(-1.5, 1.5)), mpf(pick.uniform(-1.5, 1.5))
    if name == 'fast':
        along, across = along*20, across*20
    elif name == 'upper_half':
        polar = mpf(pick.uniform(0.05, 1.4))
    elif name == 'near_conical':
        polar = mp.acos(-mpf(pick.uniform(0.1, 0.95)))
        along = pick.choice([-1, 1])*power(pick, 2, LAST[bits])
        across = mp.sin(polar)/mp.sqrt(-mp.cos(polar))*(1+pick.choice([-1, 1])*power(pick, 2, LAST[bits]))
    elif name == 'near_plane':
        across = power(pick, 2, TINY[bits]/4)
    elif name == 'small':
        size = power(pick, 1, min(SMALL[bits], 30))
        polar = mp.pi-size*mpf(pick.uniform(0.1, 1))
        along, across = along*size, across*size
    elif name == 'released_at_rest':
        along = across = mpf(0)
    elif name == 'near_upright':
        size = power(pick, 1, LAST[bits]/2)
        polar, along, across = size, along*size, across*size
    elif name == 'near_pole':
        size = power(pick, 2, LAST[bits])
        polar = pick.choice([size, mp.pi-size])
    x, y, z = mp.sin(polar)*mp.cos(angle), mp.sin(polar)*mp.sin(angle), mp.cos(polar)
    vx = along*mp.cos(polar)*mp.cos(angle)-across*mp.sin(angle)
    vy = along*mp.cos(polar)*mp.sin(angle)+across*mp.cos(angle)
    vz = -along*mp.sin(polar)
    if name in ('bottom_pole', 'top_pole'):
        x, y, z, vx, vy, vz = mpf(0), mpf(0), mpf(-1 if name == 'bottom_pole' else 1), 2*along, 2*across, mpf(0)
    if name == 'off_sphere':
        x, y, z = (u*(1+mpf(pick.uniform(-9e-4, 9e-4))) for u in (x, y, z))
        tilt = mpf(pick.uniform(-5e-4, 5e-4))*mp.sqrt(along**2+across**2)
        vx, vy, vz = vx+tilt*x, vy+tilt*y, vz+tilt*z
    return [l, g]+[rounded(l*u, bits) for u in (x, y, z)]+[rounded(speed*u, bits) for u in (vx, vy, vz)]


# Starts that no other input has: 300 rows at the poles, 300 at rest.
STATE_ROWS = {'exact': 30, 'bottom_pole': 150, 'top_pole': 150, 'released_at_rest': 300}


def write_state():
    pick = random.Random('state')

    def state(l, g, x, y, z, vx, vy, vz, t):
        return exact.Motion(l, g, x, y, z, vx, vy, vz).state(t)
    lines = []
    for bits in (64, 32, 128):
        for name in STATES:
            for number in range(STATE_ROWS.get(name, 12) if bits == 64 else 3):
                arguments = start(name, pick, bits)
                with mp.workdps(200):
                    motion = exact.Motion(*arguments)
                    if motion.rest or motion.separatrix:
                        period = 3*mp.sqrt(arguments[0]/arguments[1])
                    else:
                        period = motion.orbit.T
                t = pick.choice([mpf(0), period*mpf(pick.uniform(0, 1)), period*mpf(pick.uniform(-3, 3)), period*mpf(pick.uniform(0, 100 if bits < 128 else 10))])
                if name == 'wide' and bits == 32 and not mpf(10)**-30 < period < mpf(10)**30:
                    continue
                if number == 0:
                    t = mpf(0)
                lines.append(row(name, bits, state, arguments+[rounded(t, bits)], zero_condition=True))
    write('state', 'l g x y z vx vy vz t -> x y z vx vy vz (of the projected start); condition in all arguments', 9, 6, lines)


def write_passage(what):
    pick = random.Random('passage '+what)

    def height(l, g, z1, z2, z):
        o = exact.gaps_from_heights(l, g, z1, z2)
        return [exact.passage_height(exact.Orbit(o), z1-z, z-z2)]

    def azimuth(l, g, z1, z2, phi):
        return [exact.passage_azimuth(exact.Orbit(exact.gaps_from_heights(l, g, z1, z2)), phi)]
    lines = []
    for bits in (64, 32, 128):
        for name in HEIGHTS:
            if name == 'conical' and what == 'height' or name == 'plane' and what == 'azimuth':
                continue
            for _ in range(3 if bits == 64 else 1):
                arguments = sampled('heights', pick, bits, name)
                z1, z2 = arguments[2:]
                if what == 'height':
                    values = [z1, z2]+[min(z1, max(z2, rounded(z2+(z1-z2)*u, bits)))
                                       for u in (mpf(pick.uniform(0, 1)), power(pick, 1, 12), 1-power(pick, 1, 12), mpf(pick.uniform(0, 1)))]
                else:
                    values = [mpf(0)]+[rounded(u, bits) for u in (pick.uniform(0, 3.2), pick.uniform(0, 0.1), power(pick, 2, 20), pick.uniform(3, 100), pick.uniform(100, 1e4))]
                for value in values if bits == 64 else pick.sample(values, 3):
                    lines.append(row(name, bits, height if what == 'height' else azimuth, arguments+[value], varied=[4], zero_condition=True))
    write('passage_'+what, 'l g z1 z2 %s -> first t >= 0; condition in the last argument alone' % ('z' if what == 'height' else 'phi'), 5, 1, lines)


WRITERS['state'] = write_state
WRITERS['passage_height'] = lambda: write_passage('height')
WRITERS['passage_azimuth'] = lambda: write_passage('azimuth')


if __name__ == '__main__':
    mp.mp.dps = 400
    for wanted in sys.argv[1:] or WRITERS:
        WRITERS[wanted]()
