"""Springs distinguished by their gap as a row, of a contact that is pressed and moved in one direction.

A step that is straight in depth and shift is one move of `SlipMemory`, however long.  Where a prescribed force bends
it, it is halved until the halves bring the springs to where the whole did (`winkler.problems.row`).
"""

from __future__ import annotations

from typing import Any, TypeVar

import numpy as np

from winkler.foundation.bed import Bed
from winkler.loading.loads import Depth, Shift
from winkler.loading.path import Path
from winkler.numerics.jit import Instead
from winkler.numerics.types import Array
from winkler.problems.friction.slip_memory import SlipMemory, SlipPieces
from winkler.problems.friction.slip_stack import (
    SlipCells,
    SlipGoal,
    SlipStack,
    SlipState,
    move,
    settled,
    slip_apart,
    slip_step,
    within,
)
from winkler.problems.friction.slip_sums import PanelTable, SlipSums, panel_at, panel_moments, panel_table
from winkler.problems.normal.force_curve import NormalCurves
from winkler.problems.normal.indentation import IndentationSolution
from winkler.problems.row import CURVED_STEP_TOLERANCE, Reached, Row, halved
from winkler.values.errors import NotConverged, OutsideValidity

UNTOUCHED_DEPTH = 1e-9
"""Depth [m] to which the normal curve is made for bodies that never touch, and never evaluated."""
LONG = 5000
"""Points of a path from which on a kernel saves more than it takes to load."""
SOUGHT, HALVED = 2, 5
"""For how many points one counts whose shift is sought, or to which a step is bent."""
ROOM = 4096
"""Pieces for which a kernel has room at first."""
WHOLE = {"side", "inner", "outer", "count", "stuck", "known"}
"""Columns of a stack that hold whole numbers."""
ORDER = 2
"""Of the errors of a step that is halved, as of `winkler.problems.row.Row`."""
NEVER_MET = SlipState(-1, 0.0, 0.0, 0.0)
"""Springs of bodies that have not met."""

State = TypeVar("State")


class PressedRow(Row[SlipGoal, State]):
    """Springs under a path of depths or normal forces, and of shifts or shear forces.

    Parameters
    ----------
    path : Path
    """

    order: int | None = ORDER
    curves, bends = True, False
    """Whether steps are halved where a prescribed force bends them; whether a shear force bends them in itself."""

    def __init__(self, path: Path) -> None:
        self.greatest = float(np.max(np.abs(path.along)))
        self.driven, self.pressed = isinstance(path.lateral, Shift), isinstance(path.normal, Depth)

    def _allow(self, stiffness: float, most: float) -> None:
        """Set what counts as little, from the stiffness without slip [N/m] and the greatest bound of a spring [m]."""
        size = min(most, self.greatest if self.driven or stiffness == 0.0 else self.greatest / stiffness)
        self.allowed = CURVED_STEP_TOLERANCE * size, CURVED_STEP_TOLERANCE * stiffness * size**2

    @property
    def _never_bent(self) -> bool:
        return not self.curves or (self.driven and self.pressed)

    def _straight(self, steady: Any, same: Any) -> Any:
        """Return whether steps are straight, under a steady depth or not, to the same load along the surface or not."""
        # with no change of shift it does not matter when the depth changes
        return (steady & (self.driven or not self.bends)) | ((steady | self.driven) & same)

    def unbent(self, depths: Array, along: Array) -> bool:
        """Return whether no step is bent, of depths ``(n,)`` and what is prescribed along ``(n, ...)``."""
        if self._never_bent:
            return True
        same = np.all(np.diff(along.reshape(depths.size, -1), axis=0) == 0.0, axis=1)
        return bool(np.all(self._straight(np.diff(depths) == 0.0, same)))

    def force_at(self, depth: float) -> float:
        """Return the normal force at a depth [N]."""
        raise NotImplementedError

    def halfway(self, state: State, start: SlipGoal, goal: SlipGoal) -> SlipGoal | None:
        """Return what is prescribed at the middle of the depths."""
        if self._never_bent or self._straight(start.depth == goal.depth, np.all(start.along == goal.along)):
            return None
        return middle_goal(self, start, goal)


