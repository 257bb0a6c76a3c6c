"""The fit of a contact with or without adhesion: its forces over the measured positions, and their derivatives.

The derivative with respect to the contact point follows from the slope of the predicted force; those with respect to
the model's own numbers are differences of two models at the same contact radii, good to five digits because both are
smooth to ten.
"""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Iterable
from typing import Any, Self

import numpy as np

from winkler.fitting.curves.checks import CurveOutline
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.elastic.contact import (
    DirectionRun,
    HeldContact,
    attached,
    comparable,
    held_contact,
    highest_of,
    moved_force,
    runs_of,
    states_for,
)
from winkler.fitting.elastic.slow_jumps import beside_jumps, missed_in_contact
from winkler.fitting.elastic.start import starts
from winkler.fitting.elastic.tables_for import tables_for
from winkler.fitting.elastic.yielding import YieldingContact, turning_depths, yielding_contact
from winkler.fitting.outcome import Fit
from winkler.fitting.parameters import number_at
from winkler.fitting.task import FitTask, Prediction, even_weights, moved
from winkler.fitting.validity import Model, with_load
from winkler.fitting.varied import NATURAL_BOUNDS, parameters_of
from winkler.fitting.viscoelastic.acceleration import tip_acceleration
from winkler.loading.loads import Depth
from winkler.numerics.types import Array
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.problems.plastic.first_loading import LEAST_STIFFNESS
from winkler.problems.plastic.indentation import PlasticIndentation
from winkler.problems.plastic.yielded_response import GREATEST_POISSON, LEAST_POISSON
from winkler.values.errors import InvalidInput, OutsideValidity

__all__ = ["ElasticTask", "elastic_task"]

SHIFTS = (-2.5, -1.0, 1.0, 2.5)
"""Shifts of the contact point, in standard errors, from which a fit with adhesion begins again."""
EXPLAINED_NOISE = 1.2
"""Greatest root mean square of the residuals of a start that needs no other beside it, relative to the noise."""
MISSED_LEAST = 3.0
"""Least root mean square of the residuals in contact, relative to the noise, with which they count less."""
LEAST_EXPONENT = 1e-9
"""Least exponent of a metal that hardens: it is varied itself, not its logarithm, so that none is within its reach."""
LITTLE = -3.0
"""Change of the logarithm of a work of adhesion from which it begins again."""


