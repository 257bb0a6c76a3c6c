"""What notes on sliding rings have in common: where the traction exceeds friction, and how paths are cut."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings
from winkler.numerics.types import Array
from winkler.problems.ring_slip.ring_path import ANGLE_TOLERANCE
from winkler.problems.ring_slip.ring_states import RingState
from winkler.problems.ring_slip.torsion_march import LOSS_TOLERANCE
from winkler.values.validity import Assumption, Note, Standing

TRACTION_ROUNDING = 1e-6
"""Excess of the traction over friction that is none."""
TABLES_ERROR = 3e-4
"""By which part tractions err where kernels have a logarithm."""


def ring_notes(
    bed: Bed,
    coefficient: float,
    states: Sequence[RingState],
    examined: Iterable[int],
    radii: int,
    words: tuple[str, str],
    by_load: bool,
    logarithmic: bool = False,
) -> Iterator[Note]:
    """Yield whether the law of friction holds at each ring, and how fine a path is cut.

    Parameters
    ----------
    bed : Bed
    coefficient : float
        mu [-].
    states : sequence of RingState
        Those of the path.
    examined : iterable of int
        The states of which the traction is restored, in contact.
    radii : int
        At so many radii.
    words : tuple of str
        The motion and the load.
    by_load : bool
        Whether the load is prescribed and the motion computed.
    logarithmic : bool
        Whether kernels have a logarithm.
    """
    motion, load = words
    rounding = TABLES_ERROR if logarithmic else TRACTION_ROUNDING
    bad = np.flatnonzero([not state.nested for state in states])
    excess, index = _excess(bed, coefficient, states, examined, radii, rounding)
    if bad.size or excess > rounding:
        yield Note(
            Assumption.SLIP,
            Standing.APPROXIMATE,
            f"From index {min([*bad[:1].tolist(), index])} on springs have slipped with sticking springs outside "
            "them, because the normal load changes during reversal. The law of friction then holds for the "
            "springs, but not everywhere on the surface. The traction exceeds mu times the pressure by up to "
            f"{excess:.1%} at the points that were checked.",
            "traction restored at points of the path",
        )
    settled = (
        f"the error of the {motion} is at most {ANGLE_TOLERANCE:g} of the friction limit"
        if by_load
        else f"the error of the dissipated energy is at most {LOSS_TOLERANCE:g} of the energies"
    )
    yield Note(
        Assumption.RESOLUTION,
        Standing.EXACT,
        f"{motion.capitalize()}, {load} and slip are computed without a grid; under a changing normal load {settled}.",
        "moves along the path halved until they agree",
    )


def _excess(
    bed: Bed, coefficient: float, states: Sequence[RingState], examined: Iterable[int], radii: int, rounding: float
) -> tuple[float, int]:
    """Return by which part the traction exceeds friction at most, and the first such state."""
    most, first = 0.0, len(states)
    pressure: dict[tuple[float, float], Array] = {}
    for index in examined:
        state = states[index]
        r, press = np.linspace(0.02, 0.98, radii) * state.radius, (state.depth, state.radius)
        if press not in pressure:
            pressure[press] = bed.medium.pressure(PressedSprings(bed, *press), r)
        borne = coefficient * pressure[press]
        excess = float(np.max(np.abs(state.traction(r)) / borne)) - 1.0 if borne.min() > 0.0 else 0.0
        if excess > rounding:
            most, first = max(most, excess), min(first, index)
    return most, first
