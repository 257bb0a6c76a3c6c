r"""Flat punches of all radii at once: Krein's way through a Fredholm equation.

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

with a smooth :math:`\sigma`.  So :math:`\varphi`, :math:`\rho` and :math:`\sigma` depend on the medium alone and are
tabulated once, as polynomials of :math:`x/a` and a on fixed octaves of a, cached by value.

The equation is solved on Gauss-Legendre nodes of panels that halve towards the edge of the punch down to the length
over which the kernel is smooth; where a panel is wider than that, the kernel is integrated over it piece by piece.

References
----------
.. [1] I. C. Gohberg, M. G. Krein, Theory and Applications of Volterra Operators in Hilbert Space, AMS 1970, ch. IV.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Hashable, Iterator
from typing import NamedTuple, cast

import numpy as np

from winkler.errors import NotConverged
from winkler.numerics.cosine import Response, transform
from winkler.numerics.kernel_matrix import halving_panels, kernel_matrix, legendre_to_chebyshev, panel_nodes
from winkler.numerics.quadrature import gauss_legendre
from winkler.numerics.types import Array

__all__ = [
    "Punches",
    "area",
    "edge",
    "edge_slope",
    "first_radius",
    "octave_of",
    "punches",
    "push",
    "resolvent",
    "tables",
]

RADII, FEWER_RADII = 18, 12
"""Radii of an octave at which the equation is solved; fewer for a response that is not known to all digits."""
COUNTS = (12, 16, 24, 32)
"""Nodes per panel, raised until the results settle; the fewest only for a response that is not known to all digits."""
SETTLED = 1e-12
LAST = 1e-9
"""Relative change that is accepted where rounding keeps it from settling: soft films squeeze digits out."""
FINEST = 1.5
"""Width of the panel at the edge, in lengths of the kernel."""
BLOCK = 4096
"""Places at which a series is summed at once: what fits into a processor's cache."""
HALVINGS = 4
"""How often an octave of radii may be halved."""


class Punches(NamedTuple):
    """Flat punches with radii from `low` to `high` [m], as Chebyshev series in a and, on panels of x/a, in x/a.

    `area` holds the integral of phi over a, `edge` phi(a; a); `rho` is times a, `push` is sigma; the leading index is
    the power of a.
    """

    low: float
    high: float
    panels: Array
    area: Array
    edge: Array
    phi: Array
    rho: Array
    push: Array


def first_radius(response: Response) -> float:
    """Return the end of the lowest octave [m], which reaches down to zero: a power series in a holds there."""
    return _first_radius(cast(Hashable, response))


@functools.lru_cache(maxsize=256)
def _first_radius(given: Hashable) -> float:
    response = cast(Response, given)
    strength = abs(float(transform(response, response.length)(np.zeros(1))[0]))
    return 0.5 * response.length / (1.0 + response.length * strength)


def octave_of(response: Response, radius: Array) -> Array:
    """Return the octave in which radii lie, also those below the lowest, as integers ``(m,)``."""
    with np.errstate(divide="ignore"):
        octave = np.ceil(np.log2(radius / first_radius(response)))
    return np.where(np.isfinite(octave), octave, -1e6).astype(int)


def tables(response: Response, octave: int) -> tuple[Punches, ...]:
    """Return the punches of an octave of radii, ascending.

    Raises
    ------
    NotConverged
        If the solution does not settle.
    """
    return _tables(cast(Hashable, response), max(octave, 0))


@functools.lru_cache(maxsize=512)
def _tables(given: Hashable, octave: int) -> tuple[Punches, ...]:
    response = cast(Response, given)
    high = first_radius(response) * 2.0**octave
    waiting = [(0.5 * high if octave else 0.0, high, 0)]
    done: list[Punches] = []
    while waiting:
        low, high, depth = waiting.pop()
        table, tail = _solve(response, low, high)
        if tail <= 10.0 * _settled(response) or depth == HALVINGS:
            if tail > max(LAST, 100.0 * _settled(response)):
                raise NotConverged(
                    f"The flat punches between {low:.3g} m and {high:.3g} m are not resolved (the series ends at "
                    f"{tail:.1e}); the contrasts of the stack are beyond what winkler can carry."
                )
            done.append(table)
        else:
            middle = 0.5 * (low + high)
            waiting += [(low, middle, depth + 1), (middle, high, depth + 1)]
    return tuple(sorted(done, key=lambda table: table.low))


