"""How far worn line contacts can be trusted."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import cast

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.line_bed import LineBed
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.loading.loads import LineForce
from winkler.media.medium import Medium
from winkler.problems.assumptions.coupling import sliding_note, sticking_note
from winkler.problems.line.indentation import LineIndentation
from winkler.problems.line_friction.validity import SLIP_SUMS
from winkler.problems.wear.line_states import LineWearState
from winkler.problems.wear.stuck_core import StuckCore
from winkler.problems.wear.validity import (
    DEBRIS,
    SAME_CORE,
    SLIDES_EVERYWHERE,
    core_note,
    edge_notes,
    moved_core_note,
    resolution_note,
    worn_yield,
)
from winkler.problems.wear.worn_layers import layer_notes, strip_cells_note
from winkler.values.validity import Assumption, Note, Standing

Bed = LineFoundation | LayeredLineFoundation | PowerLawLineFoundation

WORN_SLIP = Note(
    Assumption.SLIP,
    Standing.EXACT,
    "For similar bodies slip is the coefficient of friction times a gap: that beside the contact under the load "
    "P - Q/mu. This holds for a worn profile too.",
    SLIP_SUMS.source,
)
LAYERS_SLIP = Note(
    Assumption.SLIP,
    Standing.EXACT,
    "Pressures, tractions and slip follow from flat punches on the layers under pressure and under shear along "
    "x, for a worn profile too.",
    "the same strips as loads and flat punches, compared with integral equations of one strip",
)


def _slip_note(bed: LineBed) -> Note:
    return WORN_SLIP if bed.sheared_as_pressed else LAYERS_SLIP


def _before_wear(bed: Bed, force: float, worn: tuple[Note, ...]) -> Iterator[Note]:
    """Yield the notes before wear; of yield that it begins before wear and without friction, or what is known then."""
    outside = []
    for note in LineIndentation(bed, LineForce(force)).solve().validity:
        if note.assumption is not Assumption.ELASTIC:
            yield note
        elif note.standing is Standing.OUTSIDE:
            outside.append(note)
    yield from outside or worn


def _march_notes(
    bed: Bed, tolerance: float, states: Sequence[LineWearState], scale: str, *, layer_wears: bool
) -> tuple[Note, ...]:
    return (
        *_before_wear(bed, states[0].force_per_length, worn_yield(bed.medium, states)),
        DEBRIS,
        resolution_note(states[-1], tolerance, scale),
        *layer_notes(bed.medium, states, strip_cells_note(states[0]), layer_wears=layer_wears),
    )


def line_fretting_notes(
    bed: Bed, coefficient: float, tolerance: float, states: Sequence[LineWearState], *, layer_wears: bool
) -> tuple[Note, ...]:
    """Return how far a fretting line contact can be trusted.

    Parameters
    ----------
    bed : LineFoundation, LayeredLineFoundation or PowerLawLineFoundation
        Before wear.
    coefficient : float
        Of friction [-].
    tolerance : float
        Of each jump.
    states : sequence of LineWearState
    layer_wears : bool
        Whether the uppermost layer of a layered body wears.
    """
    scale = "greatest worn depth in the end"
    return (
        *_march_notes(bed, tolerance, states, scale, layer_wears=layer_wears),
        sticking_note(cast(Medium, bed.medium), coefficient),
        _slip_note(bed),
    )


def line_sliding_notes(
    bed: Bed, tolerance: float, states: Sequence[LineWearState], *, layer_wears: bool
) -> tuple[Note, ...]:
    """Return how far a sliding line contact can be trusted; parameters as `line_fretting_notes`."""
    scale = "load per length over E*, or, once the pressure has settled, of that and the greatest worn depth together"
    # the law of wear does not define the friction
    return (
        *_march_notes(bed, tolerance, states, scale, layer_wears=layer_wears),
        *edge_notes(states[-1]),
        sliding_note(cast(Medium, bed.medium), np.nan),
        SLIDES_EVERYWHERE,
    )


def line_limiting_notes(core: StuckCore, coefficient: float, force: float) -> tuple[Note, ...]:
    """Return how far the limiting profile of a line contact can be trusted.

    Parameters
    ----------
    core : StuckCore
        What sticks.
    coefficient : float
        Of friction [-].
    force : float
        P [N/m].
    """
    bed = cast(Bed, core.bed)
    moved = () if bed.sheared_as_pressed else (moved_core_note(core.first, core.alone, "LineFrettingWear"),)
    stays = core.alone <= core.first * (1.0 + SAME_CORE)
    return (
        *_before_wear(bed, force, worn_yield(bed.medium, ())),
        DEBRIS,
        sticking_note(cast(Medium, bed.medium), coefficient),
        _slip_note(bed),
        *([core_note("M. Ciavarella, D. A. Hills, Eur. J. Mech. A Solids 18 (1999) 491-497")] if stays else []),
        *moved,
    )
