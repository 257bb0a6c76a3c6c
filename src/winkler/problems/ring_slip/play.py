"""Springs that slide under a steady normal load, whose memory are the turning points of the motion.

Each spring bears up to its own bound, and slides at it: a play.  Where all have come into contact at rest, what they
bear along a branch from a turning point is twice what fresh springs bear after half of the way (Masing), and a
branch ends where it closes the loop from which it came.  It does not matter how the bounds came about.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np


class Stretch(NamedTuple):
    """A part of a branch on the way to one point of a history.

    `point` is that point, `turn` the point at which the branch began (-1 of fresh springs), `fold` 1 of fresh springs
    and 2 of others, `sign` the direction; the way from the turn is `fold` times the amplitude, which rises from `start`
    to `end`.
    """

    point: int
    turn: int
    fold: int
    sign: float
    start: float
    end: float


class Branches(NamedTuple):
    """A history: its stretches, and of each point its direction and the last turn that is remembered, -1 if none.

    `inner` holds for each point that is a turn the one that is remembered before it, -1 if none, and -1 of all others.
    """

    stretches: list[Stretch]
    directions: list[float]
    heads: list[int]
    inner: list[int]

    def turns(self, point: int) -> list[int]:
        """Return the turns that are remembered at a point, the oldest first."""
        found, turn = [], self.heads[point]
        while turn >= 0:
            found.append(turn)
            turn = self.inner[turn]
        return found[::-1]


def followed(values: Sequence[float]) -> Branches:
    """Return the branches of a history that begins at zero, of fresh springs.

    Parameters
    ----------
    values : sequence of float
        The motion, or the load, point by point.
    """
    stretches: list[Stretch] = []
    directions: list[float] = []
    heads: list[int] = []
    inner = [-1] * len(values)
    turns: list[int] = []
    value = direction = 0.0
    for point, target in enumerate(values):
        sign = 1.0 if target > value else -1.0
        if target != value and direction == -sign:
            inner[point - 1] = turns[-1] if turns else -1
            turns.append(point - 1)
        on_its_way = value != target
        while on_its_way:
            direction = sign
            closes = sign * np.inf
            if turns:
                closes = values[turns[-2]] if len(turns) > 1 else -values[turns[-1]]
            turn, fold = (turns[-1], 2) if turns else (-1, 1)
            base = values[turn] if turns else 0.0
            stop = target if sign * (closes - target) > 0.0 else closes
            stretches.append(Stretch(point, turn, fold, sign, abs(value - base) / fold, abs(stop - base) / fold))
            on_its_way = stop == closes  # then on the branch that the loop interrupted, if only for its last point
            if on_its_way:
                del turns[-2:]
            value = stop
        heads.append(turns[-1] if turns else -1)
        directions.append(direction)
    return Branches(stretches, directions, heads, inner)
