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
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from winkler.media.interior.map_field import MapField
from winkler.media.interior.periodic_map_field import PeriodicMapField
from winkler.media.interior.rectangle import COMPONENTS, STRESSES
from winkler.media.layered.coated_interior import refuse_unknown_places, wave_states
from winkler.media.layered.hankel_waves import faded_out
from winkler.media.layered.sheared_interior import across_states
from winkler.media.layered.stack import StackBody
from winkler.media.layered.wave_constants import WaveConstants, constants_of
from winkler.media.offers import LayerStack
from winkler.numerics.chunks import chunks
from winkler.numerics.types import Array, ComplexArray

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


class _LoadWaves(NamedTuple):
    """Some waves of a map: wave numbers along x and y, transforms of the loads (l, m, n) with the weights of the waves.

    Waves of a `size` are those of fast transforms, which begin in the middle of the first pixel at `origin`.
    """

    kx: Array
    ky: Array
    loads: ComplexArray
    size: tuple[int, int] = (0, 0)
    origin: tuple[float, float] = (0.0, 0.0)

    @property
    def k(self) -> Array:
        """Wave numbers in all directions, (m, n)."""
        return np.hypot(self.kx[:, None], self.ky)

    def on_grid(self, amplitudes: ComplexArray, x: Array, y: Array) -> Array:
        """Return the sums of waves of amplitudes (c, m, n) in the middles x, y of the pixels of a map, (c, nx, ny)."""
        import scipy.fft

        if self.size[0]:
            each = (scipy.fft.irfft2(one, self.size, workers=-1)[: x.size, : y.size] for one in amplitudes)
            return np.array([*each])
        rows, angles = np.exp(1j * np.outer(x, self.kx)) @ amplitudes, np.outer(self.ky, y)
        return np.asarray(rows.real @ np.cos(angles) - rows.imag @ np.sin(angles))

    def at_places(self, amplitudes: ComplexArray, x: Array, y: Array) -> Array:
        """Return the same at places x, y of one shape (p,)."""
        weights = np.ones(self.ky.size)
        if self.size[0]:  # the other half of the waves is their complex conjugate
            weights[1 : (self.size[1] + 1) // 2] = 2.0
            weights /= math.prod(self.size)
        along = np.exp(1j * np.outer(x - self.origin[0], self.kx)) @ amplitudes
        return np.asarray(np.sum(along * np.exp(1j * np.outer(y - self.origin[1], self.ky)) * weights, axis=1).real)


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
        """Return the map of the means over `times` by `times` pixels from the same corner; a periodic one as it is."""
        if self.periodic:
            return self
        means = MapField(self.loads, self.pixel, 0.0).coarsened(times)
        return MapInLayers(self.medium, means.loads, means.pixel)

    def _short(self) -> _LoadWaves:
        """Return the shorter waves, of a periodic map all but the mean."""
        import scipy.fft

        nx, ny = (size * (1 if self.periodic else 2) for size in self.loads.shape[1:])
        kx = 2.0 * math.pi * scipy.fft.fftfreq(nx, self.pixel[0])
        ky = 2.0 * math.pi * scipy.fft.rfftfreq(ny, self.pixel[1])
        k = np.hypot(kx[:, None], ky)
        part = np.where(k > 0.0, 1.0, 0.0)
        if not self.periodic:
            part *= 1.0 - faded_out(k / self.join - 1.0)
        loads = scipy.fft.rfft2(self.loads[self.numbers], (nx, ny), workers=-1)
        return _LoadWaves(kx, ky, loads * part, (nx, ny), (0.5 * self.pixel[0], 0.5 * self.pixel[1]))

    def _long(self) -> Iterator[_LoadWaves]:
        """Yield the bands of longer waves."""
        x, y = self.middles
        high, last = self.join, False
        while not last:
            low = high / BAND
            room = ROOM * SHORT_WAVES / low
            last = room > LONGEST_PERIOD * max(self.sides) and low < LONGEST_WAVE / self.medium.response.span
            steps = [2.0 * math.pi / (side + room) for side in self.sides]
            counts = [math.ceil(2.0 * high / step) for step in steps]
            kx, ky = steps[0] * np.arange(-counts[0], counts[0] + 1), steps[1] * np.arange(counts[1] + 1)
            k = np.hypot(kx[:, None], ky)
            part = faded_out(k / high - 1.0) - (0.0 if last else faded_out(k / low - 1.0))
            part *= np.where(ky > 0.0, 2.0, 1.0) * math.prod(steps) / (4.0 * math.pi**2)
            part = np.where(k > 0.0, part * math.prod(self.pixel), 0.0)
            loads = np.exp(-1j * np.outer(kx, x)) @ self.loads[self.numbers] @ np.exp(-1j * np.outer(y, ky))
            yield _LoadWaves(kx, ky, loads * part)
            high = low

    @property
    def middles(self) -> tuple[Array, Array]:
        """Of the pixels, along x and along y [m]."""
        x, y = ((np.arange(n) + 0.5) * side for n, side in zip(self.loads.shape[1:], self.pixel, strict=True))
        return x, y

    def at_depth(self, z: float, count: int = COMPONENTS) -> Array:
        """Return sigma xx, yy, zz, xy, xz, yz [Pa] and u, v, w [m] below the middles of all pixels, (count, nx, ny).

        Parameters
        ----------
        z : float
            Depth [m]; an interface belongs to the upper layer.
        count : int, optional
            How many of them.

        Raises
        ------
        OutsideValidity
            If it lies in a rigid base, or in a transversely isotropic uppermost layer.
        """
        found = np.zeros((count, *self.loads.shape[1:]))
        for waves, total in self._waves_at(z, found, lambda own: own.at_depth(z, count)):
            found += waves.on_grid(total, *self.middles)
        return found

    def at_places(self, places: Array) -> Array:
        """Return the same at places (m, 3) on or below the map, as (9, m)."""
        found = np.zeros((COMPONENTS, len(places)))
        for z in np.unique(places[:, 2]):
            (chosen,) = np.nonzero(places[:, 2] == z)
            part = np.zeros((COMPONENTS, chosen.size))
            for waves, total in self._waves_at(float(z), part, lambda own: own.at_places(places[chosen])):  # noqa: B023
                for some in chunks(chosen.size, waves.kx.size):
                    x, y = places[chosen[some], :2].T
                    for row, amplitudes in zip(part, total, strict=True):
                        row[some] += waves.at_places(amplitudes, x, y)
            found[:, chosen] = part
        return found

    def across(self, y: float, z: float) -> Array:
        """Return the same on the line at y and depth z, below the middles of the pixels along x, (9, nx)."""
        x = self.middles[0]
        return self.at_places(np.stack([x, np.full(x.size, y), np.full(x.size, z)], axis=1))

    def _waves_at(
        self, z: float, found: Array, own: Callable[[MapField | PeriodicMapField], Array]
    ) -> Iterator[tuple[_LoadWaves, ComplexArray]]:
        """Yield waves and the amplitudes of the first components at a depth; add what no wave has to what is found."""
        refuse_unknown_places(self.body, np.array([z]))
        plane, beside, solid = self._states(z)
        if z <= self.body.bottoms[0]:
            kind, top = PeriodicMapField if self.periodic else MapField, self.body.top
            found += own(kind(self.loads, self.pixel, top.poisson))  # type: ignore[union-attr]
            found[STRESSES:] /= 2.0 * top.shear  # type: ignore[union-attr]
        elif self.periodic:
            pressure, along, across = np.mean(self.loads, axis=(1, 2))
            held = solid.lateral * pressure
            means = np.array([held, held, pressure, 0.0, along, across])
            found[:STRESSES] -= means.reshape(-1, *(1,) * (found.ndim - 1))
        between = {number > 0: self._between(plane[int(number > 0)]) for number in self.numbers}
        aside = self._between(beside)
        for waves in self.waves:
            k = waves.k
            reach = min(int(np.searchsorted(self.table, float(np.min(k[k > 0.0])))), TABLE - 1)
            if not (np.any(plane[:, :, reach:]) or np.any(beside[:, reach:])):
                continue  # they have died out
            per_k = 1.0 / np.where(k > 0.0, k, 1.0)
            total = np.zeros((len(found), *k.shape), dtype=complex)
            logs = np.clip(np.log(np.maximum(k, 1e-300)), *np.log(self.table[[0, -1]]))
            turned = aside(logs) if self.numbers[-1] > 0 else np.zeros((2, 1, 1))
            states = {dragged: rows(logs) for dragged, rows in between.items()}
            bend = solid.shear * solid.twist
            for load, number in zip(waves.loads, self.numbers, strict=True):
                state = states[number > 0]
                c, s = waves.kx[:, None] * per_k, waves.ky * per_k
                total[:STRESSES] += _amplitudes(number, c, s, state, turned) * load
                if len(found) > STRESSES:
                    total[STRESSES:] += _displacements(number, c, s, state, turned[0] / bend) * (load * per_k)
            yield waves, total

    def _states(self, z: float) -> tuple[Array, Array, WaveConstants]:
        """Return what the waves of the table give, of tractions down and along (2, 6, m) and across (2, m).

        Of the former these are stresses along, across, down and in shear, and displacements along and down times k; of
        the latter stresses in the plane and down.  Last are the constants of the solid.
        """
        deepest = max(1, int(np.searchsorted(self.table * z, FARTHEST_DECAY)))
        k, depths = self.table[:deepest], np.array([z])
        plane, beside = np.zeros((2, 6, TABLE)), np.zeros((2, TABLE))
        for dragged in {number > 0 for number in self.numbers}:
            ((_, state, end),) = wave_states(self.body, depths, k, dragged=dragged)
            plane[int(dragged), :, :end] = state.weighted(np.ones(end))
        solid = constants_of(state.solid)
        if self.numbers[-1] > 0:
            (across,) = across_states(self.body, depths, k)
            beside[:, :deepest] = solid.shear * solid.twist * across.moved, across.loaded
        return plane, beside, solid

    def _between(self, rows: Array) -> Callable[[Array], Array]:
        """Return rows of the table as a function of logarithms of wave numbers of any shape."""
        from scipy.interpolate import CubicSpline

        found: Callable[[Array], Array] = CubicSpline(np.log(self.table), rows, axis=1)
        return found


def _amplitudes(number: int, c: Array, s: Array, plane: Array, beside: Array) -> ComplexArray:
    """Return each stress of waves in the directions (c, s) per pressure (0), or traction along x (1) or y (2)."""
    along, across, down, shear = plane[:4]
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


def _displacements(number: int, c: Array, s: Array, plane: Array, beside: Array) -> ComplexArray:
    """Return each displacement times the wave number, as `_amplitudes`."""
    strain, lift = plane[4:]
    if number == 0:
        return np.array([-1j * strain * c, -1j * strain * s, lift + 0j])
    g, h = (c, -s) if number == 1 else (s, c)
    return np.array([c * strain * g - s * beside * h, s * strain * g + c * beside * h, 1j * lift * g])
