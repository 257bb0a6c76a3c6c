"""The fit of a contact with or without adhesion: its forces over the measured positions, and their derivatives.

The derivative with respect to the contact point follows from the slope of the predicted force; those with respect to
the model's own numbers are differences of two models at the same contact radii, good to five digits because both are
smooth to ten.

Start of a fit: a rough contact point, moduli and works of adhesion that match the largest and the least force.

A force is proportional to all moduli at once, a pull-off nearly so to the work of adhesion, whatever the shape; so a
few scalings give the right magnitude from any start.
"""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Iterable, Iterator
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
from winkler.fitting.elastic.film_tables import FilmTables
from winkler.fitting.elastic.model_tables import EACH_ANEW, HomogeneousTables, ModelTables
from winkler.fitting.elastic.slow_jumps import beside_jumps, missed_in_contact
from winkler.fitting.elastic.yielding import YieldingContact, rough_force, turning_depths, yielding_contact
from winkler.fitting.outcome import Fit
from winkler.fitting.parameters import number_at, unit_of
from winkler.fitting.start import contact_points
from winkler.fitting.task import FitTask, Prediction, even_weights, moved
from winkler.fitting.validity import Model, with_load
from winkler.fitting.varied import CURVE_PARAMETERS, NATURAL_BOUNDS, Parameter, parameters_of
from winkler.fitting.viscoelastic.acceleration import tip_acceleration
from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.offers import LayerStack, offers
from winkler.numerics.types import Array
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.problems.normal.indentation import Indentation
from winkler.problems.plastic.first_loading import LEAST_STIFFNESS
from winkler.problems.plastic.indentation import PlasticIndentation
from winkler.problems.plastic.yielded_response import GREATEST_POISSON, LEAST_POISSON
from winkler.values.errors import InvalidInput, OutsideValidity

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


MOST_ROUNDS = 6


def starts(task: FitTask, rough_outline: CurveOutline) -> Iterator[Array]:
    """Yield the coordinates from which a fit may begin, one for each trial contact point.

    Parameters
    ----------
    task : FitTask
        Of a contact with or without adhesion.
    rough_outline : CurveOutline
        Rough outline of the approach.
    """
    parameter = next((p for p in task.parameters if p.name == "contact_point"), None)
    origins = [0.0]
    if parameter is not None:
        origins = contact_points(task, parameter, rough_outline)[: task.tables.most_starts]
        origins = [parameter.start] if parameter.has_start else [parameter.inside(origin) for origin in origins]
    numbers = {p.name: p.start for p in task.parameters}
    for origin in dict.fromkeys(origins):
        numbers = _sized(task, rough_outline, origin, dict(numbers))
        yield np.array([p.inward(p.inside(numbers[p.name])) for p in task.parameters])


def _sized(task: FitTask, rough_outline: CurveOutline, origin: float, numbers: dict[str, float]) -> dict[str, float]:
    """Return numbers with moduli and works of the right magnitude for a contact point, changed from given ones."""
    stated = {p.name for p in task.parameters if p.has_start}
    if "contact_point" in numbers and "contact_point" not in stated:
        numbers["contact_point"] = origin
    if "baseline" in numbers and "baseline" not in stated:
        numbers["baseline"] = rough_outline.baseline
    elastic = not isinstance(task.model, PlasticIndentation)
    moduli = _named(task, stated, "Pa", ("strength",) if elastic else ("young",))
    works = _named(task, stated, "J/m^2", ())
    if moduli or works:
        _scale(task, rough_outline, numbers, moduli, works)
    return numbers


def _possible(task: FitTask, numbers: dict[str, float], works: list[str], depth: float) -> tuple[float, float]:
    """Return the force at a depth and the pull-off force, the works reduced until the theory is valid."""
    if isinstance(task.model, PlasticIndentation):
        return rough_force(lambda: task.with_numbers(numbers), depth), 0.0
    tables: ModelTables = task.tables
    known = tables.known(numbers, 0.0, depth)
    if known is not None:
        return float(known.closing(np.array([depth])).force[0]), 0.0
    for _ in range(MOST_ROUNDS if works else 0):
        try:
            return tables.rough(states_for(task.with_numbers(numbers)), depth)
        except OutsideValidity:
            numbers.update({name: 0.05 * numbers[name] for name in works})
    return tables.rough(states_for(task.with_numbers(numbers)), depth)


def _named(task: FitTask, stated: set[str], unit: str, without: tuple[str, ...]) -> list[str]:
    return [
        p.name
        for p in task.parameters
        if p.name not in stated
        and p.name not in CURVE_PARAMETERS
        and p.name.rpartition(".")[2] not in without
        and unit_of(task.model, p.name) == unit
    ]


def _scale(
    task: FitTask, rough_outline: CurveOutline, numbers: dict[str, float], moduli: list[str], works: list[str]
) -> None:
    """Multiply moduli and works until the largest force and the pull-off force match."""
    origin = numbers.get("contact_point", 0.0)
    travel = float(task.curve.position.max()) - origin
    top = max(rough_outline.top, 1e-3 * float(np.ptp(task.curve.force)))
    depth = travel - task.curve.compliance * top
    depth = depth if depth > 1e-3 * abs(travel) else 1e-3 * abs(travel) + 1e-9 * float(np.ptp(task.curve.position))
    for _ in range(MOST_ROUNDS):
        worst = 1.0
        force, loss = _possible(task, numbers, works, depth)
        if moduli:
            pull = -min(0.0, loss)
            share = float(np.clip((top + pull) / max(force + pull, 1e-6 * top), 1e-3, 1e3))
            worst = max(worst, share, 1.0 / share)
            inside = {p.name: p.inside for p in task.parameters}
            numbers.update({name: inside[name](numbers[name] * share) for name in moduli})
        if works and isinstance(task.model, AdhesiveIndentation):
            target = max(rough_outline.pull, 2.0 * rough_outline.noise, 1e-4 * top)
            pull = -loss
            share = float(np.clip(target / max(pull, 1e-6 * target), 1e-3, 1e3))
            worst = max(worst, share, 1.0 / share)
            numbers.update({name: numbers[name] * share for name in works})
        if worst < 1.2:
            return


def tables_for(model: Model, parameters: tuple[Parameter, ...]) -> ModelTables:
    """Return the tables that the predictions of a fit share.

    Parameters
    ----------
    model : Indentation or AdhesiveIndentation
    parameters : tuple of Parameter
    """
    own = [p for p in parameters if p.name not in CURVE_PARAMETERS]
    of_medium = all(p.name.startswith("bed.medium.") for p in own)
    if not isinstance(model, Indentation) or type(model.bed) is not Foundation or not of_medium:
        return EACH_ANEW
    medium, profile = model.bed.medium, model.bed.profile
    if isinstance(medium, HomogeneousMedium):
        return HomogeneousTables(model.bed)
    film = offers(medium, LayerStack)
    if film and len(own) == 1 and own[0].name.endswith(".young") and not profile.kinks:
        return FilmTables(model, own[0].name)
    return EACH_ANEW
