#!/usr/bin/env python3
"""Writes theta.dat (i, v, q -> theta, its derivative) and theta_complex.dat (i, Re v, Im v, q -> Re and Im of both).

The defining series (DLMF 20.2) with digits to spare for their cancellation; for q next to 1 the sum of Gaussians of
DLMF 20.7.30 to 20.7.33 in plain form. Every tenth row is compared with Arb's theta functions.
Conditions follow from the heat equation, dtheta/dq = -theta''/(4 q); for complex values they are in ulps of the
modulus."""
import random
import flint
from mpmath import mp, mpf, mpc, exp, log, pi, sqrt, frexp, ldexp, nint, nstr, ceil
from make_jacobi import DIGITS, rounded, spacing, uniform, power, sign


def theta(index, z, q):
    """theta and its first three derivatives along z."""
    if q == 0:
        return [mpf(index > 2)] + [mpf(0)]*3
    decay = -log(q)
    total = [mpc(0)]*4
    half = index in (1, 2)
    if decay > 0.05:
        most = int(sqrt(mp.dps*2.4/decay + (z.imag/decay)**2) + abs(z.imag)/decay) + 5
        for n in range(-most, most + 1):
            frequency = 2*n + 1 if half else 2*n
            term = exp(1j*frequency*z - decay*mpf(frequency)**2/4)
            if index == 1:
                term *= -1j*(-1)**n
            elif index == 4:
                term *= (-1)**n
            for order in range(4):
                total[order] += term*(1j*frequency)**order
        return total
    half = index in (1, 4)
    middle = int(nint(z.real/pi))
    most = int(sqrt(mp.dps*2.4*decay)) + 3
    for n in range(middle - most, middle + most + 1):
        y = z - (n + (mpf(1)/2 if half else 0))*pi
        term = sqrt(pi/decay)*exp(-y*y/decay)
        if index <= 2:
            term *= (-1)**n
        slopes = [1, -2*y/decay, 4*y*y/decay**2 - 2/decay, -8*y**3/decay**3 + 12*y/decay**2]
        for order in range(4):
            total[order] += term*slopes[order]
    return total


def compare_with_arb(index, z, q, value):
    flint.ctx.prec = int(mp.dps*3.4) + 2000
    digits = int(flint.ctx.prec/3.4)
    with mp.workdps(digits):
        def ball(x):
            mantissa, exponent = int(x.man), int(x.exp)
            return flint.arb(mantissa*(-1 if x < 0 and mantissa > 0 else 1))*flint.arb(2)**exponent
        tau = flint.acb(0, -ball(q).log()/flint.arb.pi())
        zeta = flint.acb(ball(z.real), ball(z.imag))/flint.arb.pi()
        other = flint.acb.modular_theta(zeta, tau)[index - 1]
        real, imag = (mpf(part.mid().str(80, radius=False)) for part in (other.real, other.imag))
    assert abs(value - mpc(real, imag)) <= mpf(10)**-45*abs(value), (index, z, q, value, real, imag)


def row(name, bits, index, z, q, is_complex, check):
    mp.dps = 60
    z = mpc(z)
    decay = -log(q) if q > 0 else mpf(1000)
    mp.dps = 90 + int(5/max(decay, mpf('0.05'))) + 2*int(mp.log10(abs(z) + 1))
    mp.dps += int(abs(z.imag)*2/decay + abs(z.imag)**2/decay/2)
    if 0 < decay < 1e-3:
        mp.dps += int(-2*mp.log10(decay))
    values = theta(index, z, q)
    if z == 0:  # The odd derivatives, of theta_1 the even ones, vanish by symmetry.
        values = [v if (order + (index == 1)) % 2 == 0 else mpc(0) for order, v in enumerate(values)]
    if check and q > 0 and decay > 1e-8 and values[0] != 0:
        compare_with_arb(index, z, q, values[0])
    if not is_complex:
        values = [v.real for v in values]
    half_z = spacing(z.real, bits)/2 + spacing(z.imag, bits)/2
    half_q = spacing(q, bits)/2
    conditions = []
    for order in (0, 1):
        if values[order] == 0:
            conditions.append(mpf(0))
            continue
        change = abs(values[order + 1])*half_z + (abs(values[order + 2])/(4*q)*half_q if q > 0 else 0)
        conditions.append(change/spacing(abs(values[order]), bits))
    digits = DIGITS[bits][2]
    head = [name, str(bits), str(index)]
    if is_complex:
        parts = [x for v in values[:2] for x in (v.real, v.imag)]
        if any(abs(v) > mpf(10)**(30 if bits == 32 else 300) for v in values[:2]):
            return None
        if any(0 < abs(v) < mpf(10)**(-30 if bits == 32 else -290) for v in values[:2]):
            return None
        head += [nstr(z.real, digits), nstr(z.imag, digits), nstr(q, digits)]
        conditions = [conditions[0]]*2 + [conditions[1]]*2
    else:
        parts = values[:2]
        if any(0 < abs(v) < mpf(10)**(-36 if bits == 32 else -290) for v in parts):
            return None
        head += [nstr(z.real, digits), nstr(q, digits)]
    return ' '.join(head + [nstr(x, 40) for x in parts] + [nstr(x, 4) for x in conditions])


