"""Pop-ins: sudden steps of position at nearly constant force, or drops of force, while the tip is pressed in."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.directions import IN
from winkler.fitting.curves.events.record import Record
from winkler.fitting.curves.events.steps import Step, found_steps
from winkler.fitting.curves.medians import median
from winkler.numerics.types import Array

NEIGHBOURS = 12
"""Points on each side by which the two signals of a step are compared."""
MOST_FORCE_SHARE = 0.3
"""Greatest step of force over stiffness times step of position: more is a jump of the machine."""


class PopIn(NamedTuple):
    """Number of the first point behind the step, its size with standard error, and the unit of both, m or N."""

    place: int
    size: float
    error: float
    unit: str

    @property
    def ratio(self) -> float:
        """Size over error."""
        return self.size / self.error if self.error > 0.0 else np.inf


def pop_ins(record: Record, first: int) -> tuple[PopIn, ...]:
    """Return the pop-ins while the tip goes in, from the point `first` on."""
    turns = np.flatnonzero(np.diff(record.direction)) + 1
    result: list[PopIn] = []
    for part in np.split(np.arange(record.length), turns):
        inside = part[part >= first]
        if inside.size and record.direction[inside[0]] == IN:
            result += _of_stretch(record.position[inside], record.force[inside], int(inside[0]))
    return tuple(result)


def _of_stretch(position: Array, force: Array, offset: int) -> list[PopIn]:
    drops = [(step, "N") for step in found_steps(force, -1.0) if _other(position, step) > -_usual(position)]
    steps = [(step, "m") for step in found_steps(position, 1.0) if not _driven(position, force, step)]
    kept: list[tuple[Step, str]] = []
    for step, unit in sorted(drops + steps, key=lambda pair: -pair[0].ratio):
        if all(abs(step.place - other.place) > NEIGHBOURS // 2 for other, _ in kept):
            kept.append((step, unit))
    kept.sort(key=lambda pair: pair[0].place)
    return [PopIn(offset + step.place, abs(step.size), step.error, unit) for step, unit in kept]


def _other(signal: Array, step: Step) -> float:
    """Return the step of another signal at the same place, beyond its usual course."""
    size = min(NEIGHBOURS, step.place - 1, signal.size - step.place - 1)
    if size < 2:
        return 0.0
    before, behind = signal[step.place - size : step.place], signal[step.place : step.place + size]
    along = np.arange(size) - 0.5 * (size - 1)
    spread = float(along @ along)
    slope = 0.5 * float(along @ before + along @ behind) / spread
    return float(behind.mean() - before.mean()) - slope * size


def _usual(signal: Array) -> float:
    """Return a few usual changes of a signal from point to point."""
    return 3.0 * median(np.abs(np.diff(signal))) + 1e-3 * float(np.ptp(signal))


def _driven(position: Array, force: Array, step: Step) -> bool:
    """Return whether the force follows a step of the position as it does beside it: the machine jumped."""
    size = min(NEIGHBOURS, step.place - 1, position.size - step.place - 1)
    if size < 2:
        return True
    parts = [slice(step.place - size, step.place), slice(step.place, step.place + size)]
    x = np.concatenate([position[part] - position[part].mean() for part in parts])
    y = np.concatenate([force[part] - force[part].mean() for part in parts])
    stiffness = float(x @ y) / max(float(x @ x), 1e-300)
    return _other(force, step) > MOST_FORCE_SHARE * stiffness * step.size
