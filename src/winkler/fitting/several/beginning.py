"""Where a joint fit begins: each curve fitted alone, and the shared numbers at their weighted mean."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.elastic.task import elastic_task
from winkler.fitting.fit import fit
from winkler.fitting.outcome import AnyFit, CreepFit
from winkler.fitting.several.same_task import SameTask, same_task
from winkler.fitting.task import FitTask
from winkler.fitting.validity import Model
from winkler.fitting.viscoelastic.drive import driven_task, examined_stroke
from winkler.numerics.types import Array
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

__all__ = ["begun_alone", "errors_of", "same_start"]

LEAST_ERROR = 1e-12


def errors_of(found: AnyFit, names: Sequence[str]) -> Array:
    """Return the standard errors of shared numbers in the coordinates of their fit ``(q,)``."""
    places = [found.index(name) for name in names]
    scale = [found.values[i] if found.logarithmic[i] else 1.0 for i in places]
    return np.asarray(found.standard_errors[places] / np.abs(scale))


def begun_alone(
    curve: ForceCurve,
    model: Model | ViscoelasticIndentation,
    stated: dict[str, Any],
    names: Sequence[str],
    noise: float,
    time_limit: float,
) -> tuple[SameTask, Array]:
    """Return the task of a curve at its own fit, and the errors of the shared numbers; infinite if it has none."""
    try:
        found = fit(curve, model, free=stated, noise=noise, time_limit=time_limit)
    except (OutsideValidity, NotConverged):
        own = {name: bound for name, bound in stated.items() if name not in names}
        if not own:
            raise
        found = fit(curve, model, free=own, noise=noise, time_limit=time_limit)
    else:
        if isinstance(found, CreepFit):
            raise InvalidInput("fit_together: positions would be fitted; curves are fitted together by their forces.")
        return same_task(found), errors_of(found, names)
    task: FitTask
    if isinstance(model, ViscoelasticIndentation):
        task = driven_task(found.curve, model, stated, np.zeros(()), examined_stroke(found.curve)[0])
    else:
        task = elastic_task(found.curve, model, stated, np.zeros(()))
    task = task._replace(weights=found.weights)
    numbers = dict(zip(found.names, found.values.tolist(), strict=True))
    start = np.array([p.inward(numbers.get(p.name, p.start)) for p in task.parameters])
    return SameTask(task, start, found), np.full(len(names), math.inf)


def same_start(begun: Sequence[SameTask], errors: Array, names: Sequence[str]) -> list[SameTask]:
    """Return tasks whose shared numbers have one coordinate, and begin at their weighted mean.

    Parameters
    ----------
    begun : sequence of SameTask, (k,)
    errors : ndarray, (k, q)
        Of the shared numbers, in coordinates; infinite where a curve does not determine them.
    names : sequence of str, (q,)

    Raises
    ------
    InvalidInput
        If a model lacks a shared number.
    """
    first = {p.name: p for p in begun[0].task.parameters}
    for task, _, _ in begun:
        missing = [name for name in names if name not in {p.name for p in task.parameters}]
        if missing:
            raise InvalidInput(f"fit_together: a model has no '{missing[0]}'; shared numbers exist in all models.")
    starts = {}
    for place, name in enumerate(names):
        of = [
            first[name].inward({p.name: p.outward(float(c)) for p, c in zip(task.parameters, at, strict=True)}[name])
            for task, at, _ in begun
        ]
        weights = 1.0 / np.maximum(errors[:, place], LEAST_ERROR) ** 2
        starts[name] = float(np.average(of, weights=weights) if weights.any() else np.median(of))
    result = []
    for task, at, found in begun:
        parameters = tuple(first[p.name] if p.name in names else p for p in task.parameters)
        start = np.array([starts.get(p.name, c) for p, c in zip(parameters, at.tolist(), strict=True)])
        result.append(SameTask(task._replace(parameters=parameters), start, found))
    return result
