"""Integrated scenes beside heyoka in one run: python3 bench/integrated_beside_heyoka.py build/release/bin/kyvadlo-bench

Needs heyoka (pip install heyoka; written with 7.13) and numpy. The scenes, spans and tolerances are those that
`kyvadlo-bench --integrated` prints; heyoka integrates the same equations by Taylor series compiled by LLVM, without its compilation
in the time. Errors are those of the place at the end, against heyoka in long double with a tolerance of 1e-18.
"""
import subprocess
import sys
import time

import heyoka as hy
import numpy as np

LENGTH, GRAVITY = 1.0, 9.81
START = [0.6, 0.0, -0.8, 0.0, 1.5, 0.0]
PERIOD = 2*np.pi*np.sqrt(LENGTH/GRAVITY)
EARTH, LATITUDE = 7.292115e-5, np.radians(48.85)
PASSES = 5


def equations(scene):
    """Newton's equations: on the sphere the rod's force keeps p.p'' + v.v = 0, a spring pulls by its length."""
    x, y, z, u, v, w = hy.make_vars('x', 'y', 'z', 'u', 'v', 'w')
    place, velocity = (x, y, z), (u, v, w)
    force = [0.0*x, 0.0*y, -GRAVITY+0.0*z]
    if scene == 'drag':
        speed = hy.sqrt(u*u+v*v+w*w)
        force = [f-1e-5*speed*c for f, c in zip(force, velocity)]
    elif scene == 'Earth':
        north, up = EARTH*np.cos(LATITUDE), EARTH*np.sin(LATITUDE)
        force = [force[0]-2*(north*w-up*v), force[1]-2*up*u, force[2]+2*north*u]
    elif scene == 'pivot':
        turn = 2*np.pi*0.7
        force[0] = force[0]+0.01*turn**2*hy.cos(turn*hy.time)
    square = x*x+y*y+z*z
    if scene == 'spring':
        pull = 100.0*(1.0-LENGTH/hy.sqrt(square))
    else:
        pull = (force[0]*x+force[1]*y+force[2]*z+u*u+v*v+w*w)/square
    return list(zip(place, velocity))+[(c, f-pull*p) for c, f, p in zip(velocity, force, place)]


class Heyoka:
    def __init__(self, scene, tolerance, kind=float):
        start = np.array([kind(s) for s in START])
        self.kind, self.start = kind, start
        self.integrator = hy.taylor_adaptive(equations(scene), start.copy(), time=kind(0), tol=kind(tolerance), fp_type=kind)

    def __call__(self, end):
        ta = self.integrator
        ta.time = self.kind(0)
        ta.state[:] = self.start
        ta.propagate_until(self.kind(end))
        return ta.state[:3].copy()


def seconds(work, end):
    """Of the processor, for one run: the least of several."""
    runs = max(1, int(100*PERIOD/end))
    least = np.inf
    for _ in range(PASSES if end < 1000*PERIOD else 2):
        begun = time.process_time()
        for _ in range(runs):
            work(end)
        least = min(least, (time.process_time()-begun)/runs)
    return least


def main():
    printed = subprocess.run([sys.argv[1], '--integrated']+sys.argv[2:], check=True, capture_output=True, text=True).stdout
    rows = [line.split() for line in printed.splitlines()]
    rows = [row for row in rows if row and row[0] in ('drag', 'Earth', 'spring', 'pivot')]
    print('Integrated scenes beside heyoka %s: microseconds a period, and the error of the place at the end [m].\n' % hy.__version__)
    print('%-8s%8s%11s%10s%10s%10s%10s%8s' % ('scene', 'periods', 'tolerance', 'kyvadlo', 'error', 'heyoka', 'error', 'times'))
    references = {}
    for row in rows:
        scene, periods, tolerance, ours, end = row[0], int(row[1]), float(row[2]), float(row[3]), np.array(row[7:], dtype=float)
        if (scene, periods) not in references:
            references[scene, periods] = Heyoka(scene, 1e-18, np.longdouble)(periods*PERIOD)
        integrator = Heyoka(scene, tolerance)
        place = integrator(periods*PERIOD)
        theirs = 1e6*seconds(integrator, periods*PERIOD)/periods
        errors = [float(np.linalg.norm(p-references[scene, periods])) for p in (end, place)]
        print('%-8s%8d%11.0e%10.2f%10.1e%10.2f%10.1e%8.2f' % (scene, periods, tolerance, ours, errors[0], theirs, errors[1],
                                                               theirs/ours), flush=True)


if __name__ == '__main__':
    main()