def real_sets(bits):
    precision = DIGITS[bits][0]
    least = -30 if bits == 32 else -300
    zero = lambda: random.randint(-6, 6)*pi/2*(1 + sign()*mpf(2)**-uniform(2, precision + 1))
    return {
        'benign': lambda: (uniform(-4, 4), uniform(0, 0.9)),
        'tiny_nome': lambda: (uniform(-4, 4), power(least, -2)),
        'near_switch': lambda: (uniform(-4, 4), exp(-2)*(1 + sign()*power(-6, -1))),
        'near_one': lambda: (uniform(-4, 4), 1 - power(-3, -1)),
        'next_to_one': lambda: (random.randint(-3, 3)*pi/2 + sign()*power(-9, -6),
                                1 - power(-7 if bits == 32 else -12, -3)),
        'zeros': lambda: (zero(), uniform(0, 0.95)),
        'hard_bigv': lambda: (sign()*power(1, 5), uniform(0, 0.9)),
        'tiny_argument': lambda: (sign()*power(-30, -2), uniform(0, 0.98)),
        'zero_nome': lambda: (uniform(-4, 4), mpf(0)),
    }


def complex_sets(bits):
    most = 60 if bits == 32 else 500

    def wide():
        q = uniform(0.001, 0.95)
        return mpc(uniform(-10, 10), sign()*sqrt(uniform(0, most)*-log(q))), q

    def tiny():
        q = power(-20 if bits == 32 else -200, -2)
        return mpc(uniform(-4, 4), sign()*sqrt(uniform(0, most)*-log(q))), q

    def zeros():
        q = rounded(uniform(0.01, 0.9), bits)
        z = random.randint(-2, 2)*pi/2 - 1j*random.randint(-2, 2)*log(q)/2
        return z*(1 + sign()*power(-DIGITS[bits][2]/2, -1)), q
    return {
        'benign': lambda: (mpc(uniform(-4, 4), uniform(-1, 1)), uniform(0, 0.9)),
        'wide': wide,
        'tiny_nome': tiny,
        'near_one': lambda: (mpc(uniform(-1, 1), uniform(-1, 1)), 1 - power(-2, -1)),
        'zeros': zeros,
        'zero_nome': lambda: (mpc(uniform(-4, 4), uniform(-4, 4)), mpf(0)),
    }


def write(name, sets, is_complex, counts):
    with open(name + '.dat', 'w') as out:
        out.write(f'# Written by make_theta.py. i {"Re(v) Im(v)" if is_complex else "v"} q -> theta_i, d theta_i/dv\n')
        out.write('columns 4 4\n' if is_complex else 'columns 3 2\n')
        for bits, count in counts.items():
            random.seed(20 + bits)
            for set_name, draw in sets(bits).items():
                done = 0
                while done < count:
                    mp.dps = 50
                    z, q = draw()
                    q = rounded(q, bits)
                    if q >= 1:
                        continue
                    z = mpc(rounded(mpc(z).real, bits), rounded(mpc(z).imag, bits))
                    line = row(set_name, bits, done % 4 + 1, z, q, is_complex, done % 10 < 2)
                    if line is not None:
                        out.write(line + '\n')
                        done += 1


if __name__ == '__main__':
    write('theta', real_sets, False, {32: 40, 64: 160, 128: 40})
    write('theta_complex', complex_sets, True, {32: 40, 64: 120, 128: 40})
