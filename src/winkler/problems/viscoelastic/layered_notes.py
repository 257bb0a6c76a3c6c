"""Validity notes of contacts whose layers relax each by a law of its own: shape, edge, error of cells and steps."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.loading.loads import Depth, Force
from winkler.numerics.caching import cached_by_value
from winkler.numerics.types import Array
from winkler.problems.assumptions.film import film_notes
from winkler.problems.normal.unknown_yield import relaxing_yield
from winkler.problems.normal.validity import shape_notes
from winkler.problems.viscoelastic.layered_path import STEP_CELLS, marched, stepped
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing

HALVED = "the same with half as many cells and steps of eight times the error"
COARSER_STEPS = 8.0
SMALL_CHANGE, LARGE_CHANGE = 1e-3, 1e-2
"""Of the greatest force or depth, where numbers are good, and where they are not known."""


def layered_notes(problem: Any, solution: Any, own: tuple[Note, ...], error: Note | None = None) -> tuple[Note, ...]:
    """Return the notes on bed, shape, cells and yield about those of one kind of problem, and of its error."""
    bed, radius = problem.bed, float(np.max(solution.radius))
    shape = shape_notes(bed, radius) if radius > 0.0 else []
    depths, forces, radii = (np.ravel(each) for each in (solution.depth, solution.force, solution.radius))
    deepest = int(np.argmax(depths))
    shape.extend(film_notes(bed, float(depths[deepest]), float(forces[deepest]), float(radii[deepest])))
    error = error or _error_note(problem, solution)
    return (*bed.notes, *shape, *_disc(bed, radius), error, *own, *relaxing_yield(bed.medium))


def _disc(bed: Any, radius: float) -> tuple[Note, ...]:
    one = Note(
        Assumption.SINGLE_CONTACT,
        Standing.EXACT,
        "It was checked at every point that the contact is one disc: no tension inside, no overlap outside.",
        "a-posteriori check of pressure and separation, at sampled places",
    )
    return (one,) if 0.0 < radius < bed.rim else ()


def _error_note(problem: Any, solution: Any) -> Note:
    """Return by how much cells and steps twice as coarse change what was not prescribed, as it was solved."""
    forces, depths = np.ravel(solution.force), np.ravel(solution.depth)
    try:
        force, depth = _coarser(problem)
    except (InvalidInput, NotConverged, OutsideValidity) as failed:
        return Note(
            Assumption.RESOLUTION,
            Standing.APPROXIMATE,
            f"The error of cells and steps is not known, because no coarser solution was found: {failed}",
            HALVED,
        )
    many = min(force.size, forces.size)
    change = max(changed_by(force[:many], forces[:many]), changed_by(depth[:many], depths[:many]))
    return resolution_note(problem.bed, "force or depth", change, float(np.max(solution.radius)))


def resolution_note(bed: Any, what: str, change: float, widest: float) -> Note:
    """Return the note on a change [-] by half as many cells, up to a radius or half-width [m]."""
    error = float(bed.medium.creep_of_waves(widest / STEP_CELLS, widest).error)
    if change <= SMALL_CHANGE:
        standing = Standing.ASYMPTOTIC
    else:
        standing = Standing.APPROXIMATE if change <= LARGE_CHANGE else Standing.OUTSIDE
    return Note(
        Assumption.RESOLUTION,
        standing,
        f"Half as many cells, and coarser steps, change {what} by {change:.2g} of the maximum; the remaining "
        "error is at most about as large. The sum of exponentials for a wavelength has an error of at most "
        f"{error:.0e}.",
        HALVED,
    )


def changed_by(coarse: Array, fine: Array) -> float:
    """Return the greatest change over the greatest number [-]."""
    greatest = float(np.max(np.abs(fine)))
    return float(np.max(np.abs(coarse - fine))) / greatest if greatest > 0.0 else 0.0


@cached_by_value(32)
def _coarser(problem: Any) -> tuple[Array, Array]:
    """Return force [N] and depth [m] of a coarser solution."""
    path = getattr(problem, "path", None)
    if path is not None:
        count, tolerance = max(2, problem.count // 2), COARSER_STEPS * problem.tolerance
        found = marched("validity", problem.bed, path.time, path.normal, path.across, count, tolerance)
        states = [point.state for _, point in found]
        return np.array([state.force for state in states]), np.array([state.depth for state in states])
    load = Depth(problem.depth) if hasattr(problem, "depth") else Force(problem.force)
    depth, force, _ = stepped("validity", problem.bed, problem.time, load, STEP_CELLS // 2)
    return force, depth