# ---------------------------------------------------------------------------------------------------------- solving


def _panels(response: Response, high: float) -> Array:
    """Return panels of x/a that halve towards the edge."""
    halvings = max(0, math.ceil(math.log2(high / (FINEST * response.length))))
    return halving_panels(halvings)


def _solve(response: Response, low: float, high: float) -> tuple[Punches, float]:
    """Return the punches between two radii, and how far their series in a is from its end."""
    panels = _panels(response, high)
    count = _enough(response, high, panels)
    many = RADII if _settled(response) == SETTLED else FEWER_RADII
    angle = np.pi * (np.arange(many) + 0.5) / many
    radii = low + (high - low) * np.cos(0.5 * angle) ** 2
    solved = [_punch(response, float(a), panels, count) for a in radii]
    matrix = np.cos(np.outer(np.arange(many), angle)) * (2.0 / many)
    matrix[0] *= 0.5
    inner = legendre_to_chebyshev(count)
    area_, edge_ = (matrix @ np.array([punch[part] for punch in solved]) for part in (0, 1))
    phi, rho = (
        np.einsum("km,mpj,ij->kpi", matrix, np.array([punch[part] for punch in solved]), inner) for part in (2, 3)
    )
    turn = _to_pressure(panels.size - 1, inner.shape[0])
    push = edge_[:, None, None] * (np.arange(inner.shape[0]) == 0) - np.einsum("piqj,kqj->kpi", turn, phi)
    tails = [np.max(np.abs(series[-3:])) / np.max(np.abs(series)) for series in (area_, edge_)]
    scale = max(float(np.max(np.abs(rho))), 1.0)
    tails.append(np.max(np.abs(rho[-3:])) / scale)
    return Punches(low, high, panels, area_, edge_, phi, rho, push), float(max(tails))


@functools.cache
def _to_pressure(count: int, degree: int) -> Array:
    """Return the matrix from series of phi on `count` panels to series of edge - sigma on the same panels."""
    cheb = np.polynomial.chebyshev
    edges = np.array([1.0 - 0.5**k for k in range(count)] + [1.0])
    places, _ = gauss_legendre(degree)
    shares, weights = gauss_legendre(2 * degree)
    slopes = cheb.chebder(np.eye(degree))
    matrix = np.zeros((count, degree, count, degree))
    for panel in range(count):
        ratio = edges[panel] + (edges[panel + 1] - edges[panel]) * places
        span = np.sqrt((1.0 - ratio) * (1.0 + ratio))
        for other in range(panel, count):
            low, high = np.maximum(edges[other], ratio), edges[other + 1]
            # y = sqrt(x^2 - r^2): phi is even in x, so that phi'(x)/x is smooth in y
            start, stop = (np.sqrt((x - ratio) * (x + ratio)) for x in (low, high))
            y = start[:, None] + (stop - start)[:, None] * shares
            x = np.hypot(ratio[:, None], y)
            width = high - edges[other]
            basis = cheb.chebvander((2.0 * x - edges[other] - high) / width, degree - 2) @ slopes * (2.0 / width)
            rule = span[:, None] * (stop - start)[:, None] * weights / x
            matrix[panel, :, other] = legendre_to_chebyshev(degree) @ np.einsum("ij,ijk->ik", rule, basis)
    return matrix


def _settled(response: Response) -> float:
    """Return the relative change below which nothing is learnt any more."""
    return max(SETTLED, response.precision)


def _enough(response: Response, high: float, panels: Array) -> int:
    """Return how many nodes a panel needs for the widest punch to settle."""
    settled = _settled(response)
    counts = COUNTS if settled > SETTLED else COUNTS[1:]
    last = _punch(response, high, panels, counts[0])
    change = math.inf
    for fewer, more in itertools.pairwise((*counts, 48)):
        finer = _punch(response, high, panels, more)
        before = change
        change = max(abs(float(new / old) - 1.0) for new, old in zip(finer[:2], last[:2], strict=True))
        if change <= settled or (change <= LAST and change > 0.1 * before):
            return int(fewer)
        last = finer
    if change > max(LAST, 100.0 * settled):
        raise NotConverged(
            f"The flat punch of radius {high:.3g} m still moves by {change:.1e}; the contrasts of the stack are beyond "
            "what winkler can carry."
        )
    return COUNTS[-1]


