#!/usr/bin/env python3
"""The promises of the elliptic functions against Arb in many more arguments than the .dat files hold: the worst error of every
function and set, in ulps; fails if one breaks its promise (that of test/study/promises.f90).

    function_campaign.py PROGRAM [SINGLE DOUBLE QUAD [NAME...]]

takes PROGRAM eval, SINGLE, DOUBLE, QUAD rows a function and set (20000, 2000, 2000), and the functions named (all). Needs
python-flint: without it the status is 77, which ctest takes for a test that was skipped. The condition of a row is computed only
where the error exceeds the promise without it.
"""
import random
import subprocess
import sys
from fractions import Fraction

try:
    import flint
except ImportError:
    print('no python-flint: nothing is compared')
    sys.exit(77)

import make_complete
import make_incomplete
from legendre_reference import DIGITS, bits_for, mid_fraction, rounded, to_arb, ulp

KIND = {32: 'single', 64: 'double', 128: 'quad'}


def of_complement(function, place):
    """The function of 1 - m from that of m, m the argument number `place`."""
    def taken(*arguments):
        arguments = list(arguments)
        arguments[place] = 1 - arguments[place]
        return function(*arguments)
    return taken


def pair_sets(bits, r, count):
    for name, phi, m in make_incomplete.amplitudes(bits, r, count):
        yield name, phi, m


# name of eval: (sets, reference, which of its results, promise in ulp, share of the condition)
def questions():
    for part, (name, promise) in enumerate((('K', 4), ('E', 4), ('D', 4), ('B', 4))):
        yield name, make_complete.parameters, make_complete.complete, part, promise, 0
        yield name + 'c', make_complete.complements, of_complement(make_complete.complete, 0), part, promise, 0
    yield 'nome', make_complete.parameters, make_complete.nome, 0, 6, 0
    yield 'nomec', make_complete.complements, of_complement(make_complete.nome, 0), 0, 6, 0
    yield 'Pi', make_incomplete.third_kind_pairs, make_incomplete.complete_pi, 0, 8, 4
    yield 'Pic', make_incomplete.third_kind_pairs_c, of_complement(make_incomplete.complete_pi, 1), 0, 8, 4
    for part, name in enumerate(('F', 'Einc', 'Dinc', 'Binc')):
        yield name, pair_sets, make_incomplete.incomplete, part, 8, 4
        yield name + 'c', make_incomplete.amplitudes_c, of_complement(make_incomplete.incomplete, 1), part, 8, 4


def sets(generator, bits, count):
    """The rows of every set, at most `count` each, the arguments as the kind holds them."""
    r = random.Random(1859 + bits)
    try:
        rows = list(generator(bits, r, count))
    except TypeError:
        rows, kept = [], 0
        while kept < count:
            rows += [row for row in generator(bits, r) if row[0] != 'special']
            kept = sum(row[0] == rows[0][0] for row in rows)
    found = {}
    for name, *arguments in rows:
        found.setdefault(name, []).append([rounded(a, bits) for a in arguments])
    return {name: some[:count] for name, some in found.items()}


def decimal(x, bits):
    digits = {32: 12, 64: 20, 128: 40}[bits]
    if x == 0:
        return '0'
    flint.ctx.prec = 400
    return to_arb(x).str(digits, radius=False)


def answers(program, bits, name, rows):
    lines = '\n'.join(' '.join([name] + [decimal(a, bits) for a in row]) for row in rows) + '\n'
    run = subprocess.run([program, 'eval', '--kind', KIND[bits]], input=lines, capture_output=True, text=True, check=False)
    return run.stdout.splitlines()


def condition(function, part, arguments, value, bits):
    """In ulps, how far half an ulp of every argument moves the result."""
    total = 0
    for i, a in enumerate(arguments):
        if a != 0:
            moved = list(arguments)
            moved[i] = a + ulp(a, bits)/2
            total += abs(mid_fraction(function(*moved)[part]) - value)/ulp(value, bits)
    return float(total)


def main():
    program = sys.argv[1]
    counts = dict(zip((32, 64, 128), [int(word) for word in sys.argv[2:5]] or [20000, 2000, 2000]))
    broken = asked = 0
    for name, generator, function, part, promise, share in questions():
        if sys.argv[5:] and name not in sys.argv[5:]:
            continue
        for bits, count in counts.items():
            for set_name, rows in sets(generator, bits, count).items():
                worst = (0.0, None)
                for row, answer in zip(rows, answers(program, bits, name, rows)):
                    flint.ctx.prec = bits_for(*row, *[1 - a for a in row])
                    value = function(*row)[part]
                    asked += 1
                    if isinstance(value, str):
                        excess = 0.0 if answer == value else float('inf')
                    else:
                        value = mid_fraction(value)
                        if answer.startswith('error') or answer.endswith('Infinity'):
                            excess = float('inf')
                        elif value == 0:
                            excess = 0.0 if rounded(Fraction(answer), bits) == 0 else float('inf')
                        else:
                            excess = float(abs(rounded(Fraction(answer), bits) - value)/ulp(value, bits))
                            if excess > promise and share > 0:
                                excess -= share*condition(function, part, row, value, bits)
                    if excess > worst[0]:
                        worst = (excess, row)
                if worst[0] > promise:
                    broken += 1
                    print(f'{name} {KIND[bits]} {set_name}: {worst[0]:.2f} ulp, {promise} promised: '
                          + ' '.join(decimal(a, bits) for a in worst[1]), flush=True)
        print(f'{name}: done', flush=True)
    print(f'{asked} rows, {broken} promises broken')
    sys.exit(broken > 0)


if __name__ == '__main__':
    main()
