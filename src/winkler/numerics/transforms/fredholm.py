r"""Flat punches of all radii at once: Krein's method for a Fredholm equation.

A flat punch of radius a on a medium with the response M presses with the line load :math:`E^*\varphi(x;a)`,

.. math:: \varphi(x) + \int_0^a K(x,t)\,\varphi(t)\,\mathrm dt = 1, \qquad
          K(x,t) = \tfrac12\,[C(x-t) + C(x+t)] .

The same equation with the right-hand side :math:`K(x,a)` has the solution :math:`\rho(x;a)`, and both operators
fall apart into triangles, :math:`(I+K)^{-1} = (I-R^{\mathsf T})(I-R)`: a body whose homogeneous transform is h gives

.. math:: w(a) = h(a) - \int_0^a \rho(x;a)\,h(x)\,\mathrm dx , \qquad
          \varphi_h(x;a) = w(x) - \int_x^a \rho(x;t)\,w(t)\,\mathrm dt .

The pressure of the punch is T4 of its line load,

.. math:: p_1(r;a) = \frac{E^*}{\pi}\,\frac{\sigma(r;a)}{\sqrt{a^2-r^2}} , \qquad
          \sigma(r;a) = \varphi(a;a) - \sqrt{a^2-r^2}\int_r^a\frac{\varphi'(x;a)}{\sqrt{x^2-r^2}}\,\mathrm dx ,

with a smooth :math:`\sigma`.  So :math:`\varphi`, :math:`\rho` and :math:`\sigma` depend on the medium alone, and are
read from tables (`winkler.numerics.transforms.punch_tables`).

References
----------
.. [1] I. C. Gohberg, M. G. Krein, Theory and Applications of Volterra Operators in Hilbert Space, AMS 1970, ch. IV.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from winkler.numerics.transforms.cosine_transform import WaveResponse
from winkler.numerics.transforms.punch_tables import Punches, octave_of, tables
from winkler.numerics.types import Array

POINTS_PER_BLOCK = 4096
"""Places at which a series is summed at once: what fits into a processor's cache."""


def _grouped(response: WaveResponse, a: Array) -> Iterator[tuple[Array, Punches, Array]]:
    """Yield indices, their table and the variable of its series from -1 to 1."""
    octaves = np.maximum(octave_of(response, a), 0)
    for octave in np.unique(octaves):
        (members,) = np.nonzero(octaves == octave)
        octave_tables = tables(response, int(octave))
        which = np.searchsorted([table.high for table in octave_tables[:-1]], a[members])
        for index, table in enumerate(octave_tables):
            chosen = members[which == index]
            if chosen.size:
                yield chosen, table, (2.0 * a[chosen] - table.low - table.high) / (table.high - table.low)


def _series(response: WaveResponse, a: Array, part: str, derivative: bool = False) -> Array:
    a = np.asarray(a, dtype=float)
    flat, result = a.ravel(), np.empty(a.size)
    for chosen, table, s in _grouped(response, flat):
        series = getattr(table, part)
        if derivative:
            series = np.polynomial.chebyshev.chebder(series) * (2.0 / (table.high - table.low))
        result[chosen] = np.polynomial.chebyshev.chebval(s, series)
    return result.reshape(a.shape)


def area(response: WaveResponse, a: Array) -> Array:
    """Return the integral of phi(x; a) over x from 0 to a [m]: the stiffness of a flat punch is 2 E* times that."""
    return np.asarray(a) * mean(response, a)


def mean(response: WaveResponse, a: Array) -> Array:
    """Return the mean of phi(x; a) over x from 0 to a [-]."""
    return _series(response, a, "area")


def edge(response: WaveResponse, a: Array) -> Array:
    """Return phi(a; a) [-]: the springs are E* phi(a; a)^2 per length."""
    return _series(response, a, "edge")


def edge_slope(response: WaveResponse, a: Array) -> Array:
    """Return d phi(a; a) / da [1/m]."""
    return _series(response, a, "edge", derivative=True)


class Pairs(NamedTuple):
    """A function of x and a: its value, its derivative by a at fixed x/a, and its derivative by x."""

    value: Array
    along: Array
    across: Array


def resolvent(response: WaveResponse, x: Array, a: Array) -> Pairs:
    """Return rho(x; a) [1/m] and its derivatives [1/m^2], for 0 <= x <= a of one shape."""
    x, a = np.broadcast_arrays(np.asarray(x, dtype=float), np.asarray(a, dtype=float))
    scale = np.where(a > 0.0, a, 1.0)
    moment, by_a, by_ratio = (
        item.reshape(x.shape) for item in _table(response, x.ravel(), a.ravel(), "rho", True)
    )  # tabulated is a rho
    value = moment / scale
    return Pairs(value, (by_a - value) / scale, by_ratio / scale**2)


def moment(response: WaveResponse, x: Array, a: Array) -> Array:
    """Return a rho(x; a) [-], for 0 <= x <= a of one shape: `resolvent` without derivatives."""
    return _value(response, x, a, "rho")


def moments(response: WaveResponse, x: Array, a: Array) -> Array:
    """Return a rho(x; a) [-] for all places x ``(n,)`` and radii a ``(m,)``, ``(m, n)``; zero where x > a.

    Much faster than `moment` on all pairs: the series in a is summed once for each radius.
    """
    cheb = np.polynomial.chebyshev
    result = np.zeros((a.size, x.size))
    for chosen, table, s in _grouped(response, a):
        rows = np.tensordot(cheb.chebvander(s, table.rho.shape[0] - 1), table.rho, 1)
        for row, member in enumerate(chosen):
            ratio = x[x <= a[member]] / (a[member] or 1.0)
            borders = np.searchsorted(ratio, table.panels[1:-1])
            parts = zip(np.split(ratio, borders), table.panels[:-1], table.panels[1:], rows[row], strict=True)
            result[member, : ratio.size] = np.concatenate(
                [cheb.chebval((2.0 * part - low - high) / (high - low), series) for part, low, high, series in parts]
            )
    return result


