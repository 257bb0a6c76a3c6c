"""Strips of contact that were found under one load: refined ones, or elements; both answer the same questions."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.chunks import chunks
from winkler.numerics.fields.strips_below import loads_of
from winkler.numerics.surfaces.pressed_line import PressedLine
from winkler.numerics.surfaces.refined_strips import gaps
from winkler.numerics.surfaces.strip_equations import LineCurve, Spots
from winkler.numerics.types import Array, ComplexArray, Curve

SAMPLES, ZOOMS, ZOOMED = 65, 6, 9
"""Places of a strip among which its greatest pressure is sought, at least, and how they close in on it."""
PLACES_PER_CHUNK, PAIRS_PER_CHUNK = 1000, 1_000_000
FEWEST_LOADS = 24
"""Line loads of a strip in its transform, beyond the terms of its series and 3/4 of the phase over its half-width."""


class RefinedStrips(NamedTuple):
    """Strips whose edges and pressures were refined.

    Parameters
    ----------
    modulus
        E* [Pa].
    origin, unit
        Place [m] and length [m] in which the strips are given.
    curve, spots
        The section and the strips.
    error
        The greatest of tension, overlap and what is left of the equations, each over its scale.
    """

    modulus: float
    origin: float
    unit: float
    curve: LineCurve
    spots: Spots
    error: float

    @property
    def refined(self) -> bool:
        """Yes."""
        return True

    @property
    def tilt(self) -> float:
        """theta."""
        return self.spots.tilt

    @property
    def edges(self) -> Array:
        """Left and right edges [m], (m, 2)."""
        return self.origin + self.unit * np.array([[strip.start, strip.end] for strip in self.spots.strips])

    @property
    def forces(self) -> Array:
        """Force per length of each strip [N/m]."""
        return 0.5 * self.modulus * self.unit * np.array([strip.force for strip in self.spots.strips])

    @property
    def moment(self) -> float:
        """Moment of the pressure about x = 0 per length [N]."""
        turned = sum(strip.moment for strip in self.spots.strips)
        return 0.5 * self.modulus * self.unit**2 * float(turned) + self.origin * float(np.sum(self.forces))

    @property
    def peaks(self) -> Array:
        """The greatest pressure of each strip [Pa], infinite at a sharp crest or wall."""
        found = []
        for strip in self.spots.strips:
            if strip.walls != (0.0, 0.0) or np.any(strip.corners[:, 1] > 0.0):
                found.append(math.inf)
                continue
            angle = np.linspace(0.0, math.pi, SAMPLES + 2 * strip.series.size)
            for _ in range(ZOOMS):
                level = -strip.potential(strip.middle + strip.half * np.cos(angle) + 0.0j).imag
                best = int(np.argmax(level))
                angle = np.linspace(angle[max(best - 1, 0)], angle[min(best + 1, angle.size - 1)], ZOOMED)
            found.append(0.5 * self.modulus * float(np.max(level)))
        return np.array(found)

    def _placed(self, x: Array) -> Array:
        return (np.asarray(x, dtype=float) - self.origin) / self.unit

    def pressure(self, x: Array) -> Array:
        """Return p [Pa] at places [m]."""
        place = self._placed(x)
        found = np.zeros(place.shape)
        for strip in self.spots.strips:
            inside = (place >= strip.start) & (place <= strip.end)
            if inside.any():
                found[inside] = -0.5 * self.modulus * strip.potential(place[inside] + 0.0j).imag
        return np.maximum(found, 0.0)

    def gap(self, x: Array) -> Array:
        """Return the distance of the deformed surfaces [m] at places where the body is."""
        place = self._placed(x)
        found = np.zeros(place.shape)
        beside = np.ones(place.shape, dtype=bool)
        for strip in self.spots.strips:
            beside &= (place < strip.start) | (place > strip.end)
        if beside.any():
            found[beside] = self.unit * gaps(self.curve, self.spots, place[beside])
        return np.maximum(found, 0.0)

    def potential(self, x: Array, z: Array) -> tuple[Array, Array]:
        """Return F [Pa] and, below the surface, F' [Pa/m]."""
        zeta = self._placed(x) + 1j * np.asarray(z) / self.unit
        whole, slope, deep = np.zeros(zeta.shape, dtype=complex), np.zeros(zeta.shape, dtype=complex), zeta.imag > 0.0
        for strip in self.spots.strips:
            whole += strip.potential(zeta)
            slope[deep] += strip.gradient(zeta[deep])
        return 0.5 * self.modulus * whole, 0.5 * self.modulus / self.unit * slope

    def transform(self, k: Array, middle: float) -> ComplexArray:
        """Return the transform of the pressure at ascending wave numbers [1/m], places counted from a middle [N/m]."""
        found = np.zeros(k.size, dtype=complex)
        for strip in self.spots.strips:
            count = strip.series.size + FEWEST_LOADS + math.ceil(0.75 * k[-1] * self.unit * strip.half)
            pressed = loads_of(strip, count)
            places = self.origin - middle + self.unit * pressed.places
            found += _summed(places, 0.5 * self.modulus * self.unit * pressed.loads, k)
        return found


