"""Start of a fit: a rough contact point, moduli and works of adhesion that match the largest and the least force.

A force is proportional to all moduli at once, a pull-off nearly so to the work of adhesion, whatever the shape; so a
few scalings give the right magnitude from any start.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from winkler.fitting.curves.checks import CurveOutline
from winkler.fitting.elastic.contact import states_for
from winkler.fitting.elastic.model_tables import ModelTables
from winkler.fitting.elastic.yielding import rough_force
from winkler.fitting.parameters import unit_of
from winkler.fitting.start import contact_points
from winkler.fitting.task import FitTask
from winkler.fitting.varied import CURVE_PARAMETERS
from winkler.numerics.types import Array
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.problems.plastic.indentation import PlasticIndentation
from winkler.values.errors import OutsideValidity

__all__ = ["starts"]

MOST_ROUNDS = 6


def starts(task: FitTask, rough_outline: CurveOutline) -> Iterator[Array]:
    """Yield the coordinates from which a fit may begin, one for each trial contact point.

    Parameters
    ----------
    task : FitTask
        Of a contact with or without adhesion.
    rough_outline : CurveOutline
        Rough outline of the approach.
    """
    parameter = next((p for p in task.parameters if p.name == "contact_point"), None)
    origins = [0.0]
    if parameter is not None:
        origins = contact_points(task, parameter, rough_outline)[: task.tables.most_starts]
        origins = [parameter.start] if parameter.has_start else [parameter.inside(origin) for origin in origins]
    numbers = {p.name: p.start for p in task.parameters}
    for origin in dict.fromkeys(origins):
        numbers = _sized(task, rough_outline, origin, dict(numbers))
        yield np.array([p.inward(p.inside(numbers[p.name])) for p in task.parameters])


def _sized(task: FitTask, rough_outline: CurveOutline, origin: float, numbers: dict[str, float]) -> dict[str, float]:
    """Return numbers with moduli and works of the right magnitude for a contact point, changed from given ones."""
    stated = {p.name for p in task.parameters if p.has_start}
    if "contact_point" in numbers and "contact_point" not in stated:
        numbers["contact_point"] = origin
    if "baseline" in numbers and "baseline" not in stated:
        numbers["baseline"] = rough_outline.baseline
    elastic = not isinstance(task.model, PlasticIndentation)
    moduli = _named(task, stated, "Pa", ("strength",) if elastic else ("young",))
    works = _named(task, stated, "J/m^2", ())
    if moduli or works:
        _scale(task, rough_outline, numbers, moduli, works)
    return numbers


def _possible(task: FitTask, numbers: dict[str, float], works: list[str], depth: float) -> tuple[float, float]:
    """Return the force at a depth and the pull-off force, the works reduced until the theory is valid."""
    if isinstance(task.model, PlasticIndentation):
        return rough_force(lambda: task.with_numbers(numbers), depth), 0.0
    tables: ModelTables = task.tables
    known = tables.known(numbers, 0.0, depth)
    if known is not None:
        return float(known.closing(np.array([depth])).force[0]), 0.0
    for _ in range(MOST_ROUNDS if works else 0):
        try:
            return tables.rough(states_for(task.with_numbers(numbers)), depth)
        except OutsideValidity:
            numbers.update({name: 0.05 * numbers[name] for name in works})
    return tables.rough(states_for(task.with_numbers(numbers)), depth)


def _named(task: FitTask, stated: set[str], unit: str, without: tuple[str, ...]) -> list[str]:
    return [
        p.name
        for p in task.parameters
        if p.name not in stated
        and p.name not in CURVE_PARAMETERS
        and p.name.rpartition(".")[2] not in without
        and unit_of(task.model, p.name) == unit
    ]


def _scale(
    task: FitTask, rough_outline: CurveOutline, numbers: dict[str, float], moduli: list[str], works: list[str]
) -> None:
    """Multiply moduli and works until the largest force and the pull-off force match."""
    origin = numbers.get("contact_point", 0.0)
    travel = float(task.curve.position.max()) - origin
    top = max(rough_outline.top, 1e-3 * float(np.ptp(task.curve.force)))
    depth = travel - task.curve.compliance * top
    depth = depth if depth > 1e-3 * abs(travel) else 1e-3 * abs(travel) + 1e-9 * float(np.ptp(task.curve.position))
    for _ in range(MOST_ROUNDS):
        worst = 1.0
        force, loss = _possible(task, numbers, works, depth)
        if moduli:
            pull = -min(0.0, loss)
            share = float(np.clip((top + pull) / max(force + pull, 1e-6 * top), 1e-3, 1e3))
            worst = max(worst, share, 1.0 / share)
            inside = {p.name: p.inside for p in task.parameters}
            numbers.update({name: inside[name](numbers[name] * share) for name in moduli})
        if works and isinstance(task.model, AdhesiveIndentation):
            target = max(rough_outline.pull, 2.0 * rough_outline.noise, 1e-4 * top)
            pull = -loss
            share = float(np.clip(target / max(pull, 1e-6 * target), 1e-3, 1e3))
            worst = max(worst, share, 1.0 / share)
            numbers.update({name: numbers[name] * share for name in works})
        if worst < 1.2:
            return
