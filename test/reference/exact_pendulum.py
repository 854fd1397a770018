"""The spherical pendulum in arbitrary precision, from the equations of the paper: the ground of make_orbit.py.

Everything is derived from the gaps d1 = l+z1, d2 = l+z2, h1 = l-z1, h2 = l-z2, e3 = z3-l, s = -(z1+z2), D = z1-z2.
Working precision is the caller's (`mpmath.mp.dps`); intermediate cancellations are covered by asking for enough of it,
so that no formula here has to be clever, and `make_orbit.py` repeats every row at a higher precision and compares.
"""
from fractions import Fraction

import flint
import mpmath as mp
from mpmath import mpc, mpf


class Inadmissible(ValueError):
    """The numbers given determine no orbit."""


def carlson_rf(x, y, z):
    """R_F by Arb, at the precision of mpmath."""
    flint.ctx.prec = mp.mp.prec + 40
    value = flint.acb.elliptic_rf(*(flint.acb(flint.arb(u)) for u in (x, y, z))).real
    if not value.is_finite():
        raise Inadmissible('R_F')
    mantissa, exponent = value.mid().man_exp()
    return +mpf((int(mantissa), int(exponent)))


def fraction(x):
    """An exact binary number as a fraction."""
    sign, mantissa, exponent, _ = mpf(x)._mpf_
    value = Fraction(int(mantissa))*(Fraction(2)**exponent)
    return -value if sign else value


# ---------------------------------------------------------------------------------------------- turning heights
class Gaps:
    """Turning heights with all differences; c2 >= 0."""

    def __init__(self, l, g, d1, d2, h1, h2, e3, s, D):
        self.l, self.g, self.d1, self.d2, self.h1, self.h2, self.e3, self.s, self.D = l, g, d1, d2, h1, h2, e3, s, D
        self.d3 = 2*l+e3
        self.z1 = d1-l if d1 < h1 else l-h1
        self.z2, self.z3 = d2-l, l+e3
        self.Z31, self.Z32 = e3+h1, e3+h2
        self.c2 = mp.sqrt(2*g*s*e3*self.d3)
        self.c1 = g*(e3-s+l)

    def turning(self):
        return [self.z2, self.z1, self.z3, self.d2, self.h1, self.D, self.Z31, self.e3]


def gaps_from_heights(l, g, z1, z2):
    return _gaps(l, g, l+z1, l+z2, l-z1, l-z2, -(z1+z2), z1-z2)


def gaps_from_gaps(l, g, h1, d2):
    return _gaps(l, g, 2*l-h1, d2, h1, 2*l-d2, h1-d2, 2*l-h1-d2)


def gaps_from_rises(l, g, d1, d2):
    return _gaps(l, g, d1, d2, 2*l-d1, 2*l-d2, 2*l-d1-d2, d1-d2)


def _gaps(l, g, d1, d2, h1, h2, s, D):
    if not (l > 0 and g > 0 and d1 >= d2 >= 0 and h2 >= h1 >= 0 and s > 0):
        raise Inadmissible('turning heights')
    return Gaps(l, g, d1, d2, h1, h2, d1*d2/s, s, D)


