"""The answer of a joint fit from its equations: numbers, errors, agreement of the curves, and each curve's fit."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from winkler.fitting.curves.checks import Flag
from winkler.fitting.estimate import FitEstimate
from winkler.fitting.generalised import Generalised
from winkler.fitting.outcome import AnyFit
from winkler.fitting.several.arrowhead import Reduced, reduced
from winkler.fitting.several.joining import Joined
from winkler.fitting.several.joint import JointFit
from winkler.fitting.several.same_task import SameTask
from winkler.fitting.varied import Parameter
from winkler.numerics.types import Array

__all__ = ["joint_fit"]

DISAGREEMENT = 0.01
"""Chance below which curves count as different."""
LEAST_DIRECTION = 1e-9
"""Least information of a curve on a combination of numbers, relative to the greatest, that is compared."""


class _Agreement(NamedTuple):
    """Chance of each curve; of all: squared disagreement, degrees of freedom, chance."""

    chances: list[float]
    squares: float
    freedom: float
    chance: float


def joint_fit(made: Joined, begun: Sequence[SameTask], names: tuple[str, ...], noises: Sequence[float]) -> JointFit:
    """Return the answer of a joint fit.

    Parameters
    ----------
    made : Joined
    begun : sequence of SameTask, (k,)
        From which it was found.
    names : tuple of str, (q,)
        Shared numbers.
    noises : sequence of float, (k,)
        Standard deviations of the fitted quantity [N]; zero: estimated.
    """
    tasks = [one.task for one in begun]
    parts = [reduced(block) for block in made.blocks]
    agreement = _agreement(made, parts)
    by_name = {p.name: p for p in tasks[0].parameters}
    shared = [by_name[name] for name in names]
    at = made.states[0].coordinates[made.blocks[0].shared]
    values = _outward(shared, at)
    change = np.abs([p.change(n) for p, n in zip(shared, values.tolist(), strict=True)])
    flags = [*_bounds(shared, at)]
    widening = 1.0
    if agreement.chance < DISAGREEMENT:
        widening = math.sqrt(agreement.squares / agreement.freedom)
        flags.append(_disagree(agreement, widening))
    fits, unexplained = [], []
    for index, (task, state, covariance) in enumerate(zip(tasks, made.states, made.covariances, strict=True)):
        noise = noises[index] or state.deviation(task) or state.scatter or float(np.finfo(float).tiny)
        if not state.misfit(task, noise).explained:
            unexplained.append(str(index + 1))
        fits.append(_fit_of(begun[index], state, covariance * widening**2, noise))
    if unexplained:
        which = ", ".join(unexplained)
        flags.append(Flag("misfit", f"The model with shared numbers does not explain the curves numbered {which}."))
    singles, errors = _singles(parts, at)
    whole = np.sum([np.diag(part.information) for part in parts], axis=0)
    count = sum(len(task.parameters) - len(names) for task in tasks) + len(names)
    deviations = np.sqrt(np.diag(made.shared))
    return JointFit(
        names=names,
        values=values,
        standard_errors=deviations * change * widening,
        correlation=made.shared / np.outer(deviations, deviations),
        logarithmic=tuple(p.logarithmic for p in shared),
        fits=tuple(fits),
        freedom=max(sum(state.noise.effective_count for state in made.states) - count, 1.0),
        shares=np.array([np.diag(part.information) / whole for part in parts]),
        single_values=np.array([_outward(shared, row) for row in singles]),
        single_errors=errors * change,
        chances=np.array(agreement.chances),
        flags=tuple(flags),
    )


def _outward(parameters: Sequence[Parameter], coordinates: Array) -> Array:
    return np.array([p.outward(float(c)) for p, c in zip(parameters, coordinates, strict=True)])


def _bounds(shared: Sequence[Parameter], at: Array) -> list[Flag]:
    flags = []
    for parameter, coordinate in zip(shared, at.tolist(), strict=True):
        ends = parameter.inward(parameter.low), parameter.inward(parameter.high)
        if any(abs(coordinate - end) <= 1e-6 * (1.0 + abs(coordinate)) for end in ends):
            flags.append(Flag("at_bound", f"{parameter.name} has reached its bound; its error has no meaning."))
    return flags


def _disagree(agreement: _Agreement, widening: float) -> Flag:
    limit = DISAGREEMENT / len(agreement.chances)
    odd = [str(index + 1) for index, chance in enumerate(agreement.chances) if chance < limit]
    which = f", those numbered {', '.join(odd)} most" if odd else ""
    return Flag(
        "disagree",
        f"The curves differ more in the shared numbers than their noise allows{which}; the errors are {widening:.3g} "
        "times those by noise. A mean over single fits states the scatter between curves.",
    )


def _agreement(made: Joined, parts: Sequence[Reduced]) -> _Agreement:
    """Return how well the curves agree in the shared numbers, by the squares of what each alone would change."""
    from scipy.special import chdtrc

    chances, squares, freedom = [], 0.0, -float(len(made.shared))
    for part in parts:
        own, rank = _pseudo_inverse(part.information)
        squares += float(part.gradient @ own @ part.gradient)
        freedom += rank
        apart, degrees = _pseudo_inverse(part.information - part.information @ made.shared @ part.information)
        chances.append(float(chdtrc(degrees, part.gradient @ apart @ part.gradient)) if degrees else 1.0)
    chance = float(chdtrc(freedom, squares)) if freedom > 0.0 else 1.0
    return _Agreement(chances, squares, max(freedom, 1.0), chance)


def _pseudo_inverse(matrix: Array) -> tuple[Array, int]:
    """Return the inverse within the determined directions of a symmetric matrix, and their number."""
    size = np.sqrt(np.maximum(np.diag(matrix), np.finfo(float).tiny))
    values, vectors = np.linalg.eigh(matrix / np.outer(size, size))
    kept = values > LEAST_DIRECTION
    inverse = (vectors[:, kept] / values[kept]) @ vectors[:, kept].T
    return inverse / np.outer(size, size), int(np.count_nonzero(kept))


def _singles(parts: Sequence[Reduced], at: Array) -> tuple[Array, Array]:
    """Return coordinates and errors of the shared numbers by each curve alone; nan where it does not say."""
    values, errors = [], []
    for part in parts:
        inverse, rank = _pseudo_inverse(part.information)
        if rank < at.size:
            values.append(np.full(at.size, np.nan))
            errors.append(np.full(at.size, np.nan))
            continue
        values.append(at + inverse @ part.gradient)
        errors.append(np.sqrt(np.diag(inverse)))
    return np.array(values), np.array(errors)


def _fit_of(begun: SameTask, state: Generalised, covariance: Array, noise: float) -> AnyFit:
    """Return the fit of one curve with the numbers of the joint fit."""
    task = begun.task
    numbers = task.numbers(state.coordinates)
    values = np.array(list(numbers.values()))
    deviations = np.sqrt(np.diag(covariance))
    errors = deviations * np.abs([p.change(n) for p, n in zip(task.parameters, values.tolist(), strict=True)])
    whole = float(np.sum(np.log(task.weights[task.weights > 0.0])))
    own = {
        "model": task.model_of(numbers, state.prediction),
        "names": tuple(numbers),
        "values": values,
        "standard_errors": errors,
        "correlation": covariance / np.outer(deviations, deviations),
        "lows": np.array([p.low for p in task.parameters]),
        "highs": np.array([p.high for p in task.parameters]),
        "noise": noise,
        "scatter": state.scatter,
        "effective_count": state.noise.effective_count,
        "slow_share": state.noise.slow_share,
        "log_likelihood": state.noise.likelihood + whole,
        "stretches": np.ones((values.size, 2)),
        "predicted": state.prediction.fitted,
        "logarithmic": tuple(p.logarithmic for p in task.parameters),
        "flags": (),
    }
    return task.outcome(numbers, state.prediction, _of_single(begun.found, tuple(numbers)) | own)


def _of_single(found: AnyFit, names: tuple[str, ...]) -> dict[str, Any]:
    """Return the common fields of a single fit, rows for each number in the order of `names`."""
    fields = {field.name: getattr(found, field.name) for field in dataclasses.fields(FitEstimate)}
    del fields["radius"]
    for name, content in fields.items():
        if isinstance(content, np.ndarray) and content.ndim == 2 and content.shape[0] == len(found.names):
            usual = np.median(content, axis=0)
            fields[name] = np.array([content[found.index(one)] if one in found.names else usual for one in names])
    return fields
