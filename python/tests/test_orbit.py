"""Orbits: laws of physics, errors, copies, threads. Their values are held to mpmath's in test_references.py."""
import copy
import pickle
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as shapes

import kyvadlo
from kyvadlo import Orbit

G = kyvadlo.GRAVITY
WIDE = Orbit.from_heights(1.0, G, 0.3, -0.8)
ALL = [WIDE, Orbit.from_gaps(2.0, G, 0.7, 0.2), Orbit.from_rises(1.0, G, 0.4, 0.1), Orbit.from_energy(1.0, G, -2.0, 1.5),
       Orbit.from_energy(1.0, G, -3.0, 1.5, above="top"), Orbit.from_energy(1.0, G, 6.0, -1.5, above="bottom"),
       Orbit.from_release(1.0, G, 60.0, 1.2), Orbit.from_state(1.0, G, [0.6, 0, -0.8], [0.8, 1.0, 0.6])]


@pytest.mark.parametrize("orbit", ALL, ids=repr)
def test_laws_of_physics(orbit):
    """On the sphere, along it, energy and momentum kept, and Newton's equation by differences of the velocity."""
    t = np.linspace(-20, 20, 101)
    x, v = orbit.state(t)
    length, gravity = orbit.length, orbit.gravity
    np.testing.assert_allclose(np.linalg.norm(x, axis=-1), length, rtol=1e-15*8)
    np.testing.assert_allclose((x*v).sum(-1), 0, atol=1e-14*length*np.sqrt(gravity*length))
    np.testing.assert_allclose((v*v).sum(-1)/2 + gravity*x[:, 2], orbit.energy, rtol=1e-13, atol=1e-13*gravity*length)
    np.testing.assert_allclose(x[:, 0]*v[:, 1] - x[:, 1]*v[:, 0], orbit.momentum, rtol=1e-13)
    h = 1e-5
    force = (orbit.velocity(t + h) - orbit.velocity(t - h))/(2*h) + np.array([0, 0, gravity])
    np.testing.assert_allclose(np.cross(force, x), 0, atol=1e-6*gravity*length)
    np.testing.assert_allclose(-(force*x).sum(-1)/length, orbit.tension(t), rtol=1e-6)
    np.testing.assert_allclose(orbit.height(t), x[:, 2], atol=1e-14*length)
    np.testing.assert_allclose(np.cos(orbit.azimuth(t)), x[:, 0]/np.hypot(x[:, 0], x[:, 1]), atol=1e-13)
    np.testing.assert_allclose(orbit.speed(t), np.linalg.norm(v, axis=-1), rtol=1e-12)
    np.testing.assert_allclose(orbit.height(t + orbit.period), orbit.height(t), atol=1e-13*length)
    np.testing.assert_allclose(orbit.azimuth(t + orbit.period) - orbit.azimuth(t), orbit.azimuth_per_period, rtol=1e-12)
    turning = orbit.turning_heights
    assert turning.lower <= turning.upper < turning.outer and np.pi/2 < abs(orbit.apsidal_angle) < np.pi
    assert orbit.advance == pytest.approx(np.copysign(abs(orbit.azimuth_per_period) - np.pi, orbit.azimuth_per_period), rel=1e-13)
    assert orbit.modulus**2 + orbit.complementary_modulus**2 == pytest.approx(1, rel=1e-15)
    assert kyvadlo.ellipk(orbit.modulus**2) == pytest.approx(orbit.quarter_period, rel=1e-14)
    assert kyvadlo.nome(orbit.modulus**2) == pytest.approx(orbit.nome, rel=1e-13)


@pytest.mark.parametrize("orbit", ALL, ids=repr)
def test_derivatives_are_those_of_the_motion(orbit):
    found = orbit.derivatives([0.0, 0.7, 3.0])
    assert found.matrices.shape == (3, 6, len(found.columns)) and found.columns[-1] == "t"
    np.testing.assert_allclose(found.states, np.concatenate(orbit.state([0.0, 0.7, 3.0]), axis=-1), atol=1e-12)
    h = 1e-6
    slope = (np.concatenate(orbit.state(0.7 + h), axis=-1) - np.concatenate(orbit.state(0.7 - h), axis=-1))/(2*h)
    np.testing.assert_allclose(found.matrices[1, :, -1], slope, atol=1e-7)
    if found.columns[0] == "length":   # by differences of the first number
        numbers = [orbit.length, orbit.gravity, *orbit._given]
        for k in range(4):
            ends = []
            for sign in (1, -1):
                moved = list(numbers)
                moved[k] += sign*h
                ends.append(Orbit._make(orbit._maker, *moved))
            slope = (np.concatenate(ends[0].state(0.7)) - np.concatenate(ends[1].state(0.7)))/(2*h)
            np.testing.assert_allclose(found.matrices[1, :, k], slope, atol=1e-6)
            assert found.period[k] == pytest.approx((ends[0].period - ends[1].period)/(2*h), rel=1e-6, abs=1e-8)
            assert found.advance[k] == pytest.approx((ends[0].advance - ends[1].advance)/(2*h), rel=1e-5, abs=1e-7)


@settings(deadline=None, max_examples=50)
@given(shapes.arrays(np.float64, shapes.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=4),
                     elements=st.floats(-1e6, 1e6)))
