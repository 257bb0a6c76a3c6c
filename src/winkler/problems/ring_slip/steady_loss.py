"""What the rings of a coating lose in every closed cycle of depth and shift."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.ring_slip.ring_table import PressedStep, RingTable, pressed_step, slide
from winkler.values.errors import OutsideValidity

STEPS_PER_CYCLE = 400
"""Steps of every oscillation of the quicker motion."""
MOST_CYCLES = 50
"""Of either motion in one closed cycle."""

CycleSteps = list[PressedStep]


def cycle_steps(owner: str, table: RingTable, normal: int, lateral: int, sunk: Array) -> CycleSteps:
    """Return the steps of one closed cycle; depths [m] at its points, the first one again at the end.

    Raises
    ------
    OutsideValidity
        If the cycle holds more oscillations than are followed.
    """
    if max(normal, lateral) > MOST_CYCLES:
        raise OutsideValidity(
            f"{owner}: a closed cycle holds {normal} normal and {lateral} lateral ones; on a coating, where rings are "
            f"followed in steps, at most {MOST_CYCLES} of each: give a simpler ratio of frequencies."
        )
    return [pressed_step(table, start, end) for start, end in pairwise(sunk.tolist())]


def loss_of_cycle(table: RingTable, steps: CycleSteps, moved: Array) -> float:
    """Return the loss of the second closed cycle [J], which is that of all later ones.

    Parameters
    ----------
    table : RingTable
    steps : list of PressedStep
    moved : ndarray, (steps + 1,)
        The shift at the same points [m].
    """
    load, lost = np.zeros(table.gaps.size), 0.0
    shifts = np.diff(moved).tolist()
    for _ in range(2):
        lost = 0.0
        for step, shift in zip(steps, shifts, strict=True):
            rings = slide(table, load, step, shift)
            load, lost = rings.load, lost + rings.loss
    return lost
