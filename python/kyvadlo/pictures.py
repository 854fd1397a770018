"""Pictures by matplotlib, which only they need."""
from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_LABELS = {"period": "period T [s]", "modulus": "modulus k", "azimuth_per_period": "azimuth in a period [rad]",
           "advance": "advance of the apsides [rad]"}


def _figure(columns: int) -> tuple[Figure, Any]:
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        raise ImportError("plot() needs matplotlib: pip install matplotlib") from error
    return plt.subplots(1, columns, figsize=(4.8*columns, 4.2), layout="constrained")


def draw_motion(t: NDArray[Any], x: NDArray[Any], y: NDArray[Any], z: NDArray[Any]) -> Figure:
    """The path from above, and the height over time."""
    figure, (above, aside) = _figure(2)
    above.plot(x, y, linewidth=0.8)
    above.set(xlabel="x [m]", ylabel="y [m]", aspect="equal", title="from above")
    aside.plot(t, z, linewidth=0.8)
    aside.set(xlabel="t [s]", ylabel="z [m]", title="height")
    return figure


def draw_table(table: Mapping[str, NDArray[Any]], what: str) -> Figure:
    """A quantity over the lower turning height, a line for each upper one."""
    figure, axes = _figure(1)
    for upper in np.unique(table["upper"]):
        chosen = table["upper"] == upper
        axes.plot(table["lower"][chosen], table[what][chosen], label=f"{upper:g} m", linewidth=1)
    axes.set(xlabel="lower turning height [m]", ylabel=_LABELS[what])
    axes.legend(title="upper", fontsize="small")
    return figure


def draw_fit(residuals: Mapping[str, NDArray[Any]]) -> Figure:
    """What was measured and the model, and the residuals in sigmas, over time."""
    figure, (values, rest) = _figure(2)
    for i, name in enumerate(dict.fromkeys(residuals["column"])):
        chosen = residuals["column"] == name
        t = residuals["t"][chosen]
        values.plot(t, residuals["measured"][chosen], ".", color=f"C{i}", markersize=3, label=name)
        values.plot(t, residuals["model"][chosen], color=f"C{i}", linewidth=0.8)
        rest.plot(t, residuals["residual_in_sigmas"][chosen], ".", color=f"C{i}", markersize=3, label=name)
    values.set(xlabel="t [s]", title="measured, and the model as lines")
    rest.set(xlabel="t [s]", title="residuals [sigma]")
    values.legend(fontsize="small")
    return figure
