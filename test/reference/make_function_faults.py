#!/usr/bin/env python3
"""The values of test/unit/test_function_faults.pf, by Arb and mpmath at the exact binary arguments; printed."""
from fractions import Fraction

import flint
from flint import acb, arb
from mpmath import mp

import make_bulirsch

flint.ctx.prec = 6000
mp.prec = 6000


def a(x):
    f = Fraction(x)
    return arb(flint.fmpq(f.numerator, f.denominator))


def quad(text):
    """The number of real128 nearest to a decimal."""
    from legendre_reference import rounded
    f = rounded(Fraction(text), 128)
    return arb(flint.fmpq(f.numerator, f.denominator))


def single(text):
    """The number of real32 nearest to a decimal."""
    from legendre_reference import rounded
    return rounded(Fraction(text), 32)


def show(name, value):
    print(name, value.str(36, radius=False))


def pi_inc(n, phi, m):
    return acb.elliptic_pi_inc(acb(a(n)), acb(a(phi)), acb(a(m))).real


def rj_negative(x, y, z, q):
    x, y, z = sorted((a(x), a(y), a(z)), key=lambda v: v.mid())
    q = a(q)
    other = (z*(x + y + q) - x*y)/(z + q)
    value = (other - z)*acb.elliptic_rj(x, y, z, other).real - 3*acb.elliptic_rf(x, y, z).real
    if x > 0:
        s, t = x*y + other*q, other*q
        rc = acb.elliptic_rc(s, t).real
        value += 3*(x*y*z/s).sqrt()*rc
    return value/(z + q)


def complete(mc):
    m = 1 - mc
    k, e = acb(m).elliptic_k().real, acb(m).elliptic_e().real
    return (k - e)/m, k - (k - e)/m


def theta(i, v, q):
    """By its series in q."""
    total = arb(0)
    q = a(q)
    for n in range(0, 400):
        if i == 1:
            total += 2*(-1)**n*(q.log()*(a(n) + a(0.5))**2).exp()*((2*n + 1)*v).sin()
    return total


show('FAULT_PIINC', pi_inc(1.5, 1e40, 1e-20))
show('FAULT_PIINC_2', pi_inc(3.0, 1e30, -1e-25))
show('FAULT_BC', complete(quad('16.09366971760072299356027900162480851370'))[1])
show('FAULT_DC', complete(quad('0.06173632424734089162499030478783734516825'))[0])
show('FAULT_RJ', rj_negative(1.5, 3.0, 1e130, 1.99))
show('FAULT_RJ_2', rj_negative(1.5, 3.0, 1e230, 1.99))
show('FAULT_RJ_3', rj_negative(5e-324, 0.0, 1.270196509085502e240, 5e-324))
show('FAULT_RJ_4', rj_negative(0.0, 1e-305, 2e148, 1e234))
show('FAULT_RJ_5', rj_negative(1e-306, 1e-304, 1e20, 1e298))
show('FAULT_RJ_6', rj_negative(1e-233, 0.0, 1e-205, 2e-16))
show('FAULT_RJ_7', rj_negative(*map(single, ('2.42698819874e-26', '5.27242519946e-26', '0', '7.76962355950e-26'))))
show('FAULT_RJ_8', rj_negative(7.376726597650134e186, 7.3767249426479424e186, 7.3767256363859748e186, 5.434722104253712e-322))
show('FAULT_RJ_9', rj_negative(8.674e307, 0.0, 9.181e-318, 9.181e-318))
show('FAULT_RJ_10', rj_negative(*map(single, ('5.9930610656738281', '11521064', '7.1597394406657901e28', '5.9794793128967285'))))
show('FAULT_PI', acb.elliptic_pi(acb(a(-1e308)), acb(a(-1e308))).real)
show('FAULT_EINC', acb.elliptic_e_inc(acb(a(4e307)), acb(a(0.9999999999999999))).real)
show('FAULT_PIINC_3', pi_inc(-1e308, 1.0, -1e308))
show('FAULT_PIINC_4', pi_inc(1.5, 1.0, -1.7e308))
# 2 N times the complete integral and a rest that is less than it, Pi(n) = K - Pi(m/n)
n, phi, m = a(7.7592607015165089e258), a(-3.6127151104460792e244), a(-1.0791389499932062e-162)
turns = (phi/arb.pi()).floor() + 1
print('FAULT_PIINC_5 about', 2*turns*(acb(m).elliptic_k().real - acb.elliptic_pi(acb(m/n), acb(m)).real))
# u so small that Z = u (1 - E/K) to all digits
m = a(-1e300)
show('FAULT_ZETA', a(1e-323)*(1 - acb(m).elliptic_e().real/acb(m).elliptic_k().real))
q = a(0.99667)
show('FAULT_THETA_1', 1 + 2*sum(((-1)**n*q**(n*n) for n in range(1, 1200)), arb(0)))
# theta_4(i y, q) = 1 + 2 sum (-1)^n q^(n^2) cosh(2 n y)
y, q = a(549.759118215523), a(6.736470133691432e-160)
show('FAULT_THETA', 1 + 2*sum(((-1)**n*(q.log()*n*n).exp()*(2*n*y).cosh() for n in range(1, 40)), arb(0)))
show('FAULT_RC', arb.pi()/2/a(1e-293).sqrt())
show('FAULT_RC_2', arb.pi()/2/a(1e-300).sqrt())
show('FAULT_RC_3', arb.pi()/2/a(5e-324).sqrt())
show('FAULT_THETA_LARGE', theta(1, a(1e22), 0.25))
show('FAULT_F', acb.elliptic_f(acb(a(0.02900929685633258)), acb(a(1188.6320168864793))).real)


