"""One side of a picture: what it shows, in which unit, between which ends."""

from __future__ import annotations

from typing import Any

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.series import Scale, Series
from winkler.values import value

__all__ = ["Axis", "plane"]


@value
class Axis:
    """One side of a panel.

    Parameters
    ----------
    label
        What it shows, without the unit.
    scale
        In which unit it is shown; limits and marks are SI.
    low, high
        Where it begins and ends [SI]; fitted to the marks if left out. It may begin with the greater one.
    margin
        Part of the range that is left free at fitted ends.
    headroom
        Further part of the range above, left free for words.
    log, plain
        Whether it is logarithmic, and whether its numbers are written out then.
    falling
        Whether a fitted axis begins with the greatest number.
    ticks, names
        Where ticks stand [SI], and what is written there; chosen if left out.
    colour
        Of the label.
    parts
        About so many whole numbers are marked; zero: as suits.
    sparse
        Whether a logarithmic axis numbers its decades alone.
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
    sparse: bool = False

    @classmethod
    def of(cls, one: Series, scale: Scale | None = None, **more: Any) -> Axis:
        """Return the axis of a series: its name, symbol and unit; the scale that fits it if none is given."""
        scale = scale or one.scale
        return cls(one.label(Scale(1.0, "")), scale, **more)

    @property
    def title(self) -> str:
        """The label with its unit."""
        return f"{self.label} [{self.scale.unit}]" if self.scale.unit else self.label


def plane(scale: Scale, **more: Any) -> tuple[Axis, Axis]:
    """Return the axes x and y of a plane in one unit; `more` is common to both."""
    return Axis("$x$", scale, **more), Axis("$y$", scale, **more)
