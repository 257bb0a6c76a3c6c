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
equation of their own (`winkler.numerics.transforms.strips.strip_tail`).  :math:`a\psi` is even in t/a, and is read from
series in a and in (t/a)^2.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.numerics.caching import cached_by_value
from winkler.numerics.chunks import chunks
from winkler.numerics.transforms.cosine_transform import WaveResponse, has_tail, in_own_lengths
from winkler.numerics.transforms.kernel_matrix import legendre_to_chebyshev
from winkler.numerics.transforms.strips.strip_equation import MOST_MODES, first_modes, punch_modes, waves
from winkler.numerics.transforms.strips.strip_tail import PANEL_NODES, tail_panels, tail_punch
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

__all__ = ["edge", "kernel"]

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
