"""Free parameters of a fit: start, bounds, and coordinate."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from winkler.fitting.parameters import number_at, unit_of
from winkler.values.errors import InvalidInput, suggest

CURVE_PARAMETERS = ("contact_point", "baseline", "tilt", "drift", "drag", "inertia")
"""Parameters of the curve itself; the last three need times."""
NATURAL_BOUNDS = {"poisson": (-0.99, 0.5), "half_angle": (1e-3, 0.5 * np.pi - 1e-3)}
"""Bounds of parameters that are not arbitrary positive numbers."""


class Parameter(NamedTuple):
    """One free parameter.

    Parameters
    ----------
    name : str
        Its path, or one of `CURVE_PARAMETERS`.
    low, high : float
        Bounds.
    start : float
        Start value.
    has_start : bool
        Whether a start was stated.
    logarithmic : bool
        Whether its logarithm is varied.
    scale : float
        Its scale, unless the logarithm is varied.
    """

    name: str
    low: float
    high: float
    start: float
    has_start: bool
    logarithmic: bool
    scale: float

    def inward(self, number: float) -> float:
        """Return the varied coordinate."""
        if self.logarithmic:
            return math.log(number) if number > 0.0 else -np.inf
        return number / self.scale

    def outward(self, coordinate: float) -> float:
        """Return the number at a coordinate."""
        return math.exp(coordinate) if self.logarithmic else coordinate * self.scale

    def change(self, number: float) -> float:
        """Return the derivative of the number with respect to the coordinate."""
        return number if self.logarithmic else self.scale

    def inside(self, number: float) -> float:
        """Return the nearest number within the bounds."""
        return min(max(number, self.low), self.high)


def parameters_of(
    model: Any, free: dict[str, Any], scales: dict[str, float], natural_bounds: dict[str, tuple[float, float]]
) -> tuple[Parameter, ...]:
    """Return the free parameters.

    Parameters
    ----------
    model : value
        The paths lead into it.
    free : dict
        Name and (low, high), or a start value, or neither (an empty tuple).
    scales : dict of str to float
        Parameters of the curve itself, with their scales.
    natural_bounds : dict of str to (float, float)
        Paths, or last names, of parameters with natural bounds.

    Raises
    ------
    InvalidInput
        If a path does not exist, or its bounds are inconsistent.
    """
    parameters = []
    for name, stated in free.items():
        if name in scales:
            scale, low, high, start, logarithmic = scales[name], -np.inf, np.inf, 0.0, False
        else:
            if "." not in name:
                raise InvalidInput(
                    f"free: '{name}' is neither a path into the model nor one of {', '.join(scales)}"
                    f"{suggest(name, scales)}."
                )
            start = number_at(model, name)
            usual = (0.0, np.inf) if start > 0.0 else (-np.inf, np.inf)
            low, high = natural_bounds.get(name, natural_bounds.get(name.rpartition(".")[2], usual))
            logarithmic = low == 0.0
            scale = 1.0 if unit_of(model, name) == "" else max(abs(start), 1e-300)
        own_start = False
        if isinstance(stated, tuple | list) and len(stated) == 2:
            low, high = max(low, float(stated[0])), min(high, float(stated[1]))
            start = start if low < start < high else _between(low, high, logarithmic)
        elif isinstance(stated, int | float) and not isinstance(stated, bool):
            start, own_start = float(stated), True
        elif not (isinstance(stated, tuple | list) and len(stated) == 0):
            raise InvalidInput(f"free: '{name}' is {stated!r}; give (low, high), a start value, or () for neither.")
        if not (low < high and low <= start <= high):
            raise InvalidInput(f"free: '{name}' starts at {start:.6g} between {low:.6g} and {high:.6g}; correct it.")
        parameters.append(Parameter(name, low, high, start, own_start, logarithmic, scale))
    return tuple(parameters)


def _between(low: float, high: float, logarithmic: bool) -> float:
    if logarithmic and low > 0.0:
        return float(np.sqrt(low * high))
    return 0.5 * (low + high) if np.isfinite(low) and np.isfinite(high) else (low if np.isfinite(low) else high)
