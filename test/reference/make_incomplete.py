#!/usr/bin/env python3
"""References of Pi complete (complete_pi*.dat), of F, E, D, B (incomplete*.dat), of Pi incomplete (incomplete_pi*.dat), of
Jacobi's zeta (zeta*.dat) and Heuman's lambda (lambda*.dat), from m and (files *_c) from 1 - m, by Arb (python-flint) at the
exact binary arguments. Principal values are the real parts Arb gives. Zeta: the amplitude is found from its argument by
Newton's iteration on F; then Z = E(am) - (E/K) u.
Sets as in the comparison of libraries: benign; n = 1 - 10**-U(1,15); n = -10**U(0,12); k = 1 - 10**-U(1,15); both;
phi = pi/2 - 10**-U(0,8) with k near 1; phi in 10..1e5; tiny phi; and beyond: negative m, m > 1, n > 1, 1 - m down to 1e-300,
phi just beyond pi/2."""
import random
from fractions import Fraction

import flint
from flint import acb, arb

from legendre_reference import mid_fraction, power_of_ten, real, rounded, row, to_arb, uniform, write

HALF_PI = Fraction('1.57079632679489661923132169163975144209858')


def inverse_degree(bits):
    return {32: 6, 64: 15, 128: 33}[bits]


def complete_pi(n, m):
    if n == 1:
        return ['Infinity']
    if m == 1:
        return ['Infinity' if n < 1 else '-Infinity']
    return [real(acb.elliptic_pi(acb(to_arb(n)), acb(to_arb(m))))]


def incomplete(phi, m):
    if phi == 0:
        return [arb(0)]*4
    x, a = acb(to_arb(phi)), to_arb(m)
    f, e = real(acb.elliptic_f(x, acb(a))), real(acb.elliptic_e_inc(x, acb(a)))
    if m == 0:
        half = to_arb(phi)/2 - (2*to_arb(phi)).sin()/4
        return [f, e, half, f - half]
    d = (f - e)/a
    return [f, e, d, f - d]


def incomplete_pi(n, phi, m):
    return [real(acb.elliptic_pi_inc(acb(to_arb(n)), acb(to_arb(phi)), acb(to_arb(m))))]


def zeta(u, m):
    if u == 0 or m == 0:
        return [arb(0)]
    if m == 1:
        return [to_arb(u).tanh()]
    a, v = to_arb(m), to_arb(u)
    k, e = real(acb(a).elliptic_k()), real(acb(a).elliptic_e())
    turns = round(mid_fraction(v/(2*k)))
    rest = v - 2*turns*k
    sign = 1 if rest >= 0 else -1
    rest = abs(rest)
    beyond = rest > k/2
    target = k - rest if beyond else rest
    t = inverse_of_f(target, a)
    phi = t.sinh().atan()
    value = real(acb.elliptic_e_inc(acb(phi), acb(a))) - e/k*target
    if beyond:
        s, c = phi.sin(), phi.cos()
        value = a*s*c/(c*c + (1 - a)*s*s).sqrt() - value
    return [sign*value]


def inverse_of_f(target, a):
    """t = asinh(tan(phi)) with F(phi) = target <= K/2, by Newton's iteration; t is close to F however near m is to 1."""
    t = target.mid()
    for _ in range(60):
        phi = t.sinh().atan()
        c, s = phi.cos(), phi.sin()
        step = ((real(acb.elliptic_f(acb(phi), acb(a))) - target)*(c*c + (1 - a)*s*s).sqrt()/c).mid()
        t = (t - step).mid()
        if abs(step) < abs(t)*arb(2)**-220:
            return t
    raise ValueError('no convergence')


