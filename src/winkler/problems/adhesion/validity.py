"""Validity notes of an adhesive contact: range of attraction, slopes, size, overlap outside."""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.adhesion import AdhesionLaw, DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.numerics.types import Array
from winkler.problems.adhesion import griffith
from winkler.problems.adhesion.law_states import states_of
from winkler.problems.assumptions.adhesion_range import GREENWOOD, range_note
from winkler.problems.assumptions.film import film_notes
from winkler.problems.normal.strong_parts import strong_parts
from winkler.problems.normal.validity import shape_notes
from winkler.problems.normal.yield_statement import FRICTIONLESS, SurfaceFriction, yield_notes
from winkler.values.validity import Assumption, Note, Standing

JKR = "K. L. Johnson, K. Kendall, A. D. Roberts, Proc. R. Soc. Lond. A 324 (1971) 301, doi:10.1098/rspa.1971.0141"
MAUGIS = "D. Maugis, J. Colloid Interface Sci. 150 (1992) 243-269, doi:10.1016/0021-9797(92)90285-T"
DMT = "B. V. Derjaguin, V. M. Muller, Yu. P. Toporov, J. Colloid Interface Sci. 53 (1975) 314-326"
OVERLAP_TOLERANCE = 1e-9
SAMPLES = 512


def adhesive_notes(
    bed: Bed, law: AdhesionLaw, depth: Array, radius: Array, rubbing: SurfaceFriction = FRICTIONLESS
) -> tuple[Note, ...]:
    """Return the notes of adhesive contacts `(m,)`; of several, those of the widest one.

    Parameters
    ----------
    bed : Bed
    law : AdhesionLaw
    depth, radius : ndarray, (m,)
        [m].
    rubbing : SurfaceFriction, optional
        What is known of friction, for the onset of yield.
    """
    last = int(np.argmax(radius))
    widest = float(radius[last])
    notes = [*bed.notes, _law_note(bed, law, widest)]
    if widest == 0.0:
        touch = "The bodies touch in a point. Attraction beyond this point, without contact, is not computed."
        return (*notes, Note(Assumption.EQUILIBRIUM, Standing.EXACT, touch, "no spring is compressed"))
    notes += shape_notes(bed, widest)
    notes.extend(film_notes(bed, float(depth[last]), float(griffith.force_at(bed, depth[last], radius[last])), widest))
    if widest >= bed.rim:
        notes.append(
            Note(
                Assumption.EQUILIBRIUM,
                Standing.EXACT,
                "The edge of the contact is pinned at the rim of the body.",
                "Kendall's flat punch",
            )
        )
    elif not bed.rising:
        notes.append(_overlap_note(bed, law, float(depth[last]), widest))
    if strong_parts(bed.medium):
        notes += yield_notes([states_of(bed, law).pressed(float(depth[last]), widest)], rubbing)
    return tuple(notes)


def _law_note(bed: Bed, law: AdhesionLaw, radius: float) -> Note:
    if isinstance(law, Dugdale):
        stretch = float(griffith.stretch(bed, law.work, np.array([radius]))[0])
        return Note(
            Assumption.ADHESION,
            Standing.EXACT,
            f"Exact for a constant stress of the range {law.range:.3g} m, which is {law.range / stretch:.3g} of "
            "the edge stretch in the JKR limit. Other laws of the same work and strength differ in the "
            "transition, but not in its limits."
            if radius > 0.0
            else "Exact for a constant stress.",
            MAUGIS,
        )
    if radius == 0.0:
        models = {ShortRange: f"without range (JKR) [{JKR}]", DerjaguinMullerToporov: f"from afar (DMT) [{DMT}]"}
        return Note(Assumption.ADHESION, Standing.ASYMPTOTIC, f"Attraction {models[type(law)]}.", GREENWOOD)
    stretch = float(griffith.stretch(bed, law.work, np.array([radius]))[0])
    return range_note(law, stretch, "By attraction without range")


def _overlap_note(bed: Bed, law: AdhesionLaw, depth: float, radius: float) -> Note:
    """Look for places outside where the bodies would overlap."""
    end = min(4.0 * radius, bed.reach, bed.rim)
    r = radius + (end - radius) * (np.arange(SAMPLES) + 0.5) / SAMPLES
    pressed = states_of(bed, law).pressed(depth, radius)
    apart = bed.height(r) - depth + bed.medium.displacement(pressed, r)
    touching = apart < -OVERLAP_TOLERANCE * float(np.max(np.abs(bed.height(r))) + abs(depth))
    if touching.any():
        return Note(
            Assumption.SINGLE_CONTACT,
            Standing.OUTSIDE,
            f"At r = {r[touching][0]:.4g} m the bodies would overlap outside the contact. A ring touches there, "
            "and the contact is not a disc.",
            "separation of the restored surfaces",
        )
    return Note(
        Assumption.SINGLE_CONTACT,
        Standing.EXACT,
        "The equivalent profile may decrease somewhere. It was checked that the bodies do not overlap outside "
        "the contact.",
        "separation of the restored surfaces",
    )
