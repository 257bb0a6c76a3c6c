"""What every rough line refuses, and its notes on waves that it leaves out."""

from __future__ import annotations

import math
from typing import Annotated, Any, TypeAlias

import numpy as np

from winkler.checks.number_checks import Whole, affordable
from winkler.errors import InvalidInput
from winkler.limits import MOST_NUMBERS, MOST_SPRINGS
from winkler.loading import Depth, Force
from winkler.path import numbers_of
from winkler.problems.normal.yield_of_pressure import spots_yield_notes
from winkler.validity import Assumption, Note, Standing

__all__ = ["LineSprings", "Realisations", "check_ensemble", "line_notes"]

CUT_OFF_ROUNDING = 1e-9


Realisations: TypeAlias = Annotated[int, Whole(1, MOST_SPRINGS)]
LineSprings: TypeAlias = Annotated[int, Whole(16, MOST_SPRINGS)]


def check_ensemble(owner: str, load: Force | Depth, realisations: int, count: int) -> None:
    """Refuse loads that are none or pull, and more springs than are computed with."""
    affordable(owner, "springs of all realisations", realisations * count, MOST_NUMBERS)
    least_load = float(np.min(numbers_of(load)))
    if least_load <= 0.0:
        raise InvalidInput(
            f"{owner}: the load {least_load:.6g} is not positive; without adhesion surfaces are pressed together."
        )


def line_notes(solution: Any) -> tuple[Note, ...]:
    """Return whether spots in contact yield, and if waves are longer than the line, or shorter than two springs."""
    problem = solution.problem
    spectrum, length, count = problem.spectrum, problem.length, problem.count
    yielding = spots_yield_notes(problem.medium, float(np.max(np.asarray(solution.force) / np.asarray(solution.area))))
    left_out = []
    if spectrum.smallest * length < 2.0 * math.pi * (1.0 - CUT_OFF_ROUNDING):
        left_out.append(f"longer than the line ({length:.4g} m)")
    if spectrum.greatest * length > math.pi * count * (1.0 + CUT_OFF_ROUNDING):
        left_out.append(f"shorter than two springs ({2.0 * length / count:.4g} m; give a larger count)")
    if not left_out:
        return yielding
    return (
        *yielding,
        Note(
            Assumption.RESOLUTION,
            Standing.APPROXIMATE,
            f"Waves of the spectrum {' and '.join(left_out)} are left out of the line.",
            "the points of a discrete Fourier transform",
        ),
    )
