"""What a comparison of models allows to say: the best model is told from another only by clear evidence.

Akaike's and Schwarz' criteria, both by the likelihood under white and slow noise, have to favour it by at least ten,
about 150 to one.  A model that does not explain the curve is not confirmed because others are worse; and a curve with
the information of few independent points tells no models apart.
"""

from __future__ import annotations

import numpy as np

from winkler.errors import InvalidInput
from winkler.fitting.compare import Comparison
from winkler.values import value, words

__all__ = ["LEAST_EVIDENCE", "ModelVerdict", "verdict_of"]

LEAST_EVIDENCE = 10.0
"""Difference of a criterion from which on a model is excluded."""


@value
class ModelVerdict:
    """Which models a curve allows.

    Parameters
    ----------
    possible : tuple of str
        Models that the curve does not tell apart, the best first.
    excluded : tuple of str
        Models that it excludes.
    explained : bool
        Whether the best model explains the curve.
    enough : bool
        Whether the curve has enough independent points to tell models apart.
    """

    __words__ = words(
        possible=("", None, "models that the curve does not tell apart, the best first"),
        excluded=("", None, "models that the curve excludes"),
        explained=("", None, "whether the best model explains the curve"),
        enough=("", None, "whether the curve has enough independent points"),
    )

    possible: tuple[str, ...]
    excluded: tuple[str, ...]
    explained: bool
    enough: bool

    @property
    def told(self) -> bool:
        """Whether the curve determines its model, among those that were compared."""
        return len(self.possible) == 1 and bool(self.excluded) and self.explained

    @property
    def statement(self) -> str:
        """The verdict as a sentence."""
        several = _listed(self.possible)
        if not self.explained:
            nearest = f"{self.possible[0]} comes nearest" if len(self.possible) == 1 else f"{several} come nearest"
            return f"None of the models explains this curve; {nearest}."
        if not self.enough:
            return f"This curve cannot tell: it has too few independent points to choose among {several}."
        if len(self.possible) > 1:
            beside = f"; it excludes {_listed(self.excluded)}" if self.excluded else ""
            return f"This curve cannot tell: {several}{beside}."
        if not self.excluded:
            return f"{self.possible[0]} is the only model that could be fitted."
        return f"This curve tells {self.possible[0]} from {_listed(self.excluded)}."


def verdict_of(comparison: Comparison) -> ModelVerdict:
    """Return which models a curve allows.

    Parameters
    ----------
    comparison : Comparison
        From `compare`.

    Raises
    ------
    InvalidInput
        If it holds no model.
    """
    if not comparison.models:
        raise InvalidInput("verdict_of: the comparison holds no model; compare at least two.")
    flags = {flag.name for flag in comparison.best.flags}
    enough = "memory" not in flags
    worse = np.minimum(comparison.aic - comparison.aic[0], comparison.bic - comparison.bic[0])
    out = (worse >= LEAST_EVIDENCE) & enough
    named = list(zip(comparison.models, out.tolist(), strict=True))
    return ModelVerdict(
        possible=tuple(name for name, excluded in named if not excluded),
        excluded=tuple(name for name, excluded in named if excluded),
        explained="misfit" not in flags,
        enough=enough or len(named) == 1,
    )


def _listed(names: tuple[str, ...]) -> str:
    if len(names) < 2:
        return "".join(names)
    return f"{', '.join(names[:-1])} and {names[-1]}"
