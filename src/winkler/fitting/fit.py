r"""Fit of a model to a measured force curve: parameters, their uncertainty, and doubts.

.. math:: F_i = F_\mathrm{model}(D_i - D_0) + F_0 + t\,(D_i-D_0) + e_i

with the contact point :math:`D_0`, the baseline :math:`F_0` and its tilt t.  The whole curve counts, in contact or not.
Least squares begin; generalised ones, under the noise that the residuals show (`winkler.fitting.noise`), give the
parameters and their covariance.

The algorithm is the same for all models.  A response model (`winkler.fitting.task.FitTask`) defines the prediction.
For a body that relaxes, the placeholder path of the model defines the input: with `Depth`, forces are fitted along the
measured motion; with `Force`, positions are fitted under the measured forces.

Uncertainty of the parameters of a fit, and doubts that follow from its algebra.

The covariance is that of generalised least squares under white and slow noise (`winkler.fitting.noise`).

A curve wholly in contact whose free tilt takes the beginning of the contact for a baseline.

Under noise the foot of a contact is a straight line, so that a fit with a free tilt places the contact point inside the
curve, with a modulus that is too low.  Then a contact that begins at the first point or before it, with its own scale,
baseline and tilt, describes the curve as well; a curve that shows its baseline excludes it.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, NamedTuple, overload

import numpy as np

from winkler.fitting.curvature import stretches_of
from winkler.fitting.curves.across_pop_ins import across_pop_ins
from winkler.fitting.curves.checks import CurveOutline, Flag, outline, refuse, without_baseline
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.outline import FEWEST
from winkler.fitting.elastic.slow_jumps import of_slow_jumps
from winkler.fitting.elastic.task import elastic_task
from winkler.fitting.estimate import FitEstimate
from winkler.fitting.generalised import Generalised, generalised, likeliest
from winkler.fitting.least_squares import solved
from winkler.fitting.misfit import Misfit
from winkler.fitting.noise.estimate import noise_of, orthonormal
from winkler.fitting.outcome import AnyFit, CreepFit, Fit, ViscoelasticFit
from winkler.fitting.search import FitState, Search
from winkler.fitting.start import best_start
from winkler.fitting.task import FitTask, Prediction
from winkler.fitting.validity import Model
from winkler.fitting.varied import Parameter
from winkler.fitting.viscoelastic.acceleration import tip_acceleration
from winkler.fitting.viscoelastic.drive import driven_task, examined_stroke
from winkler.loading.loads import Depth
from winkler.numerics.equations.streaming import streamed
from winkler.numerics.types import Array, Quantity
from winkler.problems.normal.indentation import Indentation
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.readable import with_unit

__all__ = ["Fit", "doubts", "fit", "fit_steps", "not_white"]


@overload
def fit(
    curve: ForceCurve,
    model: Model,
    *,
    free: Mapping[str, Any] | Iterable[str],
    noise: Quantity = 0.0,
    time_limit: float = math.inf,
) -> Fit: ...


@overload
def fit(
    curve: ForceCurve,
    model: ViscoelasticIndentation,
    *,
    free: Mapping[str, Any] | Iterable[str],
    noise: Quantity = 0.0,
    time_limit: float = math.inf,
) -> ViscoelasticFit | CreepFit: ...


def fit(
    curve: ForceCurve,
    model: Model | ViscoelasticIndentation,
    *,
    free: Mapping[str, Any] | Iterable[str],
    noise: Quantity = 0.0,
    time_limit: float = math.inf,
) -> AnyFit:
    """Fit parameters of a model to a curve.

    Parameters
    ----------
    curve : ForceCurve
        One approach, one retraction, or both. Hold periods are omitted unless the model is viscoelastic.
    model : Indentation, AdhesiveIndentation or ViscoelasticIndentation
        The problem; its load is only a placeholder, Depth(0.0).  Free parameters begin at the values of the model.  For
        a viscoelastic body the path defines the input. With Path([0.0], Depth(0.0)) forces are fitted along the
        measured motion, with Path([0.0], Force(0.0)) positions under the measured forces.
    free : mapping or iterable of str
        Paths into the model ("bed.medium.first.young", "law.work") and parameters of the curve ("contact_point",
        "baseline", "tilt", with times also "drift" of the position [m/s], "drag" [N s/m] of a liquid on the
        cantilever and "inertia" [kg] of the probe); a mapping gives (low, high), a start value, or () for neither.
    noise : float or ndarray, optional
        Standard deviation of the fitted quantity, forces [N] or positions [m], one for all or ``(n,)``; zero (unless
        given): estimated from the free points.
    time_limit : float, optional
        Time limit [s], checked after each prediction of the curve.

    Returns
    -------
    Fit, ViscoelasticFit or CreepFit
        A CreepFit where positions were fitted.

    Raises
    ------
    InvalidInput
        If the curve does not pass the checks of `winkler.fitting.curves.checks`, or a path does not exist.
    OutsideValidity
        If the curve does not determine the free parameters, or leads beyond the reach of the profile.
    NotConverged
        If least squares do not converge, or not within the time limit.

    Examples
    --------
    >>> import numpy as np
    >>> from winkler import Depth, Elastic, Foundation, HalfSpace, Indentation, Paraboloid
    >>> bed = Foundation(Paraboloid(5e-6), HalfSpace.between(Elastic(1e4, 0.5)))
    >>> position = np.linspace(-1e-6, 1e-6, 200)
    >>> force = Indentation(bed, Depth(position)).solve().force
    >>> gel = ForceCurve(position + 3e-6, force + 1e-13 * np.sin(1e3 * np.arange(200)))
    >>> model = Indentation(Foundation(Paraboloid(5e-6), HalfSpace.between(Elastic(1e6, 0.5))), Depth(0.0))
    >>> result = fit(gel, model, free=["bed.medium.first.young", "contact_point"])
    >>> round(result.value("bed.medium.first.young"), -1), round(result.value("contact_point"), 9)
    (10000.0, 3e-06)
    """
    return _fit(curve, model, free, noise, Search(time_limit))


def fit_steps(
    curve: ForceCurve,
    model: Model | ViscoelasticIndentation,
    *,
    free: Mapping[str, Any] | Iterable[str],
    noise: Quantity = 0.0,
    time_limit: float = math.inf,
) -> Iterator[FitState | AnyFit]:
    """Yield the state of a fit after each of its evaluations, and last its result.

    Parameters, errors and results are those of `fit`.  Closing the iterator ends the fit.

    Yields
    ------
    FitState, and last a Fit, ViscoelasticFit or CreepFit

    Examples
    --------
    >>> import numpy as np
    >>> from winkler import Depth, Elastic, Foundation, HalfSpace, Indentation, Paraboloid
    >>> model = Indentation(Foundation(Paraboloid(5e-6), HalfSpace.between(Elastic(1e6, 0.5))), Depth(0.0))
    >>> position = np.linspace(-1e-6, 1e-6, 50)
    >>> gel = ForceCurve(position, 0.04 * np.maximum(position, 0.0) ** 1.5)
    >>> *states, result = fit_steps(gel, model, free=["bed.medium.first.young"])
    >>> states[-1].values == result.values
    array([ True])
    """

    def run(on_state: Callable[[FitState], None]) -> AnyFit:
        return _fit(curve, model, free, noise, Search(time_limit, on_state))

    yield from streamed(run)


def _fit(
    curve: ForceCurve,
    model: Model | ViscoelasticIndentation,
    free: Mapping[str, Any] | Iterable[str],
    noise: Quantity,
    search: Search,
) -> AnyFit:
    stated = dict.fromkeys(free, ()) if not isinstance(free, Mapping) else dict(free)
    if not stated:
        raise InvalidInput("fit: nothing is free; name at least one number, as 'bed.medium.first.young'.")
    task: FitTask
    if isinstance(model, ViscoelasticIndentation):
        rough_outline, flags = examined_stroke(curve)
        deviation = _deviation(curve, noise, "N" if isinstance(model.path.normal, Depth) else "m")
        task = driven_task(curve, model, stated, deviation, rough_outline)
    else:
        if (in_motion := np.count_nonzero(curve.direction)) < FEWEST <= curve.count:
            raise InvalidInput(
                f"curve '{curve.name}': {in_motion} of {curve.count} points lie on a loading or "
                f"an unloading, and a fit needs {FEWEST}: the position hardly changes, or the segments are wrong."
            )
        moving = curve.chosen(curve.direction != 0.0) if np.any(curve.direction == 0.0) else curve
        flags, rough_outline = refuse(moving), outline(moving)
        deviation = _deviation(curve, noise, "N")
        deviation = deviation[curve.direction != 0.0] if deviation.ndim else deviation
        acceleration = None
        if "inertia" in stated:  # of the whole path: without its holds it is not even in time
            acceleration = tip_acceleration(curve)[curve.direction != 0.0]
        task = elastic_task(moving, model, stated, deviation, acceleration)
    count, free_count = np.count_nonzero(task.weights), len(task.parameters)
    if count < 3 * free_count:
        raise InvalidInput(
            f"fit: {count} points do not determine {free_count} parameters; give more points, or free fewer."
        )
    try:
        found = _best(task, rough_outline, deviation, float(np.mean(noise)), flags, search)
    except NotConverged as error:
        raise NotConverged(" ".join([str(error), *map(str, flags)])) from None
    if not isinstance(found, Fit):
        return found
    further = [*across_pop_ins(curve, found.curve, found.touched)]
    further = [*of_slow_jumps(task.curve.count - found.curve.count), *further]
    return dataclasses.replace(found, flags=(*found.flags, *further)) if further else found


def _deviation(curve: ForceCurve, noise: Quantity, unit: str) -> Array:
    """Return the standard deviation of the fitted quantity, ``()`` or ``(n,)``; zero if unknown."""
    stated = np.asarray(noise, dtype=float)
    if stated.ndim and stated.shape != curve.position.shape:
        raise InvalidInput(
            f"fit: noise has the shape {stated.shape}, the curve {curve.position.shape}; give one number."
        )
    if not np.all(np.isfinite(stated)) or np.any(stated < 0.0) or (stated.ndim and np.any(stated == 0.0)):
        raise InvalidInput(f"fit: noise must be positive, in {unit} (or zero for all, to be estimated from the curve).")
    return stated if stated.any() else np.zeros(())


def _best(
    task: FitTask,
    rough_outline: CurveOutline | None,
    deviation: Array,
    noise: float,
    flags: tuple[Flag, ...],
    search: Search,
) -> AnyFit:
    """Return the fit with the least squares."""
    coordinates, _ = solved(task, best_start(task, rough_outline, search), search)
    for _ in range(task.most_reweightings):
        reweighed = task.reweighed(coordinates, rough_outline, deviation)
        if reweighed is None:
            break
        task = reweighed
        coordinates, _ = solved(task, coordinates, search)
    if not task.predicted(coordinates).touched.any():
        raise OutsideValidity("fit: the best fit has no point in contact; the model does not describe this curve.")
    refuse_singular(task.parameters, task.slopes(coordinates), task.size)
    best = generalised(task, task.final(coordinates), noise, search)
    return _with_errors(task, likeliest(task, best, noise, search), noise, flags)


def _with_errors(task: FitTask, best: Generalised, noise: float, flags: tuple[Flag, ...]) -> AnyFit:
    """Return the fit at its final coordinates, with errors and doubts."""
    coordinates, prediction = best.coordinates, best.prediction
    numbers = task.numbers(coordinates)
    noise = noise or best.deviation(task) or best.scatter or np.finfo(float).tiny
    uncertainty = certainty(best.covariance, best.noise.effective_count, best.misfit(task, noise))
    values = np.array(list(numbers.values()))
    errors = uncertainty.errors * np.abs([p.change(n) for p, n in zip(task.parameters, values.tolist(), strict=True)])
    shared = {
        "curve": task.curve,
        "model": task.model_of(numbers, prediction),
        "names": tuple(numbers),
        "values": values,
        "standard_errors": errors,
        "correlation": uncertainty.correlation,
        "lows": np.array([p.low for p in task.parameters]),
        "highs": np.array([p.high for p in task.parameters]),
        "noise": noise,
        "weights": task.stated_weights,
        "scatter": best.scatter_of(task),
        "effective_count": best.noise.effective_count,
        "slow_share": best.noise.slow_share,
        "log_likelihood": best.noise.likelihood + float(np.sum(np.log(task.weights[task.weights > 0.0]))),
        "reaches": best.noise.mixture.reaches,
        "stretches": stretches_of(task, coordinates, best.covariance, best.noise),
        "predicted": prediction.fitted,
        "logarithmic": tuple(p.logarithmic for p in task.parameters),
        "flags": (*flags, *task.doubts(numbers, errors)),
    }
    result = task.outcome(numbers, prediction, shared)
    further = [*doubts(task.parameters, coordinates, result, uncertainty), *not_white(task, best)]
    if not any(flag.name == "no_baseline" for flag in result.flags):
        both = ("approach", "retract") if isinstance(result, Fit) else ("approach",)
        unseen = [*without_baseline(result.curve, result.touched, both)]
        further += unseen or unseen_baseline(task, coordinates, prediction, best.noise.effective_count)
    return dataclasses.replace(result, flags=(*result.flags, *further)) if further else result


LEAST_ODDS = 20.0
"""Of slow noise or disturbances to white noise, for which white noise is doubted."""


def not_white(task: FitTask, best: Generalised) -> Iterator[Flag]:
    """Yield a doubt if residuals are slow where the noise was stated to be white.

    Parameters
    ----------
    task : FitTask
    best : Generalised
        The fit at its coordinates.
    """
    if not task.curve.has_white_noise:
        return
    jacobian = task.instrument(best.coordinates, best.prediction)
    allowed = noise_of(best.residuals, jacobian, task.courses(jacobian))
    if allowed.likelihood - best.noise.likelihood > math.log(LEAST_ODDS):
        yield Flag(
            "not_white",
            f"The noise was stated to be white, but {allowed.slow_share:.0%} of its variance in the residuals is slow "
            "or follows a drift, tilt or drag: intervals are too narrow. Leave noise_spectrum out.",
        )


SINGULAR_RATIO = 1e-7
CORRELATION_LIMIT = 0.99
POINTS_PER_PARAMETER = 5
"""Fewest independent points for each parameter."""


class Certainty(NamedTuple):
    """Uncertainty of parameters under the noise of their fit.

    Parameters
    ----------
    errors : ndarray, (p,)
        Standard errors of the coordinates.
    correlation : ndarray, (p, p)
        Of these errors.
    effective_count : float
        Number of independent points.
    misfit : Misfit
    """

    errors: Array
    correlation: Array
    effective_count: float
    misfit: Misfit


def certainty(covariance: Array, effective_count: float, misfit: Misfit) -> Certainty:
    """Return the uncertainty of the parameters of a fit from the covariance of its coordinates."""
    variances = np.diag(covariance)
    correlation = np.clip(covariance / np.sqrt(np.outer(variances, variances)), -1.0, 1.0)
    return Certainty(np.sqrt(variances), correlation, effective_count, misfit)


def refuse_singular(parameters: tuple[Parameter, ...], jacobian: Array, largest: float) -> None:
    """Raise OutsideValidity for parameters that the curve does not determine.

    Parameters
    ----------
    parameters : tuple of Parameter, (p,)
    jacobian : ndarray, (n, p)
    largest : float
        Norm of the measured quantity.

    Raises
    ------
    OutsideValidity
        If a parameter has no effect, or only a combination of several has.
    """
    size = np.linalg.norm(jacobian, axis=0)
    names = [p.name for p in parameters]
    insensitive = [name for name, norm in zip(names, size, strict=True) if norm <= SINGULAR_RATIO * largest * 1e-3]
    if insensitive:
        raise OutsideValidity(
            f"fit: the curve does not depend on {', '.join(insensitive)}; leave it fixed.{_fewer_terms(insensitive)}"
        )
    _, values, rows = np.linalg.svd(orthonormal(jacobian / size)[1])
    if values[-1] <= SINGULAR_RATIO * values[0]:
        combined = [name for name, part in zip(names, rows[-1], strict=True) if abs(part) > 0.1]
        raise OutsideValidity(
            f"fit: not identifiable: the curve does not distinguish {' from '.join(combined)}, "
            f"only a combination of them; fix all but one.{_fewer_terms(combined)}"
        )


def _fewer_terms(names: list[str]) -> str:
    is_series = any("shears[" in name or "relaxation_times[" in name for name in names)
    return " One term fewer may suffice." if is_series else ""


def doubts(
    parameters: tuple[Parameter, ...], coordinates: Array, estimate: FitEstimate, uncertainty: Certainty
) -> Iterator[Flag]:
    """Yield the doubts about the parameters of a fit.

    Parameters
    ----------
    parameters : tuple of Parameter, (p,)
    coordinates : ndarray, (p,)
    estimate : FitEstimate
        The fit, flags of its own not yet among them.
    uncertainty : Certainty
    """
    numbers = zip(parameters, coordinates.tolist(), estimate.values, estimate.standard_errors, strict=True)
    for parameter, coordinate, number, error in numbers:
        bounds = parameter.inward(parameter.low), parameter.inward(parameter.high)
        if any(abs(coordinate - bound) <= 1e-6 * (1.0 + abs(coordinate)) for bound in bounds):
            yield Flag("at_bound", f"{parameter.name} has reached its bound; its error has no meaning.")
        elif parameter.logarithmic and error > number:
            yield Flag("undetermined", f"{parameter.name} is smaller than its error and remains undetermined.")
    for i, first in enumerate(parameters):
        for j, second in enumerate(parameters[:i]):
            correlation = uncertainty.correlation[i, j]
            if abs(correlation) > CORRELATION_LIMIT:
                text = f"{second.name} and {first.name} go together (correlation {correlation:.4f})."
                yield Flag("correlated", text)
    if uncertainty.effective_count < POINTS_PER_PARAMETER * len(parameters):
        yield Flag(
            "memory",
            f"The curve has the information of {uncertainty.effective_count:.3g} independent points: the noise "
            "is slow, or the model misses the course of the curve.",
        )
    if not uncertainty.misfit.on_the_whole:
        yield Flag(
            "misfit",
            f"The residuals are {math.sqrt(estimate.chi_square):.3g} times the noise, in contact "
            f"{math.sqrt(estimate.chi_square_in_contact):.3g} times: the model does not explain the curve.",
        )
    elif not uncertainty.misfit.explained:
        place = float(estimate.curve.position[uncertainty.misfit.place])
        yield Flag(
            "misfit",
            f"Near the position {with_unit(place, 'm', 4)} the residuals are {uncertainty.misfit.local:.3g} times the "
            "noise: the model does not explain this part of the curve.",
        )


BEGINNINGS = (0.0, 0.05, 0.15, 0.4, 1.0)
"""Contact points before the first position, in parts of the travel."""
EXCLUDED = 14.0
"""Weighted squares by which a contact from the first point on has to be worse, as of models that are compared."""


def unseen_baseline(
    task: FitTask, coordinates: Array, prediction: Prediction, effective_count: float
) -> Iterator[Flag]:
    """Yield `no_baseline` for a fit with a free tilt that a contact from the first point on describes as well.

    Parameters
    ----------
    task : FitTask
        Of a contact without adhesion and relaxation; others have no such flag.
    coordinates : ndarray, (p,)
        Of the fit.
    prediction : Prediction
        There.
    effective_count : float
        Number of independent points.
    """
    names = [parameter.name for parameter in task.parameters]
    if not isinstance(task.model, Indentation) or not {"tilt", "contact_point"} <= set(names):
        return
    if extra_squares(task, coordinates, prediction, effective_count) < EXCLUDED:
        yield Flag(
            "no_baseline",
            "With a free tilt, a contact from the first point on describes the curve as well: no baseline is seen, and "
            "contact point, tilt and modulus may be far off; fix the tilt, or begin farther out.",
        )


def extra_squares(task: FitTask, coordinates: Array, prediction: Prediction, effective_count: float) -> float:
    """Return by how many weighted squares of independent points the best contact from the first point on is worse.

    Scale of the force, baseline and tilt are found anew for each contact point, by linear least squares.
    """
    weights, position = task.weights, task.curve.position
    squares = float(np.sum(((task.measured - prediction.fitted) * weights) ** 2))
    count = max(int(np.count_nonzero(weights)) - len(task.parameters), 1)
    first, travel = float(position.min()), float(np.ptp(position))
    place = next(n for n, parameter in enumerate(task.parameters) if parameter.name == "contact_point")
    others = []
    for share in BEGINNINGS:
        moved = coordinates.copy()
        moved[place] = task.parameters[place].inward(first - share * travel)
        numbers = task.numbers(moved)
        contact = task.prediction(moved).fitted - task.line(numbers)
        columns = np.stack([np.ones(position.size), (position - first) / travel, contact], axis=1) * weights[:, None]
        size = np.linalg.norm(columns, axis=0)
        if not size[-1] > 0.0:
            continue
        columns /= size
        found = np.linalg.lstsq(columns, task.measured * weights, rcond=None)[0]
        if found[-1] > 0.0:
            others.append(float(np.sum((task.measured * weights - columns @ found) ** 2)))
    if not others or squares == 0.0:
        return np.inf
    return (min(others) / squares - 1.0) * min(count, effective_count)
