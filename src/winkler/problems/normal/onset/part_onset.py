"""The loads at which each body, layer and base begins to yield, and what is stated of them."""

from __future__ import annotations

import math
from collections.abc import Sequence

from winkler.values.readable import with_unit
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

MISES = "R. von Mises, Nachr. Ges. Wiss. Goettingen (1913) 582"
PART = ("", "", "number of the part that has a strength, from the surface of the first body down")
NAME = ("", None, "what the part is called")


@value
class PartOnset:
    """The onset of yield of one body, layer or base, as if the others stayed elastic.

    Parameters
    ----------
    part : int
        Number of the part among those with a strength, counted from the uppermost layer of the first body down, from
        1.
    name : str
        Name of the part.
    force, radius, depth : float
        Force, contact radius and depth at the onset of yield [N], [m], [m]; infinite if no yield was found in the
        examined range.
    x, z : float
        Coordinates [m], as in `YieldOnsetSolution`; nan where it does not yield.
    why : str
        Reason why no onset was found; empty if one was found.
    """

    __words__ = words(
        part=PART,
        name=NAME,
        x=("x", "m", "position along the direction of the traction"),
        why=("", None, "why no onset was found"),
    )

    part: int
    name: str
    force: float
    radius: float
    depth: float
    x: float
    z: float
    why: str = ""


@value
class EllipticPartOnset:
    """The onset of yield of one body, layer or base below an ellipse, as if the others stayed elastic.

    Parameters
    ----------
    part : int
        Number of the part among those with a strength, counted from the uppermost layer of the first body down, from
        1.
    name : str
        Name of the part.
    force : float
        [N] when it begins to yield.
    x, y, z : float
        Coordinates [m], as in `EllipticYieldOnsetSolution`.
    """

    __words__ = words(part=PART, name=NAME, x=("x", "m", "place along the surface"))

    part: int
    name: str
    force: float
    x: float
    y: float
    z: float


def onset_note(rows: Sequence[tuple[str, float]], unit: str, *, fading: Sequence[str] = ()) -> Note:
    """Return which part yields first, and under which load each does.

    Parameters
    ----------
    rows : sequence of tuple
        The name of each part, and its load in the unit.
    unit : str
    fading : sequence of str
        Names of the parts at whose onset the contact is so wide that the shortest waves in the layers are left out.
    """
    first = min(rows, key=lambda row: row[1])[0]
    text = f"Yielding begins in the {first}, where the von Mises stress of the elastic field first reaches its strength"
    if len(rows) > 1:
        loads = [
            f"the {name} {f'at {with_unit(load, unit)}' if math.isfinite(load) else 'not within what was examined'}"
            for name, load in rows
        ]
        text += f"; each as if the others stayed elastic: {', '.join(loads)}"
    if fading:
        text += (
            f"; at the onset in the {' and the '.join(fading)} the contact is so wide that stresses in the layers "
            "within a hundredth of it from its edge are rounded off"
        )
    return Note(Assumption.ELASTIC, Standing.ASYMPTOTIC if first in fading else Standing.EXACT, f"{text}.", MISES)
