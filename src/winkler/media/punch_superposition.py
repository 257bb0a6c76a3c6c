r"""The superposition of flat punches that belongs to a displacement of the springs (Jaeger), tabulated for integration.

The punch of radius t carries ``-du(t)``.  Above a kink s of u the slope starts with an inverse square root; over
:math:`y = \sqrt{t^2-s^2}` the weight :math:`H(y) = -u'(t)\,y/t`, :math:`-\mathrm du = H\,\mathrm dy`, is smooth.  It is
tabulated once, on panels short enough for a Chebyshev series.  From a distance many panels are few punches: a
`PunchCluster` replaces them by punches at fixed radii, so that a shape of a thousand kinks costs little more than a
smooth one.
"""

from __future__ import annotations

import functools
import itertools
import math
from typing import NamedTuple

import numpy as np

from winkler.media.medium import Displacement
from winkler.numerics.caching import cached_by_value
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

SAMPLES = 24
"""Samples of H on a panel; its series then ends at this order, less one."""
TOLERANCE = 1e-12
"""Largest last coefficients of a series that is accepted, relative to the largest H."""
NEGLIGIBLE_TOLERANCE = 1e-20
"""The same times width over contact radius: below it a panel is accepted as it is (the very tip of a pointed g)."""
ROUNDING_TOLERANCE = 1e-8
"""A series whose last coefficients do not fall on halving the panel, but are below this, ends in rounding noise."""
ROUNDING = 2e-15
"""Largest coefficients at the end of a series that are left out, relative to the largest H: rounding of its sums."""
MOST_PANELS = 40_000
FEWEST_MEMBERS = 4
"""Fewest panels that are worth a cluster."""
PUNCHES_PER_CLUSTER = 26
"""Punches that stand for a cluster; at a distance of ln(rho) = `CLUSTER_DISTANCE` they are good to 3.2^-26 = 7e-14."""
CLUSTER_DISTANCE = math.log(3.2)


class LoadPanel(NamedTuple):
    """H(y) on ``lower <= y <= upper`` as a Chebyshev series, y = sqrt(t^2 - base^2) [m]."""

    base: float
    lower: float
    upper: float
    series: Array

    def weight(self, y: Array) -> Array:
        """H(y) [-]."""
        s = np.clip((2.0 * y - (self.lower + self.upper)) / (self.upper - self.lower), -1.0, 1.0)
        return np.asarray(np.polynomial.chebyshev.chebval(s, self.series))


class PunchCluster(NamedTuple):
    """Neighbouring panels and the punches, radii and weights [m], that stand for them far from ``[lower, upper]``."""

    panels: tuple[LoadPanel, ...]
    children: tuple[PunchCluster, ...]
    lower: float
    upper: float
    radii: Array
    weights: Array


class PunchSuperposition(NamedTuple):
    """All punches of a displacement: panels in ascending order, and the cluster of all of them."""

    panels: tuple[LoadPanel, ...]
    root: PunchCluster


@cached_by_value(32)
def punch_superposition(displacement: Displacement) -> PunchSuperposition:
    """Return the pile of punches of a displacement; cached by value, so the displacement must be hashable.

    Raises
    ------
    NotConverged
        If u'(x) is not smooth between the kinks.
    """
    panels = tuple(_panels(displacement))
    nodes, weights = gauss_legendre(SAMPLES)
    radii, parts = [], []
    for panel in panels:
        y = panel.lower + (panel.upper - panel.lower) * nodes
        radii.append(np.hypot(panel.base, y))
        parts.append(panel.weight(y) * (panel.upper - panel.lower) * weights)
    return PunchSuperposition(panels, _cluster(panels, np.array(radii), np.array(parts)))


