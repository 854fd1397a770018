"""Equidistant points between decimals, (A (n - i) + B i)/n as an exact fraction, with 60 figures: grid_points.dat.

Each line: A B n i point. The point is cut after 60 figures and ends in 1 if something follows, so that whoever rounds it rounds the exact one."""
import os
import random
from fractions import Fraction

random.seed(20)


def figures(value):
    if value == 0:
        return "0"
    sign, value, power = ("-" if value < 0 else ""), abs(value), 0
    while value >= 10:
        value, power = value / 10, power + 1
    while value < 1:
        value, power = value * 10, power - 1
    whole = int(value * 10**59)
    rest = "" if value * 10**59 == whole else "1"
    text = str(whole)
    return f"{sign}{text[0]}.{text[1:]}{rest}e{power}"


def decimal():
    digits = random.randint(1, 25)
    power = random.choice([0, 0, -3, 5, random.randint(-300, 290)])
    return random.choice(["", "-"]) + f"{random.randint(0, 9)}.{random.randint(0, 10**digits - 1):0{digits}d}e{power}"


pairs = [("-0.9", "0.9", 18), ("0", "0.7", 7), ("1", "-1", 3), ("5", "5", 4), ("1e300", "-1e-300", 9), ("0", "0", 2),
         ("0.1", "1e-20", 1000000), ("0", "86400", 4500000000000000), ("1e-320", "1e-323", 7)]
pairs += [(decimal(), decimal(), random.choice([1, 2, 3, 7, 10, 999, random.randint(2, 10**15)])) for _ in range(200)]
with open(os.path.join(os.path.dirname(__file__), "grid_points.dat"), "w") as out:
    for a, b, n in pairs:
        for i in sorted({0, 1, n // 3, n - 1, n}):
            point = (Fraction(a) * (n - i) + Fraction(b) * i) / n
            out.write(f"{a} {b} {n} {i} {figures(point)}\n")
