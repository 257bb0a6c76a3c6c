r"""Maugis' contact: a constant stress pulls in a ring around the contact, everything in closed form but one integral.

With the ring of `winkler.problems.adhesion.maugis_zone`

.. math:: d = g(a) - A\,s^{1-k}, \qquad
          F = k(a)\,d - \int_0^a k'g\,\mathrm dx - 2AE_s\int_a^c x^k\,(c^2-x^2)^{(1-k)/2}\,\mathrm dx .

It is exact on homogeneous half-spaces and on those graded by a power of the depth; on layers the springs of the ring
follow from an equation of their own (`winkler.problems.adhesion.layered_zone`).
"""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings
from winkler.laws.adhesion import Dugdale
from winkler.media.body_of import exponent_of
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.offers import PowerOfDepth, offers
from winkler.numerics.types import Array
from winkler.problems.adhesion.edge_states import stored_energy
from winkler.problems.adhesion.maugis_integrals import RingSprings, edges_of, gap_moment, pulled
from winkler.problems.adhesion.maugis_zone import CohesiveZone, widest_within, zone
from winkler.values.errors import OutsideValidity
from winkler.values.value import value, words

__all__ = ["CLOSEST_OTHERWISE", "CohesiveStates", "RingedSprings", "beyond_profile", "no_zone"]

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
                f"Dugdale: what a constant stress does to a {type(medium).__name__} is not known; use "
                "ShortRange(work), or a HalfSpace, GradedHalfSpace, CoatedHalfSpace, SlidingFilm or "
                "DepthGradedHalfSpace."
            )
        if offers(medium, PowerOfDepth) and medium.exponent >= 1.0:
            raise OutsideValidity(
                "Dugdale: Gibson's solid (exponent 1) sinks only where it is pressed, so that a ring of stress cannot "
                "hold the edge; use ShortRange(work), or an exponent below 1."
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