class ElasticTask(FitTask):
    """A contact without relaxation, with the hysteresis of its edge."""

    settled = 1e-10
    coarse_count = 200
    starts_improved = 2
    starts_are_trials = False
    most_reweightings = 4

    @property
    def size(self) -> float:
        """Norm of the forces, weighted [N]."""
        return float(np.linalg.norm(self.curve.force * self.weights))

    @functools.cached_property
    def runs(self) -> tuple[DirectionRun, ...]:
        """The parts of the curve of one direction."""
        return runs_of(self.curve)

    def starts(self, rough_outline: CurveOutline | None) -> Iterable[Array]:
        """Return coordinates for some contact points, moduli and works of adhesion of the right magnitude."""
        assert rough_outline is not None
        return starts(self, rough_outline)

    @property
    def has_one_optimum(self) -> bool:
        """Without a snap."""
        return not isinstance(self.model, AdhesiveIndentation)

    def explained_by(self, squares: float, coarse: FitTask, rough_outline: CurveOutline | None) -> bool:
        """Return whether the residuals are hardly larger than the noise out of contact, and no snap has optima."""
        if rough_outline is None or not self.has_one_optimum:
            return False
        count = max(int(np.count_nonzero(coarse.weights)) - len(self.parameters), 1)
        level = EXPLAINED_NOISE * rough_outline.noise * float(np.mean(coarse.weights))
        return bool(squares <= count * level**2)

    def restarts(self, coordinates: Array, covariance: Array) -> list[Array]:
        """Return, with adhesion, coordinates with other contact points, and with little adhesion.

        Each snap lies between two points, so that there are several optima.
        """
        if not isinstance(self.model, AdhesiveIndentation):
            return []
        found = []
        for place, parameter in enumerate(self.parameters):
            if parameter.name == "contact_point":
                along = covariance[:, place] / np.sqrt(covariance[place, place])
                found += [coordinates + shift * along for shift in SHIFTS]
            elif parameter.name.startswith("law.") and parameter.logarithmic:
                found.append(moved(coordinates, place, LITTLE))
        return found

    def reweighed(self, coordinates: Array, rough_outline: CurveOutline | None, noise: Array) -> Self | None:
        """Return, with adhesion, the task without slow jumps, then with contact weighed by what the model misses."""
        del rough_outline, noise
        if not isinstance(self.model, AdhesiveIndentation) or self.misfits is not None:
            return None
        prediction = self.prediction(coordinates)
        residuals = (self.measured - prediction.fitted) * self.weights
        kept = beside_jumps(residuals, prediction.touched, self.runs)
        if not kept.all():
            return self.chosen(np.flatnonzero(kept))
        missed = missed_in_contact(residuals, prediction.touched)
        if missed <= MISSED_LEAST:
            return None
        misfits = np.where(prediction.touched, missed, 1.0)
        return self._replace(weights=self.weights / misfits, misfits=misfits)

    def sample_of(self, stretch: Array) -> Array:
        """Return points evenly spaced."""
        count = max(3, round(self.coarse_count * stretch.size / self.curve.count))
        return np.linspace(stretch[0], stretch[-1], min(count, stretch.size)).astype(int)

    def place(self, numbers: dict[str, float]) -> Array:
        """Return D from first touch, less what the inertia of the probe bends the machine by [m]."""
        along = self.along(numbers)
        if self.acceleration is None or self.curve.compliance == 0.0:
            return along
        return np.asarray(along - self.curve.compliance * numbers.get("inertia", 0.0) * self.acceleration)

    def held(self, numbers: dict[str, float]) -> HeldContact:
        """Return the contact continued to all points."""
        place, compliance = self.place(numbers), self.curve.compliance
        known = self.tables.known(numbers, compliance, highest_of(place))
        if known is not None:
            force, slope, radius, balanced = known.closing(place)
            return HeldContact(force, slope, radius, balanced > 0.0, known, adhesive=False)
        origin = numbers.get("contact_point", 0.0)
        return held_contact(self.with_numbers(numbers), compliance, place, self.runs, origin, self.tables)

    def prediction(self, coordinates: Array) -> Prediction:
        """Return the forces [N] at coordinates."""
        numbers = self.numbers(coordinates)
        held, line = self.held(numbers), self.line(numbers)
        holds = attached(held, (self.curve.force - line) * self.weights, self.runs, self.weights)
        return Prediction(np.where(holds, held.force, 0.0) + line, holds, held)

    def slope(self, name: str, numbers: dict[str, float], prediction: Prediction) -> Any:
        """Return the derivative with respect to a number in closed form ``(n,)``, else None."""
        if name == "contact_point":
            return -np.where(prediction.touched, prediction.contact.slope, 0.0) - numbers.get("tilt", 0.0)
        if name == "inertia":
            assert self.acceleration is not None
            bent = self.curve.compliance * np.where(prediction.touched, prediction.contact.slope, 0.0)
            return self.acceleration * (1.0 - bent)
        return super().slope(name, numbers, prediction)

    def difference(self, coordinates: Array, index: int, prediction: Prediction) -> Array:
        """Return the derivative with respect to a coordinate, where possible at the same contact radii."""
        step = self.step(coordinates, index)
        numbers, holds, held = self.numbers(moved(coordinates, index, step)), prediction.touched, prediction.contact
        known = self.tables.known(numbers, self.curve.compliance, 0.0)
        if known is not None:
            return np.asarray(held.response.change(known, held) / step)
        other = self.with_numbers(numbers)
        column = np.zeros(self.curve.count)
        if np.all(held.balanced[holds]) and comparable(self.with_numbers(self.numbers(coordinates)), other):
            column[holds] = moved_force(held, other, self.curve.compliance, holds, self.tables) / step
        else:
            column[holds] = (self.held(numbers).force - held.force)[holds] / step
        return column

    def model_of(self, numbers: dict[str, float], prediction: Prediction) -> Model:
        """Return the model with its numbers, at the largest depth of the curve."""
        model: Model = self.with_numbers(numbers)
        bed, touched, held = model.bed, prediction.touched, prediction.contact
        widest = float(np.max(held.radius[touched]))
        depth = float(np.max((self.place(numbers) - self.curve.compliance * held.force)[touched]))
        beyond = widest >= bed.reach and bed.reach < bed.rim
        if beyond and depth > float(states_for(model).depth(np.array([bed.reach]))[0]):
            raise OutsideValidity(
                f"fit: the curve leads to contact radii beyond {bed.reach:.4g} m, where the profile is not "
                "defined; cut the curve off before, or give a profile that extends farther."
            )
        return with_load(model, Depth(depth))

    def outcome(self, numbers: dict[str, float], prediction: Prediction, shared: dict[str, Any]) -> Fit:
        """Return the fit."""
        radius = np.where(prediction.touched, prediction.contact.radius, 0.0)
        return Fit(**shared, radius=radius, contact=prediction.touched)


