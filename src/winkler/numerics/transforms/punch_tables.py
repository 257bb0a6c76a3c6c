"""Flat punches of all radii, tabulated: the equation of `winkler.numerics.transforms.fredholm`, solved once.

The equation is solved on Gauss-Legendre nodes of panels that halve towards the edge of the punch down to the length
over which the kernel is smooth; where a panel is wider than that, the kernel is integrated over it piece by piece.
Results are polynomials of :math:`x/a` and a on fixed octaves of a, cached by value.  Tables of an odd response
(`winkler.numerics.transforms.odd_response`) hold a twist instead.
"""

from __future__ import annotations

import functools
import itertools
import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.caching import cached_by_value
from winkler.numerics.integrals.quadrature import gauss_legendre, panel_nodes
from winkler.numerics.transforms.cosine_transform import WaveResponse, in_own_lengths, transform
from winkler.numerics.transforms.kernel_matrix import halving_panels, kernel_matrix, legendre_to_chebyshev
from winkler.numerics.transforms.odd_response import parity
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

RADII_PER_OCTAVE, FEWER_RADII_PER_OCTAVE = 18, 12
"""Radii of an octave at which the equation is solved; fewer for a response that is not known to all digits."""
NODE_COUNTS = (12, 16, 24, 32)
"""Nodes per panel, raised until the results settle; the fewest only for a response that is not known to all digits."""
SETTLED_TOLERANCE = 1e-12
LAST_TOLERANCE = 1e-9
"""Relative change that is accepted where rounding keeps it from settling: soft films squeeze digits out."""
ROUNDED_WIDTH, MOST_ROUNDED = 4e-16, 1e-5
"""What rounding moves at a radius of one length, as which a film that keeps its volume squeezes out digits by the cube
of the radius; and beyond which results are refused."""
ROUNDING_RATIO = 1e-16
"""What rounding leaves of the end of a series, over the largest phi: it does not get shorter on halving the octave."""
EDGE_PANEL_WIDTH = 1.5
"""Width of the panel at the edge, in lengths of the kernel."""
EDGE_PANEL_WIDTH_ROUNDED = 4.0
"""The same where a logarithm is rounded off over that length: it is integrated, and leaves hardly a trace in phi."""
IN_LENGTHS = "times the thickness of the uppermost layer (or the length over which moduli change)"
"""The unit of radii in sentences: tables have no metres."""
WIDEST = 8e5
"""Radii over the thickness of the uppermost layer beyond which tables are lost in rounding, and halved without end."""
MOST_HALVINGS = 4
"""How often an octave of radii may be halved."""
SHORTENED_RATIO = 0.1
"""What three coefficients leave of the end of a series, at the most, unless it is rounding."""


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


def first_radius(response: WaveResponse) -> float:
    """Return the end of the lowest octave [m], which reaches down to zero: a power series in a holds there."""
    own, unit = in_own_lengths(response)
    return unit * _first_radius(own)


@cached_by_value(256)
def _first_radius(response: WaveResponse) -> float:
    response, _ = parity(response)
    strength = abs(float(transform(response, response.length)(np.zeros(1))[0]))
    return 0.5 * response.length / (1.0 + response.length * strength)


def octave_of(response: WaveResponse, radius: Array) -> Array:
    """Return the octave in which radii lie, also those below the lowest, as integers ``(m,)``."""
    with np.errstate(divide="ignore"):
        octave = np.ceil(np.log2(radius / first_radius(response)))
    return np.where(np.isfinite(octave), octave, -1e6).astype(int)


def tables(response: WaveResponse, octave: int) -> tuple[Punches, ...]:
    """Return the punches of an octave of radii, ascending.

    Raises
    ------
    NotConverged
        If the solution does not settle.
    """
    own, unit = in_own_lengths(response)
    return _stretched(own, max(octave, 0), unit)


@cached_by_value(512)
def _stretched(response: WaveResponse, octave: int, unit: float) -> tuple[Punches, ...]:
    """Return the tables with radii in m, of a response in units of a length [m]."""
    return tuple(table._replace(low=unit * table.low, high=unit * table.high) for table in _tables(response, octave))


