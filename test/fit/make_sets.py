#!/usr/bin/env python3
"""Synthetic measurements of the five cases of doc/fitting.md, by an integrator that shares no code with kyvadlo: SciPy's DOP853 of
Newton's equations in Cartesian coordinates, with the constraint written out.

    make_sets.py CASE SEED FOLDER      writes FOLDER/CASE_SEED.nml, .csv and .truth (JSON)

The orbit, the parameters, the sampling and the noise are drawn from the seed over wide ranges."""
import json
import sys

import numpy as np
from scipy.integrate import solve_ivp

RATE = 7.292115e-5


def right_side(length, gravity, linear=0.0, quadratic=0.0, turn=(0.0, 0.0, 0.0)):
    turn = np.array(turn)

    def rates(t, s):
        r, v = s[:3], s[3:]
        a = -(linear + quadratic * np.sqrt(v @ v)) * v - 2 * np.array(
            [turn[1] * v[2] - turn[2] * v[1], turn[2] * v[0] - turn[0] * v[2], turn[0] * v[1] - turn[1] * v[0]])
        a[2] -= gravity
        return np.concatenate([v, a - ((r @ a + v @ v) / (r @ r)) * r])
    return rates


def motion(times, start, tolerance=1e-11, **what):
    f = right_side(**what)
    s = solve_ivp(f, (0, times[-1]), start, 'DOP853', t_eval=times, rtol=tolerance, atol=tolerance)
    return s.y


def start_at(length, theta, phi, speed, across):
    """On the sphere at the angle theta from straight down; speed in a direction at the angle across in the tangent plane."""
    n = np.array([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), -np.cos(theta)])
    a = np.array([np.cos(theta) * np.cos(phi), np.cos(theta) * np.sin(phi), np.sin(theta)])
    b = np.array([-np.sin(phi), np.cos(phi), 0])
    return np.concatenate([length * n, speed * (np.cos(across) * a + np.sin(across) * b)])


def write(folder, name, scene, header, rows, truth):
    with open(f'{folder}/{name}.nml', 'w') as f:
        f.write(scene)
    with open(f'{folder}/{name}.csv', 'w') as f:
        f.write(','.join(header) + '\n')
        for row in rows:
            f.write(','.join(repr(float(v)) for v in row) + '\n')
    with open(f'{folder}/{name}.truth', 'w') as f:
        json.dump(truth, f)


def wide_start(rng, length, gravity):
    while True:
        theta = np.radians(rng.uniform(20, 130))
        phi = rng.uniform(-np.pi, np.pi)
        speed = rng.uniform(0.1, 1.2) * np.sqrt(gravity * length)
        energy = speed**2 / 2 - gravity * length * np.cos(theta)
        if energy < 0.8 * gravity * length:
            return start_at(length, theta, phi, speed, rng.uniform(-np.pi, np.pi))


def case1(rng, extra):
    length = 10**rng.uniform(-1, 1.3)
    gravity = rng.uniform(1.5, 25)
    start = wide_start(rng, length, gravity)
    period = 2 * np.pi * np.sqrt(length / gravity)
    n = rng.integers(60, 400)
    times = np.arange(n) * period * rng.uniform(3, 30) / n
    sigma = length * 10**rng.uniform(-4, -2)
    s = motion(times, start, length=length, gravity=gravity)
    data = s[:3].T + rng.normal(0, sigma, (n, 3))
    free = 'length gravity position velocity' + (' density_ratio' if extra else '')
    scene = f"&pendulum\n/\n&fit free = '{free}', sigma = {float(sigma)!r} /\n"
    return scene, ['t', 'x', 'y', 'z'], np.column_stack([times, data]), dict(
        length=length, gravity=gravity, position=list(start[:3]), velocity=list(start[3:])), 'density_ratio'


def case2(rng, extra):
    length = rng.uniform(2, 30)
    gravity = rng.uniform(9.78, 9.83)
    latitude = rng.uniform(20, 70)
    amplitude = np.radians(rng.uniform(2, 6))
    period = 2 * np.pi * np.sqrt(length / gravity)
    speed = amplitude * length * 2 * np.pi / period * rng.uniform(0, 0.03)
    start = start_at(length, amplitude, rng.uniform(-np.pi, np.pi), speed, rng.choice([-1, 1]) * np.pi / 2)
    n = 1200
    times = np.arange(n) * 3600 / n
    turn = RATE * np.array([0, np.cos(np.radians(latitude)), np.sin(np.radians(latitude))])
    sigma = 10**rng.uniform(-3.7, -2.7)
    s = motion(times, start, 1e-9, length=length, gravity=gravity, turn=turn)
    data = s[:2].T + rng.normal(0, sigma, (n, 2))
    free = 'length latitude position velocity' + (' gravity' if extra else '')
    scene = f"&pendulum gravity = {gravity!r} /\n&earth_rotation /\n&fit free = '{free}', sigma = {float(sigma)!r} /\n"
    return scene, ['t', 'x', 'y'], np.column_stack([times, data]), dict(
        length=length, latitude=latitude, position=list(start[:3]), velocity=list(start[3:])), 'gravity'


