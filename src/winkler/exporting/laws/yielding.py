"""Round bodies on metals that yield, let go and pressed again, as a law for other programs."""

from __future__ import annotations

import numpy as np

from winkler.exporting.laws.normal import BEYOND
from winkler.exporting.step_law import LawTable, StatePart, StepLaw, StepNumber
from winkler.exporting.translation.plain import plain
from winkler.foundation.on_medium import UnderProfile
from winkler.loading.loads import Depth
from winkler.media.halfspace import HalfSpace
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array
from winkler.problems.particles.table_step import cubic_energy, follow_table
from winkler.problems.plastic.first_loading import FirstLoading, first_loading
from winkler.problems.plastic.indentation import PlasticIndentation
from winkler.problems.plastic.yielding_step import step_yielding
from winkler.values.errors import InvalidInput, NotConverged

MOTION = (StepNumber("depth", "m", "d at the end of the step, not positive without contact"),)
ANSWER = (
    StepNumber("force", "N", "normal force, compression positive"),
    StepNumber("stiffness", "N/m", "dF/dd"),
    StepNumber("radius", "m", "contact radius, zero without contact; of an ellipse that of the disc as stiff"),
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
NODES = 16
"""Of sums over springs: exact of cones and paraboloids."""
NEARER = 0.125
"""By what the first row moves to the apex where the contact below it is no power of the depth."""


def yielding_law(problem: PlasticIndentation, deepest: float, tolerance: float, inputs: tuple[str, ...]) -> StepLaw:
    """Return the law of a round body that yields, or on a body that yields.

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
        If the medium is layered, or the deepest point presses nothing.
    NotConverged
        If the table would need too many rows.
    """
    bed = problem.bed
    assert isinstance(bed, UnderProfile)
    if not isinstance(bed.medium, HalfSpace):
        raise InvalidInput(
            f"export: the medium is a {type(bed.medium).__name__}; layers are followed up to first yield only, so that "
            "they leave no dent: give a HalfSpace, or export the Indentation of these layers."
        )
    if not deepest > 0.0:
        raise InvalidInput(f"export: the deepest point presses {deepest:g} m deep; give one that presses the bodies.")
    curve = first_loading(bed)
    tables, error = _tables(curve, deepest, tolerance)
    notes = (
        f"First loading (cubics between rows) is off by at most {error:.2g} of the greatest force, radius and "
        "recovery, as measured at five places between all rows; unloading from there is elastic, on the dent.",
        BEYOND,
        *map(str, PlasticIndentation(bed, Depth(np.array([deepest]))).solve().validity),
    )
    state = (StatePart("memory", "greatest depth so far [m], what has been lost [J]", np.zeros(2)),)
    title = "Two round bodies of which at least one yields: loading, unloading and reloading"
    rng = np.random.default_rng(SEED)
    trial = deepest * (np.linspace(0.05, 1.0, STEPS) * rng.uniform(-0.1, 1.0, STEPS))[:, np.newaxis]
    return StepLaw(title, step_yielding, tables, state, MOTION, ANSWER, notes, inputs, trial)


def _tables(curve: FirstLoading, deepest: float, tolerance: float) -> tuple[tuple[LawTable, ...], float]:
    """Return all tables, and the greatest error of the rows of first loading."""
    onset = min(curve.at_onset(by_force=False), deepest)
    rows = np.array([0.0, deepest])
    if 0.0 < onset < deepest:
        rows = np.concatenate([rows[:1], np.geomspace(onset, deepest, FIRST_ROWS)])
        rows[-1] = deepest
    nodes, weights = gauss_legendre(NODES)
    modulus = float(curve.bed.medium.modulus)  # type: ignore[attr-defined]
    fixed = (
        *_profile(curve, deepest, tolerance),
        LawTable("nodes", "of sums over springs", nodes),
        LawTable("weights", "of these sums", weights),
        LawTable("law", "E* [Pa], depth of first yield [m]", np.array([modulus, onset])),
    )
    while rows.size <= MOST_ROWS:
        tables = (*_written(curve, rows), *fixed)
        errors = _errors(curve, tables)
        coarse = np.flatnonzero(errors > tolerance)
        if not coarse.size:
            return tables, float(np.max(errors))
        middles = np.where(coarse > 0, np.sqrt(rows[coarse] * rows[coarse + 1]), NEARER * rows[1])
        rows = np.insert(rows, coarse + 1, middles)
    raise NotConverged(f"export: {MOST_ROWS} rows do not give a table to {tolerance:g}; give a greater tolerance.")


def _profile(curve: FirstLoading, deepest: float, tolerance: float) -> tuple[LawTable, ...]:
    """Return rows of the profile up to the edge of the widest contact, and a little beyond."""
    bed, modulus = curve.bed, float(curve.bed.medium.modulus)  # type: ignore[attr-defined]
    state, _ = curve.at_level(np.array([deepest]), by_force=False)
    last = min(float(state.radius[0]) * (1.0 + 2.0 * tolerance), bed.reach)
    bends = np.unique([*(b for b, _ in bed.kinks if 0.0 < b < last), last])
    place = np.append(0.0, bends)
    while place.size <= MOST_ROWS:
        number, slope = bed.gap(place), bed.gap_slope(place)
        between = place[:-1, None] + np.diff(place)[:, None] * CHECKED
        rows = place, number, slope, np.append(0.0, np.cumsum(_sums(place, number, slope)))
        found = np.array([[plain(follow_table)(*rows, x)[::2] for x in line] for line in between])
        true = np.stack([bed.gap(between), 0.5 * bed.gap_load(between) / modulus], axis=-1)
        off = np.abs(found / true - 1.0)  # dents of all sizes have their own shape
        coarse = np.flatnonzero(np.max(off, axis=(1, 2)) > SAFETY_FACTOR * tolerance)
        if not coarse.size:
            names = ("place", "gap", "gap_slope", "gap_sum")
            meanings = ("x [m] of the rows", "g [m] of the profile", "dg/dx", "integral of g up to each row [m^2]")
            bent = LawTable("bends", "where g bends, and the last row [m]", bends)
            return (*(LawTable(*of) for of in zip(names, meanings, rows, strict=True)), bent)
        place = np.insert(place, coarse + 1, 0.5 * (place[coarse] + place[coarse + 1]))
    raise NotConverged(f"export: {MOST_ROWS} rows do not give the profile to {tolerance:g}; give a greater tolerance.")


def _sums(place: Array, number: Array, slope: Array) -> Array:
    """Return the integrals between rows, of the curves that `follow_table` draws."""
    width = np.diff(place)
    rows = zip(number[:-1], slope[:-1], np.diff(number) / width, slope[1:], width, strict=True)
    sums = np.array([plain(cubic_energy)(*row, 1.0) for row in rows])
    if slope[0] == 0.0:  # a power up to the first row
        sums[0] = number[1] * place[1] / (1.0 + slope[1] * place[1] / number[1])
    return sums


def _written(curve: FirstLoading, depth: Array) -> tuple[LawTable, ...]:
    numbers, slopes = _numbers(curve, depth), np.zeros((3, depth.size))
    elastic = depth <= curve.at_onset(by_force=False)
    elastic[0] = True
    radius = np.sqrt(numbers[1, elastic][1:])
    if elastic.sum() == 1:  # a sharp tip, which has yielded from the first touch on
        numbers[2, 0] = numbers[2, 1]
    slopes[0, : elastic.sum()][1:] = curve.bed.stiffness(radius)
    slopes[1, : elastic.sum()][1:] = 2.0 * radius / curve.bed.gap_slope(radius)
    if not elastic.all():
        beyond = depth[~elastic]
        less, more = (_numbers(curve, beyond * (1.0 + step)) for step in (-STEP, STEP))
        slopes[:, ~elastic] = (more - less) / (2.0 * STEP * beyond)
    least = curve.bed.gap_slope(np.zeros(1))[0]
    if least == 0.0 and depth.size > 1:
        slopes[1, 0] = numbers[1, 1] / depth[1]  # a paraboloid at the apex
    energy = np.append(0.0, np.cumsum(_sums(depth, numbers[0], slopes[0])))
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
    places = (depth[:-1, None] + np.diff(depth)[:, None] * CHECKED).ravel()
    true, _ = curve.at_level(places, by_force=False)
    last, _ = curve.at_level(depth[-1:], by_force=False)
    step, given = plain(step_yielding), [np.array(table.numbers) for table in tables]
    found = np.empty((places.size, len(ANSWER)))
    for place, answer in zip(places, found, strict=True):
        step(*given, np.zeros(2), np.array([place]), answer)
    off = (
        (found[:, 0] - true.force, last.force),
        (found[:, 2] - true.radius, last.radius),
        (places - found[:, 3] - true.recovery, last.recovery),
    )
    worst = np.max([np.abs(one) / most[0] for one, most in off], axis=0)
    return np.asarray(np.max(worst.reshape(-1, len(CHECKED)), axis=1) / SAFETY_FACTOR)
