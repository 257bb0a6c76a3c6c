"""An elastic-plastic particle along its path: force and contact radius over the depth, loaded and let go."""

from __future__ import annotations

import dataclasses
import itertools
import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from winkler.loading import Depth, Force
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.friction.curves import lost_told
from winkler.plot.series import series, told
from winkler.problems.particles.elastic_plastic import ParticleSolution

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from winkler.plot.picture import Picture

__all__ = ["particle_sheet"]

FINE = 120
"""Every leg of the path is drawn through so many states."""
BESIDE = 1e-9
"""Part of a depth by which the curve is looked at before and after a jump."""
MARKED = 40
"""Paths of at most so many points show each of them."""


class _Leg(NamedTuple):
    """States from one point of the path to the next, and whether they go deeper."""

    deeper: bool
    depth: Array
    force: Array
    radius: Array


def particle_sheet(item: ParticleSolution) -> Picture:
    """Return force and contact radius over the depth: going in, coming out, and where yield begins."""
    legs = _legs(item)
    with style.styled():
        figure = style.figure(2, height=3.5)
        left, right = figure.subplots(1, 2)
        _draw(left, item, legs, "force")
        _draw(right, item, legs, "radius")
        left.axhline(0.0, color=style.MUTED, linewidth=0.8, zorder=1)
        left.set_ylim(None, 1.45 * float(left.get_ylim()[1]))
        right.set_ylim(0.0, None)
        style.framed_legend(left, loc="upper left")
        style.note(right, lost_told(float(item.dissipation[-1]), item.depth, item.force), where="lower right")
        left.set_title("force over depth")
        right.set_title("contact radius over depth")
        figure.suptitle(_headline(item))
    return figure


def _headline(item: ParticleSolution) -> str:
    deepest, onset = float(np.max(item.depth)), item.yield_depth
    if deepest <= onset:
        return "an elastic particle: it does not yield along this path"
    kept = float(item.residual_depth[-1])
    return f"yields from $d_Y$ = {told(onset, 'm')} on; let go, it would just touch at $d_0$ = {told(kept, 'm')}"


def _draw(axes: Axes, item: ParticleSolution, legs: list[_Leg], name: str) -> None:
    """Draw one quantity over the depth."""
    along = series("ParticleSolution", "depth", np.concatenate([leg.depth for leg in legs]))
    of = series("ParticleSolution", name, np.concatenate([getattr(leg, name) for leg in legs]))
    across, upright = along.scale.factor, of.scale.factor
    named: set[bool] = set()
    for leg in legs:
        axes.plot(
            leg.depth / across,
            getattr(leg, name) / upright,
            color=style.BLUE if leg.deeper else style.RED,
            linestyle=style.DASHES[0 if leg.deeper else 1],
            label="_" if leg.deeper in named else "loading" if leg.deeper else "unloading",
        )
        named.add(leg.deeper)
    if float(np.max(along.content)) > item.yield_depth:
        axes.axvline(item.yield_depth / across, color=style.GREEN, linestyle=style.DASHES[2], label="yield begins")
    if item.depth.size <= MARKED:
        points = item.depth / across, getattr(item, name) / upright
        axes.plot(*points, "o", color=style.INK, markersize=4.0, label="points of the path", zorder=5)
    axes.margins(x=0.04, y=0.08)
    axes.set_xlabel(along.label().replace("depth", "depth (overlap)", 1))
    axes.set_ylabel(of.label())


def _legs(item: ParticleSolution) -> list[_Leg]:
    """Return the whole way through many states, as far as the answer goes."""
    problem, by_depth = item.problem, isinstance(item.problem.path, Depth)
    levels = item.depth if by_depth else item.force
    row = np.append(min(0.0, float(levels[0])), levels)
    ways = [_between(low, high, item.yield_depth if by_depth else math.inf) for low, high in itertools.pairwise(row)]
    dense = np.concatenate([row[:1], *ways])
    found = dataclasses.replace(problem, path=Depth(dense) if by_depth else Force(dense)).solve()
    legs, start = [], 0
    for way, (low, high) in zip(ways, itertools.pairwise(row), strict=True):
        part = slice(start, start + way.size + 1)
        start += way.size
        if high != low:
            legs.append(_Leg(high > low, found.depth[part], found.force[part], found.radius[part]))
    return legs


def _between(low: float, high: float, jump: float) -> Array:
    """Return places after one and up to another, with both sides of a jump between them."""
    way = np.linspace(low, high, FINE + 1)[1:]
    beside = np.array([jump * (1.0 - BESIDE), jump * (1.0 + BESIDE)])
    inside = beside[(beside > min(low, high)) & (beside < max(low, high))]
    way = np.unique(np.append(way, inside))
    return way if low < high else way[::-1]
