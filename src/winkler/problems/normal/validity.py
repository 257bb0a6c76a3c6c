"""Validity notes of an indentation: slopes, size of the body, pinned edges, onset of yield."""

from __future__ import annotations

import math

import numpy as np

from winkler.foundation.bed import Bed
from winkler.numerics.types import Array
from winkler.problems.assumptions.film import film_notes
from winkler.problems.normal.overlap import rises
from winkler.problems.normal.single_contact import unfinished
from winkler.problems.normal.yield_statement import FRICTIONLESS, SurfaceFriction, yield_notes_of_bed
from winkler.values.validity import Assumption, Note, Standing

JOHNSON = "K. L. Johnson, Contact Mechanics, Cambridge 1985, doi:10.1017/CBO9781139171731"
SLOPE_ERROR = 0.4
"""Part of the load that a slope of one costs at most: Hay's correction under a cone on a body with nu = 0."""
SIZE_ERROR = 0.425
"""Part of the approach that a radius of contact as large as the body's costs at most: what Boussinesq's field of the
opposite force moves the contact of a sphere with nu = 0.5."""
HAY = "J. C. Hay, A. Bolshakov, G. M. Pharr, J. Mater. Res. 14 (1999) 2296, doi:10.1557/JMR.1999.0306"


def indentation_notes(
    bed: Bed, depth: Array, radius: Array, rubbing: SurfaceFriction = FRICTIONLESS
) -> tuple[Note, ...]:
    """Return the notes of an indentation; of several loads, those of the widest contact.

    Parameters
    ----------
    bed : Bed
    depth, radius : ndarray, (m,)
        [m].
    rubbing : SurfaceFriction, optional
        What is known of friction, for the onset of yield.
    """
    return (*bed.notes, *contact_notes(bed, depth, radius), *yield_notes_of_bed(bed, depth, radius, rubbing))


def contact_notes(bed: Bed, depth: Array, radius: Array) -> tuple[Note, ...]:
    """Return the notes on the validity of the widest of several contacts: slopes, size, a pinned edge, one disc."""
    if not np.any(radius > 0.0):
        return (
            Note(
                Assumption.EQUILIBRIUM,
                Standing.EXACT,
                "The bodies do not touch under this load.",
                "no spring is compressed",
            ),
        )
    last = int(np.argmax(depth))
    widest = float(radius[last])
    notes = shape_notes(bed, widest)
    if widest >= bed.rim:
        notes.append(
            Note(
                Assumption.SHAPE,
                Standing.EXACT,
                "The contact is pinned at the rim, where the pressure is infinite; a real edge yields or is rounded.",
                "Boussinesq's flat punch",
            )
        )
    deepest, force = float(depth[last]), float(bed.stiffness(radius[last]) * depth[last] - bed.gap_load(radius[last]))
    notes.extend(film_notes(bed, deepest, force, widest))
    if not bed.certain:
        notes.append(_disc_note(bed, float(depth[last]), widest))
    return tuple(notes)


def _disc_note(bed: Bed, depth: float, radius: float) -> Note:
    """Return the note on how it was checked that the contact is one disc."""
    failed = unfinished(bed, depth, radius)
    if failed:
        return Note(
            Assumption.SINGLE_CONTACT,
            Standing.APPROXIMATE,
            f"It is not known whether the contact is one disc, because the check did not finish ({failed}). "
            "Depth, force and radius are those of a disc.",
            "a-posteriori check of pressure and separation, at sampled places",
        )
    if not rises(bed, radius):
        checks = "the equivalent profile decreases somewhere, so pressure and separation were examined"
    elif bed.medium.punch_facts(radius).pulls:
        checks = (
            "the equivalent profile increases, but flat punches of this width have tension, so the pressure was "
            "examined"
        )
    else:
        checks = (
            "the equivalent profile increases at all examined places, and flat punches up to this radius have no "
            "tension"
        )
    return Note(
        Assumption.SINGLE_CONTACT,
        Standing.EXACT,
        f"It was checked that the contact is one disc: no tension inside, no overlap outside ({checks}).",
        "a-posteriori check of pressure and separation, at sampled places",
    )


def shape_notes(bed: Bed, radius: float) -> list[Note]:
    """Return what the slopes within a contact of this radius and the size of the body mean for the theory."""
    share = np.linspace(0.0, 1.0, 65)[1:]
    inside = radius * (share[:-1] if radius >= bed.rim else share)  # a rim has no slope
    notes = [steepness_note(float(np.max(np.abs(bed.slope(inside)))))]
    return [*notes, large_body_note(radius / bed.size)] if math.isfinite(bed.size) else notes


def steepness_note(slope: float) -> Note:
    """Return what the steepest slope [-] within a contact means for the theory."""
    if slope == 0.0:
        standing, verdict = Standing.EXACT, "the surface is flat"
    elif slope <= 0.1:
        standing, verdict = Standing.ASYMPTOTIC, "small, as the theory assumes"
    elif slope <= 1.0:
        standing = Standing.APPROXIMATE
        verdict = (
            "not small: expect deviations of the order of (1 - 2 nu) times the slope and of its square; for nu = "
            "0.5 only the square remains"
        )
    else:
        standing, verdict = Standing.OUTSIDE, "far from small: the linear half-space no longer describes this contact"
    statement = f"The steepest slope within the contact is {slope:.3g}: {verdict}."
    return Note(Assumption.SMALL_SLOPES, standing, statement, HAY, SLOPE_ERROR * slope)


def large_body_note(ratio: float, *, strip: bool = False) -> Note:
    """Return what the contact radius, or the half-width of a strip, over the radius of the body [-] means."""
    if ratio <= 0.1:
        standing, verdict = Standing.ASYMPTOTIC, "the body can be treated as a half-space"
    elif ratio <= 0.5:
        standing, verdict = Standing.APPROXIMATE, "the body deviates notably from a half-space"
    else:
        standing, verdict = Standing.OUTSIDE, "the body is no half-space"
    size = "half-width of the contact" if strip else "contact radius"
    error = None if strip else SIZE_ERROR * ratio
    statement = f"The {size} is {ratio:.3g} of the body's radius: {verdict}."
    return Note(Assumption.HALF_SPACE, standing, statement, JOHNSON, error)
