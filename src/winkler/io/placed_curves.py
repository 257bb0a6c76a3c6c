"""A curve of a file with its place on the sample, or the reason why it cannot be read."""

from __future__ import annotations

from collections.abc import Iterable

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.unloading.continuous_stiffness import ContinuousStiffness
from winkler.io.continuous_loading import StatedResults
from winkler.io.swapped_columns import swap_note
from winkler.numerics.types import Array
from winkler.values.value import value


@value
class PlacedCurve:
    """A force curve, and where on the sample it was taken.

    Parameters
    ----------
    curve : ForceCurve
    x, y : float
        Place on the sample [m]; nan where the file does not state it.
    continuous : ContinuousStiffness, optional
        The stiffness that was measured during the loading; None where the file has no such column.
    stated : StatedResults, optional
        Modulus and hardness that the instrument computed itself; None where the file has no such column.
    """

    curve: ForceCurve
    x: float
    y: float
    continuous: ContinuousStiffness | None = None
    stated: StatedResults | None = None


@value
class UnreadCurve:
    """A curve that could not be read, and why.

    Parameters
    ----------
    name : str
        The file; within a map also the number of the curve.
    reason : str
        One sentence.
    """

    name: str
    reason: str


def name_of_test(name: str, number: int, count: int) -> str:
    """Return the name of a curve, with its number where the file holds several below each other."""
    return name if count == 1 else f"{name}, test {number}"


def reading_of(maker: str, facts: Iterable[str], number: int, count: int, position: Array, force: Array) -> str:
    """Return what was taken for what in one of several tests, with a doubt where columns may be exchanged."""
    several = f"test {number} of {count} below each other" if count > 1 else ""
    return f"{maker}: " + "; ".join(fact for fact in (*facts, several, swap_note(position, force)) if fact)
