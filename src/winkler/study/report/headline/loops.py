"""The loops of a path: what each cycle loses, its secant stiffness and its loss factor."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.problems.last_cycle import Cycled, loss_factor
from winkler.study.batch.outcome import Outcome
from winkler.study.report.describe import settings_text
from winkler.study.report.headline.shown_contact import shown_point
from winkler.values.readable import with_unit
from winkler.values.vocabulary import word

MOST_LOOPS = 24
LOSSES = ("loss_per_cycle", "loss_per_cycle_per_length")
LOOP_HEADS = ("points of the path", "loss per cycle", "secant stiffness", "loss factor")


class LoopRow(NamedTuple):
    """One loop as text.

    Parameters
    ----------
    points
        The points of the path between which it runs.
    loss
        What it loses.
    stiffness
        Amplitude of the load over that of the motion; empty where nothing moves, or the path leaves a line.
    factor
        Loss over pi times both amplitudes, twice the damping ratio; empty as before.
    """

    points: str
    loss: str
    stiffness: str
    factor: str


def loop_rows(outcome: Outcome) -> tuple[LoopRow, ...]:
    """Return the last loops of the path of the shown point, in their order; none if it has fewer than two.

    Parameters
    ----------
    outcome
        Outcome of a study.
    """
    solution = shown_point(outcome).solution if outcome.solved else None
    loss = next((name for name in LOSSES if hasattr(type(solution), name)), "")
    if not isinstance(solution, Cycled) or not loss:
        return ()
    unit, units = word(type(solution), loss).unit or "", _stiffness_unit(type(solution))
    cycles = solution.cycles(MOST_LOOPS)
    rows = []
    for one in cycles:
        moves = bool(one.motion * one.load > 0.0)  # not a number where the path leaves a line
        stiffness = with_unit(one.load / one.motion, units) if moves and units else ""
        factor = f"{float(np.asarray(loss_factor(one.loss, one.motion, one.load))):.4g}" if moves else ""
        rows.append(LoopRow(f"{one.first} to {one.last}", with_unit(one.loss, unit), stiffness, factor))
    return tuple(rows) if len(rows) > 1 else ()


def loops_title(outcome: Outcome) -> str:
    """Return the title of the table of loops, of a sweep with the point that they are of.

    Parameters
    ----------
    outcome
        Outcome of a study.
    """
    of = settings_text(outcome.study, shown_point(outcome).settings) if outcome.study.sweep else ""
    return f"Loops of the path{f' at {of}' if of else ''}"


def _stiffness_unit(cls: type) -> str:
    return (word(cls, "secant_stiffness").unit or "") if hasattr(cls, "secant_stiffness") else ""