SlipEnd = tuple[int, float, float, float, float, float]
"""The numbers of a `SlipState`, work and loss."""


class SlipRow(PressedRow[SlipState]):
    """The springs under a path.

    Parameters
    ----------
    bed : Bed
    coefficient : float
        mu [-].
    ratio : float
        c_T/c_N [-] of every spring.
    path : Path
    contact : IndentationSolution
        The contact without friction at every point of the path.
    """

    owner = "Tangential"

    def __init__(self, bed: Bed, coefficient: float, ratio: float, path: Path, contact: IndentationSolution) -> None:
        self.coefficient, self.ratio, self.beta = coefficient, ratio, coefficient / ratio
        pressed = (np.atleast_1d(quantity).tolist() for quantity in (contact.depth, contact.force, path.along))
        super().__init__(path)
        self.goals = [SlipGoal(*goal) for goal in zip(*pressed, strict=True)]
        deepest = max(0.0, *(goal.depth for goal in self.goals))
        self._curves = NormalCurves(bed, deepest if deepest > 0.0 else UNTOUCHED_DEPTH)
        self.sums = SlipSums(self._curves)
        stiffness, _, _ = self.sums.at(deepest)
        self._allow(ratio * stiffness, self.beta * deepest if deepest > 0.0 else 0.0)
        self.pieces = SlipPieces()
        numbers = self.beta, ratio, coefficient, self.driven, self.pressed, *self.allowed
        self.cells = SlipCells(self.pieces.sums_of(self.sums), self.sums, *numbers)
        self._table: PanelTable | None = None
        count = len(self.goals)
        if HALVED * count >= LONG and not self.unbent(np.asarray(contact.depth), path.along):
            count *= HALVED
        if (count if self.driven else SOUGHT * count) >= LONG:
            self._table, self.pieces.columns = panel_table(self._curves, 1), arrays_of(self.pieces.columns)
            self.cells = self.cells._replace(stack=self.pieces.columns)

    def begin(self, goal: SlipGoal) -> Reached[SlipState]:
        """Return the springs pressed straight down, and moved after."""
        cells = self.cells
        top, dragged, depth, _, _ = move(cells.stack, None, self.beta, NEVER_MET, goal.depth, 0.0, False)
        return self.step(SlipState(top, dragged, depth, 0.0), goal)

    def halfway(self, state: SlipState, start: SlipGoal, goal: SlipGoal) -> SlipGoal | None:
        """Return as `PressedRow.halfway`."""
        return None if start.depth == goal.depth else super().halfway(state, start, goal)

    def step(self, state: SlipState, goal: SlipGoal) -> Reached[SlipState]:
        """Return the springs after a step that is straight in depth and shift, to a shift or to a shear force."""
        return slip_step(self.cells, state, goal)

    def reach(self, state: SlipState, start: SlipGoal, goal: SlipGoal) -> Reached[SlipState]:
        """Return as `Row.reach`; pieces of trial steps are forgotten."""
        fast = self._table is not None
        if self.pieces.crowded(state.top):
            self.pieces, numbers_of = self.pieces.alone(state.top)
            if fast:
                self.pieces.columns = arrays_of(self.pieces.columns)
            self.cells = self.cells._replace(stack=self.pieces.columns)
            state = state._replace(top=numbers_of.get(state.top, -1))
        numbers = self._fast(state, start, goal) if fast else slip_reach(self, state, start, goal)
        return Reached(SlipState(*numbers[:4]), *numbers[4:])

    def _fast(self, state: SlipState, start: SlipGoal, goal: SlipGoal) -> SlipEnd:
        """Return as `Row.reach`, by the kernel."""
        pieces, used = self.pieces, self.pieces.columns.used[0]
        while True:
            assert self._table is not None
            try:
                cells = self.cells._replace(table=self._table)
                return SLIP_REACH(cells, state, start, goal)
            except MemoryError:
                pieces.columns = arrays_of(pieces.columns)
                self.cells = self.cells._replace(stack=pieces.columns)
            except LookupError:
                self._table = panel_table(self._curves, int(self._table.missing[0]) + 1)
            except (OutsideValidity, NotConverged):
                pieces.columns.used[0] = used
                return slip_reach(self, state, start, goal)  # says why
            pieces.columns.used[0] = used

    def apart(self, one: Reached[SlipState], two: Reached[SlipState]) -> float:
        """Return as `slip_apart`."""
        return slip_apart(self.cells, one, two)

    def force_at(self, depth: float) -> float:
        """Return as `PressedRow.force_at`."""
        return self.sums.at(depth)[1]

    def memory(self, state: SlipState) -> SlipMemory:
        """Return what the springs remember."""
        return SlipMemory(state.depth, state.dragged, self.pieces, state.top)

    def shear_force(self, memory: SlipMemory) -> float:
        """Return F_x [N]."""
        return float(self.ratio * self.sums.shear(memory))

    def stored(self, memory: SlipMemory) -> float:
        """Return the energy stored in the springs' displacement along the surface [J]."""
        return float(self.ratio * self.sums.stored(memory))


