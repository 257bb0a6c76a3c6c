r"""Fit of a model to a measured force curve: parameters, their uncertainty, and doubts.

.. math:: F_i = F_\mathrm{model}(D_i - D_0) + F_0 + t\,(D_i-D_0) + e_i

with the contact point :math:`D_0`, the baseline :math:`F_0` and its tilt t.  The whole curve counts, in contact or not.
Least squares begin; generalised ones, under the noise that the residuals show (`winkler.fitting.noise`), give the
parameters and their covariance.

The algorithm is the same for all models.  A response model (`winkler.fitting.task.FitTask`) defines the prediction.
For a body that relaxes, the placeholder path of the model defines the input: with `Depth`, forces are fitted along the
measured motion; with `Force`, positions are fitted under the measured forces.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, overload

import numpy as np

from winkler.fitting.certainty import certainty, doubts, refuse_singular
from winkler.fitting.curvature import stretches_of
from winkler.fitting.curves.across_pop_ins import across_pop_ins
from winkler.fitting.curves.checks import CurveOutline, Flag, outline, refuse, without_baseline
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.outline import FEWEST
from winkler.fitting.elastic.slow_jumps import of_slow_jumps
from winkler.fitting.elastic.task import elastic_task
from winkler.fitting.generalised import Generalised, generalised, likeliest
from winkler.fitting.least_squares import solved
from winkler.fitting.not_white import not_white
from winkler.fitting.outcome import AnyFit, CreepFit, Fit, ViscoelasticFit
from winkler.fitting.search import FitState, Search
from winkler.fitting.start import best_start
from winkler.fitting.task import FitTask
from winkler.fitting.unseen_baseline import unseen_baseline
from winkler.fitting.validity import Model
from winkler.fitting.viscoelastic.acceleration import tip_acceleration
from winkler.fitting.viscoelastic.drive import driven_task, examined_stroke
from winkler.loading.loads import Depth
from winkler.numerics.equations.streaming import streamed
from winkler.numerics.types import Array, Quantity
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

__all__ = ["Fit", "fit", "fit_steps"]


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
        One approach, one retraction, or both; points of holds are left out, unless the model relaxes.
    model : Indentation, AdhesiveIndentation or ViscoelasticIndentation
        The problem; its load is only a placeholder, Depth(0.0).  Free parameters begin at the values of the model.  The
        path of a body that relaxes defines the input: Path([0.0], Depth(0.0)), and forces are fitted along the measured
        motion; Path([0.0], Force(0.0)), and positions under the measured forces.
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
        If the curve is refused (see `winkler.fitting.curves.checks`), or a path does not exist.
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
    jumps = of_slow_jumps(task.curve.count - found.curve.count)
    further = across_pop_ins(curve, found.curve, found.touched)
    return dataclasses.replace(found, flags=(*found.flags, *jumps, *further))


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
    return dataclasses.replace(result, flags=(*result.flags, *further))
