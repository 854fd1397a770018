"""Scenes by the program that the package carries."""
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import kyvadlo
from kyvadlo.scenes import program, scene_text

SCENE = {"pendulum": {"name": "it's wide", "length": 1.0, "z_upper": 0.3, "z_lower": -0.8},
         "output": {"duration": 3.0, "samples": 301, "quantities": ["position", "velocity", "energy"]}}
HAS_GSL = "no integrator" not in subprocess.run([program(), "simulate", "-"], input="&pendulum length=1 release_angle=5/\n&air linear=1/",
                                    capture_output=True, text=True, check=False).stderr


def test_program_is_the_program():
    printed = subprocess.run([sys.executable, "-m", "kyvadlo", "eval", "K", "0.5"], capture_output=True, text=True, check=True)
    assert float(printed.stdout) == kyvadlo.ellipk(0.5)
    failed = subprocess.run([sys.executable, "-m", "kyvadlo", "table", "--no-such"], capture_output=True, text=True, check=False)
    assert failed.returncode == 2 and "no-such" in failed.stderr
    assert kyvadlo.__version__ in subprocess.run([program(), "--version"], capture_output=True, text=True, check=True).stdout


def test_samples_are_the_orbits():
    samples = kyvadlo.simulate(SCENE)
    assert list(samples) == ["t", "x", "y", "z", "vx", "vy", "vz", "energy"] and len(samples["t"]) == 301
    orbit = kyvadlo.Orbit.from_heights(1.0, kyvadlo.GRAVITY, 0.3, -0.8)
    positions, velocities = orbit.state(samples["t"])
    assert np.abs(positions - np.column_stack([samples[name] for name in "xyz"])).max() < 2e-15
    assert np.abs(velocities - np.column_stack([samples[name] for name in ("vx", "vy", "vz")])).max() < 2e-14


def test_a_path_a_text_and_a_dict_are_one_scene(tmp_path):
    text = scene_text(SCENE)
    path = tmp_path/"scene with blanks.nml"
    path.write_text(text)
    runs = [kyvadlo.simulate(scene) for scene in (SCENE, text, path, str(path))]
    for other in runs[1:]:
        assert other.scene == text and all((other[name] == runs[0][name]).all() for name in runs[0])
    printed = subprocess.run([program(), "simulate", path], capture_output=True, text=True, check=True).stdout
    rows = np.array([[float(word) for word in line.split(",")] for line in printed.splitlines()[1:]])
    assert (np.column_stack(list(runs[0].values())) == rows).all()


def test_values_of_every_kind():
    text = scene_text({"group": {"a": True, "b": np.float64(0.1), "c": np.int64(3), "d": np.array([1.5, 2]), "e": "don't"}})
    assert text == "&group\n   a = .true.\n   b = 0.1\n   c = 3\n   d = 1.5, 2.0\n   e = 'don''t'\n/"


def test_events_and_empty_fields():
    string = {"pendulum": {"length": 1, "position": [0.6, 0, 0.8], "velocity": [0, 1.2, 0]}, "string": {"restitution": 0.2},
              "output": {"duration": 5, "samples": 51}}
    samples = kyvadlo.simulate(string)
    assert samples.events["event"][0] == "slack" and len(samples.events["t"]) > 10 and len(samples["t"]) == 51
    assert len(kyvadlo.simulate(SCENE).events["t"]) == 0
    rest = {"pendulum": {"length": 1, "release_angle": 0}, "output": {"duration": 1, "samples": 3, "quantities": "azimuth position"}}
    samples = kyvadlo.simulate(rest)
    assert np.isnan(samples["azimuth"]).all() and (samples["z"] == -1).all()


def test_errors_are_the_programs(tmp_path):
    with pytest.raises(ValueError, match="standard input:3: &pendulum: unknown name z_uper"):
        kyvadlo.simulate({"pendulum": {"length": 1, "z_uper": 0.3}})
    with pytest.raises(FileNotFoundError):
        kyvadlo.simulate(tmp_path/"absent.nml")
    with pytest.warns(UserWarning, match="top_gap"):
        kyvadlo.simulate("&pendulum length=1 top_gap=0.7 bottom_gap=0.2 /")


@pytest.mark.skipif(HAS_GSL, reason="this build integrates")
def test_without_an_integrator_effects_are_refused():
    with pytest.raises(ValueError, match="no integrator .CMake option KYVADLO_WITH_GSL. for &air"):
        kyvadlo.simulate({"pendulum": {"length": 1, "release_angle": 20}, "air": {"linear": 0.1}})


