"""Several curves fitted at once: some numbers are shared, such as a modulus, others are each curve's own.

Contact point and baseline differ from curve to curve; the modulus of one sample, or the thickness of one film, does
not.  Curves of different depths, speeds or tips determine together what one alone leaves open.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from winkler.fitting.curves.checks import Flag
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.elastic.task import elastic_task
from winkler.fitting.estimate import FitEstimate
from winkler.fitting.fit import fit
from winkler.fitting.generalised import Generalised
from winkler.fitting.outcome import AnyFit, CreepFit
from winkler.fitting.search import Search
from winkler.fitting.several.arrowhead import Reduced, reduced
from winkler.fitting.several.joining import Joined, joined
from winkler.fitting.several.joint import JointFit
from winkler.fitting.several.same_task import SameTask, same_task
from winkler.fitting.task import FitTask
from winkler.fitting.validity import Model
from winkler.fitting.varied import Parameter
from winkler.fitting.viscoelastic.drive import driven_task, examined_stroke
from winkler.numerics.types import Array
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity, suggest

FEWEST = 2


def fit_together(
    curves: Sequence[ForceCurve],
    models: Model | ViscoelasticIndentation | Sequence[Model | ViscoelasticIndentation],
    *,
    free: Mapping[str, Any] | Iterable[str],
    shared: Iterable[str],
    noise: float | Sequence[float] = 0.0,
    time_limit: float = math.inf,
) -> JointFit:
    """Fit several curves at once, with numbers that they share.

    Parameters
    ----------
    curves : sequence of ForceCurve, (k,)
        At least two.
    models : model, or sequence of models, (k,)
        One model for all curves, or one for each curve, for example for tips of different radii.
    free : mapping or iterable of str
        As for `fit`, for every curve.
    shared : iterable of str
        Free parameters that are the same for all curves; each curve has its own values of the others.
    noise : float or sequence of float, optional
        As for `fit`, one for all or one for each curve.
    time_limit : float, optional
        Time limit of the fit of one curve, and of the joint fit [s].

    Returns
    -------
    JointFit

    Raises
    ------
    InvalidInput
        If there are fewer than two curves, their numbers do not fit, or a shared number is not free.
    OutsideValidity
        If the curves together do not determine the numbers.
    NotConverged
        If least squares do not converge, or not within the time limit.

    Examples
    --------
    Two shallow curves with different balls on one gel.

    >>> import numpy as np
    >>> from winkler import Depth, Elastic, ForceCurve, Foundation, HalfSpace, Indentation, Paraboloid
    >>> curves, models, random = [], [], np.random.default_rng(1)
    >>> for radius, origin in ((2e-6, 3e-6), (10e-6, 1e-6)):
    ...     depth = np.linspace(-1e-6, 0.5e-6, 300)
    ...     force = 4.0 / 3.0 * 5e3 / 0.75 * np.sqrt(radius) * np.maximum(depth, 0.0) ** 1.5
    ...     curves.append(ForceCurve(depth + origin, force + 1e-11 * random.standard_normal(300)))
    ...     bed = Foundation(Paraboloid(radius), HalfSpace.between(Elastic(1e4, 0.5)))
    ...     models.append(Indentation(bed, Depth(0.0)))
    >>> young = "bed.medium.first.young"
    >>> found = fit_together(curves, models, free=[young, "contact_point"], shared=[young])
    >>> low, high = found.interval(young)
    >>> low < 5e3 < high, [round(fit.value("contact_point"), 8) for fit in found.fits]
    (True, [3e-06, 1e-06])
    """
    curves = tuple(curves)
    each = (models,) * len(curves) if isinstance(models, Model | ViscoelasticIndentation) else tuple(models)
    noises = tuple(noise) if isinstance(noise, Sequence) else (noise,) * len(curves)
    for word, many in (("models", each), ("noise", noises)):
        if len(many) != len(curves):
            raise InvalidInput(f"fit_together: there are {len(curves)} curves and {len(many)} {word}; give one each.")
    stated = dict(free) if isinstance(free, Mapping) else dict.fromkeys(free, ())
    names = _shared(shared, tuple(stated), len(curves))
    begun = [
        begun_alone(curve, model, stated, names, level, time_limit)
        for curve, model, level in zip(curves, each, noises, strict=True)
    ]
    return _joint([one[0] for one in begun], [one[1] for one in begun], names, noises, time_limit)


def joint_of(fits: Sequence[AnyFit], shared: Iterable[str], *, time_limit: float = math.inf) -> JointFit:
    """Return the joint fit of curves that were fitted one by one, with some of their numbers shared.

    Parameters
    ----------
    fits : sequence of Fit or ViscoelasticFit, (k,)
        At least two, with the same free numbers.
    shared : iterable of str
    time_limit : float, optional
        [s].

    Raises
    ------
    InvalidInput, OutsideValidity, NotConverged
        As for `fit_together`.
    """
    names = _shared(shared, fits[0].names if fits else (), len(fits))
    if any(set(one.names) != set(fits[0].names) for one in fits):
        raise InvalidInput("joint_of: the fits have different free numbers; free the same for all curves.")
    if any(isinstance(one, CreepFit) for one in fits):
        raise InvalidInput("joint_of: positions were fitted; curves are fitted together by their forces.")
    noises = tuple(one.noise for one in fits)
    return _joint([same_task(one) for one in fits], [errors_of(one, names) for one in fits], names, noises, time_limit)


def _shared(shared: Iterable[str], free: tuple[str, ...], count: int) -> tuple[str, ...]:
    names = tuple(dict.fromkeys([shared] if isinstance(shared, str) else shared))
    if count < FEWEST:
        raise InvalidInput(f"fit_together: {count} curve{'s' * (count != 1)} cannot share numbers; give at least 2.")
    if not names:
        raise InvalidInput("fit_together: nothing is shared; name at least one free number.")
    for name in names:
        if name not in free:
            raise InvalidInput(
                f"fit_together: '{name}' is shared, but not free{suggest(name, free)}; {', '.join(free)} are free."
            )
    return names


def _joint(
    begun: list[SameTask], errors: list[Array], names: tuple[str, ...], noises: Sequence[float], time_limit: float
) -> JointFit:
    started = same_start(begun, np.array(errors), names)
    return joint_fit(joined(started, names, Search(time_limit)), started, names, noises)


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
