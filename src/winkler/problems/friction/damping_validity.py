"""Validity notes of every solution of damping by friction."""

from __future__ import annotations

import math

from winkler.foundation.bed import Bed
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.direction import direction_notes
from winkler.problems.normal.stiffness_ratio import alike, stiffness_ratios
from winkler.problems.ring_slip.moving_notes import STUCK
from winkler.problems.ring_slip.push_bound import push_bound
from winkler.problems.ring_slip.push_notes import push_note, tables_note
from winkler.values.validity import Assumption, Note, Standing

JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 7.2, doi:10.1017/CBO9781139171731"
POPOV_HESS = "V. L. Popov, M. Hess, Method of Dimensionality Reduction, Springer 2015, doi:10.1007/978-3-642-53876-6"
JAEGER = "J. Jaeger, Arch. Appl. Mech. 65 (1995) 478-487, doi:10.1007/BF00835661"

STEADY = Note(
    Assumption.STEADY,
    Standing.EXACT,
    "From the second cycle on every spring repeats its motion, and the dissipated energy per cycle is constant.",
    "the displacement of each spring is projected on a fixed interval in every step",
)
ALONG = Note(
    Assumption.SLIP,
    Standing.ASYMPTOTIC,
    "Tractions are assumed parallel to the motion (Cattaneo-Mindlin). Under this assumption every spring sticks "
    "and slips with its annulus of the contact. If Poisson's ratio is not zero, the true slip deviates from the "
    "motion by an angle of at most nu/(4 - 2 nu).",
    JOHNSON,
)
SLOW = Note(
    Assumption.INERTIA,
    Standing.ASYMPTOTIC,
    "The motion is slow: inertia, waves and damping inside the bodies are neglected.",
    "quasi-static contact of elastic bodies",
)


def damping_notes(bed: Bed, radius: float, coefficient: float, rings: bool = False) -> tuple[Note, ...]:
    """Return what is assumed of friction in a contact.

    Parameters
    ----------
    bed : Bed
    radius : float
        Up to which the bodies touch [m].
    coefficient : float
        Of friction [-]; infinity where nothing slips.
    rings : bool
        Whether rings of layers slide, not springs.
    """
    if rings:
        tables = tables_note(push_bound(bed, coefficient, radius, False))
        return (push_note(bed, radius), *tables, sticking_note(bed.medium, coefficient), *direction_notes(bed), SLOW)
    least, greatest = ratios = stiffness_ratios(bed, radius)
    if alike(ratios):
        alone = Note(
            Assumption.SLIP,
            Standing.EXACT,
            f"All springs have the same ratio of tangential to normal stiffness ({least:.4g}), so springs of "
            "equal gap stick and slip together. Sums over the springs are equal to the three-dimensional "
            "integrals under the Cattaneo-Mindlin assumption.",
            JAEGER,
        )
    elif math.isinf(coefficient):
        alone = STUCK
    else:
        alone = Note(
            Assumption.SLIP,
            Standing.APPROXIMATE,
            f"The ratio of tangential to normal spring stiffness varies between {least:.3g} and {greatest:.3g}. "
            "Independent slip of the springs is then an assumption, not a theorem. Its error is not known; it is "
            "expected to be of the order of the spread of this ratio.",
            POPOV_HESS,
        )
    return (alone, sticking_note(bed.medium, coefficient), *direction_notes(bed), ALONG, SLOW)
