r"""One step of Newton's method on a surface, inside a trust region (Steihaug).

:math:`(K + D)s = -r` on the pixels that are free, with the stiffness K of the surface and D of the law, by conjugate
gradients in single digits.  The preconditioner is the compliance of the surface; where the law is stiff that of the
surface on springs.  Lengths are those of the elastic energy, :math:`s K s`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.attracted.elastic_surface import ElasticSurface
from winkler.numerics.types import Array

__all__ = ["RegionStep", "region_step"]

MOST_ITERATIONS = 120
"""Conjugate gradients in one step; ten are usual."""
STIFF = 4.0
"""Pixels whose law is stiffer than the longest wave of the map by this factor are preconditioned as on springs."""
FLATTEST = 1e-6
"""Curvature of the energy over the elastic one below which a direction counts as one of negative curvature."""


class RegionStep(NamedTuple):
    """A step.

    Parameters
    ----------
    change
        Of the displacements on the torus.
    gain
        By how much the energy of second order falls.
    at_edge
        Whether the step ends at the edge of the region.
    """

    change: Array
    gain: float
    at_edge: bool


class FreeMoves:
    """The surface as conjugate gradients see it: moves of the free pixels, without a mean if it is periodic."""

    def __init__(self, surface: ElasticSurface, free: Array, stiffness: Array):
        self.surface, self.kept = surface, free.astype(np.float32)
        self.count = float(np.count_nonzero(free))
        self.bend = stiffness.astype(np.float32)
        stiff = self.bend > np.float32(STIFF * 2.0 * math.pi / max(surface.shape))
        self.pressed = np.zeros_like(self.kept)
        self.pressed[surface.area] = stiff & free[surface.area]
        self.some = bool(np.any(self.pressed))
        self.bedded = surface.bedded(float(np.median(self.bend[stiff]))) if self.some else surface.single_compliance

    def projected(self, numbers: Array) -> Array:
        """Return what free pixels may do of it."""
        numbers *= self.kept
        if self.surface.periodic:
            numbers -= self.kept * np.float32(float(np.sum(numbers, dtype=np.float64)) / self.count)
        return numbers

    def softened(self, force: Array) -> Array:
        """Return roughly the displacements under tractions."""
        if not self.some:
            return self.projected(self.surface.displaced(force))
        rest = np.float32(1.0) - self.pressed
        apart = self.surface.displaced(force * rest) * rest
        return self.projected(apart + self.surface.applied(self.bedded, force * self.pressed) * self.pressed)

    def bent(self, held: Array, along: Array) -> Array:
        """Return (K + D) d, from K d."""
        both = held.copy()
        both[self.surface.area] += self.bend * along[self.surface.area]
        return both


def region_step(
    surface: ElasticSurface, wrong: Array, free: Array, stiffness: Array, radius: float, aim: float
) -> RegionStep:
    """Return a step.

    Parameters
    ----------
    surface
        The surface.
    wrong
        r, tractions out of balance on the torus; zero where pixels are held.
    free
        Which pixels of the torus may move.
    stiffness
        D on the map.
    radius
        Of the region.
    aim
        To what part of the residual the equations are solved.
    """
    reduced = FreeMoves(surface, free, stiffness)
    size = float(np.max(np.abs(wrong)))  # in single digits squares of small numbers would vanish
    r = reduced.projected((-wrong / size).astype(np.float32))
    s, ks = np.zeros_like(r), np.zeros_like(r)
    along = reduced.softened(r)
    product = first = _dot(r, along)
    reach, gain, at_edge = radius / size, 0.0, False
    for _ in range(MOST_ITERATIONS):
        held = surface.tractions(along)
        curved = reduced.bent(held, along)
        curvature, length, across = _dot(along, curved), _dot(along, held), _dot(s, held)
        inner = _dot(s, ks)
        negative = curvature <= FLATTEST * length
        far = 0.0 if negative else product / curvature
        if negative or inner + 2.0 * far * across + far * far * length >= reach * reach:
            far = _to_edge(inner, across, length, reach)
            s += np.float32(far) * along
            gain += far * _dot(r, along) - 0.5 * far * far * curvature
            at_edge = True
            break
        s += np.float32(far) * along
        ks += np.float32(far) * held
        gain += 0.5 * far * product
        r -= np.float32(far) * reduced.projected(curved)
        softened = reduced.softened(r)
        new = _dot(r, softened)
        if new <= aim * aim * first:
            break
        along = softened + np.float32(new / product) * along
        product = new
    return RegionStep(size * s.astype(np.float64), size * size * gain, at_edge)


def _dot(one: Array, other: Array) -> float:
    return float(np.vdot(one, other))


def _to_edge(inner: float, across: float, length: float, reach: float) -> float:
    """Return t with |s + t d| = reach; one where nothing bounds it."""
    if not math.isfinite(reach):
        return 1.0
    return (math.sqrt(max(across * across + length * (reach * reach - inner), 0.0)) - across) / length
