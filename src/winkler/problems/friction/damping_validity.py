"""Validity notes of every solution of damping by friction."""

from __future__ import annotations

import math

from winkler.foundation.bed import Bed
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.direction import direction_notes
from winkler.problems.normal.stiffness_ratio import alike, stiffness_ratios
from winkler.problems.ring_slip.push_bound import push_bound
from winkler.problems.ring_slip.push_notes import push_note, tables_note
from winkler.values.validity import Assumption, Note, Standing

__all__ = ["STEADY", "damping_notes"]

JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 7.2, doi:10.1017/CBO9781139171731"
POPOV_HESS = "V. L. Popov, M. Hess, Method of Dimensionality Reduction, Springer 2015, doi:10.1007/978-3-642-53876-6"
JAEGER = "J. Jaeger, Arch. Appl. Mech. 65 (1995) 478-487, doi:10.1007/BF00835661"

STEADY = Note(
    Assumption.STEADY,
    Standing.EXACT,
    "The loss is that of every cycle from the second on: each spring's cycle takes its displacement to the "
    "nearest point of one fixed interval, and once there it stays.",
    "composition of the springs' own steps, each of which is such a projection and a shift",
)
ALONG = Note(
    Assumption.SLIP,
    Standing.ASYMPTOTIC,
    "Tractions are taken along the motion (Cattaneo-Mindlin); within that, every spring sticks and slides as "
    "its ring of the contact does. Where Poisson's ratio is not zero, points slide at a small angle to it, "
    "nu/(4 - 2 nu) at most.",
    JOHNSON,
)
SLOW = Note(
    Assumption.INERTIA,
    Standing.ASYMPTOTIC,
    "The motion is slow: inertia, waves and damping within the bodies are left out.",
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
            "Springs of one gap stick and slide together, since their stiffnesses have one ratio "
            f"({least:.4g}): sums over springs are the three-dimensional sums within Cattaneo-Mindlin.",
            JAEGER,
        )
    elif math.isinf(coefficient):
        alone = Note(
            Assumption.SLIP,
            Standing.EXACT,
            "Nothing slides: springs bear what the stiffness k_x(a) of a disc without slip grows by with its radius, "
            "and what leaves the contact loses what it bore.",
            "superposition of discs of all radii, each moved along the surface as a whole",
        )
    else:
        alone = Note(
            Assumption.SLIP,
            Standing.APPROXIMATE,
            f"The tangential stiffness of the springs is between {least:.3g} and {greatest:.3g} of the "
            "normal one: that springs slide by themselves is then an assumption, not a theorem; the error is "
            "not known, and is expected to be of the order of the spread of that ratio.",
            POPOV_HESS,
        )
    return (alone, sticking_note(bed.medium, coefficient), *direction_notes(bed), ALONG, SLOW)
