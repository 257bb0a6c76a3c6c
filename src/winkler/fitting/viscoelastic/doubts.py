"""Doubts about a fitted relaxing solid: times outside the observed range, coinciding terms.

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
from collections.abc import Iterator

import numpy as np

from winkler.fitting.curves.checks import Flag
from winkler.fitting.curves.corrections import drag_force, free_line
from winkler.fitting.task import FitTask
from winkler.fitting.viscoelastic.start import TIMES, field_name, window
from winkler.media.offers import offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.values.errors import InvalidInput

__all__ = ["unidentified"]

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
