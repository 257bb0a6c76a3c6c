r"""A model fitted to a measured force curve: numbers, how sure they are, and what speaks against them.

.. math:: F_i = F_\mathrm{model}(D_i - D_0) + F_0 + t\,(D_i-D_0) + e_i

with the contact point :math:`D_0`, the baseline :math:`F_0` and its tilt t.  The whole curve counts, in contact or not.
Least squares give the numbers; the noise's own memory (`winkler.fitting.curves.noise`) gives their covariance.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, overload

import numpy as np

from winkler.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.fitting.certainty import certainty, doubts, refuse_singular
from winkler.fitting.curves.checks import Flag, refuse
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.outcome import Fit
from winkler.fitting.prediction import Model, states_for
from winkler.fitting.search import FitState, Search
from winkler.fitting.start import best_start, solved
from winkler.fitting.task import Prediction, Task, task
from winkler.fitting.viscoelastic.fit import viscoelastic_fit
from winkler.fitting.viscoelastic.outcome import CreepFit, ViscoelasticFit
from winkler.loading import Depth
from winkler.numerics.equations.streaming import streamed
from winkler.numerics.types import Array, Quantity
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation

__all__ = ["Fit", "fit", "fit_steps"]

MOST_PREDICTIONS = 200
QUIET = 20
"""Fewest free points from which the noise is read."""


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
) -> Fit | ViscoelasticFit | CreepFit:
    """Fit numbers of a model to a curve.

    Parameters
    ----------
    curve : ForceCurve
        One way in, one way out, or both; points that are held are left out, unless the model relaxes.
    model : Indentation, AdhesiveIndentation or ViscoelasticIndentation
        The problem; its load is only a placeholder, Depth(0.0).  Numbers that are free begin at the model's own.  The
        path of a body that relaxes says what drives: Path([0.0], Depth(0.0)), and forces are fitted along the measured
        motion; Path([0.0], Force(0.0)), and positions under the measured forces.
    free : mapping or iterable of str
        Paths into the model ("bed.medium.first.young", "law.work") and what the curve leaves open ("contact_point",
        "baseline", "tilt", with times also "drift" of the position [m/s] and "drag" [N s/m] of a liquid on the
        cantilever); a mapping gives (low, high), a start value, or () for neither.
    noise : float or ndarray, optional
        Standard deviation of what is fitted, forces [N] or positions [m], one for all or ``(n,)``; zero (unless given):
        read from the free points.
    time_limit : float, optional
        The longest that it may take [s]; looked at after every prediction of the curve.

    Returns
    -------
    Fit, ViscoelasticFit or CreepFit
        A CreepFit where positions were fitted.

    Raises
    ------
    InvalidInput
        If the curve is refused (see `winkler.fitting.curves.checks`), or a path leads nowhere.
    OutsideValidity
        If the curve cannot tell the free numbers apart, or leads beyond the reach of the profile.
    NotConverged
        If least squares do not settle, or not within the time limit.

    Examples
    --------
    >>> import numpy as np
    >>> from winkler import Depth, Elastic, Foundation, HalfSpace, Indentation, Paraboloid
    >>> bed = Foundation(Paraboloid(5e-6), HalfSpace.between(Elastic(1e4, 0.5)))
    >>> position = np.linspace(-1e-6, 1e-6, 200)
    >>> force = Indentation(bed, Depth(position)).solve().force
    >>> gel = ForceCurve(position + 3e-6, force + 1e-13 * np.sin(1e3 * np.arange(200)))
    >>> model = Indentation(Foundation(Paraboloid(5e-6), HalfSpace.between(Elastic(1e6, 0.5))), Depth(0.0))
    >>> found = fit(gel, model, free=["bed.medium.first.young", "contact_point"])
    >>> round(found.value("bed.medium.first.young"), -1), round(found.value("contact_point"), 9)
    (10000.0, 3e-06)
    """
    return _searched(curve, model, free, noise, Search(time_limit))


def fit_steps(
    curve: ForceCurve,
    model: Model | ViscoelasticIndentation,
    *,
    free: Mapping[str, Any] | Iterable[str],
    noise: Quantity = 0.0,
    time_limit: float = math.inf,
) -> Iterator[FitState | Fit | ViscoelasticFit | CreepFit]:
    """Yield how far a fit has come after each of its evaluations, and last what it has found.

    Parameters and errors are those of `fit`, and so are the numbers.  A stream that is left early ends the fit.

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
    >>> *states, found = fit_steps(gel, model, free=["bed.medium.first.young"])
    >>> states[-1].values == found.values
    array([ True])
    """

    def searched(hand_over: Callable[[FitState], None]) -> Fit | ViscoelasticFit | CreepFit:
        return _searched(curve, model, free, noise, Search(time_limit, hand_over))

    yield from streamed(searched)


def _searched(
    curve: ForceCurve,
    model: Model | ViscoelasticIndentation,
    free: Mapping[str, Any] | Iterable[str],
    noise: Quantity,
    search: Search,
) -> Fit | ViscoelasticFit | CreepFit:
    if isinstance(model, ViscoelasticIndentation):
        return viscoelastic_fit(curve, model, free=free, noise=noise, search=search)
    moving = curve.chosen(curve.direction != 0.0) if np.any(curve.direction == 0.0) else curve
    flags = refuse(moving)
    given = dict.fromkeys(free, ()) if not isinstance(free, Mapping) else dict(free)
    if moving.count < 3 * len(given):
        raise InvalidInput(f"fit: {moving.count} points cannot tell {len(given)} numbers; give more, or free fewer.")
    question = task(moving, model, given, _spread(curve, noise))
    try:
        coordinates, _ = solved(question, best_start(question, search), MOST_PREDICTIONS, search)
    except NotConverged as error:
        raise NotConverged(" ".join([str(error), *map(str, flags)])) from None
    return _told(question, coordinates, float(np.mean(noise)), flags)


def _spread(curve: ForceCurve, noise: Quantity) -> Array:
    given = np.asarray(noise, dtype=float)
    if given.ndim and given.shape != curve.position.shape:
        raise InvalidInput(
            f"fit: noise has the shape {given.shape}, the curve {curve.position.shape}; give one number."
        )
    if not np.all(np.isfinite(given)) or np.any(given < 0.0) or (given.ndim and np.any(given == 0.0)):
        raise InvalidInput("fit: noise must be positive, in N (or zero for all, to be read from the curve).")
    if not given.any():
        return np.ones(())
    return given[curve.direction != 0.0] if given.ndim else given


def _told(question: Task, coordinates: Array, noise: float, flags: tuple[Flag, ...]) -> Fit:
    """Return the answer at the coordinates of least squares."""
    prediction = question.prediction(coordinates)
    numbers = question.numbers(coordinates)
    model = _at_largest_depth(question, numbers, prediction)
    jacobian = question.jacobian(coordinates, prediction)
    refuse_singular(question.parameters, jacobian, float(np.linalg.norm(question.curve.force * question.weights)))
    residuals = (question.curve.force - prediction.force) * question.weights
    sure = certainty(residuals, jacobian)
    values = np.array(list(numbers.values()))
    change = [p.change(n) for p, n in zip(question.parameters, values.tolist(), strict=True)]
    quiet = residuals[~prediction.attached]
    if noise == 0.0:
        noise = float(np.std(quiet)) if quiet.size >= QUIET else sure.scatter
    result = Fit(
        question.curve,
        model,
        tuple(numbers),
        values,
        sure.errors * np.abs(change),
        sure.correlation,
        np.array([p.low for p in question.parameters]),
        np.array([p.high for p in question.parameters]),
        noise or sure.scatter,
        question.weights,
        sure.scatter,
        sure.effective_count,
        prediction.force,
        prediction.attached,
        np.where(prediction.attached, prediction.held.radius, 0.0),
        flags,
    )
    against = doubts(question.parameters, coordinates, result, sure)
    return dataclasses.replace(result, flags=(*flags, *against))


def _at_largest_depth(question: Task, numbers: dict[str, float], prediction: Prediction) -> Model:
    """Return the model with its numbers, at the largest depth of the curve."""
    if not prediction.attached.any():
        raise OutsideValidity("fit: the best fit has no point in contact; the model does not describe this curve.")
    model = question.with_numbers(numbers)
    bed = model.bed
    widest = float(np.max(prediction.held.radius[prediction.attached]))
    along = question.curve.position - numbers.get("contact_point", 0.0)
    depth = float(np.max((along - question.curve.compliance * prediction.held.force)[prediction.attached]))
    beyond = widest >= bed.reach and bed.reach < bed.rim
    if beyond and depth > float(states_for(model).depth(np.array([bed.reach]))[0]):
        raise OutsideValidity(
            f"fit: the curve leads to contact radii beyond {bed.reach:.4g} m, where nothing is known of the profile; "
            "cut the curve off before, or give a profile that is known farther out."
        )
    return dataclasses.replace(model, load=Depth(depth))
