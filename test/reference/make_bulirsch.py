#!/usr/bin/env python3
"""References of Bulirsch's integrals (bulirsch_cel.dat, bulirsch_el1.dat, bulirsch_el2.dat, bulirsch_el3.dat), by Arb
(python-flint) at the exact binary arguments, from DLMF 19.25.1 and 19.25.16 to 19.25.18 in Carlson's integrals. Principal values by
DLMF 19.20.14. Sets: benign; kc near 1; kc tiny or large; x large; p negative, near 0 or large; weights of both signs."""
import random

from flint import acb

from legendre_reference import power_of_ten, rounded, row, to_arb, uniform, write


def rc(x, y):
    if y < 0:
        return (x/(x - y)).sqrt()*rc(x - y, -y)
    return acb.elliptic_rc(x, y).real


def rf(x, y, z):
    return acb.elliptic_rf(x, y, z).real


def rd(x, y, z):
    return acb.elliptic_rd(x, y, z).real


def rj(x, y, z, p):
    if p > 0:
        return acb.elliptic_rj(x, y, z, p).real
    x, y, z = sorted((x, y, z), key=lambda v: v.mid())
    q = -p
    other = (z*(x + y + q) - x*y)/(z + q)
    value = (other - z)*rj(x, y, z, other) - 3*rf(x, y, z)
    if x > 0:
        value += 3*(x*y*z/(x*y + other*q)).sqrt()*rc(x*y + other*q, other*q)
    return value/(z + q)


def cel(kc, p, a, b):
    m, p, a, b = to_arb(kc)**2, to_arb(p), to_arb(a), to_arb(b)
    zero, one = to_arb(kc)*0, to_arb(kc)*0 + 1
    return [a*rf(zero, m, one) + (b - p*a)*rj(zero, m, one, p)/3]


def incomplete(x, kc):
    r = 1/to_arb(x)**2
    return r, r + to_arb(kc)**2, r + 1


def el1(x, kc):
    return [(1 if x > 0 else -1)*rf(*incomplete(x, kc))]


def el2(x, kc, a, b):
    r = incomplete(x, kc)
    return [(1 if x > 0 else -1)*(to_arb(a)*rf(*r) + (to_arb(b) - to_arb(a))*rd(*r)/3)]


def el3(x, kc, p):
    r = incomplete(x, kc)
    return [(1 if x > 0 else -1)*(rf(*r) + (1 - to_arb(p))*rj(*r, r[0] + to_arb(p))/3)]


def moduli(bits, r):
    wide = {32: 30, 64: 140, 128: 400}[bits]
    yield 'benign', uniform(r, 0, 1)*r.choice((1, 1, -1))
    yield 'near_one', 1 + power_of_ten(-r.uniform(1, 6))*r.choice((1, -1))
    yield 'tiny', power_of_ten(-r.uniform(1, wide))
    yield 'large', power_of_ten(r.uniform(0, wide))


def questions(bits, r, count):
    """Function, set and arguments, `count` of every combination."""
    wide = {32: 18, 64: 140, 128: 400}[bits]
    for _ in range(count):
        for name, kc in moduli(bits, r):
            for p_name, p in (('plain', power_of_ten(r.uniform(-2, 2))), ('p_far', power_of_ten(r.uniform(-wide/4, wide/4))),
                              ('p_negative', -power_of_ten(r.uniform(-3, 3)))):
                a, b = uniform(r, 0, 2), uniform(r, 0, 2)
                arguments = [rounded(v, bits) for v in (kc, p, a, b)]
                yield 'cel', f'{name}_{p_name}', arguments
                yield 'cel', f'{name}_{p_name}_signs', arguments[:3] + [-arguments[3]]
                x = r.choice((1, -1))*power_of_ten(r.choice((r.uniform(-1, 2), r.uniform(-wide/2, wide/2))))
                yield 'el3', f'{name}_{p_name}', [rounded(v, bits) for v in (x, kc, p)]
            for x_name, decades in (('plain', 2), ('far', wide)):
                x = r.choice((1, -1))*power_of_ten(r.uniform(-decades, decades))
                x, kc_, a, b = (rounded(v, bits) for v in (x, kc, uniform(r, 0, 2), uniform(r, 0, 2)))
                yield 'el1', f'{name}_{x_name}', [x, kc_]
                yield 'el2', f'{name}_{x_name}', [x, kc_, a, b]
                yield 'el2', f'{name}_{x_name}_signs', [x, kc_, a, -b]


FUNCTIONS = {'cel': (4, cel), 'el1': (2, el1), 'el2': (4, el2), 'el3': (3, el3)}


def main():
    rows = {name: [] for name in FUNCTIONS}
    for bits, count in {32: 12, 64: 40, 128: 8}.items():
        for name, set_name, arguments in questions(bits, random.Random(70 + bits), count):
            rows[name].append(row(set_name, bits, arguments, FUNCTIONS[name][1]))
    for name, (count, _) in FUNCTIONS.items():
        write(f'bulirsch_{name}.dat', f'Bulirsch\'s {name}, by make_bulirsch.py.', count, 1, rows[name])


if __name__ == '__main__':
    main()
