"""Scenes: simulated, tabled and fitted by the program that the package carries."""
from __future__ import annotations

import json
import os
import re
import subprocess
import tempfile
import warnings
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _kyvadlo
from .orbit import GRAVITY, Orbit

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Scene = Union[str, "os.PathLike[str]", Mapping[str, Mapping[str, Any]]]


def program() -> str:
    """The path of the program ``kyvadlo`` that the package carries."""
    return str(Path(str(_kyvadlo.__file__)).parent/"bin"/"kyvadlo")


class NamedArrays(dict):  # type: ignore[type-arg]
    """Arrays of one length by their names: a dict, as ``pandas.DataFrame`` takes it.

    ``xarray.Dataset`` takes ``variables``, which says along which of the arrays the others lie.
    """

    @property
    def variables(self) -> dict[str, tuple[str, NDArray[Any]]]:
        """Each array with its dimension: the name of the first one, which is its coordinate."""
        first = next(iter(self))
        return {name: (first, array) for name, array in self.items()}


class Samples(NamedArrays):
    """The samples of a simulated scene; ``events`` are those of a string, ``scene`` is the text that was run."""

    events: NamedArrays
    scene: str

    def plot(self) -> Figure:
        """Draws the path from above and the height over time, by matplotlib."""
        from .pictures import draw_motion
        if not {"x", "y", "z"} <= self.keys():
            raise ValueError("the scene has no position among its quantities")
        return draw_motion(self["t"], self["x"], self["y"], self["z"])


class PeriodTable(NamedArrays):
    """Periods over a grid of turning heights."""

    def plot(self, what: str = "period") -> Figure:
        """Draws a quantity over the lower turning height, a line for each upper one, by matplotlib."""
        from .pictures import draw_table
        return draw_table(self, what)


class Fit(dict):  # type: ignore[type-arg]
    """What a fit found, as the program's JSON says it: ``parameters`` with value and sigma, ``chi2``, ``scene``, ...

    ``residuals`` has the columns ``t``, ``column``, ``measured``, ``model``, ``residual``, ``residual_in_sigmas``.
    """

    residuals: NamedArrays

    def plot(self) -> Figure:
        """Draws what was measured beside the model, and the residuals, over time, by matplotlib."""
        from .pictures import draw_fit
        return draw_fit(self.residuals)


def scene_text(groups: Mapping[str, Mapping[str, Any]]) -> str:
    """A dict of groups in the form of a scene file.

    Examples
    --------
    >>> from kyvadlo.scenes import scene_text
    >>> print(scene_text({"pendulum": {"length": 1.0, "position": [0.6, 0, -0.8], "velocity": (0, 1, 0)}}))
    &pendulum
       length = 1.0
       position = 0.6, 0, -0.8
       velocity = 0, 1, 0
    /
    """
    lines = []
    for group, settings in groups.items():
        lines.append(f"&{group}")
        lines += [f"   {name} = {_value_text(value)}" for name, value in settings.items()]
        lines.append("/")
    return "\n".join(lines)


def _value_text(value: Any) -> str:
    if isinstance(value, (bool, np.bool_)):
        return ".true." if value else ".false."
    if isinstance(value, str):
        return "'" + value.replace("'", "''") + "'"
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    items = list(value)
    if items and all(isinstance(item, str) for item in items):
        return _value_text(" ".join(items))
    return ", ".join(_value_text(item) for item in items)


def _run(arguments: Sequence[str], scene: Scene, *rest: str) -> tuple[str, str]:
    """What the program prints for a scene, and the scene's text; its messages are ValueError or warnings.

    Status 1 is an answer too: a fit without a minimum.
    """
    if isinstance(scene, Mapping):
        text, name = scene_text(scene), "-"
    elif isinstance(scene, str) and "&" in scene:
        text, name = scene, "-"
    else:
        name = os.fspath(scene)
        text = Path(name).read_text(encoding="utf-8")
        name = os.path.abspath(name)
    done = subprocess.run([program(), *arguments, "--", name, *rest], input=text if name == "-" else None,
                          stdin=None if name == "-" else subprocess.DEVNULL, capture_output=True, encoding="utf-8",
                          check=False)
    message = re.sub(r"^kyvadlo: ", "", done.stderr.strip(), flags=re.MULTILINE)
    if done.returncode not in (0, 1):
        raise ValueError(message or f"the program ended with status {done.returncode}")
    if message:
        warnings.warn(message, stacklevel=3)
    return done.stdout, text


def _columns(text: str) -> dict[str, NDArray[np.float64]]:
    """The columns of CSV: comment lines are passed over, an empty field is NaN. The numbers are read bit for bit."""
    head, _, body = text.partition("\n")
    names = head.split(",")
    if "\n#" in "\n" + body:
        body = re.sub(r"^#.*\n?", "", body, flags=re.MULTILINE)
    while ",," in body:
        body = body.replace(",,", ",nan,")
    body = body.replace(",\n", ",nan\n").replace("\n", ",").rstrip(",")
    numbers = np.array([]) if body == "" else np.fromstring(body, dtype=np.float64, sep=",")
    table = numbers.reshape(-1, len(names))
    return {name: np.ascontiguousarray(table[:, i]) for i, name in enumerate(names)}