def gaps_from_energy(l, g, c2, energy=None, above_top=None, above_bottom=None):
    """Roots of (5) from c1 or c1 - g l or c1 + g l, and c2. The decision whether they exist is exact."""
    top = above_top if above_top is not None else (energy-g*l if energy is not None else above_bottom-2*g*l)
    bottom = above_bottom if above_bottom is not None else (energy+g*l if energy is not None else above_top+2*g*l)
    if bottom < 0 or not (l > 0 and g > 0):
        raise Inadmissible('energy')
    c2 = abs(c2)
    if c2 == 0:
        if top >= 0:
            return Gaps(l, g, 2*l, mpf(0), mpf(0), 2*l, top/g, mpf(0), 2*l)
        return Gaps(l, g, bottom/g, mpf(0), -top/g, 2*l, mpf(0), -top/g, bottom/g)
    # exact discriminant of z^3 - c z^2 - l^2 z + (l^2 c - j), c = c1/g, j = c2^2/(2g)
    fl, fg = fraction(l), fraction(g)
    if energy is not None:
        c = fraction(energy)/fg
    elif above_top is not None:
        c = fraction(above_top)/fg+fl
    else:
        c = fraction(above_bottom)/fg-fl
    p, q, r = -c, -fl**2, fl**2*c-fraction(c2)**2/(2*fg)
    discriminant = 18*p*q*r-4*p**3*r+p*p*q*q-4*q**3-27*r*r
    if discriminant < 0:
        raise Inadmissible('discriminant')
    j, epsilon = c2*c2/(2*g), top/g
    a, b = abs(epsilon), 2*l+max(epsilon, mpf(0))
    u = 2*j/b/(a+mp.sqrt(a*a+4*j/b))
    for _ in range(400):
        f = u*(u+a)*(b+u)-j
        step = f/((u+a)*(b+u)+u*(b+u)+u*(u+a))
        u -= step
        if abs(step) <= abs(u)*mpf(10)**(-mp.mp.dps+4):
            break
    else:
        raise ArithmeticError('Newton')
    e3, s = (epsilon+u, u) if epsilon >= 0 else (u, u+a)
    total = 2*l-s if top >= 0 else bottom/g-e3    # d1+d2
    if total <= 0:
        raise Inadmissible('energy')
    D = mp.sqrt(total*total-4*s*e3) if discriminant > 0 else mpf(0)
    d1 = (total+D)/2
    h2 = (2*l+s+D)/2
    return Gaps(l, g, d1, s*e3/d1, s*(2*l+e3)/h2, h2, e3, s, D)


# ---------------------------------------------------------------------------------------------- theta functions
def theta(i, q, v, b):
    """theta_i(v + i b | q) and its derivative with respect to v + i b, each as (real, imaginary); DLMF 20.2."""
    half = i in (1, 2)
    re = mpf(0) if half else mpf(1)
    im = dre = dim = mpf(0)
    if q == 0:
        return re, im, dre, dim
    n = 0 if half else 1
    limit = mp.log(10)*(mp.mp.dps+10)
    lq, first = -mp.log(q), None
    while True:
        m = 2*n+1 if half else 2*n
        exponent = lq*(mpf(m)/2)**2
        size = exponent-m*abs(b)
        if first is None:
            first = min(size, mpf(0)) if not half else size
        if size > first+limit and n > 1:
            break
        c = 2*mp.exp(-exponent)
        if (i in (1, 4)) and n % 2:
            c = -c
        ch, sh, cv, sv = mp.cosh(m*b), mp.sinh(m*b), mp.cos(m*v), mp.sin(m*v)
        if i == 1:
            re += c*sv*ch
            im += c*cv*sh
            dre += c*m*cv*ch
            dim -= c*m*sv*sh
        else:
            re += c*cv*ch
            im -= c*sv*sh
            dre -= c*m*sv*ch
            dim -= c*m*cv*sh
        n += 1
    return re, im, dre, dim


