"""The springs of a pressed contact, sampled for a march: what each can bear, and the length it stands for."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.rolling.line import RollingLine
from winkler.values.errors import OutsideValidity


class RollingSprings(NamedTuple):
    """Springs of a contact, so far apart as the contact moves in one step.

    Parameters
    ----------
    x : ndarray, (n,)
        Where they stand [m], even about the axis.
    bound, weight : ndarray, (n,)
        mu q_z [N/m], the mean over the length each stands for [m].
    part : float
        How much of a step a spring takes part in that comes in within it [-].
    """

    x: Array
    bound: Array
    weight: Array
    part: float


MOST_SPRINGS = 1_000_000
"""Springs on half of a contact; more would fill the memory."""
MOST_SPRING_STEPS = 1e10
"""Steps of all springs together; more would take minutes."""


def springs(owner: str, line: RollingLine, travel: float, pieces: int, count: int) -> tuple[RollingSprings, int]:
    """Return springs for a contact that travels a distance in so many pieces, and the steps of one piece.

    Parameters
    ----------
    owner : str
        Name of the problem, for the error sentences.
    line : RollingLine
    travel : float
        [m], positive.
    pieces : int
        After each of which a state is returned.
    count : int
        Minimum number of springs on half of the contact.

    Raises
    ------
    OutsideValidity
        If the distance is too short or too long for that.
    """
    a = line.radius
    steps = max(1.0, travel / pieces * count / a)
    if not a / (travel / pieces / steps) <= MOST_SPRINGS:
        raise OutsideValidity(
            f"{owner}: each of {pieces} parts of its travel, {travel:.6g} m, is so short beside the contact radius of "
            f"{a:.6g} m that more than {MOST_SPRINGS} springs are needed; give a longer travel, or fewer states."
        )
    if not pieces * steps * count <= MOST_SPRING_STEPS:
        raise OutsideValidity(
            f"{owner}: a travel of {travel:.6g} m is so long beside the contact radius of {a:.6g} m that {count} "
            "springs cannot be followed along it; give a shorter travel."
        )
    steps = math.ceil(steps)
    apart = travel / pieces / steps
    half = math.floor(a / apart * (1.0 + 1e-12))
    x = apart * np.arange(-half, half + 1)
    left = max(a - apart * half, 0.0)
    weight = np.full(x.size, apart)
    weight[0] = weight[-1] = 0.5 * apart + left
    # the mean bound over the spacing of a spring: at the edge, where it falls to zero, one place would not give it
    cuts = np.concatenate([[-a], x[:-1] + 0.5 * apart, [a]])
    bound = np.maximum(line.bearing(cuts[:-1], cuts[1:]), 0.0) / weight
    return RollingSprings(x, bound, weight, left / apart), steps
