"""The exact motion of one pendulum."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _kyvadlo

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Standard gravity [m/s2].
GRAVITY = 9.80665

_Array = NDArray[np.float64]
_Given = Union[float, tuple[float, ...]]

_ARGUMENTS = {
    "heights": ("upper", "lower"),
    "gaps": ("upper_gap", "lower_rise"),
    "rises": ("upper_rise", "lower_rise"),
    "energy": ("energy", "momentum"),
    "energy_above_top": ("energy", "momentum"),
    "energy_above_bottom": ("energy", "momentum"),
    "release": ("angle", "speed"),
    "state": ("position", "velocity"),
}


class TurningHeights(NamedTuple):
    """Heights z2, z1, z3 and the distances between them and the poles, each to its last digits [m]."""

    lower: float
    upper: float
    outer: float
    lower_rise: float
    upper_gap: float
    swing: float
    outer_gap: float
    outer_excess: float


class Derivatives(NamedTuple):
    """States at the times asked for and their exact derivatives; ``columns`` names what they are taken along."""

    states: _Array    #: (..., 6): x y z vx vy vz
    matrices: _Array  #: (..., 6, columns)
    period: _Array    #: (columns - 1,), all but t: of the period
    advance: _Array   #: (columns - 1,): of the advance of the apsides over a period
    columns: tuple[str, ...]


class Orbit:
    """The motion of a spherical pendulum in closed form.

    Made by one of the class methods ``from_heights``, ``from_gaps``, ``from_rises``, ``from_energy``, ``from_release``,
    ``from_state``, once; then asked as often as you like. Immutable: orbits compare, hash, copy and pickle by the numbers
    that made them, and any number of threads may ask one.

    Parameters
    ----------
    length : float
        Radius l of the sphere [m].
    gravity : float
        Acceleration of gravity g [m/s2].

    Raises
    ------
    ValueError
        If the numbers determine no orbit; the message names the rule and the values.

    Notes
    -----
    Heights z are counted upwards from the pivot, times from an upper turning point (of a state or a release: from the
    start), azimuths from the x axis. Nothing is integrated: positions and velocities at any time have an error of some
    ulps of the length. Motion: Jacobi's elliptic functions and theta functions; formulas: doc/formulas.md.

    Examples
    --------
    >>> import kyvadlo
    >>> orbit = kyvadlo.Orbit.from_heights(1.0, 9.80665, upper=0.3, lower=-0.8)
    >>> print(f"{orbit.period:.10f}")
    1.0867932820
    >>> orbit.locate([0.0, orbit.period/2]).round(6)
    array([[ 0.953939,  0.      ,  0.3     ],
           [-0.538323,  0.264969, -0.8     ]])
    """

    __slots__ = ("_bytes", "_constants", "_maker", "gravity", "length", "_given")
    length: float
    gravity: float
    _bytes: bytes
    _constants: tuple[float, ...]
    _maker: str
    _given: tuple[_Given, _Given]

    def __init__(self) -> None:
        raise TypeError("an Orbit is made by Orbit.from_heights, from_gaps, from_rises, from_energy, from_release or "
                        "from_state")

    @classmethod
    def _make(cls, maker: str, length: float, gravity: float, a: _Given, b: _Given) -> Orbit:
        self = object.__new__(cls)
        data = _kyvadlo.orbit(maker, length, gravity, a, b)
        for name, value in (("length", float(length)), ("gravity", float(gravity)), ("_maker", maker), ("_given", (a, b)),
                            ("_bytes", data), ("_constants", _kyvadlo.constants(data))):
            object.__setattr__(self, name, value)
        return self

    @classmethod
    def from_heights(cls, length: float, gravity: float, upper: float, lower: float) -> Orbit:
        """From the turning heights z1 >= z2 above the pivot [m]; z1 + z2 < 0."""
        return cls._make("heights", length, gravity, float(upper), float(lower))

    @classmethod
    def from_gaps(cls, length: float, gravity: float, upper_gap: float, lower_rise: float) -> Orbit:
        """From l - z1 and l + z2 [m]: for passages near the upright. lower_rise < upper_gap."""
        return cls._make("gaps", length, gravity, float(upper_gap), float(lower_rise))

    @classmethod
    def from_rises(cls, length: float, gravity: float, upper_rise: float, lower_rise: float) -> Orbit:
        """From l + z1 >= l + z2 [m]: for small swings."""
        return cls._make("rises", length, gravity, float(upper_rise), float(lower_rise))

    @classmethod
    def from_energy(cls, length: float, gravity: float, energy: float, momentum: float, above: str = "pivot") -> Orbit:
        """From energy [m2/s2] and angular momentum about the vertical [m2/s] per mass.

        The energy is 0 at rest at the height of the pivot; ``above="top"`` or ``"bottom"`` counts it from rest there.
        """
        makers = {"pivot": "energy", "top": "energy_above_top", "bottom": "energy_above_bottom"}
        if above not in makers:
            raise ValueError(f"above must be 'pivot', 'top' or 'bottom', got {above!r}")
        return cls._make(makers[above], length, gravity, float(energy), float(momentum))

    @classmethod
    def from_release(cls, length: float, gravity: float, angle: float, speed: float = 0.0) -> Orbit:
        """From an angle to the downward vertical [degrees] and a horizontal speed across [m/s]."""
        return cls._make("release", length, gravity, float(angle), float(speed))

    @classmethod
    def from_state(cls, length: float, gravity: float, position: ArrayLike, velocity: ArrayLike) -> Orbit:
        """From a position on the sphere [m] and a tangential velocity [m/s] at t = 0, three numbers each."""
        return cls._make("state", length, gravity, _three("position", position), _three("velocity", velocity))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"an Orbit cannot be changed: {name}")

    __delattr__ = __setattr__  # type: ignore[assignment]

    def __repr__(self) -> str:
        (first, second), (a, b) = _ARGUMENTS[self._maker], self._given
        above = {"energy_above_top": ", above='top'", "energy_above_bottom": ", above='bottom'"}.get(self._maker, "")
        maker = "energy" if above else self._maker
        return (f"Orbit.from_{maker}(length={self.length!r}, gravity={self.gravity!r}, {first}={a!r}, {second}={b!r}{above})")

    def _key(self) -> tuple[Any, ...]:
        return (self._maker, self.length, self.gravity, *self._given)

    def __eq__(self, other: object) -> bool:
        return self._key() == other._key() if isinstance(other, Orbit) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._key())

    def __reduce__(self) -> tuple[Any, ...]:
        return Orbit._make, self._key()

    def __copy__(self) -> Orbit:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Orbit:
        return self

    @property
    def period(self) -> float:
        """T: from one highest point to the next [s]. To and fro takes twice as long."""
        return self._constants[0]

    @property
    def modulus(self) -> float:
        """k of the elliptic functions."""
        return self._constants[1]

    @property
    def complementary_modulus(self) -> float:
        """k', with k**2 + k'**2 = 1: what k cannot tell near the separatrix."""
        return self._constants[2]

    @property
    def quarter_period(self) -> float:
        """K(k)."""
        return self._constants[3]

    @property
    def nome(self) -> float:
        """q(k)."""
        return self._constants[4]

    @property
    def azimuth_rate(self) -> float:
        """A, the steady part of the azimuth's rate [rad/s]."""
        return self._constants[5]

    @property
    def azimuth_per_period(self) -> float:
        """phi(T): by how much the azimuth grows in a period [rad]."""
        return self._constants[6]

    @property
    def advance(self) -> float:
        """By how much the apsides advance in a period, phi(T) - pi [rad]."""
        return self._constants[7]

    @property
    def apsidal_angle(self) -> float:
        """Azimuth from a highest to the next lowest point, phi(T)/2 [rad]."""
        return self._constants[8]

    @property
    def energy(self) -> float:
        """Per mass, 0 at rest at the height of the pivot [m2/s2]."""
        return self._constants[9]

    @property
    def momentum(self) -> float:
        """Angular momentum about the vertical, per mass [m2/s]."""
        return self._constants[10]

    @property
    def turning_heights(self) -> TurningHeights:
        """The roots of the height cubic, and the distances between them and the poles [m]."""
        return TurningHeights(*self._constants[11:])

    def state(self, t: ArrayLike, threads: int = 1) -> tuple[_Array, _Array]:
        """Positions [m] and velocities [m/s] at the times t [s], each of shape ``numpy.shape(t) + (3,)``.

        Long arrays are shared among ``threads`` threads, 0: as many as there are. The bits do not depend on it.
        """
        times = np.asarray(t, dtype=np.float64, order="C")
        positions, velocities = np.empty(times.shape + (3,)), np.empty(times.shape + (3,))
        _kyvadlo.locate(self._bytes, times, positions, velocities, threads)
        return positions, velocities

    def locate(self, t: ArrayLike, threads: int = 1) -> _Array:
        """Positions x, y, z at the times t [m], of shape ``numpy.shape(t) + (3,)``."""
        return self.state(t, threads)[0]

    def velocity(self, t: ArrayLike, threads: int = 1) -> _Array:
        """Velocities at the times t [m/s], of shape ``numpy.shape(t) + (3,)``."""
        return self.state(t, threads)[1]

    def _evaluate(self, what: str, argument: ArrayLike) -> Any:
        arguments = np.asarray(argument, dtype=np.float64, order="C")
        values = np.empty(arguments.shape)
        _kyvadlo.evaluate(self._bytes, what, arguments, values)
        return values[()]

    def height(self, t: ArrayLike) -> Any:
        """Height z above the pivot at the times t [m]."""
        return self._evaluate("height", t)

    def rise(self, t: ArrayLike) -> Any:
        """l + z, above the lowest point of the sphere [m]."""
        return self._evaluate("rise", t)

    def gap(self, t: ArrayLike) -> Any:
        """l - z, below the highest point of the sphere [m]."""
        return self._evaluate("gap", t)

    def azimuth(self, t: ArrayLike) -> Any:
        """Azimuth at the times t, continuous [rad]."""
        return self._evaluate("azimuth", t)

    def vertical_speed(self, t: ArrayLike) -> Any:
        """dz/dt at the times t [m/s]."""
        return self._evaluate("vertical_speed", t)

    def azimuthal_speed(self, t: ArrayLike) -> Any:
        """dphi/dt at the times t [rad/s]."""
        return self._evaluate("azimuthal_speed", t)

    def speed(self, t: ArrayLike) -> Any:
        """Speed at the times t [m/s]."""
        return self._evaluate("speed", t)

    def tension(self, t: ArrayLike) -> Any:
        """Force of the rod per mass at the times t, positive towards the pivot [m/s2]."""
        return self._evaluate("rod_force", t)

    def time_to_height(self, z: ArrayLike) -> Any:
        """First t >= 0 at the height z [s]; NaN where it never is."""
        return self._evaluate("time_to_height", z)

    def time_to_azimuth(self, phi: ArrayLike) -> Any:
        """First t >= 0 at the azimuth phi >= 0 [s]."""
        return self._evaluate("time_to_azimuth", phi)

    def next_turning_time(self, t: ArrayLike) -> Any:
        """First turning point later than t [s]."""
        return self._evaluate("next_turning_time", t)

    def derivatives(self, t: ArrayLike) -> Derivatives:
        """States at the times t and their exact derivatives.

        They are taken along the numbers that made the orbit; of an energy counted from a pole, along the state at t = 0.
        NaN stands where there is no derivative.

        Examples
        --------
        >>> import kyvadlo
        >>> found = kyvadlo.Orbit.from_heights(1.0, 9.80665, 0.3, -0.8).derivatives(0.5)
        >>> found.columns
        ('length', 'gravity', 'upper', 'lower', 't')
        >>> found.matrices.shape
        (6, 5)
        """
        times = np.asarray(t, dtype=np.float64, order="C")
        maker, (a, b) = self._maker, self._given
        if maker in ("heights", "gaps", "rises", "energy", "release"):
            columns: tuple[str, ...] = ("length", "gravity", *_ARGUMENTS[maker], "t")
        else:
            columns = ("x", "y", "z", "vx", "vy", "vz", "length", "gravity", "t")
            if maker != "state":
                position, velocity = self.state(0.0)
                maker, a, b = "state", tuple(position.tolist()), tuple(velocity.tolist())
        states = np.empty(times.shape + (6,))
        matrices = np.empty(times.shape + (6, len(columns)))
        periods = np.empty((2, len(columns) - 1))
        _kyvadlo.derivatives(maker, self.length, self.gravity, a, b, times, (states, matrices, periods))
        return Derivatives(states, matrices, periods[0], periods[1], columns)

    def plot(self, periods: float = 8, samples: int = 2000) -> Figure:
        """Draws the path from above and the height over time, by matplotlib."""
        from .pictures import draw_motion
        span = self.period if np.isfinite(self.period) else 4*np.sqrt(self.length/self.gravity)
        t = np.linspace(0, periods*span, samples)
        x, y, z = np.moveaxis(self.locate(t), -1, 0)
        return draw_motion(t, x, y, z)


def _three(name: str, numbers: ArrayLike) -> tuple[float, ...]:
    array = np.asarray(numbers, dtype=np.float64)
    if array.shape != (3,):
        raise ValueError(f"{name} must be three numbers, got {numbers!r}")
    return tuple(array.tolist())
