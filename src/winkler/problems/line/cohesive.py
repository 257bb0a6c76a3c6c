r"""A line contact in an attraction with a range: a constant stress beside the strip (Maugis' law for lines).

The stress :math:`\sigma_0` pulls from a to c, where the surfaces are :math:`h(c) = \gamma/\sigma_0` apart.  On
half-planes the flat punches that add up to the pressure have the loads :math:`E^*w'(s)` up to a, and beyond it
:math:`-2\sigma_0 s/\sqrt{c^2-s^2}`, so that with :math:`l = \sqrt{c^2-a^2}`

.. math:: P = E^* w(a) - 2\sigma_0 l , \qquad p(x) = p_w(x) - \frac{2\sigma_0}\pi\arctan\frac l{\sqrt{a^2-x^2}} .

The bed knows the distance h(c) and, on layers, what they add to both.

References
----------
J. M. Baney, C.-Y. Hui, J. Adhes. Sci. Technol. 11 (1997) 393-406, doi:10.1163/156856197X00778
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings, StretchedSprings
from winkler.foundation.line_bed import LineBed
from winkler.laws.adhesion import Dugdale
from winkler.numerics.equations.roots import between
from winkler.numerics.types import Array
from winkler.problems.line.load_springs import LoadSprings
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.value import value

ITERATIONS = 60
STEP_TOLERANCE, WORST_STEP = 1e-13, 1e-8
"""Last step over l that ends the iteration, and that close to a vertical wall, where w' is known to less."""


class LineZone(NamedTuple):
    """Where the attraction ends, c [m]; l = sqrt(c^2 - a^2) [m]."""

    outer: Array
    span: Array


@value
class CohesiveLineStates:
    """The equilibria of a line contact under a constant attraction; their `depth` is the force per length [N/m].

    Parameters
    ----------
    line : LineFoundation or LayeredLineFoundation
    law : Dugdale

    Raises
    ------
    OutsideValidity
        If the profile has a rim or kinks.
    """

    line: LineBed
    law: Dugdale

    def __post_init__(self) -> None:
        if math.isfinite(self.line.rim) or self.line.kinks:
            raise OutsideValidity(
                "Dugdale: beside a line contact the attraction with a range is known for profiles without rims and "
                "kinks; use ShortRange(work), or a smooth profile."
            )

    @property
    def bed(self) -> Bed:
        """The springs whose depth is the force per length."""
        return LoadSprings(self.line)

    def end(self) -> float:
        """The half-width whose attraction ends where the profile does [m]."""
        return _end(self)

    def from_nothing(self) -> bool:
        """A line is held by the stress beside it."""
        return True

    def zone(self, half_width: Array) -> LineZone:
        """Return where the attraction ends beside contacts of given half-widths."""
        a = np.asarray(half_width, dtype=float)
        return _zone(self, a.shape, a.tobytes())

    def depth(self, radius: Array) -> Array:
        """P(a) [N/m]."""
        load = self.line.zone_load(np.asarray(radius, dtype=float), self.zone(radius).span, self.law.strength)
        return np.asarray(self.line.medium.modulus * load)

    def load(self, radius: Array) -> Array:
        """What makes k d - load the force per length again."""
        return np.asarray((self.bed.stiffness(radius) - 1.0) * self.depth(radius))

    def slopes(self, radius: Array) -> tuple[Array, Array]:
        """P'(a) [Pa], twice."""
        a = np.asarray(radius, dtype=float)
        slope = self.line.medium.modulus * self.line.zone_load_slope(a, self.zone(a).span, self.law.strength)
        return slope, slope

    def scale(self, radius: Array) -> Array:
        """Pull over the half-width of the zone [Pa]."""
        zone = self.zone(radius)
        return np.asarray(2.0 * self.law.strength * zone.span / zone.outer)

    def pressed(self, depth: float, radius: float) -> PressedSprings:
        """The springs that stand for the contact."""
        return StretchedSprings(self.bed, depth, radius)


@functools.lru_cache(maxsize=64)
def _zone(states: CohesiveLineStates, shape: tuple[int, ...], content: bytes) -> LineZone:
    a = np.frombuffer(content).ravel()
    bed, law = states.line, states.law
    secant = bed.half_plane is not bed
    if secant:
        span = CohesiveLineStates(bed.half_plane, law).zone(a).span
    else:  # without the profile the zone would be wider: Newton's method comes down from there
        span = np.asarray(bed.half_plane.zone_start(a, law.range, law.strength))
    reach = states.bed.reach
    if math.isfinite(reach):
        span = np.minimum(span, np.sqrt(np.maximum((reach - a) * (reach + a), (0.1 * law.range) ** 2)))
    moved, last = math.inf, np.full((2, a.size), np.nan)
    for _ in range(ITERATIONS):
        gap, opening = bed.zone_gap(a, span, law.strength)
        if secant:  # the slope is that of half-planes: the last step states a better one
            gone, opened = span - last[0], gap - last[1]
            opening = np.where(gone * opened > 0.0, opened / np.where(gone == 0.0, 1.0, gone), opening)
            last = np.array([span, gap])
        new = np.maximum(span - (gap - law.range) / opening, 0.1 * span)
        before, moved = moved, float(np.max(np.abs(new - span) / span))
        span = new
        if moved <= STEP_TOLERANCE or (moved <= WORST_STEP and (secant or moved > 0.5 * before)):
            break
    if not moved <= WORST_STEP:
        raise NotConverged("Dugdale: the end of the attraction beside the strip is not found; use ShortRange(work).")
    return LineZone(np.hypot(a, span).reshape(shape), span.reshape(shape))


@functools.lru_cache(maxsize=64)
def _end(states: CohesiveLineStates) -> float:
    reach = states.bed.reach
    if not math.isfinite(reach):
        return reach

    def missing(a: float) -> float:
        if a == reach:
            return -states.law.range
        places, last = np.array([a]), np.array([math.sqrt((reach - a) * (reach + a))])
        return float(states.line.zone_gap(places, last, states.law.strength)[0][0]) - states.law.range

    if missing(0.0) <= 0.0:
        raise OutsideValidity(
            f"Dugdale: the attraction of {states.law.range:.3g} m reaches beyond the end of the profile ({reach:.6g} "
            "m) even where the bodies only just touch; use ShortRange(work), a greater strength, or a wider profile."
        )
    return between(lambda a: -missing(a), 0.0, reach, relative=1e-13) * (1.0 - 1e-12)