def heuman(phi, m):
    if phi == 0:
        return [arb(0)]
    if m == 1:
        return [2*to_arb(phi)/arb.pi()]
    a, other = acb(to_arb(m)), acb(to_arb(1 - m))
    k, e = real(a.elliptic_k()), real(a.elliptic_e())
    f1, e1 = real(acb.elliptic_f(acb(to_arb(phi)), other)), real(acb.elliptic_e_inc(acb(to_arb(phi)), other))
    return [2/arb.pi()*(e*f1 + k*(e1 - f1))]


def near_modulus(bits, r):
    return (1 - power_of_ten(-r.uniform(1, inverse_degree(bits))))**2


def third_kind_pairs(bits, r, count):
    near = inverse_degree(bits)
    reach = {32: 8, 64: 12, 128: 30}[bits]
    for _ in range(count):
        m = uniform(r, 0, 1)**2
        yield 'benign', uniform(r, -2, 1), m
        yield 'n_near_one', 1 - power_of_ten(-r.uniform(1, near)), m
        yield 'n_negative', -power_of_ten(r.uniform(0, reach)), m
        yield 'n_above_one', 1 + power_of_ten(r.uniform(-near, 3)), m
        yield 'near_one', uniform(r, -2, 1), near_modulus(bits, r)
        yield 'both_near_one', 1 - power_of_ten(-r.uniform(1, near)), near_modulus(bits, r)
        yield 'm_negative', uniform(r, -2, 3), -power_of_ten(r.uniform(-3, 8))


def third_kind_pairs_c(bits, r, count):
    near = inverse_degree(bits)
    reach = {32: 30, 64: 300, 128: 3000}[bits]
    for _ in range(count):
        yield 'benign', uniform(r, -2, 1), uniform(r, 0, 1)
        yield 'tiny', uniform(r, -2, 3), power_of_ten(-r.uniform(1, reach))
        yield 'tiny_n_negative', -power_of_ten(r.uniform(0, 8)), power_of_ten(-r.uniform(1, reach))
        yield 'tiny_n_near_one', 1 - power_of_ten(-r.uniform(1, near)), power_of_ten(-r.uniform(1, reach))


def amplitudes(bits, r, count):
    small = {32: 30, 64: 300, 128: 3000}[bits]
    near = {32: 5, 64: 8, 128: 25}[bits]
    for _ in range(count):
        m = uniform(r, 0, 1)**2
        yield 'benign', HALF_PI*uniform(r, 0, 1), m
        yield 'near_one', HALF_PI - power_of_ten(-r.uniform(0, near)), near_modulus(bits, r)
        yield 'large', power_of_ten(r.uniform(1, 5))*r.choice((-1, 1)), m
        yield 'tiny', power_of_ten(-r.uniform(1, small)), m
        yield 'beyond', HALF_PI*uniform(r, 1, 3)*r.choice((-1, 1)), uniform(r, 0, 1)
        yield 'm_negative', HALF_PI*uniform(r, 0, 3), -power_of_ten(r.uniform(-3, 8))


def above_one(bits, r, count):
    for _ in range(count):
        m = rounded(1 + power_of_ten(r.uniform(-5, 6)), bits)
        flint.ctx.prec = 300
        limit = mid_fraction((1/to_arb(m).sqrt()).asin())
        yield 'm_above_one', limit*uniform(r, 0, 1)*Fraction(99, 100), m


def amplitudes_c(bits, r, count):
    reach = {32: 30, 64: 300, 128: 3000}[bits]
    near = {32: 5, 64: 8, 128: 25}[bits]
    for _ in range(count):
        x = power_of_ten(-r.uniform(1, reach))
        yield 'benign', HALF_PI*uniform(r, 0, 1), uniform(r, 0, 1)
        yield 'tiny_complement', HALF_PI*uniform(r, 0, 1), x
        yield 'tiny_near', HALF_PI - power_of_ten(-r.uniform(0, near)), x
        yield 'tiny_large', power_of_ten(r.uniform(0, 5)), x


