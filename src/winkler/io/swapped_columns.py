"""Doubts about columns that were taken for each other, or for a curve.

Under a rigid tip whose section grows the force rises at least as fast as the depth, F ~ d^m with m >= 1.  Position
taken for force, and force for position, gives m <= 1: a concave loading.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput

CONCAVE = 0.58
"""Force at half of the depth over the greatest: 0.5 for a punch, 0.35 for a ball, 0.25 for a cone; swapped 0.5 to 1."""
WINDOW = 0.03
"""Half the width of the middle, relative to the travel of the loading."""
FEWEST = 10
FOLLOWS = 0.8
"""Least correlation of a number with the one of the next row in a curve."""
TO_AND_FRO, LEAP = 0.4, 0.02
"""Least part of rows of a list at which its position turns, two thirds by chance, and least mean step over its range.
"""
AGAINST = -0.2
"""Greatest correlation of force and position where one of them has the wrong sign."""
STEEP_END, END_PART = 3.0, 0.25
"""Least ratio of the changes of force at the end with the contact and at the other one, and the part of the travel that
is an end."""
DEEPEST, LEAST_PULL = 0.02, 0.5
"""Part of the travel at whose force the contact is deepest, and the least part of all forces by which that force lies
below those out of contact, where the force has the wrong sign: the tension of a sticky contact is least there."""


def swap_note(position: Array, force: Array) -> str:
    """Return a doubt, as a phrase, if the loading is concave; else an empty text.

    Parameters
    ----------
    position, force : ndarray, (n,)
        As they were read [m], [N].
    """
    top = int(np.argmax(force))
    if top < FEWEST or not np.ptp(position[: top + 1]) > 0.0:
        return ""
    x, y = position[: top + 1], force[: top + 1]
    low, high = float(x.min()), float(x[-1])
    if not high > low:
        return ""
    inside = np.abs(x - 0.5 * (low + high)) <= WINDOW * (high - low)
    first = float(np.mean(y[: 1 + y.size // 50]))
    share = (float(np.mean(y[inside])) - first) / (y[-1] - first) if np.any(inside) and y[-1] > first else 0.0
    if share <= CONCAVE:
        return ""
    return (
        f"doubtful: half of the depth carries {100 * share:.0f} % of the greatest force, and the loading is concave; "
        "position and force may be exchanged, or a bar was pulled"
    )


def is_list(position: Array, force: Array, *, results: bool = False) -> bool:
    """Return whether rows are no curve but a list, such as the results of a grid of tests: no row follows the last.

    Parameters
    ----------
    position, force : ndarray, (n,)
    results : bool, optional
        Whether a modulus or a hardness stands beside them: then a position that leaps to and fro is enough, as in a
        list with one force for a row of tests and another one for the next.
    """
    if position.size < 2 * FEWEST:
        return False
    steps = np.diff(position)
    turns = float(np.mean(steps[1:] * steps[:-1] < 0.0))
    if results and turns > TO_AND_FRO and float(np.mean(np.abs(steps))) > LEAP * float(np.ptp(position)):
        return True
    return all(_correlation(numbers[1:], numbers[:-1]) < FOLLOWS for numbers in (position, force))


def refuse_list(where: object, names: Sequence[str], first: Array, second: Array, *, results: bool = False) -> None:
    """Refuse a list of results, one row for each test, in place of a curve.

    Parameters
    ----------
    where
        The file, for messages.
    names : sequence of str
        Of both columns.
    first, second : ndarray, (n,)
    results : bool, optional
        As of `is_list`.

    Raises
    ------
    InvalidInput
    """
    if is_list(first, second, results=results):
        raise InvalidInput(
            f"{where}: its rows are no curve but a list, for '{names[0]}' and '{names[1]}' do not go on from row to "
            "row, as in a table of results, one for each test; give the curves themselves."
        )


def signs(position: Array, force: Array) -> tuple[float, float, str]:
    """Return the signs by which position and force grow as a contact is pressed, and what was changed, as a phrase.

    Programs write the height of a piezo, which falls as the tip approaches, or compression as a negative force.  Both
    give a force that falls with the position; the end of the travel where the force changes is that of the contact.

    Parameters
    ----------
    position, force : ndarray, (n,)
        As they were read [m], [N].
    """
    against = _correlation(position, force) if position.size > FEWEST else 1.0
    if not against < 0.0:
        return 1.0, 1.0, ""
    low, span = float(position.min()), float(np.ptp(position))
    ends = position <= low + END_PART * span, position >= low + (1.0 - END_PART) * span
    if min(map(np.count_nonzero, ends)) < FEWEST:  # a quarter of the points in place of one of the travel
        quarters = np.quantile(position, (END_PART, 1.0 - END_PART))
        ends = position <= quarters[0], position >= quarters[1]
    if min(map(np.count_nonzero, ends)) < FEWEST:
        return 1.0, 1.0, ""
    at_low, at_high = (float(np.ptp(np.quantile(force[end], (0.02, 0.98)))) for end in ends)
    push = float(np.mean(force[position <= low + DEEPEST * span]) - np.median(force[ends[1]]))
    if at_low > STEEP_END * at_high and (against < AGAINST or push > LEAST_PULL * float(np.ptp(force))):
        return -1.0, 1.0, "the force rises as the position falls, whose sign is changed"
    pull = float(np.median(force[ends[0]]) - np.mean(force[position >= low + (1.0 - DEEPEST) * span]))
    if at_high > STEEP_END * at_low and against < AGAINST and pull > LEAST_PULL * float(np.ptp(force)):
        return 1.0, -1.0, "the contact is pressed by negative forces, whose sign is changed"
    return 1.0, 1.0, ""


def is_reversed(position: Array, force: Array) -> bool:
    """Return whether the force rises as the position falls, as over the gap of a rheometer."""
    return position.size > FEWEST and _correlation(position, force) < AGAINST


def _correlation(x: Array, y: Array) -> float:
    """Return the correlation of two rows of numbers; 1 where one is constant."""
    x, y = x - x.mean(), y - y.mean()
    size = float(np.sqrt(np.sum(x * x) * np.sum(y * y)))
    return float(np.sum(x * y)) / size if size > 0.0 else 1.0
