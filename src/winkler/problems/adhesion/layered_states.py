r"""The states of a contact on layers around which a constant stress pulls, and the disc of stress before they touch.

How wide the ring of a constant stress is on layers, and what follows for depth and force.

With the ring of `winkler.problems.adhesion.layered_ring`, :math:`A = 2\sigma_0/E^*`,

.. math:: d = g(a) - A\,\frac{m(a)}{\varphi(a;a)} , \qquad
          F = k(a)\,d - \int_0^a k'g\,\mathrm dx - 4\sigma_0\int_a^c\varphi\,m\,\mathrm dx ,

and the surfaces stand apart at c by the work of adhesion over the stress,

.. math:: \frac w{\sigma_0} = \frac2\pi\Big[\int_a^c g'J\,\mathrm dx
              + A\Big(\frac{m(a)}{\varphi(a;a)}\,J(a) - \int_a^c m\,e\,\mathrm dx\Big)\Big] .

Stretch and pull are tabulated over the radius, for their slopes and because a search asks for hundreds of radii.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.foundation import Foundation
from winkler.laws.adhesion import Dugdale
from winkler.media.offers import PressedWaves, offers
from winkler.numerics.caching import cached_by_value
from winkler.numerics.equations.bracketing import between
from winkler.numerics.equations.roots import rough_root
from winkler.numerics.panels.abel_intervals import root_difference
from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.panels.sqrt_panels import RootPanels, fit
from winkler.numerics.transforms import abel
from winkler.numerics.transforms.cosine_transform import WaveResponse
from winkler.numerics.types import Array
from winkler.problems.adhesion.edge_states import stored_energy
from winkler.problems.adhesion.layered_ring import LayeredRing, layered_ring, read
from winkler.problems.adhesion.maugis import CLOSEST_OTHERWISE, RingedSprings, beyond_profile, no_zone
from winkler.problems.adhesion.maugis_integrals import RingSprings, Rule, edges_of, profile_moment
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.value import value, words

SHARE_TOLERANCE = 1e-12
ENERGY_RULE = ("double", 161)
TABLE_TOLERANCE = 1e-12
LOWEST_OCTAVE = -3
"""All narrower contacts, in radii of the disc at first touch, are in one table."""
VERTICAL_SHARE = 0.97
"""Up to this part of the radius of a body whose flank ends vertical rings are followed."""
LEAST_DISC = 1e-12
"""Radius of the narrowest disc of stress, in parts of that at first touch."""


@value
class LayeredStates:
    """States under a constant stress, on layers.

    Parameters
    ----------
    bed : Bed
        On bonded layers, a film that slides, or a body graded in depth.
    law : Dugdale
    """

    bed: Bed
    law: Dugdale

    def end(self) -> float:
        """The radius whose ring ends where the profile does [m]."""
        return _end(self)

    def from_nothing(self) -> bool:
        """A point is held by the stress around it."""
        return True

    def zones(self) -> RingOnLayers:
        """What the zone needs of the bed and the law."""
        return _zones(self)

    def zone(self, radius: Array) -> LayeredZone:
        """Return the rings around contacts of given radii `(m,)`."""
        return _zone(self, np.asarray(radius, dtype=float).tobytes())

    def tabled(self, radius: Array) -> Array:
        """Return s, stretch over A and pull of any radii ``(3, *radius.shape)`` [m], [m], [m^2]."""
        return _read(self, radius, False)

    def depth(self, radius: Array) -> Array:
        """d(a) [m]."""
        return np.asarray(self.bed.gap(radius) - self.zones().amplitude * self.tabled(radius)[1])

    def load(self, radius: Array) -> Array:
        """What the profile and the ring take from k d [N]."""
        return np.asarray(self.bed.gap_load(radius) + 4.0 * self.law.strength * self.tabled(radius)[2])

    def slopes(self, radius: Array) -> tuple[Array, Array]:
        """d'(a) and F'(a)."""
        amplitude = self.zones().amplitude
        _, stretch, pull = _read(self, radius, True)
        depth = self.bed.gap_slope(radius) - amplitude * stretch
        lost = 2.0 * self.bed.normal_stiffness(radius) * amplitude * self.tabled(radius)[1]
        return depth, self.bed.stiffness(radius) * depth - lost - 4.0 * self.law.strength * pull

    def energy(self, radius: Array) -> Array:
        r"""What springs and surfaces store, zero apart [J].

        .. math:: E = \frac12\int_0^a k'(d-g)^2\,\mathrm dx + 4\sigma_0\!\int_a^c \varphi m\,(g-d)\,\mathrm dx
                      - 2\sigma_0 A\!\int_a^c m^2\,\mathrm dx - \pi w c^2
        """
        flat, zones, strength = np.asarray(radius, dtype=float).ravel(), self.zones(), self.law.strength
        solved = self.zone(flat)
        ring = solved.ring
        stretch = zones.amplitude * ring.stretch
        inner = stored_energy(self.bed, self.bed.gap(flat) - stretch, flat)
        gaps = zones.profile(flat, solved.span, ENERGY_RULE, ring.pull_beyond) + stretch * ring.pull
        outer = 4.0 * strength * gaps - 2.0 * strength * zones.amplitude * ring.squares
        return np.asarray(inner + outer - math.pi * self.law.work * solved.outer**2).reshape(np.shape(radius))

    def touch(self) -> float:
        """The radius of the disc of stress at first touch [m]."""
        return float(self.zone(np.zeros(1)).outer[0])

    def disc(self, c: Array) -> LayeredRing:
        """Return rings without a contact, of outer radii c `(m,)` [m], as finely divided as that of the first touch."""
        first = self.zone(np.zeros(1))
        radii = np.maximum(c, LEAST_DISC * first.outer)
        return layered_ring(self.zones().response, np.zeros(radii.shape), radii, RULES[int(first.level[0])][0])

    def scale(self, radius: Array) -> Array:
        """Stretch over the radius of the zone."""
        span, stretch, _ = self.tabled(radius)
        return np.asarray(self.zones().amplitude * stretch / np.hypot(radius, span))

    def pressed(self, depth: float, radius: float) -> RingedLayers:
        """The springs out to the end of the ring."""
        solved, zones = self.zone(np.array([radius])), self.zones()
        outer, span = float(solved.outer[0]), float(solved.span[0])
        width = outer - radius

        def share(x: Array) -> Array:
            angle = np.arctan2(np.sqrt(np.maximum((outer - x) * (outer + x), 0.0)), x) / math.atan2(span, radius)
            return read(zones.response, solved.ring.share, np.minimum(angle, 1.0).reshape(1, -1)).reshape(x.shape)

        if width <= CLOSEST_OTHERWISE * np.finfo(float).eps * outer:
            raise OutsideValidity(
                f"Dugdale: the ring of attraction around the contact of {radius:.3g} m is only {width:.1e} m wide, too "
                "narrow for fields on layers; use ShortRange(work), which is its limit."
            )
        shares = fit_panels(share, np.array([radius, outer]), SHARE_TOLERANCE)
        halvings = math.floor(math.log2(width / (CLOSEST_OTHERWISE * np.finfo(float).eps * outer)))
        jump = outer - width * 0.5**halvings / 3.0 if halvings else radius
        return RingedLayers(self.bed, depth, jump, radius, outer, zones.amplitude, 0.0, halvings, shares)


@value
class RingedLayers(RingedSprings):
    """`RingedSprings` on layers, where u in the ring is not quite -A sqrt(c^2 - x^2).

    Parameters
    ----------
    shares : Panels
        u over that, from the contact radius to the end of the ring.
    """

    __words__ = words(
        **RingedSprings.__words__,
        shares=("", None, "displacement of the ring's springs over that of equal ones on a half-space"),
    )

    shares: Panels

    @property
    def blunted(self) -> RingedLayers:
        """The same."""
        return self

    def _ring(self, x: Array) -> Array:
        return np.asarray(super()._ring(x) * self.shares(np.minimum(x, self._last)))

    def _ring_slope(self, x: Array) -> Array:
        place = np.minimum(x, self._last)
        return np.asarray(
            super()._ring_slope(x) * self.shares(place) + super()._ring(x) * self.shares.derivative(place)
        )


class DiscOnLayers(NamedTuple):
    """The constant stress over a disc, as long as the middle does not touch; as `DiscOfStress`, on layers."""

    states: LayeredStates
    touch: float

    def extent(self) -> float:
        """The radius of the disc when its middle touches [m]."""
        return self.touch

    def depth(self, place: Array) -> Array:
        """d [m]."""
        place = np.asarray(place, dtype=float)
        c = np.maximum(place + self.touch, 0.0)
        law = self.states.law
        risen = 2.0 / math.pi * self.states.zones().amplitude * self.states.disc(c.ravel()).raised.reshape(c.shape)
        return np.asarray(self.states.bed.height(c) - risen - law.range)

    def force(self, place: Array) -> Array:
        """F [N]."""
        return -math.pi * self.states.law.strength * (np.asarray(place) + self.touch) ** 2

    def energy(self, force: Array) -> Array:
        """The integral of F dd from apart on [J]."""
        force = np.asarray(force, dtype=float)
        bed, strength, amplitude = self.states.bed, self.states.law.strength, self.states.zones().amplitude
        c = np.sqrt(np.maximum(-force, 0.0) / (math.pi * strength)).ravel()
        ring = self.states.disc(c)
        moment = abel.integral(lambda r: bed.height(r) * r, [b for b, _ in bed.kinks], c)
        lowered = 2.0 * moment - (bed.height(c) - 2.0 / math.pi * amplitude * ring.raised) * c**2
        whole = math.pi * strength * lowered - 2.0 * strength * amplitude * ring.squares
        return np.asarray(whole.reshape(force.shape))


@functools.lru_cache(maxsize=64)
def _zones(states: LayeredStates) -> RingOnLayers:
    bed, medium, law = states.bed, states.bed.medium, states.law
    assert offers(medium, PressedWaves)
    end = min(bed.reach, bed.rim)
    if math.isfinite(end) and not math.isfinite(float(bed.slope(np.array([end]))[0])):
        end *= VERTICAL_SHARE
    springs = RingSprings(bed.gap_slope, edges_of(bed.kinks, end), bed.rising, medium.modulus, 0.0, end)
    widest = rough_root(bed.height, law.range) if isinstance(bed, Foundation) and not math.isfinite(end) else end
    return RingOnLayers(springs, medium.response, springs.amplitude(law.strength), law.range, widest)


@functools.lru_cache(maxsize=64)
def _end(states: LayeredStates) -> float:
    zones = states.zones()
    if not math.isfinite(zones.springs.end):
        return zones.springs.end
    solved = widest_on_layers(zones)
    if solved <= 0.0:
        raise no_zone(states.law, zones.springs.end)
    return solved


@functools.lru_cache(maxsize=64)
def _zone(states: LayeredStates, content: bytes) -> LayeredZone:
    radius = np.frombuffer(content)

    def refuse(beyond: Array) -> None:
        if beyond.any():
            raise beyond_profile(states.bed, float(radius[beyond][0]))

    return layered_zone(states.zones(), radius, refuse)


def _read(states: LayeredStates, radius: Array, slopes: bool) -> Array:
    """Return what is tabulated over the radius, or its slopes."""
    radius = np.asarray(radius, dtype=float)
    flat, first = radius.ravel(), states.touch()
    beyond = flat > states.end()
    if beyond.any():
        raise beyond_profile(states.bed, float(flat[beyond][0]))
    result = np.empty((3, flat.size))
    octaves = np.maximum(np.ceil(np.log2(np.maximum(flat, 1e-300) / first)), LOWEST_OCTAVE).astype(int)
    for octave in np.unique(octaves):
        own = octaves == octave
        table = _octave(states, int(octave))
        result[:, own] = table.slope(flat[own]) if slopes else table(flat[own])
    return result.reshape(3, *radius.shape)


@cached_by_value(512)
def _octave(states: LayeredStates, octave: int) -> RootPanels:
    high = min(states.touch() * 2.0**octave, states.end())
    low = 0.0 if octave == LOWEST_OCTAVE else 0.5 * states.touch() * 2.0**octave
    kinks = np.array([b for b, _ in states.bed.kinks if b < high])

    def rows(radius: Array) -> Array:
        solved = states.zone(radius)
        return np.array([solved.span, solved.ring.stretch, solved.ring.pull])

    def tolerances(values: Array) -> Array:
        return np.asarray(max(TABLE_TOLERANCE, states.zones().response.precision) * np.max(np.abs(values), axis=1))

    return fit(rows, np.unique(np.concatenate([[low, high], kinks[kinks > low]])), kinks, tolerances)


RULES: tuple[tuple[int, Rule], ...] = (
    (10, ("gauss", 10)),
    (16, ("gauss", 16)),
    (24, ("gauss", 32)),
    (36, ("gauss", 64)),
    (54, ("double", 161)),
    (80, ("double", 321)),
    (120, ("double", 321)),
)
"""Angles of the ring, and the rule of the profile between its kinks."""
SETTLED = 1e-9
"""Greatest change of the opening on refinement at which the zone, corrected by it, is settled: errors fall faster."""
LAST_STEP = 1e-7
"""A step of the secant method in log s so small is the last one with that rule."""
NEARLY = 0.1
"""Part by which openings may change on refinement for the search for s to begin with the coarser rule."""
ITERATIONS = 100


class RingOnLayers(NamedTuple):
    """Of what the zones of one bed and law are made: springs, response, A = 2 sigma_0 / E* and w / sigma_0 [m].

    `widest_guess` [m] is where a stiff body that just touches is w / sigma_0 away: searches for s do not begin beyond.
    """

    springs: RingSprings
    response: WaveResponse
    amplitude: float
    distance: float
    widest_guess: float

    def profile(self, radius: Array, span: Array, rule: Rule, series: Array) -> Array:
        """Return the integral of g' over the zone, times a series ``(m, n)`` of the angle."""
        whole = np.arctan2(span, radius)

        def weight(owner: Array, x: Array, rest: Array) -> Array:
            return read(self.response, series[owner], np.minimum(np.arctan2(rest, x) / whole[owner, None], 1.0))

        return profile_moment(self.springs, radius, span, rule, weight)

    def apart(self, radius: Array, span: Array, level: int) -> tuple[Array, LayeredRing]:
        """Return by which part the surfaces at the end are too far apart [-], and the rings."""
        count, rule = RULES[level]
        ring = layered_ring(self.response, radius, span, count)
        lag = read(self.response, ring.lagging, np.ones((radius.size, 1)))[:, 0]
        opened = self.profile(radius, span, rule, ring.lagging) + self.amplitude * (ring.stretch * lag - ring.raised)
        return 2.0 / (math.pi * self.distance) * opened - 1.0, ring


