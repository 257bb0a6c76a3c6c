"""Problems that are measurements to be evaluated, which `winkler fit` takes as `winkler run` does."""

from __future__ import annotations

from pathlib import Path

from winkler.study.language.reading import parsed, read_text
from winkler.values.errors import WinklerError

MEASURED_PROBLEMS = ("friction_loops", "held_contacts", "master_curve", "measured_constriction")
"""Kinds whose numbers are fitted by the problem itself."""


def is_measured_problem(path: Path) -> bool:
    """Return whether a study file has such a problem and no ``[fit]``; False if it cannot be read."""
    try:
        raw = parsed(read_text(path), path.name)
    except WinklerError:
        return False
    problem = raw.get("problem")
    return "fit" not in raw and isinstance(problem, dict) and problem.get("kind") in MEASURED_PROBLEMS
