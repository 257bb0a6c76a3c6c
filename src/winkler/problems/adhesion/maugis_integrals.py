r"""The integrals of which the ring of a constant stress is made.

With :math:`J(x)` and :math:`M` of `winkler.problems.adhesion.maugis`.  The integral of
:math:`g'J` goes from kink to kink; above a kink b everything is smooth in the angle

.. math:: x^2 = b^2 + w^2\sin^2\varphi, \qquad c^2 - x^2 = w^2\cos^2\varphi, \qquad w^2 = c^2 - b^2 ,

in the root that g starts at b as well as in the root with which J ends at c.  w comes from the width of the ring,
:math:`w^2 = s^2 + a^2 - b^2`, never from c, whose rounding a steep flank would multiply.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.numerics.chunks import chunks
from winkler.numerics.integrals.quadrature import gauss_legendre, tanh_sinh
from winkler.numerics.panels.abel_intervals import root_difference
from winkler.numerics.transforms.graded_abel import right_cosine
from winkler.numerics.types import Array, Curve

Rule = tuple[str, int]
"""``("gauss", count)`` for what is smooth in the angle, ``("double", count)``, double-exponential, for what is not."""

POINTS_PER_BLOCK = 250_000
"""Places at which g' is evaluated at once."""
DOUBLINGS = 60
FINEST_RULE = 161


class Edges(NamedTuple):
    """Where pieces begin, the kink whose root each of them contains, and whether g' is infinite there."""

    places: Array
    bases: Array
    steep: Array


class RingSprings(NamedTuple):
    """What the zone needs of a bed: g', its edges, whether g rises, c_N = surface_modulus x^exponent, and its end.

    `edges` are those of `edges_of`.
    """

    gap_slope: Curve
    edges: Edges
    rising: bool
    surface_modulus: float
    exponent: float
    end: float

    def cosine(self) -> float:
        """cos(k pi / 2)."""
        return right_cosine(self.exponent)

    def amplitude(self, strength: float) -> float:
        """Return A."""
        return 2.0 * strength * self.cosine() / (self.surface_modulus * (1.0 - self.exponent))


def edges_of(kinks: tuple[tuple[float, float], ...], end: float) -> Edges:
    """Return where the integral is divided: at kinks, and above kinks that crowd, in steps that double."""
    places, bases, steep = [0.0], [0.0], [False]
    kinks = tuple(sorted(pair for pair in kinks if 0.0 < pair[0] < end))
    before = 0.0
    for index, (b, strength) in enumerate(kinks):
        following = kinks[index + 1][0] if index + 1 < len(kinks) else end
        step, whole = (math.sqrt((high - low) * (high + low)) for low, high in ((before, b), (b, following)))
        below = [math.hypot(b, step * 2.0**j) for j in range(DOUBLINGS) if step * 2.0**j < 0.4 * whole]
        places += [b, *below]
        bases += [b] * (1 + len(below))
        steep += [strength != 0.0] * (1 + len(below))
        before = b
    return Edges(np.array(places), np.array(bases), np.array(steep))


def turn(share: Array, k: float) -> Array:
    """Return J(x), with share = (c^2 - x^2) / c^2."""
    if k == 0.0:
        return np.arcsin(np.sqrt(share))
    from scipy.special import beta, betainc

    p = 0.5 * (1.0 - k)
    return np.asarray(0.5 * beta(p, 1.0 - p) * betainc(p, 1.0 - p, share))


def moment(share: Array, k: float) -> Array:
    """Return M, with share = s^2 / c^2."""
    if k == 0.0:
        return np.asarray(share / (1.0 + np.sqrt(1.0 - share)))
    from scipy.special import beta, betainc

    p, q = 1.0 - k, 0.5 * (1.0 + k)
    return np.asarray(0.5 * beta(p, q) * betainc(p, q, share))