class YieldingTask(ElasticTask):
    """A contact of bodies that yield, with the memory of its greatest depths."""

    def prediction(self, coordinates: Array) -> Prediction:
        """Return the forces [N] at coordinates."""
        numbers = self.numbers(coordinates)
        compliance, place = self.curve.compliance, self.place(numbers)
        contact = yielding_contact(lambda: self.with_numbers(numbers), compliance, place, self.runs)
        return Prediction(contact.force + self.line(numbers), contact.radius > 0.0, contact)

    def slope(self, name: str, numbers: dict[str, float], prediction: Prediction) -> Any:
        """Return the derivative with respect to a number in closed form ``(n,)``, else None.

        The contact point moves the greatest depth, too, which the rest of the curve remembers.
        """
        return None if name == "contact_point" else super().slope(name, numbers, prediction)

    def difference(self, coordinates: Array, index: int, prediction: Prediction) -> Array:
        """Return the derivative with respect to a coordinate."""
        step = self.step(coordinates, index)
        return np.asarray((self.prediction(moved(coordinates, index, step)).fitted - prediction.fitted) / step)

    def model_of(self, numbers: dict[str, float], prediction: Prediction) -> PlasticIndentation:
        """Return the model with its numbers, and the depths at which the curve turns."""
        held: YieldingContact = prediction.contact
        model: PlasticIndentation = self.with_numbers(numbers)
        depth = self.place(numbers) - self.curve.compliance * held.force
        return dataclasses.replace(model, path=Depth(turning_depths(depth, self.runs)))


def elastic_task(
    curve: ForceCurve, model: Model, free: dict[str, Any], noise: Array, acceleration: Array | None = None
) -> ElasticTask:
    """Return the task of a fit.

    Parameters
    ----------
    curve : ForceCurve
        Without points of holds.
    model : Indentation, AdhesiveIndentation or PlasticIndentation
    free : dict
        Name and (low, high), or a start value, or neither (an empty tuple).
    noise : ndarray
        Standard deviation of the forces [N], ``()`` or ``(n,)``; only its course matters here; zero: uniform.
    acceleration : ndarray, (n,), optional
        Of the tip into the body [m/s^2], where the inertia of the probe is free; from the curve unless given.

    Raises
    ------
    InvalidInput
        If a path does not exist, or its bounds are inconsistent.
    """
    span, strength = float(np.ptp(curve.position)), float(np.ptp(curve.force))
    if span == 0.0 or strength == 0.0:
        raise InvalidInput(f"fit: the curve '{curve.name}' has no range of positions or forces; nothing can be fitted.")
    scales = {"contact_point": span, "baseline": strength, "tilt": strength / span}
    if "inertia" in free:
        acceleration = tip_acceleration(curve) if acceleration is None else acceleration
        scales["inertia"] = strength / (float(np.abs(acceleration).max()) or 1.0)
    zeros = np.zeros(curve.count)
    yields = isinstance(model, PlasticIndentation)
    parameters = parameters_of(model, free, scales, _yielding_bounds(model, free) if yields else NATURAL_BOUNDS)
    tables = tables_for(model, parameters)
    return (YieldingTask if yields else ElasticTask)(
        curve, model, parameters, even_weights(curve, noise), zeros, zeros, tables=tables, acceleration=acceleration
    )


def _yielding_bounds(model: Model, free: dict[str, Any]) -> dict[str, tuple[float, float]]:
    """Return the natural bounds of free numbers of bodies that yield: those of the law of yielding."""
    known = {**NATURAL_BOUNDS, "poisson": (LEAST_POISSON, GREATEST_POISSON), "exponent": (LEAST_EXPONENT, 0.5)}
    for name in free:
        if name.endswith(".strength"):
            known[name] = 0.0, number_at(model, f"{name.removesuffix('strength')}young") / LEAST_STIFFNESS
    return known
