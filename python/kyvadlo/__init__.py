"""The spherical pendulum in closed form, and the elliptic functions it needs.

Functions are NumPy ufuncs: `ellipk`, `ellipkinc`, `ellipj`, `elliprf`, ... by SciPy's names, and more (`functions`).
Motions: `Orbit`, `periods_from_gaps`, `constants_from_gaps`, `locate_from_gaps`, `simulate`, `period_table`, `fit`.
``python -m kyvadlo`` is the program.
"""
from importlib import metadata as _metadata

from . import functions
from .functions import *  # noqa: F403
from .many_orbits import constants_from_gaps, locate_from_gaps, periods_from_gaps
from .orbit import GRAVITY, Derivatives, Orbit, TurningHeights
from .scenes import Fit, NamedArrays, PeriodTable, Samples, fit, period_table, simulate

try:
    __version__ = _metadata.version("kyvadlo")
except _metadata.PackageNotFoundError:  # found by its folder, not installed
    __version__ = "unknown"

__all__ = [*functions.__all__, "GRAVITY", "Derivatives", "Fit", "NamedArrays", "Orbit", "PeriodTable", "Samples",
           "TurningHeights", "constants_from_gaps", "fit", "locate_from_gaps", "period_table", "periods_from_gaps", "simulate"]
