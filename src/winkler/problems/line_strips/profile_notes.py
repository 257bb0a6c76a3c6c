"""Validity of the contact of a section: half-planes or layers, section, strips, slopes, yield."""

from __future__ import annotations

import math
from typing import cast

import numpy as np

from winkler.media.layered.plane_interior import PlaneWaves
from winkler.media.offers import LayerStack, PowerOfDepth, offers
from winkler.numerics.equations.highest import highest
from winkler.numerics.surfaces.found_strips import FoundStrips
from winkler.numerics.types import Array
from winkler.problems.line.greatest_stress import Placed
from winkler.problems.line.validity import ENDS, HALF_PLANES, PALLOT, POWER_LAW, WAVES
from winkler.problems.line.yield_statement import nearest_to_strength
from winkler.problems.line_strips.strip_fields import LineMedium, layers_below, middle_of, strip_fields, strip_waves
from winkler.problems.normal.strong_parts import StrongPart, strong_parts
from winkler.problems.normal.unknown_yield import MISES
from winkler.problems.normal.validity import steepness_note
from winkler.problems.normal.yield_statement import elastic_note
from winkler.profiles.sections.section import Section
from winkler.values.validity import Assumption, Note, Standing, standing_of

FINITE = "Effects of the ends of a body of finite length and thickness are neglected."
FLAMANT = "K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 2.7, doi:10.1017/CBO9781139171731"
FINE, COARSE = 0.02, 0.1
"""Change from half as many elements up to which results count as fine, and as coarse."""
MOST_STRESSED, AWAY = 3, 0.1
"""Strips below which the greatest stress is sought; depth below a sharp place at which it is judged, over the
half-width."""
PLACES, DEPTHS, FINEST_DEPTH = 25, 21, 1e-3
WIDTHS_SEARCHED, DEEPEST_SEARCHED = 1.5, 2.5


def profile_notes(section: Section, medium: LineMedium, found: FoundStrips | None, error: float) -> tuple[Note, ...]:
    """Return what was assumed of a section, and how well its strips are known.

    Parameters
    ----------
    section, medium
        The bodies.
    found
        The strips under the greatest load; none without contact.
    error
        The greatest `strip_error` of all loads.
    """
    layered = layers_below(medium)
    standing, body = (Standing.EXACT, HALF_PLANES) if layered is None else layered.response.first.in_plane
    source = FLAMANT if layered is None else WAVES
    if offers(medium, PowerOfDepth):
        body, source = POWER_LAW, PALLOT
    response = Note(
        Assumption.RESPONSE,
        standing,
        f"{body}. All strips interact. {ENDS if layered else FINITE}",
        source,
    )
    if offers(medium, PowerOfDepth):
        section_notes = (*section.notes, *(note for note in medium.notes if note.standing is not Standing.EXACT))
    else:
        section_notes = section.notes
    if found is None:
        apart = "The bodies do not touch under this load."
        return (*section_notes, response, Note(Assumption.EQUILIBRIUM, Standing.EXACT, apart, "the load is zero"))
    if found.refined:
        text = (
            "Edges and pressures of the strips were refined. At the sampled places there is no tension and no "
            f"overlap, and slopes are met within {error:.2g} of their maximum."
        )
        resolution = Note(Assumption.RESOLUTION, Standing.EXACT, text, "a-posteriori check between the nodes")
    else:
        text = (
            "The strips consist of equal elements. Contact length and maximum pressure may differ by up to "
            f"{100.0 * error:.2g} per cent. This is estimated from the elements at the edges or from half as many "
            "elements."
            if math.isfinite(error)
            else "The strips consist of equal elements; with half as many there is no contact to compare with."
        )
        resolution = Note(
            Assumption.RESOLUTION,
            standing_of(error, FINE, COARSE),
            text,
            "comparison of two grids",
            error if math.isfinite(error) else None,
        )
    x = _inside(found.edges)
    steep = max(float(np.max(np.abs(section.slope(x) - found.tilt))), abs(found.tilt))
    notes = [*section_notes, response, resolution, steepness_note(steep)]
    if _sharp(found):
        text = "The pressure is infinite under a sharp crest or at a wall; a real edge yields or is rounded."
        notes.append(Note(Assumption.SHAPE, Standing.EXACT, text, "elastic field at a corner"))
    return (*notes, *_yield_notes(medium, found))


def _inside(edges: Array) -> Array:
    share = (np.arange(33) + 0.5) / 33.0
    return np.asarray((edges[:, :1] + share * np.diff(edges, axis=1)).ravel())


def _sharp(found: FoundStrips) -> bool:
    return not math.isfinite(float(np.max(found.peaks)))


def _yield_notes(medium: LineMedium, found: FoundStrips) -> tuple[Note, ...]:
    """Return whether the body that comes nearest to its strength stays elastic."""
    parts = strong_parts(medium)
    if not parts:
        return ()
    share, where = nearest_to_strength((_greatest(medium, found, part), part) for part in parts)
    if not _sharp(found):
        return (elastic_note(share, where, Standing.EXACT if found.refined else Standing.APPROXIMATE),)
    text = (
        "The elastic stress is infinite under a sharp crest or at a wall, which yields under the smallest load; "
        f"{AWAY:g} half-widths below, the greatest von Mises stress is {where}"
        f"{'' if share < 1.0 else ': the result is not elastic'}."
    )
    return (Note(Assumption.ELASTIC, Standing.APPROXIMATE if share < 1.0 else Standing.OUTSIDE, text, MISES),)


def _greatest(medium: LineMedium, found: FoundStrips, part: StrongPart) -> Placed:
    """Return the greatest von Mises stress of a part below the strips of the greatest pressures or forces."""
    edges = found.edges
    level = found.peaks if not _sharp(found) else found.forces / np.diff(edges, axis=1)[:, 0]
    searched = [edges[index] for index in np.argsort(-level)[:MOST_STRESSED]]
    if part.top > 0.0 and len(edges) > 1:
        searched.append(edges[[0, -1], [0, 1]])  # deep down all strips press as one
    best = Placed(0.0, 0.0, 0.0)
    for ends in searched:
        middle, half = float(np.mean(ends)), 0.5 * float(np.diff(ends)[0])
        shallow = half * (AWAY if _sharp(found) or not found.refined else FINEST_DEPTH)
        spread = math.hypot(half, part.top)
        x = middle + spread * WIDTHS_SEARCHED * np.linspace(-1.0, 1.0, PLACES)
        deepest = min(DEEPEST_SEARCHED * spread, part.bottom - part.top)
        z = part.top + np.geomspace(min(shallow, 0.5 * deepest), deepest, DEPTHS)
        waves = None
        if layers_below(medium) is not None and part.first:
            farthest = float(np.max(np.abs(x - middle_of(found))))
            waves = strip_waves(cast(LayerStack, medium), found, farthest)

        def stress(across: Array, down: Array, waves: PlaneWaves | None = waves) -> Array:
            depth = down if part.first else -down
            return strip_fields(medium, found, across, depth, part.first, waves=waves).von_mises

        top = highest(stress, [x, z])
        best = max(best, Placed(top.value, *top.place), key=lambda one: one.value)
    return best if part.first else best._replace(z=-best.z)
