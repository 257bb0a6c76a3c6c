r"""How wide the ring of a constant stress is on layers, and what follows for depth and force.

With the ring of `winkler.problems.adhesion.layered_ring`, :math:`A = 2\sigma_0/E^*`,

.. math:: d = g(a) - A\,\frac{m(a)}{\varphi(a;a)} , \qquad
          F = k(a)\,d - \int_0^a k'g\,\mathrm dx - 4\sigma_0\int_a^c\varphi\,m\,\mathrm dx ,

and the surfaces stand apart at c by the work of adhesion over the stress,

.. math:: \frac w{\sigma_0} = \frac2\pi\Big[\int_a^c g'J\,\mathrm dx
              + A\Big(\frac{m(a)}{\varphi(a;a)}\,J(a) - \int_a^c m\,e\,\mathrm dx\Big)\Big] .

Stretch and pull are tabulated over the radius, for their slopes and because a search asks for hundreds of radii.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.equations.bracketing import between
from winkler.numerics.panels.sqrt_panels import root
from winkler.numerics.transforms.cosine_transform import WaveResponse
from winkler.numerics.types import Array
from winkler.problems.adhesion.layered_ring import LayeredRing, layered_ring, read
from winkler.problems.adhesion.maugis_integrals import RingSprings, Rule, profile_moment
from winkler.values.errors import NotConverged

__all__ = ["LayeredZone", "RingOnLayers", "layered_zone", "widest_on_layers"]

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
    farthest = root(np.full(radius.shape, min(zones.springs.end, 1e150)), radius)
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
        return zones.apart(radius, root(np.full(radius.shape, end), radius), 3)[0]

    low, high = np.full(1, 1e-9 * end), np.array([end * (1.0 - 1e-9)])
    if excess(low, low)[0] <= 0.0:
        return 0.0
    return float(between(excess, low, high)[0]) * (1.0 - 1e-7) if excess(high, high)[0] < 0.0 else float(high[0])