def far():
    """Jacobi's functions far out, at the exact parameter."""
    import function_campaign as campaign
    from legendre_reference import rounded
    for bits, u, m, is_complement in ((64, 2**60, 0.3, False), (64, 1e20, -7.5, False), (64, 3e25, 2.25, False), (64, 1e18, 1e-5, True),
                                      (32, '1e9', '0.3', False), (128, 2**150, '0.7', False)):
        u, m = rounded(Fraction(u), bits), rounded(Fraction(m), bits)
        m = 1 - m if is_complement else m
        values = campaign.proved(campaign.jacobi, [u, m], bits)
        flint.ctx.prec = 6000
        for name, v in zip(('sn', 'cn', 'dn', 'am'), values):
            show(f'FAR {bits} {name}', arb(flint.fmpq(v.numerator, v.denominator)))
    v = campaign.proved(campaign.zeta, [Fraction(10**15), Fraction(0.9)], 64)[0]
    show('FAR_ZETA', arb(flint.fmpq(v.numerator, v.denominator)))


far()
f = Fraction
show('FAULT_CEL', make_bulirsch.cel(f(0.5), f(1e-232), f(1.0), f(1e100))[0])
show('FAULT_CEL_2', make_bulirsch.cel(f(3.11e-52), f(-3.6), f(1.94e-51), f(4.53e306))[0])
show('FAULT_CEL_3', make_bulirsch.cel(f(3.67e307), f(0.2), f(0.3), f(1.33e307))[0])
show('FAULT_CEL_4', make_bulirsch.cel(f(2.4e140), f(-2.5e140), f(2.159e233), f(2.16e233))[0])
show('FAULT_EL2', make_bulirsch.el2(f(13.9), f(0.11), f(4.64e304), f(-8.36e307))[0])
show('FAULT_EL2_2', make_bulirsch.el2(f(0.62), f(1.66e307), f(-1.76e-12), f(8.34e-12))[0])
# sn(u, m) = sn(u k, 1/m)/k, the sine over k to 38 digits
k = a(1e38).sqrt()
show('FAULT_JACOBI', (a(1e3)*k).sin()/k)
k = a(1e30).sqrt()
show('FAULT_JACOBI_2', (a(1e6)*k).sin()/k)
