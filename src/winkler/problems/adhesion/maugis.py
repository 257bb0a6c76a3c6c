r"""Maugis' contact: a constant stress pulls in a ring around the contact, everything in closed form but one integral.

With the ring of a constant stress

.. math:: d = g(a) - A\,s^{1-k}, \qquad
          F = k(a)\,d - \int_0^a k'g\,\mathrm dx - 2AE_s\int_a^c x^k\,(c^2-x^2)^{(1-k)/2}\,\mathrm dx .

It is exact on homogeneous half-spaces and on those graded by a power of the depth; on layers the springs of the ring
follow from an equation of their own (`winkler.problems.adhesion.layered_states`).

The ring in which a constant stress pulls: how wide it is, and what it does to depth and force.

The stress :math:`\sigma_0` acts from the contact radius a to the radius c at which the surfaces are
:math:`w/\sigma_0` apart.  On springs :math:`c_N = E_s x^k` (k = 0: homogeneous) its springs are displaced by

.. math:: u(x) = -A\,(c^2-x^2)^{(1-k)/2}, \qquad A = \frac{2\sigma_0\cos(k\pi/2)}{E_s(1-k)} , \qquad a<x<c ,

so that :math:`d = g(a) - A\,s^{1-k}` with :math:`s^2=c^2-a^2`, and the surfaces stand apart at c by

.. math:: h = \frac{2\cos(k\pi/2)}\pi
              \Big[\int_a^c g'(x)\,J(x)\,\mathrm dx + A\,\big(s^{1-k}J(a) - c^{1-k}M\big)\Big], \quad
          J(x) = \int_x^c\!\frac{t^k\,\mathrm dt}{(c^2-t^2)^{(1+k)/2}}, \quad
          M = \int_{a/c}^1\!\frac{t^k\,\mathrm dt}{(1-t^2)^k} .

Where g rises, h grows with c, and c is unique; elsewhere the first one is meant, before which h is smaller.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings
from winkler.laws.adhesion import Dugdale
from winkler.media.body_of import exponent_of
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.offers import PowerOfDepth, offers
from winkler.numerics.equations.bracketing import between
from winkler.numerics.panels.abel_intervals import root_difference
from winkler.numerics.types import Array
from winkler.problems.adhesion.edge_states import stored_energy
from winkler.problems.adhesion.maugis_integrals import (
    RingSprings,
    Rule,
    edges_of,
    gap_moment,
    moment,
    profile_part,
    pulled,
    turn,
)
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.value import value, words

CLOSEST_HOMOGENEOUS, CLOSEST_OTHERWISE = 16.0, 1e8
"""Closest place to the end of a ring, in units of rounding: on a homogeneous surface, and elsewhere."""


@value
class CohesiveStates:
    """Maugis' states on any profile.

    Parameters
    ----------
    bed : Bed
        On a homogeneous half-space or one graded by a power of the depth.
    law : Dugdale

    Raises
    ------
    OutsideValidity
        If the medium is another one.
    """

    bed: Bed
    law: Dugdale

    def __post_init__(self) -> None:
        medium = self.bed.medium
        if not (isinstance(medium, HomogeneousMedium) or offers(medium, PowerOfDepth)):
            raise OutsideValidity(
                f"Dugdale: a constant stress on a {type(medium).__name__} is not implemented; use "
                "ShortRange(work), or a HalfSpace, GradedHalfSpace, CoatedHalfSpace, SlidingFilm or "
                "DepthGradedHalfSpace."
            )
        if offers(medium, PowerOfDepth) and medium.exponent >= 1.0:
            raise OutsideValidity(
                "Dugdale: Gibson's solid (exponent 1) deflects only where it is loaded, so a ring of stress "
                "cannot hold the edge; use ShortRange(work), or an exponent below 1."
            )

    def end(self) -> float:
        """The radius whose ring ends where the profile does [m]."""
        return _end(self)

    def from_nothing(self) -> bool:
        """A point is held by the stress around it."""
        return True

    def springs(self) -> RingSprings:
        """What the zone needs of the bed."""
        return _springs(self.bed)

    def zone(self, radius: Array) -> CohesiveZone:
        """Return the rings around contacts of given radii."""
        radius = np.asarray(radius, dtype=float)
        return _zone(self, radius.shape, radius.tobytes())

    def _stretch(self, span: Array) -> Array:
        springs = self.springs()
        return np.asarray(springs.amplitude(self.law.strength) * span ** (1.0 - springs.exponent))

    def depth(self, radius: Array) -> Array:
        """d(a) [m]."""
        return np.asarray(self.bed.gap(radius) - self._stretch(self.zone(radius).span))

    def load(self, radius: Array) -> Array:
        """What the profile and the ring take from k d [N]."""
        solved, springs = self.zone(radius), self.springs()
        ring = 2.0 * springs.amplitude(self.law.strength) * springs.surface_modulus
        return np.asarray(self.bed.gap_load(radius) + ring * pulled(solved.outer, solved.span, springs.exponent))

    def slopes(self, radius: Array) -> tuple[Array, Array]:
        """d'(a) and F'(a)."""
        solved, springs, strength = self.zone(radius), self.springs(), self.law.strength
        k = springs.exponent
        stress = springs.amplitude(strength) * (1.0 - k)
        depth = self.bed.gap_slope(radius) - stress * solved.span ** (-k) * solved.span_slope
        pull = 4.0 * strength * springs.cosine() * solved.outer * solved.turn * solved.outer_slope
        return depth, self.bed.stiffness(radius) * depth - pull

    def energy(self, radius: Array) -> Array:
        r"""What springs and surfaces store, zero apart [J]: on homogeneous half-spaces.

        .. math:: E = E^*\!\int_0^a (d-g)^2\,\mathrm dx + 4\sigma_0\!\int_a^c (g-d)\sqrt{c^2-x^2}\,\mathrm dx
                      - 2\sigma_0 A\!\int_a^c (c^2-x^2)\,\mathrm dx - \pi w c^2
        """
        solved, springs, strength = self.zone(radius), self.springs(), self.law.strength
        s, c, stretch = solved.span, solved.outer, self._stretch(solved.span)
        inner = stored_energy(self.bed, self.bed.gap(radius) - stretch, radius)
        gaps = gap_moment(springs, radius, s) + stretch * pulled(c, s, 0.0)
        squares = s**4 * (2.0 * c + radius) / (3.0 * (c + radius) ** 2)
        ring = 4.0 * strength * gaps - 2.0 * strength * springs.amplitude(strength) * squares
        return np.asarray(inner + ring - math.pi * self.law.work * c**2)

    def scale(self, radius: Array) -> Array:
        """Stretch over the radius of the zone."""
        solved = self.zone(radius)
        return self._stretch(solved.span) / solved.outer

    def pressed(self, depth: float, radius: float) -> RingedSprings:
        """The springs out to the end of the ring."""
        outer = float(self.zone(np.array([radius])).outer[0])
        amplitude = self.springs().amplitude(self.law.strength)
        sharpest = CLOSEST_HOMOGENEOUS if exponent_of(self.bed.medium) == 0.0 else CLOSEST_OTHERWISE
        return _ringed(self.bed, depth, radius, outer, amplitude, sharpest)


def _ringed(bed: Bed, depth: float, contact: float, outer: float, amplitude: float, sharpest: float) -> RingedSprings:
    """Return the springs of a contact with a ring, resolved down to some units of rounding."""
    k = exponent_of(bed.medium)
    width, least = outer - contact, sharpest * np.finfo(float).eps * outer
    halvings = max(0, math.floor(math.log2(max(width / least, 1.0))))
    # what is left of the ring is a jump at its centre of gravity
    jump = outer - (1.0 - k) / (3.0 - k) * width * 0.5**halvings if halvings else contact
    return RingedSprings(bed, depth, jump, contact, outer, amplitude, k, halvings)


@functools.lru_cache(maxsize=64)
def _springs(bed: Bed) -> RingSprings:
    modulus = float(bed.normal_stiffness(np.array([1.0]))[0])  # c_N = E_s x^k at x = 1 m
    end = min(bed.reach, bed.rim)
    return RingSprings(bed.gap_slope, edges_of(bed.kinks, end), bed.rising, modulus, exponent_of(bed.medium), end)


@functools.lru_cache(maxsize=64)
def _end(states: CohesiveStates) -> float:
    springs = states.springs()
    if not math.isfinite(springs.end):
        return springs.end
    solved = widest_within(springs, states.law.strength, states.law.range)
    if solved <= 0.0:
        raise no_zone(states.law, springs.end)
    return solved


def no_zone(law: Dugdale, end: float) -> OutsideValidity:
    """Return the refusal of a profile that ends at `end` [m], within the reach of the attraction."""
    return OutsideValidity(
        f"Dugdale: the attraction of {law.range:.3g} m reaches beyond the end of the profile ({end:.6g} m) even where "
        "the bodies only just touch; use ShortRange(work), a greater strength, or a wider profile."
    )


def beyond_profile(bed: Bed, radius: float) -> OutsideValidity:
    """Return the refusal of a contact [m] whose ring would pass the end of the profile."""
    end = "rim" if bed.rim <= bed.reach else "reach"
    return OutsideValidity(
        f"Dugdale: around a contact of {radius:.6g} m the surfaces attract each other beyond the {end} of the profile "
        f"({min(bed.rim, bed.reach):.6g} m); use ShortRange(work), a greater strength, or a wider profile."
    )


@functools.lru_cache(maxsize=64)
def _zone(states: CohesiveStates, shape: tuple[int, ...], content: bytes) -> CohesiveZone:
    radius = np.frombuffer(content).reshape(shape)

    def refuse(beyond: Array) -> None:
        if beyond.any():
            raise beyond_profile(states.bed, float(radius.ravel()[beyond][0]))

    solved = zone(states.springs(), states.law.strength, states.law.range, radius.ravel(), refuse)
    return CohesiveZone(*(part.reshape(shape) for part in solved))


@value
class RingedSprings(PressedSprings):
    """Springs compressed up to the contact radius and pulled in the ring around it.

    Parameters
    ----------
    bed : Bed
    depth : float
        d [m].
    radius : float
        Where the last of the springs' displacement, too near to the end of the ring to be resolved, is a jump [m].
    contact_radius : float
        a [m]: up to there the surfaces touch.
    outer_radius : float
        c [m], the end of the ring.
    amplitude : float
        u = -amplitude (c^2 - x^2)^((1-k)/2) in the ring [m^k].
    exponent : float
        k [-] of the grading.
    count : int
        How often the panels halve towards the end of the ring, where the slope of u is infinite.
    """

    __words__ = words(
        amplitude=("A", "", "displacement of the ring's springs, u = -A (c^2 - x^2)^((1-k)/2)"),
        exponent=("k", "", "exponent of the grading"),
    )

    contact_radius: float
    outer_radius: float
    amplitude: float
    exponent: float
    count: int

    @property
    def touching(self) -> float:
        """a [m]."""
        return self.contact_radius

    @property
    def blunted(self) -> RingedSprings:
        """The same with fewer places."""
        return _ringed(self.bed, self.depth, self.contact_radius, self.outer_radius, self.amplitude, CLOSEST_OTHERWISE)

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Those of the profile, the contact radius, and places that crowd towards the end of the ring."""
        a, width = self.contact_radius, self.outer_radius - self.contact_radius
        own = [(b, strength) for b, strength in self.bed.kinks if b < a]
        crowd = [(self.outer_radius - width * 0.5**j, 0.0) for j in range(1, self.count + 1)]
        return (*own, *([(a, 0.0)] if a > 0.0 and self.count > 0 else []), *crowd)

    @property
    def edge(self) -> float:
        """The jump: all but zero, unless the whole ring is too narrow to be resolved."""
        place = np.array([self.radius])
        return float(self._ring(place)[0] if self.count > 0 else self.value(place)[0])

    @property
    def _last(self) -> float:
        return self.outer_radius - (self.outer_radius - self.contact_radius) * 0.5**self.count

    def _ring(self, x: Array) -> Array:
        place = np.minimum(x, self._last)
        rest = (self.outer_radius - place) * (self.outer_radius + place)
        return np.asarray(-self.amplitude * rest ** (0.5 * (1.0 - self.exponent)))

    def value(self, x: Array) -> Array:
        """u(x) [m]; beyond the last place it is chosen so that the surface at the end of the ring is where it is."""
        x, k = np.asarray(x, dtype=float), self.exponent
        inside = x <= self.contact_radius
        # of z = c - x the kernel there leaves z^-(1+k)/2, u has z^(1-k)/2, and the jump is at (1-k)/(3-k) of the rest
        share = 0.5 / (1.0 - ((1.0 - k) / (3.0 - k)) ** (0.5 * (1.0 - k)))
        ring = self._ring(x) * np.where(x > self._last, share, 1.0)
        return np.where(inside, self.depth - self.bed.gap(np.where(inside, x, 0.0)), ring)

    def slope(self, x: Array) -> Array:
        """u'(x) [-]."""
        x = np.asarray(x, dtype=float)
        inside = x <= self.contact_radius
        ring = np.where(x <= self._last, self._ring_slope(x), 0.0)
        return np.where(inside, -self.bed.gap_slope(np.where(inside, x, 0.0)), ring)

    def _ring_slope(self, x: Array) -> Array:
        k, place = self.exponent, np.minimum(x, self._last)
        rest = (self.outer_radius - place) * (self.outer_radius + place)
        return np.asarray(self.amplitude * (1.0 - k) * x * rest ** (-0.5 * (1.0 + k)))