def _rows(path: str, words: str) -> NamedArrays:
    """The columns of a CSV file, of which that named ``words`` holds words."""
    with open(path, encoding="utf-8") as file:
        rows = [line.rstrip("\n").split(",") for line in file]
    return NamedArrays({
        name: np.array([row[i] if name == words else float(row[i] or "nan") for row in rows[1:]],
                       dtype=object if name == words else np.float64) for i, name in enumerate(rows[0])})


def simulate(scene: Scene, *, accuracy: Optional[float] = None, threads: int = 1,
             pendulum: Optional[str] = None) -> Samples:
    """Computes one pendulum over time.

    Parameters
    ----------
    scene : path, str or dict of dict
        The path of a scene file, its text (which has an ``&``), or its groups and their names (doc/scene_format.md).
    accuracy : float, optional
        Of the places, in lengths; all digits without it. Of a step, where the motion is integrated.
    threads : int
        That share the work; 0: all there are.
    pendulum : str, optional
        Name or number of one, where the scene has several.

    Returns
    -------
    Samples
        A dict of arrays: ``t`` [s] and the columns of the quantities that the scene asks for, in SI units.

    Raises
    ------
    ValueError
        With the program's message: what is wrong with the scene, in which line; or that this build has no integrator for an
        effect of the scene (a wheel without GSL).

    Examples
    --------
    >>> import kyvadlo
    >>> samples = kyvadlo.simulate({"pendulum": {"length": 1.0, "z_upper": 0.3, "z_lower": -0.8},
    ...                             "output": {"duration": 1.0, "samples": 5, "quantities": ["position", "energy"]}})
    >>> list(samples)
    ['t', 'x', 'y', 'z', 'energy']
    >>> samples["z"].round(6)
    array([ 0.3     , -0.096213, -0.77668 , -0.372873,  0.250522])
    """
    options = ["--threads", str(threads)]
    if accuracy is not None:
        options += ["--accuracy", repr(float(accuracy))]
    if pendulum is not None:
        options += ["--pendulum", str(pendulum)]
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "events.csv")
        printed, text = _run(["simulate", *options, "--events", name], scene)
        events = _rows(name, "event")
    samples = Samples(_columns(printed))
    samples.scene = text
    samples.events = events
    return samples


def period_table(upper: ArrayLike, lower: ArrayLike, length: float = 1.0, gravity: float = GRAVITY) -> PeriodTable:
    """Periods of a grid of turning heights.

    Parameters
    ----------
    upper, lower : array_like
        Turning heights above the pivot [m]; every upper one is paired with every lower one.
    length : float
        Of the pendulum [m].
    gravity : float
        Acceleration of gravity [m/s2].

    Returns
    -------
    PeriodTable
        A dict of arrays, a row for each pair: ``upper``, ``lower`` [m], ``period`` [s], ``modulus``, ``azimuth_per_period``,
        ``advance`` [rad]; NaN where a pair belongs to no orbit.

    Examples
    --------
    >>> import kyvadlo
    >>> kyvadlo.period_table([0.3], [-0.9, -0.8])["period"].round(7)
    array([1.1890708, 1.0867933])
    """
    pairs = [(float(a), float(b)) for a in np.ravel(upper) for b in np.ravel(lower)]
    rows = np.full((len(pairs), 4), np.nan)
    for row, (a, b) in zip(rows, pairs):
        try:
            orbit = Orbit.from_heights(length, gravity, a, b)
        except ValueError:
            continue
        row[:] = orbit.period, orbit.modulus, orbit.azimuth_per_period, orbit.advance
    table = PeriodTable(zip(("upper", "lower"), np.array(pairs, dtype=np.float64).reshape(-1, 2).T.copy()))
    table.update(zip(("period", "modulus", "azimuth_per_period", "advance"), rows.T.copy()))
    return table


def fit(scene: Scene, data: Union[str, os.PathLike[str], Mapping[str, ArrayLike]], *options: str) -> Fit:
    """Fits a scene to measured data, by ``kyvadlo fit``.

    Parameters
    ----------
    scene : path, str or dict of dict
        As for `simulate`; its ``&fit`` group says what is sought.
    data : path or dict of arrays
        Measured values: a CSV file, or its columns by their names, ``t`` first.
    *options : str
        Further options of ``kyvadlo fit``.

    Returns
    -------
    Fit
        A dict: what the program writes as JSON. ``converged`` is False where no minimum was found.

    Raises
    ------
    ValueError
        With the program's message; always, where the package was built without GSL.
    """
    with tempfile.TemporaryDirectory() as folder:
        if isinstance(data, Mapping):
            path = os.path.join(folder, "data.csv")
            with open(path, "w", encoding="utf-8") as file:
                print(*data, sep=",", file=file)
                for row in zip(*(np.asarray(column, dtype=np.float64) for column in data.values())):
                    print(*("" if np.isnan(value) else repr(float(value)) for value in row), sep=",", file=file)
        else:
            path = os.path.abspath(data)
        residuals = os.path.join(folder, "residuals.csv")
        printed, _ = _run(["fit", "--format", "json", "--residuals", residuals, *options], scene, path)
        found = Fit(json.loads(printed))
        found.residuals = _rows(residuals, "column")
    return found
