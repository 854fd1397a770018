#!/usr/bin/env python3
"""Writes study_reference.inc, study_positions.inc and study_cubics.inc: the built-in orbits of `kyvadlo study`, the cubics of
their turning heights, and what is exact about them; and study_functions.inc: arguments and values of elliptic functions.

Every argument (length, gravity, gaps or rises, times) has at most 24 binary digits, so that all three kinds are asked the same
question. The values are computed twice, with 60 and with 90 digits, by exact_pendulum.py from the equations of the
paper, and written with 40 (positions with 36 places). Needs mpmath and python-flint.
"""
import pathlib
import random

import exact_pendulum as exact
import mpmath as mp
from mpmath import mpf

HERE = pathlib.Path(__file__).resolve().parent

TIMES = 32      # of one period, and of the 1000th
FAR = 999       # periods before the later times


def single(x):
    """The nearest number of 24 binary digits."""
    x = mpf(x)
    if x == 0:
        return x
    with mp.workprec(24):
        return +x


GRAVITY = single('9.80665')
ORBITS = [  # name, start, first, second: top and bottom gap, or upper and lower rise, in lengths
    ('typical', 'gaps', mpf(3)/4, mpf(3)/16),
    ('near_conical', 'gaps', mpf(3)/2-mpf(2)**-10, mpf(1)/2-mpf(2)**-10),
    ('near_plane', 'gaps', mpf(3)/4, mpf(2)**-20),
    ('near_upright', 'gaps', mpf(2)**-20, mpf(2)**-40),
    ('small', 'rises', mpf(2)**-13, mpf(2)**-15),
    ('energetic', 'gaps', mpf(1)/2, mpf(1)/2-mpf(2)**-14),
    ('plane', 'gaps', mpf(1)/2, mpf(0)),
]


def gaps(start, first, second):
    return (exact.gaps_from_gaps if start == 'gaps' else exact.gaps_from_rises)(mpf(1), GRAVITY, first, second)


def twice(function):
    """The value with 60 digits, after one with 90 has confirmed 45 of them."""
    with mp.workdps(90):
        fine = function()
    with mp.workdps(60):
        coarse = function()
    for a, b in zip(fine, coarse):
        assert abs(a-b) <= mpf(10)**-45*max(abs(a), mpf(10)**-12), (a, b)
    return fine


def text(x):
    return mp.nstr(x, 40, strip_zeros=False, min_fixed=0, max_fixed=0)+'_q' if x != 0 else '0.0_q'


def place_text(x):
    """36 places behind the point: errors of places are taken relative to the length, which is 1."""
    scaled = int(mp.nint(x*mpf(10)**36))
    assert abs(scaled) < 10**36
    return '%s.%036d_q' % ('-' if scaled < 0 else '', abs(scaled))


def exact_text(x):
    """A number of at most 24 binary digits, exactly."""
    result = repr(float(x))
    assert mpf(result) == x or mpf(float(result)) == x
    return result+'_real64'


def array(name, shape, kind, items, per_line):
    """A Fortran parameter of rank one or more."""
    lines = [', '.join(items[i:i+per_line]) for i in range(0, len(items), per_line)]
    rank = shape.count(',')+1
    head = '   real(%s), parameter :: %s(%s) = ' % (kind, name, shape)
    head += 'reshape([ &\n' if rank > 1 else '[ &\n'
    tail = ' &\n   ], [%s])\n' % shape if rank > 1 else ']\n'
    return head+', &\n'.join('   '+line for line in lines)+tail


def double(x):
    """The nearest number of 53 binary digits."""
    with mp.workprec(53):
        return +mpf(x)


def double_text(x):
    result = repr(float(x))
    assert mpf(float(result)) == x
    return result+'_real64'


def differences(z2, z1, z3):
    """l + z2, l - z1, z1 - z2, z3 - l for l = 1."""
    return [1+z2, 1-z1, z1-z2, z3-1]


