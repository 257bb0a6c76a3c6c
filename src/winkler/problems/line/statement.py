"""What is stated of the widest of several line contacts: its assumptions, and whether it stays elastic."""

from __future__ import annotations

import numpy as np

from winkler.foundation.line import LineFoundation
from winkler.numerics.types import Quantity
from winkler.problems.line.peak_pressure import rim_load
from winkler.problems.line.validity import line_notes
from winkler.problems.line.yield_statement import line_yield_notes
from winkler.validity import Note

__all__ = ["line_contact_notes"]


def line_contact_notes(
    bed: LineFoundation, force: Quantity, half_width: Quantity, friction: float = 0.0
) -> tuple[Note, ...]:
    """Return how far line contacts can be trusted.

    Parameters
    ----------
    bed : LineFoundation
    force, half_width : float or ndarray
        P [N/m] and a [m].
    friction : float
        Traction over pressure [-] of a contact that slides everywhere.
    """
    widest = int(np.argmax(force))
    a = float(np.ravel(half_width)[widest])
    on_rim = rim_load(bed, float(np.ravel(force)[widest]), a)
    return (*line_notes(bed, a), *line_yield_notes(bed, a, on_rim, friction))
