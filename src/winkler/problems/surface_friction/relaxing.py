r"""Bodies under a height map that relax: what their surface remembers, and one step of it as a step of elastic bodies.

All parts of the bodies relax by one function of time, and Poisson's ratios do not change, so that space and time
separate: the surfaces are displaced as those of the elastic bodies under pressures and tractions w, and bear

.. math:: q(t) = M_\infty w + \sum_i M_i s_i , \qquad \dot s_i = \dot w - s_i/\tau_i .

Over a step w changes steadily, so that q at its end is an instantaneous modulus A times w, and what is left of before:

.. math:: w = q/A + b , \qquad A = M_\infty + \sum_i M_i \frac{1-e^{-h_i}}{h_i} , \qquad h_i = \Delta t/\tau_i .

The step is that of elastic bodies of A times their moduli whose surfaces b has displaced already.  A pixel that bears
nothing any more is displaced by b alone: it recovers freely.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from winkler.materials.elastic import Rigid
from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.media.halfspace import HalfSpace
from winkler.media.mapped import MappedMedium
from winkler.media.relaxing.at_rate import GLASSY, elastic_with
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.media.relaxing.relaxing_medium import LEE, relaxes
from winkler.media.relaxing.viscoelastic import creep_ratio
from winkler.numerics.pixels.layered import SurfaceBelow
from winkler.numerics.springs.exponential_sums import RelaxationSeries
from winkler.numerics.surfaces.surface_grid import SurfaceGrid
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.numerics.types import Array
from winkler.problems.assumptions.times import path_notes
from winkler.problems.normal.unknown_yield import relaxing_yield
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing

STILL = RelaxationSeries(1.0, 0.0, np.empty(0), np.empty(0))
"""The course of bodies that do not relax."""
SHORT = 1e-3
"""Part of a relaxation time below which a loss is taken from its power series: its terms would cancel."""


def course_of(owner: str, medium: Any) -> tuple[MappedMedium, RelaxationSeries | RelaxingByWaves]:
    """Return the elastic bodies, and by what their moduli are multiplied in the course of time.

    Of layers that relax each by a law of its own these are the elastic ones after all time, and they themselves.

    Parameters
    ----------
    owner : str
        Kind of problem, for messages.
    medium : MappedMedium
        Elastic, or relaxing.

    Raises
    ------
    InvalidInput
        If no elastic layers answer to shear as it does, or a dashpot stands alongside.
    """
    if not relaxes(medium):
        return medium, STILL
    if not medium.in_proportion and medium.rates:
        return medium.elastic, medium
    if not medium.in_proportion:
        raise InvalidInput(
            f"{owner}: {medium.reason} The response to shear during the flow is not implemented. Give {medium.alike}."
        )
    series = medium.relaxation
    if series.viscosity > 0.0:
        raise InvalidInput(
            f"{owner}: a dashpot alongside loads pixels that are caught suddenly with an infinite pressure; give a "
            "solid without one, such as StandardSolid or Prony."
        )
    bodies: list[Any] = [getattr(medium, name, None) for name in ("first", "second")]
    if not any(isinstance(body, ViscoelasticSolid) for body in bodies):
        return medium.elastic, series
    alone = any(isinstance(body, Rigid) for body in bodies)
    # the surface of a body that keeps its volume relaxes along itself as it does across
    if not (alone or creep_ratio(*bodies) is not None or all(body.poisson == 0.5 for body in bodies)):
        raise InvalidInput(
            f"{owner}: the bodies relax each by a function of its own, so that the surface relaxes otherwise along "
            "than across itself and no single function of time describes both; give bodies that relax in proportion, "
            "one of them rigid, or both with the Poisson's ratio 0.5."
        )
    first, second = (elastic_with(body, GLASSY) for body in bodies)
    return HalfSpace(first, second), series.scaled(1.0 / series.glassy)


class SurfaceMemory(NamedTuple):
    """Pressures and tractions on elastic bodies that would be displaced alike, and what each term of relaxation keeps.

    Parameters
    ----------
    series : RelaxationSeries
        By what the moduli of the elastic bodies are multiplied, without a dashpot.
    held, change : ndarray, (3, nx, ny)
        w, and how it changed in the step, over E*.
    parts, earlier : ndarray, (terms, 3, nx, ny)
        s_i, after the step and before it.
    base : ndarray, (3, nx, ny)
        b of the step.
    scale : float
        A of the step.
    spans : ndarray, (terms,)
        h_i of the step.
    """

    series: RelaxationSeries
    held: Array
    change: Array
    parts: Array
    earlier: Array
    base: Array
    scale: float
    spans: Array

    @classmethod
    def fresh(cls, series: RelaxationSeries, shape: tuple[int, ...]) -> SurfaceMemory:
        """Return that of bodies that nothing has pressed, on a map (nx, ny)."""
        none, parts = np.zeros((3, *shape)), np.zeros((series.moduli.size, 3, *shape))
        return cls(series, none, none, parts, parts, none, series.glassy, np.zeros(series.moduli.size))

    def grid(self, made: TractionGrid) -> TractionGrid:
        """Return the response of the step to tractions over its E*, that of elastic bodies."""
        return made

    def layers(self, below: SurfaceBelow | None) -> SurfaceBelow | None:
        """Return what lies below the surface in the step: what lies there in elastic bodies."""
        return below

    def sunk(self, surface: SurfaceGrid) -> Array:
        """Return how far the surface is pressed in before the step, in pixels."""
        return np.asarray(surface.displaced(self.base[0]))

    def carried(self, grid: TractionGrid, box: tuple[slice, slice]) -> Array:
        """Return how far a part of it is moved along before the step, in pixels."""
        return grid.sheared(self.base[1:][(slice(None), *box)])

    def left(self, grid: TractionGrid, box: tuple[slice, slice]) -> Array:
        """Return how far that stands moved along when the step begins, beyond `carried`."""
        return grid.sheared((self.held - self.base)[1:][(slice(None), *box)])

    def touched(self) -> Array:
        """Which pixels have borne something that is remembered, ``(nx, ny)``."""
        return np.asarray(np.any(self.held, 0) | np.any(self.parts, (0, 1)))

    def begin(self, dt: float) -> SurfaceMemory:
        """Return what is remembered at the beginning of a step of a duration [s], with its A and b."""
        if self.spans.size == 0:
            return self
        series, spans = self.series, dt / self.series.times
        lifted = float(series.moduli @ rising(spans))
        scale = series.relaxed + lifted
        base = (lifted * self.held - np.tensordot(series.moduli * np.exp(-spans), self.parts, 1)) / scale
        return self._replace(base=base, scale=scale, spans=spans)

    def end(self, borne: Array) -> SurfaceMemory:
        """Return what is remembered at its end, under pressures and tractions over A, ``(3, nx, ny)``."""
        held, parts = borne + self.base, self.parts
        change = held - self.held
        if self.spans.size > 0:
            fade, rise = (row[:, None, None, None] for row in (np.exp(-self.spans), rising(self.spans)))
            parts = fade * parts + rise * change
        return self._replace(held=held, change=change, parts=parts, earlier=self.parts)

    def energies(self, grid: TractionGrid, box: tuple[slice, slice], moved: Array) -> tuple[float, float]:
        """Return what tractions store at the end of the step, and what they lost in it inside of the bodies.

        Parameters
        ----------
        grid : TractionGrid
            The part of the map in which anything has been borne.
        box : tuple of slice
            Where it lies.
        moved : ndarray, (2, nx, ny)
            Displacement along the surface of that part at the end of the step.
        """
        here, series = (slice(1, None), *box), self.series
        stored, lost = 0.5 * series.relaxed * float(np.sum(self.held[here] * moved)), 0.0
        if self.spans.size == 0:
            return stored, lost
        change, fades, rises = self.change[here], np.exp(-self.spans), rising(self.spans)
        turned = grid.sheared(change)
        terms = zip(series.moduli.tolist(), self.spans.tolist(), fades, rises, self.earlier, strict=True)
        for modulus, span, fade, rise, part in terms:
            first = part[here]
            moved_first = grid.sheared(first)
            products = [float(np.sum(row)) for row in (first * moved_first, first * turned, change * turned)]
            stored += 0.5 * modulus * float(np.dot([fade**2, 2.0 * fade * rise, rise**2], products))
            lost += modulus * float(np.dot(loss_factors(span), products))
        return stored, lost


def rising(spans: Array) -> Array:
    """Return what each term keeps of a steady change, ``(terms,)``."""
    return np.where(spans > 0.0, -np.expm1(-spans) / np.where(spans > 0.0, spans, 1.0), 1.0)


def loss_factors(span: float) -> tuple[float, float, float]:
    """Return by what a term loses: of what it kept at first, twice that with the change, and of the change."""
    if span == 0.0:
        return 0.0, 0.0, 0.0
    once, twice = -math.expm1(-span), -math.expm1(-2.0 * span)
    if span < SHORT:
        rising = span * (1.0 / 3.0 - span * (0.25 - span * 7.0 / 60.0))
    else:
        rising = (1.0 - 2.0 * once / span + 0.5 * twice / span) / span
    return 0.5 * twice, once**2 / span, rising


def relaxing_map_notes(medium: Any, time: Array) -> tuple[Note, ...]:
    """Return what is assumed of bodies that relax on a path through moments [s]; nothing of elastic ones."""
    if not relaxes(medium):
        return ()
    return (COURSE if medium.in_proportion else LAYERED, *path_notes(medium, time), *relaxing_yield(medium))


LAYERED = Note(
    Assumption.RESPONSE,
    Standing.ASYMPTOTIC,
    "Each layer has its own relaxation function and a constant Poisson's ratio. The response of the pixels is a sum of "
    "exponentials in time, with a relative error below 1e-4. Tractions are assumed linear in time between the points "
    "of the path. Errors are proportional to the square of the step size; compare with twice the points.",
    LEE,
)
COURSE = Note(
    Assumption.RESPONSE,
    Standing.ASYMPTOTIC,
    "All bodies are assumed to have one common relaxation function and constant Poisson's ratios. Each step is "
    "then an elastic problem to which the other notes apply. Surface displacements are assumed linear in time "
    "between the points of the path. Errors are proportional to the step size; compare with twice the points.",
    LEE,
)
