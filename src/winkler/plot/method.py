"""The pictures of the method, one by one: the body, its springs, their load, the pressure, the stress, the force.

`winkler.plot.draw` puts them on one sheet; a report shows each with its own words.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.foundation.bed import Bed
from winkler.foundation.measured import MeasuredBed
from winkler.media.halfspace import HomogeneousMedium
from winkler.plot import style
from winkler.plot.adhesion.cycles import intensity_told
from winkler.plot.adhesion.equilibria import draw_around
from winkler.plot.extent import around
from winkler.plot.medium import draw_makeup, draw_spring_stiffness, draw_stiffness
from winkler.plot.normal.body import draw_contact
from winkler.plot.normal.curves import draw_curve, draw_line_load, draw_pressure, draw_surface, force_depth, surface
from winkler.plot.normal.springs import draw_springs
from winkler.plot.normal.stresses import draw_stress
from winkler.plot.series import series, told
from winkler.problems.adhesion.edge_states import FarStates
from winkler.problems.adhesion.indentation import AdhesiveSolution
from winkler.problems.adhesion.law_states import states_of
from winkler.problems.normal.indentation import IndentationSolution

if TYPE_CHECKING:
    from collections.abc import Callable

    from matplotlib.axes import Axes

    from winkler.plot.picture import Picture

__all__ = [
    "PICTURES",
    "Contact",
    "draw_bed_makeup",
    "headline",
    "line_load_of",
    "picture",
    "pictures_of",
    "pressure_of",
]


Contact = IndentationSolution | AdhesiveSolution
"""What the pictures show: a solution for one load."""


def headline(solution: Any) -> str:
    """Return depth, force and contact radius in one line."""
    parts = [
        f"${symbol}$ = {told(float(getattr(solution, name)), unit)}"
        for name, symbol, unit in (("force", "F_N", "N"), ("depth", "d", "m"), ("radius", "a", "m"))
    ]
    return "   ".join(parts)


def shape(solution: Contact, extent: float | None = None) -> Picture:
    """Return the body in three dimensions, in its dent."""
    return _one(lambda axes, to: draw_contact(axes, solution, to), solution, extent)


def springs(solution: Contact, extent: float | None = None) -> Picture:
    """Return the equivalent plane profile over its springs."""
    return _one(lambda axes, to: draw_springs(axes, solution.pressed, to), solution, extent)


def medium(solution: Contact, extent: float | None = None) -> Picture:
    """Return how the solid changes with the depth, and how stiff that makes the springs."""
    bed, radius = solution.pressed.bed, float(solution.radius)
    to = around(solution.pressed, extent)
    with style.styled():
        figure = style.figure(2, height=3.3)
        left, right = figure.subplots(1, 2)
        draw_bed_makeup(left, right, bed, to, radius)
    return figure


def draw_bed_makeup(left: Axes, right: Axes, bed: Bed, to: float, radius: float = 0.0) -> None:
    """Draw what a bed rests on: E(z), or the measured k(a), and the stiffness of the springs.

    Parameters
    ----------
    left, right : Axes
        Empty.
    bed : Bed
    to : float
        Greatest x and, where the medium has no length of its own, depth [m].
    radius : float
        Radius of a contact [m], marked; zero for none.
    """
    if isinstance(bed, MeasuredBed):
        draw_stiffness(left, bed, to, radius)
        draw_spring_stiffness(right, bed.medium, min(to, bed.reach), radius)
    else:
        draw_makeup(left, bed.medium, to, radius)
        draw_spring_stiffness(right, bed.medium, to, radius)


def line_load(solution: Contact, extent: float | None = None) -> Picture:
    """Return q(x)."""
    return _one(lambda axes, to: line_load_of(axes, solution, to), solution, extent)


def line_load_of(axes: Axes, solution: Contact, to: float) -> None:
    """Draw q(x) of a contact, and what the area below it is."""
    pull = 0.0
    if isinstance(solution, AdhesiveSolution):
        states = states_of(solution.problem.bed, solution.problem.law)
        pull = states.pull if isinstance(states, FarStates) else 0.0
    draw_line_load(axes, solution, to, float(solution.force), pull)


def pressure(solution: Contact, extent: float | None = None) -> Picture:
    """Return p(r)."""
    return _one(lambda axes, to: pressure_of(axes, solution, to), solution, extent)


def pressure_of(axes: Axes, solution: Contact, to: float) -> None:
    """Draw p(r) of a contact, with its mean, or with what the tension at its edge is."""
    if isinstance(solution, AdhesiveSolution):
        draw_pressure(axes, solution, to, remark=intensity_told(solution))
    else:
        draw_pressure(axes, solution, to, float(solution.mean_pressure))


def displacement(solution: Contact, extent: float | None = None) -> Picture:
    """Return the displacement of the surface, inside and outside the contact."""
    return _one(lambda axes, to: draw_surface(axes, surface(solution, 1.5 * to)), solution, extent)


def stress(solution: Contact, extent: float | None = None) -> Picture:
    """Return the map of the stress below the surface."""
    if solution.radius == 0.0:
        raise InvalidInput(
            "draw: the bodies do not touch under this load, so there is no stress to show; give more load."
        )
    return _one(lambda axes, to: draw_stress(axes, solution, to, float(solution.radius)), solution, extent, width=5.0)


def force(solution: Contact, extent: float | None = None) -> Picture:
    """Return F(d) up to this load, or around it where the bodies stick, and the load itself as a point."""
    if isinstance(solution, AdhesiveSolution):
        stuck = solution
        return _one(lambda axes, _: draw_around(axes, stuck), solution, extent)
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
    "medium": medium,
    "springs": springs,
    "line_load": line_load,
    "pressure": pressure,
    "displacement": displacement,
    "stress": stress,
    "force": force,
}
"""Name -> function of a solution for one load; the order of the method."""


def pictures_of(solution: Contact) -> tuple[str, ...]:
    """Return the names of the pictures that have something to show: a homogeneous medium needs none of its own."""
    homogeneous = isinstance(solution.pressed.bed.medium, HomogeneousMedium)
    return tuple(name for name in PICTURES if not (name == "medium" and homogeneous))


def picture(name: str, solution: Contact, extent: float | None = None) -> Picture:
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


def _one(paint: Callable[[Any, float], None], solution: Contact, extent: float | None, width: float = 4.6) -> Picture:
    with style.styled():
        figure = style.figure(width=width, height=3.3)
        paint(figure.add_subplot(), around(solution.pressed, extent))
    return figure
