"""How a viscoelastic contact responds along a measured motion, or under measured forces, fast enough for a fit.

The elastic response of the bed at E* = 1 is tabulated once; `winkler.numerics.springs.hereditary` applies the
relaxation.
"""

from __future__ import annotations

import functools
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.loading.loads import Depth
from winkler.numerics.springs.exponential_sums import CreepSeries, RelaxationSeries
from winkler.numerics.springs.hereditary import forces_of_motion, motion_of_forces
from winkler.numerics.types import Array
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.solve_contact import at_end
from winkler.values.errors import OutsideValidity

TABLE_INTERVALS = 800
TABLE_RATIO = 1.25
"""Tables end at powers of it, so that one table serves many contact points."""


class ElasticTable(NamedTuple):
    """The elastic response of a bed, over roots of d / deepest evenly spaced from 0 to 1.

    Parameters
    ----------
    deepest : float
        [m].
    force, slope, radius : ndarray, (801,)
        Phi(d) at E* = 1 Pa [N], its derivative with respect to the root [N], and a [m].
    """

    deepest: float
    force: Array
    slope: Array
    radius: Array

    def radius_at(self, depth: Array) -> Array:
        """Return contact radii at depths [m]."""
        root = np.sqrt(np.maximum(depth, 0.0) / self.deepest)
        wide = np.interp(root, np.linspace(0.0, 1.0, self.radius.size), self.radius)
        return np.where(depth > 0.0, wide, 0.0)


class ContactHistory(NamedTuple):
    """Force [N], depth [m], and the depth at which an elastic contact is as wide [m], each ``(n,)``."""

    force: Array
    depth: Array
    edge: Array


def elastic_table(bed: Bed, deepest: float) -> ElasticTable:
    """Return the elastic response of a bed, at least up to a depth [m].

    Parameters
    ----------
    bed : Bed
        With E* = 1 Pa.
    deepest : float
        [m].

    Raises
    ------
    OutsideValidity
        If the profile ends before, or a contact there is no disc.
    """
    end = at_end(bed)[0]
    step = float(np.ceil(np.log(max(deepest, 1e-30)) / np.log(TABLE_RATIO)))
    rounded = TABLE_RATIO**step
    if bed.reach < bed.rim and rounded > end:
        if deepest > end:
            raise OutsideValidity(
                f"fit: the curve leads to depths of {deepest:.4g} m, beyond {end:.4g} m, where the profile is not "
                "defined; cut the curve off before, or give a profile that extends farther."
            )
        rounded = end
    return _table(bed, rounded)


@functools.lru_cache(maxsize=64)
def _table(bed: Bed, deepest: float) -> ElasticTable:
    root = np.linspace(0.0, 1.0, TABLE_INTERVALS + 1)
    depth = deepest * root**2
    solved = Indentation(bed, Depth(depth[1:])).solve()
    force = np.concatenate([[0.0], np.asarray(solved.force)])
    slope = np.concatenate([[0.0], np.asarray(solved.stiffness)]) * 2.0 * root * deepest
    radius = np.concatenate([np.asarray(solved.radius)[:1] * 0.0, np.asarray(solved.radius)])
    return ElasticTable(deepest, force, slope, radius)


def forces(
    table: ElasticTable, series: RelaxationSeries, time: Array, place: Array, turn: int, compliance: float
) -> ContactHistory:
    """Return the response of a contact along a motion.

    Parameters
    ----------
    table : ElasticTable
        At least up to the greatest position.
    series : RelaxationSeries
        E*(t).
    time, place : ndarray, (n,)
        [s] and D [m] from first touch; a first place beyond it is reached suddenly.
    turn : int
        The first index of the retraction; n if there is none.
    compliance : float
        Of the machine [m/N].
    """
    times = np.concatenate([time[:1], time])
    driven = np.concatenate([np.minimum(place[:1], 0.0), place])
    count = times.size
    force, depth, edge, phi = (np.empty(count) for _ in range(4))
    drift, load = np.empty((count, series.times.size)), np.empty((count, series.times.size))
    forces_of_motion(
        times, driven, turn + 1, compliance, series.relaxed, series.viscosity, series.moduli, series.times,
        table.deepest, table.force, table.slope, force, depth, edge, drift, load, phi,
    )  # fmt: skip
    return ContactHistory(force[1:], depth[1:], edge[1:])


def positions(table: ElasticTable, series: CreepSeries, time: Array, force: Array) -> Array:
    """Return the depths ``(n,)`` [m] under forces [N], the first sudden; not a number beyond the table."""
    depth = np.empty(time.size)
    motion_of_forces(
        time, force, series.glassy, series.fluidity, series.compliances, series.times, table.deepest, table.force,
        table.slope, depth,
    )  # fmt: skip
    return depth
