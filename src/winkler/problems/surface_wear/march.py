"""How the wear of a height map is followed: in steps that are taken once whole and once in halves.

What both differ by, over three, is the error of the halves, which are kept; it decides how far the next step goes.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.surfaces.pressed_grid import PressedSurface
from winkler.numerics.types import Array
from winkler.problems.surface_wear.worn_map import WornMap
from winkler.values.errors import NotConverged

__all__ = ["MapMoment", "begin", "go"]

FIRST_SHARE = 1e-2
"""Part of the depth that the first step takes off where the pressure is greatest."""
ERROR_OF_HALVES = 1.0 / 3.0
"""Error of two halves over what they differ by from the whole, at second order."""
SAFETY, LEAST_FACTOR, MOST_FACTOR = 0.8, 0.2, 5.0
SHORTEST_STEP = 1e-13
"""Part of the way at which steps are given up."""


class MapMoment(NamedTuple):
    """How far wear has come.

    Parameters
    ----------
    elapsed
        Distance slid [m].
    jump
        How far the next step would go [m].
    load_distance
        Sum of p / E* over the pixels, integrated over the distance [m].
    worn
        What has been lost [m], (nx, ny).
    contact
        The contact.
    """

    elapsed: float
    jump: float
    load_distance: float
    worn: Array
    contact: PressedSurface


def begin(surface: WornMap) -> MapMoment:
    """Return the moment before wear.

    Raises
    ------
    NotConverged
        If the contact is not solved.
    """
    worn = np.zeros(surface.gaps.shape)
    contact = surface.pressed(worn, 0.0, ())
    jump = FIRST_SHARE * contact.depth / (surface.softness * float(np.max(contact.pressure)))
    return MapMoment(0.0, jump, 0.0, worn, contact)


def go(surface: WornMap, goal: float, moment: MapMoment, tolerance: float) -> MapMoment:
    """Return how far wear has come at a goal.

    Parameters
    ----------
    surface
        The map.
    goal
        Distance [m], beyond that of the moment.
    moment
        Where it begins.
    tolerance
        Greatest error of the worn depth in a step, over the greatest worn depth.

    Raises
    ------
    NotConverged
        If steps become too short to go on.
    """
    while moment.elapsed < goal:
        moment = _stepped(surface, moment, goal, tolerance)
    return moment


def _stepped(surface: WornMap, moment: MapMoment, goal: float, tolerance: float) -> MapMoment:
    """Return the moment after one step, the longest of those tried whose error is small enough."""
    left, jump = goal - moment.elapsed, moment.jump
    while True:
        last = jump >= left
        length = left if last else jump
        if length < SHORTEST_STEP * goal and not last:
            raise NotConverged(
                f"after {moment.elapsed:.6g} m the steps become too short to go on; allow a larger tolerance of the "
                "wear, or a smaller one of the contact."
            )
        try:
            whole = surface.step(moment.worn, moment.contact, length)
            half = surface.step(moment.worn, moment.contact, 0.5 * length)
            end = surface.step(half.worn, half.contact, 0.5 * length)
        except NotConverged:
            jump = LEAST_FACTOR * length
            if jump < SHORTEST_STEP * goal:
                raise
            continue
        differing = float(np.max(np.abs(end.worn - whole.worn)))
        error = ERROR_OF_HALVES * differing / (tolerance * float(np.max(end.worn)))
        factor = SAFETY * error ** (-1.0 / 3.0) if error > 0.0 else math.inf
        factor = min(max(factor, LEAST_FACTOR), MOST_FACTOR)
        if error <= 1.0:
            following = max(factor * length, jump if last else 0.0)  # a goal that was near does not limit what follows
            elapsed = goal if last else moment.elapsed + length
            carried = moment.load_distance + half.load_distance + end.load_distance
            return MapMoment(elapsed, following, carried, end.worn, end.contact)
        jump = min(factor, 1.0) * length
