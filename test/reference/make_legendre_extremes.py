#!/usr/bin/env python3
"""Writes legendre_extremes.dat: integrals of the third kind at the ends of real64, by Arb at the exact inputs, where products
of the formulas overflow or underflow unless they are arranged. Set: complete or incomplete; arguments n, phi (0 if complete),
1 - m."""
from fractions import Fraction

from legendre_reference import row, write
from make_incomplete import complete_pi, incomplete_pi

COMPLETE = ((0.00135, 4.86e307), (3.4e16, 1.98e307), (1.8, 6.2e254), (-1e300, 1e-300), (0.3, 5e-324), (1e300, 1e-310))
INCOMPLETE = ((-3291.46, 4.4633141623243865e-9, 3.02e249), (-4.03e267, 1.5707963267948968, 1.68e-322),
              (2.18e-98, 1.5796895, 1.42e-320), (1.1488e5, 15.2, 3.55e232), (-2.55e-40, 36.39, 3.66e-317),
              (-1e300, 1e-200, 1e-300), (0.5, 1e-300, 0.5))


def main():
    rows = []
    for n, x in COMPLETE:
        rows.append(row('complete', 64, [Fraction(n), Fraction(0), Fraction(x)],
                        lambda n, phi, x: complete_pi(n, 1 - x)))
    for arguments in INCOMPLETE:
        rows.append(row('incomplete', 64, [Fraction(a) for a in arguments], lambda n, phi, x: incomplete_pi(n, phi, 1 - x)))
    write('legendre_extremes.dat', 'n phi 1-m -> Pi; written by make_legendre_extremes.py (Arb)', 3, 1, rows)


if __name__ == '__main__':
    main()