class LayeredZone(NamedTuple):
    """Solved zones `(m,)`: s and c [m], the rings, and which of `RULES` each of them needs."""

    span: Array
    outer: Array
    ring: LayeredRing
    level: Array


def layered_zone(zones: RingOnLayers, radius: Array, refuse: Callable[[Array], None]) -> LayeredZone:
    """Return the zones around contacts of given radii `(m,)`.

    Parameters
    ----------
    zones : RingOnLayers
    radius : ndarray, (m,)
        [m], zero or positive.
    refuse
        Called with a mask of contacts whose zone would pass the end of the profile; must raise.

    Raises
    ------
    NotConverged
        If a ring is too wide against the layers, or the profile not smooth between its kinks.
    """
    alone = zones.distance / zones.amplitude
    guess = np.minimum(np.where(radius > alone, np.sqrt(alone * radius), alone), zones.widest_guess)
    coarsest = _coarsest(zones, radius, guess)
    span, power = _span(zones, radius, guess, coarsest, refuse)
    waiting, before = np.arange(radius.size), np.full(radius.shape, math.inf)
    parts: list[tuple[Array, LayeredRing]] = []
    level_of = np.zeros(radius.shape, dtype=int)
    for level in range(coarsest + 1, len(RULES)):
        excess = zones.apart(radius[waiting], span[waiting], level)[0]
        span[waiting] *= np.exp(-np.log1p(np.clip(excess, -0.5, 1.0)) / power[waiting])
        moved = np.abs(excess)
        done = moved <= max(SETTLED, zones.response.precision)
        if done.any():
            settled = waiting[done]
            parts.append((settled, zones.apart(radius[settled], span[settled], level)[1]))
            level_of[settled] = level
        before[waiting] = moved
        waiting = waiting[~done]
        if not waiting.size:
            break
    if waiting.size:
        worst = waiting[0]
        raise NotConverged(
            f"Dugdale: the opening of the ring around a contact of {radius[worst]:.3g} m still moves by "
            f"{before[worst]:.1e} on refinement. Either the ring, out to "
            f"{math.hypot(radius[worst], span[worst]):.3g} m, is too wide against the layers, or the profile is not "
            "smooth between its stated kinks: give a greater strength, state the kinks, or use ShortRange(work)."
        )
    return LayeredZone(span, np.hypot(radius, span), _gathered(parts, radius.size), level_of)


