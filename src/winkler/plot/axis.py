"""One axis of a panel: quantity, unit, limits, scale and ticks."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.series import Scale, Series
from winkler.values.value import value

LEAST_FALL = 0.12
"""Variation over the greatest number from which an axis begins at zero; of less nothing would be seen there."""


@value
class PanelAxis:
    """One axis of a panel.

    Parameters
    ----------
    label
        Label without the unit.
    scale
        Unit of the displayed numbers; limits and marks are SI.
    low, high
        Limits [SI]; fitted to the marks if left out.  `low` may be the greater one.
    margin
        Part of the range left free at fitted limits.
    headroom
        Further part of the range left free above for text.
    log, plain
        Whether the axis is logarithmic, and whether its numbers are then written without powers of ten.
    falling
        Whether a fitted axis is inverted.
    ticks, names
        Positions of ticks [SI] and their labels; chosen if left out.
    colour
        Of the label.
    parts
        Approximate number of integer ticks; zero: automatic.
    """

    label: str = ""
    scale: Scale = Scale(1.0, "")
    low: float | None = None
    high: float | None = None
    margin: float | None = None
    headroom: float = 0.0
    log: bool = False
    plain: bool = False
    falling: bool = False
    ticks: Array | None = None
    names: tuple[str, ...] = ()
    colour: str = style.INK
    parts: int = 0

    @classmethod
    def of(cls, one: Series, scale: Scale | None = None, **more: Any) -> PanelAxis:
        """Return the axis of a series: its name, symbol and unit; the scale that fits it if none is given."""
        scale = scale or one.scale
        return cls(one.label(Scale(1.0, "")), scale, **more)

    @property
    def title(self) -> str:
        """The label with its unit."""
        return f"{self.label} [{self.scale.unit}]" if self.scale.unit else self.label


def from_zero(content: Array) -> float | None:
    """Return zero as the lower end of an axis, or none if the numbers vary too little to be seen above it."""
    varied = float(np.nanmax(content) - np.nanmin(content))
    return 0.0 if varied == 0.0 or varied >= LEAST_FALL * float(np.nanmax(content)) else None


def edges_of(middles: Array, *, decades: bool = False) -> Array:
    """Return the edges of cells around their rising middles."""
    along = np.log(middles) if decades else middles
    between = 0.5 * (along[1:] + along[:-1])
    edges = np.concatenate([[2.0 * along[0] - between[0]], between, [2.0 * along[-1] - between[-1]]])
    return np.asarray(np.exp(edges) if decades else edges)


def plane(scale: Scale, **more: Any) -> tuple[PanelAxis, PanelAxis]:
    """Return the axes x and y of a plane in one unit; `more` is common to both."""
    return PanelAxis("$x$", scale, **more), PanelAxis("$y$", scale, **more)
