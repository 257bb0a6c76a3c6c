"""Fits of forces or positions of a contact on layers, of which one solid relaxes by a law of its own.

The response is that of cells whose waves remember (`winkler.fitting.layered.response`), along any history:
in, held, out, and in again.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterable
from typing import Any, Self

import numpy as np

from winkler.fitting.curves.checks import CurveOutline
from winkler.fitting.layered.response import (
    LayeredHistory,
    TooWide,
    along_path,
    relaxing_solid,
    stack_waves,
)
from winkler.fitting.task import FitTask, Prediction, moved
from winkler.fitting.viscoelastic.corners import with_corners
from winkler.fitting.viscoelastic.creep import UnderForce
from winkler.fitting.viscoelastic.motion import UnderMotion
from winkler.fitting.viscoelastic.response import ContactHistory
from winkler.fitting.viscoelastic.start import is_modulus, trials
from winkler.foundation.bed import Bed
from winkler.foundation.on_medium import OnMedium
from winkler.media.halfspace import HalfSpace
from winkler.media.relaxing.layered import ViscoelasticCoatedHalfSpace
from winkler.numerics.types import Array
from winkler.problems.normal.solve_contact import at_depth
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

__all__ = ["LayeredForce", "LayeredMotion", "refuse_stack_numbers"]

CELLS, COARSE_CELLS = 64, 32
"""Of a fit, and for the choice of its start."""
WIDENED = 1.25
"""Cells reach up to powers of it, so that one grid serves many curves."""
MOST_WIDENINGS, UNKNOWN = 60, -(10**9)
EXPLAINED = 1.5
"""Standard deviations of the noise within which a start needs no other."""
SOLID_STEP = 1e-3
"""Step of the logarithms of moduli and times."""
PLACE_STEP = 0.1
"""Central step of a contact point: forces of cells are smooth up to their width only."""
RATE_STEP = 0.01
"""Central step of a drift."""
SIZINGS, SIZED, LARGEST_SIZING = 4, 0.1, 1e3
GLASSY_POINTS = 60


def refuse_stack_numbers(bed: Bed, names: tuple[str, ...]) -> None:
    """Refuse free numbers of a bed that are not those of the one solid that relaxes."""
    solid, medium = relaxing_solid(bed), bed.medium
    assert isinstance(medium, ViscoelasticCoatedHalfSpace)
    places = [f"layers[{index}].solid" for index, layer in enumerate(medium.layers) if layer.solid is solid]
    places += [name for name in ("on", "second") if getattr(medium, name) is solid]
    own = f"bed.medium.{places[0]}."
    for name in names:
        if name.startswith("bed.") and not (name.startswith(own) and not name.endswith(".poisson")):
            raise InvalidInput(
                f"fit: '{name}' is free, but on layers that relax the moduli, times and exponents of '{own[:-1]}' can "
                "be fitted; give it a fixed value."
            )


class _CellReach:
    """How many cells a task has, and up to which power of `WIDENED` they reach; it only grows."""

    def __init__(self, cells: int) -> None:
        self.cells, self.power = cells, UNKNOWN


class _LayeredFit(FitTask):
    """What fits of forces and of positions on layers have in common."""

    settled = 1e-7
    coarse_count = 120

    @functools.cached_property
    def grid(self) -> _CellReach:
        """The cells."""
        return _CellReach(CELLS)

    @property
    def resolution(self) -> int:
        """The power of the reach of the cells."""
        return self.grid.power

    @functools.cached_property
    def coarse(self) -> Self:
        """The task on a part of the points, with fewer cells."""
        turns = np.flatnonzero(np.diff(self.curve.direction)) + 1
        stretches = np.split(np.arange(self.curve.count), turns)
        some = self.chosen(np.unique(np.concatenate([self.sample_of(stretch) for stretch in stretches])))
        some.__dict__["grid"], some.__dict__["coarse"] = _CellReach(COARSE_CELLS), some
        return some

    def explained_by(self, squares: float, coarse: Self, rough_outline: CurveOutline | None) -> bool:
        """Return whether the noise of the forces out of contact explains what is left."""
        if rough_outline is None or not np.array_equal(coarse.measured, coarse.curve.force):
            return False
        return squares <= int(np.count_nonzero(coarse.weights)) * (EXPLAINED * rough_outline.noise) ** 2

    def respond(
        self, numbers: dict[str, float], time: Array, driven: Array, given: tuple[float, float]
    ) -> LayeredHistory:
        """Return the response of the contact along a path, a d + b F over time [s]."""
        bed = self.with_numbers(numbers).bed
        solid = relaxing_solid(bed)
        if self.grid.power == UNKNOWN:
            deepest = float(np.max(driven)) if given[0] else float(np.ptp(self.curve.depth(0.0)))
            self.grid.power = _first_power(bed, deepest)
        for _ in range(MOST_WIDENINGS):
            reach = WIDENED**self.grid.power
            try:
                return along_path(stack_waves(bed, reach, self.grid.cells), solid, time, driven, given)
            except TooWide:
                if reach >= bed.rim:
                    break
                self.grid.power += 1
            except NotConverged as failed:
                raise OutsideValidity(str(failed)) from failed
        raise OutsideValidity(
            "fit: the contact reaches the rim of the body or grows without end, where layers that relax are not "
            "fitted; give bounds or starts nearer to the answer, or a profile that extends farther."
        )

    def difference(self, coordinates: Array, index: int, prediction: Prediction) -> Array:
        """Return the derivative with respect to a coordinate, of predictions by the same cells."""
        del prediction
        self.predicted(coordinates)
        name, power = self.parameters[index].name, self.grid.power
        if name.startswith("bed.medium."):
            step = self.step(coordinates, index, SOLID_STEP)
            ahead = self.prediction(moved(coordinates, index, step)).fitted
            return np.asarray((ahead - self.predicted(coordinates).fitted) / step)
        step = abs(self.step(coordinates, index, PLACE_STEP if name == "contact_point" else RATE_STEP))
        ends = [self.prediction(moved(coordinates, index, sign * step)).fitted for sign in (-1.0, 1.0)]
        if self.grid.power != power:
            ends[0] = self.prediction(moved(coordinates, index, -step)).fitted
        return np.asarray((ends[1] - ends[0]) / (2.0 * step))

    def starts(self, rough_outline: CurveOutline | None) -> Iterable[Array]:
        """Yield coordinates for some contact points, times and exponents, with moduli sized by the forces."""
        factor = 1.0
        for numbers in trials(self, rough_outline):
            coordinates, factor = _sized(self.coarse, numbers, factor)
            yield coordinates

    def relaxing_fields(self, numbers: dict[str, float], prediction: Prediction) -> dict[str, Any]:
        """Return fields of the contact: depths and radii [m]."""
        contact = prediction.contact
        return {"depth": contact.depth, "radius": np.where(prediction.touched, contact.edge, 0.0)}


class LayeredMotion(_LayeredFit, UnderMotion):  # type: ignore[misc]
    """Forces fitted along the measured motion, on layers."""

    def prediction(self, coordinates: Array) -> Prediction:
        """Return the forces [N] with baseline, drag and inertia."""
        numbers = self.numbers(coordinates)
        place = self.place(numbers)
        time, driven, measured = with_corners(self._corners, self.curve.time, self.curve.position, place)
        if not float(driven.max()) > 0.0:
            nothing = np.zeros(place.size)
            return Prediction(self.line(numbers), nothing > 0.0, ContactHistory(nothing, place, nothing))
        found = self.respond(numbers, time, driven, (1.0, self.curve.compliance))
        contact = ContactHistory(*(part[measured] for part in found))
        return Prediction(contact.force + self.line(numbers), contact.force > 0.0, contact)


class LayeredForce(_LayeredFit, UnderForce):  # type: ignore[misc]
    """Positions fitted under measured forces, on layers."""

    def prediction(self, coordinates: Array) -> Prediction:
        """Return the positions [m], before and behind the end of the approach by the same cells."""
        while True:
            power = self.grid.power
            found = super().prediction(coordinates)
            if self.grid.power == power:
                return found

    def moved(self, numbers: dict[str, float], time: Array, place: Array) -> ContactHistory:
        """Return the response to a motion [m] that only goes in."""
        return ContactHistory(*self.respond(numbers, time, place, (1.0, self.curve.compliance)))

    def loaded(self, numbers: dict[str, float], time: Array, driven: Array) -> tuple[Array, Array]:
        """Return depths [m] under forces [N], and contact radii [m]."""
        found = self.respond(numbers, time, np.maximum(driven, 0.0), (0.0, 1.0))
        return found.depth, found.radius

    def contact_compliance(self, numbers: dict[str, float], depth: Array) -> Array:
        """Return the immediate compliance of contacts [m/N]; infinite without contact."""
        deepest = float(np.max(depth))
        if not deepest > 0.0:
            return np.full(depth.shape, np.inf)
        sudden = deepest * np.linspace(0.0, 1.0, GLASSY_POINTS + 1) ** 2
        force = self.respond(numbers, np.zeros(sudden.size), sudden, (1.0, 0.0)).force
        with np.errstate(divide="ignore"):
            return np.asarray(1.0 / np.interp(depth, sudden, np.maximum(np.gradient(force, sudden), 0.0), left=0.0))


def _first_power(bed: Bed, deepest: float) -> int:
    """Return the power of the reach for contacts on a half-space of the uppermost solid."""
    assert isinstance(bed, OnMedium)
    assert isinstance(bed.medium, ViscoelasticCoatedHalfSpace)
    relaxed = bed.medium.relaxed
    alike = bed.with_medium(HalfSpace(relaxed.layers[0].solid, relaxed.second))
    _, radius = at_depth(alike, np.array([max(deepest, 1e-30)]))
    return math.ceil(math.log(min(float(radius[0]), bed.rim)) / math.log(WIDENED))


def _sized(task: FitTask, numbers: dict[str, float], factor: float) -> tuple[Array, float]:
    """Return the coordinates of parameters with moduli of the right magnitude, in the proportions of the model.

    With them comes the factor of the moduli, at which the next trial begins.
    """
    assert isinstance(task, _LayeredFit)
    moduli = [p for p in task.parameters if not p.has_start and is_modulus(task, p)]
    own = task.curve.force - task.line(numbers)
    depth = task.place(numbers) - task.curve.compliance * own
    first = {p.name: numbers[p.name] for p in moduli}
    for _ in range(SIZINGS if moduli else 0):
        numbers = numbers | {p.name: p.inside(factor * first[p.name]) for p in moduli}
        borne = task.respond(numbers, task.curve.time, depth, (1.0, 0.0)).force
        square = float(borne @ borne)
        change = float(own @ borne) / square if square > 0.0 else 1.0
        factor *= min(max(change, 1.0 / LARGEST_SIZING), LARGEST_SIZING)
        if abs(math.log(max(change, 1.0 / LARGEST_SIZING))) < SIZED:
            break
    numbers = numbers | {p.name: p.inside(factor * first[p.name]) for p in moduli}
    return np.array([p.inward(p.inside(numbers[p.name])) for p in task.parameters]), factor
