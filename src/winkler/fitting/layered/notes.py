"""Validity notes of a fit on layers that relax: shape, what lies below the film, and the error of the cells."""

from __future__ import annotations

import math

import numpy as np

from winkler.fitting.layered.response import TooWide, along_path, relaxing_solid, stack_waves
from winkler.fitting.validity import coating_notes
from winkler.foundation.bed import Bed
from winkler.foundation.on_medium import OnMedium
from winkler.media.relaxing.layered import ViscoelasticCoatedHalfSpace
from winkler.numerics.types import Array
from winkler.problems.assumptions.film import film_notes
from winkler.problems.normal.validity import shape_notes
from winkler.values.errors import WinklerError
from winkler.values.validity import Assumption, Note, Standing

CELLS, FEWER_CELLS, MARGIN = 64, 32, 1.3
SMALL_CHANGE, LARGE_CHANGE = 1e-3, 1e-2
"""Of the greatest force, up to which the cells are good, and beyond which they are not."""
HALF = "the same path with half as many cells"


def layered_fit_notes(bed: Bed, names: tuple[str, ...], time: Array, depth: Array, radius: Array) -> tuple[Note, ...]:
    """Return the notes of a fitted contact.

    Parameters
    ----------
    bed : Bed
        With the fitted numbers, on a `ViscoelasticCoatedHalfSpace`.
    names : tuple of str
        Of the free numbers.
    time, depth, radius : ndarray, (n,)
        Of the fitted contact [s], [m], [m].
    """
    assert isinstance(bed, OnMedium)
    assert isinstance(bed.medium, ViscoelasticCoatedHalfSpace)
    widest, deepest = float(np.max(radius)), float(np.max(depth))
    if not widest > 0.0:
        return ()
    relaxed = bed.with_medium(bed.medium.relaxed)
    notes = [*shape_notes(bed, widest), *coating_notes(relaxed, names, widest)]
    solid = relaxing_solid(bed)
    try:
        fine, coarse = (
            along_path(stack_waves(bed, min(MARGIN * widest, bed.rim), count), solid, time, depth, (1.0, 0.0)).force
            for count in (CELLS, FEWER_CELLS)
        )
    except (WinklerError, TooWide) as failed:
        cause = str(failed) or "the contact reaches the last of them"
        statement = f"Cells: their error is not known: {cause}"
        return (*notes, Note(Assumption.RESOLUTION, Standing.APPROXIMATE, statement, HALF))
    most = float(np.max(fine))
    change = float(np.max(np.abs(fine - coarse))) / most if most > 0.0 else math.inf
    standing = Standing.ASYMPTOTIC if change <= SMALL_CHANGE else Standing.APPROXIMATE
    if change > LARGE_CHANGE:
        standing = Standing.OUTSIDE
    statement = (
        f"Cells: half as many of the {CELLS} along the radius change the forces by {change:.2g} of the maximum "
        "force; the fitted forces have about this error at most."
    )
    notes.append(Note(Assumption.RESOLUTION, standing, statement, HALF))
    return (*notes, *film_notes(bed, deepest, most, widest))
