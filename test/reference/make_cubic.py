#!/usr/bin/env python3
"""References for cubic_roots: cubic.dat.

The distinct real roots of the cubic with exactly the printed binary coefficients, by FLINT's certified isolation of the
complex roots of an integer polynomial (multiple roots are recognised exactly). Results: the number of distinct real roots,
then the roots ascending, 0 behind them. Condition of a root: the largest of its changes when each coefficient in turn moves
up or down by half an ulp, summed over the coefficients, 1e30 if a move makes it disappear. Run in this directory.
"""
import random
from flint import fmpz_poly, fmpz, arb, ctx
from mpmath import mp, mpf

mp.prec = 500
KINDS = {32: (24, -126, 128, 9), 64: (53, -1022, 1024, 17), 128: (113, -16382, 16384, 36)}


class Kind:
    def __init__(self, bits):
        self.bits = bits
        self.digits, self.low, self.high, self.decimals = KINDS[bits]

    def spacing(self, x):
        if x == 0:
            return mpf(2)**(self.low - self.digits + 1)
        return mpf(2)**(max(int(mp.frexp(x)[1]) - 1, self.low) - self.digits + 1)

    def round(self, x):
        step = self.spacing(mpf(x))
        return mp.nint(mpf(x)/step)*step

    def text(self, x):
        return '0' if x == 0 else mp.nstr(x, self.decimals, strip_zeros=True, min_fixed=0, max_fixed=0)


def real_roots(coefficients):
    """Distinct real roots, ascending, 300 bits."""
    parts = [(mpf(c)._mpf_[0], int(mpf(c)._mpf_[1]), int(mpf(c)._mpf_[2])) for c in coefficients]
    least = min((e for s, m, e in parts if m), default=0)
    integers = [fmpz((-1 if s else 1)*(m << (e - least)) if m else 0) for s, m, e in parts]
    polynomial = fmpz_poly(list(reversed(integers)))
    ctx.prec = 400
    if polynomial.degree() < 1:
        return []
    found = []
    for root, multiplicity in polynomial.complex_roots():
        if root.imag == 0:
            man, exp = root.real.mid().man_exp()
            found.append(mpf(int(man))*mpf(2)**int(exp))
    return sorted(found)


def condition(coefficients, roots, kind):
    total = [mpf(0)]*len(roots)
    for i, c in enumerate(coefficients):
        if c == 0:
            continue
        worst = [mpf(0)]*len(roots)
        for direction in (1, -1):
            moved = list(coefficients)
            moved[i] = c + direction*kind.spacing(c)/2
            others = real_roots(moved)
            for j, root in enumerate(roots):
                if len(others) == len(roots):
                    change = abs(others[j] - root)/kind.spacing(root)
                else:
                    change = mpf('1e30')
                worst[j] = max(worst[j], change)
        total = [t + w for t, w in zip(total, worst)]
    return [min(t, mpf('1e30')) for t in total]


def sets(kind):
    uniform = lambda: mpf(random.uniform(-1, 1)) + mpf(random.uniform(-1, 1))*mpf(2)**-50
    middle, wide = {32: (8, 30), 64: (60, 280), 128: (280, 4500)}[kind.bits]
    power = lambda decades: mpf(10)**mpf(random.uniform(-decades, decades))*random.choice((-1, 1))

    def from_roots(x, y, z, a=1):
        return [mpf(a), -a*(x + y + z), a*(x*y + y*z + z*x), -a*x*y*z]

    def short(bits):
        return mpf(random.randrange(-2**bits, 2**bits) or 1)*mpf(2)**random.randrange(-8, 8)

    few = (kind.digits - 4)//3 - 3

    def one_ulp_off(coefficients):
        coefficients = [kind.round(c) for c in coefficients]
        place = random.randrange(4)
        coefficients[place] += random.choice((-1, 1))*kind.spacing(coefficients[place])
        return coefficients

    def exact_double():
        x, z = short(few), short(few)
        return from_roots(x, x, z)

    def exact_triple():
        x = short(few)
        return from_roots(x, x, x)

    def near_double():
        x = uniform()*3
        return from_roots(x, x*(1 + mpf(10)**(-random.uniform(1, kind.digits*0.3))), uniform()*3, uniform())

    def near_triple():
        x = uniform()*3
        shift = lambda: 1 + uniform()*mpf(10)**(-random.uniform(1, kind.digits*0.2))
        return from_roots(x*shift(), x*shift(), x*shift())

    yield 'benign', lambda: [uniform() for _ in range(4)]
    yield 'three_roots', lambda: from_roots(uniform(), uniform(), uniform(), uniform())
    yield 'wide_roots', lambda: from_roots(power(middle/4), power(middle/4), power(middle/4))
    yield 'near_double', near_double
    yield 'near_triple', near_triple
    yield 'exact_double', exact_double
    yield 'exact_triple', exact_triple
    yield 'one_ulp_off_double', lambda: one_ulp_off(exact_double())
    yield 'one_ulp_off_triple', lambda: one_ulp_off(exact_triple())
    yield 'wide60', lambda: [power(middle) for _ in range(4)]
    yield 'wide280', lambda: [power(wide) for _ in range(4)]
    yield 'without_square', lambda: [uniform(), 0, uniform(), uniform()]
    yield 'without_constant', lambda: [uniform(), uniform(), uniform(), 0]
    yield 'quadratic', lambda: [0, uniform(), uniform(), uniform()]
    yield 'linear', lambda: [0, 0, uniform(), uniform()]


def main():
    random.seed(1953)
    with open('cubic.dat', 'w') as out:
        print('# Real roots of cubics by make_cubic.py (FLINT, certified)', file=out)
        print('columns 4 4', file=out)
        for bits in KINDS:
            kind = Kind(bits)
            for name, make in sets(kind):
                rows = 0
                while rows < (50 if bits == 64 else 30):
                    coefficients = [kind.round(c) for c in make()]
                    if any(c != 0 and not mpf(2)**(kind.low + 20) < abs(c) < mpf(2)**(kind.high - 1) for c in coefficients):
                        continue
                    roots = real_roots(coefficients)
                    if any(r != 0 and not mpf(2)**kind.low < abs(r) < mpf(2)**(kind.high - 1) for r in roots):
                        continue
                    if name.startswith('exact'):
                        expected = {'exact_double': 2, 'exact_triple': 1}[name]
                        if len(roots) != expected and not (name == 'exact_double' and len(roots) == 1):
                            raise RuntimeError(f'{name}: coefficients were rounded')
                    conditions = condition(coefficients, roots, kind)
                    missing = 3 - len(roots)
                    print(name, bits, *[kind.text(c) for c in coefficients], len(roots),
                          *[mp.nstr(r, 40, min_fixed=0, max_fixed=0) for r in roots], *['0']*missing,
                          '0', *[mp.nstr(c, 3) for c in conditions], *['0']*missing, file=out)
                    rows += 1


if __name__ == '__main__':
    main()
