#!/usr/bin/env python3
"""Writes jacobi.dat (u, m) and jacobic.dat (u, 1 - m): sn, cn, dn and am at the exact binary arguments.

Descending Landen transformation with the arithmetic-geometric mean (DLMF 22.20(ii)) at 60 digits beyond what the
argument and the complementary parameter cancel; every twentieth row is compared with mpmath's ellipfun, which sums
theta series.
The sets are those of doc/accuracy_tables.md."""
import random
from mpmath import mp, mpf, sqrt, sin, cos, asin, atan2, log10, ellipfun, nstr, frexp, ldexp, nint, pi, agm

DIGITS = {32: (24, -125, 9), 64: (53, -1021, 17), 128: (113, -16381, 36)}


def rounded(x, bits):
    """The number of the kind nearest to x."""
    precision, least, _ = DIGITS[bits]
    if x == 0:
        return mpf(0)
    mantissa, exponent = frexp(x)
    shift = max(exponent, least) - precision
    return ldexp(nint(ldexp(x, -shift)), shift)


def spacing(x, bits):
    precision, least, _ = DIGITS[bits]
    return mpf(0) if x == 0 else ldexp(mpf(1), max(frexp(x)[1], least) - precision)


def landen(u, m, mc):
    """sn, cn, dn, am for m < 1."""
    a, b, ladder = mpf(1), sqrt(mc), []
    while abs(a - b) > a*mpf(10)**(-mp.dps + 5):
        a, b, c = (a + b)/2, sqrt(a*b), (a - b)/2
        ladder.append(c/a)
    phi = ldexp(a*u, len(ladder))
    for ratio in reversed(ladder):
        phi = (phi + asin(ratio*sin(phi)))/2
    sn, cn = sin(phi), cos(phi)
    return sn, cn, sqrt(cn*cn + mc*sn*sn), phi


def jacobi(u, m, mc):
    if m < 1:
        return landen(u, m, mc)
    if mc == 0:
        e = mp.exp(u)
        return (e - 1/e)/(e + 1/e), 2/(e + 1/e), 2/(e + 1/e), 2*mp.atan(mp.tanh(u/2))
    k = sqrt(m)
    sn, dn, cn, _ = landen(u*k, 1/m, -mc/m)
    return sn/k, cn, dn, atan2(sn/k, cn)


def work_digits(u, mc):
    if mc == 0:
        return 75
    return 75 + int(2*max(0, -log10(abs(mc)))) + int(2*log10(abs(u) + 1)) + int(log10(1 + abs(1 - mc)))


def row(name, bits, u, parameter, complementary, check):
    """One line: the results and the conditions, each argument moved by half an ulp."""
    mp.dps = 800
    mp.dps = work_digits(u, parameter if complementary else 1 - parameter) + 40
    m, mc = (1 - parameter, parameter) if complementary else (parameter, 1 - parameter)
    values = jacobi(u, m, mc)
    sn, cn, dn, am = values
    if check and abs(u) < 1e3 and mp.dps < 400 and 0 < m < 1:
        with mp.workdps(mp.dps + 40):
            for kind, value in zip(('sn', 'cn', 'dn'), values):
                assert abs(ellipfun(kind, u, m=m) - value) < mpf(10)**-45, (kind, u, m)
    step = mpf(10)**-30*abs(parameter)
    if parameter == 0 or mc == 0:
        slope = [mpf(0)]*4
    else:
        with mp.workdps(mp.dps + 60):
            p = parameter + step
            moved = jacobi(u, 1 - p if complementary else p, p if complementary else 1 - p)
            p = parameter
            here = jacobi(u, 1 - p if complementary else p, p if complementary else 1 - p)
            slope = [(x - y)/step for x, y in zip(moved, here)]
    if parameter == 1 and not complementary:  # dF/dm at m = 1, DLMF 22.10.7 to 22.10.9
        sinh, cosh = mp.sinh(u), mp.cosh(u)
        bend = (sinh*cosh - u)/4/cosh**2
        slope = [-bend, bend*sinh, -(sinh*cosh + u)/4*sinh/cosh**2, bend*cosh*-1]
    along_u = [cn*dn, sn*dn, m*sn*cn, dn]
    half_u, half_p = spacing(u, bits)/2, spacing(parameter, bits)/2
    conditions = [(abs(du)*half_u + abs(dp)*half_p)/spacing(v, bits) if v != 0 else mpf(0)
                  for du, dp, v in zip(along_u, slope, values)]
    digits = DIGITS[bits][2]
    return ' '.join([name, str(bits), nstr(u, digits), nstr(parameter, digits)] + [nstr(v, 40) for v in values]
                    + [nstr(c, 4) for c in conditions])


def uniform(a, b):
    return mpf(random.uniform(a, b)) + (random.random() + random.random()*mpf(2)**-50)*mpf(2)**-60*(b - a)


