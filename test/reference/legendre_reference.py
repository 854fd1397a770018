"""What the make_*.py of Legendre's integrals share: exact binary arguments of the three kinds, half-ulp steps, rows.

Numbers are Fractions (exact) or flint.arb (250 bits and more, as many as the cancellation in m, 1 - m, ... takes).
"""
import math
import random
from fractions import Fraction

import flint
from flint import acb, arb

DIGITS = {32: 24, 64: 53, 128: 113}
MIN_EXPONENT = {32: -149, 64: -1074, 128: -16494}
PRINTED = {32: 9, 64: 17, 128: 36}


def exponent(x):
    """Largest e with 2**e <= |x|, x a Fraction other than 0."""
    x = abs(x)
    e = x.numerator.bit_length() - x.denominator.bit_length()
    return e if x >= Fraction(2)**e else e - 1


def ulp(x, bits):
    return Fraction(2)**max(exponent(x) - DIGITS[bits] + 1, MIN_EXPONENT[bits])


def rounded(x, bits):
    """The Fraction nearest to x that the kind holds exactly."""
    x = Fraction(x)
    if x == 0:
        return x
    u = ulp(x, bits)
    return round(x/u)*u


def power_of_ten(e):
    """10**e for a real e, as a Fraction good to 40 digits."""
    i = math.floor(e)
    return Fraction(10)**i*Fraction(10**(e - i))


def uniform(random_source, low, high):
    return Fraction(low) + (Fraction(high) - Fraction(low))*Fraction(random_source.getrandbits(120), 2**120)


def to_arb(x):
    return arb(flint.fmpq(x.numerator, x.denominator))


def bits_for(*values):
    """Working precision: 400 bits and three times what the smallest and largest of the values take."""
    return 400 + 3*max([0] + [abs(exponent(v)) for v in values if v != 0])


def decimal(x, digits):
    """A Fraction or arb in decimal."""
    if isinstance(x, str):
        return x
    if isinstance(x, Fraction):
        if x == 0:
            return '0.0e0'
        with_precision = flint.ctx.prec
        flint.ctx.prec = 200 + 4*abs(exponent(x))
        text = to_arb(x).str(digits, radius=False)
        flint.ctx.prec = with_precision
    else:
        text = x.str(digits, radius=False)
    return text if 'e' in text else text + 'e0'


def mid_fraction(x):
    """The middle of an arb as a Fraction."""
    mantissa, e = x.mid().man_exp()
    return Fraction(int(mantissa))*Fraction(2)**int(e)


def row(name, bits, arguments, function, extra=()):
    """One row of a reference file. `function(*arguments)` gives a list of arb, or of 'Infinity'; its condition is the sum
    over the arguments of the change of the result when the argument moves by half an ulp, in ulps of the result."""
    flint.ctx.prec = bits_for(*arguments, *extra)
    results = function(*arguments)
    conditions = []
    for value in results:
        if not isinstance(value, str):
            assert value.is_finite() and (value.rad() == 0 or value.rel_accuracy_bits() > 160), \
                (name, bits, [float(a) for a in arguments], value)
    moved = []
    for i, a in enumerate(arguments):
        if a != 0:
            step = ulp(a, bits)/2
            both = []
            for sign in (1, -1):
                try:
                    both.append(function(*arguments[:i], a + sign*step, *arguments[i + 1:]))
                except (ValueError, AssertionError, ZeroDivisionError):
                    pass
            moved.append(both)
    for j, value in enumerate(results):
        if isinstance(value, str) or value == 0:
            conditions.append(0.0)
            continue
        middle = mid_fraction(value)
        unit = ulp(middle, bits)
        total = 0.0
        for both in moved:
            changes = []
            for other in both:
                if isinstance(other[j], str) or not other[j].is_finite():
                    continue
                changes.append(abs(float((other[j] - value).mid()/to_arb(unit))))
            total += max(changes, default=0.0)
        conditions.append(total)
    words = [name, str(bits)] + [decimal(a, PRINTED[bits]) for a in arguments]
    words += [decimal(v, 40) for v in results] + [f'{c:.3e}' for c in conditions]
    return ' '.join(words)


def write(path, title, argument_count, result_count, rows):
    with open(path, 'w') as out:
        for line in title.strip().splitlines():
            out.write('# ' + line + '\n')
        out.write(f'columns {argument_count} {result_count}\n')
        out.write('\n'.join(rows) + '\n')


def real(value):
    assert isinstance(value, (acb, arb))
    return value.real if isinstance(value, acb) else value
