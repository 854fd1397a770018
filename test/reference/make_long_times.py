"""Positions after long times, and to many figures, for test/driver/long_times.sh, with the doubles nearest to the decimals of its scenes: plane
swings, in a fluid and of a body too, and a cone seen from a turning frame."""
from mpmath import asin, cos, ellipfun, ellipk, floor, mp, mpf, nstr, pi, sin, sqrt

mp.dps = 90


def swing(name, degrees, gravity, t, figures=20, length=1):
    """Let go at rest."""
    k = sin(degrees * pi / 360)
    u = sqrt(mpf(gravity) / length) * mpf(t)
    period = 4 * ellipk(k**2)
    angle = 2 * asin(k * ellipfun("cd", u - period * floor(u / period), m=k**2))
    print(name, t, nstr(length * sin(angle), figures), nstr(-length * cos(angle), figures))


swing("fluid", 60, mpf(9.80665) * (1 - mpf(0.3)) / (1 + mpf(0.5) * mpf(0.3)), 1e9)
swing("body", 60, 9.80665, 1e9, length=mpf(4) / 3)
swing("release", 50, 9.80665, 1e9)
for time in (6e15, 6e17):
    swing("phase", 30, 9.80665, time)
for time in (1, 2):
    swing("figures", 90, 1, time, 33)
# A cone with l = 1, g = 2, z = -1/2 turns with 2 rad/s.
turned = (2 - mpf(0.3)) * mpf(10) ** 9
print("frame", nstr(sqrt(mpf(3)) / 2 * cos(turned), 20), nstr(sqrt(mpf(3)) / 2 * sin(turned), 20), nstr(turned, 25))