def _punch(response: Response, a: float, panels: Array, count: int) -> tuple[float, float, Array, Array]:
    """Return the integral of phi over a, phi at the edge, and phi and a rho at the nodes ``(panels, count)``."""
    kernel = transform(response, 2.0 * a)
    x, w = panel_nodes(a * panels, count)
    matrix = kernel_matrix(response, a, panels.size - 2, count)
    right = np.stack([np.ones(x.size), 0.5 * (kernel(a - x) + kernel(a + x))], axis=1)
    phi, rho = np.linalg.solve(np.eye(x.size) + matrix, right).T
    return float(w @ phi) / a, float(1.0 - w @ rho), phi.reshape(-1, count), a * rho.reshape(-1, count)


# ------------------------------------------------------------------------------------------------------------- using


def _grouped(response: Response, a: Array) -> Iterator[tuple[Array, Punches, Array]]:
    """Yield indices, their table and the variable of its series from -1 to 1."""
    octaves = np.maximum(octave_of(response, a), 0)
    for octave in np.unique(octaves):
        (members,) = np.nonzero(octaves == octave)
        found = tables(response, int(octave))
        which = np.searchsorted([table.high for table in found[:-1]], a[members])
        for index, table in enumerate(found):
            chosen = members[which == index]
            if chosen.size:
                yield chosen, table, (2.0 * a[chosen] - table.low - table.high) / (table.high - table.low)


def _series(response: Response, a: Array, part: str, derivative: bool = False) -> Array:
    a = np.asarray(a, dtype=float)
    flat, result = a.ravel(), np.empty(a.size)
    for chosen, table, s in _grouped(response, flat):
        series = getattr(table, part)
        if derivative:
            series = np.polynomial.chebyshev.chebder(series) * (2.0 / (table.high - table.low))
        result[chosen] = np.polynomial.chebyshev.chebval(s, series)
    return result.reshape(a.shape)


def area(response: Response, a: Array) -> Array:
    """Return the integral of phi(x; a) over x from 0 to a [m]: the stiffness of a flat punch is 2 E* times that."""
    return np.asarray(a) * _series(response, a, "area")


def edge(response: Response, a: Array) -> Array:
    """Return phi(a; a) [-]: the springs are E* phi(a; a)^2 per length."""
    return _series(response, a, "edge")


def edge_slope(response: Response, a: Array) -> Array:
    """Return d phi(a; a) / da [1/m]."""
    return _series(response, a, "edge", derivative=True)


class Pairs(NamedTuple):
    """A function of x and a: its value, its derivative by a at fixed x/a, and its derivative by x."""

    value: Array
    along: Array
    across: Array


def resolvent(response: Response, x: Array, a: Array) -> Pairs:
    """Return rho(x; a) [1/m] and its derivatives [1/m^2], for 0 <= x <= a of one shape."""
    x, a = np.broadcast_arrays(np.asarray(x, dtype=float), np.asarray(a, dtype=float))
    scale = np.where(a > 0.0, a, 1.0)
    moment, by_a, by_ratio = (
        item.reshape(x.shape) for item in _table(response, x.ravel(), a.ravel(), "rho", True)
    )  # tabulated is a rho
    value = moment / scale
    return Pairs(value, (by_a - value) / scale, by_ratio / scale**2)


def punches(response: Response, x: Array, a: Array) -> Array:
    """Return phi(x; a) [-], for 0 <= x <= a of one shape."""
    return _value(response, x, a, "phi")


def push(response: Response, r: Array, a: Array) -> Array:
    """Return sigma(r; a) = pi sqrt(a^2 - r^2) p1(r; a) / E* [-], for 0 <= r <= a of one shape."""
    return _value(response, r, a, "push")


def _value(response: Response, x: Array, a: Array, part: str) -> Array:
    x, a = np.broadcast_arrays(np.asarray(x, dtype=float), np.asarray(a, dtype=float))
    return np.asarray(_table(response, x.ravel(), a.ravel(), part, False)[0].reshape(x.shape))


def _table(response: Response, x: Array, a: Array, part: str, derivatives: bool) -> Array:
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
            for start in range(0, own.size, BLOCK):
                part_ = own[start : start + BLOCK]
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
    by_s = np.einsum("ij,ij->i", radial[:, :-1] @ cheb.chebder(series, axis=0), basis)
    by_place = np.einsum("ij,ij->i", radial @ cheb.chebder(series, axis=1), basis[:, :-1])
    return np.array([value, by_s, by_place])
