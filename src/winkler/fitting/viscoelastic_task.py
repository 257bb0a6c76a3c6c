r"""A fit of a relaxing contact as a question for least squares: what drives it, what it answers, and the derivatives.

The motion drives, :math:`D_i-D_0-u\,t_i`, and forces are fitted; or the forces drive, and the positions are fitted.  In
both the contact bears what is left of the measured force,

.. math:: F_i = F_\mathrm{contact} + F_0 + t\,(D_i-D_0) + c_v\,\dot D_i + e_i ,

without baseline, tilt, and the drag of a liquid on the cantilever.
"""

from __future__ import annotations

from typing import Any, ClassVar, NamedTuple

import numpy as np

from winkler.errors import InvalidInput, OutsideValidity
from winkler.fitting.curve import ForceCurve
from winkler.fitting.parameters import changed, each
from winkler.fitting.task import FREELY, Parameter, asked
from winkler.fitting.viscoelastic_response import Answered, elastic_table, forces, positions
from winkler.loading import Depth
from winkler.media.relaxing import RelaxingMedium
from winkler.numerics.types import Array
from winkler.problems.viscoelastic import ViscoelasticIndentation
from winkler.problems.viscoelastic_march import elastic_like, relaxation_of

__all__ = ["OF_A_TIMED_CURVE", "Driven", "Pressed", "Told", "Under", "driven_task"]

OF_A_TIMED_CURVE = ("contact_point", "baseline", "tilt", "drift", "drag")
"""Names of what a curve with times itself leaves open."""
ALPHA = (1e-3, 0.999)
"""Bounds of the exponent of a solid."""
STEP = 1e-5
COARSE_STEP = 1e-3
"""Step of numbers that change the number of terms of a series, whose error jumps there."""
SHAPES = ("exponent", "relaxation_time")
SMOOTH = 100
"""The velocity is smoothed over this part of the points."""
SHARE = 0.1
"""Part of the greatest force from which on positions are fitted; below it they say little about the depth."""


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
        What residuals are multiplied with; zero where a point only drives.
    velocity : ndarray, (n,)
        Of the machine [m/s].
    """

    curve: ForceCurve
    model: ViscoelasticIndentation
    parameters: tuple[Parameter, ...]
    weights: Array
    velocity: Array


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

    def chosen(self, kept: Array) -> Driven:
        """Return the question of some of the points, given as indices."""
        return self._replace(curve=self.curve.chosen(kept), weights=self.weights[kept], velocity=self.velocity[kept])


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


class Under(Driven):
    """The forces drive, positions are fitted."""

    @property
    def measured(self) -> Array:
        """The positions [m]."""
        return self.curve.position

    def told(self, numbers: dict[str, float]) -> Told:
        """Return the positions with drift and the way the machine gives."""
        model = self.with_numbers(numbers)
        medium = model.bed.medium
        assert isinstance(medium, RelaxingMedium)
        borne = self.curve.force - self.line(numbers)
        travel = float(np.ptp(self.curve.position)) + float(np.max(np.abs(self.curve.depth(0.0))) * 1e-12)
        table = elastic_table(elastic_like(model.bed), 2.0 * travel)
        depth = positions(table, medium.creep, self.curve.time, borne)
        if not np.all(np.isfinite(depth)):
            raise OutsideValidity(
                "fit: the solid sinks in farther than twice the way of the machine; give bounds or starts nearer to "
                "the answer."
            )
        since = self.curve.time - self.curve.time[0]
        beyond = numbers.get("contact_point", 0.0) + numbers.get("drift", 0.0) * since
        return Told(beyond + depth + self.curve.compliance * borne, Answered(borne, depth, depth))


def _moved(coordinates: Array, index: int, step: float) -> Array:
    moved = coordinates.copy()
    moved[index] += step
    return moved


def _velocity(curve: ForceCurve) -> Array:
    """Return the velocity of the machine [m/s], smoothed within each stretch of one direction, zero while held."""
    velocity = np.zeros(curve.count)
    turns = np.flatnonzero(np.diff(curve.direction)) + 1
    for stretch in np.split(np.arange(curve.count), turns):
        time, position = curve.time[stretch], curve.position[stretch]
        if curve.direction[stretch[0]] == 0.0 or stretch.size < 3 or not np.all(np.diff(time) > 0.0):
            continue
        wide = max(1, stretch.size // SMOOTH)
        high = np.minimum(np.arange(stretch.size) + wide, stretch.size - 1)
        low = np.maximum(np.arange(stretch.size) - wide, 0)
        velocity[stretch] = (position[high] - position[low]) / (time[high] - time[low])
    return velocity


def driven_task(
    curve: ForceCurve, model: ViscoelasticIndentation, free: dict[str, Any], noise: Array, *, baseline: float
) -> Driven:
    """Return a fit as a task.

    Parameters
    ----------
    curve : ForceCurve
        With times, one way in, held or not, and at most one way out.
    model : ViscoelasticIndentation
        Its path is only a placeholder: of depths, and forces are fitted; of forces, and positions are.
    free : dict
        As for `winkler.fitting.task.task`; the name of a row means each of its numbers.
    noise : ndarray
        Standard deviation of what is fitted, ``()`` or ``(n,)``; only its course matters here.
    baseline : float
        Roughly the force out of contact [N].

    Raises
    ------
    InvalidInput
        If a name leads nowhere, its bounds contradict themselves, or the way out is to be told from forces.
    """
    if not free:
        raise InvalidInput("fit: nothing is free; name at least one number, as 'bed.medium.first.relaxed_shear'.")
    strength = float(np.ptp(curve.force))
    span = float(np.ptp(curve.position)) or float(np.abs(curve.position).max())
    lasting = float(np.ptp(curve.time))
    if not (strength > 0.0 or span > 0.0) or not lasting > 0.0:
        raise InvalidInput(f"fit: the curve '{curve.name}' has no range of forces or times; nothing can be fitted.")
    strength = strength or float(np.abs(curve.force).max())
    velocity = _velocity(curve)
    fastest = float(np.abs(velocity).max()) or span / lasting
    scales = {
        "contact_point": 0.1 * span,
        "baseline": strength,
        "tilt": strength / span,
        "drift": span / lasting,
        "drag": strength / fastest,
    }
    wanted = {path: given for name, given in free.items() for path in (each(model, name) if "." in name else (name,))}
    weights = np.array(np.broadcast_to(np.mean(noise) / noise, curve.position.shape))
    exponents = {name: ALPHA for name in wanted if name.startswith("bed.medium.") and name.endswith(".exponent")}
    parameters = asked(model, wanted, scales, FREELY | exponents)
    if isinstance(model.path.normal, Depth):
        return Pressed(curve, model, parameters, weights, velocity)
    if np.any(curve.direction < 0.0):
        raise InvalidInput(
            "fit: forces drive a contact only while it grows; leave out the points that come out, or fit forces."
        )
    borne = curve.force - baseline
    weights[(curve.direction > 0.0) & (borne < SHARE * float(borne.max()))] = 0.0
    return Under(curve, model, parameters, weights, velocity)
