r"""The matrix of :math:`K(x,t) = \frac12[C(x-t) + C(x+t)]` on panels that halve towards the end, C sharp near zero.

On Gauss-Legendre nodes it is a product of values and weights, except on panels that are wide against their distance
from x and against the length over which C is smooth.  There the Lagrange polynomials of the nodes are integrated with
C, in pieces that get longer away from x.  Where C has a logarithm that is rounded off over a tiny length, the
distance beyond that length is taken as a fifth power: against :math:`v^4\,\mathrm dv` the logarithm is smooth.

The panels of [0, a] less the first are those of [0, a/2], moved: what depends on x - t alone is the same for both,
and kept.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable

import numpy as np

from winkler.numerics.caching import cached_by_value
from winkler.numerics.integrals.quadrature import gauss_legendre, panel_nodes
from winkler.numerics.transforms.cosine_transform import WaveResponse, transform
from winkler.numerics.types import Array, Curve

WIDEST_REGULAR_PANEL = 3.0
"""A panel wider than this many lengths of the kernel is integrated piece by piece where the kernel is near."""
FAR_DISTANCE_RATIO = 0.6
"""A panel is far from a point if its distance is more than this part of its width."""
SAMPLES = 32
"""Of C(x + t) where both are beyond the first panel: distances from a to 2 a, over which C is smooth."""
NODES_PER_PIECE = 16
LOGARITHMIC_NODES = 30
"""Nodes on the piece where C has a logarithm."""
VARIABLE_POWER = 5
ROUNDED_LENGTHS = 8.0
"""Up to this many lengths C is visibly rounded off."""


@functools.cache
def legendre_to_chebyshev(count: int) -> Array:
    """Return the matrix from values at Gauss-Legendre nodes to a Chebyshev series."""
    nodes, _ = gauss_legendre(count)
    return np.linalg.inv(np.polynomial.chebyshev.chebvander(2.0 * nodes - 1.0, count - 1))


def halving_panels(halvings: int) -> Array:
    """Return panels of [0, 1] that halve towards 1."""
    return np.array([1.0 - 0.5**k for k in range(halvings + 1)] + [1.0])


def kernel_matrix(response: WaveResponse, a: float, halvings: int, count: int, sign: float = 1.0) -> Array:
    """Return the matrix that integrates K(x, t) times a function known at the nodes.

    Parameters
    ----------
    response : WaveResponse
        Of which C is the transform.
    a : float
        End of the panels [m].
    halvings : int
        How often they halve.
    count : int
        Gauss-Legendre nodes on each panel.
    sign : float
        Of C(x + t): -1 for odd functions.

    Returns
    -------
    ndarray, (n, n)
        n = (halvings + 1) count.
    """
    kernel = transform(response, 2.0 * a)
    x, w = panel_nodes(a * halving_panels(halvings), count)
    matrix = _sums(kernel, x, a, halvings, count) * w
    _correct(matrix[:, :count], response, kernel, -x, 0.0, a if halvings == 0 else 0.5 * a, count)
    matrix *= sign
    hook = _first_panel_tables(response, count)
    for step in range(halvings + 1):
        right, below = hook(a * 0.5**step, halvings - step)
        start, stop = step * count, (step + 1) * count
        matrix[start:stop, start:] += right
        matrix[stop:, start:stop] += below
    return 0.5 * matrix


def _sums(kernel: Curve, x: Array, a: float, halvings: int, count: int) -> Array:
    """Return C(x + t) at all nodes."""
    matrix = np.empty((x.size, x.size))
    matrix[:, :count] = kernel(x[:, None] + x[:count])
    matrix[:count] = matrix[:, :count].T
    if halvings:
        # beyond the first panel x + t is at least a: C is a polynomial of both
        place, spread = _samples(halvings, count)
        matrix[count:, count:] = spread @ kernel(a * (place[:, None] + place)) @ spread.T
    return matrix


@functools.lru_cache(maxsize=64)
def _samples(halvings: int, count: int) -> tuple[Array, Array]:
    """Return places in [1/2, 1], and the matrix from values there to the nodes of all panels but the first."""
    cheb = np.polynomial.chebyshev
    s = cheb.chebpts1(SAMPLES)
    x, _ = panel_nodes(halving_panels(halvings)[1:], count)
    return 0.75 + 0.25 * s, cheb.chebvander(4.0 * x - 3.0, SAMPLES - 1) @ np.linalg.inv(cheb.chebvander(s, SAMPLES - 1))


@cached_by_value(16)
def _first_panel_tables(response: WaveResponse, count: int) -> Callable[[float, int], tuple[Array, Array]]:
    """Return `_first_panel_table` of a response with a cache of its own: the response is compared only once."""
    return functools.lru_cache(maxsize=1024)(functools.partial(_first_panel_table, response, count))


def _first_panel_table(response: WaveResponse, count: int, a: float, halvings: int) -> tuple[Array, Array]:
    """Return the matrix of C(x - t) from all panels on the first, and from the first on all others."""
    kernel = transform(response, a)
    edges = a * halving_panels(halvings)
    x, w = panel_nodes(edges, count)
    own = x[:count]
    all_on_first = kernel(np.abs(x[:, None] - own)) * w[:count]
    _correct(all_on_first, response, kernel, x, edges[0], edges[1], count)
    right = np.empty((count, x.size))
    right[:, :count] = all_on_first[:count]
    right[:, count:] = kernel(x[count:] - own[:, None]) * w[count:]
    for panel in range(1, edges.size - 1):
        columns = right[:, panel * count : (panel + 1) * count]
        _correct(columns, response, kernel, own, edges[panel], edges[panel + 1], count)
    return right, all_on_first[count:]


def _correct(
    matrix: Array, response: WaveResponse, kernel: Curve, place: Array, low: float, high: float, n: int
) -> None:
    """Replace, in place, rows that nodes on the panel from `low` to `high` integrate badly."""
    width = high - low
    if width <= WIDEST_REGULAR_PANEL * response.length:
        return
    (near,) = np.nonzero(np.maximum(low - place, place - high) <= FAR_DISTANCE_RATIO * width)
    if near.size == 0:
        return
    distance, weights = graded_rule(place[near], low, high, response)
    t = place[near, None] + distance
    basis = np.polynomial.chebyshev.chebvander(np.clip((2.0 * t - low - high) / width, -1.0, 1.0), n - 1)
    matrix[near] = np.einsum("ij,ijk->ik", weights * kernel(np.abs(distance)), basis) @ legendre_to_chebyshev(n)


def graded_rule(place: Array, low: float, high: float, response: WaveResponse) -> tuple[Array, Array]:
    """Return nodes, as distances from `place`, and weights on [low, high] in pieces that shrink towards `place`."""
    farthest = float(np.max(np.maximum(high - place, place - low)))
    step = 2.0 * response.smooth
    count = max(1, math.ceil(math.log2(farthest / step)) + 1)
    steps = step * 2.0 ** np.arange(count)
    first = [(np.array([0.0, step]), 1)]
    if response.smooth > response.length:
        rounded = min(ROUNDED_LENGTHS * response.length, step)
        first = [(np.array([0.0, rounded]), 1), (np.array([rounded, step]), VARIABLE_POWER)]
    signs = [sign for sign, wide in ((1.0, high - np.min(place)), (-1.0, np.max(place) - low)) if wide > 0.0]
    parts = [_pieces(place, low, high, sign * edges, p) for sign in signs for edges, p in [*first, (steps, 1)]]
    distance, weights = (np.concatenate(part, axis=1) for part in zip(*parts, strict=True))
    return distance, weights


def _pieces(place: Array, low: float, high: float, steps: Array, power: int) -> tuple[Array, Array]:
    """Return Gauss-Legendre nodes in a root of the distance, and weights, between steps clipped to [low, high]."""
    edges = np.clip(steps, (low - place)[:, None], (high - place)[:, None])
    edges = edges[:, np.concatenate([[True], np.any(np.diff(edges, axis=1) != 0.0, axis=0)])]
    nodes, rule = gauss_legendre(NODES_PER_PIECE if power == 1 else LOGARITHMIC_NODES)
    sign = 1.0 if steps[-1] > 0.0 else -1.0
    # a panel on the other side of the place has none of these pieces
    roots = np.maximum(sign * edges, 0.0) ** (1.0 / power)
    start, span = roots[:, :-1, None], np.diff(roots, axis=1)[..., None]
    root = start + span * nodes
    weights = span * rule * power * root ** (power - 1)
    shape = (place.size, -1)
    return (sign * root**power).reshape(shape), weights.reshape(shape)
