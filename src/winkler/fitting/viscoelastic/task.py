r"""The fit of a relaxing contact: common part of fits of forces and of positions.

Forces are fitted along the motion :math:`D_i-D_0-u\,t_i` (`winkler.fitting.viscoelastic.motion`), or positions under
the measured forces (`winkler.fitting.viscoelastic.creep`).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from winkler.fitting.curves.checks import CurveOutline, Flag
from winkler.fitting.parameters import each
from winkler.fitting.task import DIFFERENCE_STEP, FitTask, Prediction, moved
from winkler.fitting.viscoelastic.doubts import unidentified
from winkler.fitting.viscoelastic.response import elastic_table
from winkler.fitting.viscoelastic.start import starts
from winkler.numerics.types import Array
from winkler.problems.viscoelastic.march import elastic_like

__all__ = ["RelaxingTask"]

COARSE_STEP = 1e-3
"""Step of parameters that change the number of terms of a series, whose error is then discontinuous."""
ROUGH_NUMBERS = ("exponent", "relaxation_time")


class RelaxingTask(FitTask):
    """A relaxing contact, including holds; subclasses define the input and the fitted quantity."""

    settled = 1e-9
    coarse_count = 250
    starts_improved = 3
    starts_are_trials = True

    @property
    def size(self) -> float:
        """Weighted norm of the measured quantity about its mean."""
        measured = self.measured * self.weights
        return float(np.linalg.norm(measured - measured.mean()))

    def difference(self, coordinates: Array, index: int, prediction: Prediction) -> Array:
        """Return the derivative with respect to a coordinate, central where the number of terms may change."""
        parameter = self.parameters[index]
        rough = parameter.name.startswith("bed.medium.") and parameter.name.rpartition(".")[2] in ROUGH_NUMBERS
        step = self.step(coordinates, index, COARSE_STEP if rough else DIFFERENCE_STEP)
        ahead = self.prediction(moved(coordinates, index, step)).fitted
        if rough and coordinates[index] - step > parameter.inward(parameter.low):
            behind = self.prediction(moved(coordinates, index, -step)).fitted
            return np.asarray((ahead - behind) / (2.0 * step))
        return np.asarray((ahead - prediction.fitted) / step)

    def sample_of(self, stretch: Array) -> Array:
        """Return evenly spaced points, and more at the start of a hold or a retraction and at the deepest contact."""
        stretches = 1 + int(np.count_nonzero(np.diff(self.curve.direction)))
        share = max(self.coarse_count // (2 * stretches), 10)
        last = stretch.size - 1
        near = np.geomspace(1.0, max(last, 1), min(share, stretch.size)) - 1.0  # fast relaxation occurs at once
        dense = last - near if self.curve.direction[stretch[0]] > 0.0 else near
        even = np.linspace(0, last, min(share, stretch.size))
        return np.asarray(stretch[np.concatenate([even, dense]).astype(int)])

    def starts(self, rough_outline: CurveOutline | None) -> Iterable[Array]:
        """Yield coordinates for some contact points, times and exponents, moduli by linear least squares."""
        return starts(self, rough_outline)

    def doubts(self, numbers: dict[str, float], errors: Array) -> list[Flag]:
        """Return the doubts about the solid."""
        return unidentified(self, numbers, dict(zip(numbers, errors.tolist(), strict=True)))

    def final(self, coordinates: Array) -> Array:
        """Return coordinates with terms sorted by their times, if only their order changes."""
        rows: dict[str, list[int]] = {}
        for index, parameter in enumerate(self.parameters):
            if parameter.name.endswith("]"):
                rows.setdefault(parameter.name.rpartition("[")[0], []).append(index)
        ordered = coordinates.copy()
        for name, places in rows.items():
            partner = name.replace("relaxation_times", "shears").replace("retardation_times", "compliances")
            if partner == name or len(rows.get(partner, ())) != len(places):
                continue
            interchangeable = all(len({self.parameters[i][1:3] for i in row}) == 1 for row in (places, rows[partner]))
            if interchangeable and len(places) == len(each(self.model, name)):
                turn = np.argsort(coordinates[places])
                for row in (places, rows[partner]):
                    ordered[row] = coordinates[row][turn]
        return coordinates if np.array_equal(ordered, coordinates) else ordered

    def relaxing_fields(self, numbers: dict[str, float], prediction: Prediction) -> dict[str, Any]:
        """Return fields of the contact: depths and radii [m]."""
        contact = prediction.contact
        table = elastic_table(elastic_like(self.with_numbers(numbers).bed), float(contact.edge.max()))
        return {
            "depth": contact.depth,
            "radius": np.where(prediction.touched, table.radius_at(contact.edge), 0.0),
        }
