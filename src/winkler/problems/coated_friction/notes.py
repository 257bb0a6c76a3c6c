"""How far a pushed contact on a coating can be trusted."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings
from winkler.laws.friction import Coulomb
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.coated_friction.state import CoatedTangentialState
from winkler.problems.normal.validity import indentation_notes
from winkler.problems.normal.yield_statement import SurfaceFriction
from winkler.problems.ring_slip.push_notes import push_note
from winkler.problems.ring_slip.torsion_march import ANGLE_TOLERANCE, LOSS_TOLERANCE
from winkler.validity import Assumption, Note, Standing

__all__ = ["coated_notes"]

TRACTION_ROUNDING = 1e-6
"""Excess of the traction over friction that is none."""
PATH_SAMPLES, RADIUS_SAMPLES = 6, 25
"""At so many states of a path the traction is examined, at so many radii."""


def coated_notes(bed: Bed, law: Coulomb, states: Sequence[CoatedTangentialState], by_force: bool) -> Iterator[Note]:
    """Yield how far a path of states can be trusted.

    Parameters
    ----------
    bed : Bed
    law : Coulomb
    states : sequence of CoatedTangentialState
    by_force : bool
        Whether the shear force is prescribed and the shift computed.
    """
    depth, radius = (np.array([getattr(state, word) for state in states]) for word in ("depth", "radius"))
    yield from indentation_notes(bed, depth, radius, SurfaceFriction(law.coefficient))
    yield sticking_note(bed.medium, law.coefficient)
    yield push_note(bed, float(np.max(radius)))
    bad = np.flatnonzero([not state.nested for state in states])
    excess, index = _excess(bed, law, states)
    if bad.size or excess > TRACTION_ROUNDING:
        yield Note(
            Assumption.SLIP,
            Standing.APPROXIMATE,
            f"From index {min([*bad[:1].tolist(), index])} on what slides is not one outer ring: the law holds for the "
            f"springs, but the traction exceeds coefficient times pressure by up to {excess:.1%}, where examined.",
            "traction restored at points of the path",
        )
    computed = f"the shift to {ANGLE_TOLERANCE:g}" if by_force else f"the loss to {LOSS_TOLERANCE:g} of the energies"
    yield Note(
        Assumption.RESOLUTION,
        Standing.EXACT,
        f"Shift, shear force and slip are known without a grid; under a changing normal load {computed}.",
        "moves along the path halved until they agree",
    )


def _excess(bed: Bed, law: Coulomb, states: Sequence[CoatedTangentialState]) -> tuple[float, int]:
    """Return by which part the traction exceeds friction at most, at sampled states, and the first such state."""
    pressed = [index for index, state in enumerate(states) if state.radius > 0.0 and state.shear_force != 0.0]
    most, first = 0.0, len(states)
    pressure: dict[tuple[float, float], Array] = {}
    for index in pressed[:: max(1, -(-len(pressed) // PATH_SAMPLES))]:
        state = states[index]
        r, press = np.linspace(0.02, 0.98, RADIUS_SAMPLES) * state.radius, (state.depth, state.radius)
        if press not in pressure:
            pressure[press] = bed.medium.pressure(PressedSprings(bed, *press), r)
        borne = law.coefficient * pressure[press]
        excess = float(np.max(np.abs(state.traction(r)) / borne)) - 1.0 if borne.min() > 0.0 else 0.0
        if excess > TRACTION_ROUNDING:
            most, first = max(most, excess), min(first, index)
    return most, first
