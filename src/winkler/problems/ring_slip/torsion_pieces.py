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

__all__ = ["NO_CONTACT", "TurnHistory", "TurnedTwist", "TwistMemory", "TwistPiece", "fresh", "pieces_of"]


@value
class TwistMemory:
    """The springs of a contact.

    Parameters
    ----------
    level, radius, excess : float
        How the contact is pressed: depth [m] or force [N]; a [m]; d - g(a) [m].
    edges : ndarray, (m + 1,)
        Ends of the stretches [m], from zero to a.
    held, entered : ndarray, (m,)
        alpha [Pa] and beta [Pa per unit of the level].
    sides : ndarray, (m,)
        sigma: 1, 0 or -1.
    bounds : ndarray, (m, 3)
        Level, radius and excess of the contact whose bound it is.
    """

    __words__ = words(
        press=("", None, "how the contact is pressed"),
        level=("", None, "depth or force, as prescribed"),
        excess=("d-g(a)", "m", "depth beyond that at which the contact fills the body"),
        edges=("x_j", "m", "ends of the stretches"),
        held=(r"\alpha", "Pa", "constant part of the load over x"),
        entered=(r"\beta", None, "part of the load over x that grows with the level of first touch"),
        sides=(r"\sigma", "", "part of the load over x that is a bound"),
        bounds=("", None, "the contacts whose bounds these are"),
        record=("", None, "the springs themselves"),
    )

    level: float
    radius: float
    excess: float
    edges: Array
    held: Array
    entered: Array
    sides: Array
    bounds: Array

    @property
    def press(self) -> PressedState:
        """How the contact is pressed."""
        return PressedState(self.level, self.radius, self.excess)

    @property
    def record(self) -> TwistMemory:
        """The springs themselves; of a `TurnedTwist` they are found from its turns."""
        return self


class TurnHistory(NamedTuple):
    """The points of a history under a steady load, ``(points,)`` each: motion, load, front of slip, and energies.

    Fronts are radii or gaps [m]; the units of the others are those of the springs.
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
        record=("", None, "what the springs remember, ring by ring"),
    )

    press: PressedState
    history: TurnHistory
    point: int

    @property
    def radius(self) -> float:
        """a [m]."""
        return self.press.radius

    @property
    def record(self) -> TwistMemory:
        """The springs, ring by ring."""
        press, point, (motion, _, front, *_, branches) = self.press, self.point, self.history
        last = [*branches.turns(point), point]
        # when the springs of each ring slid last; those within the first never did
        edges = np.array([0.0, *front[last].tolist(), press.radius])
        held = motion[point] - np.append(0.0, motion[last])
        sides = np.array([0.0, *(branches.directions[each] for each in last)])
        some = np.diff(edges) > 0.0
        sides = sides[some]
        bounds = np.where(sides[:, None] != 0.0, np.array(press), np.array(NO_CONTACT))
        ends = np.append(0.0, edges[1:][some])
        return TwistMemory(*press, ends, held[some], np.zeros(sides.size), sides, bounds)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, TurnedTwist):
            return NotImplemented
        return self is other or self.record == other.record

    def __hash__(self) -> int:
        return hash((self.press, float(self.history.motion[self.point])))


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


def fresh(level: float = 0.0) -> TwistMemory:
    """Return springs of which none is in contact."""
    none = np.zeros(0)
    return TwistMemory(level, 0.0, 0.0, np.zeros(1), none, none, none, np.zeros((0, 3)))


def pieces_of(memory: TwistMemory | TurnedTwist) -> list[TwistPiece]:
    """Return the stretches one by one."""
    memory = memory.record
    edges, bounds = memory.edges, [PressedState(*bound) for bound in memory.bounds.tolist()]
    numbers = (edges[:-1], edges[1:], memory.held, memory.entered, memory.sides)
    return [TwistPiece(*row) for row in zip(*(each.tolist() for each in numbers), bounds, strict=True)]
