"""Setup of the fit of a relaxing contact: free parameters, input, and weights.

Fit of the forces of a relaxing contact that is loaded and unloaded again and again, by rows of springs.

Ting's rule in closed form serves one loading and its unloading; during a second loading the contact remembers every
turn before.  Springs that detach, recover and are touched again carry that memory by themselves.

Fits of forces or positions of a contact on layers, of which one solid relaxes by a law of its own.

The response is that of cells whose waves remember (`winkler.fitting.layered.response`), along any history:
in, held, out, and in again.
"""

from __future__ import annotations

import dataclasses
import functools
import math
from collections.abc import Iterable
from typing import Any, Self

import numpy as np

from winkler.fitting.curves.checks import CurveOutline, Flag, outline, refuse
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.outline import FEWEST
from winkler.fitting.layered.response import (
    LayeredHistory,
    TooWide,
    along_path,
    relaxing_solid,
    stack_waves,
)
from winkler.fitting.parameters import each
from winkler.fitting.task import FitTask, Prediction, even_weights, moved
from winkler.fitting.varied import NATURAL_BOUNDS, parameters_of
from winkler.fitting.viscoelastic.acceleration import tip_acceleration
from winkler.fitting.viscoelastic.corners import with_corners
from winkler.fitting.viscoelastic.creep import FORCE_FIT_SHARE, LEAST_NOISE, UnderForce
from winkler.fitting.viscoelastic.motion import UnderMotion
from winkler.fitting.viscoelastic.response import ContactHistory, elastic_table
from winkler.fitting.viscoelastic.start import is_modulus, trials
from winkler.fitting.viscoelastic.task import RelaxingTask
from winkler.foundation.bed import Bed
from winkler.foundation.on_medium import OnMedium
from winkler.loading.loads import Depth
from winkler.loading.path import Path
from winkler.media.halfspace import HalfSpace
from winkler.media.relaxing.layered import ViscoelasticCoatedHalfSpace
from winkler.numerics.types import Array
from winkler.problems.normal.solve_contact import at_depth
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.march import elastic_like
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

STEADY_CHANGE = 0.05
"""Greatest relative change of a constant force."""
EXPONENT_BOUNDS = (1e-3, 0.999)
"""Bounds of the exponent of a solid."""
SMOOTHING_DIVISOR = 100
"""The velocity is smoothed over this part of the points."""
SOFT_SHARE = 0.2
"""Greatest deflection of the machine relative to its travel with which repeated cycles are fitted."""
SIGNAL_TO_NOISE = 5.0
"""Least force over its noise from which on positions are fitted."""


def examined_stroke(curve: ForceCurve) -> tuple[CurveOutline | None, tuple[Flag, ...]]:
    """Return the rough outline of the approach, if there is one, and its flags.

    Raises
    ------
    InvalidInput
        If the curve has no times, begins with the retraction, or is refused (see `winkler.fitting.curves.checks`).
    """
    if not curve.timed:
        raise InvalidInput(f"fit: curve '{curve.name}' has no times, and a solid that relaxes needs them.")
    rough_outline = curve.direction[np.concatenate([[True], np.diff(curve.direction) != 0.0])]
    out = np.flatnonzero(rough_outline < 0.0)
    if out.size and out[0] == 0:
        raise InvalidInput(
            f"fit: curve '{curve.name}' begins with the retraction; fit an approach, with what follows it."
        )
    first_out = np.flatnonzero(curve.direction < 0.0)
    inward = curve.direction > 0.0
    if first_out.size:
        inward[first_out[0] :] = False  # of repeated cycles the first approach
    if np.count_nonzero(inward) < FEWEST:
        return None, ()
    force = curve.force[inward]
    if np.ptp(force) < STEADY_CHANGE * np.abs(force).max():  # a constant weight
        return None, ()
    approach = curve.chosen(inward)
    flags = refuse(approach, but=("saturated",))  # a constant force is not a saturated detector
    return outline(approach), flags


