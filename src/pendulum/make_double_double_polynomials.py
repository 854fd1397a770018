#!/usr/bin/env python3
"""Writes double_double_polynomials.inc: near-minimax polynomials of the double-double kernels, by Chebyshev
interpolation at 80 digits (mpmath).

    sin(pi f/2)/f and cos(pi f/2)            for |f| <= 1/2,     in powers of f**2
    sinh(r)/r     and cosh(r)                for |r| <= ln(2)/2, in powers of r**2

The leading coefficients are pairs of numbers, the last ones, whose terms are below 2**-50 of the sum, single numbers.
Printed beside each: the largest error with the coefficients so rounded, of the sum's largest value.
"""
import mpmath as mp

mp.mp.dps = 80
SLACK = mp.mpf("1.0001")  # the reduced argument may pass its bound by a rounding


def ratio(function, scale):
    def quotient(z):
        x = mp.sqrt(abs(z))
        return function(scale * x) / x if x > mp.mpf(10) ** -35 else mp.mpf(scale)
    return quotient


HALF, ROOT = mp.mpf(1) / 2, mp.log(2) / 2
# Name, text, function of the square, largest argument, degree, coefficients that are pairs.
SERIES = [
    ("sine_series", "sin(pi f/2)/f", ratio(mp.sin, mp.pi / 2), HALF, 12, 8),
    ("cosine_series", "cos(pi f/2)", lambda z: mp.cos(mp.pi / 2 * mp.sqrt(abs(z))), HALF, 13, 9),
    ("hyperbolic_sine_series", "sinh(r)/r", ratio(mp.sinh, mp.mpf(1)), ROOT, 10, 7),
    ("hyperbolic_cosine_series", "cosh(r)", lambda z: mp.cosh(mp.sqrt(abs(z))), ROOT, 10, 7),
]

with open("double_double_polynomials.inc", "w") as out:
    out.write("   ! Written by make_double_double_polynomials.py.\n")
    for name, text, function, top, degree, pairs in SERIES:
        right = (top * SLACK) ** 2
        polynomial = mp.chebyfit(function, [0, right], degree + 1)[::-1]
        high = [float(c) for c in polynomial]
        low = [float(c - mp.mpf(h)) if n < pairs else 0.0 for n, (c, h) in enumerate(zip(polynomial, high))]
        rounded = [mp.mpf(h) + mp.mpf(l) for h, l in zip(high, low)]
        points = [right * i / 1000 for i in range(1001)]
        worst = max(abs(mp.polyval(rounded[::-1], z) - function(z)) for z in points) / abs(function(points[0]))
        hyperbolic = name.startswith("hyperbolic")
        if hyperbolic:
            out.write("\n#ifndef without_hyperbolic_functions")
        out.write(f"\n   !> {text} in powers of the square z; largest error {mp.nstr(worst, 2)} of the value at 0.\n")
        out.write(f"   pure type(pair_type) function {name}(z) result(total)\n")
        out.write("      type(pair_type), intent(in) :: z\n      real(real64) :: tail\n\n")
        out.write(f"      tail = {high[degree]!r}_real64\n")
        for n in range(degree - 1, pairs - 1, -1):
            out.write(f"      tail = {high[n]!r}_real64 + z%high*tail\n")
        tail = "pair_type(tail, 0.0_real64)"
        for n in range(pairs - 1, -1, -1):
            out.write(f"      total = next({high[n]!r}_real64, {low[n]!r}_real64, z, {tail})\n")
            tail = "total"
        out.write(f"   end function {name}\n")
        if hyperbolic:
            out.write("#endif\n")
