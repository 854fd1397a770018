#!/usr/bin/env python3
"""Writes study_reference.inc and study_positions.inc: the built-in orbits of `kyvadlo study` and what is exact about them.

Every argument (length, gravity, gaps or rises, times) has at most 24 binary digits, so that all three kinds are asked the same
question. The values are computed twice, with 60 and with 90 digits, by test/reference/exact_pendulum.py from the equations of the
paper, and written with 40 (positions with 36 places). Needs mpmath and python-flint.
"""
import pathlib
import sys

import mpmath as mp
from mpmath import mpf

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent/'test'/'reference'))
import exact_pendulum as exact  # noqa: E402

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
    note = '! Written by make_study_reference.py.\n'
    (HERE/'study_reference.inc').write_text(note+orbits)
    (HERE/'study_positions.inc').write_text(note+positions)


main()
