#!/usr/bin/env python3
"""References of K, E, D, B and the nome from m (complete.dat, nome.dat) and from 1 - m (complete_c.dat, nome_c.dat),
by Arb (python-flint) at the exact binary arguments. Sets as in the comparison of libraries: benign; k = 1 - 10**-U(1,15);
k = 10**-U(1,150); complement from 1e-300; and negative parameters."""
import random
from fractions import Fraction

from flint import acb, arb

from legendre_reference import power_of_ten, real, rounded, row, to_arb, uniform, write


def complete(m):
    if m == 1:
        return ['Infinity', arb(1), 'Infinity', arb(1)]
    if m == 0:
        return [arb.pi()/2, arb.pi()/2, arb.pi()/4, arb.pi()/4]
    x = to_arb(m)
    k, e = real(acb(x).elliptic_k()), real(acb(x).elliptic_e())
    return [k, e, (k - e)/x, k - (k - e)/x]


def nome(m):
    if m == 1:
        return [arb(1)]
    if m == 0:
        return [arb(0)]
    if m < 0:
        return [-nome(m/(m - 1))[0]]
    k, other = real(acb(to_arb(m)).elliptic_k()), real(acb(to_arb(1 - m)).elliptic_k())
    return [(-arb.pi()*other/k).exp()]


def parameters(bits, r):
    reach = {32: 30, 64: 300, 128: 4000}[bits]
    near = {32: 6, 64: 15, 128: 33}[bits]
    count = {32: 25, 64: 60, 128: 20}[bits]
    for _ in range(count):
        yield 'benign', uniform(r, 0, 1)**2
        yield 'near_one', (1 - power_of_ten(-r.uniform(1, near)))**2
        yield 'tiny', power_of_ten(-r.uniform(2, reach))
        yield 'negative', -power_of_ten(r.uniform(-3, 3))
        yield 'huge_negative', -power_of_ten(r.uniform(3, reach))
    for m in (Fraction(0), Fraction(1), Fraction(1, 2), Fraction(15, 16), Fraction(-15), Fraction(3, 4), Fraction(7, 8)):
        yield 'special', m


def complements(bits, r):
    reach = {32: 30, 64: 300, 128: 4000}[bits]
    near = {32: 6, 64: 15, 128: 33}[bits]
    count = {32: 25, 64: 60, 128: 20}[bits]
    for _ in range(count):
        yield 'benign', uniform(r, 0, 1)
        yield 'tiny', power_of_ten(-r.uniform(1, reach))
        yield 'near_one', 1 - power_of_ten(-r.uniform(1, near))*r.choice((-1, 1))
        yield 'above_one', 1 + power_of_ten(r.uniform(-3, 3))
        yield 'huge', power_of_ten(r.uniform(3, reach))
    smallest = {32: -149, 64: -1074, 128: -16494}[bits]
    largest = {32: 127, 64: 1023, 128: 16383}[bits]
    for x in (Fraction(0), Fraction(1), Fraction(1, 16), Fraction(16), Fraction(1, 2), Fraction(1, 4), Fraction(2)**smallest,
              Fraction(2)**largest, Fraction(2)**(smallest + 10)*3):
        yield 'special', x


def main():
    files = {name: [] for name in ('complete', 'complete_c', 'nome', 'nome_c')}
    for bits in (32, 64, 128):
        r = random.Random(20 + bits)
        for name, value in parameters(bits, r):
            m = rounded(value, bits)
            files['complete'].append(row(name, bits, [m], complete, [1 - m]))
            files['nome'].append(row(name, bits, [m], nome, [1 - m]))
        for name, value in complements(bits, r):
            x = rounded(value, bits)
            files['complete_c'].append(row(name, bits, [x], lambda x: complete(1 - x), [1 - x]))
            files['nome_c'].append(row(name, bits, [x], lambda x: nome(1 - x), [1 - x]))
    write('complete.dat', 'm -> K E D B; written by make_complete.py (Arb)', 1, 4, files['complete'])
    write('complete_c.dat', '1-m -> K E D B; written by make_complete.py (Arb)', 1, 4, files['complete_c'])
    write('nome.dat', 'm -> q; written by make_complete.py (Arb)', 1, 1, files['nome'])
    write('nome_c.dat', '1-m -> q; written by make_complete.py (Arb)', 1, 1, files['nome_c'])


if __name__ == '__main__':
    main()
