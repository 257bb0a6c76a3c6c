"""In which direction the tangential stiffness of a bed holds: of a disc in all of them, of other outlines not."""

from __future__ import annotations

import math

from winkler.foundation.bed import Bed
from winkler.foundation.directional import DirectionalBed
from winkler.foundation.footprint import EllipticOutline, UnknownOutline
from winkler.values.validity import Assumption, Note, Standing

MINDLIN = "R. D. Mindlin, J. Appl. Mech. 16 (1949) 259-268, doi:10.1115/1.4009973"
JAEGER = (
    "M. Ciavarella, Int. J. Solids Struct. 35 (1998) 2349-2362, doi:10.1016/S0020-7683(97)00154-6; J. Jaeger, "
    "Arch. Appl. Mech. 65 (1995) 478-487, doi:10.1007/BF00835661"
)
MEAN = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "The ratio of tangential to normal stiffness is that of a disc. The outline of the contact is not known; if "
    "it is not a disc, the ratio depends on the direction. For an ellipse the ratio of a disc belongs to the "
    "mean of both compliances. Each compliance deviates from this mean by 6 % for nu = 0.3 and curvature radii "
    "of 1:10.",
    MINDLIN,
)


def direction_notes(bed: Bed) -> tuple[Note, ...]:
    """Return the notes on the direction of shear; none for a disc."""
    if isinstance(bed, DirectionalBed):
        return (_directional_note(bed),)
    outline = bed.footprint
    if isinstance(outline, UnknownOutline):
        return (MEAN,)
    if not isinstance(outline, EllipticOutline):
        return ()
    return (
        Note(
            Assumption.SLIP,
            Standing.EXACT,
            f"The shear force acts along x; the semi-axis along x is {1.0 / outline.slenderness:.3g} times that "
            "along y. The tangential stiffness is that along x. The stick zone is an ellipse similar to the "
            "contact (Cattaneo, Mindlin).",
            "K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 7.2, doi:10.1017/CBO9781139171731",
        ),
    )


def _directional_note(bed: DirectionalBed) -> Note:
    """Return what springs behind a contact of any outline leave out, and how far that leads if it was measured."""
    measured = bed.shift_error > 0.0 or bed.loss_error > 0.0
    error = (
        "The springs were compared with boundary elements, in a loop with 0.9 of the sliding force at the maximum "
        "depth. "
        f"Displacements differ by at most {_per_cent(bed.shift_error)} % of their maximum, the dissipated energy by "
        f"{_per_cent(bed.loss_error)} %. If the depth varies, the error of the dissipated energy is at most three "
        "times as large"
        if measured
        else "Use ReducedFriction to compute the error of this assumption"
    )
    return Note(
        Assumption.SLIP,
        Standing.APPROXIMATE,
        "The shear force acts along x. At the maximum depth the tangential stiffness without slip is "
        f"{bed.ratios_along[-1]:.4g} of the normal stiffness along x, {bed.ratios_across[-1]:.4g} along y "
        "(boundary elements). Slip is assumed to follow from normal contacts at smaller depths (Ciavarella, "
        f"Jaeger), parallel to the shear force. {error}.",
        JAEGER,
    )


def _per_cent(error: float) -> str:
    """Return an error in per cent, two digits, rounded up."""
    if error == 0.0:
        return "0"
    digit = 10.0 ** (math.floor(math.log10(100.0 * error)) - 1)
    return f"{math.ceil(100.0 * error / digit) * digit:.2g}"
