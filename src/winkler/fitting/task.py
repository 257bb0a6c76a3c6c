"""A fit as a question for least squares: parameters in, residuals and their derivatives out.

Positive quantities are varied by their logarithm.  The derivatives with respect to contact point, baseline and tilt
follow from the slope of the predicted force; those of the model's own numbers are differences of two models at the same
contact radii, good to five digits because both are smooth to ten.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from winkler.errors import InvalidInput, suggest
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.parameters import changed, found, unit_of
from winkler.fitting.prediction import (
    Held,
    Model,
    Run,
    attached,
    comparable,
    held_contact,
    moved_force,
    runs_of,
)
from winkler.numerics.types import Array

__all__ = ["FREELY", "OF_THE_CURVE", "Parameter", "Prediction", "Task", "asked", "task"]

OF_THE_CURVE = ("contact_point", "baseline", "tilt")
"""Names of what a curve itself leaves open."""
STEP = 1e-5
FREELY = {"poisson": (-0.99, 0.5), "half_angle": (1e-3, 0.5 * np.pi - 1e-3)}
"""Bounds of numbers that are no positive quantities without end."""


class Parameter(NamedTuple):
    """One number that is varied.

    Parameters
    ----------
    name : str
        Its path, or contact_point, baseline or tilt.
    low, high : float
        Bounds.
    start : float
        Where to begin.
    told : bool
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
    told: bool
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


class Prediction(NamedTuple):
    """A model's forces ``(n,)`` with the baseline [N], where it is in contact, and the contact behind them."""

    force: Array
    attached: Array
    held: Held


class Task(NamedTuple):
    """Everything that a fit needs to know.

    Parameters
    ----------
    curve : ForceCurve
    model : Indentation or AdhesiveIndentation
    parameters : tuple of Parameter
    weights : ndarray, (n,)
        What residuals are multiplied with.
    runs : tuple of Run
    fixed : tuple of (str, float)
        Numbers that are not varied, other than the model's own.
    """

    curve: ForceCurve
    model: Model
    parameters: tuple[Parameter, ...]
    weights: Array
    runs: tuple[Run, ...]
    fixed: tuple[tuple[str, float], ...] = ()

    def numbers(self, coordinates: Array) -> dict[str, float]:
        """Return the numbers at coordinates, by name."""
        varied = {p.name: p.outward(float(c)) for p, c in zip(self.parameters, coordinates, strict=True)}
        return varied | dict(self.fixed)

    def with_numbers(self, numbers: dict[str, float]) -> Model:
        """Return the model with its numbers."""
        own = {name: number for name, number in numbers.items() if name not in OF_THE_CURVE}
        return changed(self.model, own) if own else self.model

    def held(self, numbers: dict[str, float]) -> Held:
        """Return the contact as if it held everywhere."""
        origin = numbers.get("contact_point", 0.0)
        model = self.with_numbers(numbers)
        return held_contact(model, self.curve.compliance, self.curve.position - origin, self.runs, origin)

    def line(self, numbers: dict[str, float]) -> Array:
        """Return the baseline at all positions [N]."""
        along = self.curve.position - numbers.get("contact_point", 0.0)
        return numbers.get("baseline", 0.0) + numbers.get("tilt", 0.0) * along

    def prediction(self, coordinates: Array) -> Prediction:
        """Return the forces at coordinates."""
        numbers = self.numbers(coordinates)
        held, line = self.held(numbers), self.line(numbers)
        holds = attached(held, (self.curve.force - line) * self.weights, self.runs, self.weights)
        return Prediction(np.where(holds, held.force, 0.0) + line, holds, held)

    def residuals(self, coordinates: Array) -> Array:
        """Return the weighted misfit, measured less predicted."""
        return np.asarray((self.curve.force - self.prediction(coordinates).force) * self.weights)

    def jacobian(self, coordinates: Array, prediction: Prediction) -> Array:
        """Return the derivatives ``(n, p)`` of the predicted forces, weighted."""
        numbers = self.numbers(coordinates)
        holds = prediction.attached
        columns = []
        for index, parameter in enumerate(self.parameters):
            match parameter.name:
                case "contact_point":
                    column = -np.where(holds, prediction.held.slope, 0.0) - numbers.get("tilt", 0.0)
                case "baseline":
                    column = np.ones(self.curve.count)
                case "tilt":
                    column = self.curve.position - numbers.get("contact_point", 0.0)
                case _:
                    columns.append(self._difference(coordinates, index, prediction))
                    continue
            columns.append(column * parameter.scale)
        return np.stack(columns, axis=1) * self.weights[:, None]

    def _difference(self, coordinates: Array, index: int, prediction: Prediction) -> Array:
        parameter = self.parameters[index]
        step = STEP
        if coordinates[index] + step > parameter.inward(parameter.high):
            step = -STEP
        moved = coordinates.copy()
        moved[index] += step
        numbers, holds, held = self.numbers(moved), prediction.attached, prediction.held
        other = self.with_numbers(numbers)
        column = np.zeros(self.curve.count)
        if np.all(held.balanced[holds]) and comparable(self.with_numbers(self.numbers(coordinates)), other):
            column[holds] = moved_force(held, other, self.curve.compliance, holds) / step
        else:
            column[holds] = (self.held(numbers).force - held.force)[holds] / step
        return column


def task(curve: ForceCurve, model: Model, free: dict[str, Any], noise: Array) -> Task:
    """Return a fit as a task.

    Parameters
    ----------
    curve : ForceCurve
        Without held points.
    model : Indentation or AdhesiveIndentation
    free : dict
        Name and (low, high), or a start value, or nothing in particular (an empty tuple).
    noise : ndarray
        Standard deviation of the forces [N], ``()`` or ``(n,)``; only its course matters here.

    Raises
    ------
    InvalidInput
        If a name leads nowhere, or its bounds contradict themselves.
    """
    if not free:
        raise InvalidInput("fit: nothing is free; name at least one number, as 'bed.medium.first.young'.")
    span, strength = float(np.ptp(curve.position)), float(np.ptp(curve.force))
    if span == 0.0 or strength == 0.0:
        raise InvalidInput(f"fit: the curve '{curve.name}' has no range of positions or forces; nothing can be fitted.")
    scales = {"contact_point": span, "baseline": strength, "tilt": strength / span}
    weights = np.broadcast_to(np.mean(noise) / noise, curve.position.shape)
    return Task(curve, model, asked(model, free, scales, FREELY), weights, runs_of(curve))


def asked(
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
        told = False
        if isinstance(given, tuple | list) and len(given) == 2:
            asked = float(given[0]), float(given[1])
            low, high = max(low, asked[0]), min(high, asked[1])
            start = start if low < start < high else _between(low, high, logarithmic)
        elif isinstance(given, int | float) and not isinstance(given, bool):
            start, told = float(given), True
        elif not (isinstance(given, tuple | list) and len(given) == 0):
            raise InvalidInput(f"free: '{name}' is {given!r}; give (low, high), a start value, or () for neither.")
        if not (low < high and low <= start <= high):
            raise InvalidInput(f"free: '{name}' starts at {start:.6g} between {low:.6g} and {high:.6g}; mend it.")
        parameters.append(Parameter(name, low, high, start, told, logarithmic, scale))
    return tuple(parameters)


def _between(low: float, high: float, logarithmic: bool) -> float:
    if logarithmic and low > 0.0:
        return float(np.sqrt(low * high))
    return 0.5 * (low + high) if np.isfinite(low) and np.isfinite(high) else (low if np.isfinite(low) else high)
