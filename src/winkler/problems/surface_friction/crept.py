r"""Layers under a height map that relax each by a law of its own: every term of their creep has a response of its own.

Tractions q that change steadily in a step displace the surface at its end by

.. math:: u = A_0\,q + \sum_j A_j\,(q - e_j) , \qquad \dot e_j = \dot q - e_j/\lambda_j ,

with the :math:`A_j` of `winkler.numerics.springs.rate_fit`, from grids of elastic layers.  The step is that of an
elastic surface of what multiplies the new tractions, which the rest has displaced already.
"""

from __future__ import annotations

from typing import NamedTuple, cast

import numpy as np

from winkler.media.mapped import layers_of
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.numerics.pixels.layered import LayeredSurface, MixedSurface, SurfaceBelow
from winkler.numerics.springs.rate_fit import RateFit
from winkler.numerics.surfaces.surface_grid import SurfaceGrid
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.numerics.types import Array
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.surface_friction.relaxing import loss_factors, rising


class MapCreep:
    """What displaces a map term by term; lengths in pixels along x, tractions over E* after all time.

    Parameters
    ----------
    medium : RelaxingByWaves
    shape, pixel : tuple
        Pixels of the map, and their size [m].
    periodic : bool
    """

    def __init__(
        self, medium: RelaxingByWaves, shape: tuple[int, int], pixel: tuple[float, float], *, periodic: bool
    ) -> None:
        self.fit = cast(RateFit, medium.rates)
        stacks = [medium.elastic_at(rate) for rate in self.fit.rates.tolist()]
        self.softer = np.array([medium.elastic.modulus / stack.modulus for stack in stacks])
        self.layers = tuple(cast(LayeredSurface, layers_of(stack)) for stack in stacks)
        aspect, pressed, pushed = (1.0, pixel[1] / pixel[0]), [], []
        for stack, below, soft in zip(stacks, self.layers, self.softer.tolist(), strict=True):
            grid = SurfaceGrid.of(shape, aspect, periodic=periodic, layers=below.in_units_of(pixel[0]))
            compliance = compliance_of(stack).in_units_of(pixel[0])
            self.grid = TractionGrid.of(shape, aspect, compliance, periodic=periodic)
            pressed.append(soft * grid.response)
            pushed.append(soft * self.grid.along)
        self.local = self.fit.terms(self.softer)
        self.pressed, self.along = self.fit.terms(np.stack(pressed)), self.fit.terms(np.stack(pushed))

    def displaced(self, parts: Array) -> Array:
        """Return how far tractions of each term move the surface along ``(1 + k, 2, nx, ny)``."""
        each = zip(self.along, parts, strict=True)
        return np.stack([self.grid._replace(along=along).sheared(part) for along, part in each])


class CreptMemory(NamedTuple):
    """What a map remembers; as of `SurfaceMemory`, except for what is said of it.

    Parameters
    ----------
    creep : MapCreep
    held, change : ndarray, (3, nx, ny)
        q over E* after all time, and how it changed in the step.
    parts, earlier : ndarray, (terms, 3, nx, ny)
        e_j after the step, and before it.
    base : ndarray, (1 + terms, 3, nx, ny)
        Tractions that have displaced the surface before the step, by term.
    scale : float
        E* of the step over that after all time.
    spans : ndarray, (terms,)
        Duration of the step over the times.
    """

    creep: MapCreep
    held: Array
    change: Array
    parts: Array
    earlier: Array
    base: Array
    scale: float
    spans: Array

    @classmethod
    def fresh(cls, creep: MapCreep, shape: tuple[int, ...]) -> CreptMemory:
        """Return that of layers that nothing has pressed, on a map (nx, ny)."""
        none, parts = np.zeros((3, *shape)), np.zeros((creep.fit.times.size, 3, *shape))
        base = np.zeros((1 + creep.fit.times.size, 3, *shape))
        return cls(creep, none, none, parts, parts, base, 1.0, np.zeros(creep.fit.times.size))

    @property
    def _crept(self) -> Array:
        """Which parts of new tractions have crept at the end of the step, by term."""
        return np.append(1.0, 1.0 - rising(self.spans))

    def touched(self) -> Array:
        """Return that all pixels count: none is left out."""
        return np.ones(self.held.shape[1:], dtype=bool)

    def begin(self, dt: float) -> CreptMemory:
        """Return what is remembered at the beginning of a step of a duration [s]."""
        started = self._replace(spans=dt / self.creep.fit.times)
        fade, rise = (row[:, None, None, None] for row in (np.exp(-started.spans), rising(started.spans)))
        base = np.concatenate([0.0 * self.held[None], rise * self.held - fade * self.parts])
        return started._replace(base=base, scale=1.0 / float(started._crept @ self.creep.local))

    def end(self, borne: Array) -> CreptMemory:
        """Return what is remembered at its end, under pressures and tractions over its E*, ``(3, nx, ny)``."""
        held = self.scale * borne
        change = held - self.held
        fade, rise = (row[:, None, None, None] for row in (np.exp(-self.spans), rising(self.spans)))
        return self._replace(held=held, change=change, parts=fade * self.parts + rise * change, earlier=self.parts)

    def grid(self, made: TractionGrid) -> TractionGrid:
        """Return the response of the step to tractions over its E*."""
        return self.creep.grid._replace(along=self.scale * np.tensordot(self._crept, self.creep.along, 1))

    def layers(self, below: SurfaceBelow | None) -> MixedSurface:
        """Return what lies below the surface in the step, lengths in m."""
        weights = self.scale * (self._crept @ self.creep.fit.shares) * self.creep.softer
        return MixedSurface(self.creep.layers, tuple(weights.tolist()))

    def sunk(self, surface: SurfaceGrid) -> Array:
        """Return how far the surface is pressed in before the step, in pixels."""
        return np.asarray(surface.numbers(np.sum(self.creep.pressed * surface.waves(self.base[:, 0]), axis=0)))

    def carried(self, grid: TractionGrid, box: tuple[slice, slice]) -> Array:
        """Return how far it is moved along before the step, in pixels."""
        return np.asarray(np.sum(self.creep.displaced(self.base[:, 1:]), axis=0))

    def left(self, grid: TractionGrid, box: tuple[slice, slice]) -> Array:
        """Return how far it stands moved along when the step begins, beyond `carried`."""
        now = np.concatenate([self.held[None], self.held - self.parts])
        return np.asarray(np.sum(self.creep.displaced((now - self.base)[:, 1:]), axis=0))

    def energies(self, grid: TractionGrid, box: tuple[slice, slice], moved: Array) -> tuple[float, float]:
        """Return what tractions store at the end of the step, and what they lost in it, as of `SurfaceMemory`."""
        crept = np.concatenate([self.held[None], self.held - self.parts])[:, 1:]
        stored = 0.5 * float(np.sum(crept * self.creep.displaced(crept)))
        change = np.broadcast_to(self.change[1:], self.earlier[:, 1:].shape)
        first, none = self.earlier[:, 1:], np.zeros((1, *self.change[1:].shape))
        moved_first, turned = (self.creep.displaced(np.concatenate([none, row]))[1:] for row in (first, change))
        lost = 0.0
        for span, *rows in zip(self.spans.tolist(), first, change, moved_first, turned, strict=True):
            one, two, moved_one, moved_two = rows
            products = [float(np.sum(row)) for row in (one * moved_one, one * moved_two, two * moved_two)]
            lost += float(np.dot(loss_factors(span), products))
        return stored, lost
