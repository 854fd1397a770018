"""Reference values of test/interfaces/test_f77_functions.f, from mpmath at 50 digits: one a routine, at exact arguments.

    python3 make_f77_functions.py
"""
from mpmath import (asin, ellipe, ellipf, ellipfun, ellipk, ellippi, elliprc, elliprd, elliprf, elliprg, elliprj,
                    exp, inf, jtheta, mp, mpf, pi, quad, sqrt)

mp.dps = 50
phi, u, m, n = mpf("1.25"), mpf("0.75"), mpf("0.375"), mpf("0.4375")
mc = mpf(2)**-40                                     # 1 - m that m itself would round
x, y, z, p = mpf("0.5"), mpf("1.25"), mpf("2"), mpf("3")
kc, a, b, t = mpf("0.625"), mpf("1.5"), mpf("0.25"), mpf("1.75")   # of Bulirsch's functions; t = tan(phi)


def am(u, m):
    return asin(ellipfun("sn", u, m=m))              # |u| < K


def zeta(u, m):
    return ellipe(am(u, m), m) - u*ellipe(m)/ellipk(m)


def heuman(phi, m):
    return 2/pi*(ellipe(m)*ellipf(phi, 1 - m) + ellipk(m)*(ellipe(phi, 1 - m) - ellipf(phi, 1 - m)))


def d(phi, m):
    return (ellipf(phi, m) - ellipe(phi, m))/m


def nome(m):
    return exp(-pi*ellipk(1 - m)/ellipk(m))


def of_parameter(f):
    return [f(m), f(1 - mc)]


def bulirsch(weight, upper):
    return quad(lambda s: weight(s)/sqrt((1 + s*s)*(1 + kc*kc*s*s)), [0, 1, upper])


K, E = ellipk, ellipe
values = [
    ("K", *of_parameter(K)), ("E", *of_parameter(E)),
    ("D", *of_parameter(lambda m: (K(m) - E(m))/m)), ("B", *of_parameter(lambda m: K(m) - (K(m) - E(m))/m)),
    ("Pi", *of_parameter(lambda m: ellippi(n, m))),
    ("F", *of_parameter(lambda m: ellipf(phi, m))), ("incomplete E", *of_parameter(lambda m: ellipe(phi, m))),
    ("incomplete D", *of_parameter(lambda m: d(phi, m))),
    ("incomplete B", *of_parameter(lambda m: ellipf(phi, m) - d(phi, m))),
    ("incomplete Pi", *of_parameter(lambda m: ellippi(n, phi, m))),
    ("RC", elliprc(x, y)), ("RF", elliprf(x, y, z)), ("RD", elliprd(x, y, z)), ("RG", elliprg(x, y, z)),
    ("RJ", elliprj(x, y, z, p)),
    ("zeta", *of_parameter(lambda m: zeta(u, m))), ("Heuman", *of_parameter(lambda m: heuman(phi, m))),
    ("nome", *of_parameter(nome)),
    ("theta_2, its derivative", jtheta(2, phi, n/2), jtheta(2, phi, n/2, 1)),
    ("sn", *of_parameter(lambda m: ellipfun("sn", u, m=m))), ("cn", *of_parameter(lambda m: ellipfun("cn", u, m=m))),
    ("dn", *of_parameter(lambda m: ellipfun("dn", u, m=m))), ("am", *of_parameter(lambda m: am(u, m))),
    ("cel", bulirsch(lambda s: (a + b*s*s)/(1 + p*s*s), inf)),
    ("el1, el2, el3", bulirsch(lambda s: 1, t), bulirsch(lambda s: (a + b*s*s)/(1 + s*s), t),
     bulirsch(lambda s: (1 + s*s)/(1 + p*s*s), t)),
]
for name, *numbers in values:
    print(name, *(mp.nstr(v, 20) for v in numbers))