@cached_by_value(512)
def _tables(response: WaveResponse, octave: int) -> tuple[Punches, ...]:
    high = first_radius(response) * 2.0**octave
    if response.smooth <= response.length and high > WIDEST * response.length:
        raise NotConverged(
            f"Flat punches with radii of up to {high / response.length:.3g} times the thickness of the uppermost "
            "layer are lost in rounding. Request narrower contacts, or leave out a layer that is so thin."
        )
    low = 0.5 * high if octave else 0.0
    return _resolved(response, _solve(response, low, high), MOST_HALVINGS)


def _resolved(response: WaveResponse, table: Punches, halvings: int) -> tuple[Punches, ...]:
    """Return a table, or those of so many halvings of its radii that their series end."""
    tail, level = _ends(table)
    rounded = ROUNDING_RATIO * float(np.max(np.abs(table.phi)))
    if tail <= max(10.0 * _settled(response), rounded):
        return (table,)
    if tail <= _accepted(response, table.high) and (level or not halvings):
        return (table,)  # rounding keeps the series from ending
    if not halvings:
        raise NotConverged(
            f"Flat punches with radii of {table.low / response.length:.3g} to {table.high / response.length:.3g} "
            f"{IN_LENGTHS} are not resolved (the series ends at {tail:.1e}); the contrasts of the stack are "
            "beyond what winkler can carry: request narrower contacts."
        )
    middle = 0.5 * (table.low + table.high)
    halves = (_solve(response, *ends) for ends in ((table.low, middle), (middle, table.high)))
    return tuple(part for half in halves for part in _resolved(response, half, halvings - 1))


def _ends(table: Punches) -> tuple[float, bool]:
    """Return how far series in a are from their end, and whether these no longer fall there: the rest is rounding."""
    series = table.area, table.edge, table.rho
    sizes = [np.max(np.abs(one), axis=tuple(range(1, one.ndim))) for one in series]
    ends = np.array([(np.max(size[-3:]), np.max(size[-6:-3])) for size in sizes])
    ends /= np.array([np.max(sizes[0]), np.max(sizes[1]), max(float(np.max(sizes[2])), 1.0)])[:, None]
    last = ends[np.argmax(ends[:, 0])]
    return float(last[0]), bool(last[0] >= SHORTENED_RATIO * last[1])


def _panels(response: WaveResponse, high: float) -> Array:
    """Return panels of x/a that halve towards the edge."""
    finest = min(
        (EDGE_PANEL_WIDTH_ROUNDED if response.smooth > response.length else EDGE_PANEL_WIDTH) * response.length,
        response.smooth,
    )
    halvings = max(0, math.ceil(math.log2(high / max(finest, EDGE_PANEL_WIDTH * response.length))))
    return halving_panels(halvings)


def _solve(response: WaveResponse, low: float, high: float) -> Punches:
    """Return the punches between two radii."""
    panels = _panels(response, high)
    count = _enough(response, high, panels)
    many = RADII_PER_OCTAVE if _settled(response) == SETTLED_TOLERANCE else FEWER_RADII_PER_OCTAVE
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
    return Punches(low, high, panels, area_, edge_, phi, rho, push)


@functools.cache
def _to_pressure(count: int, degree: int) -> Array:
    """Return the matrix from series of phi on `count` panels to series of edge - sigma on the same panels."""
    edges = halving_panels(count - 1).tolist()
    panels = list(itertools.pairwise(edges))
    matrix = np.zeros((count, degree, count, degree))
    for panel, other in itertools.combinations_with_replacement(range(count), 2):
        matrix[panel, :, other] = _from_panel(panels[panel], panels[other], degree)
    return matrix