def slip_reach(row: Any, state: SlipState, start: SlipGoal, goal: SlipGoal) -> SlipEnd:
    """Return the state and the costs of `Row.reach`, summed up; pieces of trial steps are forgotten."""
    cells = cells_of(row)
    stack, mark = cells.stack, cells.stack.used[0]
    end = slip_step(cells, state, goal) if start.depth == goal.depth else halved(row, state, start, goal)
    top = settled(stack, end.state.top, mark)
    within(stack, cells.table, top)
    return top, end.state.dragged, end.state.depth, end.state.shift, end.work, end.lost


def slip_middle(cells: SlipCells, state: SlipState, start: SlipGoal, goal: SlipGoal) -> tuple[bool, SlipGoal]:
    """Return as `winkler.problems.row.middle_of`, of springs that no shear force bends."""
    if start.depth == goal.depth or (cells.driven and (cells.pressed or start.along == goal.along)):
        return False, goal
    return True, middle_goal(cells, start, goal)


def middle_goal(row: Any, start: SlipGoal, goal: SlipGoal) -> SlipGoal:
    """Return what is prescribed at the middle of the depths."""
    depth, force, share = 0.5 * (start.depth + goal.depth), start.force, 0.5
    if not (row.pressed or start.depth == goal.depth):
        force = force_of(row, depth)
        share = min(max((force - start.force) / (goal.force - start.force), 0.0), 1.0)
    return SlipGoal(depth, force, start.along + (goal.along - start.along) * share)


def cells_of(row: Any) -> SlipCells:
    """Return the cells of a `SlipRow`."""
    cells: SlipCells = row.cells
    return cells


def force_of(row: Any, depth: float) -> float:
    """Return as `PressedRow.force_at`."""
    return float(row.force_at(depth))


def _slip_force(cells: SlipCells, depth: float) -> float:
    return panel_at(cells.table, depth)[1]


def _themselves(cells: SlipCells) -> SlipCells:
    return cells


def _slip_order(cells: SlipCells) -> int:
    return ORDER


def _no_room(stack: SlipStack) -> None:
    raise MemoryError("a longer stack is needed")


def _refused(force: float, most: float) -> None:
    raise OutsideValidity("friction does not carry it")


def _missed(target: float, short: float) -> None:
    raise NotConverged("the force is not met")


def arrays_of(stack: SlipStack) -> SlipStack:
    """Return a stack as arrays, with room for more."""
    used, columns = stack.used[0], []
    for name, column in zip(SlipStack._fields[:-1], stack[:-1], strict=True):
        longer = np.zeros(2 * used + ROOM, dtype=int if name in WHOLE else float)
        longer[:used] = column[:used]
        columns.append(longer)
    return SlipStack._make([*columns, np.array([used])])


SLIP_REACH = Instead(
    {
        "step_of": slip_step,
        "middle_of": slip_middle,
        "apart_of": slip_apart,
        "order_of": _slip_order,
        "moments": panel_moments,
        "normal_at": panel_at,
        "force_of": _slip_force,
        "cells_of": _themselves,
        "make_room": _no_room,
        "refuse": _refused,
        "missed": _missed,
    },
    ("halved", "cells_of"),
).kernel(slip_reach)
"""From one point of a path to the next, as `halved` on `SlipCells` over arrays and panels."""