def case3(rng, extra):
    length = 10**rng.uniform(-0.7, 1)
    gravity = rng.uniform(3, 25)
    start = wide_start(rng, length, gravity)
    rate = np.sqrt(gravity / length)
    linear = rate * 10**rng.uniform(-2.5, -1)
    n = rng.integers(100, 400)
    times = np.arange(n) * 2 * np.pi / rate * rng.uniform(4, 20) / n
    sigma = length * 10**rng.uniform(-4, -2.3)
    s = motion(times, start, length=length, gravity=gravity, linear=linear)
    data = s[:3].T + rng.normal(0, sigma, (n, 3))
    free = 'length gravity position velocity linear' + (' density_ratio' if extra else '')
    scene = f"&pendulum\n/\n&air linear = 0.1 /\n&fit free = '{free}', sigma = {float(sigma)!r} /\n"
    if not extra:
        scene = f"&pendulum\n/\n&fit free = '{free}', sigma = {float(sigma)!r} /\n"
    return scene, ['t', 'x', 'y', 'z'], np.column_stack([times, data]), dict(
        length=length, gravity=gravity, linear=linear, position=list(start[:3]), velocity=list(start[3:])), 'density_ratio'


def case4(rng, extra):
    length = 10**rng.uniform(-0.7, 1)
    gravity = rng.uniform(3, 25)
    angle = rng.uniform(10, 120)
    rate = np.sqrt(gravity / length)
    linear = rate * 10**rng.uniform(-3, -1.5)
    start = start_at(length, np.radians(angle), 0, 0, 0)
    f = right_side(length, gravity, linear)
    event = lambda t, s: s[0]
    n = rng.integers(10, 60)
    s = solve_ivp(f, (0, 2 * np.pi / rate * (n + 4)), start, 'DOP853', events=event, rtol=1e-11, atol=1e-11)
    times = s.t_events[0][:n]
    sigma = float(10**rng.uniform(-4, -2.7) / rate)
    data = times + rng.normal(0, sigma, n)
    free = 'gravity linear' + (' length' if extra else '')
    given = '' if extra else f'length = {length!r}, '
    scene = f"&pendulum {given}release_angle = {angle!r} /\n&fit free = '{free}', sigma = {float(sigma)!r} /\n"
    return scene, ['crossing_time'], data[:, None], dict(gravity=gravity, linear=linear), 'length'


def case5(rng, extra):
    length = 10**rng.uniform(-0.7, 1)
    gravity = rng.uniform(9.7, 9.9)
    start = wide_start(rng, length, gravity)
    period = 2 * np.pi * np.sqrt(length / gravity)
    n = rng.integers(100, 400)
    times = np.arange(n) * period * rng.uniform(3, 20) / n
    scale = 10**rng.uniform(1, 3)
    angle = rng.uniform(-30, 30)
    offset = rng.uniform(-2, 2, 2) * length
    s = motion(times, start, length=length, gravity=gravity)
    a = np.radians(angle)
    seen = s[[0, 2]].T + offset
    sigma = scale * length * 10**rng.uniform(-4, -2.3)
    data = scale * seen @ np.array([[np.cos(a), np.sin(a)], [-np.sin(a), np.cos(a)]]) + rng.normal(0, sigma, (n, 2))
    free = 'length position velocity offset scale angle' + (' gravity' if extra else '')
    scene = f"&pendulum gravity = {gravity!r} /\n&camera view = 'xz' /\n&fit free = '{free}', sigma = {float(sigma)!r} /\n"
    return scene, ['t', 'u', 'v'], np.column_stack([times, data]), dict(
        length=length, position=list(start[:3]), velocity=list(start[3:]), offset=list(offset), scale=scale,
        angle=angle), 'gravity'


CASES = [case1, case2, case3, case4, case5]


def make(case, seed, folder, extra=False):
    rng = np.random.default_rng([case, seed])
    scene, header, rows, truth, more = CASES[case - 1](rng, extra)
    name = f'{case}_{seed}' + ('x' if extra else '')
    write(folder, name, scene, header, rows, dict(truth=truth, extra=more))
    return name


if __name__ == '__main__':
    make(int(sys.argv[1]), int(sys.argv[2]), sys.argv[3], len(sys.argv) > 4)