class ElementStrips(NamedTuple):
    """Strips made of even elements.

    Parameters
    ----------
    modulus
        E* [Pa].
    places
        Middles of the elements [m].
    pressed
        Pressures over E*/2, and gaps [m].
    error
        The greatest relative change of contact length and greatest pressure from half as many elements, or an element
        of every strip over all that touch, if that is greater.
    beyond
        The distance of the deformed surfaces [m] at places beyond the elements [m].
    """

    modulus: float
    places: Array
    pressed: PressedLine
    error: float
    beyond: Curve

    @property
    def refined(self) -> bool:
        """No."""
        return False

    @property
    def tilt(self) -> float:
        """theta."""
        return self.pressed.tilt

    @property
    def spacing(self) -> float:
        """Width of the elements [m]."""
        return float(self.places[-1] - self.places[0]) / (self.places.size - 1)

    @property
    def _runs(self) -> Array:
        return runs(self.pressed.pressure > 0.0)

    @property
    def edges(self) -> Array:
        """Left and right edges [m], (m, 2): those of elements."""
        found = self._runs
        return np.stack([self.places[found[:, 0]], self.places[found[:, 1]]], axis=1) + 0.5 * self.spacing * np.array(
            [-1.0, 1.0]
        )

    @property
    def forces(self) -> Array:
        """Force per length of each strip [N/m]."""
        whole = np.concatenate([[0.0], np.cumsum(self.pressed.pressure)])
        return np.asarray(0.5 * self.modulus * self.spacing * (whole[self._runs[:, 1] + 1] - whole[self._runs[:, 0]]))

    @property
    def moment(self) -> float:
        """Moment of the pressure about x = 0 per length [N]."""
        return 0.5 * self.modulus * self.spacing * float(self.pressed.pressure @ self.places)

    @property
    def peaks(self) -> Array:
        """The greatest pressure of each strip [Pa], that of an element."""
        p = self.pressed.pressure
        return 0.5 * self.modulus * np.array([float(np.max(p[i : j + 1])) for i, j in self._runs])

    def pressure(self, x: Array) -> Array:
        """Return p [Pa] at places [m]: even on each element."""
        at = np.round((np.asarray(x, dtype=float) - self.places[0]) / self.spacing)
        inside = (at >= 0) & (at < self.places.size)
        index = np.clip(at, 0, self.places.size - 1).astype(int)
        return np.where(inside, 0.5 * self.modulus * self.pressed.pressure[index], 0.0)

    def gap(self, x: Array) -> Array:
        """Return the distance of the deformed surfaces [m]: straight between the middles of elements."""
        x = np.asarray(x, dtype=float)
        found = np.interp(x, self.places, np.where(self.pressed.pressure > 0.0, 0.0, self.pressed.gap))
        outside = (x < self.places[0]) | (x > self.places[-1])
        if outside.any():
            found[outside] = self.beyond(x[outside])
        return np.maximum(found, 0.0)

    def potential(self, x: Array, z: Array) -> tuple[Array, Array]:
        """Return F [Pa] and, below the surface, F' [Pa/m]."""
        bears = self.pressed.pressure > 0.0
        p, left = self.pressed.pressure[bears], self.places[bears] - 0.5 * self.spacing
        zeta = (np.asarray(x) + 1j * np.asarray(z)).ravel()
        whole, slope = np.zeros(zeta.shape, dtype=complex), np.zeros(zeta.shape, dtype=complex)
        for part in chunks(zeta.size, 1, PLACES_PER_CHUNK):
            near = zeta[part, None] - left[None, :]
            far = near - self.spacing
            with np.errstate(all="ignore"):
                whole[part] = (np.log(near) - np.log(far)) @ p
                slope[part] = np.where(zeta[part].imag > 0.0, (1.0 / near - 1.0 / far) @ p, 0.0)
        factor, shape = 0.5 * self.modulus / math.pi, np.shape(x)
        return factor * whole.reshape(shape), factor * slope.reshape(shape)

    def transform(self, k: Array, middle: float) -> ComplexArray:
        """Return the transform of the pressure at wave numbers [1/m], places counted from a middle [N/m]."""
        bears = self.pressed.pressure > 0.0
        loads = 0.5 * self.modulus * self.spacing * self.pressed.pressure[bears]
        return np.sinc(k * self.spacing / (2.0 * math.pi)) * _summed(self.places[bears] - middle, loads, k)


FoundStrips = RefinedStrips | ElementStrips


def _summed(places: Array, loads: Array, k: Array) -> ComplexArray:
    """Return the transform of line loads."""
    parts = chunks(k.size, places.size, PAIRS_PER_CHUNK)
    return np.concatenate([np.exp(-1j * np.outer(k[part], places)) @ loads for part in parts])


def runs(active: Array) -> Array:
    """Return the first and last index of each run of true values, (m, 2)."""
    padded = np.concatenate([[False], active, [False]]).astype(int)
    change = np.diff(padded)
    return np.stack([np.flatnonzero(change == 1), np.flatnonzero(change == -1) - 1], axis=1)
