r"""Predicted force of bodies that yield at all positions of a measured curve, loaded, let go, and loaded again.

Beyond the farthest position so far the contact follows its curve of first loading, before it the dent that this
position has left.  The farthest position is that of the turns of the curve, not of single points, so that noise of the
position is no unloading.  In a machine of the compliance c the depth solves :math:`d + c\,F(d) = D`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from winkler.fitting.elastic.contact import DirectionRun
from winkler.numerics.types import Array
from winkler.problems.normal.solve_contact import at_depth
from winkler.problems.plastic.first_loading import FirstLoading, LoadingTable
from winkler.problems.plastic.indentation import PlasticIndentation, refuse_other_shapes
from winkler.problems.plastic.release import Release
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

MOST_STEPS = 60
SETTLED = 1e-11
"""Last step of Newton's method for the depth in a machine, in parts of the depth."""


class YieldingContact(NamedTuple):
    """Forces [N], their slopes over the depth [N/m], and contact radii [m], at all positions ``(n,)``."""

    force: Array
    slope: Array
    radius: Array


def yielding_contact(
    problem: Callable[[], PlasticIndentation], compliance: float, position: Array, runs: tuple[DirectionRun, ...]
) -> YieldingContact:
    """Return the contact at positions from first touch on.

    Parameters
    ----------
    problem : callable
        Returns the model; its path does not matter.
    compliance : float
        Of the machine [m/N].
    position : ndarray, (n,)
        D [m].
    runs : tuple of DirectionRun
        The parts of the curve of one direction.

    Raises
    ------
    OutsideValidity
        If the numbers of the model are outside the law of yielding, or the curve is.
    """
    curve = _loading(problem)
    first, after, tops = _memory(position, runs)
    columns = np.zeros((3, position.size))
    if not tops.size:
        return YieldingContact(*columns)
    loaded = _Loaded(curve, float(tops[-1]))
    columns[:, first] = _in_machine(lambda depth: loaded(depth), compliance, position[first])
    top_depth = tops - compliance * _in_machine(lambda depth: loaded(depth), compliance, tops)[0]
    greatest, _ = curve.at_level(top_depth, by_force=False)
    refuse_other_shapes("fit", curve.bed, greatest.radius)
    yielded = greatest.radius > curve.onset
    index = np.flatnonzero(after >= 0)
    elastic = index[~yielded[after[index]]]
    columns[:, elastic] = _in_machine(lambda depth: loaded(depth), compliance, position[elastic])
    dented = index[yielded[after[index]]]
    if dented.size:
        release, of = Release(curve.bed, greatest), after[dented]
        left = (greatest.depth - greatest.recovery)[of]

        def let_go(depth: Array) -> Array:
            rest, radius = release.at(np.minimum(depth - left, greatest.recovery[of]), of, by_force=False)
            return np.stack([release.force(rest, radius, of), curve.bed.stiffness(radius), radius])

        columns[:, dented] = _in_machine(let_go, compliance, position[dented])
    return YieldingContact(*columns)


def rough_force(problem: Callable[[], PlasticIndentation], depth: float) -> float:
    """Return the force of first loading at a depth [N]."""
    state, _ = _loading(problem).at_level(np.array([depth]), by_force=False)
    return float(state.force[0])


def turning_depths(depth: Array, runs: tuple[DirectionRun, ...]) -> Array:
    """Return the depths at which a curve turns [m]."""
    return np.array([max(float((np.max if run.inward else np.min)(depth[run.start : run.stop])), 0.0) for run in runs])


def _loading(problem: Callable[[], PlasticIndentation]) -> FirstLoading:
    try:
        return problem()._loading
    except InvalidInput as error:  # such a strength was given by no one: the search has come to it
        raise OutsideValidity(str(error)) from None


def _memory(position: Array, runs: tuple[DirectionRun, ...]) -> tuple[Array, Array, Array]:
    """Return which points are on first loading ``(n,)``, after which turn the others are (-1: none), and the turns.

    A turn is the farthest position of what lies before it [m].
    """
    after = np.full(position.size, -1)
    tops: list[float] = []
    for run in runs:
        here = slice(run.start, run.stop)
        if run.inward and tops:
            after[here] = np.where(position[here] <= tops[-1], len(tops) - 1, -1)
        top = float(np.max(position[here]))
        if top > (tops[-1] if tops else 0.0):
            tops.append(top)
        if not run.inward:  # also one that was recorded without its loading
            after[here] = len(tops) - 1
    after[position <= 0.0] = -1
    return (after < 0) & (position > 0.0), after, np.array(tops)


class _Loaded:
    """Force, slope and radius of first loading over the depth, by cubics through its curve.

    Parameters
    ----------
    curve : FirstLoading
    highest : float
        Greatest depth [m].
    """

    def __init__(self, curve: FirstLoading, highest: float) -> None:
        from scipy.interpolate import CubicSpline

        self.curve, self.first, self.force = curve, highest, None
        onset = curve.at_onset(by_force=False)
        if highest > onset:
            table = LoadingTable.of_levels(curve, np.array([highest]), by_force=False)
            self.first = onset or float(table.states.depth[0])
            places = np.log(table.states.depth)
            self.force = CubicSpline(places, np.log(table.states.force))
            self.radius = CubicSpline(places, np.log(table.states.radius))

    def __call__(self, depth: Array) -> Array:
        """Return them at depths ``(n,)``, as ``(3, n)``."""
        found = np.zeros((3, depth.size))
        yields = depth > self.first
        if self.force is not None and yields.any():
            place = np.log(depth[yields])
            force = np.exp(self.force(place))
            found[:, yields] = force, self.force(place, 1) * force / depth[yields], np.exp(self.radius(place))
        low = (depth > 0.0) & ~yields
        if low.any():
            found[:, low] = self._below(depth[low])
        return found

    def _below(self, depth: Array) -> Array:
        """Return them below the curve: elastic, or, of a sharp tip that yields at once, powers of the depth."""
        bed = self.curve.bed
        if self.curve.onset > 0.0 or self.force is None:
            depth, radius = at_depth(bed, depth)
            stiffness = bed.stiffness(radius)
            return np.stack([stiffness * depth - bed.gap_load(radius), stiffness, radius])
        place = np.log(self.first)
        power = float(self.force(place, 1))
        force = float(np.exp(self.force(place))) * (depth / self.first) ** power
        radius = np.exp(float(self.radius(place))) * (depth / self.first) ** float(self.radius(place, 1))
        return np.stack([force, power * force / depth, radius])


def _in_machine(contact: Callable[[Array], Array], compliance: float, position: Array) -> Array:
    """Return force, slope over the position and radius at positions ``(n,)``, as ``(3, n)``."""
    depth = position
    if compliance == 0.0 or not position.size:
        return contact(depth)
    depth = 0.5 * position
    for _ in range(MOST_STEPS):
        force, slope, _ = contact(depth)
        step = (depth + compliance * force - position) / (1.0 + compliance * slope)
        depth = np.where(step < depth, depth - step, 0.5 * depth)
        if np.all(np.abs(step) <= SETTLED * np.abs(depth)):
            found = contact(depth)
            found[1] /= 1.0 + compliance * found[1]
            return found
    raise NotConverged(f"fit: the depth in a machine of {compliance:.3g} m/N was not found in {MOST_STEPS} steps.")
