"""Doubts about columns that were taken for each other, or for a curve.

Under a rigid tip whose section grows the force rises at least as fast as the depth, F ~ d^m with m >= 1.  Position
taken for force, and force for position, gives m <= 1: a concave loading.
"""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array

__all__ = ["is_list", "is_reversed", "swap_note"]

CONCAVE = 0.58
"""Force at half of the depth over the greatest: 0.5 for a punch, 0.35 for a ball, 0.25 for a cone; swapped 0.5 to 1."""
WINDOW = 0.03
"""Half the width of the middle, relative to the travel of the loading."""
FEWEST = 10
FOLLOWS = 0.8
"""Least correlation of a number with the one of the next row in a curve."""
AGAINST = -0.2
"""Greatest correlation of force and position where one of them has the wrong sign."""


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
        f"doubtful: half of the depth bears {100 * share:.0f} % of the greatest force, and the loading is concave; "
        "position and force may be exchanged"
    )


def is_list(position: Array, force: Array) -> bool:
    """Return whether rows are no curve but a list, such as the results of a grid of tests: no row follows the last."""
    if position.size < 2 * FEWEST:
        return False
    return all(_correlation(numbers[1:], numbers[:-1]) < FOLLOWS for numbers in (position, force))


def is_reversed(position: Array, force: Array) -> bool:
    """Return whether the force rises as the position falls, as over the gap of a rheometer."""
    return position.size > FEWEST and _correlation(position, force) < AGAINST


def _correlation(x: Array, y: Array) -> float:
    """Return the correlation of two rows of numbers; 1 where one is constant."""
    x, y = x - x.mean(), y - y.mean()
    size = float(np.sqrt(np.sum(x * x) * np.sum(y * y)))
    return float(np.sum(x * y)) / size if size > 0.0 else 1.0
