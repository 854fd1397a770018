"""Writes events.dat: when quantities of a spherical pendulum pass values, by Newton's equations alone.

The bob starts at (0.6, 0, -0.8) m with the velocity (0, v, 0); l = 1 m, g = 9.80665 m/s2. Position and velocity are Taylor series of
degree 40 in steps of 0.02 s, with 45 digits: x'' = -N x, N = v**2 - g z. No elliptic function, no conserved quantity is used. Zeros are
bracketed by 400 points a second, and by the extremes between them, and found by mpmath. Run with mpmath 1.3.0.
"""
from mpmath import mp, mpf, atan2, findroot, hypot, acos, pi, nstr, sqrt

mp.dps = 45
DEGREE, STEP, G, END = 40, mpf(1)/50, mpf("9.80665"), mpf(3)


def series(state):
    p = [[state[i]] for i in range(3)]
    v = [[state[i + 3]] for i in range(3)]
    pull = []
    for k in range(DEGREE):
        pull.append(sum(v[i][j]*v[i][k - j] for i in range(3) for j in range(k + 1)) - G*p[2][k])
        for i in range(3):
            a = -sum(pull[j]*p[i][k - j] for j in range(k + 1)) - (G if i == 2 and k == 0 else 0)
            p[i].append(v[i][k]/(k + 1))
            v[i].append(a/(k + 1))
    return p + v


def motion(speed):
    state, steps = [mpf("0.6"), mpf(0), mpf("-0.8"), mpf(0), speed, mpf(0)], []
    for _ in range(int(END/STEP) + 1):
        steps.append(series(state))
        state = [mp.polyval(c[::-1], STEP) for c in steps[-1]]
    return lambda t: [mp.polyval(c[::-1], t - STEP*min(int(t/STEP), len(steps) - 1)) for c in steps[min(int(t/STEP), len(steps) - 1)]]


def turns(s):
    return atan2(s[1], s[0]) % (2*pi)


COLUMNS = {"x": lambda s: s[0], "y": lambda s: s[1], "z": lambda s: s[2], "vx": lambda s: s[3], "vy": lambda s: s[4], "vz": lambda s: s[5],
           "speed": lambda s: sqrt(s[3]**2 + s[4]**2 + s[5]**2), "tension": lambda s: s[3]**2 + s[4]**2 + s[5]**2 - G*s[2],
           "inclination": lambda s: acos(-s[2]/sqrt(s[0]**2 + s[1]**2 + s[2]**2))}
REQUESTS = [("x", "0.1"), ("x", "0"), ("y", "-0.2"), ("z", "-0.7"), ("vx", "0.5"), ("vy", "-1"), ("vz", "0"), ("vz", "0.25"),
            ("speed", "1.5"), ("tension", "12"), ("inclination", "0.75")]


def golden(f, a, b):
    """The time of the extreme of f between a and b."""
    return findroot(lambda t: (f(t + mpf(10)**-12) - f(t - mpf(10)**-12))*mpf(10)**12/2, (a, b), solver="anderson", tol=mpf(10)**-30, verify=False)


def zeros(f, points=1200):
    times = [END*i/points for i in range(points + 1)]
    values = [f(t) for t in times]
    found = []
    for i in range(points):
        brackets = [(times[i], times[i + 1])] if values[i]*values[i + 1] < 0 else []
        if not brackets and 0 < i and values[i - 1]*values[i] > 0 and values[i]*values[i + 1] > 0 \
                and abs(values[i]) <= min(abs(values[i - 1]), abs(values[i + 1])):
            top = golden(f, times[i - 1], times[i + 1])
            if f(top)*values[i] < 0:
                brackets = [(times[i - 1], top), (top, times[i + 1])]
        found += [findroot(f, b, solver="anderson", tol=mpf(10)**-60, verify=False) for b in brackets]
    return sorted(t for t in found if t > mpf(10)**-6)


with open("events.dat", "w") as file:
    file.write("# v [m/s], value, number of the crossing -> time of the crossing [s]; the condition is not computed\n")
    file.write("# Written by make_events.py\ncolumns 3 1\n")
    for word in ("0.5", "1.7"):
        at = motion(mpf(float(word)))
        requests = list(REQUESTS)
        # Two crossings next to an extreme of x: 1e-9 and 1e-11 below its second largest value.
        x = lambda t: at(t)[0]
        grid = [x(END*i/600) for i in range(601)]
        i = max((i for i in range(60, 600) if grid[i - 1] < grid[i] > grid[i + 1]), key=lambda i: grid[i])
        top = x(golden(x, END*(i - 1)/600, END*(i + 1)/600))
        requests += [("x", repr(float(top) - 1e-9)), ("x", repr(float(top) - 1e-11))]
        for column, value in requests:
            level = mpf(float(value))
            for k, t in enumerate(zeros(lambda t: COLUMNS[column](at(t)) - level), 1):
                file.write(f"{column} 64 {float(word)!r} {float(value)!r} {k} {nstr(t, 30)} 0\n")