@functools.cache
def _from_panel(panel: tuple[float, float], other: tuple[float, float], degree: int) -> Array:
    """Return what phi on one panel of x/a adds on another; the same however many panels follow."""
    cheb = np.polynomial.chebyshev
    places, _ = gauss_legendre(degree)
    shares, weights = gauss_legendre(2 * degree)
    slopes = cheb.chebder(np.eye(degree))
    ratio = panel[0] + (panel[1] - panel[0]) * places
    span = np.sqrt((1.0 - ratio) * (1.0 + ratio))
    low, high = np.maximum(other[0], ratio), other[1]
    # y = sqrt(x^2 - r^2): phi is even in x, so that phi'(x)/x is smooth in y
    start, stop = (np.sqrt((x - ratio) * (x + ratio)) for x in (low, high))
    y = start[:, None] + (stop - start)[:, None] * shares
    x = np.hypot(ratio[:, None], y)
    width = high - other[0]
    basis = cheb.chebvander((2.0 * x - other[0] - high) / width, degree - 2) @ slopes * (2.0 / width)
    rule = span[:, None] * (stop - start)[:, None] * weights / x
    return np.asarray(legendre_to_chebyshev(degree) @ np.einsum("ij,ijk->ik", rule, basis))


def _settled(response: WaveResponse) -> float:
    """Return the relative change below which the results are settled."""
    return max(SETTLED_TOLERANCE, response.precision)


def _accepted(response: WaveResponse, high: float) -> float:
    """Return the relative change that is accepted up to a radius where rounding keeps results from settling."""
    squeezed = min(ROUNDED_WIDTH * (high / response.length) ** 3, MOST_ROUNDED)
    return max(LAST_TOLERANCE, 100.0 * _settled(response), squeezed)


def _enough(response: WaveResponse, high: float, panels: Array) -> int:
    """Return how many nodes a panel needs for the widest punch to settle."""
    settled = _settled(response)
    counts = NODE_COUNTS if settled > SETTLED_TOLERANCE else NODE_COUNTS[1:]
    last = _punch(response, high, panels, counts[0])
    change = math.inf
    for fewer, more in itertools.pairwise((*counts, 48)):
        finer = _punch(response, high, panels, more)
        before = change
        change = max(abs(float(new / old) - 1.0) for new, old in zip(finer[:2], last[:2], strict=True))
        if change <= settled or (change <= LAST_TOLERANCE and change > 0.1 * before):
            return int(fewer)
        last = finer
    if change > _accepted(response, high):
        raise NotConverged(
            f"A flat punch with a radius of {high / response.length:.3g} {IN_LENGTHS} still moves by {change:.1e}; the "
            "contrasts of the stack are beyond what winkler can carry: request a narrower contact."
        )
    return NODE_COUNTS[-1]


def punch_at(response: WaveResponse, a: float, count: int) -> tuple[float, float, Array, Array, Array]:
    """Return a flat punch without a table, in lengths of the response.

    Parameters
    ----------
    response : WaveResponse
    a : float
        Its radius.
    count : int
        Nodes on a panel.

    Returns
    -------
    tuple
        The integral of phi over a, phi at the edge, phi and a rho at the nodes ``(panels, count)``, panels of x/a.
    """
    panels = _panels(response, a)
    return (*_punch(response, a, panels, count), panels)


def _punch(response: WaveResponse, a: float, panels: Array, count: int) -> tuple[float, float, Array, Array]:
    """Return the mean of phi, phi at the edge, and phi and a rho at the nodes ``(panels, count)``.

    For an `OddResponse` that is what its module states.
    """
    response, sign = parity(response)
    kernel = transform(response, 2.0 * a)
    x, w = panel_nodes(a * panels, count)
    matrix = kernel_matrix(response, a, panels.size - 2, count, sign)
    shape = np.ones(x.size) if sign > 0.0 else x / a
    # of the narrowest panels a - x would be lost in the rounding of x
    from_edge = a * (-panel_nodes(panels - 1.0, count)[0])
    right = np.stack([shape, 0.5 * (kernel(from_edge) + sign * kernel(a + x))], axis=1)
    phi, rho = np.linalg.solve(np.eye(x.size) + matrix, right).T
    mean, edge = float((w * shape) @ phi) / a, float(1.0 - (w * shape) @ rho)
    if sign < 0.0:
        mean, phi = 3.0 * mean, phi / shape
    return mean, edge, phi.reshape(-1, count), a * rho.reshape(-1, count)
