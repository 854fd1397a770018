#!/usr/bin/env python3
"""Writes batch_polynomials*.inc: near-minimax polynomials of the batch kernels, by Chebyshev interpolation at 60
digits (mpmath).

    sin(pi f/2)/f and cos(pi f/2)            for |f| <= 1/2,     in powers of f**2
    sinh(r)/r     and cosh(r)                for |r| <= ln(2)/2, in powers of r**2
    atan(s)/s                                for |s| <= tan(pi/8), in powers of s**2

Printed beside each table: the largest error with the coefficients rounded to their kind, relative for the sines,
absolute for the cosines.
"""
import struct

import mpmath as mp

mp.mp.dps = 60
SLACK = mp.mpf("1.0001")  # the reduced argument may pass its bound by a rounding


def rounded_to(kind, number):
    """The nearest number of the kind, as a float."""
    return float(number) if kind == "real64" else struct.unpack("f", struct.pack("f", float(number)))[0]


def fit(function, top, degree, relative, kind):
    """Coefficients in z = x**2 on [0, top**2], lowest first; the leading one of the cosines is kept at 1."""
    right = (top * SLACK) ** 2
    if relative:
        polynomial = mp.chebyfit(function, [0, right], degree + 1)[::-1]
    else:
        polynomial = [mp.mpf(1)] + mp.chebyfit(lambda z: (function(z) - 1) / z, [0, right], degree)[::-1]
    rounded = [rounded_to(kind, c) for c in polynomial]
    worst = 0
    for i in range(1, 2000):
        z = right * i / 2000
        error = mp.polyval([mp.mpf(c) for c in rounded[::-1]], z) - function(z)
        worst = max(worst, abs(error / function(z)) if relative else abs(error))
    return rounded, worst


def ratio(function, scale):
    def quotient(z):
        x = mp.sqrt(abs(z))
        return function(scale * x) / x if x > mp.mpf(10) ** -25 else mp.mpf(scale)
    return quotient


# The file of a grade: its kind, the degrees in the square of sine, cosine, sinh, cosh, and of the series of the period
# and of the azimuth.
GRADES = [
    ("batch_polynomials.inc", "real64", (6, 7, 5, 5), (7, 6, 10)),
    ("batch_polynomials_single.inc", "real32", (3, 4, 2, 3), None),
    ("batch_polynomials_short.inc", "real64", (4, 5, 3, 4), None),
]


def series(degrees, period_degrees):
    """Name, text, function of the square, largest argument, degree, whether relative, the first term written."""
    half, root = mp.mpf(1) / 2, mp.log(2) / 2
    yield "sine_series", "sin(pi f/2)/f", ratio(mp.sin, mp.pi / 2), half, degrees[0], True, 0
    yield "cosine_series", "cos(pi f/2)", lambda z: mp.cos(mp.pi / 2 * mp.sqrt(abs(z))), half, degrees[1], False, 0
    yield "hyperbolic_sine_rest", "sinh(r)/r", ratio(mp.sinh, mp.mpf(1)), root, degrees[2], True, 1
    if period_degrees:
        yield ("logarithm_rest", "atanh(s)/s", ratio(mp.atanh, mp.mpf(1)), (mp.sqrt(2) - 1) / (mp.sqrt(2) + 1),
               period_degrees[0], True, 1)
        yield ("mean_series", "1/agm(1+x, 1-x)", lambda z: 1 / mp.agm(1 + mp.sqrt(abs(z)), 1 - mp.sqrt(abs(z))),
               mp.mpf(1) / 10, period_degrees[1], False, 0)
        yield ("arctangent_rest", "atan(s)/s", ratio(mp.atan, mp.mpf(1)), mp.tan(mp.pi / 8), period_degrees[2], True, 1)
    yield "hyperbolic_cosine_series", "cosh(r)", lambda z: mp.cosh(mp.sqrt(abs(z))), root, degrees[3], False, 0


for file, kind, degrees, period_degrees in GRADES:
    with open(file, "w") as out:
        out.write("   ! Written by make_batch_polynomials.py.\n")
        for name, text, function, top, degree, relative, first in series(degrees, period_degrees):
            terms, worst = fit(function, top, degree, relative, kind)
            error = f"largest {'relative' if relative else 'absolute'} error {mp.nstr(worst, 2)}"
            what = f"({text} - 1)/z" if first else text
            of_period = name in ("logarithm_rest", "mean_series", "arctangent_rest")
            if of_period:
                out.write("\n#ifndef without_periods")
            out.write(f"\n   !> {what} in powers of the square z; {error}{' of ' + text if first else ''}.\n")
            out.write(f"   pure real({kind}) function {name}(z) result(total)\n")
            out.write(f"      real({kind}), intent(in) :: z\n\n")
            out.write(f"      total = {terms[degree]!r}_{kind}\n")
            for term in terms[degree - 1:first - 1 if first else None:-1]:
                out.write(f"      total = {term!r}_{kind} + z*total\n")
            out.write(f"   end function {name}\n")
            if of_period:
                out.write("#endif\n")
