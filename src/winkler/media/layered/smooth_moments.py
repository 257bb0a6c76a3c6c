r"""Moments of a smooth profile with flat punches: a product of numbers of the medium and samples of the profile.

Where the homogeneous transform h is a polynomial on [0, a], to rounding, its samples at fixed parts of a suffice,

.. math:: \int_0^a \rho(x;a)\,h(x)\,\mathrm dx = \sum_j R_j(a)\,h(a\xi_j) , \qquad
          R_j(a) = \int_0^1 a\rho(a\xi;a)\,\ell_j(\xi)\,\mathrm d\xi ,

with Lagrange's polynomials :math:`\ell_j`.  R and the same of phi belong to the medium, so that a new profile
before costs nothing but its samples.
"""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np

from winkler.numerics.caching import cached_by_value
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.transforms import fredholm, punch_tables
from winkler.numerics.transforms.cosine_transform import WaveResponse, in_own_lengths
from winkler.numerics.transforms.kernel_matrix import panel_nodes
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile

__all__ = ["smooth_moments"]

SAMPLES = 32
LAST_COEFFICIENTS = 4
"""Coefficients at the end of a Legendre series that must have vanished."""
VANISHED_RATIO = 1e-14
"""The same, relative to the largest sample."""


class MomentRule(NamedTuple):
    """Chebyshev series in the radius ``(k, n)`` of the weights of rho and phi at the samples."""

    rho: Array
    phi: Array


def smooth_moments(response: WaveResponse, profile: Profile, octave: int, a: Array) -> tuple[Array, Array]:
    """Return the integral of rho h, its derivative, and that of phi h; and where they hold.

    Parameters
    ----------
    response : WaveResponse
    profile : Profile
        Without a kink below the radii.
    octave : int
        In which all radii lie.
    a : ndarray, (m,)
        Radii [m].

    Returns
    -------
    moments : ndarray, (3, m)
    holds : ndarray of bool, (m,)
        Where h is smooth enough; elsewhere the moments mean nothing.
    """
    own, _ = in_own_lengths(response)
    xi, _ = gauss_legendre(SAMPLES)
    x = a[:, None] * xi
    with np.errstate(all="ignore"):
        h, slope = profile.gap(x), profile.gap_slope(x)
        holds = _resolved(h) & _resolved(slope)
    result = np.zeros((3, a.size))
    if not holds.any():
        return result, holds
    rules, octave_tables = _rules(own, max(octave, 0)), punch_tables.tables(response, octave)
    which = np.searchsorted([table.high for table in octave_tables[:-1]], a)
    for index, (table, rule) in enumerate(zip(octave_tables, rules, strict=True)):
        (mine,) = np.nonzero((which == index) & holds)
        if not mine.size:
            continue
        radius = a[mine]
        s = (2.0 * radius - table.low - table.high) / (table.high - table.low)
        powers = np.polynomial.chebyshev.chebvander(s, len(rule.rho) - 1)
        by_radius = fredholm.slopes(powers, s) * (2.0 / (table.high - table.low))
        weights = powers @ rule.rho
        own_h, own_slope = h[mine], slope[mine]
        result[0, mine] = np.sum(weights * own_h, axis=1)
        result[1, mine] = np.sum((by_radius @ rule.rho) * own_h + weights * xi * own_slope, axis=1)
        result[2, mine] = radius * np.sum((powers @ rule.phi) * own_h, axis=1)
    return result, holds


def _resolved(values: Array) -> Array:
    """Return which rows are samples of polynomials."""
    tail = np.max(np.abs(values @ _tail()), axis=1)
    return np.asarray(tail <= VANISHED_RATIO * np.max(np.abs(values), axis=1))


@functools.cache
def _tail() -> Array:
    """Return the matrix from samples to the last coefficients of their Legendre series."""
    xi, weights = gauss_legendre(SAMPLES)
    order = np.arange(SAMPLES - LAST_COEFFICIENTS, SAMPLES)
    basis = np.polynomial.legendre.legvander(2.0 * xi - 1.0, SAMPLES - 1)[:, order]
    return np.asarray(weights[:, None] * basis * (2.0 * order + 1.0))


@cached_by_value(256)
def _rules(key: WaveResponse, octave: int) -> tuple[MomentRule, ...]:
    """Return the rules of an octave of radii, for all parts of its tables."""
    legendre, chebyshev = np.polynomial.legendre, np.polynomial.chebyshev
    xi, weights = gauss_legendre(SAMPLES)
    order = np.arange(SAMPLES)
    to_series = (weights[:, None] * legendre.legvander(2.0 * xi - 1.0, SAMPLES - 1) * (2.0 * order + 1.0)).T
    rules = []
    for table in punch_tables.tables(key, octave):
        degree = table.rho.shape[2]
        count = (degree + SAMPLES) // 2 + 1  # exact for both polynomials
        ratio, shares = panel_nodes(table.panels, count)
        nodes, _ = gauss_legendre(count)
        basis = chebyshev.chebvander(2.0 * nodes - 1.0, degree - 1)
        lagrange = legendre.legvander(2.0 * ratio - 1.0, SAMPLES - 1) @ to_series
        parts = [
            np.einsum("kpi,ni->kpn", series, basis).reshape(len(series), -1) @ (shares[:, None] * lagrange)
            for series in (table.rho, table.phi)
        ]
        rules.append(MomentRule(*parts))
    return tuple(rules)
