"""The states of a contact on layers around which a constant stress pulls, and the disc of stress before they touch."""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.foundation import Foundation
from winkler.laws.adhesion import Dugdale
from winkler.media.offers import PressedWaves, offers
from winkler.numerics.caching import cached_by_value
from winkler.numerics.equations.roots import rough_root
from winkler.numerics.panels.chebyshev import Panels, fit_panels
from winkler.numerics.panels.sqrt_panels import RootPanels, fit
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array
from winkler.problems.adhesion.edge_states import stored_energy
from winkler.problems.adhesion.layered_ring import LayeredRing, layered_ring, read
from winkler.problems.adhesion.layered_zone import (
    RULES,
    LayeredZone,
    RingOnLayers,
    layered_zone,
    widest_on_layers,
)
from winkler.problems.adhesion.maugis import CLOSEST_OTHERWISE, RingedSprings, beyond_profile, no_zone
from winkler.problems.adhesion.maugis_integrals import RingSprings, edges_of
from winkler.values.errors import OutsideValidity
from winkler.values.value import value, words

__all__ = ["DiscOnLayers", "LayeredStates", "RingedLayers"]

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