def test_times_of_any_shape(t):
    for view in (t, np.asfortranarray(t), np.repeat(t[None], 2, axis=0)[1], t.astype(">f8")):
        x, v = WIDE.state(view)
        assert x.shape == v.shape == view.shape + (3,)
        assert np.shape(WIDE.height(view)) == view.shape and WIDE.derivatives(view).matrices.shape == view.shape + (6, 5)
        for index in np.ndindex(view.shape):
            assert (x[index] == WIDE.locate(view[index])).all()


def test_references_are_counted():
    """None is not immortal before Python 3.12."""
    before = sys.getrefcount(None)
    for _ in range(1000):
        WIDE.locate(1.0), WIDE.height(1.0), WIDE.derivatives(1.0)
    assert abs(sys.getrefcount(None) - before) < 500


def test_nan_and_infinite_times():
    assert np.isnan(WIDE.locate([np.nan, np.inf, -np.inf])).all() and np.isnan(WIDE.height(np.nan))


def test_other_times_are_taken_as_numbers():
    assert (WIDE.locate(2) == WIDE.locate(2.0)).all() and (WIDE.locate([1, 2])[1] == WIDE.locate(2.0)).all()
    assert isinstance(WIDE.height(1), float)
    with pytest.raises((TypeError, ValueError)):
        WIDE.locate("soon")


@pytest.mark.parametrize("make, message", [
    (lambda: Orbit.from_heights(1.0, G, 0.8, 0.3), "their sum must be negative, got upper = 0.8, lower = 0.3"),
    (lambda: Orbit.from_heights(-1.0, G, 0.3, -0.8), "length must be positive"),
    (lambda: Orbit.from_gaps(1.0, 0.0, 0.3, 0.2), "gravity"),
    (lambda: Orbit.from_rises(1.0, G, np.nan, 0.2), "upper_rise"),
    (lambda: Orbit.from_energy(1.0, G, -20.0, 0.0), "energy"),
    (lambda: Orbit.from_state(1.0, G, [0, 0, -2], [0, 1, 0]), "position"),
    (lambda: Orbit.from_state(1.0, G, [0, 0], [0, 1, 0]), "position must be three numbers"),
    (lambda: Orbit.from_energy(1.0, G, 1.0, 1.0, above="moon"), "above must be"),
])
def test_errors_are_valueerrors_with_the_librarys_message(make, message):
    with pytest.raises(ValueError, match=message.replace(".", "[.]")):
        make()


def test_an_orbit_has_no_other_maker():
    with pytest.raises(TypeError, match="from_heights"):
        Orbit()


@pytest.mark.parametrize("orbit", ALL, ids=repr)
def test_copies_pickles_hash_repr(orbit):
    for other in (copy.copy(orbit), copy.deepcopy(orbit), pickle.loads(pickle.dumps(orbit)), eval(repr(orbit), {"Orbit": Orbit})):
        assert other == orbit and hash(other) == hash(orbit) and len({orbit, other}) == 1
        assert (other.locate([0.0, 7.5]) == orbit.locate([0.0, 7.5])).all()
    assert orbit != Orbit.from_heights(1.0, G, 0.2, -0.8) and orbit != 3
    with pytest.raises(AttributeError, match="cannot be changed"):
        orbit.length = 2


def test_threads():
    """Two orbits asked by four threads, and long arrays shared by two: the bits of one thread."""
    t = np.linspace(0, 1e4, 50000)
    expected = {orbit: orbit.state(t) for orbit in ALL[:2]}
    with ThreadPoolExecutor(4) as pool:
        for orbit, got in zip(ALL[:2]*4, pool.map(lambda orbit: orbit.state(t), ALL[:2]*4)):
            assert all((a == b).all() for a, b in zip(got, expected[orbit]))
    for got, wanted in zip(WIDE.state(t, threads=2), expected[WIDE]):
        assert (got == wanted).all()


def test_many_orbits_at_once():
    gaps, rises = np.linspace(0.05, 1.7, 300), np.linspace(0.01, 0.04, 300)[::-1]
    period, advance = kyvadlo.periods_from_gaps(1.0, 9.8, gaps, rises)
    constants = kyvadlo.constants_from_gaps(1.0, 9.8, gaps, rises)
    position, velocity = kyvadlo.locate_from_gaps(1.0, 9.8, gaps, rises, 2.5, threads=2)
    for i in range(0, 300, 13):
        orbit = kyvadlo.Orbit.from_gaps(1.0, 9.8, gaps[i], rises[i])
        assert abs(period[i] - orbit.period) <= 4*np.spacing(orbit.period)
        assert abs(advance[i] - orbit.advance) <= 8*np.spacing(orbit.advance)
        assert abs(constants[i, 4] - orbit.nome) <= 8*np.spacing(orbit.nome)
        assert abs(constants[i, 7] - orbit.advance) <= 8*np.spacing(orbit.advance)
        state = np.concatenate(orbit.state(2.5))
        assert np.max(np.abs(np.concatenate([position[i], velocity[i]]) - state)) <= 1e-13
    assert np.isnan(kyvadlo.periods_from_gaps(1.0, 9.8, 0.1, 0.2)).all()
    assert np.isnan(kyvadlo.constants_from_gaps(1.0, 9.8, 0.1, 0.2)).all()
    assert kyvadlo.constants_from_gaps(1.0, 9.8, np.ones((2, 3)), 0.5).shape == (2, 3, 8)
    assert kyvadlo.locate_from_gaps(1.0, 9.8, np.ones((2, 3)), 0.5, 0.0)[0].shape == (2, 3, 3)
