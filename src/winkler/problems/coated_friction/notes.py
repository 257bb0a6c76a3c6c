"""How far a pushed contact on layers can be trusted."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.friction import Coulomb
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.coated_friction.state import CoatedTangentialState
from winkler.problems.normal.validity import indentation_notes
from winkler.problems.normal.yield_statement import SurfaceFriction
from winkler.problems.ring_slip.push_notes import push_note, tables_note
from winkler.problems.ring_slip.ring_notes import ring_notes
from winkler.validity import Note

__all__ = ["coated_notes"]

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
    bound = states[0].springs.bound
    yield from tables_note(bound)
    pressed = [index for index, state in enumerate(states) if state.radius > 0.0 and state.shear_force != 0.0]
    examined = pressed[:: max(1, -(-len(pressed) // PATH_SAMPLES))]
    words = ("shift", "shear force")
    yield from ring_notes(bed, law.coefficient, states, examined, RADIUS_SAMPLES, words, by_force, bound.logarithmic)
