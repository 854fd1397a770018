"""Positions after 1e9 s, to 20 figures, for test/driver/long_times.sh: a plane swing from 60 degrees in a fluid, and a cone seen from
a turning frame, both with the doubles nearest to the decimals of their scenes."""
from mpmath import cos, ellipfun, ellipk, floor, mp, mpf, nstr, pi, sin, sqrt, asin

mp.dps = 60
t = mpf(10) ** 9
gravity = mpf(9.80665) * (1 - mpf(0.3)) / (1 + mpf(0.5) * mpf(0.3))
k = sin(pi / 6)
u = sqrt(gravity) * t
period = 4 * ellipk(k**2)
angle = 2 * asin(k * ellipfun("cd", u - period * floor(u / period), m=k**2))
print("fluid", nstr(sin(angle), 20), nstr(-cos(angle), 20))
# l = 1, g = 2, z = -1/2: 2 rad/s.
turned = (2 - mpf(0.3)) * t
print("frame", nstr(sqrt(mpf(3)) / 2 * cos(turned), 20), nstr(sqrt(mpf(3)) / 2 * sin(turned), 20), nstr(turned, 25))
