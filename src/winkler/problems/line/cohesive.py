r"""A line contact in an attraction with a range: a constant stress beside the strip (Maugis' law for lines).

The stress :math:`\sigma_0` pulls from a to c, where the surfaces are :math:`\gamma/\sigma_0` apart.  The flat punches
that add up to the pressure have the loads :math:`E^*w'(s)` up to a, and beyond it :math:`-2\sigma_0
s/\sqrt{c^2-s^2}`, so that with :math:`l = \sqrt{c^2-a^2}`

.. math:: P &= E^* w(a) - 2\sigma_0 l , \qquad
          p(x) = p_w(x) - \frac{2\sigma_0}\pi\arctan\frac l{\sqrt{a^2-x^2}} , \\
          \frac\gamma{\sigma_0} &= \frac2\pi\int_a^c w'(s)\,\mathrm{arcosh}\frac cs\,\mathrm ds
          + \frac{4\sigma_0}{\pi E^*}\Big[l\,\mathrm{arcosh}\frac ca - c\ln\frac ca\Big] .

For a cylinder the integral is :math:`\frac1{2R}\big[cl - a^2\,\mathrm{arcosh}\frac ca\big]` (Baney and Hui).

References
----------
J. M. Baney, C.-Y. Hui, J. Adhes. Sci. Technol. 11 (1997) 393-406, doi:10.1163/156856197X00778
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.errors import NotConverged, OutsideValidity
from winkler.foundation.bed import Bed, PressedSprings, StretchedSprings
from winkler.foundation.line import LineFoundation
from winkler.laws.adhesion import Dugdale
from winkler.numerics.equations.roots import between
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array
from winkler.problems.line.load_springs import LoadSprings
from winkler.profiles.power import Paraboloid
from winkler.values import value

__all__ = ["CohesiveLineStates", "LineZone"]

NODES, PIECE = 16, 1.5
"""Nodes on each piece of the integral over arcosh(c/s)."""
FARTHEST = 40.0
"""Greatest arcosh(c/s): nearer to the middle nothing is left of the integral."""
ITERATIONS = 60
STEP_TOLERANCE, WORST_STEP = 1e-13, 1e-8
"""Last step over l that ends the iteration, and that close to a vertical wall, where w' is known to less."""


class LineZone(NamedTuple):
    """Where the attraction ends, c [m]; l = sqrt(c^2 - a^2) [m], and l'(a) [-]."""

    outer: Array
    span: Array
    span_slope: Array


@value
class CohesiveLineStates:
    """The equilibria of a line contact under a constant attraction; their `depth` is the force per length [N/m].

    Parameters
    ----------
    line : LineFoundation
    law : Dugdale

    Raises
    ------
    OutsideValidity
        If the profile has a rim or kinks.
    """

    line: LineFoundation
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
        pull = 2.0 * self.law.strength * self.zone(radius).span
        return np.asarray(self.line.medium.modulus * self.line.load_profile(radius) - pull)

    def load(self, radius: Array) -> Array:
        """What makes k d - load the force per length again."""
        return np.asarray((self.bed.stiffness(radius) - 1.0) * self.depth(radius))

    def slopes(self, radius: Array) -> tuple[Array, Array]:
        """P'(a) [Pa], twice."""
        zone = self.zone(radius)
        pull = 2.0 * self.law.strength * zone.span_slope
        slope = self.line.medium.modulus * self.line.load_profile_slope(radius) - pull
        return np.asarray(slope), np.asarray(slope)

    def scale(self, radius: Array) -> Array:
        """Pull over the half-width of the zone [Pa]."""
        zone = self.zone(radius)
        return np.asarray(2.0 * self.law.strength * zone.span / zone.outer)

    def pressed(self, depth: float, radius: float) -> PressedSprings:
        """The springs that stand for the contact."""
        return StretchedSprings(self.bed, depth, radius)


def gap_at(line: LineFoundation, a: Array, span: Array) -> tuple[Array, Array]:
    """Return the distance [m] of the surfaces at c beside a contact without attraction, and its slope [-]."""
    c = np.hypot(a, span)
    wide = np.minimum(_arcosh(a, span), FARTHEST)
    if isinstance(line.profile, Paraboloid):
        twice = 2.0 * line.profile.curvature_radius
        return (c * span - a * a * wide) / twice, 2.0 * span / twice
    pieces = max(1, math.ceil(float(np.max(wide)) / PIECE))
    nodes, weights = gauss_legendre(NODES)
    share = (np.arange(pieces)[:, None] + nodes).ravel() / pieces
    v = wide[:, None] * share
    s = c[:, None] / np.cosh(v)
    density = line.load_profile_slope(s) * s * np.tile(weights, pieces) / pieces * wide[:, None]
    apart = 2.0 / math.pi * np.sum(density * v * np.tanh(v), axis=1)
    return apart, 2.0 / math.pi * np.sum(density, axis=1) / c


