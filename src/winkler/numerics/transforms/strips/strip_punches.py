r"""Flat punches of all half-widths on layers, as piles of flat punches on a half-plane.

A flat punch of the half-width a that bears a load of one on layers presses as those of all half-widths t up to a do on
a half-plane, :math:`\varphi(a;a)` of its load at its own edge.  With
:math:`\partial\varphi(t;a)/\partial a=-\psi(t;a)\,\varphi(a;a)` a contact presses like the loads q on a half-plane, and
a body with the load profile w on a half-plane has the one W on layers,

.. math:: q(t) = \varphi(t;t)\,v(t) - \int_t^\infty\psi(t;c)\,\varphi(c;c)\,v(c)\,\mathrm dc , \qquad
          \varphi(a;a)\,W(a) = w(a) - a\int_0^a\psi(t;a)\,w(t)\,\frac{\mathrm dt}t ,

v the load beyond W.  Both kernels are one, by reciprocity, as those of round punches are
(`winkler.numerics.transforms.fredholm`).  With the modes of `winkler.numerics.transforms.strips.strip_equation`, whose
matrix is :math:`I+B`,

.. math:: \psi(t;a) = -\frac ta\sum_m y_m\int_0^\infty M\,J_{2m}(ka)\,J_1(kt)\,\mathrm dk , \qquad
          (I+B)^{\mathsf T}\,\frac{s_m y_m}{4m} = 1 .

Where M falls like 1 / xi the modes do not end, and :math:`\psi` has a logarithm at the edge: both follow from an
equation of their own.  :math:`a\psi` is even in t/a, and is read from series in a and in (t/a)^2.

Flat punches of all half-widths where M falls like 1 / xi: the equation of their loads on a half-plane.

What the layers add to the load profile of a half-plane leads to Fredholm's equation of the second kind for
:math:`\psi`,

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
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.numerics.caching import cached_by_value
from winkler.numerics.chunks import chunks
from winkler.numerics.integrals.quadrature import gauss_legendre, panel_nodes
from winkler.numerics.transforms.cosine_transform import (
    WaveResponse,
    has_tail,
    in_own_lengths,
    on_axis,
    sine_transform,
    wave_numbers,
)
from winkler.numerics.transforms.kernel_matrix import legendre_to_chebyshev
from winkler.numerics.transforms.strips.strip_equation import MOST_MODES, first_modes, punch_modes, waves
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

WIDTHS_PER_OCTAVE = 20
"""Half-widths of an octave at which the equation is solved."""
LOWEST, LOWEST_OF_TAIL, HIGHEST_OF_TAIL = -1, -6, 7
"""Octave of the thickness that reaches down to zero: a power series holds there.  Where M falls like 1 / xi, octaves of
the length over which moduli change: there a half-width times its logarithm is left, and the widest."""
FEWER_WIDTHS = 12
"""The same where M falls like 1 / xi."""
BEYOND = 8
"""Terms of the series in t/a beyond the modes."""
ENTRIES = 4_000_000


class StripPunches(NamedTuple):
    """Flat punches with half-widths from `low` to `high` [m], as Chebyshev series in a.

    `edge` holds phi(a; a); `psi` a times psi, on panels of (t/a)^2, as series in that, its last index.
    """

    low: float
    high: float
    edge: Array
    panels: Array
    psi: Array


def _grouped(response: WaveResponse, a: Array) -> Iterator[tuple[Array, StripPunches, Array]]:
    """Yield indices, their table and the variable of its series from -1 to 1."""
    own, unit = in_own_lengths(response)
    lowest = LOWEST_OF_TAIL if has_tail(own) else LOWEST
    with np.errstate(divide="ignore"):
        octaves = np.maximum(np.ceil(np.log2(a / (unit * own.smooth))), lowest)
    for octave in np.unique(octaves):
        (members,) = np.nonzero(octaves == octave)
        table = _punches(own, int(octave))
        yield members, table, (2.0 * a[members] / unit - table.low - table.high) / (table.high - table.low)


def edge(response: WaveResponse, a: Array) -> Array:
    """Return phi(a; a) [-], of half-widths [m] ``(m,)``."""
    result = np.empty(a.size)
    for members, table, s in _grouped(response, a):
        result[members] = np.polynomial.chebyshev.chebval(s, table.edge)
    return result


def kernel(response: WaveResponse, t: Array, a: Array) -> Array:
    """Return a psi(t; a) [-] for all places t ``(n,)`` and half-widths a ``(m,)`` [m], ``(m, n)``; zero where t > a."""
    result = np.zeros((a.size, t.size))
    for members, table, s in _grouped(response, a):
        rows = np.tensordot(np.polynomial.chebyshev.chebvander(s, table.psi.shape[0] - 1), table.psi, 1)
        for part in chunks(members.size, t.size, ENTRIES):
            widths = np.where(a[members[part]] > 0.0, a[members[part]], 1.0)[:, None]
            square = np.minimum(t / widths, 1.0) ** 2
            panel = np.searchsorted(table.panels[1:-1], square, side="right")
            start, stop = table.panels[panel], table.panels[panel + 1]
            twice = 2.0 * (2.0 * square - start - stop) / (stop - start)
            last, current = np.zeros(twice.shape), np.zeros(twice.shape)
            for series in np.moveaxis(rows[part], -1, 0)[:0:-1]:
                last, current = current, np.take_along_axis(series, panel, 1) + twice * current - last
            first = np.take_along_axis(rows[part, :, 0], panel, 1)
            found = first + 0.5 * twice * current - last
            result[members[part]] = np.where(t <= a[members[part]][:, None], found, 0.0)
    return result


def _of_tail(response: WaveResponse, octave: int, half_width: Array) -> tuple[Array, Array, Array]:
    """Return phi(a; a), panels and a psi of half-widths where M falls like 1 / xi."""
    high = response.smooth * 2.0**octave
    if octave > HIGHEST_OF_TAIL:
        raise NotConverged(
            f"Flat strips {2.0**octave:.3g} times as wide as the length over which moduli change are not resolved, "
            f"{2.0**HIGHEST_OF_TAIL:.0f} times at most. Press less, or give a CoatedHalfSpace of layers that follow "
            "the grading."
        )
    edges, values = zip(*(tail_punch(response, float(a), high) for a in half_width), strict=True)
    panels = tail_panels(response, high)
    psi = np.array(values).reshape(half_width.size, panels.size - 1, PANEL_NODES) @ legendre_to_chebyshev(PANEL_NODES).T
    return np.array(edges), panels, psi


@cached_by_value(64)
def _punches(response: WaveResponse, octave: int) -> StripPunches:
    """Return the table of one octave of half-widths, in units of a response of its own length."""
    lowest, count = (LOWEST_OF_TAIL, FEWER_WIDTHS) if has_tail(response) else (LOWEST, WIDTHS_PER_OCTAVE)
    high = response.smooth * 2.0**octave
    low = 0.0 if octave == lowest else 0.5 * high
    nodes = np.polynomial.chebyshev.chebpts1(count)
    half_width = 0.5 * (low + high) + 0.5 * (high - low) * nodes
    found = (_of_tail if has_tail(response) else _of_modes)(response, octave, half_width)
    to_series = np.linalg.inv(np.polynomial.chebyshev.chebvander(nodes, count - 1))
    return StripPunches(low, high, to_series @ found[0], found[1], np.tensordot(to_series, found[2], 1))


def _of_modes(response: WaveResponse, octave: int, half_width: Array) -> tuple[Array, Array, Array]:
    """Return phi(a; a), panels and a psi of half-widths where M dies out like an exponential."""
    from scipy.special import j1

    found, count = waves(response, octave), first_modes(octave)
    modes = punch_modes(found, half_width, count, octave)
    while not modes.settled:
        if count >= MOST_MODES:
            raise NotConverged(
                f"A flat strip {2.0**octave:.3g} times as wide as the layer is thick is not resolved by "
                f"{MOST_MODES} modes; press less, or give a thicker layer."
            )
        count = min(2 * count, MOST_MODES)
        modes = punch_modes(found, half_width, count, octave)
    terms = count + BEYOND
    angle = 0.5 * np.pi * (np.arange(terms) + 0.5) / terms
    ratio = np.cos(angle)
    turned = np.stack([(row * found.weights * found.k) @ j1(np.outer(found.k, a * ratio))
                       for row, a in zip(modes.adjoint, half_width, strict=True)])  # fmt: skip
    series = 2.0 / terms * (-ratio * half_width[:, None] * turned) @ np.cos(2.0 * np.outer(angle, np.arange(terms)))
    series[:, 0] *= 0.5
    return modes.edge, np.array([0.0, 1.0]), series[:, None]


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
    y, weights = panel_nodes(panels, PANEL_NODES)
    places, to_series = np.sqrt(y), legendre_to_chebyshev(PANEL_NODES)
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
    return _EdgePanels(places, weights, *matrices)


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
