"""The widest stable contact that meets a depth or a force: the one that is left after pressing firmly."""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.equations.bracketing import between
from winkler.numerics.types import Array
from winkler.problems.adhesion.branches_beyond import branches_beyond
from winkler.problems.adhesion.edge_states import EdgeStates, position
from winkler.problems.adhesion.stability import Branch
from winkler.problems.normal.solve_contact import indices_of
from winkler.values.errors import OutsideValidity

GRID_POINTS = 48
NEWTON_LEAST_LOADS, NEWTON_STEPS, NEWTON_TOLERANCE = 8, 6, 1e-8
"""Of so many loads, so many steps of Newton's method are tried, until one is so small: the next would be its square."""
LIMIT_SLACK = 1e-13
"""How far below a limit, relative to it, a load still counts as the limit itself."""


def _levels(states: EdgeStates, machine_stiffness: float, stable: tuple[Branch, ...]) -> tuple[Array, Array]:
    starts = position(states, machine_stiffness, np.array([branch.start for branch in stable]))
    stops = position(states, machine_stiffness, np.array([branch.stop for branch in stable]))
    if stable[-1].stop == states.bed.rim:  # the rim holds the edge under any load
        stops[-1] = math.inf
    return starts, stops


def _held(level: Array, start: float, stop: float) -> Array:
    return (level >= start - LIMIT_SLACK * abs(start)) & (level <= stop)


def stable_counts(states: EdgeStates, machine_stiffness: float, level: Array) -> Array:
    """Return how many stable states there are at each level `(m,)`: d [m] of fixed grips, else F + k_m d [N]."""
    stable = branches_beyond(states, machine_stiffness, float(np.max(level)))
    starts, stops = _levels(states, machine_stiffness, stable)
    held = [_held(level, start, stop) for start, stop in zip(starts, stops, strict=True)]
    return np.asarray(np.sum(held, axis=0))


def widest(
    states: EdgeStates, machine_stiffness: float, level: Array, quantity: str, unit: str, size: str = "radius"
) -> Array:
    """Return the radii of the widest stable contacts at levels `(m,)`; those held by a rim have its radius.

    Parameters
    ----------
    states : EdgeStates
    machine_stiffness : float
        0 of a dead load, inf for fixed grips.
    level : ndarray, (m,)
        F [N] of a dead load, d [m] of fixed grips.
    quantity, unit, size
        Words for messages.

    Raises
    ------
    OutsideValidity
        If no stable contact meets a level: below the pull-off, or beyond the reach of the profile.
    """
    stable = branches_beyond(states, machine_stiffness, float(np.max(level)))
    starts, stops = _levels(states, machine_stiffness, stable)
    least = float(np.min(starts))
    below = level < least - LIMIT_SLACK * abs(least)
    if below.any():
        raise OutsideValidity(
            f"{quantity} {level[below][0]:.6g} {unit}{indices_of(below)} is below the pull-off: no equilibrium "
            f"exists beyond {least:.9g} {unit} ({size} {stable[int(np.argmin(starts))].start:.6g} m); give "
            f"{least:.9g} {unit} or more."
        )
    beyond = level > np.max(stops)
    if beyond.any():
        raise OutsideValidity(
            f"{quantity} {level[beyond][0]:.6g} {unit}{indices_of(beyond)} leads beyond the reach of the profile "
            f"({states.bed.reach:.6g} m), where nothing is known of it; at most {np.max(stops):.6g} {unit} can be "
            "solved."
        )
    result = np.full(level.shape, np.nan)
    for branch, start, stop in reversed(list(zip(stable, starts, stops, strict=True))):
        (own,) = np.nonzero(np.isnan(result) & _held(level, start, stop))
        if own.size:
            result[own] = _on(states, machine_stiffness, branch, level[own])
    lost = np.isnan(result)
    if lost.any():
        raise OutsideValidity(
            f"{quantity} {level[lost][0]:.6g} {unit}{indices_of(lost)} lies between two ranges of stable contacts; "
            "give one of " + ", ".join(f"{a:.6g} to {b:.6g} {unit}" for a, b in zip(starts, stops, strict=True)) + "."
        )
    return result


def _on(states: EdgeStates, machine_stiffness: float, branch: Branch, level: Array) -> Array:
    """Return the radii on one branch, along which the position rises."""
    if branch.stop <= branch.start:
        return np.full(level.shape, branch.start)
    grid = branch.start + (branch.stop - branch.start) * np.linspace(0.0, 1.0, GRID_POINTS) ** 2
    if branch.stop > 16.0 * branch.start > 0.0:
        grid = np.geomspace(branch.start, branch.stop, GRID_POINTS)
    grid[-1] = branch.stop
    heights = np.maximum.accumulate(position(states, machine_stiffness, grid))
    index = np.clip(np.searchsorted(heights, level), 1, GRID_POINTS - 1)
    low, high = grid[index - 1], grid[index]
    inside = (level > heights[index - 1]) & (level < heights[index])
    result = np.where(level >= heights[index], high, low)
    (own,) = np.nonzero(inside)
    if own.size > NEWTON_LEAST_LOADS:
        # of many loads most are solved by Newton's method from a straight line
        rise = (level[own] - heights[index[own] - 1]) / (heights[index[own]] - heights[index[own] - 1])
        result[own], converged = _newton(states, machine_stiffness, level[own], low[own], high[own], rise)
        own = own[~converged]
    if own.size:
        result[own] = between(lambda a, i: position(states, machine_stiffness, a) - level[own[i]], low[own], high[own])
    return result


def _newton(
    states: EdgeStates, machine_stiffness: float, level: Array, low: Array, high: Array, rise: Array
) -> tuple[Array, Array]:
    """Return radii, and where they have converged: the last step was small against the distance from a fold or kink."""
    radius = low + rise * (high - low)
    kinks = np.array([0.0, *(b for b, _ in states.bed.kinks), math.inf])
    place = np.searchsorted(kinks[1:], radius)
    # no step crosses a kink: the slope may be infinite just above it
    low, high = np.maximum(low, kinks[place]), np.minimum(high, kinks[place + 1])
    converged, left = np.zeros(level.shape, dtype=bool), np.arange(level.size)
    for _ in range(NEWTON_STEPS):
        here = radius[left]
        depth, force = states.slopes(here)
        slope = depth if math.isinf(machine_stiffness) else force + machine_stiffness * depth
        missing = level[left] - position(states, machine_stiffness, here)
        step = missing / np.where(slope > 0.0, slope, np.inf)
        new = here + step
        inside = (slope > 0.0) & (new > low[left]) & (new < high[left])
        small = inside & (np.abs(step) <= NEWTON_TOLERANCE * (here - low[left]))
        radius[left[inside]], converged[left[small]] = new[inside], True
        left = left[inside & ~small]
        if not left.size:
            break
    return radius, converged
