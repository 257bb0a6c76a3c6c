r"""The field of a disc of one voltage on a half-space, of which nothing passes the surface beside it.

.. math:: \theta = \frac2\pi\operatorname{arccot}\zeta, \quad
          2\zeta^2a^2 = s+\sqrt{s^2+4a^2z^2}, \quad s = r^2+z^2-a^2, \qquad
          \frac{\partial\theta}{\partial z} = -\frac2\pi\,\mathrm{Im}\frac1{\sqrt{r^2+(z-\mathrm ia)^2}} .
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array


def disc_potential(r: Array, z: Array, radius: float) -> Array:
    """Return theta: one on the disc, falling to zero far away.

    Parameters
    ----------
    r, z : ndarray
        Places [m], z not negative, of one shape.
    radius : float
        Of the disc [m].
    """
    if radius == 0.0:
        return np.zeros(np.shape(r))
    # theta = 2/pi arccot(zeta), zeta the oblate coordinate; both formulas of it, so that no digits are lost
    beyond = (r - radius) * (r + radius) + z**2
    root = np.hypot(beyond, 2.0 * radius * z)
    outside = beyond > 0.0
    inner = 2.0 * (radius * z) ** 2 / np.where(outside, 1.0, np.where(root > beyond, root - beyond, 1.0))
    square = np.where(outside, 0.5 * (beyond + root), inner)
    return np.asarray(2.0 / np.pi * np.arctan2(radius, np.sqrt(square)))


def disc_slopes(r: Array, z: Array, radius: float) -> tuple[Array, Array]:
    """Return the slopes of theta along r and z [1/m]; infinite at the edge of the disc."""
    if radius == 0.0:
        return np.zeros(np.shape(r)), np.zeros(np.shape(r))
    # the imaginary part is held below zero, also on the surface: this side of the cut is the body
    square = (r - radius) * (r + radius) + z**2 - 2j * radius * np.maximum(z, np.finfo(float).tiny)
    root = np.sqrt(square)
    edge = np.abs(root) < 1e-150
    root = np.where(edge, 1.0, root)
    down = -2.0 / np.pi * np.imag(1.0 / root)
    axis = r == 0.0
    out = -2.0 / np.pi * np.imag(1.0 - (z - 1j * radius) / root) / np.where(axis, 1.0, r)
    # on the surface nothing passes beside the disc, and nothing flows along it
    surface = z == 0.0
    out = np.where(axis | (surface & (r < radius)), 0.0, out)
    down = np.where(surface & (r > radius), 0.0, down)
    return np.where(edge, -np.inf, out), np.where(edge, -np.inf, down)
