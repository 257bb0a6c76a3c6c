r"""Flat punches of all half-widths where M falls like 1 / xi: the equation of their loads on a half-plane.

What the layers add to the load profile of a half-plane leads to Fredholm's equation of the second kind for :math:`\psi`
of `winkler.numerics.transforms.strips.strip_punches`,

.. math:: \psi(c;a) + \int_0^a N(c,t)\,\psi(t;a)\,\mathrm dt = N(c,a) , \qquad
          N(c,t) = c\int_0^\infty M\,k\,J_1(kc)\,J_1(kt)\,\mathrm dk ,

.. math:: \varphi(a;a) = 1 + g(a) - \int_0^a\frac at\,\psi(t;a)\,(1+g(t))\,\mathrm dt , \qquad
          g(c) = c\int_0^\infty M\,J_1(kc)\,\mathrm dk .

With :math:`M\approx A/k+B/k^2` N has a logarithm at t = c, of which the complete elliptic integrals are the whole,

.. math:: \int_0^\infty J_1(kc)\,J_1(kt)\,\mathrm dk = \frac2{\pi t}\,\big[K-E\big]\!\big(\tfrac tc\big) , \qquad
          \int_0^\infty \frac{J_1(kc)\,J_1(kt)}k\,\mathrm dk = \frac t{2c} , \qquad t \le c .

Both parts are integrated on panels with the polynomials of their nodes once for all half-widths; the waves of the rest
die out.  Panels halve towards the edge, where :math:`\psi` has a logarithm, too; all is even in the places.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.caching import cached_by_value
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.transforms.cosine_transform import WaveResponse, on_axis, sine_transform, wave_numbers
from winkler.numerics.types import Array

__all__ = ["PANEL_NODES", "tail_panels", "tail_punch"]

PANEL_NODES = 10
WIDEST_PANEL = 2.0
"""Of panels inside, in lengths over which the kernel is smooth."""
HALVINGS = 16
LAST_WAVE_NUMBER = 30.0
"""Up to which the rest is summed, times the length over which the kernel is smooth."""
SERIES, ROUNDED = (50.0, 800.0), 0.02
"""Wave numbers between which A and B are read, times that length, and the greatest over that of rounding."""
SERIES_TERMS, SERIES_PLACES = 4, 12
PHASE = 6.0
"""Of a wave to the edge over one panel of wave numbers."""
SPLIT_NODES, SPLIT_POWER = 40, 5
"""On both sides of a place at which a kernel is not smooth, and the power in which the distance grows."""
ANGLES, ANGLE_POWER = 64, 3


class _EdgePanels(NamedTuple):
    """Places over the half-width at nodes of the panels, weights of y = x^2, and matrices of A and B."""

    places: Array
    weights: Array
    logarithm: Array
    straight: Array


def tail_panels(response: WaveResponse, high: float) -> Array:
    """Return panels of y = (t/a)^2 for half-widths up to `high`, in the unit of a response: halving to the edge."""
    return _panels(_inside(response, high))


def _inside(response: WaveResponse, high: float) -> int:
    return max(2, math.ceil(high / (WIDEST_PANEL * response.smooth)))


def _panels(count: int) -> Array:
    inside = np.arange(count) / count
    near = 1.0 - 0.5 ** np.arange(1.0, HALVINGS + 1.0) / count
    return np.asarray(np.append(np.concatenate([inside, near]), 1.0) ** 2)


@functools.lru_cache(maxsize=8)
def _grid(count: int) -> _EdgePanels:
    panels = _panels(count)
    nodes, weights = gauss_legendre(PANEL_NODES)
    y = panels[:-1, None] + np.diff(panels)[:, None] * nodes
    places = np.sqrt(y.ravel())
    to_series = np.linalg.inv(np.polynomial.chebyshev.chebvander(2.0 * nodes - 1.0, PANEL_NODES - 1))
    shares, rule = gauss_legendre(SPLIT_NODES)
    near, rule = shares**SPLIT_POWER, rule * SPLIT_POWER * shares ** (SPLIT_POWER - 1)
    matrices = np.empty((2, places.size, places.size))
    for panel, (low, high) in enumerate(zip(panels[:-1], panels[1:], strict=True)):
        start, stop = math.sqrt(low), math.sqrt(high)
        split = np.clip(places, start, stop)[:, None]
        t = np.concatenate([split + (start - split) * near, split + (stop - split) * near], axis=1)
        step = np.concatenate([(split - start) * rule, (stop - split) * rule], axis=1)
        basis = np.polynomial.chebyshev.chebvander((2.0 * t * t - low - high) / (high - low), PANEL_NODES - 1)
        columns = slice(panel * PANEL_NODES, (panel + 1) * PANEL_NODES)
        for matrix, kernel in zip(matrices, _kernels(places[:, None], np.maximum(t, 1e-300)), strict=True):
            matrix[:, columns] = np.einsum("ij,ijk->ik", step * kernel, basis) @ to_series
    return _EdgePanels(places, (np.diff(panels)[:, None] * weights).ravel(), *matrices)


def _kernels(c: Array, t: Array) -> tuple[Array, Array]:
    """Return c times the integrals of the module, over places c and t."""
    from scipy.special import ellipe, ellipkm1

    inner, outer = np.minimum(c, t), np.maximum(c, t)
    beside = np.maximum((outer - inner) * (outer + inner) / outer**2, 1e-300)
    ratio = 1.0 - beside
    # K - E = (pi/4) m (1 + 3 m / 8 + ...) cancels where one of them is close to the middle
    small = math.pi / 4.0 * ratio * (1.0 + ratio * (3.0 / 8.0 + ratio * 15.0 / 64.0))
    whole = np.where(ratio < 1e-4, small, ellipkm1(beside) - ellipe(ratio))
    return 2.0 / math.pi * c / inner * whole, 0.5 * c * inner / outer


@cached_by_value(64)
def _series(response: WaveResponse) -> tuple[float, float]:
    """Return A [1/m] and B [1/m^2]: M is A / k + B / k^2 and a rest that dies out sooner."""
    last = min(SERIES[1] / response.smooth, ROUNDED / response.length)
    k = np.geomspace(last * SERIES[0] / SERIES[1], last, SERIES_PLACES)
    powers = np.vander(k[0] / k, SERIES_TERMS, increasing=True)
    found = np.linalg.lstsq(powers, k * np.real(response.excess(k)), rcond=None)[0]
    return float(found[0]), float(found[1] * k[0])


@cached_by_value(8)
def _waves(response: WaveResponse, high: float) -> tuple[Array, Array, Array]:
    """Return arguments ka, their weights, and J_1 of them times places over half-widths, and at the edge."""
    from scipy.special import j1

    places = np.append(_grid(_inside(response, high)).places, 1.0)
    argument, weights = wave_numbers(0.25 * high / response.span, PHASE, LAST_WAVE_NUMBER * high / response.smooth)
    return argument, weights, j1(np.outer(places, argument))


def tail_punch(response: WaveResponse, a: float, high: float) -> tuple[float, Array]:
    """Return phi(a; a) and a psi(t; a) at the nodes of the panels for half-widths up to `high`.

    Parameters
    ----------
    response : WaveResponse
        In its own unit of length.
    a, high : float
        The half-width, and the greatest one for which the panels are the same.
    """
    grid, (first, second) = _grid(_inside(response, high)), _series(response)
    argument, weights, waves = _waves(response, high)
    k = argument / a
    rest = weights * (argument * on_axis(response, k) - a * first - a * second / k)
    coupled = (waves * rest) @ waves.T
    x = grid.places
    matrix = a * first * grid.logarithm + a * a * second * grid.straight
    matrix += x[:, None] * coupled[:-1, :-1] * (0.5 * grid.weights / x)
    logarithm, straight = _kernels(x, np.ones(x.size))
    right = a * first * logarithm + a * a * second * straight + x * coupled[:-1, -1]
    psi = np.linalg.solve(np.eye(x.size) + matrix, right)
    borne = 1.0 + _turned(response, a * np.append(x, 1.0))
    return float(borne[-1] - (0.5 * grid.weights / x**2) @ (psi * borne[:-1])), psi


def _turned(response: WaveResponse, c: Array) -> Array:
    """Return g(c) [-]: x over the root of c^2 - x^2 times the transform of sines, on [0, c]."""
    share, weight = gauss_legendre(ANGLES)
    angle = 0.5 * math.pi * share**ANGLE_POWER
    weight = 0.5 * math.pi * ANGLE_POWER * share ** (ANGLE_POWER - 1) * weight
    felt = sine_transform(response, float(np.max(c)))(np.outer(c, np.sin(angle)))
    return np.asarray(c * (felt @ (weight * np.sin(angle))))
