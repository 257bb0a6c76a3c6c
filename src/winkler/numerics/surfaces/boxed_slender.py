r"""A slender contact of unknown size: solved on a rough grid until the grid fits around it, then on finer ones.

Lengths are in units of half of the length of the body, which ends at -1 and 1; forces over E*.

A first guess of a slender contact: slices that press in proportion to their overlap, each for itself.

Under an even force per length q a cylinder approaches by about :math:`\Lambda q/(\pi E^*)`, with
:math:`\Lambda = 2\ln(2L/a)+1` near ten.  Of slices that bear :math:`q = \pi E^*\delta_+/\Lambda` on their overlap
:math:`\delta = d+\vartheta x-z`, approach and tilt under a stated force and moment make

.. math:: \frac{\pi}{2\Lambda}\int\delta_+^2\,\mathrm dx - Fd - M\vartheta

least: a convex function of two numbers, found by Newton's steps that are halved until they go down.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.pixels.layered import SurfaceBelow
from winkler.numerics.surfaces.pressed_slender import Pose, PressedSlender, press_slender
from winkler.numerics.surfaces.slender_grid import SlenderGrid, graded
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged, OutsideValidity

ROUGH_ELEMENTS = 32
"""Along the contact while its size is sought."""
ROWS_SHARE = 8
"""Elements along the contact for each one across half of it."""
MOST_BOXES = 60
"""Boxes tried around a contact; some five are usual."""
WELL_FILLED = 0.7
"""Part of a box along and across that a contact fills before the grid is refined."""
FINEST_SHARE, BEND_SHARE = 0.05, 0.3
"""Distance from which on elements grow, over the half-width, from an end of the contact and from a bend."""
APART_SHARE = 0.3
"""And at most over the distance of the next end or bend."""
FIRST_WIDTHS, FIRST_MARGIN = 0.5, 0.2
"""First half-widths over those of the overlap, and how much wider and longer the first box is."""
FIRST_WAVE = 1.0
"""Wave number at which a first guess takes the compliance of layers."""
SAMPLES, FEWEST_SAMPLES, MOST_ZOOMS = 1001, 20, 12
"""Places at which a contact is looked for; fewest of them that bear, or the search goes on between fewer places."""
OUTER, STEP, FEWEST_ACROSS = 3, 2, 6
"""Element, counted from the edge of a slice, through which its edge is found, how far from it the next two are at most,
and how many elements that takes."""
POWERS = np.linspace(0.5, 1.0, 26)
"""Of 1 - y^2/b^2, with which the pressure of a slice may fall towards its edge."""


class Generator(NamedTuple):
    """The generator of a slender body: how far it falls back along its length, its radius across, what lies below.

    Parameters
    ----------
    drop
        Takes places between -1 and 1, returns by how much the radius is smaller there; not negative, zero somewhere.
    radius
        Of curvature across.
    marks
        Places beside which the pressure may change quickly.
    layers
        What differs from a homogeneous half-space.
    """

    drop: Callable[[Array], Array]
    radius: float
    marks: tuple[float, ...]
    layers: SurfaceBelow | None = None


class SlenderContact(NamedTuple):
    """A contact on its grid."""

    grid: SlenderGrid
    pressed: PressedSlender

    @property
    def on_axis(self) -> Array:
        """Pressure in the middle of each slice, by the parabola through the elements beside it."""
        pressure = self.pressed.pressure
        return np.maximum((9.0 * pressure[:, 0] - pressure[:, 1]) / 8.0, 0.0)

    @property
    def half_width(self) -> Array:
        """Half-width b of each slice: the pressure goes like (1 - y^2/b^2)^s through three elements near the edge.

        A slender contact has s = 1/2, where a sharp end presses s is greater, and near one where the contact is much
        wider than long; elements finer than the length see s come back to 1/2 at the edge itself.  Elements at the very
        edge bear too much; slices of few elements are taken for semi-ellipses of their force.  On layers the pressure
        may follow no such power: an edge that lies an element beside those that bear is taken for the last one's end.
        """
        pressure, y = self.pressed.pressure, self.grid.places_across
        counts = np.count_nonzero(pressure, axis=1)
        slices, step = np.arange(counts.size), np.clip((counts - OUTER) // 2, 1, STEP)
        rows = [np.maximum(counts - OUTER - steps * step, 0) for steps in range(3)]
        axis = np.where(self.on_axis > 0.0, self.on_axis, 1.0)
        outer, middle, inner = ((pressure[slices, row] / axis)[:, None] ** (1.0 / POWERS) for row in rows)
        squares = [y[row, None] ** 2 for row in rows]
        near, far = squares[1] - squares[2], squares[0] - squares[1]
        # zero at the power with which all three lie on one curve; between two powers straight
        missed = (inner - middle) * far - (middle - outer) * near
        after = np.clip(np.argmax(missed * missed[:, :1] <= 0.0, axis=1), 1, POWERS.size - 1)
        after = np.where(np.all(missed * missed[:, :1] > 0.0, axis=1) & (missed[:, 0] > 0.0), POWERS.size - 1, after)
        before = after - 1
        one, other = missed[slices, before], missed[slices, after]
        share = np.where(one * other < 0.0, one / np.where(one != other, one - other, 1.0), np.abs(one) > np.abs(other))
        rise, height = (
            level[slices, before] + share * (level[slices, after] - level[slices, before])
            for level in (middle - outer, outer)
        )
        straight = (counts >= FEWEST_ACROSS) & (rise > 0.0)
        edge = np.sqrt(squares[0][:, 0] + far[:, 0] * height / np.where(straight, rise, 1.0))
        last = counts * self.grid.across
        edge = np.where(straight & (np.abs(edge - last) <= self.grid.across), edge, last)
        ellipse = 2.0 * self.force_per_length / (math.pi * axis)
        return np.where(counts > 0, np.where(counts >= FEWEST_ACROSS, edge, ellipse), 0.0)

    @property
    def force_per_length(self) -> Array:
        """Force per length of each slice, over E*."""
        return np.asarray(2.0 * self.grid.across * np.sum(self.pressed.pressure, axis=1))


class _Box(NamedTuple):
    low: float
    high: float
    width: float


def pressed_levels(generator: Generator, pose: Pose, elements: int) -> tuple[SlenderContact, SlenderContact]:
    """Return the contact on a grid of half as many elements, and on that of `elements` along it.

    Parameters
    ----------
    generator
        The body.
    pose
        What is stated.
    elements
        Along the contact.

    Raises
    ------
    NotConverged
        If the contact is not found.
    OutsideValidity
        If the elements are too coarse for an incompressible layer.
    """
    box, widths = _first_box(generator, pose)
    found, rough = None, ROUGH_ELEMENTS
    for _ in range(MOST_BOXES):
        try:
            contact = _solved(generator, pose, box, rough, found, widths)
        except OutsideValidity:  # too coarse for an incompressible layer
            if rough >= elements:
                raise
            rough *= 2
            continue
        fitting = _fitted(contact, box)
        if fitting is None:
            box, found = _wider(contact, box), contact
            continue
        filled = (fitting.high - fitting.low) / (box.high - box.low), fitting.width / box.width
        box, found = fitting, contact
        if min(filled) >= WELL_FILLED:
            break
    else:
        raise NotConverged(f"no grid fits around the contact after {MOST_BOXES} of them; tilt or press it less.")
    levels = []
    for count in (elements // 2, elements):
        for _ in range(MOST_BOXES):
            found = _solved(generator, pose, box, count, found, widths)
            fitting = _fitted(found, box)
            if fitting is not None:
                break
            box = _wider(found, box)
        else:
            raise NotConverged(f"no grid fits around the contact after {MOST_BOXES} of them; tilt or press it less.")
        levels.append(found)
        box = fitting
    return levels[0], levels[1]


def _first_box(generator: Generator, pose: Pose) -> tuple[_Box, tuple[Array, Array]]:
    """Return a first box, and half-widths over places, of slices that bear each for itself."""
    x = np.linspace(-1.0, 1.0, SAMPLES)
    if generator.layers is not None:  # a load overlaps as on a body as compliant as below a wave of the length
        compliance = float(generator.layers.whole(np.array([FIRST_WAVE]))[0])
        pose = pose._replace(force=pose.force * compliance, moment=pose.moment * compliance)
    for _ in range(MOST_ZOOMS):
        overlap = first_overlap(x, generator.drop(x), pose)
        bearing = np.flatnonzero(overlap > 0.0)
        if bearing.size >= FEWEST_SAMPLES:
            break
        low, high = (bearing[0], bearing[-1]) if bearing.size else (int(np.argmax(overlap)),) * 2
        x = np.linspace(x[max(low - FEWEST_SAMPLES, 0)], x[min(high + FEWEST_SAMPLES, SAMPLES - 1)], SAMPLES)
    else:
        raise NotConverged("the contact is too short to be found; press harder, or check the numbers and their units.")
    low, high = x[max(bearing[0] - 1, 0)], x[min(bearing[-1] + 1, SAMPLES - 1)]
    reach = FIRST_MARGIN * (high - low)
    widths = FIRST_WIDTHS * np.sqrt(2.0 * generator.radius * np.maximum(overlap, 0.0))
    box = _Box(max(low - reach, -1.0), min(high + reach, 1.0), (1.0 + FIRST_MARGIN) * float(np.max(widths)))
    return box, (x, widths)


def _solved(
    generator: Generator, pose: Pose, box: _Box, count: int, before: SlenderContact | None, widths: tuple[Array, Array]
) -> SlenderContact:
    """Return the contact in the box, begun from one on another grid."""
    rows = max(count // ROWS_SHARE, 4)
    bends = [mark for mark in generator.marks if box.low < mark < box.high]
    marks = np.array([box.low, *bends, box.high])
    apart = np.concatenate([[np.inf], np.diff(marks), [np.inf]])
    shares = np.array([FINEST_SHARE, *(BEND_SHARE for _ in bends), FINEST_SHARE])
    finest = np.minimum(shares * box.width, APART_SHARE * np.minimum(apart[1:], apart[:-1]))
    grid = SlenderGrid.of(graded(box.low, box.high, marks, finest, count), box.width / rows, rows, generator.layers)
    x, y = grid.middles, grid.places_across
    gaps = generator.drop(x)[:, None] + y**2 / (2.0 * generator.radius)
    width = np.interp(x, *widths) if before is None else np.interp(x, before.grid.middles, before.half_width)
    width[int(np.argmax(width))] = max(float(np.max(width)), 2.0 * float(y[0]))
    return SlenderContact(grid, press_slender(grid, gaps, pose, y < width[:, None]))


def _touching(contact: SlenderContact) -> tuple[int, int, int]:
    """Return the first and the last slice that bears, and the greatest number of elements across."""
    counts = np.count_nonzero(contact.pressed.pressure, axis=1)
    bearing = np.flatnonzero(counts)
    return int(bearing[0]), int(bearing[-1]), int(np.max(counts))


def _fitted(contact: SlenderContact, box: _Box) -> _Box | None:
    """Return the box one element wider than the contact; None if the contact may go on beyond its own box."""
    first, last, most = _touching(contact)
    edges, n = contact.grid.edges, contact.grid.middles.size
    if most == contact.grid.rows or (first == 0 and box.low > -1.0) or (last == n - 1 and box.high < 1.0):
        return None
    low = -1.0 if first == 0 else float(edges[first - 1])
    high = 1.0 if last == n - 1 else float(edges[last + 2])
    return _Box(low, high, (most + 0.75) * contact.grid.across)


def _wider(contact: SlenderContact, box: _Box) -> _Box:
    first, last, most = _touching(contact)
    reach = 0.25 * (box.high - box.low)
    return _Box(
        max(box.low - reach, -1.0) if first == 0 else box.low,
        min(box.high + reach, 1.0) if last == contact.grid.middles.size - 1 else box.high,
        1.5 * box.width if most == contact.grid.rows else box.width,
    )


USUAL = 10.0
MOST_STEPS, MOST_HALVINGS = 100, 40
CLOSE = 1e-3
"""Change of the overlap over the greatest one at which the guess is good enough."""


def first_overlap(x: Array, drop: Array, pose: Pose) -> Array:
    """Return the overlap of each slice, positive where it bears.

    Parameters
    ----------
    x
        Places, evenly.
    drop
        Drop of the generator there, infinite where there is none.
    pose
        What is stated, over E*.
    """
    finite = np.where(np.isfinite(drop), drop, 0.0)
    weights = np.where(np.isfinite(drop), math.pi / USUAL * (x[1] - x[0]), 0.0)
    free = np.array([math.isnan(pose.approach), math.isnan(pose.tilt)])
    middle = 0.5 * float(x[0] + x[-1]) if np.all(free) else 0.0
    loads = np.nan_to_num(np.array([pose.force, pose.moment - middle * pose.force]))
    start = np.nan_to_num(np.array([pose.approach, pose.tilt]))
    if free[0]:
        start[0] = loads[0] / float(np.sum(weights)) + float(np.max(finite - start[1] * x))
    basis = np.stack([np.ones(x.size), x - middle])

    def energy(at: Array) -> float:
        return 0.5 * float(np.sum(weights * np.maximum(at @ basis - finite, 0.0) ** 2)) - float(loads[free] @ at[free])

    level = energy(start)
    for _ in range(MOST_STEPS if np.any(free) else 0):
        overlap = np.maximum(start @ basis - finite, 0.0)
        slope = (basis @ (weights * overlap) - loads)[free]
        bend = ((basis * (weights * (overlap > 0.0))) @ basis.T)[np.ix_(free, free)]
        step = np.zeros(2)
        step[free] = -np.linalg.lstsq(bend, slope, rcond=None)[0]
        for _ in range(MOST_HALVINGS):
            if energy(start + step) <= level:
                break
            step *= 0.5
        start, level = start + step, energy(start + step)
        if np.max(np.abs(step @ basis)) <= CLOSE * float(np.max(overlap)):
            break
    return np.where(np.isfinite(drop), start @ basis - finite, -np.inf)
