"""The memory of the springs of a sheared contact at one moment: a stack of pieces, and how far it was dragged.

The springs are distinguished by their gap instead of their place; how a step moves them is
`winkler.problems.friction.slip_stack`.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.friction.slip_stack import SlipStack, SlipState, empty_stack, move, new_piece
from winkler.values.value import words


class SpringPiece(NamedTuple):
    """Springs in a row whose displacement is a straight line over the gap.

    Parameters
    ----------
    start, stop : float
        Their gaps [m].
    left, right : float
        u_t at both ends [m].
    slides : int
        Whether they are on their bound: on which side (+1, -1), else 0.
    """

    start: float
    stop: float
    left: float
    right: float
    slides: int


REPLACED, FEW = 4, 512
"""Pieces over those of the present stack, beyond a few, from which on it goes on by itself."""


class SlipPieces:
    """The pieces that all states of a path share: each of them is put once, and never changes."""

    __slots__ = ("columns", "summed")

    def __init__(self, columns: SlipStack | None = None) -> None:
        self.columns = empty_stack() if columns is None else columns
        self.summed: object = None
        """With which sums `SlipStack.zeroth` and its neighbours were found."""

    def sums_of(self, table: object) -> SlipStack:
        """Return the stack, in which no sums but those of a table are known."""
        if self.summed is not table:
            self.summed = table
            for piece in range(self.columns.used[0]):
                self.columns.known[piece] = 0
        return self.columns

    def crowded(self, top: int) -> bool:
        """Whether most pieces are none of the stack below a piece: steps have replaced them."""
        alive = self.columns.count[top] if top >= 0 else 0
        return bool(self.columns.used[0] > REPLACED * alive + FEW)

    def alone(self, top: int) -> tuple[SlipPieces, dict[int, int]]:
        """Return the pieces of the stack below a piece without all others, and old number -> new number.

        Who keeps no states of a path then needs no more memory after many steps than after a few.
        """
        chain = []
        while top >= 0:
            chain.append(top)
            top = int(self.columns.inner[top])
        chain.reverse()
        rows = {name: [getattr(self.columns, name)[piece] for piece in chain] for name in SlipStack._fields[:-1]}
        rows |= {"inner": list(range(-1, len(chain) - 1)), "outer": [-1] * len(chain)}
        made = SlipPieces(SlipStack(**rows, used=[len(chain)]))
        made.summed = self.summed
        return made, {piece: number for number, piece in enumerate(chain)}


class MovedMemory(NamedTuple):
    """What a straight step does.

    Parameters
    ----------
    memory : SlipMemory
        After it.
    lost, work : float
        What sliding has cost, and what the bodies have spent [J], over the ratio of stiffnesses; not a number unless
        they are summed.
    """

    memory: SlipMemory
    lost: float
    work: float


class SlipMemory:
    """The sideways displacement of the springs over their gap, in straight pieces; it never changes.

    Parameters
    ----------
    depth : float
        d [m]; below zero the bodies are apart.
    dragged : float
        How far the stack of pieces was dragged as a whole [m].
    pieces : SlipPieces, optional
    top : int, optional
        Its outermost one; -1 for none.
    """

    __slots__ = ("depth", "dragged", "pieces", "top")
    __words__ = words(
        stick_gap=(r"\gamma_c", "m", "gap of the outermost spring that sticks"),
        corners=("", None, "depths and factors of the contacts that add up to the displacement"),
        edges=(r"\gamma_j", "m", "gaps at which the straight pieces of the displacement meet"),
        left=("u_t", "m", "displacement of the springs where a piece begins"),
        right=("u_t", "m", "displacement of the springs where a piece ends"),
        on_axis=("u_t", "m", "displacement of the spring that touches first"),
        dragged=("", "m", "how far the pieces of the displacement were dragged together"),
        pieces=("", None, "the pieces of all states of the path"),
        top=("", None, "number of the piece at the edge"),
        size=("m", None, "how many straight pieces the displacement has"),
    )

    def __init__(self, depth: float, dragged: float = 0.0, pieces: SlipPieces | None = None, top: int = -1) -> None:
        self.depth, self.dragged, self.top = depth, dragged, top
        self.pieces = SlipPieces() if pieces is None else pieces

    def __reduce__(self) -> tuple[object, ...]:  # of what all states share each takes its own
        return _stacked, (self.depth, self.dragged, tuple(self.outwards()))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, SlipMemory):
            return NotImplemented
        if (self.depth, self.dragged, self.size) != (other.depth, other.dragged, other.size):
            return False
        return (self.pieces is other.pieces and self.top == other.top) or self.outwards() == other.outwards()

    def __hash__(self) -> int:
        return hash((self.depth, self.dragged, self.size))

    @classmethod
    def fresh(cls) -> SlipMemory:
        """Return what is remembered by bodies that have not met."""
        return cls(0.0)

    def outwards(self) -> list[SpringPiece]:
        """Return the pieces in the order of their gaps, displaced by so much beyond the stack as a whole."""
        stack, ring, rows = self.pieces.columns, self.top, []
        while ring >= 0:
            start, stop, left, right = (float(column[ring]) for column in stack[:4])
            rows.append(SpringPiece(start, stop, left, right, int(stack.side[ring])))
            ring = int(stack.inner[ring])
        return rows[::-1]

    @property
    def size(self) -> int:
        """How many pieces there are."""
        return int(self.pieces.columns.count[self.top]) if self.top >= 0 else 0

    @property
    def edges(self) -> Array:
        """Where the pieces meet: gaps from 0 to the depth [m], (m + 1,)."""
        return np.array([0.0, *(piece.stop for piece in self.outwards())])

    @property
    def left(self) -> Array:
        """u_t where each piece begins [m], (m,)."""
        return np.array([piece.left for piece in self.outwards()]) + self.dragged

    @property
    def right(self) -> Array:
        """u_t where each piece ends [m], (m,)."""
        return np.array([piece.right for piece in self.outwards()]) + self.dragged

    @property
    def on_axis(self) -> float:
        """u_t of the spring that touches first [m]; zero without contact."""
        return float(self.pieces.columns.axis[self.top]) + self.dragged if self.top >= 0 else 0.0

    @property
    def stick_gap(self) -> float:
        """Gap of the outermost spring that is not on its bound [m]; zero if all are."""
        stack, ring = self.pieces.columns, self.top
        while ring >= 0 and stack.side[ring] != 0:
            ring = stack.inner[ring]
        return float(stack.stop[ring]) if ring >= 0 else 0.0

    def moved(self, depth: float, change: float, bound: float, sums: Any = None) -> MovedMemory:
        """Return the memory after a straight step, and its energies.

        Parameters
        ----------
        depth : float
            d at the end of the step [m].
        change : float
            By how much the bodies shift in the step [m].
        bound : float
            As of `winkler.problems.friction.slip_stack.move`.
        sums : SlipSums, optional
            With which energies are summed: the work does not go by what the springs keep.

        Returns
        -------
        MovedMemory
        """
        stack, summed = self.pieces.columns if sums is None else self.pieces.sums_of(sums), sums is not None
        state = SlipState(self.top, self.dragged, self.depth, 0.0)
        top, dragged, depth, lost, work = move(stack, sums, bound, state, depth, change, summed)
        if not summed:
            lost = work = math.nan
        return MovedMemory(SlipMemory(depth, dragged, self.pieces, top), lost, work)

    @property
    def corners(self) -> tuple[Array, Array]:
        """Depths [m] and factors of the normal contacts whose springs add up to u_t: the sum of B (gamma_j - gamma)+.

        Jumps of u_t, which only springs that never slide can have, are not among them.
        """
        edges = self.edges
        slope = (self.right - self.left) / np.diff(edges)
        return edges[1:], np.diff(np.append(slope, 0.0))


def _stacked(depth: float, dragged: float, rows: tuple[SpringPiece, ...]) -> SlipMemory:
    pieces, top = SlipPieces(), -1
    for row in rows:
        top = new_piece(pieces.columns, top, *row)
    return SlipMemory(depth, dragged, pieces, top)