def _cluster(panels: tuple[LoadPanel, ...], t: Array, parts: Array) -> PunchCluster:
    lower = math.hypot(panels[0].base, panels[0].lower)
    upper = math.hypot(panels[-1].base, panels[-1].upper)
    if len(panels) < FEWEST_MEMBERS:
        return PunchCluster(panels, (), lower, upper, np.zeros(0), np.zeros(0))
    # Lagrange's polynomials on Chebyshev points, integrated over the punches
    order, angle = np.arange(PUNCHES_PER_CLUSTER), np.pi * (np.arange(PUNCHES_PER_CLUSTER) + 0.5) / PUNCHES_PER_CLUSTER
    place = np.clip((2.0 * t.ravel() - (lower + upper)) / (upper - lower), -1.0, 1.0)
    moments = np.cos(np.outer(order, np.arccos(place))) @ parts.ravel()
    moments[0] *= 0.5
    weights = (2.0 / PUNCHES_PER_CLUSTER) * (np.cos(np.outer(angle, order)) @ moments)
    half = len(panels) // 2
    children = (_cluster(panels[:half], t[:half], parts[:half]), _cluster(panels[half:], t[half:], parts[half:]))
    return PunchCluster(panels, children, lower, upper, lower + (upper - lower) * np.cos(0.5 * angle) ** 2, weights)


def _panels(displacement: Displacement) -> list[LoadPanel]:
    """Tabulate H on panels between the kinks, halving them until their series end."""
    a = displacement.radius
    waiting: list[tuple[float, float, float]] = []
    for low, high in itertools.pairwise([0.0, *sorted({b for b, _ in displacement.kinks if 0.0 < b < a}), a]):
        near = high if low == 0.0 else min(high, 2.0 * low)  # t = sqrt(s^2 + y^2) is not smooth at y = is
        waiting.append((low, 0.0, math.sqrt((near - low) * (near + low))))
        if near < high:
            waiting.append((0.0, near, high))
    done: list[LoadPanel] = []
    size, parents = 0.0, np.full(len(waiting), math.inf)
    while waiting:
        base, lower, upper = np.array(waiting).T
        series = _series(displacement, base, lower, upper)
        size = max(size, float(np.max(np.abs(series))))
        error = np.max(np.abs(series[:, -3:]), axis=1)
        width = np.hypot(base, upper) - np.hypot(base, lower)
        noise = (error > 0.5 * parents) & (error < ROUNDING_TOLERANCE * size)
        if np.isfinite(parents[0]):
            noise &= noise[np.arange(len(waiting)) ^ 1]  # in both halves of the parent
        ready = (error <= TOLERANCE * size) | (error * width <= NEGLIGIBLE_TOLERANCE * size * a) | noise
        for i in np.flatnonzero(ready):
            last = np.flatnonzero(np.abs(series[i]) > ROUNDING * size)
            done.append(LoadPanel(*waiting[i], series[i, : last[-1] + 1 if last.size else 1]))
        rest = np.flatnonzero(~ready)
        if rest.size and (len(done) + 2 * rest.size > MOST_PANELS or not np.all(np.isfinite(series[rest]))):
            raise NotConverged(
                f"subsurface field: u'(x) is not smooth near x = {math.hypot(base[rest[0]], lower[rest[0]]):.6g} m, "
                "between two kinks; list every point where it is not smooth as a kink, or smooth the profile."
            )
        middle = 0.5 * (lower + upper)
        waiting = [
            (float(base[i]), float(low), float(high))
            for i in rest
            for low, high in ((lower[i], middle[i]), (middle[i], upper[i]))
        ]
        parents = np.repeat(error[rest], 2)
    return sorted(done, key=lambda panel: math.hypot(panel.base, panel.lower))


@functools.cache
def _chebyshev() -> tuple[Array, Array]:
    """Return the Chebyshev points on [0, 1] and the matrix from samples there to a series."""
    angle = np.pi * (np.arange(SAMPLES) + 0.5) / SAMPLES
    matrix = np.cos(np.outer(np.arange(SAMPLES), angle)) * (2.0 / SAMPLES)
    matrix[0] *= 0.5
    return np.cos(0.5 * angle) ** 2, matrix


def _series(displacement: Displacement, base: Array, lower: Array, upper: Array) -> Array:
    points, matrix = _chebyshev()
    s = base[:, None]
    t = np.minimum(np.hypot(s, lower[:, None] + (upper - lower)[:, None] * points), displacement.radius)
    y = np.sqrt((t - s) * (t + s))  # of the rounded t, where the slope is taken: a diverging slope cancels exactly
    slope = np.asarray(displacement.slope(t.ravel()), dtype=float).reshape(t.shape)
    return np.asarray((-slope * (y / t)) @ matrix.T)
