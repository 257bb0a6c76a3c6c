"""What problems of wear take: springs that know their tractions, a law, one steady load, a grid and a tolerance."""

from __future__ import annotations

import numpy as np

from winkler.errors import InvalidInput, OutsideValidity
from winkler.foundation.foundation import Foundation
from winkler.laws.wear import OwnWear, PairWear, WearLaw
from winkler.loading import Depth, Force, Normal
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.halfspace import HomogeneousMedium
from winkler.path import numbers_of
from winkler.problems.normal.indentation import IndentationSolution

__all__ = ["check_fineness", "check_normal", "check_wear", "touching", "wearable"]

FEWEST, MOST = 20, 5000


def wearable(owner: str, bed: Foundation) -> None:
    """Refuse a bed whose pressure and slip do not follow from its springs in closed form."""
    if not isinstance(bed, Foundation):
        raise InvalidInput(
            f"{owner}: the bed is a {type(bed).__name__}; give Foundation(profile, medium): what wears is the profile."
        )
    if not isinstance(bed.medium, HomogeneousMedium | GradedHalfSpace):
        raise OutsideValidity(
            f"{owner}: in a {type(bed.medium).__name__} pressure and slip do not follow from the springs alone, and "
            "layers wear away themselves; give HalfSpace(first, second) or GradedHalfSpace(first, second), or ask for "
            "LimitingProfile, which takes elastic layers and gradings, too."
        )


def check_wear(owner: str, law: WearLaw) -> None:
    """Refuse what is no law of wear."""
    if not isinstance(law, OwnWear | PairWear):
        raise InvalidInput(
            f"{owner}: wear is a {type(law).__name__}; give Archard(rate), PairWear(first, second), or a law with a "
            "method depth_per_slip(pressure)."
        )


def check_normal(owner: str, normal: Normal) -> None:
    """Refuse anything but one positive depth or force."""
    if not isinstance(normal, Depth | Force) or numbers_of(normal).ndim != 0 or not float(numbers_of(normal)) > 0.0:
        raise InvalidInput(
            f"{owner}: normal is {normal!r}; give Depth(d) or Force(F) with one positive number, and sweep over "
            "several."
        )


def check_fineness(owner: str, count: int, tolerance: float) -> None:
    """Refuse a grid or a tolerance that is out of range."""
    if isinstance(count, bool) or not isinstance(count, int) or not FEWEST <= count <= MOST:
        raise InvalidInput(f"{owner}: count is {count!r}; give a whole number of cells from {FEWEST} to {MOST}.")
    if isinstance(tolerance, bool) or not isinstance(tolerance, int | float) or not 1e-9 <= tolerance <= 1e-2:
        raise InvalidInput(f"{owner}: tolerance is {tolerance!r}; give a number between 1e-9 and 1e-2.")


def touching(owner: str, contact: IndentationSolution) -> IndentationSolution:
    """Return a contact; refuse one in which the bodies do not touch."""
    if not float(np.asarray(contact.radius)) > 0.0:
        raise OutsideValidity(f"{owner}: the bodies do not touch under this load; press them together.")
    return contact