def pulled(outer: Array, span: Array, k: float) -> Array:
    """Return the integral of x^k (c^2 - x^2)^((1-k)/2) from a to c [m^2]."""
    share = np.minimum((span / outer) ** 2, 1.0)
    if k == 0.0:
        inner = np.sqrt(1.0 - share)
        return np.asarray(0.5 * outer**2 * (np.arcsin(np.sqrt(share)) - inner * np.sqrt(share)))
    from scipy.special import beta, betainc

    p, q = 0.5 * (3.0 - k), 0.5 * (1.0 + k)
    return np.asarray(0.5 * outer**2 * beta(p, q) * betainc(p, q, share))


class _IntegralPieces(NamedTuple):
    """Pieces of integrals: whose they are, their sign, the base of their angle, where they begin, how far they go.

    `start` is an angle from the base on, `stop` one from the end of the zone back.
    """

    owner: Array
    sign: Array
    base: Array
    high: Array
    steep: Array
    width: Array
    start: Array
    stop: Array
    whole: Array


def _rest(radius: Array, span: Array, place: Array) -> Array:
    """Return sqrt(c^2 - place^2) without forming c."""
    return np.asarray(np.sqrt(np.maximum(span * span + (radius - place) * (radius + place), 0.0)))


def _pieces(edges: Edges, radius: Array, span: Array, k: float) -> _IntegralPieces:
    """Divide the zones at the edges that lie in them."""
    first = np.searchsorted(edges.places, radius, side="right") - 1
    last = np.maximum(np.searchsorted(edges.places, np.hypot(radius, span), side="left") - 1, first)
    counts = last - first + 1
    owner = np.repeat(np.arange(radius.size), counts)
    index = first[owner] + np.arange(owner.size) - np.repeat(np.cumsum(counts) - counts, counts)
    a, s, base = radius[owner], span[owner], edges.bases[index]
    low = np.maximum(edges.places[index], a)
    width = _rest(a, s, base)
    rest = np.where(low == a, s, _rest(a, s, low))
    high = np.append(edges.places, np.inf)[np.where(index < last[owner], index + 1, edges.places.size)]
    ends, limit = np.isinf(high), high
    high = np.where(ends, low, high)
    left = np.where(ends, 0.0, _rest(a, s, high))
    risen, rises = root_difference(low, base), root_difference(high, base)
    start, stop = np.arctan2(risen, rest), np.where(ends, 0.0, np.arctan2(left, rises))
    back = np.arctan2(rest, risen)
    # of two differences of the same angle, the one that cancels less
    whole = np.where(ends | (back < start), back - stop, np.arctan2(rises, left) - start)
    whole = np.maximum(whole, 0.0)
    divided = _IntegralPieces(owner, np.ones(owner.size), base, limit, edges.steep[index], width, start, stop, whole)
    return divided if k == 0.0 else _from_base(divided, back)


def _from_base(pieces: _IntegralPieces, back: Array) -> _IntegralPieces:
    """Let pieces begin at the base, and take off what is too much: a power starts there, not far outside of them."""
    near = (pieces.start > 0.0) & (pieces.start < pieces.whole)
    more = _IntegralPieces(*(part[near] for part in pieces))
    more = more._replace(sign=-more.sign, start=0.0 * more.start, stop=back[near], whole=more.start)
    begun = pieces._replace(
        start=np.where(near, 0.0, pieces.start), whole=pieces.whole + np.where(near, pieces.start, 0.0)
    )
    return _IntegralPieces(*(np.concatenate(parts) for parts in zip(begun, more, strict=True)))


def profile_part(springs: RingSprings, radius: Array, span: Array, rule: Rule) -> tuple[Array, Array]:
    """Return the integral of g' J over the zone [m], and its derivative by c [-]."""
    outer = np.hypot(radius, span)
    pieces = _pieces(springs.edges, radius, span, springs.exponent)
    total, by_outer = np.zeros(radius.shape), np.zeros(radius.shape)
    nodes, complements, weights = _points(rule)
    k = springs.exponent
    for some in chunks(pieces.owner.size, nodes.size, POINTS_PER_BLOCK):
        own = _IntegralPieces(*(part[some] for part in pieces))
        c = outer[own.owner]
        x, rest, measure = _on(springs, own, nodes, complements, weights)
        turn_value = turn(np.minimum((rest / c[:, None]) ** 2, 1.0), k)
        total += np.bincount(own.owner, np.einsum("mn,mn->m", measure, rest / x * turn_value), radius.size)
        if k != 0.0:
            measure *= np.where(rest > 0.0, x / np.where(rest > 0.0, rest, 1.0), 0.0) ** k
        by_outer += np.bincount(own.owner, np.sum(measure, axis=1) / c, radius.size)
    return total, by_outer


