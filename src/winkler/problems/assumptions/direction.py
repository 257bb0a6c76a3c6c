"""In which direction the tangential stiffness of a bed holds: of a disc in all of them, of other outlines not."""

from __future__ import annotations

from winkler.footprint import EllipticOutline, UnknownOutline
from winkler.foundation.bed import Bed
from winkler.validity import Assumption, Note, Standing

__all__ = ["direction_notes"]

MINDLIN = "R. D. Mindlin, J. Appl. Mech. 16 (1949) 259-268, doi:10.1115/1.4009973"
MEAN = Note(
    Assumption.SLIP,
    Standing.APPROXIMATE,
    "The ratio of tangential to normal stiffness is that of a disc. The outline of the contact is not known, and if it "
    "is no disc, the ratio depends on the direction: on an ellipse the one of a disc belongs to the mean of the "
    "compliances along and across, from which each of them deviates by 6 % for nu = 0.3 and curvature radii of 1:10.",
    MINDLIN,
)


def direction_notes(bed: Bed) -> tuple[Note, ...]:
    """Return the notes on the direction of shear; none for a disc."""
    outline = bed.footprint
    if isinstance(outline, UnknownOutline):
        return (MEAN,)
    if not isinstance(outline, EllipticOutline):
        return ()
    return (
        Note(
            Assumption.SLIP,
            Standing.EXACT,
            f"The shear is along x, where the semi-axis is {1.0 / outline.slenderness:.3g} of that across: "
            "the tangential stiffness is that of this direction, and sticking and slipping parts are "
            "similar ellipses (Cattaneo, Mindlin).",
            "K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 7.2, doi:10.1017/CBO9781139171731",
        ),
    )
