r"""The record of twisted springs: on every stretch of the contact three numbers and one bound state what they bear.

A spring at x bears :math:`q = x\,h` with :math:`h = \alpha + \beta\,\ell(x) + \sigma\,b(x)`; the terms are those of
`winkler.problems.ring_slip.torsion_memory`.
"""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import numpy as np

from winkler.foundation.torsion_bound import PressedState, TwistBound
from winkler.numerics.types import Array
from winkler.problems.ring_slip.play import Branches
from winkler.values.value import value, words


class TwistPiece(NamedTuple):
    """A stretch of the contact from `low` to `high` [m], with alpha, beta, sigma, and the contact whose bound b is."""

    low: float
    high: float
    held: float
    entered: float
    side: float
    bound: PressedState

    def values(self, bound: TwistBound) -> Array:
        """Return h [Pa] at the nodes of a bound."""
        result = np.full(bound.x.shape, self.held)
        if self.entered != 0.0:
            result += self.entered * bound.clock
        if self.side != 0.0:
            result += self.side * bound.at(self.bound)
        return result


NO_CONTACT = PressedState(0.0, 0.0, 0.0)


@value
class TwistMemory:
    """The springs of a contact.

    Parameters
    ----------
    press : PressedState
        How the contact is pressed.
    pieces : tuple of TwistPiece
        Its stretches from the axis to the edge.
    """

    __words__ = words(
        press=("", None, "how the contact is pressed"),
        pieces=("", None, "state of the springs of each annular element"),
    )

    press: PressedState
    pieces: tuple[TwistPiece, ...]


class TurnHistory(NamedTuple):
    """The points of a history under a steady load, ``(points,)`` each: motion, load, front of slip, and energies.

    Fronts are radii [m]; the units of the others are those of the springs.
    """

    motion: Array
    load: Array
    front: Array
    work: Array
    stored: Array
    lost: Array
    branches: Branches


@dataclasses.dataclass(frozen=True, eq=False)
class TurnedTwist:
    """The springs of a contact at a point of a history under a steady load, which all points share.

    Parameters
    ----------
    press : PressedState
        How the contact is pressed.
    history : TurnHistory
    point : int
    """

    __words__ = words(
        press=("", None, "how the contact is pressed"),
        history=("", None, "turning points of the path"),
        point=("", "", "index of the point of the path"),
        pieces=("", None, "state of the springs of each annular element"),
    )

    press: PressedState
    history: TurnHistory
    point: int

    @property
    def pieces(self) -> tuple[TwistPiece, ...]:
        """The springs, ring by ring."""
        press, point, (motion, _, front, *_, branches) = self.press, self.point, self.history
        last = [*branches.turns(point), point]
        # when the springs of each ring slid last; those within the first never did
        edges = [0.0, *front[last].tolist(), press.radius]
        held = (motion[point] - np.append(0.0, motion[last])).tolist()
        sides = [0.0, *(branches.directions[each] for each in last)]
        bounds = [press if side != 0.0 else NO_CONTACT for side in sides]
        rows = zip(edges[:-1], edges[1:], held, [0.0] * len(held), sides, bounds, strict=True)
        return tuple(piece for piece in map(TwistPiece._make, rows) if piece.high > piece.low)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, TurnedTwist):
            return NotImplemented
        return self is other or self.pieces == other.pieces

    def __hash__(self) -> int:
        return hash((self.press, float(self.history.motion[self.point])))


def fresh(level: float = 0.0) -> TwistMemory:
    """Return springs of which none is in contact."""
    return TwistMemory(PressedState(level, 0.0, 0.0), ())
