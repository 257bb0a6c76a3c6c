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

:math:`a\psi` is even in t/a, and is read from series in a and in t/a.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.errors import NotConverged
from winkler.numerics.caching import cached_by_value
from winkler.numerics.transforms.cosine_transform import WaveResponse, in_own_lengths
from winkler.numerics.transforms.strips.strip_equation import MOST_MODES, first_modes, punch_modes, waves
from winkler.numerics.types import Array

__all__ = ["edge", "kernel"]

WIDTHS_PER_OCTAVE = 20
"""Half-widths of an octave at which the equation is solved."""
LOWEST = -1
"""Octave of the thickness that reaches down to zero: a power series holds there."""
BEYOND = 8
"""Terms of the series in t/a beyond the modes."""


class StripPunches(NamedTuple):
    """Flat punches with half-widths from `low` to `high` [m], as Chebyshev series in a.

    `edge` holds phi(a; a); `psi` a times psi, in even Chebyshev polynomials of t/a, its second index.
    """

    low: float
    high: float
    edge: Array
    psi: Array


def _grouped(response: WaveResponse, a: Array) -> Iterator[tuple[Array, StripPunches, Array]]:
    """Yield indices, their table and the Chebyshev polynomials of its series ``(m, n)``."""
    own, unit = in_own_lengths(response)
    with np.errstate(divide="ignore"):
        octaves = np.maximum(np.ceil(np.log2(a / (unit * own.length))), LOWEST)
    for octave in np.unique(octaves):
        (members,) = np.nonzero(octaves == octave)
        table = _punches(own, int(octave))
        s = (2.0 * a[members] / unit - table.low - table.high) / (table.high - table.low)
        yield members, table, np.polynomial.chebyshev.chebvander(s, WIDTHS_PER_OCTAVE - 1)


def edge(response: WaveResponse, a: Array) -> Array:
    """Return phi(a; a) [-], of half-widths [m] ``(m,)``."""
    result = np.empty(a.size)
    for members, table, powers in _grouped(response, a):
        result[members] = powers @ table.edge
    return result


def kernel(response: WaveResponse, t: Array, a: Array) -> Array:
    """Return a psi(t; a) [-] for all places t ``(n,)`` and half-widths a ``(m,)`` [m], ``(m, n)``; zero where t > a."""
    result = np.zeros((a.size, t.size))
    for members, table, powers in _grouped(response, a):
        widths = np.where(a[members] > 0.0, a[members], 1.0)[:, None]
        twice = 4.0 * np.minimum(t / widths, 1.0) ** 2 - 2.0  # 2 T_2
        rows = powers @ table.psi
        last, current = np.zeros(twice.shape), np.zeros(twice.shape)
        for row in rows.T[:0:-1]:
            last, current = current, row[:, None] + twice * current - last
        result[members] = np.where(t <= a[members][:, None], rows[:, :1] + 0.5 * twice * current - last, 0.0)
    return result


@cached_by_value(64)
def _punches(response: WaveResponse, octave: int) -> StripPunches:
    """Return the table of one octave of half-widths, in units of a response of its own length."""
    from scipy.special import j1

    high = response.length * 2.0**octave
    low = 0.0 if octave == LOWEST else 0.5 * high
    nodes = np.polynomial.chebyshev.chebpts1(WIDTHS_PER_OCTAVE)
    half_width = 0.5 * (low + high) + 0.5 * (high - low) * nodes
    found, count = waves(response, octave), first_modes(octave)
    modes = punch_modes(found, half_width, count, octave)
    while not modes.settled:
        if count >= MOST_MODES:
            raise NotConverged(
                f"A flat strip {high / response.length:.3g} times as wide as the layer is thick is not resolved by "
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
    to_series = np.linalg.inv(np.polynomial.chebyshev.chebvander(nodes, WIDTHS_PER_OCTAVE - 1))
    return StripPunches(low, high, to_series @ modes.edge, to_series @ series)
