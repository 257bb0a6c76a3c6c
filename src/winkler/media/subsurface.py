r"""The field inside a body under an axisymmetric contact: flat punches of all radii, superposed.

With `flat`, the field of one punch under unit line load, the springs' displacement u(x) gives

.. math:: \text{field}(r, z) = E^*\Big[\int_0^a \text{flat}(r, z; t)\,(-u'(t))\,\mathrm dt
          + u(a)\,\text{flat}(r, z; a)\Big].

Near the surface `flat` is almost singular at :math:`t = r`, in truth at :math:`t = r + iz`.  In the variable
:math:`y = \sqrt{t^2-s^2}` of a panel (`pile`) that is :math:`y = p + iq`; with :math:`y = p + q\sinh v` it lies at
:math:`v = i\pi/2` whatever the depth, so the work grows with the logarithm of the depth only.  On the surface itself
:math:`y = p\sin v` for punches narrower than r and :math:`y = p\cosh v` for wider ones remove the singularities
altogether, and the field below passes continuously into that of the surface.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from winkler.errors import InvalidInput
from winkler.media.medium import Displacement
from winkler.media.pile import FAR, Cluster, Panel, pile
from winkler.media.punch_field import BodyField, Potentials, combine, punch_below, punch_surface
from winkler.numerics.quadrature import gauss_legendre
from winkler.numerics.types import Array

__all__ = ["field", "superposed_below", "superposed_on"]

Indices = NDArray[np.intp]
Place = Callable[[Indices, Array], tuple[Array, Array]]
Punch = Callable[[Array, Array, Array, Array | None], tuple[Array, ...]]

BLOCK = 20_000
"""Largest number of points at once."""
CHUNK = 1 << 16
"""Largest number of (point, node) pairs at once: the temporary arrays stay in the cache."""
COUNTS = np.array([6, 8, 10, 12, 16, 20, 24, 28, 32, 40, 48, 56, 64, 80, 96, 112])
"""Numbers of nodes of the rules; one of them is chosen for every point and panel."""
LONGEST = 12.0
"""Longest interval of v that one rule covers."""
SHALLOWEST = 1e-30
"""Least depth below the surface, in contact radii, that is told from the next; cubes of it must not underflow."""
STRAIGHT = math.log(3.0)
"""A panel is mapped by sinh only if the singularity is nearer than this, ln(rho) of its Bernstein ellipse."""
NODES, SHORT = 48, 4.0
"""On the surface, where points are few: one rule of many nodes on short intervals of v."""


def field(displacement: Displacement, r: Array, z: Array, *, modulus: float, poisson: float, shear: float) -> BodyField:
    """Return stresses and displacements in one of two bodies in frictionless, axisymmetric contact.

    Parameters
    ----------
    displacement : Displacement
        u(x) of the springs, whose line load is ``modulus * u(x)``; hashable.
    r, z : ndarray
        Distance from the axis and depth below the surface [m], not negative, of shapes that broadcast.
    modulus : float
        Effective modulus E* of the pair [Pa].
    poisson, shear : float
        Poisson's ratio [-] and shear modulus [Pa] of the body in which the field is wanted.

    Returns
    -------
    BodyField
        Stresses [Pa], tension positive, and displacements [m], z into the body, in the common shape of r and z.
        At ``z = 0`` they are the limits from inside the body.  Stresses are infinite only on the surface itself: at
        the edge if u jumps there, at a kink of diverging slope, under a conical tip; their sign is that of the
        limit along the surface below the contact.

    Raises
    ------
    InvalidInput
        If a coordinate is negative or not finite.
    NotConverged
        If u'(x) is not smooth between the kinks.
    """
    radius, depth = np.broadcast_arrays(np.asarray(r, dtype=float), np.asarray(z, dtype=float))
    for word, given in (("r", radius), ("z", depth)):
        bad = given[~(np.isfinite(given) & (given >= 0.0))]
        if bad.size:
            raise InvalidInput(
                f"{word}: {bad[0]:g} m is not a place in the body; give finite values from zero upwards."
            )
    places, depths = radius.ravel(), depth.ravel()
    total = np.zeros((len(Potentials._fields), places.size))
    if displacement.radius > 0.0:
        below, surface = depths > 0.0, depths == 0.0
        total[:, below] = superposed_below(displacement, places[below], depths[below], punch_below)
        v, v_z, psi_r_by_r = superposed_on(displacement, places[surface])
        nothing = np.zeros(v.size)
        total[:, surface] = [v, v_z, nothing, nothing, nothing, psi_r_by_r]
    potentials = Potentials(*(part.reshape(radius.shape) for part in total))
    return combine(potentials, radius, depth, modulus=modulus, poisson=poisson, shear=shear)


# ------------------------------------------------------------------------------------------------ below the surface


def superposed_below(displacement: Displacement, r: Array, z: Array, punch: Punch) -> Array:
    """Superpose flat punches at points below the surface.

    Parameters
    ----------
    displacement : Displacement
        u(x) of the springs, in contact.
    r, z : ndarray, (n,)
        Distance from the axis and depth [m], z > 0.
    punch
        Takes r, z, the radius t of punches and t - r where it is known better than by subtraction; returns the
        potentials of punches under unit line load.

    Returns
    -------
    ndarray, (m, n)
        A row for every potential.
    """
    deep = np.maximum(z, SHALLOWEST * displacement.radius)
    parts = [
        _below(displacement, r[start : start + BLOCK], deep[start : start + BLOCK], punch)
        for start in range(0, max(r.size, 1), BLOCK)
    ]
    return np.concatenate(parts, axis=1)


def _below(displacement: Displacement, r: Array, z: Array, punch: Punch) -> Array:
    total = np.array(punch(r, z, np.asarray(displacement.radius), None))
    total *= displacement.edge
    waiting: list[tuple[Cluster, Indices]] = [(pile(displacement).root, np.arange(r.size))]
    while waiting:
        cluster, points = waiting.pop()
        if cluster.radii.size:
            middle, half = 0.5 * (cluster.lower + cluster.upper), 0.5 * (cluster.upper - cluster.lower)
            far = _distance((r[points] + 1j * z[points] - middle) / half) > FAR
            total[:, points[far]] += _far(cluster, r[points[far]], z[points[far]], punch)
            waiting += [(child, points[~far]) for child in cluster.children if not np.all(far)]
        else:
            for panel in cluster.panels:
                for group, part in _near(panel, r[points], z[points], punch):
                    total[:, points[group]] += part
    return total


def _far(cluster: Cluster, r: Array, z: Array, punch: Punch) -> Array:
    """Superpose the punches that stand for a cluster."""
    parts = []
    step = max(CHUNK // cluster.radii.size, 1)
    for start in range(0, max(r.size, 1), step):
        flat = punch(r[start : start + step, None], z[start : start + step, None], cluster.radii, None)
        parts.append(np.array([part @ cluster.weights for part in flat]))
    return np.concatenate(parts, axis=1)


def _near(panel: Panel, r: Array, z: Array, punch: Punch) -> Iterator[tuple[Indices, Array]]:
    """Integrate one panel, in groups of points that share a rule."""
    s, lower, upper, rank = panel.base, panel.lower, panel.upper, panel.series.size
    square, product = (r - s) * (r + s) - z * z, r * z  # p + iq = sqrt((r + iz)^2 - s^2)
    large = np.sqrt(0.5 * (np.hypot(square, 2.0 * product) + np.abs(square)))
    small = product / large
    p, q = np.where(square >= 0.0, large, small), np.where(square >= 0.0, small, large)
    share = (s / np.hypot(r / q, 1.0)) ** 2 if s > 0.0 else np.zeros(r.size)  # q^2 - z^2
    # where the integrand is not smooth: at p + iq, and where t(y) or sqrt(r + t) is not
    middle, half = 0.5 * (lower + upper), 0.5 * (upper - lower)
    branch = np.full(r.shape, 1j * s) if s > 0.0 else 1j * q - p
    distance = np.minimum(_distance((p + 1j * q - middle) / half), _distance((branch - middle) / half))
    count = _enough(15.0 / distance + 0.6 * rank)

    def punches(i: Indices, y: Array, offset: Array, measure: Array) -> Array:
        t = np.hypot(s, y) if s > 0.0 else y
        excess = (offset * (y + p[i]) + share[i]) / (r[i] + t)
        weights = panel.weight(y) * measure
        return np.array([np.sum(part * weights, axis=1) for part in punch(r[i], z[i], t, excess)])

    straight = distance > STRAIGHT
    for i, nodes, weights in _groups(np.flatnonzero(straight), np.ones(r.size, dtype=int), count):
        y = np.broadcast_to(lower + (upper - lower) * nodes, (i.size, nodes.size))
        yield i[:, 0], punches(i, y, y - p[i], (upper - lower) * weights)

    curved = np.flatnonzero(~straight)
    first, last = np.zeros(r.size), np.zeros(r.size)
    first[curved], last[curved] = (np.arcsinh((end - p[curved]) / q[curved]) for end in (lower, upper))
    parts = np.ceil((last - first) / LONGEST).astype(int)
    length, centre = (last - first)[curved], 0.5 * (first + last)[curved]
    beyond = np.arcsinh((branch - p)[curved] / q[curved])
    nearest = np.minimum(_distance((1j * np.pi - 2.0 * centre) / length), _distance(2.0 * (beyond - centre) / length))
    nearest = np.where(parts[curved] == 1, nearest, _distance(1j * np.pi * parts[curved] / length))
    count[curved] = _enough(16.0 / nearest + 0.8 * rank)
    for i, nodes, weights in _groups(curved, parts, count):
        v = first[i] + (last - first)[i] * nodes
        offset = q[i] * np.sinh(v)
        y = np.clip(p[i] + offset, lower, upper)
        yield i[:, 0], punches(i, y, offset, (last - first)[i] * q[i] * np.cosh(v) * weights)


def _groups(chosen: Indices, parts: Indices, count: Indices) -> Iterator[tuple[Indices, Array, Array]]:
    """Yield columns of points with the same rule, and its nodes and weights, in pieces of at most `CHUNK` pairs."""
    for some, many in np.unique(np.stack([parts[chosen], count[chosen]]), axis=1).T:
        members = chosen[(parts[chosen] == some) & (count[chosen] == many)]
        nodes, weights = _rule(int(some), int(many))
        for start in range(0, members.size, step := max(CHUNK // nodes.size, 1)):
            yield members[start : start + step, None], nodes, weights


def _enough(wanted: Array) -> Indices:
    return np.asarray(COUNTS[np.minimum(np.searchsorted(COUNTS, wanted), COUNTS.size - 1)], dtype=np.intp)


def _distance(w: NDArray[Any]) -> Array:
    """Return ln(rho) of the ellipse with foci at -1 and 1 through the complex points w, at least 1e-3."""
    root = np.sqrt(w + 0j - 1.0) * np.sqrt(w + 0j + 1.0)
    return np.asarray(np.maximum(np.abs(np.log(np.abs(w + root))), 1e-3))


@functools.lru_cache(maxsize=256)
def _rule(parts: int, count: int) -> tuple[Array, Array]:
    """Return the Gauss-Legendre rule of `count` nodes on each of equal `parts` of [0, 1]."""
    nodes, weights = gauss_legendre(count)
    return (np.arange(parts)[:, None] + nodes).ravel() / parts, np.tile(weights, parts) / parts


# ------------------------------------------------------------------------------------------------ on the surface


def superposed_on(displacement: Displacement, r: Array) -> Array:
    """Superpose the punches at points of the surface, r of shape ``(n,)``; the rows are V, V_z and psi_r / r."""
    return np.concatenate(
        [_surface(displacement, r[start : start + BLOCK]) for start in range(0, max(r.size, 1), BLOCK)], axis=1
    )


def _surface(displacement: Displacement, r: Array) -> Array:
    panels, a = pile(displacement).panels, displacement.radius
    total = np.zeros((3, r.size))  # V, V_z and psi_r/r
    for panel in panels:
        p = np.sqrt(np.abs(r - panel.base) * (r + panel.base))
        for case, superposed in ((r > panel.base, _above), (r < panel.base, _before), (r == panel.base, _at)):
            if np.any(case):
                total[:, case] += superposed(panel, r[case], p[case])
    if displacement.edge != 0.0:
        punch = punch_surface(r, np.asarray(a))
        total += displacement.edge * np.array([punch.v, punch.v_z, punch.psi_r_by_r])
    v, v_z, psi_r_by_r = total
    for b, strength in displacement.kinks:
        if strength != 0.0 and 0.0 < b < a:
            v_z[r == b] = -math.copysign(math.inf, strength)
    axis = r == 0.0
    if np.any(axis):
        v_z[axis] -= 2.0 * _tip(displacement, panels[0])
        psi_r_by_r[axis] = -0.5 * v_z[axis]
    return np.array([v, v_z, psi_r_by_r])


def _above(panel: Panel, r: Array, p: Array) -> Array:
    """Integrate a panel for r > base, p = sqrt(r^2 - base^2): over punches narrower, then wider than r."""
    nodes, weights = gauss_legendre(NODES)
    first, last = (np.arcsin(np.minimum(end / p, 1.0))[:, None] for end in (panel.lower, panel.upper))
    angle = first + (last - first) * nodes
    y, root = p[:, None] * np.sin(angle), p[:, None] * np.cos(angle)  # root = sqrt(r^2 - t^2) = dy/dv
    t = np.hypot(panel.base, y)
    weight = panel.weight(y) * root * (last - first) * weights
    result = np.array([np.sum(2.0 * np.arctan2(t, root) * weight, axis=1), np.zeros(r.size), np.zeros(r.size)])
    result[2] = np.sum(2.0 * t * weight, axis=1) / (r * r)
    wider = p < panel.upper
    own = p[wider]
    start, stop = (np.arcsinh(np.sqrt(np.maximum(end - own, 0.0) * (end + own)) / own) for end in panel[1:3])
    result[:, wider] += _wider(panel, r[wider], start, stop, lambda i, v: (own[i] * np.cosh(v), own[i] * np.sinh(v)))
    return result


def _before(panel: Panel, r: Array, p: Array) -> Array:
    """Integrate a panel for r < base, p = sqrt(base^2 - r^2): all punches are wider than r."""
    start, stop = np.arcsinh(panel.lower / p), np.arcsinh(panel.upper / p)
    return _wider(panel, r, start, stop, lambda i, v: (p[i] * np.sinh(v), p[i] * np.cosh(v)))


def _at(panel: Panel, r: Array, _: Array) -> Array:
    """Integrate a panel for r = base; the first panel without V_z, see `_tip`."""
    nodes, weights = gauss_legendre(NODES)
    y = panel.lower + (panel.upper - panel.lower) * nodes
    weight = panel.weight(y) * (panel.upper - panel.lower) * weights
    v_z = 0.0 if panel.base == panel.lower == 0.0 else -2.0 * np.sum(weight / y)
    psi_r_by_r = np.sum(2.0 / (np.hypot(panel.base, y) + y) * weight)
    return np.repeat([[np.pi * np.sum(weight)], [v_z], [psi_r_by_r]], r.size, axis=1)


def _wider(panel: Panel, r: Array, start: Array, stop: Array, place: Place) -> Array:
    """Integrate over punches wider than r; `place` gives y and sqrt(t^2 - r^2) = dy/dv at v for some of the points."""
    result = np.zeros((3, r.size))
    parts = np.ceil((stop - start) / SHORT).astype(int)
    for i, nodes, weights in _groups(np.flatnonzero(parts), parts, np.full(r.size, NODES)):
        y, root = place(i, start[i] + (stop - start)[i] * nodes)
        weight = panel.weight(y) * (stop - start)[i] * weights
        kernels = (np.pi * root, np.full(1, -2.0), 2.0 * root / (np.hypot(panel.base, y) + root))
        result[:, i[:, 0]] = [np.sum(kernel * weight, axis=1) for kernel in kernels]
    return result


def _tip(displacement: Displacement, panel: Panel) -> float:
    """Integrate -u'(t)/t over the first panel: infinite where u' does not vanish at the axis, as under a cone."""
    refined = panel.upper < 1e-6 * displacement.radius  # u' is no power series there
    place = panel.upper * (1.0 if refined else 1e-9)
    far, near = (-float(displacement.slope(np.array([x]))[0]) for x in (place, 1e-2 * place))
    rising = abs(near) <= abs(far)
    power = 0.5 * math.log10(far / near) if far * near > 0.0 else float(rising)
    if power < 0.01:
        return math.copysign(math.inf, near)
    if refined:
        return far / power
    nodes, weights = gauss_legendre(NODES)
    return float(np.sum(panel.weight(panel.upper * nodes) * weights / nodes))