SMOOTH_RULES: tuple[Rule, ...] = (("gauss", 8), ("gauss", 16), ("gauss", 32), ("gauss", 64))
"""Rules for what is smooth in the angle between the kinks."""
ROUGH_RULES: tuple[Rule, ...] = (("double", 81), ("double", 161), ("double", 321))
STEP_TOLERANCE = 1e-12
ROUNDING_STEP = 1e-9
ROUNDING_RATIO = 0.1
"""What moves by more than this part of the move before, and by less than `ROUNDING_STEP`, moves by rounding."""
SCAN_STEPS = 64
"""Steps in which the first c is sought where g does not rise."""
ITERATIONS = 100
NEWTON_LAST_STEP = 1e-7
"""A step of Newton's method so small, relative to s, is the last one but that with the finer rule."""
LEAST_INTERPOLATED, GUESS_STRIDE = 40, 8
"""Of so many contacts every eighth gives the others their first guess."""


class CohesiveZone(NamedTuple):
    """A ring of cohesion: s = sqrt(c^2 - a^2) and c [m], and what their slopes are made from.

    `span_slope` is s'(a), `outer_slope` c'(a), `turn` J(a).
    """

    span: Array
    outer: Array
    span_slope: Array
    outer_slope: Array
    turn: Array


class _CohesiveRing(NamedTuple):
    """Of what the zones of one bed and law are made."""

    springs: RingSprings
    amplitude: float
    distance: float

    @property
    def rules(self) -> tuple[Rule, ...]:
        """Those to be tried, one after the other."""
        return (*SMOOTH_RULES, *ROUGH_RULES) if self.springs.exponent == 0.0 else ROUGH_RULES

    def apart(self, radius: Array, span: Array, rule: Rule) -> tuple[Array, Array, Array]:
        """Return by which part the surfaces at the end are too far apart [-], and slopes.

        They are the derivative of that by log s at fixed a, and that of the profile's part by c [-].
        """
        k = self.springs.exponent
        outer = np.hypot(radius, span)
        share = np.minimum((span / outer) ** 2, 1.0)
        turn_value, moved = turn(share, k), moment(share, k)
        part, by_outer = profile_part(self.springs, radius, span, rule)
        stress = self.amplitude * (1.0 - k)
        whole = part + self.amplitude * (span ** (1.0 - k) * turn_value - outer ** (1.0 - k) * moved)
        by_span = (span / outer) * (
            by_outer + stress * (outer * turn_value * span ** (-1.0 - k) - moved * outer ** (-k))
        )
        factor = 2.0 * self.springs.cosine() / (math.pi * self.distance)
        return factor * whole - 1.0, factor * by_span * span, by_outer