def punches(response: WaveResponse, x: Array, a: Array) -> Array:
    """Return phi(x; a) [-], for 0 <= x <= a of one shape."""
    return _value(response, x, a, "phi")


def push(response: WaveResponse, r: Array, a: Array) -> Array:
    """Return sigma(r; a) = pi sqrt(a^2 - r^2) p1(r; a) / E* [-], for 0 <= r <= a of one shape."""
    return _value(response, r, a, "push")


def on_pieces(response: WaveResponse, a: Array, ratio: Array, low: Array, high: Array) -> Array:
    """Return a rho(x; a), its derivative by a at fixed x/a [1/m], and phi(x; a), many places of each radius at once.

    Parameters
    ----------
    response : WaveResponse
    a : ndarray, (m,)
        Radii [m], positive.
    ratio : ndarray, (m, q, n)
        x/a, on q pieces of which none reaches across a panel of the tables.
    low, high : ndarray, (m, q)
        Ends of the pieces, as x/a.

    Returns
    -------
    ndarray, (3, m, q, n)
    """
    cheb = np.polynomial.chebyshev
    result = np.empty((3, *ratio.shape))
    for members, table, s in _grouped(response, a):
        powers = cheb.chebvander(s, table.rho.shape[0] - 1)
        by_s = slopes(powers, s) * (2.0 / (table.high - table.low))
        rows = np.stack([np.tensordot(by, part, 1) for by, part in _parts(powers, by_s, table)], axis=-1)
        middle = 0.5 * (low[members] + high[members])
        panel = np.clip(np.searchsorted(table.panels, middle, side="right") - 1, 0, table.panels.size - 2)
        start, stop = table.panels[panel][..., None], table.panels[panel + 1][..., None]
        place = np.clip((2.0 * ratio[members] - start - stop) / (stop - start), -1.0, 1.0)
        basis = cheb.chebvander(place, rows.shape[2] - 1)
        result[:, members] = np.moveaxis(basis @ rows[np.arange(s.size)[:, None], panel], -1, 0)
    return result


def _parts(powers: Array, by_s: Array, table: Punches) -> tuple[tuple[Array, Array], ...]:
    return (powers, table.rho), (by_s, table.rho), (powers, table.phi)


def slopes(powers: Array, s: Array) -> Array:
    """Return the derivatives of Chebyshev polynomials, k U_(k-1), of which these are the values ``(m, n)`` at s."""
    slopes = np.zeros_like(powers)
    last, current = np.zeros_like(s), np.ones_like(s)
    for k in range(1, powers.shape[1]):
        slopes[:, k] = k * current
        last, current = current, 2.0 * s * current - last
    return slopes


def _value(response: WaveResponse, x: Array, a: Array, part: str) -> Array:
    x, a = np.broadcast_arrays(np.asarray(x, dtype=float), np.asarray(a, dtype=float))
    return np.asarray(_table(response, x.ravel(), a.ravel(), part, False)[0].reshape(x.shape))


def _table(response: WaveResponse, x: Array, a: Array, part: str, derivatives: bool) -> Array:
    """Return what is tabulated, and its derivatives by a at fixed x/a and by x/a if wanted, ``(1 or 3, n)``."""
    result = np.zeros((3 if derivatives else 1, x.size))
    for members, table, s in _grouped(response, a):
        series = getattr(table, part)
        ratio = np.clip(x[members] / np.where(a[members] > 0.0, a[members], 1.0), 0.0, 1.0)
        which = np.clip(np.searchsorted(table.panels, ratio, side="right") - 1, 0, table.panels.size - 2)
        for panel in np.unique(which):
            (own,) = np.nonzero(which == panel)
            low, high = table.panels[panel], table.panels[panel + 1]
            place = (2.0 * ratio - low - high) / (high - low)
            scales = np.array([1.0, 2.0 / (table.high - table.low), 2.0 / (high - low)])[: len(result), None]
            for start in range(0, own.size, POINTS_PER_BLOCK):
                part_ = own[start : start + POINTS_PER_BLOCK]
                result[:, members[part_]] = scales * _both(series[:, panel], s[part_], place[part_], derivatives)
    return result


def _both(series: Array, s: Array, place: Array, derivatives: bool) -> Array:
    """Return a double Chebyshev series ``(i, j)`` at places of both variables, and its two derivatives if wanted."""
    cheb = np.polynomial.chebyshev
    radial, basis = cheb.chebvander(s, len(series) - 1), cheb.chebvander(place, series.shape[1] - 1)
    rows = radial @ series
    value = np.einsum("ij,ij->i", rows, basis)
    if not derivatives:
        return np.asarray(value[None])
    by_s = np.einsum("ij,ij->i", radial[:, :-1] @ (_derivative(len(series)) @ series), basis)
    by_place = np.einsum("ij,ij->i", rows @ _derivative(series.shape[1]).T, basis[:, :-1])
    return np.array([value, by_s, by_place])


@functools.cache
def _derivative(count: int) -> Array:
    """Return the matrix that makes so many coefficients of a Chebyshev series those of its derivative."""
    return np.polynomial.chebyshev.chebder(np.eye(count))
