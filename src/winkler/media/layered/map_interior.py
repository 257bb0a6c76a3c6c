r"""Stresses inside layers under a map of pressures and tractions, each constant in its pixel.

A wave of the wave number k in the direction (c, s) moves the layers as a plane wave does
(`winkler.media.layered.plane_interior`); one whose traction points across it as in
`winkler.media.layered.sheared_interior`.  With the stresses A, B along and across, S down, T of a pressure, and D, Q of
waves across,

.. math:: \sigma_x = \frac1{4\pi^2}\int (A c^2 + B s^2)\,\hat p\,e^{i(k_x x + k_y y)}\,\mathrm d^2k , \quad\dots

Of a map that stands alone the waves are divided by smooth steps into bands, each four times as long as the one before.
A band of long waves needs a lattice of few wave numbers with a period so long that no copy of the map is felt; the
shortest waves are summed by fast Fourier transforms on twice the size of the map.  In the uppermost layer the field of
a half-space under the same pixels is `winkler.media.interior.map_field`, and waves add the rest.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.media.interior.map_field import MapField
from winkler.media.interior.map_peak import DEEPEST, DEPTH_STEP, SHALLOWEST, greatest_of_levels, loaded_span
from winkler.media.interior.peak import StressSpot
from winkler.media.interior.periodic_map_field import PeriodicMapField
from winkler.media.interior.tensor import Measure, von_mises
from winkler.media.layered.coated_interior import refuse_unknown_places, wave_states
from winkler.media.layered.hankel_waves import faded_out
from winkler.media.layered.sheared_interior import across_states
from winkler.media.layered.stack import StackBody
from winkler.media.layered.wave_constants import constants_of
from winkler.media.offers import LayerStack
from winkler.numerics.types import Array, ComplexArray

__all__ = ["MapInLayers", "greatest_in_layer"]

SHORT_WAVES = 8.0
"""Wave number times half the shorter side of the map from which on, over an octave, transforms take over."""
BAND = 4.0
"""Ratio of the wave numbers at which two bands begin."""
ROOM = 4.0
"""Of a band, between a map and its copy: distance times the wave number where it begins, over `SHORT_WAVES`."""
LONGEST_PERIOD = 1000.0
"""Period of the last band, over the longer side of the map: its copies are felt as the inverse square of that."""
LONGEST_WAVE = 0.1
"""Wave number below which layers are only their base, times the length beyond which they are."""
TABLE = 600
"""Wave numbers at which states are computed; between them they are splines in the logarithm."""
FARTHEST_DECAY = 40.0
MEANS_PER_DEPTH = 6.0
"""Depth over the side of the means that stand for the pixels."""


class _LoadWaves(NamedTuple):
    """Some waves of a map: wave numbers and directions (m, n), transforms of the loads (l, m, n), factors of places.

    A transform has the weight of its wave.  Without factors the waves are those of fast transforms of some size.
    """

    k: Array
    c: Array
    s: Array
    loads: ComplexArray
    along: ComplexArray | None = None
    aside: ComplexArray | None = None
    size: tuple[int, int] = (0, 0)

    def summed(self, amplitudes: ComplexArray, shape: tuple[int, ...]) -> Array:
        """Return the sum of waves of these amplitudes (m, n) in the middles of the pixels of a map."""
        import scipy.fft

        if self.along is not None:
            return np.asarray((self.along @ amplitudes @ self.aside).real)
        return np.asarray(scipy.fft.irfft2(amplitudes, self.size, workers=-1)[: shape[0], : shape[1]])


class MapInLayers:
    """A map of loads on layers.

    Parameters
    ----------
    medium : LayerStack
        Layers on their base.
    loads : ndarray, (3, nx, ny)
        Pressure, and tractions along x and y that act on the surface [Pa].
    pixel : tuple of float
        (dx, dy) [m].
    periodic : bool
        Whether the map is repeated without end.
    """

    def __init__(self, medium: LayerStack, loads: Array, pixel: tuple[float, float], *, periodic: bool = False) -> None:
        self.medium, self.loads, self.pixel, self.periodic = medium, loads, pixel, periodic
        self.body = StackBody(medium.stack, medium.on)
        self.numbers = [number for number, load in enumerate(loads) if number == 0 or np.any(load != 0.0)]
        self.sides = [size * side for size, side in zip(loads.shape[1:], pixel, strict=True)]
        self.join = 2.0 * SHORT_WAVES / min(self.sides)
        nyquist = math.pi * math.hypot(1.0 / pixel[0], 1.0 / pixel[1])
        self.table = np.geomspace(1e-3 * LONGEST_WAVE / medium.response.span, nyquist, TABLE)
        self.waves = [self._short(), *(() if periodic else self._long())]

    def coarsened(self, times: int) -> MapInLayers:
        """Return the map of the means over `times` by `times` pixels, beginning at the same corner."""
        means = MapField(self.loads, self.pixel, 0.0).coarsened(times)
        return MapInLayers(self.medium, means.loads, means.pixel, periodic=self.periodic)

    def _short(self) -> _LoadWaves:
        """Return the shorter waves, of a periodic map all but the mean."""
        import scipy.fft

        nx, ny = (size * (1 if self.periodic else 2) for size in self.loads.shape[1:])
        kx = 2.0 * math.pi * scipy.fft.fftfreq(nx, self.pixel[0])[:, None]
        ky = 2.0 * math.pi * scipy.fft.rfftfreq(ny, self.pixel[1])[None, :]
        k = np.hypot(kx, ky)
        safe, part = np.where(k > 0.0, k, 1.0), np.where(k > 0.0, 1.0, 0.0)
        if not self.periodic:
            part *= 1.0 - faded_out(k / self.join - 1.0)
        loads = scipy.fft.rfft2(self.loads[self.numbers], (nx, ny), workers=-1)
        return _LoadWaves(k, kx / safe, ky / safe, loads * part, size=(nx, ny))

    def _long(self) -> Iterator[_LoadWaves]:
        """Yield the bands of longer waves."""
        x, y = ((np.arange(n) + 0.5) * side for n, side in zip(self.loads.shape[1:], self.pixel, strict=True))
        high, last = self.join, False
        while not last:
            low = high / BAND
            room = ROOM * SHORT_WAVES / low
            last = room > LONGEST_PERIOD * max(self.sides) and low < LONGEST_WAVE / self.medium.response.span
            steps = [2.0 * math.pi / (side + room) for side in self.sides]
            counts = [math.ceil(2.0 * high / step) for step in steps]
            kx, ky = steps[0] * np.arange(-counts[0], counts[0] + 1)[:, None], steps[1] * np.arange(counts[1] + 1)
            k = np.hypot(kx, ky)
            part = faded_out(k / high - 1.0) - (0.0 if last else faded_out(k / low - 1.0))
            part *= np.where(ky > 0.0, 2.0, 1.0) * math.prod(steps) / (4.0 * math.pi**2)
            safe, part = np.where(k > 0.0, k, 1.0), np.where(k > 0.0, part, 0.0)
            along, aside = np.exp(1j * np.outer(x, kx)), np.exp(1j * np.outer(ky, y))
            loads = along.conj().T @ self.loads[self.numbers] @ aside.conj().T
            yield _LoadWaves(k, kx / safe, ky / safe, loads * (part * math.prod(self.pixel)), along, aside)
            high = low

    def stresses(self, z: float) -> Array:
        """Return sigma xx, yy, zz, xy, xz, yz [Pa] below the middles of all pixels, (6, nx, ny).

        Parameters
        ----------
        z : float
            Depth [m]; an interface belongs to the upper layer.

        Raises
        ------
        OutsideValidity
            If it lies in a rigid base, or in a transversely isotropic uppermost layer.
        """
        refuse_unknown_places(self.body, np.array([z]))
        shape = self.loads.shape[1:]
        found = np.zeros((6, *shape))
        plane, beside, lateral = self._states(z)
        if z <= self.body.bottoms[0]:
            kind = PeriodicMapField if self.periodic else MapField
            found += kind(self.loads, self.pixel, self.body.top.poisson).at_depth(z)[:6]  # type: ignore[union-attr]
        elif self.periodic:
            pressure, along, across = np.mean(self.loads, axis=(1, 2))
            held = lateral * pressure
            found -= np.array([held, held, pressure, 0.0, along, across])[:, None, None]
        for waves in self.waves:
            reach = min(int(np.searchsorted(self.table, float(np.min(waves.k[waves.k > 0.0])))), TABLE - 1)
            if not (np.any(plane[:, :, reach:]) or np.any(beside[:, reach:])):
                continue  # they have died out
            total = np.zeros((6, *waves.k.shape), dtype=complex)
            turned = self._at(waves.k, beside) if self.numbers[-1] > 0 else np.zeros((2, 1, 1))
            states = [self._at(waves.k, plane[int(number > 0)]) for number in self.numbers[:2]]
            for load, number in zip(waves.loads, self.numbers, strict=True):
                total += _amplitudes(number, waves.c, waves.s, states[min(number, len(states) - 1)], turned) * load
            for row, amplitudes in zip(found, total, strict=True):
                row += waves.summed(amplitudes, shape)
        return found

    def _states(self, z: float) -> tuple[Array, Array, float]:
        """Return stresses of the waves of the table, of tractions down and along (2, 4, m) and across (2, m).

        Those of the former are along, across, down and in shear; of the latter in the plane and down.  The last number
        is the stress across over that down of a layer that keeps its width.
        """
        deepest = max(1, int(np.searchsorted(self.table * z, FARTHEST_DECAY)))
        k, depths = self.table[:deepest], np.array([z])
        plane, beside = np.zeros((2, 4, TABLE)), np.zeros((2, TABLE))
        for dragged in {number > 0 for number in self.numbers}:
            ((_, state, end),) = wave_states(self.body, depths, k, dragged=dragged)
            plane[int(dragged), :, :end] = state.weighted(np.ones(end))[:4]
        solid = constants_of(state.solid)
        if self.numbers[-1] > 0:
            (across,) = across_states(self.body, depths, k)
            beside[:, :deepest] = solid.shear * solid.twist * across.moved, across.loaded
        return plane, beside, solid.lateral

    def _at(self, k: Array, rows: Array) -> Array:
        """Return rows of the table at wave numbers of any shape."""
        from scipy.interpolate import CubicSpline

        logs = np.log(self.table)
        return np.asarray(CubicSpline(logs, rows, axis=1)(np.clip(np.log(np.maximum(k, 1e-300)), logs[0], logs[-1])))


def greatest_in_layer(field: MapInLayers, top: float, bottom: float, measure: Measure = von_mises) -> StressSpot:
    """Return the greatest stress of a kind [Pa] between two depths, and its place [m] from the corner of the map.

    Parameters
    ----------
    field : MapInLayers
        With some load.
    top, bottom : float
        Faces of a layer [m]; infinite of the base.
    measure
        Of which kind; von Mises' unless given.
    """
    lower = min(bottom, top + DEEPEST * math.hypot(loaded_span(field.loads, field.pixel), top))
    pixel = max(field.pixel)
    step = max(SHALLOWEST * pixel, 0.5 * (DEPTH_STEP - 1.0) * top)
    count = max(2, math.ceil(math.log(max(lower - top, step) / step, DEPTH_STEP)) + 1)
    first = 0.0 if top == 0.0 else float(np.nextafter(top, math.inf))
    depths = np.clip(top + step * DEPTH_STEP ** np.arange(count), first, lower)
    means = {1: field}

    def stresses(z: float) -> tuple[Array, tuple[float, float]]:
        times = 1 if field.periodic else max(1, int(z / (MEANS_PER_DEPTH * pixel)))
        if times not in means:
            means[times] = field.coarsened(times)
        return means[times].stresses(z), means[times].pixel

    return greatest_of_levels(stresses, np.unique([first, *depths]), top, measure)


def _amplitudes(number: int, c: Array, s: Array, plane: Array, beside: Array) -> ComplexArray:
    """Return each stress of waves in the directions (c, s) per pressure (0), or traction along x (1) or y (2)."""
    along, across, down, shear = plane
    turned, aside = beside
    if number == 0:
        even = along * c * c + across * s * s, along * s * s + across * c * c, down, (along - across) * c * s
        return np.array([*even, -1j * shear * c, -1j * shear * s])
    g, h = (c, -s) if number == 1 else (s, c)
    main, other, drop, bend = -along * g, -across * g, -down * g, -turned * h
    upright, beside_it = shear * g, aside * h
    odd = (
        c * c * main + s * s * other - 2.0 * c * s * bend,
        s * s * main + c * c * other + 2.0 * c * s * bend,
        drop,
        c * s * (main - other) + (c * c - s * s) * bend,
    )
    return np.array([*(-1j * each for each in odd), c * upright - s * beside_it, s * upright + c * beside_it])