def _gathered(parts: list[tuple[Array, LayeredRing]], size: int) -> LayeredRing:
    """Return rings of different rules in the order of their contacts, their series made equally long."""
    fields = []
    for index, first in enumerate(parts[-1][1]):
        whole = np.zeros((size, *first.shape[1:]))
        for members, ring in parts:
            field = ring[index]
            if field.ndim == 1:
                whole[members] = field
            else:
                whole[members, : field.shape[1]] = field
        fields.append(whole)
    return LayeredRing(*fields)


def _coarsest(zones: RingOnLayers, radius: Array, guess: Array) -> int:
    """Return the first rule by which rings as wide as the guess open nearly as by the next one."""
    before = zones.apart(radius, guess, 0)[0]
    for level in range(1, len(RULES) - 1):
        here = zones.apart(radius, guess, level)[0]
        if np.all(np.abs(here - before) <= NEARLY * (1.0 + np.abs(here))):
            return level - 1
        before = here
    return len(RULES) - 2


def _span(
    zones: RingOnLayers, radius: Array, guess: Array, level: int, refuse: Callable[[Array], None]
) -> tuple[Array, Array]:
    """Return s = sqrt(c^2 - a^2) by the rule of a level, and with which power of s the surfaces open there.

    The secant method in logarithms, inside a bracket that only shrinks.
    """
    farthest = root_difference(np.full(radius.shape, min(zones.springs.end, 1e150)), radius)
    span = np.minimum(guess, farthest)
    low, high = np.zeros(radius.shape), np.full(radius.shape, math.inf)
    last, last_level = np.full(radius.shape, math.nan), np.full(radius.shape, math.nan)
    left, powers = np.arange(radius.size), np.full(radius.shape, 2.0)
    for _ in range(ITERATIONS):
        here = span[left]
        excess = zones.apart(radius[left], here, level)[0]
        short = excess < 0.0
        if np.any(short & (here >= farthest[left])):
            beyond = np.zeros(radius.shape, dtype=bool)
            beyond[left] = short & (here >= farthest[left])
            refuse(beyond)
        low[left], high[left] = np.where(short, here, low[left]), np.where(short, high[left], here)
        value = np.log1p(np.maximum(excess, -0.99))
        with np.errstate(all="ignore"):
            power = (value - last_level[left]) / np.log(here / last[left])
        power = np.where((power > 0.2) & (power < 20.0), power, 2.0)
        powers[left] = power
        step = np.clip(value / power, -3.0, 3.0)
        last[left], last_level[left] = here, value
        new = here * np.exp(-step)
        settled = np.abs(step) <= LAST_STEP
        inside = (new > low[left]) & (new < high[left])
        middle = np.where(
            np.isinf(high[left]),
            2.0 * here,
            np.where(low[left] > 0.0, np.sqrt(low[left]) * np.sqrt(high[left]), 0.5 * here),
        )
        span[left] = np.minimum(np.where(inside | settled, new, middle), farthest[left])
        closed = high[left] <= low[left] * (1.0 + 4e-16)
        left = left[~(settled | closed)]
        if not left.size:
            break
    return span, powers


def widest_on_layers(zones: RingOnLayers) -> float:
    """Return the contact radius whose ring ends with the profile [m]; zero if no ring is so narrow."""
    end = (1.0 - 1e-12) * zones.springs.end

    def excess(radius: Array, _: Array) -> Array:
        return zones.apart(radius, root_difference(np.full(radius.shape, end), radius), 3)[0]

    low, high = np.full(1, 1e-9 * end), np.array([end * (1.0 - 1e-9)])
    if excess(low, low)[0] <= 0.0:
        return 0.0
    return float(between(excess, low, high)[0]) * (1.0 - 1e-7) if excess(high, high)[0] < 0.0 else float(high[0])
