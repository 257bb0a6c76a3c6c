r"""The field inside a body under an axisymmetric contact: flat punches of all radii, superposed.

With `flat`, the field of one punch under unit line load, the springs' displacement u(x) gives

.. math:: \text{field}(r, z) = E^*\Big[\int_0^a \text{flat}(r, z; t)\,(-u'(t))\,\mathrm dt
          + u(a)\,\text{flat}(r, z; a)\Big].

Near the surface `flat` is almost singular at :math:`t = r`, in truth at :math:`t = r + iz`.  In the variable :math:`y =
\sqrt{t^2-s^2}` of a panel (`punch_superposition`) that is :math:`y = p + iq`; with :math:`y = p + q\sinh v` it lies at
:math:`v = i\pi/2` whatever the depth, so the work grows with the logarithm of the depth only.  The field passes
continuously into that on the surface itself (`winkler.media.interior.surface_limit`).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from winkler.media.interior.surface_limit import PAIRS_PER_CHUNK, POINTS_PER_BLOCK, Indices, point_groups, superposed_on
from winkler.media.medium import Displacement
from winkler.media.punch_field import BodyField, Potentials, combine, punch_below
from winkler.media.punch_superposition import CLUSTER_DISTANCE, LoadPanel, PunchCluster, punch_superposition
from winkler.numerics.chunks import chunks
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput

Punch = Callable[[Array, Array, Array, Array | None], tuple[Array, ...]]

NODE_COUNTS = np.array([6, 8, 10, 12, 16, 20, 24, 28, 32, 40, 48, 56, 64, 80, 96, 112])
"""Numbers of nodes of the rules; one of them is chosen for every point and panel."""
LONGEST_INTERVAL = 12.0
"""Longest interval of v that one rule covers."""
LEAST_DEPTH_RATIO = 1e-30
"""Least depth below the surface, in contact radii, that is resolved; cubes of it must not underflow."""
MAPPING_DISTANCE = math.log(3.0)
"""A panel is mapped by sinh only if the singularity is nearer than this, ln(rho) of its Bernstein ellipse."""


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
    for word, coordinate in (("r", radius), ("z", depth)):
        bad = coordinate[~(np.isfinite(coordinate) & (coordinate >= 0.0))]
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
    deep = np.maximum(z, LEAST_DEPTH_RATIO * displacement.radius)
    parts = [_below(displacement, r[part], deep[part], punch) for part in chunks(max(r.size, 1), 1, POINTS_PER_BLOCK)]
    return np.concatenate(parts, axis=1)


def _below(displacement: Displacement, r: Array, z: Array, punch: Punch) -> Array:
    total = np.array(punch(r, z, np.asarray(displacement.radius), None))
    total *= displacement.edge
    waiting: list[tuple[PunchCluster, Indices]] = [(punch_superposition(displacement).root, np.arange(r.size))]
    while waiting:
        cluster, points = waiting.pop()
        if cluster.radii.size:
            middle, half = 0.5 * (cluster.lower + cluster.upper), 0.5 * (cluster.upper - cluster.lower)
            far = _distance((r[points] + 1j * z[points] - middle) / half) > CLUSTER_DISTANCE
            total[:, points[far]] += _far(cluster, r[points[far]], z[points[far]], punch)
            waiting += [(child, points[~far]) for child in cluster.children if not np.all(far)]
        else:
            for panel in cluster.panels:
                for group, part in _near(panel, r[points], z[points], punch):
                    total[:, points[group]] += part
    return total


def _far(cluster: PunchCluster, r: Array, z: Array, punch: Punch) -> Array:
    """Superpose the punches that stand for a cluster."""
    parts = []
    for rows in chunks(max(r.size, 1), cluster.radii.size, PAIRS_PER_CHUNK):
        flat = punch(r[rows, None], z[rows, None], cluster.radii, None)
        parts.append(np.array([part @ cluster.weights for part in flat]))
    return np.concatenate(parts, axis=1)


def _near(panel: LoadPanel, r: Array, z: Array, punch: Punch) -> Iterator[tuple[Indices, Array]]:
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
    count = _enough(17.0 / distance + 0.6 * rank + 4.0)

    def punches(i: Indices, y: Array, offset: Array, measure: Array) -> Array:
        t = np.hypot(s, y) if s > 0.0 else y
        excess = (offset * (y + p[i]) + share[i]) / (r[i] + t)
        weights = np.broadcast_to(panel.weight(y) * measure, excess.shape)
        return np.array([np.einsum("ij,ij->i", part, weights) for part in punch(r[i], z[i], t, excess)])

    straight = distance > MAPPING_DISTANCE
    for i, nodes, weights in point_groups(np.flatnonzero(straight), np.ones(r.size, dtype=int), count):
        y = lower + (upper - lower) * nodes
        yield i[:, 0], punches(i, y, y - p[i], (upper - lower) * weights)

    curved = np.flatnonzero(~straight)
    first, last = np.zeros(r.size), np.zeros(r.size)
    first[curved], last[curved] = (np.arcsinh((end - p[curved]) / q[curved]) for end in (lower, upper))
    parts = np.ceil((last - first) / LONGEST_INTERVAL).astype(int)
    length, centre = (last - first)[curved], 0.5 * (first + last)[curved]
    beyond = np.arcsinh((branch - p)[curved] / q[curved])
    nearest = np.minimum(_distance((1j * np.pi - 2.0 * centre) / length), _distance(2.0 * (beyond - centre) / length))
    nearest = np.where(parts[curved] == 1, nearest, _distance(1j * np.pi * parts[curved] / length))
    count[curved] = _enough(18.0 / nearest + 0.8 * rank + 4.0)
    for i, nodes, weights in point_groups(curved, parts, count):
        v = first[i] + (last - first)[i] * nodes
        offset = q[i] * np.sinh(v)
        y = np.clip(p[i] + offset, lower, upper)
        yield i[:, 0], punches(i, y, offset, (last - first)[i] * q[i] * np.cosh(v) * weights)


def _enough(needed: Array) -> Indices:
    return np.asarray(
        NODE_COUNTS[np.minimum(np.searchsorted(NODE_COUNTS, needed), NODE_COUNTS.size - 1)], dtype=np.intp
    )


def _distance(w: NDArray[Any]) -> Array:
    """Return ln(rho) of the ellipse with foci at -1 and 1 through the complex points w, at least 1e-3."""
    root = np.sqrt(w + 0j - 1.0) * np.sqrt(w + 0j + 1.0)
    return np.asarray(np.maximum(np.abs(np.log(np.abs(w + root))), 1e-3))