def third_kind(sets, bits, r):
    near = inverse_degree(bits)
    reach = {32: 8, 64: 12, 128: 30}[bits]
    for i, (name, phi, m) in enumerate(sets):
        n = (uniform(r, -2, 1), 1 - power_of_ten(-r.uniform(1, near)), -power_of_ten(r.uniform(0, reach)),
             1 + power_of_ten(r.uniform(-3, 3)))[r.randrange(4)]
        yield name + '_' + ('n_negative' if n < -2 else 'plain' if n < Fraction(9, 10) else 'n_near_one' if n < 1
                            else 'n_above_one'), n, phi, m


def exact(bits, *values):
    return [rounded(v, bits) for v in values]


def main():
    names = ('complete_pi', 'incomplete', 'incomplete_pi', 'zeta', 'lambda')
    files = {name + end: [] for name in names for end in ('', '_c')}
    for bits in (32, 64, 128):
        r = random.Random(40 + bits)
        count = {32: 12, 64: 40, 128: 8}[bits]
        for name, n, m in third_kind_pairs(bits, r, count):
            n, m = exact(bits, n, m)
            files['complete_pi'].append(row(name, bits, [n, m], complete_pi, [1 - m, 1 - n]))
        for name, n, x in third_kind_pairs_c(bits, r, count):
            n, x = exact(bits, n, x)
            files['complete_pi_c'].append(row(name, bits, [n, x], lambda n, x: complete_pi(n, 1 - x), [1 - n]))
        sets = list(amplitudes(bits, r, count)) + list(above_one(bits, r, count))
        sets_c = list(amplitudes_c(bits, r, count))
        for name, phi, m in sets:
            phi, m = exact(bits, phi, m)
            files['incomplete'].append(row(name, bits, [phi, m], incomplete, [1 - m]))
        for name, phi, x in sets_c:
            phi, x = exact(bits, phi, x)
            files['incomplete_c'].append(row(name, bits, [phi, x], lambda phi, x: incomplete(phi, 1 - x)))
        for name, n, phi, m in third_kind(sets, bits, r):
            n, phi, m = exact(bits, n, phi, m)
            files['incomplete_pi'].append(row(name, bits, [n, phi, m], incomplete_pi, [1 - m, 1 - n]))
        for name, n, phi, x in third_kind(sets_c, bits, r):
            n, phi, x = exact(bits, n, phi, x)
            files['incomplete_pi_c'].append(row(name, bits, [n, phi, x], lambda n, phi, x: incomplete_pi(n, phi, 1 - x),
                                                [1 - n]))
        for name, phi, m in sets:
            if m <= 1:
                phi, m = exact(bits, phi, m)
                files['zeta'].append(row(name, bits, [phi, m], zeta, [1 - m]))
                if m >= 0:
                    files['lambda'].append(row(name, bits, [phi, m], heuman, [1 - m]))
        for name, phi, x in sets_c:
            phi, x = exact(bits, phi*power_of_ten(r.uniform(0, 2)) if name != 'tiny_large' else phi, x)
            files['zeta_c'].append(row(name, bits, [phi, x], lambda phi, x: zeta(phi, 1 - x)))
            files['lambda_c'].append(row(name, bits, [phi, x], lambda phi, x: heuman(phi, 1 - x)))
    titles = dict(complete_pi='n m -> Pi', incomplete='phi m -> F E D B', incomplete_pi='n phi m -> Pi', zeta='u m -> Z')
    titles['lambda'] = 'phi m -> Lambda_0'
    counts = dict(complete_pi=(2, 1), incomplete=(2, 4), incomplete_pi=(3, 1), zeta=(2, 1))
    counts['lambda'] = (2, 1)
    for name in names:
        for end in ('', '_c'):
            title = titles[name] if not end else titles[name].replace(' m ', ' 1-m ')
            write(name + end + '.dat', title + '; written by make_incomplete.py (Arb)', *counts[name], files[name + end])


if __name__ == '__main__':
    main()
