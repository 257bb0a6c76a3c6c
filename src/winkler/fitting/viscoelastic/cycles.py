"""Fit of the forces of a relaxing contact that is loaded and unloaded again and again, by rows of springs.

Ting's rule in closed form serves one loading and its unloading; during a second loading the contact remembers every
turn before.  Springs that detach, recover and are touched again carry that memory by themselves.
"""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.task import Prediction
from winkler.fitting.viscoelastic.motion import UnderMotion
from winkler.fitting.viscoelastic.response import ContactHistory, elastic_table
from winkler.loading.loads import Depth
from winkler.loading.path import Path
from winkler.numerics.types import Array
from winkler.problems.viscoelastic.march import elastic_like

__all__ = ["UnderCycles", "goes_in_again"]

SPRINGS = 300
CENTRAL_STEP = 1e-3
"""Step of differences: forces of springs are smooth up to their number only."""


def goes_in_again(curve: ForceCurve) -> bool:
    """Return whether a curve moves in after a retraction."""
    out = np.flatnonzero(curve.direction < 0.0)
    return bool(out.size and np.any(curve.direction[out[0] :] > 0.0))


class UnderCycles(UnderMotion):
    """Forces fitted along the measured depth of several cycles."""

    def prediction(self, coordinates: Array) -> Prediction:
        """Return the forces [N] with baseline, drag and inertia."""
        numbers = self.numbers(coordinates)
        line = self.line(numbers)
        depth = self.place(numbers) - self.curve.compliance * (self.curve.force - line)
        nothing = np.zeros(depth.size)
        if not float(depth.max()) > 0.0:
            return Prediction(line, nothing > 0.0, ContactHistory(nothing, depth, nothing))
        path = Path(self.curve.time - self.curve.time[0], Depth(depth))
        model = dataclasses.replace(self.with_numbers(numbers), path=path, count=SPRINGS)
        found = model.solve()
        table = elastic_table(elastic_like(model.bed), float(depth.max()))
        wide = np.interp(found.radius, table.radius, table.deepest * np.linspace(0.0, 1.0, table.radius.size) ** 2)
        return Prediction(found.force + line, found.force > 0.0, ContactHistory(found.force, depth, wide))

    def difference(self, coordinates: Array, index: int, prediction: Prediction) -> Array:
        """Return the derivative with respect to a coordinate, by central differences."""
        del prediction
        step = self.step(coordinates, index, CENTRAL_STEP)
        ahead, behind = coordinates.copy(), coordinates.copy()
        ahead[index] += step
        behind[index] -= step
        return np.asarray((self.prediction(ahead).fitted - self.prediction(behind).fitted) / (2.0 * step))
