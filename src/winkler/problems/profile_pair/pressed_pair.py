"""Two bodies of given profiles in their places, and pressed on each other."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from winkler.loading.loads import Force
from winkler.problems.profile_pair.patch import ProfilePatch, patches_of
from winkler.problems.profile_pair.placing import PlacedBody, Placing, lower_body, upper_body
from winkler.problems.profile_pair.pressing import PressedWindows, pressed_by_drop, pressed_by_force
from winkler.values.errors import InvalidInput


class PlacedPair(NamedTuple):
    """Two bodies pressed on each other.

    Parameters
    ----------
    lower, upper
        Before the upper one is let down.
    placing
        Their distances then.
    windows
        Pressures, and how far the upper body went down.
    down
        The upper body let down.
    patches
        Of each window.
    """

    lower: PlacedBody
    upper: PlacedBody
    placing: Placing
    windows: PressedWindows
    down: PlacedBody
    patches: tuple[tuple[ProfilePatch, ...], ...]


def placed_bodies(problem: Any) -> tuple[PlacedBody, PlacedBody, Placing]:
    """Return both bodies of a `ProfilePair` before the upper one is let down, and their distances.

    Raises
    ------
    InvalidInput
        If the profiles do not meet, first touch at an end, or both bodies are straight along the same direction.
    """
    lower = lower_body(problem.first, problem.first_radius)
    upper = upper_body(problem.second, problem.second_radius, problem.lateral, problem.yaw, problem.roll)
    first, second = problem.first.ends, problem.second.ends
    if first[0] >= problem.lateral + second[1] or first[1] <= problem.lateral + second[0]:
        raise InvalidInput(
            f"ProfilePair: the profiles do not meet: the lower one goes from {first[0]:.6g} m to {first[1]:.6g} m, "
            f"the upper one from {problem.lateral + second[0]:.6g} m to {problem.lateral + second[1]:.6g} m; give "
            "another lateral position."
        )
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        placing = Placing.of(lower, upper)
    there = np.flatnonzero(np.isfinite(placing.gap))
    if there.size == 0:
        raise InvalidInput("ProfilePair: the profiles do not meet; give another lateral position.")
    lowest = int(np.nanargmin(placing.gap))
    if lowest <= there[0] + 1 or lowest >= there[-1] - 1:
        raise InvalidInput(
            f"ProfilePair: the bodies first touch at the end of a profile, at y = {placing.y[lowest]:.6g} m; give "
            "longer profiles, or another lateral position."
        )
    if not placing.bending[lowest] * (first[1] - first[0]) > 1e-9:
        raise InvalidInput(
            "ProfilePair: both bodies are straight along the same direction; give one of them a radius of "
            "revolution, or use LineIndentation for a cylinder."
        )
    return lower, upper, placing


def pressed_pair(problem: Any) -> PlacedPair:
    """Return the bodies of a `ProfilePair` in their places, and the pressures between them.

    Raises
    ------
    InvalidInput, OutsideValidity, NotConverged
        As `ProfilePair.solve`.
    """
    lower, upper, placing = placed_bodies(problem)
    medium, load = problem.medium, problem.load
    if isinstance(load, Force):
        pair = pressed_by_force(lower, upper, placing, float(load.force), medium, problem.pixels, problem.tolerance)
    else:
        pair = pressed_by_drop(lower, upper, placing, float(load.depth), medium, problem.pixels, problem.tolerance)
    down = upper.raised(-float(np.nanmin(placing.gap)) - pair.drop)
    rolled = problem.rolled_radius or problem.second_radius
    patches = tuple(tuple(patches_of(lower, down, region, problem.medium, rolled)) for region in pair.regions)
    return PlacedPair(lower, upper, placing, pair, down, patches)
