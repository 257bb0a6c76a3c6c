"""Arguments of problems of wear: springs with known tractions, a law, one steady load, a grid and a tolerance."""

from __future__ import annotations

from typing import Annotated, TypeAlias

from winkler.checks.number_checks import Whole, between
from winkler.errors import OutsideValidity
from winkler.foundation.foundation import Foundation
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.halfspace import HomogeneousMedium

__all__ = ["Cells", "WearTolerance", "wearable"]


def wearable(owner: str, bed: Foundation) -> None:
    """Refuse a bed whose pressure and slip do not follow from its springs in closed form."""
    if not isinstance(bed.medium, HomogeneousMedium | GradedHalfSpace):
        raise OutsideValidity(
            f"{owner}: in a {type(bed.medium).__name__} pressure and slip do not follow from the springs alone, and "
            "layers wear away themselves; give HalfSpace(first, second) or GradedHalfSpace(first, second), or use "
            "LimitingProfile, which takes elastic layers and gradings, too."
        )


Cells: TypeAlias = Annotated[int, Whole(20, 5000, "cells")]
WearTolerance: TypeAlias = Annotated[float, between(1e-9, 1e-2)]