# ---------------------------------------------------------------------------------------------- one orbit
class Orbit:
    """Constants of the motion (14)-(16), (23)-(35); lambda T from [S5.2] (nome q) or [S5.3] (nome q')."""

    def __init__(self, gaps):
        self.gaps = o = gaps
        l, g = o.l, o.g
        if o.D == 0:
            zc = o.z1
            self.conical = True
            self.k2, self.kp2, self.q = mpf(0), mpf(1), mpf(0)
            self.K = mp.pi/2
            self.T = 2*mp.pi*l*mp.sqrt(-zc/(g*(l*l+3*zc*zc)))
            self.rate = mp.sqrt(g/-zc)
            root = mp.sqrt(l*l+3*zc*zc)
            self.lamT = 3*mp.pi*o.d1*o.h1/(root*(2*l+root))     # 2 pi l/root - pi
            self.A = (self.lamT-mp.pi)/self.T
            return
        self.conical = False
        e3, d1, d2, d3, h1, h2, D, Z31, Z32 = o.e3, o.d1, o.d2, o.d3, o.h1, o.h2, o.D, o.Z31, o.Z32
        if Z31 == 0:
            raise Inadmissible('separatrix')
        self.k2, self.kp2 = D/Z32, Z31/Z32
        root = mp.sqrt(Z32)
        self.wdot = mp.sqrt(g*Z32/2)/l
        self.K, self.Kp = root*carlson_rf(mpf(0), Z31, Z32), root*carlson_rf(mpf(0), D, Z32)
        self.T = 2*self.K/self.wdot
        self.q, self.qp = mp.exp(-mp.pi*self.Kp/self.K), mp.exp(-mp.pi*self.K/self.Kp)
        b1 = root*carlson_rf(d1, d2, d3) if d2 > 0 else self.Kp
        b1s = mp.sqrt(d2)*carlson_rf(D, D*d3/Z32, d1)
        b = mp.sqrt(Z32*h1)*carlson_rf(h2*Z31, D*e3, D*Z31) if h1 > 0 else mpf(0)
        if e3 == 0:
            b = self.Kp
        bs = mp.sqrt(e3)*carlson_rf(h1, h2*Z31/Z32, Z31) if e3 > 0 else mpf(0)
        f, fp = mp.pi/(2*self.K), mp.pi/(2*self.Kp)
        self.b, self.b1, self.bs, self.b1s = f*b, f*b1, f*bs, f*b1s
        self.X, self.X1, self.Xs, self.X1s = fp*b, fp*b1, fp*bs, fp*b1s
        self.low = self.k2 <= mpf(1)/2
        tiny = mpf(10)**(-mp.mp.dps-10)
        if self.low:
            total, n = mp.tanh(self.bs), 1
            while True:
                Q1, Q2 = self.q**(2*n-1), self.q**(2*n)
                term = 4*Q2*mp.sinh(2*self.bs)/(1+2*Q2*mp.cosh(2*self.bs)+Q2*Q2)
                term += 4*Q1*mp.sinh(2*self.b1s)/(1-2*Q1*mp.cosh(2*self.b1s)+Q1*Q1)
                total += term
                if term <= tiny*total:
                    break
                n += 1
            self.lamT = mp.pi*total
        else:
            total, n = mp.tan(self.X1s), 1
            while True:
                Q1, Q2 = self.qp**(2*n-1), self.qp**(2*n)
                total += 4*Q2*mp.sin(2*self.X1s)/(1+2*Q2*mp.cos(2*self.X1s)+Q2*Q2)
                total += 4*Q1*mp.sin(2*self.Xs)/(1-2*Q1*mp.cos(2*self.Xs)+Q1*Q1)
                if Q1 <= tiny:
                    break
                n += 1
            self.mu = mp.pi*self.wdot/(2*self.Kp)*total
            self.lamT = self.mu*self.T+2*(self.Xs-self.X1s)
        self.AT = self.lamT-mp.pi
        if o.s == 0:                              # plane rotation: exactly no turning
            self.lamT, self.AT, self.mu = +mp.pi, mpf(0), mpf(0)
        self.lam = self.lamT/self.T
        self.A = self.AT/self.T

    def constants(self):
        """T k k' K q A phi(T) lambda*T"""
        return [self.T, mp.sqrt(self.k2), mp.sqrt(self.kp2), self.K, self.q, self.A, mp.pi+self.lamT, self.lamT]

    def reduce(self, t):
        """Number of the nearest upper turning point and the time from it."""
        n = mp.floor(t/self.T+mpf(1)/2)
        return n, t-n*self.T

    def azimuth(self, t):
        """phi(t): (35) with [S2.3], or [S4.3]."""
        if self.conical:
            return self.rate*t
        n, tau = self.reduce(t)
        whole = n*(mp.pi+self.lamT)
        if tau == 0 or self.gaps.d2 == 0:     # plane libration: the limit, steps of pi at the lowest point
            return whole
        tiny, h = mpf(10)**(-mp.mp.dps-10), 1
        if self.low:
            a = mp.pi*tau/self.T
            if self.gaps.h1 == 0:
                raise Inadmissible('azimuth through the upper pole')
            value = self.A*tau+2*a+mp.atan2(mp.sin(2*a), mp.expm1(2*self.b)+2*mp.sin(a)**2)
            while True:
                Q1, Q2 = self.q**(2*h-1), self.q**(2*h)
                lq = mp.log(self.q)
                den1 = (-mp.expm1((2*h-2)*lq-2*self.b1s)*(1-Q1*mp.exp(-2*self.b1))
                        + 4*Q1*mp.cosh(2*self.b1)*mp.cos(a)**2)
                den2 = (-mp.expm1((2*h-1)*lq-2*self.bs)*(1-Q2*mp.exp(-2*self.b))
                        + 4*Q2*mp.cosh(2*self.b)*mp.sin(a)**2)
                value -= mp.atan2(2*Q1*mp.sin(2*a)*mp.sinh(2*self.b1), den1)
                value -= mp.atan2(2*Q2*mp.sin(2*a)*mp.sinh(2*self.b), den2)
                if Q1*mp.exp(2*self.b1) < tiny and Q2*mp.exp(2*self.b) < tiny and h > 1:
                    return whole+value
                h += 1
        V = mp.pi*self.wdot*tau/(2*self.Kp)
        value = self.mu*tau+mp.atan2(mp.cos(self.X)*mp.sinh(V), mp.sin(self.X)*mp.cosh(V))
        while True:
            Q1, Q2 = self.qp**(2*h-1), self.qp**(2*h)
            e = mp.exp(2*abs(V))
            den2 = (1-Q2*e)*(1-Q2/e)+4*Q2*mp.cosh(2*V)*mp.sin(self.X)**2
            den1 = (1-Q1*e)*(1-Q1/e)+4*Q1*mp.cosh(2*V)*mp.cos(self.X1)**2
            value += mp.atan2(2*Q2*mp.sin(2*self.X)*mp.sinh(2*V), den2)
            value += mp.atan2(2*Q1*mp.sin(2*self.X1)*mp.sinh(2*V), den1)
            if Q1*e < tiny:
                return whole+value
            h += 1

    def position(self, t):
        """x y z vx vy vz by [S5.1] and section 5.3, t and azimuth from an upper turning point."""
        o = self.gaps
        if self.conical:
            r, w = mp.sqrt(o.d1*o.h1), self.rate
            c, s = mp.cos(w*t), mp.sin(w*t)
            return [r*c, r*s, o.z1, -r*w*s, r*w*c, mpf(0)]
        n, tau = self.reduce(t)
        # one function of a real time variable per factor: (real, imaginary) and their time derivatives
        if self.low:
            rate, v = mp.pi/self.T, mp.pi*tau/self.T
            P = _scaled(theta(2, self.q, v, -self.b1s), rate)
            D = _scaled(theta(3, self.q, v, mpf(0)), rate)
            plus = o.d1*theta(3, self.q, mpf(0), mpf(0))[0]**2/theta(2, self.q, mpf(0), self.b1s)[0]**2
            minus = o.h2*theta(4, self.q, mpf(0), mpf(0))[0]**2
            if self.b >= self.bs:
                F, rho = _scaled(theta(4, self.q, v, self.bs), rate), self.lam
                minus /= theta(3, self.q, mpf(0), self.bs)[0]**2
            else:
                re, im, dre, dim = _scaled(theta(1, self.q, v, -self.b), rate)
                F, rho = (-im, re, -dim, dre), self.A
                minus /= theta(2, self.q, mpf(0), self.b)[0]**2
        else:
            rate, V = mp.pi*self.wdot/(2*self.Kp), mp.pi*self.wdot*tau/(2*self.Kp)
            rho = self.mu
            # theta_2(X* - iV) = theta_1(X + iV): without rounding where X = 0 (plane rotation)
            F = _turned(theta(1, self.qp, self.X, V), rate) if self.X < self.Xs else _turned(theta(2, self.qp, self.Xs, -V), -rate)
            P = _turned(theta(4, self.qp, self.X1s, V), rate)
            D = _turned(theta(3, self.qp, mpf(0), V), rate)
            plus = o.d1*theta(3, self.qp, mpf(0), mpf(0))[0]**2/theta(4, self.qp, self.X1s, mpf(0))[0]**2
            minus = o.h2*theta(2, self.qp, mpf(0), mpf(0))[0]**2/theta(3, self.qp, self.Xs, mpf(0))[0]**2
        d, dd = D[0], D[2]
        f, df, p, dp = mpc(F[0], F[1]), mpc(F[2], F[3]), mpc(P[0], P[1]), mpc(P[2], P[3])
        rotating = self.b < self.bs
        angle = rho*tau+n*(self.AT if rotating else self.lamT)
        turn = mp.sqrt(plus*minus)*mpc(mp.cos(angle), mp.sin(angle))*(-1 if int(n) % 2 and not rotating else 1)
        product = f*p
        u = turn*product/d**2
        du = turn*(mpc(0, rho)*product+df*p+f*dp-2*product*dd/d)/d**2
        PP, FF = p.real**2+p.imag**2, f.real**2+f.imag**2
        rise, fall = plus*PP/d**2, minus*FF/d**2
        z = rise-o.l if rise < fall else o.l-fall
        dz = plus*(2*(p.real*dp.real+p.imag*dp.imag)-2*PP*dd/d)/d**2
        return [u.real, u.imag, z, du.real, du.imag, dz]


