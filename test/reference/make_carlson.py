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

# Inputs on which other libraries fail (silently wrong, NaN or refused), by library.
PEERS = {
    'rd': [
        ('gsl', 8.747322574464658e+177, 2.136215423340394e-258, 4.0921410035605316e-232),
        ('gsl', 5.505378544698684e+148, 1.1676598060475864e-32, 3.120928639792502e-269),
    ],
    'rj': [
        ('gsl', 1.697630520172064e+108, 6.1331290020066755e+31, 2.2997143640704873e+106, 5.480632432494245e+232),
        ('gsl', 1.2995932920181272e+81, 1.2850228867867796e+85, 8.224556647751998e+38, 1.0884725665025166e-259),
        ('gsl', 7.073737523142914, 0.5041075780924401, 0.4268869642172545, -0.14644936875953846),
        ('boost_nopromote', 1.2874764074324208e+147, 5.302922175116516e-156, 1.6036580958889517e-209, 8.279135674007577e+81),
        ('boost_nopromote', 1.712800292050063e+142, 3.460363492022357e+26, 9.666186728527464e+195, 1.5029589525747755e-219),
        ('boost_nopromote', 1.697630520172064e+108, 6.1331290020066755e+31, 2.2997143640704873e+106, 5.480632432494245e+232),
        ('boost_nopromote', 3.8318559577705694e+261, 4.710809673123165e-80, 2.437490314680458e-145, 1.0982845288682248e+136),
        ('scipy', 1.9032843480863944e-174, 7.046783770496278e+121, 2.0453094401120107e-191, 3.1348252720574597e-230),
        ('scipy', 1.2594982512359854e+151, 4.88964208171447e-152, 7.183795323315946e-259, 1.1840216567851567e-272),
        ('scipy', 2.0697497809901254e-44, 6.920265883356371e-170, 8.532070395564353e-204, 3.725404328327502e-183),
        ('scipy', 8.431179912258509e+206, 2.151749844129257e-223, 1.065154652547336e-49, 2.4168895585830806e-258),
        ('scipy', 4.52763735455143, 95.98364239176307, 6.921682922899336, 1.2060801321614163e-09),
        ('scipy', 2.454423652895833, 74.69710610995978, 8.638937923039762, 1.0145440595953242e-09),
        ('geographiclib', 26.037932819424846, 53.74826381408977, 1.9202988594503063, 1.5538465055143742e-15),
        ('geographiclib', 7.639671992301249, 32.204778194366604, 56.0015200924899, 4.137956223587275e-15),
        ('geographiclib', 1.2857606967076858e+54, 2.1931927607588922e+49, 1.5757318831458276e+48, 3.9866909107642125e-59),
        ('geographiclib', 6.389757753980105e+59, 5.041330969012624e+49, 2.0976627086695966e+42, 5.9471031429055314e-58),
        ('geographiclib', 7.073737523142914, 0.5041075780924401, 0.4268869642172545, -0.14644936875953846),
        ('rust_ellip', 2.9873106607197383e-137, 2.3749540150467787e-188, 1.3781960377131616e+174, 1.8815464527204872e-217),
        ('rust_ellip', 5.478025970378114e-239, 2.98464185103415e-149, 5.070533494843867e+232, 3.198409597182376e-256),
    ],
    'rc': [
        ('gsl', 45.55380130621963, -1.108708790212741),
        ('rust_ellip', 5.938926114262514e+246, 4.1343049024967796e-77),
        ('rust_ellip', 5.950517072723962e+94, 1.0380382827192355e-228),
    ],
    'rg': [
        ('boost_nopromote', 1.2208447849278447e-267, 1.7568363731439163e-99, 5.337382837133755e-236),
        ('boost_nopromote', 1.4439741277717373e-165, 1.7130973757015233e-245, 2.1532784062389126e-183),
        ('scipy', 4.6133623174660985e-202, 1.47413978039519e-192, 1.2695726263770549e-172),
        ('scipy', 4.996287813163659e-181, 2.0195038871089805e-246, 3.7192754217713227e-149),
        ('geographiclib', 4.321861232543361e+35, 2.29860530027782e+56, 3.3031599980437633e-59),
        ('geographiclib', 9.1556926529113e+34, 2.876136962983093e+43, 1.5469595352746195e-58),
    ],
}


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
    other = (z*(x + y + q) - x*y)/(z + q)
    value = (other - z)*rj(x, y, z, other) - 3*acb.elliptic_rf(x, y, z).real
    if x > 0:
        value += 3*(x*y*z/(x*y + other*q)).sqrt()*rc(x*y + other*q, other*q)
    return value/(z + q)


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


def uniform():
    """In (0, 1], with more digits than any kind has."""
    return mpf(1) - mpf(random.getrandbits(120))/mpf(2)**120


def power(kind, decades):
    return mpf(10)**mpf(random.uniform(-decades, decades))


def sets(name, count, kind):
    """Yields set name and exact arguments."""
    # The decades of real64's sets, and what corresponds to them in the other kinds.
    middle, wide, full = {32: (8, 32, 37), 64: (60, 280, 307), 128: (280, 4500, 4930)}[kind.bits]
    if name == 'rj' and kind.bits == 128:
        # Arb needs one step for each factor of 4 between p and the others.
        middle, wide, full = 60, 600, 1200
    order = 3 if name == 'rj' else count
    benign = lambda: [100*uniform() for _ in range(count)]

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
        yield 'negative_y', lambda: [100*uniform(), -100*uniform()]
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
        yield 'negative_p_zero_wide', lambda: negative(one_zero([power(kind, wide) for _ in range(count)]))


def write_row(out, set_name, kind, function, arguments, value=None):
    if value is None:
        value = proved(function, arguments)
    condition = mpf(0)
    for i, a in enumerate(arguments):
        if a != 0:
            moved = list(arguments)
            moved[i] = a + kind.spacing(a)/2
            condition += abs(proved(function, moved) - value)
    condition /= kind.spacing(value)
    print(set_name, kind.bits, *[kind.text(a) for a in arguments], mp.nstr(value, 40, min_fixed=0, max_fixed=0),
          mp.nstr(condition, 3), file=out)


def main():
    for name, (count, function) in FUNCTIONS.items():
        random.seed(1953)
        with open(f'carlson_{name}.dat', 'w') as out:
            print(f'# Carlson {name.upper()} by make_carlson.py (Arb, 200 bits proved)', file=out)
            print(f'columns {count} 1', file=out)
            for bits in KINDS:
                kind = Kind(bits)
                if bits == 64:
                    for peer, *numbers in PEERS.get(name, []):
                        write_row(out, 'peer_' + peer, kind, function, [mpf(n) for n in numbers])
                largest = mpf(2)**kind.high*(1 - mpf(2)**-kind.digits)
                for set_name, make in sets(name, count, kind):
                    rows = 0
                    while rows < ((60 if bits == 64 else 20) if name == 'rj' else (100 if bits == 64 else 50)):
                        arguments = [kind.round(a) for a in make()]
                        value = proved(function, arguments)
                        # Rows whose value leaves the normal range say little; the limits have tests of their own.
                        if not mpf(2)**kind.low < abs(value) < largest:
                            continue
                        write_row(out, set_name, kind, function, arguments, value)
                        rows += 1


if __name__ == '__main__':
    main()
