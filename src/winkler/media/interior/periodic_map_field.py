r"""Stresses and displacements in a half-space under a map of loads that is repeated without end.

The loads are the waves through the middles of the pixels.  One of wave numbers :math:`k_x, k_y` decays as
:math:`e^{-qz}` with :math:`q^2=k_x^2+k_y^2`; the potentials of `winkler.media.interior.rectangle` are

.. math:: \frac{\Phi}{2\pi}=\frac{e^{-qz}}{q} , \qquad \frac{H}{2\pi}=-\frac{e^{-qz}}{q^2} , \qquad
          \frac{K}{2\pi}=\frac{e^{-qz}}{q^3} .

The mean loads leave the body its lateral size: under the mean pressure the stresses across are
:math:`\nu/(1-\nu)` of it.  The displacements of the mean loads, which are infinite, are left out.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.media.interior.rectangle import COMPONENTS, EXCHANGED
from winkler.numerics.types import Array

MOST_DECAY = 40.0
"""Waves that have decayed by this power of e do not count."""


class PeriodicMapField(NamedTuple):
    """A map of loads on the surface of a half-space, repeated along x and y.

    Parameters
    ----------
    loads
        Pressure, and tractions along x and y that act on the body, (3, nx, ny).
    pixel
        (dx, dy); places are counted in the same unit, from the corner of the map.
    poisson
        Of the body.
    """

    loads: Array
    pixel: tuple[float, float]
    poisson: float

    def _wave_numbers(self) -> tuple[Array, Array]:
        nx, ny = self.loads.shape[1:]
        kx = 2.0 * np.pi * np.fft.fftfreq(nx, self.pixel[0])
        ky = 2.0 * np.pi * np.fft.fftfreq(ny, self.pixel[1])
        return kx, ky

    def _waves(self, z: float) -> Array:
        """Return the waves of all components at one depth, (9, nx, ny)."""
        import scipy.fft

        kx, ky = np.meshgrid(*self._wave_numbers(), indexing="ij")
        q = np.hypot(kx, ky)
        q[0, 0] = 1.0 / self.pixel[0]  # the means follow
        p, along, across = scipy.fft.fft2(self.loads, workers=-1)
        out = np.asarray(
            p * _pressed(kx, ky, q, z, self.poisson)
            + along * _dragged(kx, ky, q, z, self.poisson)
            + across * _dragged(ky, kx, q, z, self.poisson)[list(EXCHANGED)]
        )
        out *= np.where(q * z < MOST_DECAY, np.exp(-np.minimum(q * z, MOST_DECAY)), 0.0)
        held = self.poisson / (1.0 - self.poisson)
        means = [part[0, 0] for part in (p, along, across)]
        out[:, 0, 0] = [-held * means[0], -held * means[0], -means[0], 0.0, -means[1], -means[2], 0.0, 0.0, 0.0]
        return out

    def at_depth(self, z: float, count: int = COMPONENTS) -> Array:
        """Return stresses and displacements below the middles of all pixels, as `MapField.at_depth`."""
        import scipy.fft

        return np.asarray(scipy.fft.ifft2(self._waves(z)[:count], workers=-1).real)

    def at_places(self, places: Array) -> Array:
        """Return stresses xx, yy, zz, xy, xz, yz and displacements, times 2 G, at places (m, 3), as (9, m)."""
        kx, ky = self._wave_numbers()
        out = np.empty((COMPONENTS, len(places)))
        for z in np.unique(places[:, 2]):
            chosen = places[:, 2] == z
            waves = self._waves(float(z))
            there = np.any(waves != 0.0, axis=0)
            rows, columns = np.flatnonzero(there.any(axis=1)), np.flatnonzero(there.any(axis=0))
            x = np.exp(1j * np.outer(places[chosen, 0] - 0.5 * self.pixel[0], kx[rows]))
            y = np.exp(1j * np.outer(places[chosen, 1] - 0.5 * self.pixel[1], ky[columns]))
            for k in range(COMPONENTS):
                out[k, chosen] = np.sum((x @ waves[k][np.ix_(rows, columns)]) * y, axis=1).real / there.size
        return out

    def across(self, y: float, z: float) -> Array:
        """Return the components on the line at y and depth z, below the middles of the pixels along x, (9, nx)."""
        import scipy.fft

        turn = np.exp(1j * (y - 0.5 * self.pixel[1]) * self._wave_numbers()[1])
        return np.asarray(scipy.fft.ifft(self._waves(z) @ turn, axis=1).real / turn.size)

    def coarsened(self, times: int) -> PeriodicMapField:
        """Return the map itself: its means over `times` by `times` pixels need not fit its sides."""
        return self

    def exchanged(self) -> PeriodicMapField:
        """Return the same map with x and y exchanged."""
        return PeriodicMapField(self.loads.transpose(0, 2, 1)[[0, 2, 1]], self.pixel[::-1], self.poisson)


def _pressed(kx: Array, ky: Array, q: Array, z: float, nu: float) -> Array:
    """Return what a wave of unit pressure gives, over its decay."""
    most = 1.0 - 2.0 * nu
    up, down = z / q - most / q**2, most / q**2 - z / q
    parts = (
        -2.0 * nu + kx**2 * up, -2.0 * nu + ky**2 * up, -1.0 - q * z, kx * ky * up,
        1j * z * kx, 1j * z * ky, 1j * kx * down, 1j * ky * down, 2.0 * (1.0 - nu) / q + z,
    )  # fmt: skip
    return np.stack(np.broadcast_arrays(*parts))


def _dragged(kx: Array, ky: Array, q: Array, z: float, nu: float) -> Array:
    """Return what a wave of unit traction along x gives, over its decay."""
    bent = 2.0 * nu / q**3 + z / q**2
    parts = (
        1j * kx * (2.0 * (1.0 + nu) / q - kx**2 * bent), 1j * kx * (2.0 * nu / q - ky**2 * bent),
        1j * kx * z, 1j * ky * (1.0 / q - kx**2 * bent),
        -1.0 + z * kx**2 / q, z * kx * ky / q,
        2.0 / q - kx**2 * bent, -kx * ky * bent, -1j * kx * ((1.0 - 2.0 * nu) / q**2 + z / q),
    )  # fmt: skip
    return np.stack(np.broadcast_arrays(*parts))
