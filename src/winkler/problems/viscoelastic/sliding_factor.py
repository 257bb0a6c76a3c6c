r"""How much of the sliding resistance of a line of relaxing springs a body in three dimensions has.

A pressure that moves along a surface at the speed v is a sum of waves in all directions; one with the wave number k
in the direction :math:`\varphi` shakes the body with the frequency :math:`v k\cos\varphi`.  For a pressure of
revolution, whose transform is that of its line load,

.. math:: F_x = \frac1\pi\int_0^\infty k\,|\hat q(k)|^2\,\bar J''(vk)\,\mathrm dk , \qquad
          \bar J''(\omega) = \frac2\pi\int_0^{\pi/2}\cos\varphi\;J''(\omega\cos\varphi)\,\mathrm d\varphi .

On the line all waves go straight ahead and :math:`J''` itself stands there.  For a retardation time :math:`\lambda`
and :math:`w=\omega\lambda` that is :math:`(1-1/\sqrt{1+w^2})/w` against :math:`w/(1+w^2)`: half of it when slow, all of
it when fast.
"""

from __future__ import annotations

import functools

import numpy as np

from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.springs.exponential_sums import CreepSeries
from winkler.numerics.types import Array

__all__ = ["share_of_line"]

LINE_PIECES = 256
"""Straight pieces that stand for a load."""
LEAST_WAVE_NUMBER = 1e-9
"""Least wave number, times half of the width."""
GREATEST_WAVE_NUMBER = 200.0
"""Greatest one: a load that ends straight has |q^|^2 ~ k^-4."""


@functools.lru_cache(maxsize=1)
def _waves() -> tuple[Array, Array, Array]:
    """Return wave numbers, their weights, and what every corner of a load between -1 and 1 gives to them."""
    corner = np.linspace(-1.0, 1.0, LINE_PIECES + 1)
    edges = np.concatenate([np.geomspace(LEAST_WAVE_NUMBER, 1.0, 37), np.arange(3.0, GREATEST_WAVE_NUMBER + 1.0, 2.0)])
    node, share = gauss_legendre(8)
    middle, half = 0.5 * (edges[1:] + edges[:-1]), 0.5 * np.diff(edges)
    number = (middle[:, None] + half[:, None] * node).ravel()
    # a load that is straight between corners is a sum of hats, all with the same transform but for their place
    step = 2.0 / LINE_PIECES
    hat = step * np.sinc(number * step / (2.0 * np.pi)) ** 2
    angle = number[:, None] * corner
    return number, (half[:, None] * share).ravel() * hat**2, np.stack([np.cos(angle), np.sin(angle)])


def share_of_line(creep: CreepSeries, speed: float, position: Array, loads: Array) -> float:
    """Return the resistance of the body over that of the line [-], between 1/2 and 1.

    Parameters
    ----------
    creep : CreepSeries
        1/E* as it grows [1/Pa].
    speed : float
        v [m/s].
    position, loads : ndarray, (n,)
        x [m], ascending from edge to edge, and q [N/m] there.
    """
    number, weight, turns = _waves()
    half = 0.5 * float(position[-1] - position[0])
    load = np.interp(np.linspace(position[0], position[-1], LINE_PIECES + 1), position, loads)
    energy = np.sum((turns @ load) ** 2, axis=0) * weight
    turn = number[:, None] * (speed / half) * creep.times
    root = np.sqrt(1.0 + turn * turn)
    # k J'' of both, but for v; 1 - 1/root without cancelling
    ahead = (turn * turn / (1.0 + turn * turn)) @ (creep.compliances / creep.times)
    around = (turn * turn / (root * (1.0 + root))) @ (creep.compliances / creep.times)
    return float(energy @ (around + creep.fluidity) / (energy @ (ahead + creep.fluidity)))