@pytest.mark.skipif(not HAS_GSL, reason="this build does not integrate")
def test_effects_are_integrated():
    damped = kyvadlo.simulate({"pendulum": {"length": 1, "release_angle": 1}, "air": {"linear": 0.1},
                               "output": {"duration": 60, "samples": 601}})
    assert np.hypot(damped["x"], damped["y"])[-100:].max() < 0.1*np.sin(np.radians(1))


FREE = {**SCENE, "fit": {"free": "length z_upper"}}
T = np.linspace(0, 3, 61)


@pytest.mark.skipif(HAS_GSL, reason="this build fits")
def test_without_gsl_a_fit_is_refused():
    with pytest.raises(ValueError, match="fit"):
        kyvadlo.fit(FREE, {"t": T, "z": np.zeros(61)})


@pytest.mark.skipif(not HAS_GSL, reason="this build does not fit")
def test_a_fit_finds_what_made_the_data(tmp_path):
    truth = kyvadlo.Orbit.from_heights(1.05, kyvadlo.GRAVITY, 0.25, -0.8)
    noise = 1e-4*np.random.default_rng(5).standard_normal((61, 3))
    measured = dict(zip("xyz", truth.locate(T).T + noise.T), t=T)
    scene = {"pendulum": {"length": 1.0, "position": [0.9, 0, 0.2], "velocity": [0, 3, 0]},
             "fit": {"free": "length position velocity"}}
    found = kyvadlo.fit(scene, measured)
    assert found["converged"] and abs(found["parameters"]["length"]["value"] - 1.05) < 5*found["parameters"]["length"]["sigma"]
    assert len(found.residuals["t"]) == 183 and abs(found.residuals["residual_in_sigmas"]).max() < 6
    assert isinstance(kyvadlo.simulate(found["scene"])["z"][0], float)
    pytest.importorskip("matplotlib.pyplot").switch_backend("agg")
    assert len(found.plot().axes[0].lines) == 6


def test_period_table():
    table = kyvadlo.period_table([-0.9, 0.0, 0.9], [-1.0, -0.5, 0.0])
    assert len(table["period"]) == 9 and np.isnan(table["period"]).sum() == 5
    printed = subprocess.run([program(), "table", "--upper", "-0.9:0.9:3", "--lower", "-1:0:3", "--format", "csv"],
                             capture_output=True, text=True, check=True).stdout
    rows = np.array([[float(word) for word in line.split(",")] for line in printed.splitlines()[1:] if line[0] != "#"])
    there = ~np.isnan(table["period"])
    np.testing.assert_allclose(np.column_stack([table[name][there] for name in table]), rows, rtol=1e-14, atol=1e-15)


def test_pandas_and_xarray_take_them():
    samples, table = kyvadlo.simulate(SCENE), kyvadlo.period_table([0.3], [-0.8, -0.9])
    pandas = pytest.importorskip("pandas")
    assert pandas.DataFrame(samples).shape == (301, 8) and pandas.DataFrame(table).shape == (2, 6)
    xarray = pytest.importorskip("xarray")
    dataset = xarray.Dataset(samples.variables)
    assert dict(dataset.sizes) == {"t": 301} and float(dataset.x.sel(t=0)) == samples["x"][0]


def test_pictures(tmp_path):
    pyplot = pytest.importorskip("matplotlib.pyplot")
    pyplot.switch_backend("agg")
    samples, table = kyvadlo.simulate(SCENE), kyvadlo.period_table([0.3, 0.1], np.linspace(-0.9, -0.5, 9))
    orbit = kyvadlo.Orbit.from_release(1.0, kyvadlo.GRAVITY, 40, 0.5)
    for i, figure in enumerate([samples.plot(), table.plot(), table.plot("advance"), orbit.plot(periods=3)]):
        figure.savefig(tmp_path/f"{i}.png")
        assert os.path.getsize(tmp_path/f"{i}.png") > 5000
        lines = [line for axes in figure.axes for line in axes.lines]
        assert lines and all(np.isfinite(line.get_ydata()).any() for line in lines)
    assert (samples.plot().axes[0].lines[0].get_xdata() == samples["x"]).all()
    with pytest.raises(ValueError, match="no position"):
        kyvadlo.simulate({**SCENE, "output": {"quantities": "energy"}}).plot()
    pyplot.close("all")
