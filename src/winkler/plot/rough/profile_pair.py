"""Sheets of two profiles: the bodies with their places of contact, the gap between them, and pressures."""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.axis import edges_of
from winkler.plot.dispatch import without_extent
from winkler.plot.panel import Line, Map, Panel, PanelAxis, Sheet, points, zero
from winkler.plot.series import scale_of, series, with_unit
from winkler.problems.profile_pair.patch import ProfilePatch
from winkler.problems.profile_pair.profile_pair import ProfilePair, ProfilePairSolution
from winkler.profiles.sections.cross_profile import CrossProfile

PLACES = 801
GAP_DRAWN = 12.0
"""Greatest gap that is drawn, over the drop."""
FLAT = 0.2
"""Height over width, or width over height, below which both are drawn with scales of their own."""
MOST_PATCHES = 2
"""Patches whose pressures are drawn."""


@without_extent(ProfilePairSolution)
def profile_pair_sheet(item: ProfilePairSolution) -> Sheet:
    """Return both profiles with their patches, the gap across, and the pressure on the patches that bear most."""
    panels = [
        bodies_panel(item.problem, item.height, item.patches).plus(title="profiles and contact"),
        _gap(item).plus(title="gap before pressing"),
    ]
    for patch in item.patches[:MOST_PATCHES]:
        title = f"{with_unit(patch.force, 'N', 3)}, inclined by {abs(math.degrees(patch.angle)):.1f}°"
        panels.append(_pressure(patch).plus(title=title))
    title = f"{with_unit(item.force, 'N')};  greatest pressure {with_unit(item.peak_pressure, 'Pa')}"
    return Sheet(tuple(panels), width=4.4, height=3.2, title=title)


def _line(profile: CrossProfile) -> tuple[Array, Array]:
    first, last = profile.ends
    y = np.linspace(first, last, PLACES)
    return y, profile.height(y)


def bodies_panel(stated: ProfilePair, height: float, patches: tuple[ProfilePatch, ...]) -> Panel:
    """Return both profiles, the upper one at a height [m], with the middles of their patches."""
    lower, upper = _line(stated.first), _line(stated.second)
    sine, cosine = np.sin(stated.roll), np.cos(stated.roll)
    across = stated.lateral + cosine * upper[0] + sine * upper[1]
    up = height - sine * upper[0] + cosine * upper[1]
    marks = (
        Line(*lower, style.BLUE, name="lower body"),
        Line(across, up, style.MUTED, name="upper body"),
        points([patch.y for patch in patches], [patch.z for patch in patches], style.RED, name="contact"),
    )
    y, z = np.concatenate([lower[0], across]), np.concatenate([lower[1], up])
    flat = float(np.ptp(z)) < FLAT * float(np.ptp(y))
    axes = PanelAxis("across $y$", scale_of("m", y)), PanelAxis("up $z$", scale_of("m", z if flat else y))
    return Panel(marks, *axes, equal=not flat, legend="best")


def _gap(item: ProfilePairSolution) -> Panel:
    """Return the gap across at first touch, and how far the upper body goes down."""
    placing = item.problem.placing
    gap = placing.gap - float(np.nanmin(placing.gap))
    near = gap < GAP_DRAWN * item.depth
    around = np.flatnonzero(near)
    part = slice(int(around[0]), int(around[-1]) + 1)
    drawn = np.where(near, gap, np.nan)[part]
    y, height = placing.y[part], series("separation", drawn)
    marks = (
        zero(),
        Line(y, drawn, style.BLUE, name="gap"),
        Line(y[[0, -1]], np.full(2, item.depth), style.RED, name="drop"),
    )
    return Panel(marks, PanelAxis("across $y$", scale_of("m", y)), PanelAxis.of(height, low=0.0), legend="best")


def _pressure(patch: ProfilePatch) -> Panel:
    """Return the pressure on one patch."""
    pressure = series("pressure", np.where(patch.pressure > 0.0, patch.pressure, np.nan))
    bar = PanelAxis.of(pressure, low=0.0, high=patch.peak_pressure)
    x, s = (edges_of(places) for places in (patch.along, patch.across))
    image = Map(s, x, pressure.content, bar, kind="cells", colours=style.SHADES, place="inset")
    scale, sides = scale_of("m", np.concatenate([x, s])), (float(np.ptp(x)), float(np.ptp(s)))
    alike = min(sides) >= FLAT * max(sides)
    return Panel((image,), PanelAxis("along the arc $s$", scale), PanelAxis("along $x$", scale), equal=alike, grid="")