def _ring(springs: RingSprings, strength: float, distance: float) -> _CohesiveRing:
    return _CohesiveRing(springs, springs.amplitude(strength), distance)


def zone(
    springs: RingSprings, strength: float, distance: float, radius: Array, refuse: Callable[[Array], None]
) -> CohesiveZone:
    """Return the zones around contacts of given radii `(m,)`.

    Parameters
    ----------
    springs : Springs
    strength : float
        The stress sigma_0 [Pa].
    distance : float
        How far it reaches, work / strength [m].
    radius : ndarray, (m,)
        [m], zero or positive.
    refuse
        Called with a mask of contacts whose zone would pass the end of the profile; must raise.

    Raises
    ------
    NotConverged
        If the profile is not smooth between its kinks.
    """
    ring = _ring(springs, strength, distance)
    span, by_outer = _guess(ring, radius, refuse), np.zeros(radius.shape)
    waiting, before = np.arange(radius.size), np.full(radius.shape, math.inf)
    for rule, finer in pairwise(ring.rules):
        part = radius[waiting]
        roots = _span(ring, part, span[waiting], rule, refuse)
        excess, slope, by_outer[waiting] = ring.apart(part, roots, finer)
        moved = np.abs(excess)
        small = moved <= ROUNDING_STEP
        correction = np.where(small & (slope > 0.0), excess / np.where(slope > 0.0, slope, 1.0), 0.0)
        span[waiting] = roots * (1.0 - np.clip(correction, -ROUNDING_STEP, ROUNDING_STEP))
        done = (moved <= STEP_TOLERANCE) | (small & (moved > ROUNDING_RATIO * before))
        waiting, before = waiting[~done], moved[~done]
        if not waiting.size:
            break
    if np.any(before > ROUNDING_STEP):
        raise NotConverged(
            f"The cohesive zone still moves by {np.max(before):.1e} on refinement: the profile is not smooth "
            "between its stated kinks; state them, or give the shape as measured points."
        )
    return _with_slopes(ring, radius, span, by_outer)


