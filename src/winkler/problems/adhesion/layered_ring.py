r"""The ring of a constant stress on layers: how it displaces the springs, at once for many contacts.

A constant stress :math:`\sigma_0` in :math:`a<r<c` has the line load :math:`-2\sigma_0\sqrt{c^2-x^2}` there, on layers
as on a half-space.  The springs' load :math:`w(x) = \varphi(x;x)\,u(x)` follows from it as from any line load
(`winkler.numerics.transforms.fredholm`): with :math:`A = 2\sigma_0/E^*` and :math:`w = -A\,m`

.. math:: m(x) - \int_x^c\rho(x;t)\,m(t)\,\mathrm dt = \sqrt{c^2-x^2} , \qquad
          e(x) - \int_x^c\rho(x;t)\,e(t)\,\mathrm dt = \frac1{\sqrt{c^2-x^2}} .

The second one gives how far a punch of radius t < c leaves the surface at c behind,

.. math:: \tfrac\pi2\,[1-u_1(c;t)] = J(t) = \int_t^c \varphi(x;x)\,e(x)\,\mathrm dx ,

which on a half-space is arccos(t/c).  Both equations are solved in the angle
:math:`x = c\cos\beta`, in which all of this is smooth, by polynomials.
"""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np

from winkler.media.layered.depth_response import DepthResponse
from winkler.numerics.chunks import chunks
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.transforms import fredholm
from winkler.numerics.transforms.cosine_transform import WaveResponse
from winkler.numerics.types import Array

PLACES_PER_BLOCK = 400_000
"""Places at which the tables of the medium are read at once."""
LOGARITHMIC_NODES, LOGARITHMIC_POWER = 2, 3
"""Nodes for every angle, and the power of the part that makes them dense, where the kernel has a logarithm."""


class AngleRule(NamedTuple):
    """Collocation at `angles` ``(n,)``; integrals from each of them to zero at `places`, with `weights`, ``(n, q)``.

    Angles are parts of that of the contact radius, which is the first; the last one is zero, at the end of the ring.

    `spread` ``(n, q, n)`` takes values at the angles to the places, `series` ``(n, n)`` to Chebyshev coefficients.
    """

    angles: Array
    places: Array
    weights: Array
    spread: Array
    series: Array


class LayeredRing(NamedTuple):
    """Rings around contacts for a stress with A = 1: arrays ``(m,)``, or series of the angle ``(m, n)`` (`read`).

    Parameters
    ----------
    stretch : ndarray, (m,)
        m(a)/phi(a; a), by how much the last spring of the contact is stretched [m].
    lagging : ndarray, (m, n)
        J(x) [-].
    raised : ndarray, (m,)
        The integral of m e [m].
    pull : ndarray, (m,)
        The integral of phi(x; x) m [m^2].
    pull_beyond : ndarray, (m, n)
        The same from x on [m^2].
    squares : ndarray, (m,)
        The integral of m^2 [m^3].
    share : ndarray, (m, n)
        m / (phi(x; x) sqrt(c^2 - x^2)) [-].
    """

    stretch: Array
    lagging: Array
    raised: Array
    pull: Array
    pull_beyond: Array
    squares: Array
    share: Array


@functools.lru_cache(maxsize=32)
def _rule(count: int, logarithmic: bool) -> AngleRule:
    cheb = np.polynomial.chebyshev
    points = -np.cos(np.pi * np.arange(count) / (count - 1))
    series = np.linalg.inv(cheb.chebvander(points, count - 1))
    if not logarithmic:
        nodes, weights = gauss_legendre(count)
        places = points[:, None] + (1.0 - points[:, None]) * nodes
        spread = cheb.chebvander(places, count - 1) @ series
        return AngleRule(
            0.5 * (1.0 - points), 0.5 * (1.0 - places), 0.5 * (1.0 - points[:, None]) * weights, spread, series
        )
    # rho has a logarithm where the integral begins, and what follows has weaker ones at both ends of the ring
    nodes, weights = gauss_legendre(LOGARITHMIC_NODES * count)
    nodes, weights = nodes**LOGARITHMIC_POWER, LOGARITHMIC_POWER * nodes ** (LOGARITHMIC_POWER - 1) * weights
    places = points[:, None] + (1.0 - points[:, None]) * nodes
    spread = cheb.chebvander(places, count - 1) @ series
    turned, turn = _dense(0.5 * (1.0 - points)), 0.25 * np.pi * np.sin(0.5 * np.pi * (1.0 - places))
    return AngleRule(turned, _dense(0.5 * (1.0 - places)), (1.0 - points[:, None]) * weights * turn, spread, series)


