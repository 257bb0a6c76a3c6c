"""Films of metals that yield: the indenter over the surface at moments of the path, and where they lie on the loop."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth, Radius
from winkler.loading.path import numbers_of
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.animation import spread
from winkler.plot.extent import outline_end, sunk
from winkler.plot.panel import Area, Line, Panel, PanelAxis, Sheet, points, titled, zero
from winkler.plot.particles.yielding import loop_panels
from winkler.plot.series import scale_of, with_unit
from winkler.problems.normal.indentation import Indentation
from winkler.problems.plastic.dent import Dent
from winkler.problems.plastic.dent_limit import DentLimitSolution
from winkler.problems.plastic.impact import PlasticImpactSolution
from winkler.problems.plastic.indentation import PlasticIndentation, PlasticSolution
from winkler.problems.plastic.strength_from_dent import StrengthFromDentSolution
from winkler.values.errors import InvalidInput

RADII_DRAWN = 1.7
"""Extent of the picture in radii of the greatest contact."""
POINTS = 241
MARGIN, HEADROOM = 0.15, 0.9
"""Free height below the deepest point and above the original surface, over the greatest depth."""


def blow_of(item: PlasticImpactSolution) -> PlasticSolution:
    """Return an impact of one velocity as the contact that it is: pressed to its greatest depth, and let go."""
    depths = np.ravel([item.greatest_depth, item.residual_depth])
    return PlasticIndentation(item.problem.bed, Depth(depths)).solve()


def pressed_of(item: Any) -> PlasticSolution | None:
    """Return the contact that a solution follows along its path; none if it follows none.

    Raises
    ------
    InvalidInput
        If it is of many impacts.
    """
    match item:
        case PlasticSolution():
            return item
        case DentLimitSolution() | StrengthFromDentSolution():
            return item.released
        case PlasticImpactSolution():
            if (count := np.size(item.velocity)) != 1:
                raise InvalidInput(f"film: a PlasticImpact of {count} velocities has as many dents; give one velocity.")
            return blow_of(item)
    return None


def dent_sheets(item: PlasticSolution, most: int) -> Iterator[Sheet]:
    """Return a sheet for each of at most so many moments of the path, from first touch on, all in one frame.

    Raises
    ------
    InvalidInput
        If the contact is an ellipse, of whose dent no shape is known.
    """
    if item.problem.bed.footprint.unlike_disc:
        raise InvalidInput(
            "film: PlasticIndentation does not compute the shape of an elliptic dent; `--part curve` shows its loop."
        )
    if not np.any(item.largest_radius > 0.0):
        raise InvalidInput("film: the bodies touch at no moment, so there is nothing to show; give more load.")
    return _sheets(item, most)


def _sheets(item: PlasticSolution, most: int) -> Iterator[Sheet]:
    along = _finely(item, most)
    loop = loop_panels(item, "depth")[0]
    for place in spread(along.depth.size, most):
        force, depth, dent = (float(part[place]) for part in (along.force, along.depth, along.residual_depth))
        here = points(depth, force, order=6.0, size=8.0)
        panels = titled((_body_panel(along, place), loop.plus(here)), "indenter and surface", "force over depth")
        left = f"the dent is {with_unit(dent, 'm')} deep" if dent > 0.0 else "elastic, no dent"
        loads = f"$F_N$ = {with_unit(force, 'N')}   $d$ = {with_unit(depth, 'm')}"
        yield Sheet(panels, width=4.6, height=3.9, below=3, title=f"{loads}   {left}")


def _finely(item: PlasticSolution, most: int) -> PlasticSolution:
    """Return the path from first touch on, with moments between its points as far as there are too few."""
    levels = numbers_of(item.problem.path)
    ends = np.append(min(0.0, float(levels[0])), levels)
    legs = levels.size
    finely = max((most - 1) // legs, 1)
    dense = np.interp(np.arange(legs * finely + 1) / finely, np.arange(legs + 1), ends)
    return dataclasses.replace(item.problem, path=type(item.problem.path)(dense)).solve()


def surface_of(item: PlasticSolution, place: int, r: Array) -> tuple[Array, Array]:
    """Return heights of the surface at a moment of a path [m]: within the dent, and the elastic ones beyond it.

    Within the radius of the greatest contact so far the surface is what its load has left, less what the springs of the
    dent displace under the load now.  Beyond this radius the second row is the displacement by these springs alone:
    the metal that was pushed up or drawn in there is not known.  Where a row does not hold it is NaN.

    Parameters
    ----------
    item : PlasticSolution
        Of a round contact.
    place : int
        Index on its path.
    r : ndarray
        Distances from the axis [m].
    """
    dented, edge = _dented(item, place), float(item.largest_radius[place])
    radius = min(float(item.radius[place]), dented.reach)  # both come from one search, and differ by rounding
    elastic = sunk(Indentation(dented, Radius(radius)).solve().pressed, r)
    if not isinstance(dented.profile, Dent):
        return -elastic, np.full(r.shape, math.nan)
    inside = r <= edge
    within = np.minimum(r, dented.reach)
    left = item.problem.bed.height(within) - dented.height(within) - float(item.residual_depth[place])
    return np.where(inside, left - elastic, math.nan), np.where(inside, math.nan, -elastic)


def _dented(item: PlasticSolution, place: int) -> Foundation:
    """Return the bed that the greatest load up to a moment leaves."""
    path = item.problem.path
    greatest = np.array([np.max(numbers_of(path)[: place + 1])])
    return dataclasses.replace(item.problem, path=type(path)(greatest)).solve().dented


def _body_panel(item: PlasticSolution, place: int) -> Panel:
    """Return the indenter over the surface at a moment, in the frame of the whole path."""
    bed = item.problem.bed
    widest, deepest = float(item.largest_radius[-1]), float(np.max(item.depth))
    low, high = -(1.0 + MARGIN) * deepest, HEADROOM * deepest
    radius, edge = float(item.radius[place]), float(item.largest_radius[place])
    half = np.unique(np.append(np.linspace(0.0, RADII_DRAWN * widest, POINTS), (radius, edge)))
    within, beyond = surface_of(item, place, half)
    ground = np.where(np.isnan(within), beyond, within)
    touching = np.where(half <= radius, within, math.nan) if radius > 0.0 else np.full(half.shape, math.nan)
    body = np.linspace(0.0, min(RADII_DRAWN * widest, outline_end(bed)), POINTS)
    outline = bed.height(body) - float(item.depth[place])
    across, bottom = style.mirrored(body, np.minimum(outline, high))
    r, ground = style.mirrored(half, ground)
    rows = [style.mirrored(half, row)[1] for row in (within, beyond, touching)]
    marks = (
        Area(r, low, ground, style.SOLID, alpha=1.0),
        Area(across, bottom, high, style.BODY, alpha=1.0),
        Line(across, bottom, style.MUTED, width=1.0),
        Line(r, rows[0], style.INK, name="surface"),
        Line(r, rows[1], style.INK, dash=style.DASHES[2], name="beyond the dent: elastic part alone"),
        Line(r, rows[2], style.RED, width=3.0, name="contact", order=4.0),
        zero(),
    )
    return Panel(
        marks,
        PanelAxis("$r$", scale_of("m", [widest]), low=float(r[0]), high=float(r[-1])),
        PanelAxis("height", scale_of("m", [deepest]), low=low, high=high),
    )