def _guess(ring: _CohesiveRing, radius: Array, refuse: Callable[[Array], None]) -> Array:
    """Return a first guess of s: of many contacts some are solved for, and the others lie between."""
    alone = (ring.distance / ring.amplitude) ** (1.0 / (1.0 - ring.springs.exponent))

    def rough(radius: Array) -> Array:
        # narrow zones obey Griffith, A s^(1-k) = l; wide ones are at most as wide as the stress alone would make them
        return np.asarray(np.where(radius > alone, np.sqrt(alone * radius), alone))

    if radius.size < LEAST_INTERPOLATED:
        return rough(radius)
    ordered = np.unique(radius)
    some = np.unique(np.append(ordered[::GUESS_STRIDE], ordered[-1]))

    def refuse_all(beyond: Array) -> None:
        refuse(np.isin(radius, some[beyond]))

    guessed = _span(ring, some, rough(some), ring.rules[0], refuse_all)
    return np.asarray(np.exp(np.interp(radius, some, np.log(guessed))))


def _span(ring: _CohesiveRing, radius: Array, guess: Array, rule: Rule, refuse: Callable[[Array], None]) -> Array:
    """Return s = sqrt(c^2 - a^2), by Newton's method in logarithms inside a bracket that only shrinks."""
    springs = ring.springs
    farthest = root_difference(np.full(radius.shape, min(springs.end, 1e150)), radius)
    span = np.minimum(guess, farthest)
    low, high = np.zeros(radius.shape), np.full(radius.shape, math.inf)
    left = np.arange(radius.size)
    for _ in range(ITERATIONS):
        here = span[left]
        excess, slope, _ = ring.apart(radius[left], here, rule)
        short = excess < 0.0
        if np.any(short & (here >= farthest[left])):
            beyond = np.zeros(radius.shape, dtype=bool)
            beyond[left] = short & (here >= farthest[left])
            refuse(beyond)
        low[left], high[left] = np.where(short, here, low[left]), np.where(short, high[left], here)
        usable = (excess > -1.0) & (excess < np.inf) & (slope > 0.0) & (slope < np.inf)
        excess = np.where(usable, excess, 0.0)
        power = np.log1p(excess) * (1.0 + excess) / np.where(usable, slope, 1.0)
        new = here * np.exp(-np.clip(power, -4.0, 4.0))
        settled = usable & (np.abs(power) <= NEWTON_LAST_STEP)
        inside = usable & (new > low[left]) & (new < high[left])
        middle = np.where(
            np.isinf(high[left]),
            2.0 * here,
            np.where(low[left] > 0.0, np.sqrt(low[left]) * np.sqrt(high[left]), 0.5 * here),
        )
        span[left] = np.minimum(np.where(inside, new, np.where(settled, here, middle)), farthest[left])
        closed = high[left] <= low[left] * (1.0 + 4e-16)
        left = left[~(settled | closed)]
        if not left.size:
            break
    return span if springs.rising else _first_crossing(ring, radius, span, rule)


