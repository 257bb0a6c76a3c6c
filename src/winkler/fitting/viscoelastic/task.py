r"""A fit of a relaxing contact as a question for least squares: what drives it, what it answers, and the derivatives.

The motion drives, :math:`D_i-D_0-u\,t_i`, and forces are fitted; or the forces drive, and the positions are fitted.  In
both the contact bears what is left of the measured force,

.. math:: F_i = F_\mathrm{contact} + F_0 + t\,(D_i-D_0) + c_v\,\dot D_i + e_i ,

without baseline, tilt, and the drag of a liquid on the cantilever.  Positions are the matter of
`winkler.fitting.viscoelastic.creep`.
"""

from __future__ import annotations

from typing import ClassVar, NamedTuple, Self

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.parameters import changed
from winkler.fitting.task import Parameter
from winkler.fitting.viscoelastic.response import Answered, elastic_table, forces
from winkler.numerics.types import Array
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.march import elastic_like, relaxation_of

__all__ = ["OF_A_TIMED_CURVE", "Driven", "Pressed", "Told"]

OF_A_TIMED_CURVE = ("contact_point", "baseline", "tilt", "drift", "drag")
"""Names of what a curve with times itself leaves open."""
STEP = 1e-5
COARSE_STEP = 1e-3
"""Step of numbers that change the number of terms of a series, whose error jumps there."""
SHAPES = ("exponent", "relaxation_time")


class Told(NamedTuple):
    """What a model says: the fitted quantity at all points ``(n,)``, and the contact behind it."""

    predicted: Array
    contact: Answered


class _Question(NamedTuple):
    """What a fit of a relaxing contact is about.

    Parameters
    ----------
    curve : ForceCurve
        In the order in which it was measured, held points included.
    model : ViscoelasticIndentation
    parameters : tuple of Parameter
    weights : ndarray, (n,)
        What residuals are multiplied with.
    velocity : ndarray, (n,)
        Of the machine [m/s].
    per_force : ndarray, (n,)
        Where positions are fitted: the position [m/N] that counts as much as a misfit of force, at points whose force
        is fitted instead; zero at all others.
    """

    curve: ForceCurve
    model: ViscoelasticIndentation
    parameters: tuple[Parameter, ...]
    weights: Array
    velocity: Array
    per_force: Array


class Driven(_Question):
    """Everything that a fit of a relaxing contact needs to know; its subclasses say what drives, and what is fitted."""

    straight: ClassVar[tuple[str, ...]] = ()
    """Names of what changes the fitted quantity in proportion."""

    @property
    def measured(self) -> Array:
        """The quantity that is fitted ``(n,)``."""
        raise NotImplementedError

    def told(self, numbers: dict[str, float]) -> Told:
        """Return what the model says."""
        raise NotImplementedError

    @property
    def turn(self) -> int:
        """The first point on the way out; n if there is none."""
        out = np.flatnonzero(self.curve.direction < 0.0)
        return int(out[0]) if out.size else self.curve.count

    def numbers(self, coordinates: Array) -> dict[str, float]:
        """Return the numbers at coordinates, by name."""
        return {p.name: p.outward(float(c)) for p, c in zip(self.parameters, coordinates, strict=True)}

    def with_numbers(self, numbers: dict[str, float]) -> ViscoelasticIndentation:
        """Return the model with its numbers."""
        own = {name: number for name, number in numbers.items() if name not in OF_A_TIMED_CURVE}
        return changed(self.model, own) if own else self.model

    def place(self, numbers: dict[str, float]) -> Array:
        """Return D from first touch, without drift [m]."""
        since = self.curve.time - self.curve.time[0]
        return np.asarray(self.curve.position - numbers.get("contact_point", 0.0) - numbers.get("drift", 0.0) * since)

    def line(self, numbers: dict[str, float]) -> Array:
        """Return the part of the force that the contact does not bear [N]."""
        along = self.curve.position - numbers.get("contact_point", 0.0)
        drag = numbers.get("drag", 0.0) * self.velocity
        return np.asarray(numbers.get("baseline", 0.0) + numbers.get("tilt", 0.0) * along + drag)

    def predicted(self, coordinates: Array) -> Array:
        """Return the fitted quantity at all points."""
        return self.told(self.numbers(coordinates)).predicted

    def residuals(self, coordinates: Array) -> Array:
        """Return the weighted misfit, measured less predicted."""
        return np.asarray((self.measured - self.predicted(coordinates)) * self.weights)

    def jacobian(self, coordinates: Array) -> Array:
        """Return the derivatives ``(n, p)`` of the prediction, weighted."""
        here = self.predicted(coordinates)
        columns = []
        for index, parameter in enumerate(self.parameters):
            if parameter.name in self.straight:
                columns.append(self._straight(parameter.name, coordinates) * parameter.scale)
                continue
            rough = parameter.name.startswith("bed.medium.") and parameter.name.rpartition(".")[2] in SHAPES
            step = COARSE_STEP if rough else STEP
            if coordinates[index] + step > parameter.inward(parameter.high):
                step = -step
            ahead = self.predicted(_moved(coordinates, index, step))
            inside = coordinates[index] - step > parameter.inward(parameter.low)
            if rough and inside:
                columns.append((ahead - self.predicted(_moved(coordinates, index, -step))) / (2.0 * step))
            else:
                columns.append((ahead - here) / step)
        return np.stack(columns, axis=1) * self.weights[:, None]

    def _straight(self, name: str, coordinates: Array) -> Array:
        match name:
            case "baseline":
                return np.ones(self.curve.count)
            case "tilt":
                return self.curve.position - self.numbers(coordinates).get("contact_point", 0.0)
            case _:
                return self.velocity

    def chosen(self, kept: Array) -> Self:
        """Return the question of some of the points, given as indices."""
        return self._replace(
            curve=self.curve.chosen(kept),
            weights=self.weights[kept],
            velocity=self.velocity[kept],
            per_force=self.per_force[kept],
        )


class Pressed(Driven):
    """The motion drives, forces are fitted."""

    straight = ("baseline", "tilt", "drag")

    @property
    def measured(self) -> Array:
        """The forces [N]."""
        return self.curve.force

    def told(self, numbers: dict[str, float]) -> Told:
        """Return the forces with everything that is not contact."""
        model, place = self.with_numbers(numbers), self.place(numbers)
        highest = float(place.max())
        if not highest > 0.0:
            nothing = np.zeros(place.size)
            return Told(self.line(numbers), Answered(nothing, place, nothing))
        table = elastic_table(elastic_like(model.bed), highest)
        series = relaxation_of("fit", model.bed)
        contact = forces(table, series, self.curve.time, place, self.turn, self.curve.compliance)
        return Told(contact.force + self.line(numbers), contact)


def _moved(coordinates: Array, index: int, step: float) -> Array:
    moved = coordinates.copy()
    moved[index] += step
    return moved