def cubics():
    """z**3 + b z**2 + c z + d with coefficients of 53 digits, as they come out for each orbit, l = g = 1; then cubics with nearly
    equal roots. The references are the roots of exactly these coefficients, and those of exactly this energy and momentum."""
    names, given, cubic_roots, energy_roots = [], [], [], []

    def roots_of(b, c, d):
        roots = sorted(mp.polyroots([1, b, c, d], maxsteps=2000, extraprec=2000), key=lambda z: mp.re(z))
        assert all(abs(mp.im(z)) < mpf(10)**-50 for z in roots), roots
        roots = [mp.re(z) for z in roots]
        return roots+differences(*roots)

    for name, start, first, second in ORBITS:
        o = (exact.gaps_from_gaps if start == 'gaps' else exact.gaps_from_rises)(mpf(1), mpf(1), first, second)
        energy, momentum = double(o.c1), double(o.c2)
        coefficients = [double(-energy), mpf(-1), double(energy-momentum**2/2)]
        names.append(name)
        given += [energy, momentum]+coefficients
        cubic_roots += twice(lambda: roots_of(*coefficients))
        energy_roots += twice(lambda: (t := exact.gaps_from_energy(mpf(1), mpf(1), momentum, energy=energy).turning())[:3]
                              + [t[3], t[4], t[5], t[7]])
    for name, e in (('near_double', mpf(2)**-16), ('nearly_equal', mpf(2)**-25)):
        z2, z1, z3 = -mpf(1)/2-e, -mpf(1)/2+e, mpf(5)/4
        coefficients = [-(z1+z2+z3), z1*z2+z2*z3+z3*z1, -z1*z2*z3]
        assert all(double(x) == x for x in coefficients)
        names.append(name)
        given += [mpf(0), mpf(0)]+coefficients
        cubic_roots += [z2, z1, z3]+differences(z2, z1, z3)
        energy_roots += [mpf(0)]*7
    result = '   integer, parameter :: n_cubics = %d\n' % len(names)
    result += '   character(len=12), parameter :: cubic_names(n_cubics) = [character(len=12) :: &\n      '
    result += ', '.join("'%s'" % n for n in names)+']\n'
    result += '   ! Energy and momentum (0, 0: not of a pendulum), b, c, d.\n'
    result += array('given', '5, n_cubics', 'real64', [double_text(x) for x in given], 5)
    result += '   ! z2, z1, z3, l + z2, l - z1, z1 - z2, z3 - l of the cubic, and of the energy and momentum.\n'
    result += array('of_cubic', '7, n_cubics', 'q', [text(x) for x in cubic_roots], 2)
    result += array('of_energy', '7, n_cubics', 'q', [text(x) for x in energy_roots], 2)
    return result


def legendre_d(phi, m):
    return (mp.ellipf(phi, m)-mp.ellipe(phi, m))/m


def jacobi(u, m):
    return [mp.ellipfun(f, u, m=m) for f in ('sn', 'cn', 'dn')]


FUNCTIONS = [  # name, arguments, function
    ('rc', 'x y', lambda x, y: [mp.elliprc(x, y)]),
    ('rf', 'x y z', lambda x, y, z: [mp.elliprf(x, y, z)]),
    ('rd', 'x y z', lambda x, y, z: [mp.elliprd(x, y, z)]),
    ('rj', 'x y z p', lambda x, y, z, p: [mp.elliprj(x, y, z, p)]),
    ('k', 'm', lambda m: [mp.ellipk(m)]),
    ('e', 'm', lambda m: [mp.ellipe(m)]),
    ('d', 'm', lambda m: [(mp.ellipk(m)-mp.ellipe(m))/m]),
    ('pi', 'n m', lambda n, m: [mp.ellippi(n, m)]),
    ('f', 'phi m', lambda phi, m: [mp.ellipf(phi, m)]),
    ('einc', 'phi m', lambda phi, m: [mp.ellipe(phi, m)]),
    ('dinc', 'phi m', lambda phi, m: [legendre_d(phi, m)]),
    ('piinc', 'n phi m', lambda n, phi, m: [mp.ellippi(n, phi, m)]),
    ('jacobi', 'u m', jacobi),
]
CALLS = 16


