"""A fit as a problem of least squares: numbers in, residuals and their derivatives out.

Positive quantities are varied by their logarithm.  What a model predicts at given numbers, and where its fit begins, a
response model says, a subclass of `Task`: `winkler.fitting.elastic.task` for contacts with or without adhesion,
`winkler.fitting.viscoelastic.motion` and `winkler.fitting.viscoelastic.creep` for bodies that relax.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable
from typing import Any, ClassVar, NamedTuple, Self

import numpy as np

from winkler.errors import InvalidInput, suggest
from winkler.fitting.curves.checks import Flag, Outline
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.estimate import Estimate
from winkler.fitting.parameters import changed, found, unit_of
from winkler.numerics.types import Array

__all__ = [
    "FREELY",
    "OF_THE_CURVE",
    "STEP",
    "Parameter",
    "Prediction",
    "Task",
    "even_weights",
    "moved",
    "parameters_of",
]

OF_THE_CURVE = ("contact_point", "baseline", "tilt", "drift", "drag")
"""Names of what a curve itself leaves open; the last two need times."""
STEP = 1e-5
FREELY = {"poisson": (-0.99, 0.5), "half_angle": (1e-3, 0.5 * np.pi - 1e-3)}
"""Bounds of numbers that are no positive quantities without end."""


class Parameter(NamedTuple):
    """One number that is varied.

    Parameters
    ----------
    name : str
        Its path, or one of `OF_THE_CURVE`.
    low, high : float
        Bounds.
    start : float
        Where to begin.
    given : bool
        Whether the start was given.
    logarithmic : bool
        Whether its logarithm is varied.
    scale : float
        What it is measured in, if not by its logarithm.
    """

    name: str
    low: float
    high: float
    start: float
    given: bool
    logarithmic: bool
    scale: float

    def inward(self, number: float) -> float:
        """Return the coordinate that is varied."""
        if self.logarithmic:
            return float(np.log(number)) if number > 0.0 else -np.inf
        return number / self.scale

    def outward(self, coordinate: float) -> float:
        """Return the number at a coordinate."""
        return float(np.exp(coordinate)) if self.logarithmic else coordinate * self.scale

    def change(self, number: float) -> float:
        """Return by how much the number changes with the coordinate."""
        return number if self.logarithmic else self.scale

    def inside(self, number: float) -> float:
        """Return the number within the bounds that is nearest to one."""
        return float(np.clip(number, self.low, self.high))


class Prediction(NamedTuple):
    """The fitted quantity at all points ``(n,)``, where the tip is in contact ``(n,)``, and the contact behind them."""

    fitted: Array
    touched: Array
    contact: Any


@dataclasses.dataclass(frozen=True, eq=False)
class Task:
    """Everything that a fit needs to know; the subclasses say how a model responds.

    Parameters
    ----------
    curve : ForceCurve
        The points that are fitted.
    model : value
        With a placeholder for its load.
    parameters : tuple of Parameter, (p,)
    weights : ndarray, (n,)
        What residuals are multiplied with.
    fixed : tuple of (str, float)
        Numbers that are not varied, other than the model's own.
    """

    curve: ForceCurve
    model: Any
    parameters: tuple[Parameter, ...]
    weights: Array
    fixed: tuple[tuple[str, float], ...] = dataclasses.field(default=(), kw_only=True)

    settled: ClassVar[float]
    """Relative change of sum and coordinates at which least squares stop."""
    must_settle: ClassVar[bool]
    """Whether numbers that have not settled are refused."""
    coarse_count: ClassVar[int]
    """How many points choose between the starts."""
    starts_improved: ClassVar[int]
    """How many starts a coarse fit improves."""
    starts_are_trials: ClassVar[bool]
    """Whether starts are guesses, of which some may lead out of the model's reach and a single one is improved too."""

    @property
    def measured(self) -> Array:
        """The quantity that is fitted ``(n,)``: the forces [N], unless a subclass says otherwise."""
        return self.curve.force

    @property
    def size(self) -> float:
        """Norm of what was measured, weighted."""
        raise NotImplementedError

    def starts(self, coarse: Self, strokes: Outline | None) -> Iterable[Array]:
        """Return coordinates from which a fit may begin; `coarse` is the task on a part of the points."""
        raise NotImplementedError

    def some_of(self, stretch: Array) -> Array:
        """Return a part of the points of one direction, as indices."""
        raise NotImplementedError

    def prediction(self, coordinates: Array) -> Prediction:
        """Return what the model says at coordinates."""
        raise NotImplementedError

    def quiet(self, prediction: Prediction) -> Array:
        """Return at which points the residuals are noise alone ``(n,)``: out of contact."""
        return ~prediction.touched

    def reweighed(self, coordinates: Array, strokes: Outline | None, noise: Array) -> Self | None:
        """Return the task with the weights that coordinates near the answer suggest; none if they stay."""
        return None

    def final(self, coordinates: Array) -> Array:
        """Return the coordinates that are reported, from those of least squares."""
        return coordinates

    def model_of(self, numbers: dict[str, float], prediction: Prediction) -> Any:
        """Return the model with its numbers and the load of the curve."""
        raise NotImplementedError

    def doubts(self, numbers: dict[str, float], errors: Array) -> list[Flag]:
        """Return what this kind of model says against its own numbers."""
        return []

    def outcome(self, numbers: dict[str, float], prediction: Prediction, shared: dict[str, Any]) -> Estimate:
        """Return the fit; `shared` are the fields that all fits have."""
        raise NotImplementedError

    def numbers(self, coordinates: Array) -> dict[str, float]:
        """Return the numbers at coordinates, by name."""
        varied = {p.name: p.outward(float(c)) for p, c in zip(self.parameters, coordinates, strict=True)}
        return varied | dict(self.fixed)

    def with_numbers(self, numbers: dict[str, float]) -> Any:
        """Return the model with its numbers."""
        own = {name: number for name, number in numbers.items() if name not in OF_THE_CURVE}
        return changed(self.model, own) if own else self.model

    def along(self, numbers: dict[str, float]) -> Array:
        """Return the measured positions from the contact point on [m]."""
        return np.asarray(self.curve.position - numbers.get("contact_point", 0.0))

    def line(self, numbers: dict[str, float]) -> Array:
        """Return the part of the force that the contact does not bear [N]."""
        return np.asarray(numbers.get("baseline", 0.0) + numbers.get("tilt", 0.0) * self.along(numbers))

    def residuals(self, coordinates: Array) -> Array:
        """Return the weighted misfit, measured less predicted."""
        return np.asarray((self.measured - self.prediction(coordinates).fitted) * self.weights)

    def jacobian(self, coordinates: Array, prediction: Prediction) -> Array:
        """Return the derivatives ``(n, p)`` of what is predicted at coordinates, weighted."""
        numbers = self.numbers(coordinates)
        columns = []
        for index, parameter in enumerate(self.parameters):
            column = self.slope(parameter.name, numbers, prediction)
            known = column is not None
            columns.append(column * parameter.scale if known else self.difference(coordinates, index, prediction))
        return np.stack(columns, axis=1) * self.weights[:, None]

    def slope(self, name: str, numbers: dict[str, float], prediction: Prediction) -> Any:
        """Return the derivative with respect to a number if it is known in closed form, ``(n,)``, else None."""
        match name:
            case "baseline":
                return np.ones(self.curve.count)
            case "tilt":
                return self.along(numbers)
            case _:
                return None

    def difference(self, coordinates: Array, index: int, prediction: Prediction) -> Array:
        """Return the derivative with respect to a coordinate as a quotient of differences ``(n,)``."""
        raise NotImplementedError

    def step(self, coordinates: Array, index: int, size: float = STEP) -> float:
        """Return a step of a coordinate that stays within its bounds."""
        parameter = self.parameters[index]
        return -size if coordinates[index] + size > parameter.inward(parameter.high) else size

    def chosen(self, kept: Array) -> Self:
        """Return the task of some of the points, given as indices."""
        return dataclasses.replace(self, curve=self.curve.chosen(kept), weights=self.weights[kept])

    def coarse(self) -> Self:
        """Return the task on a part of the points, if there are many."""
        if self.curve.count <= self.coarse_count:
            return self
        turns = np.flatnonzero(np.diff(self.curve.direction)) + 1
        stretches = np.split(np.arange(self.curve.count), turns)
        return self.chosen(np.unique(np.concatenate([self.some_of(stretch) for stretch in stretches])))


