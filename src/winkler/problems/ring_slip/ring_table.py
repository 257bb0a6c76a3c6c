r"""Springs of layered and graded bodies at fixed places, with what they bear at any depth: for many small steps.

A ring of springs around the place x counts :math:`\int e^2\,\mathrm dx` over its width, and bears at most the bound of
`winkler.problems.ring_slip.push_bound`, which is known at contact radii halfway between rings and is read straight
between them.  Where nothing slides, what counts is :math:`\mathrm dk_x/\mathrm da`, on any medium of which it is known.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.torsion_bound import BOUND_ROUNDING
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array
from winkler.problems.ring_slip.push_bound import PushBound, pushed_body
from winkler.values.errors import OutsideValidity

RINGS = 300
"""Rings of the widest contact; results err by a few over the square of that."""
STUCK_NODES = 8
"""Gauss nodes in every ring, for what a stuck ring counts."""


class RingTable(NamedTuple):
    """Rings of springs, from the axis outwards.

    Parameters
    ----------
    modulus : float
        G* [Pa]: a stuck ring bears h = G* U.
    coefficient : float
        mu; infinite where nothing slides.
    edges, gaps : ndarray, (n + 1,), (n,)
        Radii between rings [m]; depths at which rings come into contact [m].
    weights : ndarray, (n,)
        What the load h of each ring counts in the force, twice the integral of e^2 over it [m].
    levels : ndarray, (n + 1,)
        Depths at which the contact reaches the edges [m].
    bounds : ndarray, (n + 1, n)
        What rings bear at these depths, over mu [Pa].
    beyond : ndarray, (n,)
        How fast that grows with the depth once the contact fills the body [Pa/m].
    """

    modulus: float
    coefficient: float
    edges: Array
    gaps: Array
    weights: Array
    levels: Array
    bounds: Array
    beyond: Array

    def bound(self, depth: float) -> Array:
        """Return what each ring bears at a depth [m], ``(n,)`` [Pa]; zero outside of the contact."""
        if math.isinf(self.coefficient):
            return np.where(self.gaps < depth, np.inf, 0.0)
        levels = self.levels
        k = int(np.searchsorted(levels, depth, side="right")) - 1
        if k < 0:
            return np.zeros(self.gaps.size)
        if k >= self.gaps.size:
            found = self.bounds[-1] + max(depth - float(levels[-1]), 0.0) * self.beyond
        else:
            part = (depth - levels[k]) / (levels[k + 1] - levels[k])
            found = self.bounds[k] + part * (self.bounds[k + 1] - self.bounds[k])
            late = float(self.gaps[k])  # the ring that the edge passes comes into contact between the levels
            found[k] = self.bounds[k + 1, k] * (depth - late) / (float(levels[k + 1]) - late) if depth > late else 0.0
        return np.asarray(self.coefficient * np.maximum(found, 0.0))


class SlidingRings(NamedTuple):
    """What rings do in a step.

    Parameters
    ----------
    load : ndarray, (n,)
        h after it [Pa].
    force : float
        The shear force [N], averaged over the motion along the surface.
    loss : float
        [J].
    side : ndarray, (n,)
        To which side each ring has slid, or zero.
    """

    load: Array
    force: float
    loss: float
    side: Array


class PressedStep(NamedTuple):
    """How the depth changes in a step: bounds before and after [Pa], and during which part of it rings touch."""

    before: Array
    after: Array
    part: Array


def pressed_step(table: RingTable, start: float, end: float) -> PressedStep:
    """Return what a step from one depth to another [m] does to the rings."""
    gaps = table.gaps
    first, last = gaps < start, gaps < end
    both = first & last
    change = end - start
    part = np.where(both, 1.0, 0.0)
    if change != 0.0:
        touched = first ^ last
        part[touched] = (max(start, end) - gaps[touched]) / abs(change)
    return PressedStep(table.bound(start), table.bound(end), part)


def slide(table: RingTable, load: Array, step: PressedStep, shift: float) -> SlidingRings:
    """Return the rings after a straight step in depth and shift.

    Parameters
    ----------
    table : RingTable
    load : ndarray, (n,)
        h before it [Pa].
    step : PressedStep
    shift : float
        By which the body moves along the surface [m].

    Notes
    -----
    Force and loss are those of rings whose bound changes in proportion; what the force spends on the shift is what is
    stored and what is lost, to rounding, and no ring gains from sliding.
    """
    before, after, part = step
    trial = load + table.modulus * shift * part
    if math.isinf(table.coefficient):
        left = after == 0.0
        force = float(np.sum(table.weights * part * 0.5 * (load + trial)))
        lost = float(np.sum(table.weights * np.where(left, trial, 0.0) ** 2)) / (2.0 * table.modulus)
        return SlidingRings(np.where(left, 0.0, trial), force, lost, np.zeros(load.size))
    side = np.sign(trial)
    excess = np.maximum(side * trial - after, 0.0)
    slides = excess > 0.0
    side = np.where(slides, side, 0.0)
    new = np.where(slides, side * after, trial)
    margin = np.maximum(before - side * load, 0.0)
    onset = np.where(slides, margin / np.where(slides, margin + excess, 1.0), 1.0)
    reached = np.where(slides, side * (before + (after - before) * onset), trial)
    mean = 0.5 * (onset * (load + reached) + (1.0 - onset) * (reached + new))
    force = float(np.sum(table.weights * part * mean))
    lost = float(np.sum(table.weights * 0.5 * (np.abs(reached) + after) * excess)) / table.modulus
    return SlidingRings(new, force, lost, side)


def stored(table: RingTable, load: Array) -> float:
    """Return the energy that the rings store [J]."""
    return float(np.sum(table.weights * load * load)) / (2.0 * table.modulus)


class _Owned(PushBound):
    """What springs bear, for a message of whoever asks."""

    def __init__(self, owner: str, bed: Bed, widest: float) -> None:
        self.owner = owner
        super().__init__(bed, 1.0, widest, False)

    def rim_growth(self, radius: float) -> Array:
        """Return how fast bounds grow with the depth where the contact fills the body [Pa/m]."""
        panels, count = self.panels, self.x.shape[1]
        place = np.array([radius])
        k = panels.panel(place)
        last = slice(int(k[0]) * count, (int(k[0]) + 1) * count)
        return np.asarray(self._kernel.bound[:, last] @ panels.reading(place, k)[0])


def ring_table(owner: str, bed: Bed, coefficient: float, widest: float, count: int = RINGS) -> RingTable:
    """Return the rings of contacts up to a widest one [m].

    Parameters
    ----------
    owner : str
        Kind of problem, for messages.
    bed : Bed
        On a medium of `layers_of_rings`; any whose tangential stiffness is known if the coefficient is infinite.
    coefficient : float
        mu [-].
    widest : float
        [m].
    count : int, optional
        Of rings.

    Raises
    ------
    OutsideValidity
        If sliding rings would turn the inner part of the contact back, so that they are not the outer ones.
    """
    rings = _rings(owner, bed, widest, count, math.isinf(coefficient))
    return rings._replace(coefficient=coefficient)


@functools.lru_cache(maxsize=8)
def _rings(owner: str, bed: Bed, widest: float, count: int, endless: bool) -> RingTable:
    edges = np.linspace(0.0, widest, count + 1)
    places = 0.5 * (edges[1:] + edges[:-1])
    gaps, levels = bed.gap(places), np.append(0.0, bed.gap(edges[1:]))
    if endless:
        nodes, shares = gauss_legendre(STUCK_NODES)
        x = edges[:-1, None] + np.diff(edges)[:, None] * nodes
        weights = 2.0 * np.sum(bed.tangential_stiffness(x) * shares, axis=1) * np.diff(edges)
        none = np.zeros(0)
        return RingTable(1.0, math.inf, edges, gaps, weights, levels, none, none)
    bound, modulus = _Owned(owner, bed, widest), pushed_body(bed).shear_modulus
    weights = 2.0 * np.diff(bound.panels.integral(bound.weight, edges))
    panel = bound.panels.panel(places)
    reading = bound.panels.reading(places, panel)
    node = panel[:, None] * bound.x.shape[1] + np.arange(bound.x.shape[1])
    at_nodes = bound.over(edges[1:], np.zeros(count))
    bounds = np.einsum("mnc,nc->mn", at_nodes[:, node], reading)
    bounds[places > edges[1:, None]] = 0.0
    if np.min(bounds) < -BOUND_ROUNDING * np.max(bounds):
        first = float(edges[1:][np.min(bounds, axis=1) < -BOUND_ROUNDING * np.max(bounds)][0])
        raise OutsideValidity(
            f"{owner}: at a contact radius of {first:.3g} m the rings that would slide first are not the outer ones, "
            "since the coating spreads their traction inwards; give a narrower contact, a slower or lighter body."
        )
    growth = np.einsum("nc,nc->n", bound.rim_growth(widest)[node], reading)
    bounds = np.concatenate([np.zeros((1, places.size)), bounds])
    return RingTable(modulus, 1.0, edges, gaps, weights, levels, bounds, growth)