def power(a, b):
    return mpf(10)**uniform(a, b)


def sign():
    return random.choice((-1, 1))


def quarter(mc):
    with mp.workdps(400):
        return pi/2/agm(1, sqrt(mc))


def near_zero(mc, bits, most=40):
    """Next to a multiple of K, from one ulp to a tenth away."""
    n = random.choice((1, 1, 1, 2, 2, 3, 4, random.randint(5, most)))
    precision = DIGITS[bits][0]
    return sign()*n*quarter(mc)*(1 + sign()*mpf(2)**-uniform(3, precision + 1))


def parameter_sets(bits):
    least = -37 if bits == 32 else -300
    near = (7 if bits == 32 else 15)
    return {
        'benign': lambda: (uniform(-5, 5), uniform(0, 1)),
        'hard_near1': lambda: (uniform(0, 20), (1 - power(-near, -1))**2),
        'hard_bigu': lambda: (sign()*power(1, 5), uniform(0, 1)),
        'hard_near1bigu': lambda: (power(1, 4), (1 - power(-near, -1))**2),
        'hard_tiny': lambda: (uniform(-20, 20), power(least, -1)),
        'tiny_argument': lambda: (sign()*power(least, -1), uniform(0, 1)),
        'zeros': lambda: (lambda m: (near_zero(1 - m, bits), m))(rounded(uniform(0.001, 1), bits)),
        'negative': lambda: (uniform(-10, 10), -power(-5, 5)),
        'negative_huge': lambda: (lambda m: (uniform(-10, 10)/sqrt(-m)*power(0, 2), m))(-power(5, -least)),
        'above_one': lambda: (uniform(-10, 10), 1 + power(-near, 2)),
        'above_one_huge': lambda: (lambda m: (uniform(-10, 10)/sqrt(m)*power(0, 2), m))(power(2, -least)),
        'one': lambda: (uniform(-30, 30), mpf(1)),
        'zero': lambda: (sign()*power(-3, 5), mpf(0)),
    }


def complement_sets(bits):
    least = -37 if bits == 32 else -300
    return {
        'benign': lambda: (uniform(-5, 5), uniform(0, 1)),
        'hard_mc': lambda: (uniform(-40, 40), power(least, -1)),
        'hard_mc_bigu': lambda: (sign()*power(1, 4), power(least, -1)),
        'hard_mc_zeros': lambda: (lambda mc: (near_zero(mc, bits), mc))(rounded(power(least, -0.1), bits)),
        'hard_mc_period': lambda: (lambda mc: (uniform(-3, 3)*quarter(mc), mc))(rounded(power(least, -0.1), bits)),
        'hard_bigu': lambda: (sign()*power(1, 5), uniform(0, 1)),
        'negative': lambda: (uniform(-10, 10), 1 + power(-5, 5)),
        'above_one': lambda: (uniform(-10, 10), -power(-15, 2)),
    }


PEERS = {
    'gsl': [(1703.7067095016828, 0.24274786470782336), (16373.42968684154, 0.15958304321420486)],
    'boost_nopromote': [(1.5747931053239768, 0.09961677771827965**2), (-4.754867989077538, 0.18298555651265325**2)],
    'scipy': [(333.30539372835534, 0.9999999999123277), (332.602890327389, 0.9999999999736071),
              (1355.385552855587, 0.9999999999999716), (759.5217580756549, 0.9999999999998161),
              (19.853928508493826, 0.9999999999244704), (19.912200282576563, 0.999999999933068),
              (55.07, 1 - 1.75e-11), (26.0, 1 - 1e-11)],
}
COMPLEMENT_PEERS = {
    'fukushima': [(39.584176159672054, 1.8941196229458596e-188), (39.83012049274719, 3.285998347043308e-207),
                  (39.941841711391554, 4.713816030938924e-202), (39.476246905177966, 8.018453608538717e-68),
                  (5.58657936497883, 0.06278029248854426)],
}


def write(name, sets, peers, complementary, counts):
    with open(name + '.dat', 'w') as out:
        out.write(f'# Written by make_jacobi.py. u {"1-m" if complementary else "m"} -> sn cn dn am\ncolumns 2 4\n')
        for bits, count in counts.items():
            random.seed(22 + bits)
            for set_name, draw in sets(bits).items():
                for i in range(count):
                    mp.dps = 50
                    u, parameter = (rounded(x, bits) for x in draw())
                    out.write(row(set_name, bits, u, parameter, complementary, i % 20 == 0) + '\n')
        for peer, inputs in peers.items():
            for u, parameter in inputs:
                out.write(row(peer, 64, mpf(u), mpf(parameter), complementary, False) + '\n')


if __name__ == '__main__':
    counts = {32: 40, 64: 120, 128: 40}
    write('jacobi', parameter_sets, PEERS, False, counts)
    write('jacobic', complement_sets, COMPLEMENT_PEERS, True, counts)