def functions():
    """Arguments of 24 binary digits, the parameter m a square of one of 12, so that libraries which take k are asked the same; a
    benign set and a hard one: arguments far apart, moduli close to 1."""
    pick = random.Random('study')
    arguments, values = [], []
    for hard in (False, True):
        for name, names, function in FUNCTIONS:
            for call in range(CALLS):
                row = []
                for what in names.split():
                    if what == 'm':
                        k = 1-mpf(2)**-(4+call//2) if hard else mpf(pick.randrange(400, 3800))/4096
                        row.append(k*k)
                    elif what == 'n':
                        row.append(single(pick.uniform(0.9, 0.9999) if hard else pick.uniform(-2, 0.9)))
                    elif what == 'phi':
                        row.append(single(pick.uniform(1.5, 1.57) if hard else pick.uniform(0.05, 1.5)))
                    elif what == 'u':
                        row.append(single(pick.uniform(3, 9) if hard else pick.uniform(-5, 5)))
                    else:
                        row.append(single(2**pick.uniform(-60, 60) if hard else pick.uniform(0.1, 10)))
                result = twice(lambda: function(*row))
                arguments += row
                values += result
    text_of = '   integer, parameter :: calls = %d, n_functions = %d\n' % (CALLS, len(FUNCTIONS))
    text_of += '   integer, parameter :: ids(n_functions) = [ &\n      %s]\n' % ', '.join('id_'+f[0] for f in FUNCTIONS)
    text_of += '   integer, parameter :: arguments_of(n_functions) = [%s]\n' % ', '.join(str(len(f[1].split())) for f in FUNCTIONS)
    text_of += '   ! For each set (benign, hard), function and call the arguments, one behind the other; so the values.\n'
    text_of += array('arguments', str(len(arguments)), 'real64', [exact_text(x) for x in arguments], 4)
    text_of += array('values', str(len(values)), 'q', [text(x) for x in values], 2)
    return text_of


def main():
    mp.mp.dps = 60
    orbits, positions = '', ''
    periods, advances, times = [], [], []
    for name, start, first, second in ORBITS:
        period, advance = twice(lambda: [(o := exact.Orbit(gaps(start, first, second))).T, o.lamT])
        periods.append(text(period))
        advances.append(text(advance))
        moments = [single(period*(before+mpf(i)/TIMES)) for before in (0, FAR) for i in range(1, TIMES+1)]
        times += [exact_text(t) for t in moments]
        places = []
        for t in moments:
            places += twice(lambda: exact.Orbit(gaps(start, first, second)).position(t)[:3])
        positions += array('positions_'+name, '3, n_times, 2', 'q', [place_text(x) for x in places], 3)
    orbits += '   integer, parameter :: n_times = %d, n_orbits = %d\n' % (TIMES, len(ORBITS))
    orbits += '   character(len=12), parameter :: orbit_names(n_orbits) = [character(len=12) :: &\n      '
    orbits += ', '.join("'%s'" % o[0] for o in ORBITS)+']\n'
    orbits += '   logical, parameter :: by_rises(n_orbits) = [%s]\n' % ', '.join('.true.' if o[1] == 'rises' else '.false.' for o in ORBITS)
    orbits += '   real(real64), parameter :: built_in_gravity = %s\n' % exact_text(GRAVITY)
    orbits += array('first_of_start', 'n_orbits', 'real64', [exact_text(o[2]) for o in ORBITS], 3)
    orbits += array('second_of_start', 'n_orbits', 'real64', [exact_text(o[3]) for o in ORBITS], 3)
    orbits += array('periods', 'n_orbits', 'q', periods, 2)
    orbits += array('advances', 'n_orbits', 'q', advances, 2)
    orbits += array('moments', 'n_times, 2, n_orbits', 'real64', times, 4)
    (HERE/'study_functions.inc').write_text('! Written by make_study_reference.py.\n'+functions())
    (HERE/'study_cubics.inc').write_text('! Written by make_study_reference.py.\n'+cubics())
    note = '! Written by make_study_reference.py.\n'
    (HERE/'study_reference.inc').write_text(note+orbits)
    (HERE/'study_positions.inc').write_text(note+positions)


main()
