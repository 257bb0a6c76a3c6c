r"""The fit of a relaxing contact: common part of fits of forces and of positions.

Forces are fitted along the motion :math:`D_i-D_0-u\,t_i` (`winkler.fitting.viscoelastic.motion`), or positions under
the measured forces (`winkler.fitting.viscoelastic.creep`).

Doubts about a fitted relaxing solid: times outside the observed range, coinciding terms.

too_slow, too_fast
    A time is longer than the observed contact, or shorter than the sampling.
collapsed
    Two times cannot be distinguished; fewer terms suffice.
vanished
    A term is negligible.
span
    The series of a power law does not cover the measured times.
drag
    Approach and retraction differ out of contact: the drag of a liquid, without a free parameter for it.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from winkler.fitting.curves.checks import CurveOutline, Flag
from winkler.fitting.curves.corrections import drag_force, free_line
from winkler.fitting.parameters import each
from winkler.fitting.task import DIFFERENCE_STEP, FitTask, Prediction, moved
from winkler.fitting.viscoelastic.response import elastic_table
from winkler.fitting.viscoelastic.start import TIMES, field_name, starts, window
from winkler.media.offers import offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.types import Array
from winkler.problems.viscoelastic.march import elastic_like
from winkler.values.errors import InvalidInput

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


LEAST_TIME_RATIO = 1.5
"""Least ratio of distinct times."""
LEAST_TERM_SHARE = 5e-3
"""Least modulus of a term relative to the sum."""
SIGNAL_TO_NOISE = 3.0
FEWEST_POINTS = 10
LEAST_DRAG_SHARE = 1e-3
"""Least drag relative to the range of forces."""


def unidentified(task: FitTask, numbers: dict[str, float], errors: dict[str, float]) -> list[Flag]:
    """Return the doubts about the fitted solid.

    Parameters
    ----------
    task : FitTask
    numbers, errors : dict of str to float
        The fitted numbers, and their standard errors.
    """
    found = (_outside(task, numbers), _together(numbers, errors), _vanished(numbers), _span(task, numbers))
    return [*itertools.chain(*found, _drag(task, numbers))]


def _times(numbers: dict[str, float]) -> dict[str, float]:
    return {name: n for name, n in numbers.items() if field_name(name) in TIMES}


def _outside(task: FitTask, numbers: dict[str, float]) -> Iterator[Flag]:
    sampling, contact_time = window(task)
    for name, time in _times(numbers).items():
        if time > contact_time:
            yield Flag(
                "too_slow",
                f"{name} is {time:.3g} s, but the contact was observed for {contact_time:.3g} s only: its time and "
                "modulus are uncertain, and what relaxes later is counted as elastic.",
            )
        elif time < sampling:
            yield Flag(
                "too_fast",
                f"{name} is {time:.3g} s, shorter than the {sampling:.3g} s between two points: only the product "
                "of time and modulus, a viscosity, is determined.",
            )


def _together(numbers: dict[str, float], errors: dict[str, float]) -> Iterator[Flag]:
    rows = sorted(((n, name) for name, n in _times(numbers).items() if name.endswith("]")))
    for (short, first), (long, second) in itertools.pairwise(rows):
        error = 2.0 * math.hypot(errors[first] / short, errors[second] / long)
        if math.log(long / short) < max(math.log(LEAST_TIME_RATIO), error):
            yield Flag(
                "collapsed",
                f"{first} and {second} are {short:.3g} s and {long:.3g} s, one time within their errors; use one "
                "term fewer.",
            )


def _vanished(numbers: dict[str, float]) -> Iterator[Flag]:
    moduli = {name: n for name, n in numbers.items() if name.rpartition(".")[2].startswith("shears[")}
    whole = sum(moduli.values())
    for name, n in moduli.items():
        if n < LEAST_TERM_SHARE * whole:
            yield Flag("vanished", f"{name} is {n / whole:.2g} of their sum; use one term fewer.")


def _span(task: FitTask, numbers: dict[str, float]) -> Iterator[Flag]:
    medium = task.with_numbers(numbers).bed.medium
    assert offers(medium, RelaxingMedium)
    shortest, longest = medium.span
    sampling, contact_time = window(task)
    if shortest != 0.0 and (shortest > sampling or longest < contact_time):
        yield Flag(
            "span",
            f"The solid is defined between {shortest:.3g} s and {longest:.3g} s, the curve covers {sampling:.3g} s to "
            f"{contact_time:.3g} s; widen shortest and longest.",
        )


def _drag(task: FitTask, numbers: dict[str, float]) -> Iterator[Flag]:
    curve = task.curve
    has_direction = [np.count_nonzero(curve.direction == direction) >= FEWEST_POINTS for direction in (1.0, -1.0)]
    if "drag" in numbers or not all(has_direction):
        return
    try:
        half, noise = drag_force(curve), free_line(curve.approach).noise
    except InvalidInput:  # too few free points
        return
    least = SIGNAL_TO_NOISE * noise / math.sqrt(FEWEST_POINTS), LEAST_DRAG_SHARE * float(np.ptp(curve.force))
    if abs(half) >= max(least):
        yield Flag(
            "drag",
            f"Out of contact approach and retraction differ by {2.0 * half:.3g} N, the drag of a liquid; free drag, or "
            "correct it.",
        )
