"""Where a fit begins: a rough contact point, moduli and works of adhesion that meet the largest and the least force.

A force is proportional to all moduli at once, a pull-off nearly so to the work of adhesion, whatever the shape; so a
few divisions lead from any value of the model to the right size.
"""

from __future__ import annotations

import numpy as np

from winkler.errors import OutsideValidity
from winkler.fitting.curves.checks import Outline
from winkler.fitting.elastic.contact import states_for
from winkler.fitting.elastic.response import Response, response
from winkler.fitting.parameters import unit_of
from winkler.fitting.start import contact_points
from winkler.fitting.task import Task
from winkler.fitting.validity import Model
from winkler.fitting.varied import OF_THE_CURVE
from winkler.numerics.types import Array
from winkler.problems.adhesion.indentation import AdhesiveIndentation

__all__ = ["starts"]

ROUNDS = 6


def starts(task: Task, strokes: Outline) -> list[Array]:
    """Return the coordinates from which a fit may begin, one for every contact point that is tried.

    Parameters
    ----------
    task : Task
        Of a contact with or without adhesion.
    strokes : Outline
        What the approach looks like.
    """
    parameter = next((p for p in task.parameters if p.name == "contact_point"), None)
    origins = [0.0]
    if parameter is not None:
        origins = contact_points(task, parameter, strokes)
        origins = [parameter.start] if parameter.given else [parameter.inside(origin) for origin in origins]
    return [_sized(task, strokes, origin) for origin in dict.fromkeys(origins)]


def _sized(task: Task, strokes: Outline, origin: float) -> Array:
    """Return coordinates with moduli and works of the right size for a contact point."""
    numbers: dict[str, float] = {p.name: p.start for p in task.parameters}
    given = {p.name for p in task.parameters if p.given}
    if "contact_point" in numbers and "contact_point" not in given:
        numbers["contact_point"] = origin
    if "baseline" in numbers and "baseline" not in given:
        numbers["baseline"] = strokes.baseline
    moduli = _named(task, given, "Pa", ("strength",))
    works = _named(task, given, "J/m^2", ())
    if moduli or works:
        _scale(task, strokes, numbers, moduli, works)
    return np.array([p.inward(p.inside(numbers[p.name])) for p in task.parameters])


def _possible(task: Task, numbers: dict[str, float], works: list[str], depth: float) -> tuple[Model, Response]:
    """Return the model and its response, the works taken back until the theory allows them."""
    for _ in range(ROUNDS if works else 0):
        model = task.with_numbers(numbers)
        try:
            return model, response(states_for(model), 0.0, depth)
        except OutsideValidity:
            numbers.update({name: 0.05 * numbers[name] for name in works})
    model = task.with_numbers(numbers)
    return model, response(states_for(model), 0.0, depth)


def _named(task: Task, given: set[str], unit: str, without: tuple[str, ...]) -> list[str]:
    return [
        p.name
        for p in task.parameters
        if p.name not in given
        and p.name not in OF_THE_CURVE
        and p.name.rpartition(".")[2] not in without
        and unit_of(task.model, p.name) == unit
    ]


def _scale(task: Task, strokes: Outline, numbers: dict[str, float], moduli: list[str], works: list[str]) -> None:
    """Multiply moduli and works until the largest force and the pull-off have the right size."""
    origin = numbers.get("contact_point", 0.0)
    travel = float(task.curve.position.max()) - origin
    top = max(strokes.top, 1e-3 * float(np.ptp(task.curve.force)))
    depth = travel - task.curve.compliance * top
    depth = depth if depth > 1e-3 * abs(travel) else 1e-3 * abs(travel) + 1e-9 * float(np.ptp(task.curve.position))
    for _ in range(ROUNDS):
        worst = 1.0
        model, responds = _possible(task, numbers, works, depth)
        if moduli:
            force = float(responds.opening(np.array([depth]), np.inf).force[0])
            pull = -min(0.0, responds.loss()[1])
            share = float(np.clip((top + pull) / max(force + pull, 1e-6 * top), 1e-3, 1e3))
            worst = max(worst, share, 1.0 / share)
            numbers.update({name: numbers[name] * share for name in moduli})
        if works and isinstance(model, AdhesiveIndentation):
            wanted = max(strokes.pull, 2.0 * strokes.noise, 1e-4 * top)
            pull = -responds.loss()[1]
            share = float(np.clip(wanted / max(pull, 1e-6 * wanted), 1e-3, 1e3))
            worst = max(worst, share, 1.0 / share)
            numbers.update({name: numbers[name] * share for name in works})
        if worst < 1.2:
            return
