"""Balls on metals that yield, let go and pressed again, as a law for other programs."""

from __future__ import annotations

import numpy as np

from winkler.exporting.laws.normal import BEYOND
from winkler.exporting.laws.particle import ball_of
from winkler.exporting.step_law import LawTable, StatePart, StepLaw, StepNumber
from winkler.exporting.translation.plain import plain
from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth
from winkler.numerics.types import Array
from winkler.problems.particles.table_step import cubic_energy
from winkler.problems.plastic.first_loading import FirstLoading, first_loading
from winkler.problems.plastic.indentation import PlasticIndentation
from winkler.problems.plastic.yielding_step import step_yielding
from winkler.values.errors import InvalidInput, NotConverged

__all__ = ["yielding_law"]

MOTION = (StepNumber("depth", "m", "d at the end of the step, not positive without contact"),)
ANSWER = (
    StepNumber("force", "N", "normal force, compression positive"),
    StepNumber("stiffness", "N/m", "dF/dd"),
    StepNumber("radius", "m", "contact radius, zero without contact"),
    StepNumber("residual_depth", "m", "depth at which the unloaded bodies would just touch"),
    StepNumber("energy", "J", "what unloading would give back"),
    StepNumber("dissipation", "J", "what it would not, since the beginning"),
)
FIRST_ROWS, MOST_ROWS = 17, 5000
CHECKED = (0.1, 0.3, 0.5, 0.7, 0.9)
"""Places between rows where the table is compared with the law."""
SAFETY_FACTOR = 0.5
STEP = 1e-4
"""Relative change of the depth over which slopes are taken."""
STEPS, SEED = 60, 20261130


def yielding_law(problem: PlasticIndentation, deepest: float, tolerance: float, inputs: tuple[str, ...]) -> StepLaw:
    """Return the law of a ball that yields, or on a body that yields.

    Parameters
    ----------
    problem : PlasticIndentation
    deepest : float
        Up to which depth [m].
    tolerance : float
        Error of force, radius and recovery between rows, over the greatest of each.
    inputs : tuple of str

    Raises
    ------
    InvalidInput
        If the profile is no paraboloid, or the deepest point presses nothing.
    NotConverged
        If the table would need too many rows.
    """
    bed = problem.bed
    assert isinstance(bed, Foundation)
    if not deepest > 0.0:
        raise InvalidInput(f"export: the deepest point presses {deepest:g} m deep; give one that presses the bodies.")
    radius, modulus = ball_of(bed)
    curve = first_loading(bed)
    tables, error = _tables(curve, deepest, tolerance)
    law = LawTable(
        "law", "R [m], E* [Pa], depth of first yield [m]", np.array([radius, modulus, _onset(curve, deepest)])
    )
    notes = (
        f"First loading (cubics between rows) is off by at most {error:.2g} of the greatest force, radius and "
        "recovery, as measured at five places between all rows; unloading from there is in closed form.",
        BEYOND,
        *map(str, PlasticIndentation(bed, Depth(np.array([deepest]))).solve().validity),
    )
    state = (StatePart("memory", "greatest depth so far [m], what has been lost [J]", np.zeros(2)),)
    title = "A ball and a body of which at least one yields: pressed, let go and pressed again"
    rng = np.random.default_rng(SEED)
    trial = deepest * (np.linspace(0.05, 1.0, STEPS) * rng.uniform(-0.1, 1.0, STEPS))[:, np.newaxis]
    return StepLaw(title, step_yielding, (*tables, law), state, MOTION, ANSWER, notes, inputs, trial)


def _onset(curve: FirstLoading, deepest: float) -> float:
    return min(curve.at_onset(by_force=False), deepest)


def _tables(curve: FirstLoading, deepest: float, tolerance: float) -> tuple[tuple[LawTable, ...], float]:
    """Return the rows of first loading, and their greatest error."""
    onset = _onset(curve, deepest)
    if onset >= deepest:
        return _written(curve, np.array([0.0, deepest])), 0.0
    rows = np.concatenate([[0.0], np.geomspace(onset, deepest, FIRST_ROWS)])
    rows[-1] = deepest
    while rows.size <= MOST_ROWS:
        tables = _written(curve, rows)
        errors = _errors(curve, tables)
        coarse = np.flatnonzero(errors > tolerance)
        if not coarse.size:
            return tables, float(np.max(errors))
        rows = np.insert(rows, coarse + 2, np.sqrt(rows[coarse + 1] * rows[coarse + 2]))
    raise NotConverged(f"export: {MOST_ROWS} rows do not give a table to {tolerance:g}; give a greater tolerance.")


def _written(curve: FirstLoading, depth: Array) -> tuple[LawTable, ...]:
    onset = float(depth[1])
    numbers = _numbers(curve, depth)
    slopes = np.zeros_like(numbers)
    slopes[:, 1] = 1.5 * numbers[0, 1] / onset, numbers[1, 1] / onset, 0.0  # of the elastic ball
    if depth.size > 2:
        less, more = (_numbers(curve, depth[2:] * (1.0 + step)) for step in (-STEP, STEP))
        slopes[:, 2:] = (more - less) / (2.0 * STEP * depth[2:])
    slopes[1, 0] = slopes[1, 1]
    energy = np.zeros_like(depth)
    energy[1] = numbers[0, 1] * onset / 2.5
    width, mean = np.diff(depth), np.diff(numbers[0]) / np.diff(depth)
    rows = zip(numbers[0, 1:-1], slopes[0, 1:-1], mean[1:], slopes[0, 2:], width[1:], strict=True)
    energy[2:] = energy[1] + np.cumsum([plain(cubic_energy)(*row, 1.0) for row in rows])
    contents = (
        ("depth", "d [m] of the rows", depth),
        ("force", "F [N]", numbers[0]),
        ("stiffness", "dF/dd [N/m]", slopes[0]),
        ("energy", "J up to each row", energy),
        ("square", "a^2 [m^2]", numbers[1]),
        ("square_slope", "da^2/dd [m]", slopes[1]),
        ("share", "part of the recovery that has the shape of an elastic contact", numbers[2]),
        ("share_slope", "its change by d [1/m]", slopes[2]),
    )
    return tuple(LawTable(*content) for content in contents)


def _numbers(curve: FirstLoading, depth: Array) -> Array:
    """Return force, squared radius and share of the elastic shape at depths."""
    state, _ = curve.at_level(depth, by_force=False)
    return np.stack([state.force, state.radius**2, state.elastic_share])


def _errors(curve: FirstLoading, tables: tuple[LawTable, ...]) -> Array:
    """Return the error of force, radius and recovery in every interval, over the greatest of each."""
    depth = tables[0].numbers
    places = (depth[1:-1, None] + np.diff(depth[1:])[:, None] * CHECKED).ravel()
    true, _ = curve.at_level(places, by_force=False)
    last, _ = curve.at_level(depth[-1:], by_force=False)
    step, given = plain(step_yielding), [np.array(table.numbers) for table in tables]
    law = np.array([1.0, float(curve.bed.medium.modulus), float(depth[1])])  # type: ignore[attr-defined]
    found = np.empty((places.size, len(ANSWER)))
    for place, answer in zip(places, found, strict=True):
        step(*given, law, np.zeros(2), np.array([place]), answer)
    off = (
        (found[:, 0] - true.force, last.force),
        (found[:, 2] - true.radius, last.radius),
        (places - found[:, 3] - true.recovery, last.recovery),
    )
    worst = np.max([np.abs(one) / most[0] for one, most in off], axis=0)
    return np.asarray(np.max(worst.reshape(-1, len(CHECKED)), axis=1) / SAFETY_FACTOR)
