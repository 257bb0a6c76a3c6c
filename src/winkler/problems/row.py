"""A row of cells that is moved and remembers, and the one loop that carries a row along a path.

Springs by gap, springs one by one and rings that slide are rows: what their cells do in a straight step is their own
matter.  How a path is cut into straight steps, what it costs, and where a path is refused is the same for all:
a step that is not straight is halved until both halves bring the row to where the whole did.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Generic, NamedTuple, Protocol, TypeVar

from winkler.values.errors import NotConverged, OutsideValidity

__all__ = ["CURVED_STEP_TOLERANCE", "Reached", "Row", "follow", "over"]

CURVED_STEP_TOLERANCE = 3e-5
"""Curved steps are halved until cells and loss end elsewhere by less than this part of the greatest on the path."""
MOST_HALVINGS, MOST_STEPS = 40, 50_000
"""How often a step is halved, and how many steps lead from one point to the next, at most."""

Goal = TypeVar("Goal")
State = TypeVar("State")


class Reached(NamedTuple, Generic[State]):
    """Where a row is, and the work and loss of the path to it.

    Parameters
    ----------
    state
        What the cells remember.
    work, lost : float
        Spent by what moves the row, and lost on its path [J].
    """

    state: State
    work: float
    lost: float

    def then(self, step: Reached[State]) -> Reached[State]:
        """Return where a further step ends, and what both have cost."""
        return Reached(step.state, self.work + step.work, self.lost + step.lost)


class Row(Protocol[Goal, State]):
    """A row of cells; its goals say what is prescribed at a moment, its states what the cells remember."""

    owner: str
    """Kind of the problem, for messages."""
    order: int | None = None
    """With which power of its length work and loss of a halved step converge; None if they are taken as they are."""

    def begin(self, goal: Goal) -> Reached[State]:
        """Return the row at the first point of a path: pressed straight down, and moved after.

        Raises
        ------
        OutsideValidity, NotConverged
            As `step`.
        """
        ...

    def step(self, state: State, goal: Goal) -> Reached[State]:
        """Return the row after one straight step to a goal.

        Raises
        ------
        OutsideValidity
            If the cells cannot bear what is prescribed: the end of a sentence that begins with the point of the path.
        NotConverged
            If a prescribed force is not met.
        """
        ...

    def halfway(self, state: State, start: Goal, goal: Goal) -> Goal | None:
        """Return what is prescribed in the middle of a step; None if one straight step is as right as its halves."""
        return None

    def apart(self, one: Reached[State], two: Reached[State]) -> float:
        """Return by how much two ends of steps from one state to one goal differ, over what is allowed."""
        return 0.0


def follow(
    row: Row[Goal, State], goals: Iterable[Goal], reached: tuple[int, Goal, Reached[State]] | None = None
) -> Iterator[Reached[State]]:
    """Yield where a row is at each point of a path, and work and loss since the beginning.

    Parameters
    ----------
    row : Row
    goals : iterable
        What is prescribed at the points of the path.
    reached : tuple, optional
        Of a path that is carried on: the index of its last goal, that goal, and what was yielded there.

    Raises
    ------
    OutsideValidity
        If the row cannot bear what is prescribed, at that point: what comes before has been yielded.
    NotConverged
        If a step does not settle, likewise.
    """
    for index, goal in enumerate(goals, reached[0] + 1 if reached else 0):
        try:
            if reached is None:
                here = row.begin(goal)
            else:
                _, before, here = reached
                here = here.then(_reach(row, here.state, before, goal))
        except (OutsideValidity, NotConverged) as error:
            reason = str(error).removeprefix(f"{row.owner}: ")
            raise type(error)(f"{row.owner}: at index {index} of the path {reason}") from None
        yield here
        reached = index, goal, here


def over(error: float, allowed: float) -> float:
    """Return an error over what is allowed; nothing is allowed where there is nothing to be moved."""
    return 0.0 if error <= allowed else error / allowed if allowed > 0.0 else float("inf")


def _reach(row: Row[Goal, State], state: State, start: Goal, goal: Goal) -> Reached[State]:
    """Return the row at the next point of a path, and work and loss since the last one."""
    if row.halfway(state, start, goal) is None:
        return row.step(state, goal)
    done = Reached(state, 0.0, 0.0)
    ahead: list[tuple[Goal, int, Reached[State] | None]] = [(goal, 0, None)]
    settled, error, tried = 0, 0.0, 0
    while ahead:
        tried += 1
        goal, halvings, whole = ahead.pop()
        middle = row.halfway(done.state, start, goal)
        if middle is not None and error * 8.0 ** (settled - halvings) > 1.0:
            # steps of its length have just been too long: the error of half of one is a quarter at most
            ahead += [(goal, halvings + 1, None), (middle, halvings + 1, None)]
            continue
        if whole is None:
            whole = row.step(done.state, goal)
        if middle is not None:
            half = row.step(done.state, middle)
            two = half.then(row.step(half.state, goal))
            error, settled = row.apart(whole, two), halvings
            if error > 1.0:
                if halvings == MOST_HALVINGS or tried > MOST_STEPS:
                    raise NotConverged(
                        "the step does not converge, however often it is halved; give points in between."
                    )
                ahead += [(goal, halvings + 1, None), (middle, halvings + 1, half)]
                continue
            if row.order is not None:
                # the errors of both fall with that power: the two extrapolate to a step without end of halves
                rest = 2.0**row.order - 1.0
                gain = (two.work - whole.work) / rest, (two.lost - whole.lost) / rest
                two = Reached(two.state, two.work + gain[0], max(two.lost + gain[1], 0.0))
            whole = two
        done, start = done.then(whole), goal
    return done