def widest_within(springs: RingSprings, strength: float, distance: float) -> float:
    """Return the contact radius whose ring ends with the profile [m]; zero if no ring is so narrow."""
    ring, end = _ring(springs, strength, distance), (1.0 - 1e-12) * springs.end

    def excess(radius: Array, _: Array) -> Array:
        return ring.apart(radius, root_difference(np.full(radius.shape, end), radius), ROUGH_RULES[-2])[0]

    low, high = np.zeros(1), np.array([end * (1.0 - 1e-12)])
    if excess(low, low)[0] <= 0.0:
        return 0.0
    return float(between(excess, low, high)[0]) * (1.0 - 1e-9) if excess(high, high)[0] < 0.0 else float(high[0])


def _first_crossing(ring: _CohesiveRing, radius: Array, span: Array, rule: Rule) -> Array:
    """Return the first opening where g falls somewhere in the zone; elsewhere there is but one."""
    springs = ring.springs

    def excess(span: Array, index: Array) -> Array:
        return ring.apart(radius[index], span, rule)[0]

    shares = np.linspace(0.0, 1.0, SCAN_STEPS + 1)
    places = np.minimum(np.hypot(radius[:, None], span[:, None] * shares), np.nextafter(springs.end, 0.0))
    (falling,) = np.nonzero(np.any(springs.gap_slope(places) < 0.0, axis=1))
    result = span.copy()
    for before, share in pairwise(shares[1:-1]):
        if not falling.size:
            break
        wide = excess(share * span[falling], falling) >= 0.0
        roots = falling[wide]
        if roots.size:

            def of_roots(s: Array, index: Array, roots: Array = roots) -> Array:
                return excess(s, roots[index])

            low = np.where(excess(before * span[roots], roots) < 0.0, before, 1e-3 * before) * span[roots]
            result[roots] = between(of_roots, low, share * span[roots])
        falling = falling[~wide]
    return result


def _with_slopes(ring: _CohesiveRing, radius: Array, span: Array, by_outer: Array) -> CohesiveZone:
    """Differentiate h(a, s) = distance: terms that nearly cancel in narrow zones have been cancelled analytically."""
    k = ring.springs.exponent
    outer = np.hypot(radius, span)
    share = np.minimum((span / outer) ** 2, 1.0)
    turn_value = turn(share, k)
    stress = ring.amplitude * (1.0 - k)
    own = stress * moment(share, k) * outer ** (-k)
    by_radius = (by_outer * radius - own * radius) / outer - turn_value * ring.springs.gap_slope(radius)
    by_span = (span / outer) * (by_outer + stress * outer * turn_value * span ** (-1.0 - k) - own)
    span_slope = -by_radius / by_span
    return CohesiveZone(span, outer, span_slope, (radius + span * span_slope) / outer, turn_value)
