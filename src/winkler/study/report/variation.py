"""Which answers of a study vary, and are worth a curve."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from winkler.numerics.types import Array

ROUNDING = 5e-5
"""Variation over the greatest number that its four digits do not show: rounding, or what a solver leaves."""
LEFT_BY_SOLVERS = 1e-6
"""Variation over the greatest component along another direction below which it is what a solver leaves of zero."""
DIRECTIONS = (("x", "y", "z"), ("longitudinal", "lateral"))


def variation_shows(name: str, answers: Mapping[str, Array]) -> bool:
    """Return whether an answer varies by more than rounding, and than what a solver leaves of a component that is zero.

    Parameters
    ----------
    name
        Which answer.
    answers
        All of them: a shear force along y is compared with that along x.
    """
    finite = _finite(answers[name])
    if finite.size < 2:
        return False
    beside = max((_greatest(answers[other]) for other in _components(name) if other in answers), default=0.0)
    return float(np.ptp(finite)) > max(ROUNDING * float(np.max(np.abs(finite))), LEFT_BY_SOLVERS * beside)


def _components(name: str) -> Iterable[str]:
    """Yield the names of the same quantity along other directions."""
    parts = name.split("_")
    for directions in DIRECTIONS:
        for place in {0, len(parts) - 1}:
            if parts[place] in directions and len(parts) > 1:
                for other in directions:
                    if other != parts[place]:
                        yield "_".join([*parts[:place], other, *parts[place + 1 :]])


def _finite(content: Array) -> Array:
    return np.asarray(content[np.isfinite(content)])


def _greatest(content: Array) -> float:
    return float(np.max(np.abs(_finite(content)), initial=0.0))
