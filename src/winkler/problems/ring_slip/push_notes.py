"""What is assumed where rings of layered and graded bodies slide along the surface."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.torsion_bound import TwistBound
from winkler.numerics.transforms import fredholm
from winkler.problems.ring_slip.push_bound import pushed_body
from winkler.problems.ring_slip.ring_notes import TABLES_ERROR
from winkler.values.validity import Assumption, Note, Standing


def push_note(bed: Bed, radius: float) -> Note:
    """Return what is assumed of tractions on layers.

    Parameters
    ----------
    bed : Bed
    radius : float
        Of the widest contact [m].
    """
    softer = f"by a fraction of {-_stuck_error(bed, radius):.1e}" if radius > 0.0 else "slightly"
    return Note(
        Assumption.SLIP,
        Standing.APPROXIMATE,
        "Tractions are assumed parallel to the motion and axisymmetric; displacements are averaged over each "
        f"annular element (Cattaneo and Mindlin). This assumption lowers the stiffness without slip {softer}. The "
        "normal and shear kernels are those of the layers or the graded body. Each annular element carries at "
        "most its own normal load times the coefficient of friction.",
        "k_x with tractions of both directions, from flat punches on waves along and across the motion",
    )


def tables_note(bound: TwistBound) -> Iterator[Note]:
    """Yield how well what springs bear is known, where kernels have a logarithm; nothing elsewhere."""
    if bound.logarithmic:
        yield Note(
            Assumption.RESOLUTION,
            Standing.ASYMPTOTIC,
            "The kernels of a graded body contain a logarithm, which polynomials approximate. The relative error "
            f"of shear forces is at most {bound.miss:.1e}. Tractions have an error of {TABLES_ERROR:.0e} of the "
            "tractions at full sliding.",
            "stiffness without slip from the tables against that of flat punches; panels halved",
        )


def _stuck_error(bed: Bed, radius: float) -> float:
    """Return by which part k_x of tractions along the motion differs from that of all tractions [-]."""
    place, medium = np.array([radius]), pushed_body(bed)
    mean = 2.0 * medium.shear_modulus * fredholm.area(medium.tangential_response, place)
    return float(mean[0] / medium.punch_shear_stiffness(place)[0]) - 1.0
