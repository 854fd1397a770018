#!/usr/bin/env python3
"""The promises of the elliptic functions against Arb in many more arguments than the .dat files hold: the worst error of every
function and set, in ulps; fails if one breaks its promise (that of test/study/promises.f90).

    function_campaign.py FUNCTION_VALUES [SINGLE DOUBLE QUAD [QUESTION...]]

takes the program function_values, SINGLE, DOUBLE, QUAD rows a function and set (20000, 2000, 2000; 0 leaves a kind out), and the
questions named (all). Needs python-flint and mpmath: without them the status is 77, which ctest takes for a test that was skipped.
The sets are those of the make_*.py beside this file. The condition of a row is computed only where the error exceeds the promise
without it.
"""
import random
import subprocess
import sys
from fractions import Fraction

try:
    import flint
    from flint import acb, arb
    import mpmath
except ImportError:
    print('no python-flint or no mpmath: nothing is compared')
    sys.exit(77)

import make_bulirsch
import make_carlson
import make_complete
import make_incomplete
import make_jacobi
import make_theta
from legendre_reference import DIGITS, MIN_EXPONENT, decimal, exponent, mid_fraction, rounded, to_arb, ulp

MAX_EXPONENT = {32: 127, 64: 1023, 128: 16383}
PRINTED = {32: 12, 64: 20, 128: 40}


def exact(x):
    """An mpf as a Fraction."""
    sign, mantissa, e, _ = mpmath.mpf(x)._mpf_
    return Fraction(-int(mantissa) if sign else int(mantissa))*Fraction(2)**int(e)


def complementary(function, position):
    """The function of 1 - m from that of m, m the argument of that number."""
    def taken(*arguments):
        arguments = list(arguments)
        arguments[position] = 1 - arguments[position]
        return function(*arguments)
    return taken


# The functions that no make_*.py computes by Arb; those of make_jacobi.py and make_theta.py compute by mpmath, slowly.

def landen(u, m):
    """sn, cn, dn, am and Z for m < 1, by the arithmetic-geometric mean (DLMF 22.20(ii), 22.16.32)."""
    a, b = arb(1), to_arb(1 - m).sqrt()
    ladder = []
    while not (ladder and abs(ladder[-1][1]) <= arb(2)**(-flint.ctx.prec)):
        a, b, c = (a + b)/2, (a*b).sqrt(), (a - b)/2
        ladder.append((c, c/a))
        if c.contains(0):
            break
    phi, zeta = a*to_arb(u)*2**len(ladder), arb(0)
    for c, ratio in reversed(ladder):
        sine = phi.sin()
        zeta += c*sine
        phi = (phi + (ratio*sine).asin())/2
    sn, cn = phi.sin(), phi.cos()
    return sn, cn, (cn*cn + to_arb(1 - m)*sn*sn).sqrt(), phi, zeta


def jacobi(u, m):
    if m < 1:
        return landen(u, m)[:4]
    if m == 1:
        x = to_arb(u)
        return x.tanh(), 1/x.cosh(), 1/x.cosh(), x.sinh().atan()
    # The modulus above 1: sn, cn, dn of (u, m) are k1 sn, dn, cn of (u k, 1/m), DLMF 22.17.2; k is no Fraction.
    k = to_arb(m).sqrt()
    a, b = arb(1), to_arb(1 - 1/m).sqrt()
    ladder = []
    while not (ladder and abs(ladder[-1]) <= arb(2)**(-flint.ctx.prec)):
        a, b, c = (a + b)/2, (a*b).sqrt(), (a - b)/2
        ladder.append(c/a)
        if c.contains(0):
            break
    phi = a*to_arb(u)*k*2**len(ladder)
    for ratio in reversed(ladder):
        phi = (phi + (ratio*phi.sin()).asin())/2
    sn, dn = phi.sin()/k, phi.cos()
    cn = (dn*dn + to_arb(1 - 1/m)*phi.sin()**2).sqrt()
    return sn, cn, dn, arb.atan2(sn, cn)


def ratios(u, m):
    sn, cn, dn = jacobi(u, m)[:3]
    return 1/sn, 1/cn, 1/dn, sn/cn, cn/sn, sn/dn, dn/sn, cn/dn, dn/cn


def zeta(u, m):
    if m == 1:
        return [to_arb(u).tanh()]
    return [landen(u, m)[4]]


def theta(index, v, q):
    if q == 0:
        return [arb(index > 2), arb(0)]
    x, tau = acb(to_arb(v)/arb.pi()), acb(0, -to_arb(q).log()/arb.pi())
    value, slope = [acb.modular_theta(x, tau, order)[int(index) - 1].real for order in (0, 1)]
    if v == 0 and index == 1:
        value = arb(0)
    return [value, arb(0) if v == 0 and index > 1 else slope/arb.pi()]


def carlson(function):
    return lambda *arguments: [function(*[to_arb(a) for a in arguments])]


# The sets: generators of the set's name and the arguments, without end or with `count` of every set.