def moved(coordinates: Array, index: int, step: float) -> Array:
    """Return coordinates of which one is changed by a step."""
    changed_ = coordinates.copy()
    changed_[index] += step
    return changed_


def even_weights(curve: ForceCurve, noise: Array) -> Array:
    """Return the weights ``(n,)`` of points by their noise, of which only the course matters; zero: all alike."""
    return np.array(np.broadcast_to(np.mean(noise) / noise if noise.any() else 1.0, curve.position.shape))


def parameters_of(
    model: Any, free: dict[str, Any], scales: dict[str, float], freely: dict[str, tuple[float, float]]
) -> tuple[Parameter, ...]:
    """Return the numbers that are varied.

    Parameters
    ----------
    model : value
        The paths lead into it.
    free : dict
        Name and (low, high), or a start value, or nothing in particular (an empty tuple).
    scales : dict of str to float
        Names of what the curve itself leaves open, and what they are measured in.
    freely : dict of str to (float, float)
        Paths, or last names, of numbers that are no positive quantities without end, and their bounds.

    Raises
    ------
    InvalidInput
        If a name leads nowhere, or its bounds contradict themselves.
    """
    parameters = []
    for name, given in free.items():
        if name in scales:
            scale, low, high, start, logarithmic = scales[name], -np.inf, np.inf, 0.0, False
        else:
            if "." not in name:
                raise InvalidInput(
                    f"free: '{name}' is neither a path into the model nor one of {', '.join(scales)}"
                    f"{suggest(name, scales)}."
                )
            start = found(model, name)
            usual = (0.0, np.inf) if start > 0.0 else (-np.inf, np.inf)
            low, high = freely.get(name, freely.get(name.rpartition(".")[2], usual))
            logarithmic = low == 0.0
            scale = 1.0 if unit_of(model, name) == "" else max(abs(start), 1e-300)
        own_start = False
        if isinstance(given, tuple | list) and len(given) == 2:
            low, high = max(low, float(given[0])), min(high, float(given[1]))
            start = start if low < start < high else _between(low, high, logarithmic)
        elif isinstance(given, int | float) and not isinstance(given, bool):
            start, own_start = float(given), True
        elif not (isinstance(given, tuple | list) and len(given) == 0):
            raise InvalidInput(f"free: '{name}' is {given!r}; give (low, high), a start value, or () for neither.")
        if not (low < high and low <= start <= high):
            raise InvalidInput(f"free: '{name}' starts at {start:.6g} between {low:.6g} and {high:.6g}; mend it.")
        parameters.append(Parameter(name, low, high, start, own_start, logarithmic, scale))
    return tuple(parameters)


def _between(low: float, high: float, logarithmic: bool) -> float:
    if logarithmic and low > 0.0:
        return float(np.sqrt(low * high))
    return 0.5 * (low + high) if np.isfinite(low) and np.isfinite(high) else (low if np.isfinite(low) else high)
