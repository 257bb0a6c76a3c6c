"""What every rough line refuses, and what it says of waves that it does not see."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.given import affordable, whole_number
from winkler.limits import MOST_NUMBERS, SPRINGS
from winkler.loading import Depth, Force
from winkler.problems.normal.yield_of_pressure import spots_yield_notes
from winkler.problems.rough.spring_line import prescribed
from winkler.validity import Assumption, Note, Standing

__all__ = ["check_ensemble", "check_spectrum", "line_notes"]

ROUNDING = 1e-9


def check_spectrum(owner: str, spectrum: object) -> None:
    """Refuse what does not tell its power at a wave number."""
    if not callable(getattr(spectrum, "at", None)):
        raise InvalidInput(f"{owner}: spectrum is a {type(spectrum).__name__}; give SelfAffine or PowerSpectrum.")


def check_ensemble(owner: str, load: Force | Depth, realisations: int, count: int, seed: int) -> None:
    """Refuse loads that are none or pull, and numbers of lines and springs that are none."""
    for word, number, least in (("realisations", realisations, 1), ("count", count, 16), ("seed", seed, 0)):
        whole_number(owner, word, number, least, math.inf if word == "seed" else SPRINGS)
    affordable(owner, "springs of all realisations", realisations * count, MOST_NUMBERS)
    if not isinstance(load, Force | Depth):
        raise InvalidInput(f"{owner}: the load is a {type(load).__name__}; give Force or Depth.")
    least_load = float(np.min(prescribed(load)))
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
    if spectrum.smallest * length < 2.0 * math.pi * (1.0 - ROUNDING):
        left_out.append(f"longer than the line ({length:.4g} m)")
    if spectrum.greatest * length > math.pi * count * (1.0 + ROUNDING):
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