def _arcosh(a: Array, span: Array) -> Array:
    """Return arcosh(c/a), infinite at a = 0."""
    with np.errstate(divide="ignore"):
        return np.asarray(np.arcsinh(np.divide(span, a, out=np.full(a.shape, np.inf), where=a > 0.0)))


def _pulled(a: Array, span: Array) -> tuple[Array, Array]:
    """Return l arcosh(c/a) - c ln(c/a) [m] and its derivative by c [-]; l > 0."""
    c = np.hypot(a, span)
    ratio = _log_ratio(a, span)
    rest = np.log1p(span / c)  # ln((l + c)/c)
    whole = span * rest - a * a / (span + c) * ratio
    by_c = c / span * rest + a * a / (span * (span + c)) * ratio
    return whole, by_c


def _log_ratio(a: Array, span: Array) -> Array:
    """Return ln(c/a), zero at a = 0."""
    return np.asarray(0.5 * np.log1p(np.divide(span, a, out=np.zeros(a.shape), where=a > 0.0) ** 2))


@functools.lru_cache(maxsize=64)
def _zone(states: CohesiveLineStates, shape: tuple[int, ...], content: bytes) -> LineZone:
    a = np.frombuffer(content).ravel()
    line, law = states.line, states.law
    factor = 4.0 * law.strength / (math.pi * line.medium.modulus)
    # without the profile the zone would be wider: Newton's method comes down from there
    span = np.full(a.shape, law.range / factor)
    while np.any(short := factor * _pulled(a, span)[0] < law.range):
        span = np.where(short, 2.0 * span, span)
    reach = states.bed.reach
    if math.isfinite(reach):
        span = np.minimum(span, np.sqrt(np.maximum((reach - a) * (reach + a), (0.1 * law.range) ** 2)))
    for _ in range(ITERATIONS):
        apart, opening = gap_at(line, a, span)
        whole, by_c = _pulled(a, span)
        c = np.hypot(a, span)
        step = (apart + factor * whole - law.range) / ((opening + factor * by_c) * span / c)
        new = np.maximum(span - step, 0.1 * span)
        moved = float(np.max(np.abs(new - span) / span))
        span = new
        if moved <= STEP_TOLERANCE:
            break
    if moved > WORST_STEP:
        raise NotConverged("Dugdale: the end of the attraction beside the strip is not found; use ShortRange(work).")
    apart, opening = gap_at(line, a, span)
    _, by_c = _pulled(a, span)
    c = np.hypot(a, span)
    growth = 2.0 / math.pi * line.load_profile_slope(a) * np.where(a > 0.0, _arcosh(a, span), 0.0)
    # l l' = c c' - a, put together so that nothing cancels where the attraction ends close to the strip
    whole_slope = c * growth - a * opening + factor * a * _log_ratio(a, span)
    span_slope = whole_slope / ((opening + factor * by_c) * span)
    return LineZone(c.reshape(shape), span.reshape(shape), span_slope.reshape(shape))


@functools.lru_cache(maxsize=64)
def _end(states: CohesiveLineStates) -> float:
    reach = states.bed.reach
    if not math.isfinite(reach):
        return reach
    factor = 4.0 * states.law.strength / (math.pi * states.line.medium.modulus)

    def missing(a: float) -> float:
        if a == reach:
            return -states.law.range
        places, last = np.array([a]), np.array([math.sqrt((reach - a) * (reach + a))])
        apart = float(gap_at(states.line, places, last)[0][0] + factor * _pulled(places, last)[0][0])
        return apart - states.law.range

    if missing(0.0) <= 0.0:
        raise OutsideValidity(
            f"Dugdale: the attraction of {states.law.range:.3g} m reaches beyond the end of the profile ({reach:.6g} "
            "m) even where the bodies only just touch; use ShortRange(work), a greater strength, or a wider profile."
        )
    return between(lambda a: -missing(a), 0.0, reach, relative=1e-13) * (1.0 - 1e-12)