def _scaled(values, rate):
    re, im, dre, dim = values
    return re, im, rate*dre, rate*dim


def _turned(values, rate):
    """Derivative along i V: d/dt f(X + i V) = i V' f'."""
    re, im, dre, dim = values
    return re, im, -rate*dim, rate*dre


# ---------------------------------------------------------------------------------------------- any start
class Motion:
    """The motion from a state, projected orthogonally on the sphere and its tangent plane; [S6.5]."""

    def __init__(self, l, g, x, y, z, vx, vy, vz):
        self.l, self.g = l, g
        radius = mp.sqrt(x*x+y*y+z*z)
        if radius == 0 or not (l > 0 and g > 0):
            raise Inadmissible('state')
        c2 = (x*vy-y*vx)*l/radius
        radial = (x*vx+y*vy+z*vz)/radius
        vx, vy, vz = vx-radial*x/radius, vy-radial*y/radius, vz-radial*z/radius
        f = l/radius
        r2 = (x*x+y*y)*f*f
        x, y, z = x*f, y*f, z*f
        self.start = [x, y, z, vx, vy, vz]
        self.sign = -1 if c2 < 0 else 1
        c2 = abs(c2)
        v2 = vx*vx+vy*vy+vz*vz
        self.rest = r2 == 0 and v2 == 0
        if self.rest:
            return
        lmz, lpz = (l-z, r2/(l-z)) if z < 0 else (r2/(l+z), l+z)
        epsilon, j = v2/(2*g)-lmz, c2*c2/(2*g)
        self.separatrix = j == 0 and abs(epsilon) <= mpf(10)**(-mp.mp.dps*2//3)*lmz
        if self.separatrix:
            if r2 == 0 and z < 0:
                self.turn, self.t0, self.upwards = mpc(vx, vy)/mp.sqrt(v2), mpf(0), 1
            else:
                self.upwards = 1 if vz >= 0 else -1
                self.turn = mpc(x, y)/mp.sqrt(r2)
                self.t0 = mp.asinh(mp.sqrt(lpz/lmz))/mp.sqrt(g/l)
            return
        if j == 0:
            e3, s = (epsilon, mpf(0)) if epsilon >= 0 else (mpf(0), -epsilon)
        else:
            a, b = abs(epsilon), 2*l+max(epsilon, mpf(0))
            u = 2*j/b/(a+mp.sqrt(a*a+4*j/b))
            for _ in range(400):
                f = u*(u+a)*(b+u)-j
                step = f/((u+a)*(b+u)+u*(b+u)+u*(u+a))
                u -= step
                if abs(step) <= abs(u)*mpf(10)**(-mp.mp.dps+4):
                    break
            e3, s = (u+epsilon, u) if epsilon >= 0 else (u, u+a)
        z3z = e3+lmz
        p0, p1 = l*l*vz*vz/(2*g), -(z*v2/g+r2)
        ab = p0/z3z
        amb = (p1+ab)/z3z
        D = mp.sqrt(amb*amb+4*ab)
        tolerance = mpf(10)**(-mp.mp.dps*2//3)
        if D < tolerance*l and v2 > 0 and j > 0 and D < tolerance*(lpz+v2/g):
            D = mpf(0)
        if amb >= 0:
            a = (amb+D)/2
            b = ab/a if a > 0 else mpf(0)
        else:
            b = (D-amb)/2
            a = ab/b
        d1, h2, d3 = lpz+a, lmz+b, 2*l+e3
        gaps = Gaps(l, g, d1, s*e3/d1, s*d3/h2, h2, e3, s, D)
        self.orbit = Orbit(gaps)
        o = self.orbit
        if o.conical:
            self.t0 = mpf(0)
        else:
            w = mp.sqrt(a)*carlson_rf(o.kp2*b, o.kp2*D, a+o.kp2*b) if a > 0 else mpf(0)
            self.t0 = (w if vz <= 0 else -w)/o.wdot
        u0 = o.position(self.t0)
        R = (mpc(x, self.sign*y)*mpc(u0[0], -u0[1])*(g/l)+mpc(vx, self.sign*vy)*mpc(u0[3], -u0[4]))
        self.turn = R/abs(R)

    def state(self, t):
        if self.rest or t == 0:
            return self.start
        if self.separatrix:
            l, w = self.l, mp.sqrt(self.g/self.l)
            argument = w*(self.t0+self.upwards*t)
            th, se = mp.tanh(argument), 1/mp.cosh(argument)
            p, v = 2*l*th*se*self.turn, self.upwards*2*l*w*se*(se*se-th*th)*self.turn
            z = 2*l*th*th-l if abs(argument) < 1 else l-2*l*se*se
            return [p.real, p.imag, z, v.real, v.imag, self.upwards*4*l*w*se*se*th]
        u = self.orbit.position(self.t0+t)
        p, v = mpc(u[0], u[1])*self.turn, mpc(u[3], u[4])*self.turn
        return [p.real, self.sign*p.imag, u[2], v.real, self.sign*v.imag, u[5]]


# ---------------------------------------------------------------------------------------------- passages
def passage_height(orbit, z_gap_top, z_gap_bottom):
    """First t >= 0 at the height with gaps a = z1-z and b = z-z2."""
    o, a, b = orbit, z_gap_top, z_gap_bottom
    if a < 0 or b < 0:
        raise Inadmissible('height')
    if a == 0:
        return mpf(0)
    return mp.sqrt(a)*carlson_rf(o.kp2*b, o.kp2*o.gaps.D, a+o.kp2*b)/o.wdot


def passage_azimuth(orbit, phi):
    """First t >= 0 with azimuth phi: Newton, kept inside a bracket."""
    if phi < 0:
        raise Inadmissible('azimuth')
    if phi == 0:
        return mpf(0)
    if orbit.conical:
        return phi/orbit.rate
    n = mp.floor(phi/(mp.pi+orbit.lamT))
    low, high = n*orbit.T, (n+1)*orbit.T
    t, working = (low+high)/2, mp.mp.dps
    digits = 40
    while True:
        with mp.workdps(digits):
            for _ in range(2000):
                error = orbit.azimuth(t)-phi
                low, high = (low, t) if error > 0 else (t, high)
                x, y = orbit.position(t)[:2]
                new = t-error*(x*x+y*y)/orbit.gaps.c2
                if not low < new < high:
                    if digits > 40:
                        low, high = new-abs(new-t), new+abs(new-t)    # rounding of the coarser level
                    else:
                        new = (low+high)/2
                step, t = abs(new-t), new
                if step <= abs(t)*mpf(10)**(-digits*3//4):
                    break
            else:
                raise ArithmeticError('passage_azimuth')
        if digits >= working:
            return t
        digits = min(3*digits//2, working)
        low, high = t-orbit.T, t+orbit.T