def profile_moment(
    springs: RingSprings, radius: Array, span: Array, rule: Rule, weight: Callable[[Array, Array, Array], Array]
) -> Array:
    """Return the integral of g' weight over the zone; `weight` takes owners ``(m,)``, x and sqrt(c^2 - x^2) ``(m, n)``.

    For k = 0.  The weight is smooth in the angle from the contact radius on.
    """
    total = np.zeros(radius.shape)
    pieces = _pieces(springs.edges, radius, span, 0.0)
    nodes, complements, weights = _points(rule)
    for some in chunks(pieces.owner.size, nodes.size, POINTS_PER_BLOCK):
        own = _IntegralPieces(*(part[some] for part in pieces))
        x, rest, measure = _on(springs, own, nodes, complements, weights)
        total += np.bincount(own.owner, np.sum(measure * (rest / x) * weight(own.owner, x, rest), axis=1), radius.size)
    return total


def _points(rule: Rule) -> tuple[Array, Array, Array]:
    """Return nodes, their distances from one, and weights."""
    if rule[0] == "gauss":
        nodes, weights = gauss_legendre(rule[1])
        return nodes, nodes[::-1], weights
    return tanh_sinh(rule[1])


def gap_moment(springs: RingSprings, radius: Array, span: Array) -> Array:
    """Return the integral of (g(x) - g(a)) sqrt(c^2 - x^2) over the zone [m^3], by parts; for k = 0."""
    outer, total = np.hypot(radius, span), np.zeros(radius.shape)
    pieces = _pieces(springs.edges, radius, span, springs.exponent)
    for begin in range(0, pieces.owner.size, POINTS_PER_BLOCK // FINEST_RULE):
        own = _IntegralPieces(*(part[begin : begin + POINTS_PER_BLOCK // FINEST_RULE] for part in pieces))
        x, rest, measure = _on(springs, own, *tanh_sinh(FINEST_RULE))
        c = outer[own.owner, None]
        beyond = pulled(np.broadcast_to(c, rest.shape), rest, 0.0)
        total += np.bincount(own.owner, np.einsum("mn,mn->m", measure, rest / x * beyond), radius.size)
    return total


def _on(
    springs: RingSprings, own: _IntegralPieces, nodes: Array, complements: Array, weights: Array
) -> tuple[Array, Array, Array]:
    """Return x, sqrt(c^2 - x^2), and what is to be multiplied by that over x and summed for an integral over g' dx."""
    k = springs.exponent
    base, width, whole = own.base[:, None], own.width[:, None], own.whole[:, None]
    risen = width * np.sin(own.start[:, None] + whole * nodes)  # sqrt(x^2 - base^2)
    rest = width * np.sin(own.stop[:, None] + whole * complements)  # sqrt(c^2 - x^2)
    # just above a kink x cannot be resolved from it, and g' is evaluated where it can; just below, nothing must cross
    # it
    x = np.maximum(np.hypot(base, risen), np.nextafter(base, np.inf))
    x = np.minimum(x, np.minimum(own.high, np.nextafter(springs.end, 0.0))[:, None])
    measure = springs.gap_slope(x) * (own.sign[:, None] * whole * weights)
    steep = own.steep
    if steep.any():
        distance = root_difference(x[steep], np.broadcast_to(base[steep], x[steep].shape))
        # g' holds distance^(k-1): what is finite is made of the same rounded place
        measure[steep] *= distance ** (1.0 - k) * risen[steep] ** k
        measure[~steep] *= risen[~steep]
    else:
        measure *= risen
    return x, rest, measure
