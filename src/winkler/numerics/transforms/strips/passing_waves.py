r"""A parabola that passes steadily over bodies which answer each wave of pressure in a manner of their own.

With lengths over the half-length a of the strip, :math:`p=\sqrt{1-t^2}\sum_{n\ge1}g_nU_{n-1}(t)` and the response
:math:`c(\kappa)` to waves :math:`e^{i\kappa t}` that travel with the strip, complex where the bodies relax, the slope
of the surface has the Chebyshev coefficients

.. math:: 2c_\infty g_m + 4\sum_n n\,g_n\,\mathrm{Re}\,i^{m-n}\!\int_0^\infty\!(c-c_\infty)\,J_n(\kappa)J_m(\kappa)
          \,\frac{\mathrm d\kappa}\kappa = \delta_{m1} , \qquad m\ge1 ,

and half of the same sum at m = 0 is the place of the middle, because

.. math:: \int\!\sqrt{1-t^2}\,U_{n-1}\,e^{-i\kappa t}\,\mathrm dt = \frac{\pi n}\kappa\,i^{1-n}J_n(\kappa) , \qquad
          \frac2\pi\int\frac{T_m\,e^{i\kappa t}}{\sqrt{1-t^2}}\,\mathrm dt = 2i^mJ_m(\kappa) .
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.chunks import chunks
from winkler.numerics.transforms.cosine_transform import wave_numbers
from winkler.numerics.types import Array, ComplexArray
from winkler.values.errors import NotConverged

LONGEST, LARGEST_PHASE = 1e-8, 6.0
"""First panel of waves, and the width of panels: products of Bessel functions turn twice as fast."""
SHORTEST = 1e12
"""A wave that stands for those without length."""
FEWEST_WAVES, MOST_WAVES = 200.0, 3e4
SETTLED = 0.02
"""How far the response of the shortest waves that are summed is from its limit, over that; what they lack falls as the
third power of their number."""
SAMPLES = 400
FEWEST, MOST = 24, 768
VANISHED, WAVES_PER_MODE = 1e-6, 36.0
"""Last modes over the greatest, and as many waves as keep the ones left out from adding as much to them."""
ENTRIES, MARGIN = 4_000_000, 20


class PassingModes(NamedTuple):
    """The pressure g_1, g_2, ... over the slope at the edge, and the place of the middle over a."""

    modes: Array
    middle: float

    def waves(self, count: int | None = None) -> Array:
        """Return g_1, g_2, ..., so many, or all that matter."""
        return self.modes[:count]


def passing_modes(response: Callable[[Array], ComplexArray]) -> PassingModes | None:
    """Return the strip under t^2 / 2; None where its waves are too many.

    Parameters
    ----------
    response : callable
        c(kappa) of waves that travel with the strip towards +t ``(m,)``.

    Raises
    ------
    NotConverged
        If the modes do not fall off.
    """
    local = float(response(np.array([SHORTEST]))[0].real)
    sampled = np.geomspace(FEWEST_WAVES, SHORTEST, SAMPLES)
    unsettled = np.flatnonzero(np.abs(response(sampled) - local) > SETTLED * local)
    end = float(sampled[unsettled[-1] + 1]) if unsettled.size else FEWEST_WAVES
    if end > MOST_WAVES:
        return None
    count = FEWEST
    while count <= MOST:
        kappa, weights = wave_numbers(LONGEST, LARGEST_PHASE, max(end, WAVES_PER_MODE * count))
        matrix = _slopes(count, kappa, weights / kappa * (response(kappa) - local))
        system = matrix[1:] + 2.0 * local * np.eye(count)
        modes = np.linalg.solve(system, np.eye(count)[0])
        if np.max(np.abs(modes[-4:])) <= VANISHED * np.max(np.abs(modes)):
            return PassingModes(modes, float(0.5 * matrix[0] @ modes))
        count *= 2
    raise NotConverged(f"The pressure of a strip that passes is no sum of {MOST} modes; pass faster, or press more.")


def _slopes(count: int, kappa: Array, response: ComplexArray) -> Array:
    """Return 4 n Re i^(m-n) times the sums of the response and J_n J_m, ``(1 + count, count)``, m from 0 on."""
    real, imaginary = np.zeros((2, count + 1, count + 1))  # m - n even, and odd
    for part in chunks(kappa.size, count + 1, ENTRIES):
        rows = _bessel(count, kappa[part])
        even, odd = rows[::2], rows[1::2]
        real[::2, ::2] += (even * response[part].real) @ even.T
        real[1::2, 1::2] += (odd * response[part].real) @ odd.T
        imaginary[::2, 1::2] += (even * response[part].imag) @ odd.T
    imaginary[1::2, ::2] = imaginary[::2, 1::2].T
    m, n = np.arange(count + 1)[:, None], np.arange(1, count + 1)
    turn = 1j ** ((m - n) % 4)
    return np.asarray(4.0 * n * (turn.real * real[:, 1:] - turn.imag * imaginary[:, 1:]))


def _bessel(count: int, kappa: Array) -> Array:
    """Return J_0 ... J_count ``(count + 1, k)`` to about 1e-15.

    By recurrence where the argument is greater than the order, elsewhere by the midpoint rule for Bessel's integral.
    """
    from scipy.special import j0, j1

    rows, orders = np.empty((count + 1, kappa.size)), np.arange(count + 1.0)
    small, points = kappa <= count, count + MARGIN
    angle = 0.5 * np.pi * (np.arange(points) + 0.5) / points
    turns = np.outer(np.sin(angle), kappa[small])
    rows[::2, small] = np.cos(np.outer(orders[::2], angle)) @ np.cos(turns) / points
    rows[1::2, small] = np.sin(np.outer(orders[1::2], angle)) @ np.sin(turns) / points
    x = kappa[~small]
    before, now = j0(x), j1(x)
    for order in range(count + 1):
        rows[order, ~small] = before
        before, now = now, 2.0 * (order + 1.0) / x * now - before
    return rows
