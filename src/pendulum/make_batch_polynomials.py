#!/usr/bin/env python3
"""Writes batch_polynomials.inc: near-minimax polynomials of the batch kernel, by Chebyshev interpolation at 60 digits (mpmath).

    sin(pi f/2)/f and cos(pi f/2)            for |f| <= 1/2,     in powers of f**2
    sinh(r)/r     and cosh(r)                for |r| <= ln(2)/2, in powers of r**2

Printed beside each table: the largest error with the coefficients rounded to real64, relative for the sines, absolute for the cosines.
"""
import mpmath as mp

mp.mp.dps = 60
SLACK = mp.mpf("1.0001")  # the reduced argument may pass its bound by a rounding


def fit(function, top, degree, relative):
    """Coefficients in z = x**2 on [0, top**2], lowest first; the leading one of the cosines is kept at 1."""
    right = (top * SLACK) ** 2
    if relative:
        polynomial = mp.chebyfit(function, [0, right], degree + 1)[::-1]
    else:
        polynomial = [mp.mpf(1)] + mp.chebyfit(lambda z: (function(z) - 1) / z, [0, right], degree)[::-1]
    rounded = [float(c) for c in polynomial]
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


TABLES = [
    ("sine_terms", "sin(pi f/2)/f", ratio(mp.sin, mp.pi / 2), mp.mpf(1) / 2, 6, True),
    ("cosine_terms", "cos(pi f/2)", lambda z: mp.cos(mp.pi / 2 * mp.sqrt(abs(z))), mp.mpf(1) / 2, 7, False),
    ("hyperbolic_sine_terms", "sinh(r)/r", ratio(mp.sinh, mp.mpf(1)), mp.log(2) / 2, 5, True),
    ("logarithm_terms", "atanh(s)/s", ratio(mp.atanh, mp.mpf(1)), (mp.sqrt(2) - 1) / (mp.sqrt(2) + 1), 7, True),
    ("mean_terms", "1/agm(1+x, 1-x)", lambda z: 1 / mp.agm(1 + mp.sqrt(abs(z)), 1 - mp.sqrt(abs(z))), mp.mpf(1) / 10, 6, False),
    ("hyperbolic_cosine_terms", "cosh(r)", lambda z: mp.cosh(mp.sqrt(abs(z))), mp.log(2) / 2, 5, False),
]

with open("batch_polynomials.inc", "w") as out:
    out.write("   ! Written by make_batch_polynomials.py.\n")
    for name, text, function, top, degree, relative in TABLES:
        terms, worst = fit(function, top, degree, relative)
        out.write(f"   !> {text} in powers of the square; largest {'relative' if relative else 'absolute'} error "
                  f"{mp.nstr(worst, 2)}.\n")
        out.write(f"   real(real64), parameter :: {name}(0:{degree}) = [ &\n")
        out.write(", &\n".join(f"      {c!r}_real64" for c in terms) + "]\n")