def carlson_sets(name):
    def drawn(bits, count):
        random.seed(1953 + bits)
        kind = make_carlson.Kind(bits)
        for set_name, make in make_carlson.sets(name, make_carlson.FUNCTIONS[name][0], kind):
            for _ in range(count):
                yield set_name, [exact(a) for a in make()]
    return drawn


def jacobi_sets(sets):
    def drawn(bits, count):
        random.seed(22 + bits)
        mpmath.mp.dps = 50
        for set_name, draw in sets(bits).items():
            for _ in range(count):
                yield set_name, [exact(a) for a in draw()]
    return drawn


def theta_sets(bits, count):
    random.seed(20 + bits)
    mpmath.mp.dps = 50
    for set_name, draw in make_theta.real_sets(bits).items():
        for i in range(count):
            v, q = draw()
            q = rounded(exact(q), bits)
            if q < 1:
                yield set_name, [Fraction(i % 4 + 1), exact(v), q]


def complete_sets(generator):
    """The generators of make_complete.py yield a fixed number of rows."""
    def drawn(bits, count):
        r = random.Random(1859 + bits)
        for _ in range(count):
            yield from ((name, [m]) for name, m in generator(bits, r))
    return drawn


def pair_sets(generator):
    def drawn(bits, count):
        for name, *arguments in generator(bits, random.Random(1859 + bits), count):
            yield name, arguments
    return drawn


def incomplete_sets(bits, r, count):
    yield from make_incomplete.amplitudes(bits, r, count)
    yield from make_incomplete.above_one(bits, r, count)


def third_kind_sets(generator):
    """More than four times as many: a quarter of them has each kind of n."""
    def drawn(bits, count):
        r = random.Random(1860 + bits)
        for name, *arguments in make_incomplete.third_kind(generator(bits, r, 6*count), bits, r):
            yield name, arguments
    return drawn


def below_one(bits, r, count):
    return (row for row in make_incomplete.amplitudes(bits, r, count) if row[2] <= 1)


def between(bits, r, count):
    return (row for row in make_incomplete.amplitudes(bits, r, count) if 0 <= row[2] <= 1)


def longer(bits, r, count):
    for name, u, x in make_incomplete.amplitudes_c(bits, r, count):
        yield name, u if name == 'tiny_large' else u*make_incomplete.power_of_ten(r.uniform(0, 2)), x


def bulirsch_sets(name):
    def drawn(bits, count):
        for function, set_name, arguments in make_bulirsch.questions(bits, random.Random(1860 + bits), count):
            if function == name:
                yield set_name, arguments
    return drawn


# (question: a reference file's name, its sets, its reference, number of results)
def questions():
    for name, (_, function) in make_carlson.FUNCTIONS.items():
        yield 'carlson_' + name, carlson_sets(name), carlson(function), 1
    m, i = make_complete, make_incomplete
    yield 'complete', complete_sets(m.parameters), m.complete, 4
    yield 'complete_c', complete_sets(m.complements), complementary(m.complete, 0), 4
    yield 'nome', complete_sets(m.parameters), m.nome, 1
    yield 'nome_c', complete_sets(m.complements), complementary(m.nome, 0), 1
    yield 'complete_pi', pair_sets(i.third_kind_pairs), i.complete_pi, 1
    yield 'complete_pi_c', pair_sets(i.third_kind_pairs_c), complementary(i.complete_pi, 1), 1
    yield 'incomplete', pair_sets(incomplete_sets), i.incomplete, 4
    yield 'incomplete_c', pair_sets(i.amplitudes_c), complementary(i.incomplete, 1), 4
    yield 'incomplete_pi', third_kind_sets(incomplete_sets), i.incomplete_pi, 1
    yield 'incomplete_pi_c', third_kind_sets(i.amplitudes_c), complementary(i.incomplete_pi, 2), 1
    for name, (_, function) in make_bulirsch.FUNCTIONS.items():
        yield 'bulirsch_' + name, bulirsch_sets(name), function, 1
    yield 'zeta', pair_sets(below_one), zeta, 1
    yield 'zeta_c', pair_sets(longer), complementary(zeta, 1), 1
    yield 'lambda', pair_sets(between), i.heuman, 1
    yield 'lambda_c', pair_sets(longer), complementary(i.heuman, 1), 1
    yield 'jacobi', jacobi_sets(make_jacobi.parameter_sets), jacobi, 4
    yield 'jacobic', jacobi_sets(make_jacobi.complement_sets), complementary(jacobi, 1), 4
    yield 'ratios', jacobi_sets(make_jacobi.parameter_sets), ratios, 9
    yield 'ratiosc', jacobi_sets(make_jacobi.complement_sets), complementary(ratios, 1), 9
    yield 'theta', theta_sets, theta, 2


def proved(function, arguments, bits):
    """The results as Fractions, or 'Infinity'; None where Arb has no proof of 150 bits at any precision that is tried. What is proved
    to underflow is an eighth of the least number."""
    least = Fraction(2)**(MIN_EXPONENT[bits] - 3)
    flint.ctx.prec = 300
    while flint.ctx.prec < 200000:
        results = function(*arguments)
        found = [v if isinstance(v, str) else least if v.is_finite() and v.rad() > 0 and abs(v) < to_arb(least)
                 else mid_fraction(v) if v.is_finite() and (v.rad() == 0 or v.rel_accuracy_bits() > 150) else None for v in results]
        if None not in found:
            return found
        flint.ctx.prec = 2*flint.ctx.prec
    return None


