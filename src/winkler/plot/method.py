"""The pictures of the method, one by one: the body, its springs, their load, the pressure, the stress, the force.

`winkler.plot.draw` puts them on one sheet; a report shows each with its own words.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.plot import style
from winkler.plot.body import draw_contact
from winkler.plot.curves import draw_curve, draw_line_load, draw_pressure, draw_surface, force_depth, surface
from winkler.plot.extent import around
from winkler.plot.series import series, told
from winkler.plot.springs import draw_springs
from winkler.plot.stresses import draw_stress
from winkler.problems.indentation import IndentationSolution

if TYPE_CHECKING:
    from collections.abc import Callable

    from winkler.plot.picture import Picture

__all__ = ["PICTURES", "headline", "picture"]


def headline(solution: Any) -> str:
    """Return depth, force and contact radius in one line."""
    parts = [
        f"${symbol}$ = {told(float(getattr(solution, name)), unit)}"
        for name, symbol, unit in (("force", "F_N", "N"), ("depth", "d", "m"), ("radius", "a", "m"))
    ]
    return "   ".join(parts)


def shape(solution: IndentationSolution, extent: float | None = None) -> Picture:
    """Return the body in three dimensions, in its dent."""
    return _one(lambda axes, to: draw_contact(axes, solution, to), solution, extent)


def springs(solution: IndentationSolution, extent: float | None = None) -> Picture:
    """Return the equivalent plane profile over its springs."""
    return _one(lambda axes, to: draw_springs(axes, solution.pressed, to), solution, extent)


def line_load(solution: IndentationSolution, extent: float | None = None) -> Picture:
    """Return q(x)."""
    return _one(lambda axes, to: draw_line_load(axes, solution, to, float(solution.force)), solution, extent)


def pressure(solution: IndentationSolution, extent: float | None = None) -> Picture:
    """Return p(r)."""
    return _one(lambda axes, to: draw_pressure(axes, solution, to, float(solution.mean_pressure)), solution, extent)


def displacement(solution: IndentationSolution, extent: float | None = None) -> Picture:
    """Return the displacement of the surface, inside and outside the contact."""
    return _one(lambda axes, to: draw_surface(axes, surface(solution, 1.5 * to)), solution, extent)


def stress(solution: IndentationSolution, extent: float | None = None) -> Picture:
    """Return the map of the stress below the surface."""
    if solution.radius == 0.0:
        raise InvalidInput(
            "draw: the bodies do not touch under this load, so there is no stress to show; give more load."
        )
    return _one(lambda axes, to: draw_stress(axes, solution, to, float(solution.radius)), solution, extent, width=5.0)


def force(solution: IndentationSolution, extent: float | None = None) -> Picture:
    """Return F(d) up to this load, and the load itself as a point."""
    depth = float(solution.depth)
    if depth <= 0.0:
        raise InvalidInput(
            "draw: the bodies do not touch under this load, so there is no F(d) up to it; give more load."
        )

    def paint(axes: Any, _: float) -> None:
        curve = force_depth(solution.pressed)
        draw_curve(axes, curve, marker="")
        point = series("IndentationSolution", "force", np.array([float(solution.force)]))
        axes.plot([depth / curve.along.scale.factor], point.shown(curve.of.scale), "o", color=style.RED, clip_on=False)
        axes.set_xlim(0.0, 1.04 * depth / curve.along.scale.factor)
        axes.set_ylim(0.0, None)
        if np.isnan(curve.of.content).any():
            style.note(axes, "gaps: there the contact is no single disc", where="upper left")

    return _one(paint, solution, extent)


PICTURES: dict[str, Callable[..., Picture]] = {
    "shape": shape,
    "springs": springs,
    "line_load": line_load,
    "pressure": pressure,
    "displacement": displacement,
    "stress": stress,
    "force": force,
}
"""Name -> function of a solution for one load; the order of the method."""


def picture(name: str, solution: IndentationSolution, extent: float | None = None) -> Picture:
    """Return one picture of the method.

    Parameters
    ----------
    name
        One of `PICTURES`.
    solution
        For one load.
    extent : float, optional
        Drawn up to this distance from the axis [m].

    Raises
    ------
    OutsideValidity
        If what the picture shows is not known for this contact.
    """
    return PICTURES[name](solution, extent)


def _one(
    paint: Callable[[Any, float], None], solution: IndentationSolution, extent: float | None, width: float = 4.6
) -> Picture:
    with style.styled():
        figure = style.figure(width=width, height=3.3)
        paint(figure.add_subplot(), around(solution.pressed, extent))
    return figure
