#!/usr/bin/env python3
"""References for Carlson's integrals: carlson_rc.dat, carlson_rf.dat, carlson_rd.dat, carlson_rj.dat, carlson_rg.dat.

Values by Arb (python-flint) with a precision that is doubled until 150 bits are proved; mpmath's elliprj is wrong for
arguments beyond 1e+-100. Principal values of RJ by DLMF 19.20.14, whose cancellation the growing precision absorbs; of RC
by 19.2.20. Run in this directory; the sets are those of the comparison with other libraries.
"""
import random
from flint import arb, acb, ctx
from mpmath import mp, mpf

mp.prec = 400
KINDS = {32: (24, -126, 128, 9), 64: (53, -1022, 1024, 17), 128: (113, -16382, 16384, 36)}


class Kind:
    def __init__(self, bits):
        self.bits = bits
        self.digits, self.low, self.high, self.decimals = KINDS[bits]

    def spacing(self, x):
        if x == 0:
            return mpf(2)**(self.low - self.digits + 1)
        exponent = int(mp.floor(mp.log(abs(x), 2)))
        if mpf(2)**exponent > abs(x):
            exponent -= 1
        return mpf(2)**(max(exponent, self.low) - self.digits + 1)

    def round(self, x):
        step = self.spacing(x)
        return mp.nint(x/step)*step

    def text(self, x):
        return '0' if x == 0 else mp.nstr(x, self.decimals, strip_zeros=True, min_fixed=0, max_fixed=0)


def to_arb(x):
    sign, man, exp, _ = mpf(x)._mpf_
    return arb(-int(man) if sign else int(man))*arb(2)**int(exp)


def rc(x, y):
    if y < 0:
        return (x/(x - y)).sqrt()*rc(x - y, -y)
    return acb.elliptic_rc(x, y).real


def rj(x, y, z, p):
    if p > 0:
        return acb.elliptic_rj(x, y, z, p).real
    x, y, z = sorted((x, y, z), key=lambda v: v.mid())
    q = -p
    other = y + (z - y)*(y - x)/(y + q)
    value = (other - y)*rj(x, y, z, other) - 3*acb.elliptic_rf(x, y, z).real
    if x > 0:
        value += 3*(x*y*z/(x*z + other*q)).sqrt()*rc(x*z + other*q, other*q)
    return value/(y + q)


FUNCTIONS = {
    'rc': (2, rc),
    'rf': (3, lambda x, y, z: acb.elliptic_rf(x, y, z).real),
    'rd': (3, lambda x, y, z: acb.elliptic_rd(x, y, z).real),
    'rj': (4, rj),
    'rg': (3, lambda x, y, z: acb.elliptic_rg(x, y, z).real),
}


def proved(function, arguments):
    ctx.prec = 260
    while True:
        value = function(*[to_arb(a) for a in arguments])
        if value.rel_accuracy_bits() >= 200:
            break
        ctx.prec *= 2
        if ctx.prec > 2**17:
            raise RuntimeError(f'no proof for {arguments}')
    man, exp = value.mid().man_exp()
    return mpf(int(man))*mpf(2)**int(exp)


def power(kind, decades):
    return mpf(10)**mpf(random.uniform(-decades, decades))


def sets(name, count, kind):
    """Yields set name and exact arguments."""
    # The decades of real64's sets, and what corresponds to them in the other kinds.
    middle, wide, full = {32: (8, 32, 37), 64: (60, 280, 307), 128: (280, 4500, 4930)}[kind.bits]
    order = 3 if name == 'rj' else count
    benign = lambda: [mpf(100*(1 - random.random())) for _ in range(count)]

    def one_zero(arguments):
        place = random.randrange({'rc': 1, 'rf': 3, 'rd': 2, 'rj': 3, 'rg': 3}[name])
        arguments[place] = mpf(0)
        return arguments

    def near_equal():
        centre = mpf(1 + 9*random.random())
        return [centre*(1 + mpf(10)**(-random.uniform(0, kind.digits*0.3))*mpf(random.random() - 0.5)) for _ in range(count)]

    yield 'benign', benign
    yield 'near_equal', near_equal
    yield 'wide60', lambda: [power(kind, middle) for _ in range(count)]
    yield 'wide280', lambda: [power(kind, wide) for _ in range(count)]
    yield 'full_range', lambda: [power(kind, full) for _ in range(count)]
    yield 'one_zero', lambda: one_zero(benign())
    yield 'one_zero_wide', lambda: one_zero([power(kind, wide) for _ in range(count)])
    if name == 'rc':
        yield 'negative_y', lambda: [mpf(100*(1 - random.random())), -mpf(100*(1 - random.random()))]
        yield 'negative_y_wide', lambda: [power(kind, wide), -power(kind, wide)]
    if name == 'rj':
        def with_p(sign, low, high, zero=False):
            arguments = one_zero(benign()) if zero else benign()
            arguments[3] *= sign*mpf(10)**random.uniform(low, high)
            return arguments
        least = -kind.digits*0.3
        yield 'small_p', lambda: with_p(1, least, -1)
        yield 'small_p_one_zero', lambda: with_p(1, least, -1, True)
        yield 'large_p', lambda: with_p(1, 1, -least)
        yield 'negative_p', lambda: with_p(-1, 0, 0)
        yield 'negative_p_one_zero', lambda: with_p(-1, 0, 0, True)
        yield 'negative_small_p', lambda: with_p(-1, least, -1)
        yield 'negative_large_p', lambda: with_p(-1, 1, -least)

        def negative(arguments):
            arguments[3] = -arguments[3]
            return arguments
        yield 'negative_near_equal', lambda: negative(near_equal())
        yield 'negative_p_wide60', lambda: negative([power(kind, middle) for _ in range(count)])
        yield 'negative_p_wide280', lambda: negative([power(kind, wide) for _ in range(count)])


def main():
    for name, (count, function) in FUNCTIONS.items():
        random.seed(1953)
        with open(f'carlson_{name}.dat', 'w') as out:
            print(f'# Carlson {name.upper()} by make_carlson.py (Arb, 200 bits proved)', file=out)
            print(f'columns {count} 1', file=out)
            for bits in KINDS:
                kind = Kind(bits)
                largest = mpf(2)**kind.high*(1 - mpf(2)**-kind.digits)
                for set_name, make in sets(name, count, kind):
                    rows = 0
                    while rows < (100 if bits == 64 else 50):
                        arguments = [kind.round(a) for a in make()]
                        value = proved(function, arguments)
                        # Rows whose value leaves the normal range say little; the limits have tests of their own.
                        if not mpf(2)**kind.low < abs(value) < largest:
                            continue
                        condition = mpf(0)
                        for i, a in enumerate(arguments):
                            if a != 0:
                                moved = list(arguments)
                                moved[i] = a + kind.spacing(a)/2
                                condition += abs(proved(function, moved) - value)
                        condition /= kind.spacing(value)
                        print(set_name, bits, *[kind.text(a) for a in arguments], mp.nstr(value, 40, min_fixed=0, max_fixed=0),
                              mp.nstr(condition, 3), file=out)
                        rows += 1


if __name__ == '__main__':
    main()
