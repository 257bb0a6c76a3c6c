"""Validity notes and refusals of every impact, and the number of its states."""

from __future__ import annotations

import math
from typing import Annotated, TypeAlias

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.friction import Coulomb
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.direction import direction_notes
from winkler.problems.ring_slip.moving_notes import IN_IMPACTS, moving_ring_notes
from winkler.values.checks.number_checks import Whole
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note, Standing

LARGEST_FRICTION = 1e5
"""More friction than this differs from no slip by rounding alone."""

MAW = "N. Maw, J. R. Barber, J. N. Fawcett, Wear 38 (1976) 101-114, doi:10.1016/0043-1648(76)90201-5"

PLANAR = Note(
    Assumption.SLIP,
    Standing.ASYMPTOTIC,
    "Tractions are assumed parallel to the motion (Cattaneo-Mindlin). Under this assumption stick, slip and "
    "reversals are followed exactly. Spin about the normal is neglected.",
    MAW,
)


def gravity_note(force: Array) -> Note:
    """Return what was left out, against the forces of the contact [N]."""
    return Note(
        Assumption.INERTIA,
        Standing.ASYMPTOTIC,
        "Gravity and other external forces are neglected. They must be small compared with the contact force "
        f"of {np.max(force):.4g} N.",
        "equations of motion",
    )


def refuse_unlikely_spin(
    owner: str, law: Coulomb, mass: float, angular_velocity: float, inertia: float, lever: float
) -> None:
    """Refuse friction that rounding hides, and a spin or an inertia that does not go with the lever.

    Raises
    ------
    InvalidInput
        With what to give instead.
    """
    if LARGEST_FRICTION < law.coefficient < math.inf:
        raise InvalidInput(
            f"{owner}: with a friction coefficient of {law.coefficient:g} hardly a spring slides, and rounding "
            f"hides which; give at most {LARGEST_FRICTION:g}, or Coulomb(math.inf) if nothing slides."
        )
    if lever == 0.0 and (angular_velocity != 0.0 or inertia < math.inf):
        given = (
            f"an angular velocity of {angular_velocity:g} rad/s"
            if angular_velocity != 0.0
            else f"an inertia of {inertia:g} kg m^2"
        )
        raise InvalidInput(
            f"{owner}: with {given} the lever is {lever:g} m; "
            "it must be positive: give the distance from the centre of mass to the surface, the radius of a ball."
        )
    if lever > 0.0 and inertia == math.inf and angular_velocity == 0.0:
        raise InvalidInput(
            f"{owner}: a lever of {lever:g} m acts only on a body that turns; give its inertia, of a ball "
            f"2/5 m R^2, here {0.4 * mass * lever**2:.3g} kg m^2, or leave the lever out."
        )


def slip_notes(bed: Bed, coefficient: float, radius: float) -> tuple[Note, ...]:
    """Return what is assumed of slip in an impact whose widest contact has this radius [m]."""
    along = moving_ring_notes(bed, coefficient, radius, IN_IMPACTS) or (PLANAR,)
    return (*along, sticking_note(bed.medium, coefficient), *direction_notes(bed))


Moments: TypeAlias = Annotated[int, Whole(2, 1_000_000, "moments")]