def conditions(function, arguments, values, bits):
    """In ulps, how far half an ulp of every argument moves each result; infinite where that reaches beyond a pole."""
    total = [0.0]*len(values)
    for i, a in enumerate(arguments):
        if a == 0:
            continue
        change = [0.0]*len(values)
        for sign in (1, -1):
            moved = list(arguments)
            moved[i] = a + sign*ulp(a, bits)/2
            try:
                others = proved(function, moved, bits)
            except (ValueError, AssertionError, ZeroDivisionError, IndexError):
                continue
            for j, (value, other) in enumerate(zip(values, others or [])):
                if not isinstance(value, str) and not isinstance(other, str) and value != 0:
                    change[j] = max(change[j], quotient(abs(other - value), ulp(value, bits)))
                    if value*other < 0 and min(abs(value), abs(other)) > 2**(DIGITS[bits]//2):
                        change[j] = float('inf')
        total = [t + c for t, c in zip(total, change)]
    return total


def quotient(a, b):
    try:
        return float(a/b)
    except OverflowError:
        return float('inf')


def difference(answer, value, bits):
    """Between an answer as text and the true value, in ulps."""
    if not isinstance(value, str) and value != 0 and exponent(value) > MAX_EXPONENT[bits]:
        value = 'Infinity' if value > 0 else '-Infinity'
    if isinstance(value, str) or 'N' in answer or 'I' in answer:
        return 0.0 if answer == value else float('inf')
    answer = rounded(Fraction(answer), bits)
    if value == 0:
        return 0.0 if answer == 0 else float('inf')
    return quotient(abs(answer - value), ulp(value, bits))


def answers(program, question, bits, parts, rows):
    """For each row the parts (promise, slack, answer)."""
    lines = ''.join(' '.join([name] + ['0' if a == 0 else decimal(a, PRINTED[bits]) for a in row]) + '\n' for name, row in rows)
    run = subprocess.run([program, question, str(bits), str(parts), str(len(rows[0][1]))], input=lines, capture_output=True,
                         text=True, check=True)
    found = [(float(promise), float(slack), answer) for promise, slack, answer in map(str.split, run.stdout.splitlines())]
    assert len(found) == parts*len(rows)
    return [found[i:i + parts] for i in range(0, len(found), parts)]


def main():
    program = sys.argv[1]
    counts = dict(zip((32, 64, 128), [int(word) for word in sys.argv[2:5]] or [20000, 2000, 2000]))
    broken = asked = unproved = 0
    for question, sets, function, parts in questions():
        if sys.argv[5:] and question not in sys.argv[5:]:
            continue
        for bits, count in counts.items():
            if count == 0:
                continue
            taken, rows = {}, []
            for name, arguments in sets(bits, count):
                if name == 'special':
                    continue
                if taken.get(name, 0) >= count:
                    if min(taken.values()) >= count:
                        break
                    continue
                taken[name] = taken.get(name, 0) + 1
                rows.append((name, [rounded(a, bits) for a in arguments]))
            assert min(taken.values()) >= count*9/10, (question, bits, taken)
            worst = {}
            for (name, row), found in zip(rows, answers(program, question, bits, parts, rows)):
                values = proved(function, row, bits)
                asked += 1
                if values is None:
                    unproved += 1
                    print(f'{question} {bits} {name}: no reference: ' + ' '.join(decimal(a, PRINTED[bits]) for a in row), flush=True)
                    continue
                errors = [difference(answer, value, bits) for (_, _, answer), value in zip(found, values)]
                if any(error > promise and slack > 0 for error, (promise, slack, _) in zip(errors, found)):
                    errors = [error - slack*change if error > promise else error for error, (promise, slack, _), change
                              in zip(errors, found, conditions(function, row, values, bits))]
                for part, (error, (promise, slack, _)) in enumerate(zip(errors, found)):
                    if error > worst.get((name, part), (-1.0,))[0]:
                        worst[name, part] = (error, promise, slack, row)
            for (name, part), (error, promise, slack, row) in sorted(worst.items()):
                if error > promise:
                    broken += 1
                    print(f'{question} {bits} {name}, result {part + 1}: {error:.2f} ulp'
                          + (f' beyond {slack:g} conditions' if slack > 0 else '') + f', {promise:g} promised: '
                          + ' '.join(decimal(a, PRINTED[bits]) for a in row), flush=True)
            most = max(worst.values())
            print(f'{question} {bits}: {len(rows)} rows, at most {most[0]:.2f} of {most[1]:g} ulp', flush=True)
    print(f'{asked} rows, {unproved} without a reference, {broken} promises broken')
    sys.exit(broken + unproved > 0)


if __name__ == '__main__':
    main()
