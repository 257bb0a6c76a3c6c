"""Fit of the forces of a relaxing contact along the measured motion."""

from __future__ import annotations

import dataclasses
import functools
from typing import Any

import numpy as np

from winkler.fitting.outcome import ViscoelasticFit
from winkler.fitting.task import Prediction
from winkler.fitting.viscoelastic.corners import Corners, corners_of, with_corners
from winkler.fitting.viscoelastic.response import ContactHistory, elastic_table, forces
from winkler.fitting.viscoelastic.task import RelaxingTask
from winkler.loading.loads import Depth
from winkler.loading.path import Path
from winkler.numerics.types import Array
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.march import elastic_like, relaxation_of


class UnderMotion(RelaxingTask):
    """Forces fitted along the measured motion."""

    @functools.cached_property
    def _corners(self) -> Corners:
        """The turns of the machine between its points."""
        return corners_of(self.curve.time, self.curve.position, self.curve.direction)

    def place(self, numbers: dict[str, float]) -> Array:
        """Return D from first touch, without drift, and less what the inertia of the probe bends the machine by [m]."""
        steady = super().place(numbers)
        if self.acceleration is None or self.curve.compliance == 0.0:
            return steady
        return np.asarray(steady - self.curve.compliance * numbers.get("inertia", 0.0) * self.acceleration)

    def slope(self, name: str, numbers: dict[str, float], prediction: Prediction) -> Any:
        """Return the derivative with respect to a number in closed form ``(n,)``, else None."""
        if name == "inertia" and self.curve.compliance == 0.0:
            return self.acceleration
        return super().slope(name, numbers, prediction)

    def prediction(self, coordinates: Array) -> Prediction:
        """Return the forces [N] with baseline, drag and inertia."""
        numbers = self.numbers(coordinates)
        model, place = self.with_numbers(numbers), self.place(numbers)
        time, driven, measured = with_corners(self._corners, self.curve.time, self.curve.position, place)
        highest = float(driven.max())
        if not highest > 0.0:
            nothing = np.zeros(place.size)
            return Prediction(self.line(numbers), nothing > 0.0, ContactHistory(nothing, place, nothing))
        table = elastic_table(elastic_like(model.bed), highest)
        series = relaxation_of("fit", model.bed)
        turn = self.turn + int(np.count_nonzero(self._corners.before < self.turn))
        contact = forces(table, series, time, driven, turn, self.curve.compliance)
        contact = ContactHistory(*(part[measured] for part in contact))
        return Prediction(contact.force + self.line(numbers), contact.force > 0.0, contact)

    def model_of(self, numbers: dict[str, float], prediction: Prediction) -> ViscoelasticIndentation:
        """Return the model with its numbers, along the fitted depths."""
        path = Path(self.curve.time, Depth(prediction.contact.depth))
        model: ViscoelasticIndentation = self.with_numbers(numbers)
        return dataclasses.replace(model, path=path)

    def outcome(self, numbers: dict[str, float], prediction: Prediction, shared: dict[str, Any]) -> ViscoelasticFit:
        """Return the fit."""
        return ViscoelasticFit(**shared, **self.relaxing_fields(numbers, prediction))
