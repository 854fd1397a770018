"""Many orbits of one pendulum at once, each evaluated once, without setting them up."""
from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _kyvadlo

__all__ = ["constants_from_gaps", "locate_from_gaps", "periods_from_gaps"]

_Array = NDArray[np.float64]


def _pair(upper_gap: ArrayLike, lower_rise: ArrayLike) -> tuple[_Array, _Array]:
    a, b = np.broadcast_arrays(np.asarray(upper_gap, dtype=np.float64), np.asarray(lower_rise, dtype=np.float64))
    return a.copy(order="C"), b.copy(order="C")


def periods_from_gaps(length: float, gravity: float, upper_gap: ArrayLike, lower_rise: ArrayLike,
                      threads: int = 1) -> tuple[_Array, _Array]:
    """Periods and advances of many orbits.

    Parameters
    ----------
    length, gravity : float
        Of the pendulum [m], [m/s2].
    upper_gap, lower_rise : array_like
        The gaps l - z1 at the top and l + z2 at the bottom [m]; they are broadcast.
    threads : int
        How many share the work; 0: as many as OpenMP offers.

    Returns
    -------
    period, advance : ndarray
        T [s] and phi(T) - pi [rad], by which the apsides advance in a period; NaN where there is no such orbit.

    Examples
    --------
    >>> import kyvadlo
    >>> period, advance = kyvadlo.periods_from_gaps(1.0, 9.80665, [0.7, 1.2], 0.2)
    >>> period.round(7)
    array([1.1890708, 1.0411962])
    """
    a, b = _pair(upper_gap, lower_rise)
    period, advance = np.empty(a.shape), np.empty(a.shape)
    _kyvadlo.periods_from_gaps(length, gravity, a, b, period, advance, threads)
    return period, advance


def constants_from_gaps(length: float, gravity: float, upper_gap: ArrayLike, lower_rise: ArrayLike,
                        threads: int = 1) -> _Array:
    """Eight constants of many orbits.

    Parameters
    ----------
    length, gravity, upper_gap, lower_rise, threads
        As of `periods_from_gaps`.

    Returns
    -------
    constants : ndarray
        The shape of the gaps, and 8 more: T [s], k, k', K, q, A [1/s], phi(T) [rad] and the advance phi(T) - pi [rad]; NaN
        where there is no such orbit.

    Examples
    --------
    >>> import kyvadlo
    >>> kyvadlo.constants_from_gaps(1.0, 9.80665, [0.7, 1.2], 0.2)[:, 1].round(7)
    array([0.7157218, 0.5069379])
    """
    a, b = _pair(upper_gap, lower_rise)
    constants = np.empty(a.shape + (8,))
    _kyvadlo.constants_from_gaps(length, gravity, a, b, constants, threads)
    return constants


def locate_from_gaps(length: float, gravity: float, upper_gap: ArrayLike, lower_rise: ArrayLike, t: float,
                     threads: int = 1) -> tuple[_Array, _Array]:
    """Positions and velocities of many orbits at one time, counted from the upper turning height at azimuth 0.

    The period has the digits of a double only: of an orbit that is evaluated often, or after millions of periods, use
    `Orbit.from_gaps`.

    Parameters
    ----------
    length, gravity, upper_gap, lower_rise, threads
        As of `periods_from_gaps`.
    t : float
        The time [s].

    Returns
    -------
    position, velocity : ndarray
        The shape of the gaps, and 3 more: x, y, z [m] and [m/s]; NaN where there is no such orbit.

    Examples
    --------
    >>> import kyvadlo
    >>> position, velocity = kyvadlo.locate_from_gaps(1.0, 9.80665, [0.7, 1.2], 0.2, 0.0)
    >>> position.shape
    (2, 3)
    """
    a, b = _pair(upper_gap, lower_rise)
    position, velocity = np.empty(a.shape + (3,)), np.empty(a.shape + (3,))
    _kyvadlo.locate_from_gaps(length, gravity, a, b, t, position, velocity, threads)
    return position, velocity
