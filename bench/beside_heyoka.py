"""Derivatives beside heyoka in one run: python3 bench/beside_heyoka.py build/release/src

Needs heyoka (pip install heyoka; written with 7.13), numpy, mpmath, and gfortran to link the libraries in the folder given into one
that Python can load. heyoka integrates Newton's equations of the rod with their variational equations by Taylor series; kyvadlo sums
the closed form, here through its C function, set-up included. An output is a state with its derivatives with respect to the six numbers
of the start, l and g. Times are the least processor time of several passes taken in turn, without heyoka's compilation. Errors are the
greatest of a column over its greatest entry, at five of the outputs, against central differences of the motion at 160 digits
(test/reference/exact_pendulum.py).
"""
import ctypes
import os
import subprocess
import sys
import tempfile
import time

import heyoka as hy
import mpmath as mp
import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'test', 'reference'))
import exact_pendulum as exact  # noqa: E402

LENGTH, GRAVITY = 1.0, 9.81
POSITION = [0.6, 0.0, -0.8]
VELOCITIES = {'k**2 < 1/2': [0.1, 0.3, 0.075], 'energy above 2 g l': [1.3, 1.9, 0.975]}  # over sqrt(g l), as in bench/derivatives.f90
PASSES = 7


def load(folder):
    """The C functions of the static libraries, as one that can be loaded."""
    path = os.path.join(tempfile.mkdtemp(), 'kyvadlo.so')
    archives = [os.path.join(folder, 'libkyvadlo_%s.a' % name) for name in ('c', 'core', 'elliptic')]
    subprocess.run(['gfortran', '-shared', '-o', path, '-Wl,--whole-archive', *archives, '-Wl,--no-whole-archive', '-lgomp'], check=True)
    return ctypes.CDLL(path)


def numbers(array):
    return array.ctypes.data_as(ctypes.POINTER(ctypes.c_double))


class Kyvadlo:
    def __init__(self, library, velocity):
        self.library, self.start = library, (np.array(POSITION), np.array(velocity))
        self.periods = np.empty((2, 8))

    def __call__(self, times):
        states, matrices = np.empty((len(times), 6)), np.empty((len(times), 6, 9))
        code = self.library.kyvadlo_derivatives_from_state(
            ctypes.c_double(LENGTH), ctypes.c_double(GRAVITY), *[numbers(u) for u in self.start], ctypes.c_size_t(len(times)),
            numbers(times), numbers(states), numbers(matrices), numbers(self.periods), None, ctypes.c_size_t(0))
        assert code == 0
        return matrices[:, :, :8]


class Heyoka:
    def __init__(self, velocity):
        names = ('x', 'y', 'z', 'u', 'v', 'w')
        x, y, z, u, v, w = hy.make_vars(*names)
        length, gravity = hy.par[0], hy.par[1]
        pull = (u*u+v*v+w*w-gravity*z)/(length*length)
        equations = [(x, u), (y, v), (z, w), (u, -pull*x), (v, -pull*y), (w, -pull*z-gravity)]
        system = hy.var_ode_sys(equations, args=[x, y, z, u, v, w, length, gravity])
        self.start = np.array(POSITION+list(velocity))
        self.integrator = hy.taylor_adaptive(system, self.start, pars=[LENGTH, GRAVITY], tol=2.0**-52, compact_mode=True)
        self.initial = self.integrator.state.copy()
        self.slices = self.integrator.get_vslice(order=1)

    def __call__(self, times):
        ta = self.integrator
        ta.time = 0.0
        ta.state[:] = self.initial
        outputs = ta.propagate_grid(np.concatenate(([0.0], times)))[-1][1:]
        found = outputs[:, self.slices].reshape(len(times), 6, 8)
        return found @ put_on_sphere(self.start)


def put_on_sphere(start):
    """Of x -> l x/|x|, v -> v - (v.x) x/|x|**2 with respect to the six numbers and l, g."""
    x, v = start[:3]/np.linalg.norm(start[:3]), start[3:]
    flat = np.eye(3)-np.outer(x, x)
    change = np.eye(8)
    change[:3, :3] = flat
    change[3:6, 3:6] = flat
    change[3:6, :3] = -np.outer(x, v @ flat)/LENGTH
    change[:3, 6] = x
    return change


def reference(velocity, t):
    with mp.workdps(160):
        values = [mp.mpf(u) for u in [LENGTH, GRAVITY]+POSITION+list(velocity)]
        columns = []
        for i in [2, 3, 4, 5, 6, 7, 0, 1]:
            ends = []
            for side in (1, -1):
                moved = list(values)
                moved[i] += side*mp.mpf(10)**-40
                ends.append(exact.Motion(*moved).state(mp.mpf(t)))
            columns.append([float((a-b)/(2*mp.mpf(10)**-40)) for a, b in zip(*ends)])
    return np.array(columns).T


def worst(found, velocity, times):
    errors = []
    for i in np.linspace(0, len(times)-1, min(5, len(times))).astype(int):
        exactly = reference(velocity, times[i])
        errors.append(np.max(np.abs(found[i]-exactly)/np.max(np.abs(exactly), axis=0)))
    return max(errors)


def main():
    library = load(sys.argv[1])
    print('Derivatives beside heyoka %s: microseconds an output, and the worst error of a column over its greatest entry.\n' % hy.__version__)
    print('%-20s %-28s %10s %10s %10s %10s %8s' % ('motion', 'outputs', 'kyvadlo', 'error', 'heyoka', 'error', 'times'))
    for name, velocity in VELOCITIES.items():
        velocity = [u*(GRAVITY*LENGTH)**0.5 for u in velocity]
        ours, theirs = Kyvadlo(library, velocity), Heyoka(velocity)
        period = period_of(velocity)
        for what, times in (('500 in one period', np.linspace(0, period, 501)[1:]), ('1000 in 1000 periods', period*np.arange(1, 1001))):
            least, found = [np.inf, np.inf], [None, None]
            for _ in range(PASSES):
                for i, method in enumerate((ours, theirs)):
                    repeats = 100 if i == 0 else 1
                    begun = time.process_time()
                    for _ in range(repeats):
                        found[i] = method(times)
                    least[i] = min(least[i], (time.process_time()-begun)/repeats/len(times)*1e6)
            errors = [worst(f, velocity, times) for f in found]
            print('%-20s %-28s %10.3f %10.1e %10.3f %10.1e %8.1f' % (name, what, least[0], errors[0], least[1], errors[1], least[1]/least[0]))


def period_of(velocity):
    with mp.workdps(30):
        return float(exact.Motion(LENGTH, GRAVITY, *POSITION, *velocity).orbit.constants()[0])


if __name__ == '__main__':
    main()
