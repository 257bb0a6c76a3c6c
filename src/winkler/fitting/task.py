r"""A fit as a problem of least squares: numbers in, residuals and their derivatives out.

Positive quantities are varied by their logarithm.  Predictions and starts are defined by a
response model, a subclass of `FitTask`: `winkler.fitting.elastic.task` for contacts with or without adhesion,
`winkler.fitting.viscoelastic.motion` and `winkler.fitting.viscoelastic.creep` for bodies that relax.  In all of them

.. math:: F_i = F_\mathrm{contact} + F_0 + t\,(D_i-D_0) + c_v\,\dot D_i + e_i

with the contact point :math:`D_0`, the baseline :math:`F_0`, its tilt t and the drag of a liquid on the cantilever.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable
from typing import Any, ClassVar, NamedTuple, Self, TypeVar

import numpy as np

from winkler.fitting.curves.checks import CurveOutline, Flag
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.estimate import LINE_PARAMETERS
from winkler.fitting.noise.disturbances import disturbances_of
from winkler.fitting.noise.estimate import NoiseEstimate, noise_of
from winkler.fitting.noise.whitening import Whitening
from winkler.fitting.outcome import AnyFit
from winkler.fitting.parameters import changed
from winkler.fitting.varied import CURVE_PARAMETERS, Parameter
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity

T = TypeVar("T")
DIFFERENCE_STEP = 1e-5
MOST_RECENT = 8
"""Models that a task keeps."""


class Prediction(NamedTuple):
    """The fitted quantity at all points ``(n,)``, the points in contact ``(n,)``, and the contact."""

    fitted: Array
    touched: Array
    contact: Any


class _TaskFields(NamedTuple):
    """Data of a fit.

    Parameters
    ----------
    curve : ForceCurve
        The points that are fitted, in the order in which they were measured.
    model : value
        With a placeholder for its load.
    parameters : tuple of Parameter, (p,)
    weights : ndarray, (n,)
        Factors of the residuals.
    velocity : ndarray, (n,)
        Of the machine [m/s]; zero without drag.
    per_force : ndarray, (n,)
        For fits of positions: the position per force [m/N] of equal weight, at points whose force is fitted
        instead; zero at all others.
    fixed : tuple of (str, float)
        Fixed numbers that differ from those of the model.
    whitening : Whitening, optional
        Decorrelation of the residuals in least squares; none unless given.
    tables : ModelTables, optional
        What all predictions of a fit share (`winkler.fitting.elastic.model_tables`); of contacts that do not relax.
    acceleration : ndarray, (n,), optional
        Of the tip into the body [m/s^2]; none without inertia.
    misfits : ndarray, (n,), optional
        What the model misses at each point relative to the noise, by which the weights are divided; 1 unless given.
    """

    curve: ForceCurve
    model: Any
    parameters: tuple[Parameter, ...]
    weights: Array
    velocity: Array
    per_force: Array
    fixed: tuple[tuple[str, float], ...] = ()
    whitening: Whitening | None = None
    tables: Any = None
    acceleration: Array | None = None
    misfits: Array | None = None


class FitTask(_TaskFields):
    """A least-squares problem; the subclasses define the response of a model."""

    settled: ClassVar[float]
    """Relative change of sum and coordinates at which least squares stop."""
    coarse_count: ClassVar[int]
    """Number of points for the choice between starts, of which a coarse fit improves the first `starts_improved`."""
    starts_improved: ClassVar[int]
    most_reweightings: ClassVar[int] = 2
    """Most changes of the weights, or of the points that count, by the last fit."""
    starts_are_trials: ClassVar[bool]
    """Whether some starts may lie outside the validity of the model, and a single one is improved too."""

    @property
    def measured(self) -> Array:
        """The fitted quantity ``(n,)``: forces [N], unless a subclass overrides it."""
        return self.curve.force

    @property
    def stated_weights(self) -> Array:
        """Factors of the residuals by the noise alone ``(n,)``."""
        return self.weights if self.misfits is None else self.weights * self.misfits

    @property
    def size(self) -> float:
        """Weighted norm of the measured quantity."""
        raise NotImplementedError

    @property
    def has_one_optimum(self) -> bool:
        """Whether an improved first start that explains the curve needs no comparison with others."""
        return False

    def starts(self, rough_outline: CurveOutline | None) -> Iterable[Array]:
        """Return coordinates from which a fit may begin."""
        raise NotImplementedError

    def explained_by(self, squares: float, coarse: Self, rough_outline: CurveOutline | None) -> bool:
        """Return whether a start with this sum of weighted squares at the points of `coarse` needs no other."""
        del squares, coarse, rough_outline
        return False

    def sample_of(self, stretch: Array) -> Array:
        """Return a part of the points of one direction, as indices."""
        raise NotImplementedError

    def prediction(self, coordinates: Array) -> Prediction:
        """Return the prediction of the model at coordinates."""
        raise NotImplementedError

    def predicted(self, coordinates: Array) -> Prediction:
        """Return the prediction at coordinates; the last one is kept."""
        return self._kept("prediction", coordinates, lambda: self.prediction(coordinates))

    def slopes(self, coordinates: Array) -> Array:
        """Return the weighted derivatives ``(n, p)`` of the prediction at coordinates; the last ones are kept."""
        return self._kept("slopes", coordinates, lambda: self.jacobian(coordinates, self.predicted(coordinates)))

    @property
    def resolution(self) -> int:
        """What predictions depend on beside the coordinates: it grows where a contact needs wider cells."""
        return 0

    def _kept(self, name: str, coordinates: Array, compute: Callable[[], T]) -> T:
        known = self._last.get(name)
        if known is None or known[0] != (coordinates.tobytes(), self.resolution):
            found = compute()
            self._last[name] = ((coordinates.tobytes(), self.resolution), found)
            return found
        kept: T = known[1]
        return kept

    @functools.cached_property
    def _last(self) -> dict[str, tuple[tuple[bytes, int], Any]]:
        return {}

    def quiet(self, prediction: Prediction) -> Array:
        """Return the points whose residuals are noise alone ``(n,)``: out of contact."""
        return ~prediction.touched

    def reweighed(self, coordinates: Array, rough_outline: CurveOutline | None, noise: Array) -> Self | None:
        """Return the task with new weights from nearly converged coordinates; None if they stay."""
        return None

    def final(self, coordinates: Array) -> Array:
        """Return the reported coordinates from those of least squares."""
        return coordinates

    def model_of(self, numbers: dict[str, float], prediction: Prediction) -> Any:
        """Return the model with its numbers and the load of the curve."""
        raise NotImplementedError

    def doubts(self, numbers: dict[str, float], errors: Array) -> list[Flag]:
        """Return doubts specific to this kind of model."""
        return []

    def outcome(self, numbers: dict[str, float], prediction: Prediction, shared: dict[str, Any]) -> AnyFit:
        """Return the fit; `shared` are the common fields of all fits."""
        raise NotImplementedError

    @property
    def turn(self) -> int:
        """The first point of the retraction; n if there is none."""
        out = np.flatnonzero(self.curve.direction < 0.0)
        return int(out[0]) if out.size else self.curve.count

    def numbers(self, coordinates: Array) -> dict[str, float]:
        """Return the numbers at coordinates, by name."""
        varied = {p.name: p.outward(float(c)) for p, c in zip(self.parameters, coordinates, strict=True)}
        return varied | dict(self.fixed)

    def with_numbers(self, numbers: dict[str, float]) -> Any:
        """Return the model with its numbers."""
        own = {name: number for name, number in numbers.items() if name not in CURVE_PARAMETERS}
        key = tuple(own.items())
        if key not in self.recent_models:
            if len(self.recent_models) >= MOST_RECENT:
                del self.recent_models[next(iter(self.recent_models))]
            self.recent_models[key] = changed(self.model, own) if own else self.model
        return self.recent_models[key]

    @functools.cached_property
    def recent_models(self) -> dict[tuple[tuple[str, float], ...], Any]:
        """The last models by their numbers: a prediction, its derivatives and steps of the line share them."""
        return {}

    def along(self, numbers: dict[str, float]) -> Array:
        """Return the measured positions from the contact point on [m]."""
        return np.asarray(self.curve.position - numbers.get("contact_point", 0.0))

    def place(self, numbers: dict[str, float]) -> Array:
        """Return D from first touch, without drift [m]."""
        since = self.curve.time - self.curve.time[0]
        return np.asarray(self.along(numbers) - numbers.get("drift", 0.0) * since)

    def line(self, numbers: dict[str, float]) -> Array:
        """Return the part of the force outside the contact [N]."""
        moving = numbers.get("drag", 0.0) * self.velocity
        if self.acceleration is not None:
            moving = moving + numbers.get("inertia", 0.0) * self.acceleration
        return np.asarray(numbers.get("baseline", 0.0) + numbers.get("tilt", 0.0) * self.along(numbers) + moving)

    @functools.cached_property
    def disturbances(self) -> Array:
        """Weighted courses ``(n, q)`` of disturbances that the model does not contain."""
        return disturbances_of(self.curve) * self.weights[:, None]

    def courses(self, jacobian: Array) -> Array:
        """Return the disturbances at coordinates with a weighted jacobian ``(n, p)``, unless they are the same at all.

        The shape is ``(n, q)``.
        """
        del jacobian
        return self.disturbances

    def noise_of(self, residuals: Array, jacobian: Array) -> NoiseEstimate:
        """Return the noise in weighted residuals ``(n,)`` with their jacobian ``(n, p)``, as far as it is unknown."""
        return noise_of(residuals, jacobian, self.courses(jacobian), white=self.curve.has_white_noise)

    def restarts(self, coordinates: Array, covariance: Array) -> list[Array]:
        """Return coordinates from which a fit with several optima begins again; none, unless the fitted quantity jumps.

        Parameters
        ----------
        coordinates : ndarray, (p,)
            Of an optimum.
        covariance : ndarray, (p, p)
            Of these.
        """
        del coordinates, covariance
        return []

    def residuals(self, coordinates: Array) -> Array:
        """Return the weighted misfit, measured less predicted."""
        return self.residuals_of(self.predicted(coordinates))

    def residuals_of(self, prediction: Prediction) -> Array:
        """Return the weighted misfit of a prediction.

        Raises
        ------
        OutsideValidity
            If the model predicts what is no finite number.
        """
        residuals = self.decorrelated((self.measured - prediction.fitted) * self.weights)
        if not np.all(np.isfinite(residuals)):
            place = float(self.curve.position[int(np.argmax(~np.isfinite(prediction.fitted)))])
            raise OutsideValidity(
                f"fit: the model predicts no finite number at the position {place:.4g} m of curve '{self.curve.name}'; "
                "give a profile that reaches so far, or starts and bounds nearer to the answer."
            )
        return residuals

    def decorrelated(self, columns: Array) -> Array:
        """Return weighted columns ``(n,)`` or ``(n, c)`` as least squares count them."""
        return columns if self.whitening is None else self.whitening.of(columns)

    def freedoms(self, prediction: Prediction) -> tuple[float, float]:
        """Return the degrees of freedom of all fitted points, and of those in contact."""
        counted = self.weights > 0.0
        count, own = int(np.count_nonzero(counted)), sum(p.name not in LINE_PARAMETERS for p in self.parameters)
        inside = int(np.count_nonzero(counted & prediction.touched)) - own
        return float(max(count - len(self.parameters), 1)), float(max(inside, 1))

    def instrument(self, coordinates: Array, prediction: Prediction) -> Array:
        """Return the weighted derivatives ``(n, p)`` to which residuals are made orthogonal at the end."""
        del prediction
        return self.slopes(coordinates)

    def jacobian(self, coordinates: Array, prediction: Prediction) -> Array:
        """Return the weighted derivatives ``(n, p)`` of the prediction at coordinates."""
        numbers = self.numbers(coordinates)
        columns = []
        for index, parameter in enumerate(self.parameters):
            column = self.slope(parameter.name, numbers, prediction)
            if column is None:
                columns.append(self.difference(coordinates, index, prediction))
            else:
                columns.append(column * parameter.scale)
        return (np.array(columns) * self.weights).T

    def slope(self, name: str, numbers: dict[str, float], prediction: Prediction) -> Any:
        """Return the derivative with respect to a number in closed form ``(n,)``, else None."""
        match name:
            case "baseline":
                return np.ones(self.curve.count)
            case "tilt":
                return self.along(numbers)
            case "drag":
                return self.velocity
            case _:
                return None

    def difference(self, coordinates: Array, index: int, prediction: Prediction) -> Array:
        """Return the derivative with respect to a coordinate as a quotient of differences ``(n,)``."""
        raise NotImplementedError

    def step(self, coordinates: Array, index: int, size: float = DIFFERENCE_STEP) -> float:
        """Return a step of a coordinate that stays within its bounds."""
        parameter = self.parameters[index]
        return -size if coordinates[index] + size > parameter.inward(parameter.high) else size

    def chosen(self, indices: Array) -> Self:
        """Return the task of some of the points, given as indices."""
        return self._replace(
            curve=self.curve.chosen(indices),
            weights=self.weights[indices],
            velocity=self.velocity[indices],
            per_force=self.per_force[indices],
            acceleration=None if self.acceleration is None else self.acceleration[indices],
            misfits=None if self.misfits is None else self.misfits[indices],
        )

    @functools.cached_property
    def coarse(self) -> Self:
        """The task on a part of the points, if there are many."""
        if self.curve.count <= self.coarse_count:
            return self
        turns = np.flatnonzero(np.diff(self.curve.direction)) + 1
        stretches = np.split(np.arange(self.curve.count), turns)
        return self.chosen(np.unique(np.concatenate([self.sample_of(stretch) for stretch in stretches])))


def moved(coordinates: Array, index: int, step: float) -> Array:
    """Return coordinates of which one is changed by a step."""
    changed_ = coordinates.copy()
    changed_[index] += step
    return changed_


def even_weights(curve: ForceCurve, noise: Array) -> Array:
    """Return the weights ``(n,)`` of points by their noise, of which only the course matters; zero: uniform."""
    return np.array(np.broadcast_to(np.mean(noise) / noise if noise.any() else 1.0, curve.position.shape))
