"""Drag of a liquid: half the difference between both directions out of contact, beside tilt and drift."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array

__all__ = ["Drag", "drag_of"]

BLOCKS = 5
"""Blocks of a direction from whose means the memory of the noise is read; that of 1/f noise grows with the length."""
LEAST_DRIFT_TO_ERROR = 4.0
"""Least drift of the force over its standard error for which it is taken into account."""


class Drag(NamedTuple):
    """Force against the motion [N] with its standard error, and the drift of the force over the curve [N]."""

    force: float
    error: float
    drift: float


def drag_of(order: Array, position: Array, force: Array, direction: Array) -> Drag | None:
    """Return the drag from free points of both directions, by least squares with level, tilt and, if certain, drift.

    None if the drift that would be needed exceeds the range of the free forces: it is not one straight line then.

    Parameters
    ----------
    order : ndarray, (n,)
        Times, or numbers of the points.
    position, force, direction : ndarray, (n,)
        [m], [N], +1 or -1.
    """
    columns = [np.ones(order.size), _scaled(position), direction, _scaled(order)]
    (numbers, errors), (few, few_errors) = (_fitted(columns[:count], force, direction) for count in (4, 3))
    if abs(numbers[3]) > LEAST_DRIFT_TO_ERROR * errors[3]:
        if max(abs(numbers[2]), abs(numbers[3])) > float(np.ptp(force)):
            return None
        return Drag(float(numbers[2]), float(errors[2]), 2.0 * float(numbers[3]))
    # a drift that is not certain may be there nevertheless
    error = min(float(np.hypot(few_errors[2], numbers[2] - few[2])), float(np.hypot(errors[2], few_errors[2])))
    return Drag(float(few[2]), error, 0.0)


def _scaled(column: Array) -> Array:
    half = 0.5 * float(np.ptp(column)) or 1.0
    return np.asarray((column - column.mean()) / half)


def _fitted(columns: list[Array], force: Array, direction: Array) -> tuple[Array, Array]:
    """Return numbers and standard errors, enlarged by the memory of the noise."""
    design = np.stack(columns, axis=1)
    level = float(force.mean())
    numbers = np.linalg.lstsq(design, force - level, rcond=None)[0]
    left = force - level - design @ numbers
    variance = float(left @ left) / max(force.size - len(columns), 1)
    size = max(int(0.5 * force.size / BLOCKS), 1)
    blocks = np.array([part.mean() for sign in (1.0, -1.0) for part in _blocks(left[direction == sign], size)])
    excess = float(np.mean(blocks**2)) * size / variance - 1.0 if variance > 0.0 and blocks.size else 0.0
    memory = 1.0 + BLOCKS * max(excess, 0.0)
    spread = np.diag(np.linalg.pinv(design.T @ design))
    return numbers, np.sqrt(variance * memory * spread)


def _blocks(samples: Array, size: int) -> list[Array]:
    return [samples[start : start + size] for start in range(0, samples.size - size + 1, size)]
