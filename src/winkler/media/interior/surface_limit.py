r"""The field on the surface of a body under an axisymmetric contact: the limit of that below, and one without poles.

In :math:`p=\sqrt{|r^2-s^2|}` of a panel that begins at s, :math:`y = p\sin v` for punches narrower than r and
:math:`y = p\cosh v` for wider ones remove the singularities at :math:`t=r` altogether.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from winkler.media.medium import Displacement
from winkler.media.punch_field import punch_surface
from winkler.media.punch_superposition import LoadPanel, punch_superposition
from winkler.numerics.chunks import chunks
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array

Indices = NDArray[np.intp]

POINTS_PER_BLOCK = 20_000
"""Largest number of points at once."""
PAIRS_PER_CHUNK = 1 << 16
"""Largest number of (point, node) pairs at once: the temporary arrays stay in the cache."""
FEW_PAIRS = 1 << 12
"""Number of such pairs up to which one rule for all points takes less time than a rule for each."""
MOST_NODES = 1 << 10
"""More nodes than any rule has."""


def point_groups(chosen: Indices, parts: Indices, count: Indices) -> Iterator[tuple[Indices, Array, Array]]:
    """Yield points with the same rule, and its nodes and weights, in pieces of at most `PAIRS_PER_CHUNK` pairs.

    Few points share the rule that is enough for all of them.
    """
    rules = MOST_NODES * parts[chosen] + count[chosen]
    most = int(np.max(parts[chosen], initial=1)), int(np.max(count[chosen], initial=1))
    if chosen.size * math.prod(most) <= FEW_PAIRS:
        rules[:] = MOST_NODES * most[0] + most[1]
    for rule in sorted(set(rules.tolist())):
        members = chosen[rules == rule]
        nodes, weights = _rule(*divmod(rule, MOST_NODES))
        for part in chunks(members.size, nodes.size, PAIRS_PER_CHUNK):
            yield members[part, None], nodes, weights


@functools.lru_cache(maxsize=256)
def _rule(parts: int, count: int) -> tuple[Array, Array]:
    """Return the Gauss-Legendre rule of `count` nodes on each of equal `parts` of [0, 1]."""
    nodes, weights = gauss_legendre(count)
    return (np.arange(parts)[:, None] + nodes).ravel() / parts, np.tile(weights, parts) / parts


Place = Callable[[Indices, Array], tuple[Array, Array]]

ROUNDED_APEX = 1e-6
"""A slope at the axis that is less than this part of the slope half a panel away is rounding, not an apex."""
RULE_NODES, LONGEST_INTERVAL = 48, 4.0
"""Points are few here: one rule of many nodes on short intervals of v."""


def superposed_on(displacement: Displacement, r: Array) -> Array:
    """Superpose the punches at points of the surface, r of shape ``(n,)``; the rows are V, V_z and psi_r / r."""
    found = np.empty((3, r.size))
    for part in chunks(r.size, 1, POINTS_PER_BLOCK):
        found[:, part] = _surface(displacement, r[part])
    return found


def _surface(displacement: Displacement, r: Array) -> Array:
    panels, a = punch_superposition(displacement).panels, displacement.radius
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


def _above(panel: LoadPanel, r: Array, p: Array) -> Array:
    """Integrate a panel for r > base, p = sqrt(r^2 - base^2): over punches narrower, then wider than r."""
    nodes, weights = gauss_legendre(RULE_NODES)
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


def _before(panel: LoadPanel, r: Array, p: Array) -> Array:
    """Integrate a panel for r < base, p = sqrt(base^2 - r^2): all punches are wider than r."""
    start, stop = np.arcsinh(panel.lower / p), np.arcsinh(panel.upper / p)
    return _wider(panel, r, start, stop, lambda i, v: (p[i] * np.sinh(v), p[i] * np.cosh(v)))


def _at(panel: LoadPanel, r: Array, _: Array) -> Array:
    """Integrate a panel for r = base; the first panel without V_z, see `_tip`."""
    nodes, weights = gauss_legendre(RULE_NODES)
    y = panel.lower + (panel.upper - panel.lower) * nodes
    weight = panel.weight(y) * (panel.upper - panel.lower) * weights
    v_z = 0.0 if panel.base == panel.lower == 0.0 else -2.0 * np.sum(weight / y)
    psi_r_by_r = np.sum(2.0 / (np.hypot(panel.base, y) + y) * weight)
    return np.repeat([[np.pi * np.sum(weight)], [v_z], [psi_r_by_r]], r.size, axis=1)


def _wider(panel: LoadPanel, r: Array, start: Array, stop: Array, place: Place) -> Array:
    """Integrate over punches wider than r; `place` gives y and sqrt(t^2 - r^2) = dy/dv at v for some of the points."""
    result = np.zeros((3, r.size))
    parts = np.ceil((stop - start) / LONGEST_INTERVAL).astype(int)
    for i, nodes, weights in point_groups(np.flatnonzero(parts), parts, np.full(r.size, RULE_NODES)):
        y, root = place(i, start[i] + (stop - start)[i] * nodes)
        weight = panel.weight(y) * (stop - start)[i] * weights
        kernels = (np.pi * root, np.full(1, -2.0), 2.0 * root / (np.hypot(panel.base, y) + root))
        result[:, i[:, 0]] = [np.sum(kernel * weight, axis=1) for kernel in kernels]
    return result


def _tip(displacement: Displacement, panel: LoadPanel) -> float:
    """Integrate -u'(t)/t over the first panel: infinite where u' does not vanish at the axis, as under a cone."""
    refined = panel.upper < 1e-6 * displacement.radius  # u' is no power series there
    place = panel.upper * (1.0 if refined else 1e-9)
    outer, far, near = -np.asarray(displacement.slope(np.array([0.5 * panel.upper, place, 1e-2 * place])))
    if not refined and max(abs(far), abs(near)) <= ROUNDED_APEX * abs(outer):  # what is left there is rounding
        near = 0.0
    rising = abs(near) <= abs(far)
    power = 0.5 * math.log10(far / near) if far * near > 0.0 else float(rising)
    if power < 0.01:
        return math.copysign(math.inf, near)
    if refined:
        return float(far / power)
    nodes, weights = gauss_legendre(RULE_NODES)
    return float(np.sum(panel.weight(panel.upper * nodes) * weights / nodes))