def _logarithmic(response: WaveResponse) -> bool:
    """Whether the kernel has a logarithm at zero distance: where moduli change at the very surface."""
    return isinstance(response, DepthResponse)


def _dense(part: Array) -> Array:
    """Return parts of an angle, dense at both ends."""
    return np.asarray(np.sin(0.5 * np.pi * part) ** 2)


def layered_ring(response: WaveResponse, radius: Array, span: Array, count: int) -> LayeredRing:
    """Return the rings of contacts of radii a `(m,)` and of spans s = sqrt(c^2 - a^2) `(m,)` [m], by `count` angles."""
    rule = _rule(count, _logarithmic(response))
    blocks = chunks(radius.size, rule.places.size, PLACES_PER_BLOCK)
    parts = [_block(response, radius[some], span[some], rule) for some in blocks]
    return LayeredRing(*(np.concatenate(fields) for fields in zip(*parts, strict=True)))


def _block(response: WaveResponse, radius: Array, span: Array, rule: AngleRule) -> LayeredRing:
    outer, opening = np.hypot(radius, span)[:, None], np.arctan2(span, radius)[:, None]
    x = outer * np.cos(opening * rule.angles)
    t = outer[..., None] * np.cos(opening[..., None] * rule.places)
    measure = opening[..., None] * rule.weights  # dt over sqrt(c^2 - t^2)
    here = np.broadcast_to(x[:, :, None], t.shape)
    rho = fredholm.moment(response, np.minimum(here, t), t) / t
    edge = fredholm.edge(response, x)
    kernel = np.matmul((measure * rho).transpose(1, 0, 2), rule.spread).transpose(1, 0, 2)
    rest = outer * np.sin(opening * rule.angles)
    unit = np.eye(rule.angles.size)
    m = np.linalg.solve(unit - kernel * rest[:, None, :], rest[..., None])[..., 0]
    e = np.linalg.solve(unit - rest[:, :, None] * kernel, np.ones((*x.shape, 1)))[..., 0]  # times sqrt(c^2 - x^2)

    def beyond(values: Array) -> Array:
        """Return the integral of values / sqrt(c^2 - x^2) from every angle on."""
        return np.asarray(np.einsum("miq,iqj,mj->mi", measure, rule.spread, values, optimize=True))

    def whole(values: Array) -> Array:
        return np.asarray(np.einsum("mq,qj,mj->m", measure[:, 0], rule.spread[0], values, optimize=True))

    pulled = beyond(edge * m * rest)
    share = np.ones(x.shape)
    share[:, :-1] = m[:, :-1] / rest[:, :-1]
    return LayeredRing(
        stretch=m[:, 0] / edge[:, 0],
        lagging=beyond(edge * e) @ rule.series.T,
        raised=whole(m * e),
        pull=pulled[:, 0],
        pull_beyond=pulled @ rule.series.T,
        squares=whole(m * m * rest),
        share=(share / edge) @ rule.series.T,
    )


def read(response: WaveResponse, series: Array, share: Array) -> Array:
    """Return series ``(m, n)`` at angles ``(m, q)``, parts of that of the contact radius: from one, there, to zero."""
    if _logarithmic(response):
        share = np.arcsin(np.sqrt(share)) * (2.0 / np.pi)
    variable = 1.0 - 2.0 * share
    double = 2.0 * variable
    last, current = np.zeros_like(variable), np.zeros_like(variable)
    for row in series.T[:0:-1]:
        last, current = current, row[:, None] + double * current - last
    return np.asarray(series[:, :1] + variable * current - last)
