"""Arguments of problems of wear: springs with known tractions, a law, one steady load, a grid and a tolerance."""

from __future__ import annotations

from typing import Annotated, TypeAlias

from winkler.foundation.foundation import Foundation
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.offers import PowerOfDepth, PressedWaves, PushedWaves, offers
from winkler.values.checks.number_checks import Whole, between
from winkler.values.errors import OutsideValidity


def refuse_unless_rubbed(owner: str, bed: Foundation) -> None:
    """Refuse a bed whose slip is not known for worn profiles: layers that slide on one another, bodies that relax."""
    refuse_unless_pressed(owner, bed)
    if offers(bed.medium, PushedWaves):
        _ = bed.medium.tangential_response


def refuse_unless_pressed(owner: str, bed: Foundation) -> None:
    """Refuse a bed whose pressure is not known for worn profiles."""
    medium = bed.medium
    if not (isinstance(medium, HomogeneousMedium) or offers(medium, PowerOfDepth) or offers(medium, PressedWaves)):
        raise OutsideValidity(
            f"{owner}: the pressure of a worn profile on a {type(medium).__name__} is not known; give elastic "
            "bodies: HalfSpace, GradedHalfSpace, CoatedHalfSpace, SlidingFilm, StackedHalfSpace or "
            "DepthGradedHalfSpace."
        )


Cells: TypeAlias = Annotated[int, Whole(20, 5000, "cells")]
WearTolerance: TypeAlias = Annotated[float, between(1e-9, 1e-2)]
