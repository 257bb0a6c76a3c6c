"""Fits of relaxing contacts: creep, relaxation, and curves that go in, hold and come out.

The placeholder path of the model says what drives: `Depth`, and the measured motion drives while forces are fitted;
`Force`, and the measured forces drive while positions are.  Statistics are those of `winkler.fitting.fit`.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from winkler.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.fitting.certainty import certainty, doubts, refuse_singular
from winkler.fitting.curves.checks import Flag, Outline, examined, outline
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.outline import FEWEST
from winkler.fitting.parameters import each
from winkler.fitting.search import Search
from winkler.fitting.viscoelastic.creep import Under
from winkler.fitting.viscoelastic.doubts import unidentified
from winkler.fitting.viscoelastic.outcome import CreepFit, ViscoelasticFit
from winkler.fitting.viscoelastic.question import driven_task
from winkler.fitting.viscoelastic.response import elastic_table
from winkler.fitting.viscoelastic.start import best_driven_start, improve
from winkler.fitting.viscoelastic.task import Driven, Pressed, Told
from winkler.loading import Depth, Force
from winkler.numerics.types import Array, Quantity
from winkler.path import Path
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.march import elastic_like

__all__ = ["viscoelastic_fit"]

MOST_PREDICTIONS = 200
QUIET = 20
"""Fewest free points from which the noise is read."""
SETTLED = 1e-9
WEIGHED = 2
"""How often the points are weighed anew, by the noise that the last fit tells."""
STEADY = 0.05
"""A force that changes by less of itself is held."""


def viscoelastic_fit(
    curve: ForceCurve,
    model: ViscoelasticIndentation,
    *,
    free: Mapping[str, Any] | Iterable[str],
    noise: Quantity = 0.0,
    search: Search,
) -> ViscoelasticFit | CreepFit:
    """Fit numbers of a relaxing contact to a curve; parameters as for `winkler.fitting.fit.fit`, and what counts.

    Raises
    ------
    InvalidInput
        If the curve has no times, goes in twice, or is refused (see `winkler.fitting.curves.checks`).
    OutsideValidity
        If the curve cannot tell the free numbers apart, or leads beyond the reach of the profile.
    NotConverged
        If least squares do not settle, or the time of the search is over.
    """
    strokes, flags = _looked_at(curve)
    given = dict.fromkeys(free, ()) if not isinstance(free, Mapping) else dict(free)
    spread = _spread(curve, noise, model)
    question = driven_task(curve, model, given, spread, strokes)
    many = len(question.parameters)
    if np.count_nonzero(question.weights) < 3 * many:
        raise InvalidInput(
            f"fit: {np.count_nonzero(question.weights)} points cannot tell {many} numbers; give more, or free fewer."
        )
    try:
        begin = best_driven_start(question, strokes, search)
        question, coordinates = _settled(question, begin, strokes, spread, search)
        coordinates = _in_order(question, coordinates)
    except NotConverged as error:
        raise NotConverged(" ".join([str(error), *map(str, flags)])) from None
    return _found(question, coordinates, float(np.mean(noise)), flags)


def _looked_at(curve: ForceCurve) -> tuple[Outline | None, tuple[Flag, ...]]:
    """Return what the way in looks like, if there is one, and what is wrong with it."""
    if not curve.timed:
        raise InvalidInput(f"fit: curve '{curve.name}' has no times, and a solid that relaxes needs them.")
    ways = curve.direction[np.concatenate([[True], np.diff(curve.direction) != 0.0])]
    out = np.flatnonzero(ways < 0.0)
    if out.size and (out[0] == 0 or np.any(ways[out[0] :] > 0.0)):
        how = "begins on the way out" if out[0] == 0 else "goes in again after it came out"
        raise InvalidInput(f"fit: curve '{curve.name}' {how}; fit one way in, with its hold and its way out.")
    inward = curve.direction > 0.0
    if np.count_nonzero(inward) < FEWEST:
        return None, ()
    force = curve.force[inward]
    if np.ptp(force) < STEADY * np.abs(force).max():  # a weight that stands and sinks in
        return None, ()
    way = curve.chosen(inward)
    flags = [flag for flag in examined(way) if flag.name != "saturated"]  # a held force is no end of a detector
    for flag in flags:
        if flag.name != "no_baseline":
            raise InvalidInput(f"curve '{curve.name}': {flag}")
    return outline(way), tuple(flags)


def _spread(curve: ForceCurve, noise: Quantity, model: ViscoelasticIndentation) -> Array:
    unit = "N" if isinstance(model.path.normal, Depth) else "m"
    given = np.asarray(noise, dtype=float)
    if given.ndim and given.shape != curve.position.shape:
        raise InvalidInput(
            f"fit: noise has the shape {given.shape}, the curve {curve.position.shape}; give one number."
        )
    if not np.all(np.isfinite(given)) or np.any(given < 0.0) or (given.ndim and np.any(given == 0.0)):
        raise InvalidInput(f"fit: noise must be positive, in {unit} (or zero for all, to be read from the curve).")
    return given if given.any() else np.zeros(())


def _in_order(question: Driven, coordinates: Array) -> Array:
    """Return coordinates whose terms are sorted by their times, where nothing but their order would change."""
    rows: dict[str, list[int]] = {}
    for index, parameter in enumerate(question.parameters):
        if parameter.name.endswith("]"):
            rows.setdefault(parameter.name.rpartition("[")[0], []).append(index)
    ordered = coordinates.copy()
    for name, places in rows.items():
        partner = name.replace("relaxation_times", "shears").replace("retardation_times", "compliances")
        if partner == name or len(rows.get(partner, ())) != len(places):
            continue
        alike = all(len({question.parameters[i][1:3] for i in row}) == 1 for row in (places, rows[partner]))
        if alike and len(places) == len(each(question.model, name)):
            turn = np.argsort(coordinates[places])
            for row in (places, rows[partner]):
                ordered[row] = coordinates[row][turn]
    return ordered


def _settled(
    question: Driven, begin: Array, strokes: Outline | None, noise: Array, search: Search
) -> tuple[Driven, Array]:
    """Return the coordinates of least squares, and the question with the weights that they belong to."""
    coordinates, _ = improve(question, begin, MOST_PREDICTIONS, search, SETTLED)
    if not isinstance(question, Under):
        _refuse_blind(question, coordinates)
        return question, coordinates
    for _ in range(WEIGHED if strokes is not None else 0):
        question = question.weighed(coordinates, strokes.noise if strokes is not None else 0.0, noise)
        coordinates, _ = improve(question, coordinates, MOST_PREDICTIONS, search, SETTLED)
    _refuse_blind(question, coordinates)
    return question, question.unbiased(coordinates)


def _refuse_blind(question: Driven, coordinates: Array) -> None:
    """Refuse numbers that the curve cannot tell."""
    measured = question.measured * question.weights
    try:
        refuse_singular(
            question.parameters, question.jacobian(coordinates), float(np.linalg.norm(measured - measured.mean()))
        )
    except OutsideValidity as error:
        hint = " One term less may do." if "shears[" in str(error) or "relaxation_times[" in str(error) else ""
        raise OutsideValidity(f"{error}{hint}") from None


def _found(question: Driven, coordinates: Array, noise: float, flags: tuple[Flag, ...]) -> ViscoelasticFit | CreepFit:
    """Return the answer at the coordinates of least squares."""
    numbers = question.numbers(coordinates)
    told = question.told(numbers)
    touched = told.contact.force > 0.0
    if not touched.any():
        raise OutsideValidity("fit: the best fit has no point in contact; the model does not describe this curve.")
    jacobian = question.jacobian(coordinates)
    residuals = (question.measured - told.predicted) * question.weights
    sure = certainty(residuals, jacobian)
    values = np.array(list(numbers.values()))
    change = np.array([p.change(n) for p, n in zip(question.parameters, values.tolist(), strict=True)])
    errors = sure.errors * np.abs(change)
    alone = ~question.by_force if isinstance(question, Under) else ~touched
    quiet = residuals[alone]
    if noise == 0.0:
        noise = float(np.std(quiet)) if quiet.size >= QUIET else sure.scatter
    noise = noise or sure.scatter or np.finfo(float).tiny
    own = unidentified(question, numbers, dict(zip(numbers, errors.tolist(), strict=True)))
    kind = ViscoelasticFit if isinstance(question, Pressed) else CreepFit
    result = kind(
        question.curve,
        _replayed(question, numbers, told),
        tuple(numbers),
        values,
        errors,
        sure.correlation,
        np.array([p.low for p in question.parameters]),
        np.array([p.high for p in question.parameters]),
        tuple(p.logarithmic for p in question.parameters),
        noise,
        question.weights,
        sure.scatter,
        sure.effective_count,
        told.predicted,
        told.contact.depth,
        _radii(question, numbers, told),
        (*flags, *own),
    )
    against = doubts(question.parameters, coordinates, result, sure)
    return dataclasses.replace(result, flags=(*result.flags, *against))


def _radii(question: Driven, numbers: dict[str, float], told: Told) -> Array:
    deepest = float(told.contact.edge.max())
    table = elastic_table(elastic_like(question.with_numbers(numbers).bed), deepest)
    return np.where(told.contact.force > 0.0, table.radius_at(told.contact.edge), 0.0)


def _replayed(question: Driven, numbers: dict[str, float], told: Told) -> ViscoelasticIndentation:
    """Return the model with its numbers, along the path of the curve."""
    model = question.with_numbers(numbers)
    if isinstance(question, Pressed):
        return dataclasses.replace(model, path=Path(question.curve.time, Depth(told.contact.depth)))
    return dataclasses.replace(model, path=Path(question.curve.time, Force(np.maximum(told.contact.force, 0.0))))