def _velocity(curve: ForceCurve) -> Array:
    """Return the velocity of the machine [m/s], smoothed within each part of one direction, zero during holds."""
    velocity = np.zeros(curve.count)
    turns = np.flatnonzero(np.diff(curve.direction)) + 1
    for stretch in np.split(np.arange(curve.count), turns):
        time, position = curve.time[stretch], curve.position[stretch]
        if curve.direction[stretch[0]] == 0.0 or stretch.size < 3 or not np.all(np.diff(time) > 0.0):
            continue
        wide = max(1, stretch.size // SMOOTHING_DIVISOR)
        high = np.minimum(np.arange(stretch.size) + wide, stretch.size - 1)
        low = np.maximum(np.arange(stretch.size) - wide, 0)
        velocity[stretch] = (position[high] - position[low]) / (time[high] - time[low])
    return velocity


def driven_task(
    curve: ForceCurve,
    model: ViscoelasticIndentation,
    free: dict[str, Any],
    noise: Array,
    rough_outline: CurveOutline | None,
) -> RelaxingTask:
    """Return the task of a fit.

    Parameters
    ----------
    curve : ForceCurve
        With times: an approach, holds, retractions, and further cycles.
    model : ViscoelasticIndentation
        Its path is a placeholder: of depths for a fit of forces; of forces for a fit of positions.
    free : dict
        As for `winkler.fitting.elastic.task.elastic_task`; the name of an array means each of its numbers.
    noise : ndarray
        Standard deviation of the fitted quantity, ``()`` or ``(n,)``; zero if unknown.
    rough_outline : CurveOutline or None
        Rough outline of the approach; None without an approach.

    Raises
    ------
    InvalidInput
        If a path does not exist, its bounds are inconsistent, or a retraction is to be fitted under forces.
    """
    strength = float(np.ptp(curve.force))
    span = float(np.ptp(curve.position)) or float(np.abs(curve.position).max())
    duration = float(np.ptp(curve.time))
    if not (strength > 0.0 or span > 0.0) or not duration > 0.0:
        raise InvalidInput(f"fit: the curve '{curve.name}' has no range of forces or times; nothing can be fitted.")
    strength = strength or float(np.abs(curve.force).max())
    velocity = _velocity(curve)
    fastest = float(np.abs(velocity).max()) or span / duration
    scales = {
        "contact_point": 0.1 * span,
        "baseline": strength,
        "tilt": strength / span,
        "drift": span / duration,
        "drag": strength / fastest,
        "inertia": 1.0,
    }
    free_paths = {
        path: stated for name, stated in free.items() for path in (each(model, name) if "." in name else (name,))
    }
    acceleration = tip_acceleration(curve) if "inertia" in free_paths else None
    if acceleration is not None:
        scales["inertia"] = strength / (float(np.abs(acceleration).max()) or 1.0)
    weights = even_weights(curve, noise)
    exponents = {
        name: EXPONENT_BOUNDS for name in free_paths if name.startswith("bed.medium.") and name.endswith(".exponent")
    }
    parameters = parameters_of(model, free_paths, scales, NATURAL_BOUNDS | exponents)
    zeros = np.zeros(curve.count)
    layered = isinstance(model.bed.medium, ViscoelasticCoatedHalfSpace)
    if layered:
        refuse_stack_numbers(model.bed, tuple(parameter.name for parameter in parameters))
    if isinstance(model.path.normal, Depth) and goes_in_again(curve) and not layered:
        bent = curve.compliance * strength
        if bent > SOFT_SHARE * span:
            raise InvalidInput(
                f"fit: curve '{curve.name}' goes in again, and the machine bends by {bent:.3g} m of {span:.3g} "
                f"m; cycles "
                "are fitted along the measured depth of a stiff machine only: fit one approach and its retraction."
            )
        return UnderCycles(curve, model, parameters, weights, velocity, zeros, acceleration=acceleration)
    if isinstance(model.path.normal, Depth):
        along = LayeredMotion if layered else UnderMotion
        return along(curve, model, parameters, weights, velocity, zeros, acceleration=acceleration)
    if acceleration is not None:
        raise InvalidInput(
            "fit: 'inertia' acts on the force, and here positions are fitted; leave it out, or fit forces."
        )
    if np.any(curve.direction < 0.0):
        raise InvalidInput(
            "fit: positions follow from forces only while a contact grows; leave out the retraction, or fit forces."
        )
    under = LayeredForce if layered else UnderForce
    task = under(curve, model, parameters, weights, velocity, zeros)
    return task if rough_outline is None else _with_approach(task, rough_outline, noise)


def _with_approach(task: UnderForce, rough_outline: CurveOutline, noise: Array) -> UnderForce:
    """Return the task with forces fitted at small loads, with approximate weights."""
    curve = task.curve
    borne = curve.force - rough_outline.baseline
    little = borne < max(FORCE_FIT_SHARE * float(borne.max()), SIGNAL_TO_NOISE * rough_outline.noise)
    many = np.count_nonzero(little[: 1 + int(np.argmax(borne))])  # their number, independent of their noise
    early = np.arange(curve.count) < many
    late = np.flatnonzero(~early)
    rough = np.abs(np.diff(curve.position[late], 2)) if late.size > 2 else np.zeros(1)
    own = float(np.mean(noise)) or float(np.median(rough)) / (0.6745 * np.sqrt(6.0))
    own = max(own, LEAST_NOISE * float(np.ptp(curve.position)))
    of_force = max(rough_outline.noise, LEAST_NOISE * float(np.ptp(curve.force)))
    return task._replace(weights=np.where(early, 1.0, task.weights), per_force=np.where(early, own / of_force, 0.0))


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
                f"fit: '{name}' is free, but on viscoelastic layers the moduli, times and exponents of "
                f"'{own[:-1]}' can be fitted; give it a fixed value."
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
            "fit: the contact reaches the rim of the body or grows without end, where viscoelastic layers are "
            "not fitted; give bounds or starts nearer to the answer, or a profile that extends farther."
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
