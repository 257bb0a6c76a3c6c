r"""Stresses inside layers under a map of pressures that is even about its middle, at rest or dragged along the surface.

A wave of the wave number k in the direction (c, s) moves the layers as a plane wave does
(`winkler.media.layered.plane_interior`); one whose traction points across it as in
`winkler.media.layered.sheared_interior`.  With the stresses A, B along and across, S down, T of a pressure, and D, Q of
waves across,

.. math:: \sigma_x = \frac1{4\pi^2}\int (A c^2 + B s^2)\,\hat p\,e^{i(k_x x + k_y y)}\,\mathrm d^2k , \quad\dots

Waves longer than some tenths of the map are summed over directions and wave numbers, so that nothing is repeated in
space; shorter ones, which do not reach a copy of the map, by fast Fourier transforms on twice its size.  In the
uppermost layer the field of a half-space under the same pixels is `winkler.media.interior.map_field`, and waves add the
rest.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.media.interior.map_field import MapField
from winkler.media.interior.tensor import Measure, Tensor
from winkler.media.layered.coated_interior import wave_states
from winkler.media.layered.hankel_waves import faded_out
from winkler.media.layered.sheared_interior import across_states
from winkler.media.layered.stack import StackBody
from winkler.media.layered.wave_constants import constants_of
from winkler.media.offers import LayerStack
from winkler.numerics.chunks import chunks
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.transforms.cosine_transform import wave_numbers
from winkler.numerics.types import Array

__all__ = ["MapInLayers"]

LONG_WAVES = 8.0
"""Wave number times half the shorter side of the map from which on, over an octave, transforms take over."""
FIRST_WAVE = 0.1
"""First panel of wave numbers, times the length beyond which the layers are only their base."""
LARGEST_PHASE = 9.0
"""Over a panel of wave numbers, or of directions."""
DIRECTION_NODES = 12
LEAST_WAVE = 1e-5
"""Transform of the pressure over the force, below which a wave is left out."""
TABLE = 600
"""Wave numbers at which states are computed; between them they are splines in the logarithm."""
FARTHEST_DECAY = 40.0


class _DirectedWaves(NamedTuple):
    """Long waves of one quadrant: k, their direction, and quadrature weight times the transform of the pressure."""

    k: Array
    c: Array
    s: Array
    weight: Array
    even: tuple[Array, Array]
    odd: tuple[Array, Array]


class MapInLayers:
    """A map of pressures on layers.

    Parameters
    ----------
    medium : LayerStack
        Layers on their base.
    pressure : ndarray, (n, n)
        [Pa], even along both axes, n even.
    pixel : tuple of float
        (dx, dy) [m].
    """

    def __init__(self, medium: LayerStack, pressure: Array, pixel: tuple[float, float]) -> None:
        self.medium, self.pressure, self.pixel = medium, pressure, pixel
        self.body = StackBody(medium.stack, medium.on)
        half = pressure.shape[0] // 2
        self.x, self.y = ((np.arange(half) + 0.5) * side for side in pixel)
        self.sides = half * pixel[0], half * pixel[1]
        self.join = LONG_WAVES / min(self.sides)
        self.long = self._long()
        self._short()
        nyquist = math.pi * math.hypot(1.0 / pixel[0], 1.0 / pixel[1])
        self.table = np.geomspace(1e-3 * FIRST_WAVE / medium.response.span, nyquist, TABLE)

    def _share(self, k: Array) -> Array:
        """Return the part of a wave that is summed over directions: a smooth step from one to zero over an octave."""
        return faded_out(k / self.join - 1.0)

    def _long(self) -> _DirectedWaves:
        """Return the long waves, without those that bear next to nothing."""
        end, (a, b) = 2.0 * self.join, self.sides
        k, dk = wave_numbers(FIRST_WAVE / self.medium.response.span, 0.5 * LARGEST_PHASE / math.hypot(a, b), end)
        panels = math.ceil(0.5 * math.pi * end * max(a, b) / LARGEST_PHASE)
        nodes, weights = gauss_legendre(DIRECTION_NODES)
        turn = ((np.arange(panels)[:, None] + nodes) * (0.5 * math.pi / panels)).ravel()
        dturn = np.tile(weights * (0.5 * math.pi / panels), panels)
        quarter = self.pressure[self.x.size :, self.y.size :] * (4.0 * math.prod(self.pixel))
        force, kept = float(np.sum(quarter)), []
        for part in chunks(k.size, turn.size, 200_000):
            waves, angles = (each.ravel() for each in np.meshgrid(k[part], turn, indexing="ij"))
            along = np.cos(np.outer(waves * np.cos(angles), self.x))
            aside = np.cos(np.outer(waves * np.sin(angles), self.y))
            borne = np.sum((along @ quarter) * aside, axis=1) * self._share(waves)
            area = np.outer(k[part] * dk[part], dturn).ravel() / math.pi**2
            there = np.abs(borne) > LEAST_WAVE * force
            kept.append(np.stack([waves, angles, borne * area])[:, there])
        waves, angles, weight = np.concatenate(kept, axis=1)
        c, s = np.cos(angles), np.sin(angles)
        phases = np.outer(waves * c, self.x), np.outer(waves * s, self.y)
        return _DirectedWaves(
            waves,
            c,
            s,
            weight,
            (np.ascontiguousarray(np.cos(phases[0]).T), np.cos(phases[1])),
            (np.ascontiguousarray(np.sin(phases[0]).T), np.sin(phases[1])),
        )

    def _short(self) -> None:
        """Keep the shorter waves on a grid of twice the size."""
        import scipy.fft

        shape = 2 * self.pressure.shape[0], 2 * self.pressure.shape[1]
        kx = 2.0 * math.pi * scipy.fft.fftfreq(shape[0], self.pixel[0])[:, None]
        ky = 2.0 * math.pi * scipy.fft.rfftfreq(shape[1], self.pixel[1])[None, :]
        self.wave = np.hypot(kx, ky)
        safe = np.where(self.wave > 0.0, self.wave, 1.0)
        self.direction = kx / safe, ky / safe
        self.spectrum = scipy.fft.rfft2(self.pressure, shape) * (1.0 - self._share(self.wave))

    def _states(self, z: float, dragged: bool) -> tuple[Array, Array]:
        """Return stresses along, across, down and in shear (4, m), and of waves across in the plane and down (2, m)."""
        deepest = max(1, int(np.searchsorted(self.table * max(z, 1e-300), FARTHEST_DECAY)))
        k, depths = self.table[:deepest], np.array([z])
        found = np.zeros((4, self.table.size))
        ((_, state, end),) = wave_states(self.body, depths, k, dragged=dragged)
        found[:, :end] = state.weighted(np.ones(end))[:4]
        beside = np.zeros((2, self.table.size))
        if dragged:
            (across,) = across_states(self.body, depths, k)
            solid = constants_of(state.solid)
            beside[:, :deepest] = solid.shear * solid.twist * across.moved, across.loaded
        return found, beside

    def _at(self, k: Array, rows: Array) -> Array:
        """Return rows of the table at wave numbers of any shape."""
        from scipy.interpolate import CubicSpline

        logs = np.log(self.table)
        return np.asarray(CubicSpline(logs, rows, axis=1)(np.clip(np.log(np.maximum(k, 1e-300)), logs[0], logs[-1])))

    def stresses(self, z: float, traction: tuple[float, float] = (0.0, 0.0)) -> Array:
        """Return sigma xx, yy, zz, xy, xz, yz [Pa] below the middles of all pixels, (6, n, n).

        Parameters
        ----------
        z : float
            Depth [m]; an interface belongs to the upper layer.
        traction : tuple of float
            Along x and y over the pressure [-], with which the surface is dragged.
        """
        whole = np.zeros((6, *self.pressure.shape))
        if z <= self.body.bottoms[0]:
            top = self.body.top
            loads = np.stack([self.pressure, traction[0] * self.pressure, traction[1] * self.pressure])
            whole += MapField(loads, self.pixel, top.poisson).at_depth(z)[:6]  # type: ignore[union-attr]
        for number, share in enumerate((1.0, *traction)):
            if share != 0.0:
                whole += share * self._added(z, number)
        return whole

    def _added(self, z: float, number: int) -> Array:
        """Return the stresses of all waves under a pressure (0), or tractions along x (1) or y (2) as large."""
        import scipy.fft

        plane, beside = self._states(z, number > 0)
        long, short = self.long, (self.wave, *self.direction)
        amplitudes = _amplitudes(number, long.c, long.s, self._at(long.k, plane), self._at(long.k, beside))
        shares = _amplitudes(number, *short[1:], self._at(short[0], plane), self._at(short[0], beside))
        found = np.empty((6, *self.pressure.shape))
        nx, ny = self.pressure.shape
        for row, ((amplitude, parity), (share, _)) in enumerate(zip(amplitudes, shares, strict=True)):
            along, aside = (
                (long.odd if odd else long.even)[axis] for axis, odd in enumerate((parity[0] < 0, parity[1] < 0))
            )
            # odd along both axes: sin sin of the quadrant is minus the part of the wave that is even in its phase
            sign = -1.0 if parity == (-1, -1) else 1.0
            quarter = (along * (sign * amplitude * long.weight)) @ aside
            rows = np.concatenate([parity[0] * quarter[::-1], quarter])
            found[row] = np.concatenate([parity[1] * rows[:, ::-1], rows], axis=1)
            turned = share * (1.0 if parity[0] * parity[1] > 0 else -1j)
            found[row] += scipy.fft.irfft2(self.spectrum * turned, (2 * nx, 2 * ny), workers=1)[:nx, :ny]
        return found

    def greatest(self, stresses: Tensor, measure: Measure) -> tuple[float, float, float]:
        """Return the greatest stress of a kind [Pa] of those at a depth, and its x and y [m]."""
        level = measure(stresses)
        i, j = np.unravel_index(int(np.argmax(level)), level.shape)
        middle = [0.5 * size for size in level.shape]
        place = [(float(at) + 0.5 - mid) * side for at, mid, side in zip((i, j), middle, self.pixel, strict=True)]
        return float(level[i, j]), place[0], place[1]


def _amplitudes(number: int, c: Array, s: Array, plane: Array, beside: Array) -> list[tuple[Array, tuple[int, int]]]:
    """Return what each stress of a wave is per pressure or traction, and its parity along x and y.

    Of a phase with an odd power of sines the amplitude stands at the sine, else at the cosine.
    """
    along, across, down, shear = plane
    turned, aside = beside
    if number == 0:
        stress = along * c * c + across * s * s, along * s * s + across * c * c, down, (along - across) * c * s
        parities = (1, 1), (1, 1), (1, 1), (-1, -1), (-1, 1), (1, -1)
        return list(zip((*stress, shear * c, shear * s), parities, strict=True))
    g, h = (c, -s) if number == 1 else (s, c)
    main, other, drop, bend = -along * g, -across * g, -down * g, -turned * h
    upright, beside_it = shear * g, aside * h
    found = (
        c * c * main + s * s * other - 2.0 * c * s * bend,
        s * s * main + c * c * other + 2.0 * c * s * bend,
        drop,
        c * s * (main - other) + (c * c - s * s) * bend,
        c * upright - s * beside_it,
        s * upright + c * beside_it,
    )
    first, second = ((-1, 1), (1, -1)) if number == 1 else ((1, -1), (-1, 1))
    even, odd = (1, 1), (-1, -1)
    return list(zip(found, (first, first, first, second, *((even, odd) if number == 1 else (odd, even))), strict=True))
