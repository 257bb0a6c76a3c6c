r"""Boundary elements of a strip on half-planes, and its friction over one step: what sticks, and what slips where to.

Tractions are linear between evenly spaced nodes and zero at both ends.  The surfaces move along each other by

.. math:: u(x) = -\frac2{\pi E^*}\int q(s)\,\ln\frac{|x-s|}d\,\mathrm ds ,

counted from a distance d.  While the shift W is imposed, a node slips by :math:`S = W - u + u_0`, with what it was
displaced before; it sticks with S = 0 while friction allows, and slips in the direction of its traction otherwise.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.errors import NotConverged
from winkler.numerics.types import Array

__all__ = ["StripStep", "first_to_stick", "strip_compliance", "strip_step"]

MOST_ITERATIONS = 2000
ALL_AT_ONCE = 30
"""Iterations in which all nodes change that are wrong."""


def strip_compliance(count: int, spacing: float, reference: float) -> Array:
    """Return the displacement over 1/E* [m] at nodes 0, 1, ... `count` spacings away from a unit hat of traction.

    Parameters
    ----------
    count : int
        How far [-].
    spacing, reference : float
        Between nodes, and d [m].
    """
    # second difference of x^2/2 (ln|x/d| - 3/2), whose second derivative is ln|x/d|
    x = spacing * np.arange(-1.0, count + 2.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        twice = np.where(x != 0.0, 0.5 * x * x * (np.log(np.abs(x) / reference) - 1.5), 0.0)
    return np.asarray(-2.0 / np.pi * np.diff(twice, 2) / spacing)


class StripStep(NamedTuple):
    """The strip after a step.

    Parameters
    ----------
    traction : ndarray, (n,)
        Over E* [-].
    slips : ndarray, (n,)
        -1, 0 or 1 where it slips backwards, sticks, slips forwards.
    shift : float
        W [m].
    """

    traction: Array
    slips: Array
    shift: float


def strip_step(
    compliance: Array,
    before: Array,
    bound: Array,
    slips: Array,
    *,
    shift: float = 0.0,
    total: float | None = None,
    weights: Array | None = None,
    rounding: float = 0.0,
) -> StripStep:
    """Return the strip after a step of a given shift, or one that brings its tractions to a given sum.

    Parameters
    ----------
    compliance : ndarray, (n, n)
        Displacement of nodes by tractions over E* [m].
    before : ndarray, (n,)
        u_0 [m].
    bound : ndarray, (n,)
        Greatest traction over E* [-].
    slips : ndarray, (n,)
        Of the step before, from which the search begins.
    shift : float
        W [m], if no sum is given.
    total : float, optional
        Sum of the tractions over E* [-], or of their products with the weights.
    weights : ndarray, (n,), optional
        Of the nodes in the sum, such as their widths; equal without them.
    rounding : float, optional
        Part of the bound, and of the displacements, by which a node may miss its condition.

    Raises
    ------
    NotConverged
        If the zones of stick and slip are not found.
    """
    parts = np.ones(bound.size) if weights is None else weights
    for iteration in range(MOST_ITERATIONS):
        sticks = slips == 0
        if total is not None and not sticks.any():
            sticks[first_to_stick(slips, before - compliance @ (slips * bound), parts @ (slips * bound) - total)] = True
        traction = np.where(sticks, 0.0, slips * bound)
        inner = compliance[np.ix_(sticks, sticks)]
        wanted = before[sticks] - compliance[np.ix_(sticks, ~sticks)] @ traction[~sticks]
        if total is None:
            traction[sticks] = np.linalg.solve(inner, shift + wanted) if sticks.any() else 0.0
        else:
            edge, row = np.ones((len(wanted), 1)), parts[sticks][None, :]
            system = np.block([[inner, -edge], [row, np.zeros((1, 1))]])
            found = np.linalg.solve(system, np.append(wanted, total - float(parts @ traction)))
            traction[sticks], shift = found[:-1], float(found[-1])
        moved = compliance @ traction
        slip = shift + before - moved
        least = rounding * float(np.max(np.abs(moved))) if rounding else 0.0
        over = np.where(np.abs(traction) > bound * (1.0 + rounding), np.sign(traction), 0.0)
        better = np.where(sticks, over, np.where(slips * slip < -least, 0.0, slips))
        wrong = np.flatnonzero(better != np.where(sticks, 0.0, slips))
        if wrong.size == 0:
            return StripStep(traction, np.where(sticks, 0.0, slips), shift)
        changed = wrong if iteration < ALL_AT_ONCE else wrong[-1:]  # one at a time, the last, does not run in circles
        slips = np.where(sticks, 0.0, slips)
        slips[changed] = better[changed]
    raise NotConverged(
        f"The zones of stick and slip of a strip were not found in {MOST_ITERATIONS} iterations; give another count of "
        "elements or points, or a force farther from the one at which all slides."
    )


def first_to_stick(slips: Array, free: Array, surplus: float) -> int:
    """Return which node of a strip that slips everywhere comes to rest: friction bears more than the sum.

    Parameters
    ----------
    slips, free : ndarray, (n,)
        -1 or 1; slip without a shift [m].
    surplus : float
        By how much the sum of the tractions is too great: the shift is to fall, or to rise.
    """
    side = 1.0 if surplus > 0.0 else -1.0
    return int(np.argmin(np.where(slips == side, side * free, np.inf)))
