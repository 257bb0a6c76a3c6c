"""How far worn line contacts can be trusted."""

from __future__ import annotations

from collections.abc import Sequence
from typing import cast

import numpy as np

from winkler.foundation.line import LineFoundation
from winkler.media.medium import Medium
from winkler.problems.assumptions.coupling import sliding_note, sticking_note
from winkler.problems.line.half_width import under_force
from winkler.problems.line.peak_pressure import rim_load
from winkler.problems.line.validity import line_notes
from winkler.problems.line.yield_statement import line_yield_notes
from winkler.problems.line_friction.validity import SLIP_SUMS
from winkler.problems.wear.line_states import LineWearState
from winkler.problems.wear.validity import (
    DEBRIS,
    SLIDES_EVERYWHERE,
    core_note,
    edge_notes,
    resolution_note,
    worn_yield,
)
from winkler.validity import Assumption, Note, Standing

__all__ = ["line_fretting_notes", "line_limiting_notes", "line_sliding_notes"]


WORN_SLIP = Note(
    Assumption.SLIP,
    Standing.EXACT,
    "Similar half-planes slip by the coefficient of friction times the distance that the contact under the load "
    "P - Q/mu leaves open beside it, for a worn profile too.",
    SLIP_SUMS.source,
)


def _yield_notes(bed: LineFoundation, force: float, half_width: float, worn: tuple[Note, ...]) -> tuple[Note, ...]:
    """Return that the contact yields before wear and without friction, or else what is known of it when worn."""
    before = line_yield_notes(bed, half_width, rim_load(bed, force, half_width))
    return tuple(note for note in before if note.standing is Standing.OUTSIDE) or worn


def _march_notes(
    bed: LineFoundation, tolerance: float, states: Sequence[LineWearState], scale: str
) -> tuple[Note, ...]:
    before = under_force(bed, np.array([states[0].force_per_length / bed.medium.modulus])).tolist()[0]
    return (
        *line_notes(bed, before),
        *_yield_notes(bed, states[0].force_per_length, before, worn_yield(bed.medium, states)),
        DEBRIS,
        resolution_note(states[-1], tolerance, scale),
    )


def line_fretting_notes(
    bed: LineFoundation, coefficient: float, tolerance: float, states: Sequence[LineWearState]
) -> tuple[Note, ...]:
    """Return how far a fretting line contact can be trusted.

    Parameters
    ----------
    bed : LineFoundation
        Before wear.
    coefficient : float
        Of friction [-].
    tolerance : float
        Of each jump.
    states : sequence of LineWearState
    """
    scale = "greatest worn depth in the end"
    return (
        *_march_notes(bed, tolerance, states, scale),
        sticking_note(cast(Medium, bed.medium), coefficient),
        WORN_SLIP,
    )


def line_sliding_notes(bed: LineFoundation, tolerance: float, states: Sequence[LineWearState]) -> tuple[Note, ...]:
    """Return how far a sliding line contact can be trusted; parameters as `line_fretting_notes`."""
    scale = "load per length over E*, or, once the pressure has settled, of that and the greatest worn depth together"
    # the law of wear does not define the friction
    return (
        *_march_notes(bed, tolerance, states, scale),
        *edge_notes(states[-1]),
        sliding_note(cast(Medium, bed.medium), np.nan),
        SLIDES_EVERYWHERE,
    )


def line_limiting_notes(bed: LineFoundation, coefficient: float, force: float) -> tuple[Note, ...]:
    """Return how far the limiting profile of a line contact can be trusted.

    Parameters
    ----------
    bed : LineFoundation
        Before wear.
    coefficient : float
        Of friction [-].
    force : float
        P [N/m].
    """
    before = float(under_force(bed, np.array([force / bed.medium.modulus]))[0])
    return (
        *line_notes(bed, before),
        *_yield_notes(bed, force, before, worn_yield(bed.medium, ())),
        DEBRIS,
        sticking_note(cast(Medium, bed.medium), coefficient),
        WORN_SLIP,
        core_note("M. Ciavarella, D. A. Hills, Eur. J. Mech. A Solids 18 (1999) 491-497"),
    )
