"""A row of cells that is moved and remembers, and the one loop that carries a row along a path.

Springs by gap, springs one by one and rings that slide are rows: what their cells do in a straight step is their own
matter.  How a path is cut into straight steps, what it costs, and where a path is refused is the same for all:
a step that is not straight is halved until both halves bring the row to where the whole did.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any, Generic, NamedTuple, Protocol, TypeVar

from winkler.values.errors import NotConverged, OutsideValidity

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
        return then(self, step)


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

    def step(self, state: State, goal: Goal) -> Reached[State]:
        """Return the row after one straight step to a goal.

        Raises
        ------
        OutsideValidity
            If the cells cannot bear what is prescribed: the end of a sentence that begins with the point of the path.
        NotConverged
            If a prescribed force is not met.
        """

    def halfway(self, state: State, start: Goal, goal: Goal) -> Goal | None:
        """Return what is prescribed in the middle of a step; None if one straight step is as right as its halves."""
        return None

    def apart(self, one: Reached[State], two: Reached[State]) -> float:
        """Return by how much two ends of steps from one state to one goal differ, over what is allowed."""
        return 0.0

    def reach(self, state: State, start: Goal, goal: Goal) -> Reached[State]:
        """Return the row at the next point of a path, and work and loss since the last one.

        Raises
        ------
        OutsideValidity, NotConverged
            As `step`; if a step does not settle.
        """
        return halved(self, state, start, goal)


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
                here = here.then(row.reach(here.state, before, goal))
        except (OutsideValidity, NotConverged) as error:
            reason = str(error).removeprefix(f"{row.owner}: ").removesuffix(".")
            raise type(error)(f"{row.owner}: at index {index} of the path {reason}.") from None
        yield here
        reached = index, goal, here


def over(error: float, allowed: float) -> float:
    """Return an error over what is allowed; nothing is allowed where there is nothing to be moved."""
    return 0.0 if error <= allowed else error / allowed if allowed > 0.0 else float("inf")


def halved(row: Any, state: Any, start: Any, goal: Any) -> Reached[Any]:
    """Return the row at the next point of a path, and work and loss since the last one.

    It runs as it is, and for rows whose steps are functions over arrays as one kernel.
    """
    bends, middle = middle_of(row, state, start, goal)
    if not bends:
        return step_of(row, state, goal)
    done = Reached(state, 0.0, 0.0)
    ahead = [(goal, 0, False, done)]
    settled, error, tried = 0, 0.0, 0
    whole = half = rest = done
    while len(ahead) > 0:
        tried += 1
        goal, halvings, known, whole = ahead.pop()
        bends, middle = middle_of(row, done.state, start, goal)
        if bends and error * 8.0 ** (settled - halvings) > 1.0:
            # steps of its length have just been too long: the error of half of one is a quarter at most
            ahead.append((goal, halvings + 1, False, done))
            ahead.append((middle, halvings + 1, False, done))
            continue
        for part in range(1 if known else 0, 3 if bends else 1):
            rest = step_of(row, half.state if part == 2 else done.state, middle if part == 1 else goal)
            if part == 0:
                whole = rest
            elif part == 1:
                half = rest
        if bends:
            two = then(half, rest)
            error, settled = apart_of(row, whole, two), halvings
            if error > 1.0:
                if halvings == MOST_HALVINGS or tried > MOST_STEPS:
                    raise NotConverged(
                        "the step does not converge, however often it is halved; give points in between."
                    )
                ahead.append((goal, halvings + 1, False, done))
                ahead.append((middle, halvings + 1, True, half))
                continue
            order = order_of(row)
            if order > 0:
                # the errors of both fall with that power: the two extrapolate to a step without end of halves
                more = 2.0**order - 1.0
                gain, loss = (two.work - whole.work) / more, (two.lost - whole.lost) / more
                two = Reached(two.state, two.work + gain, max(two.lost + loss, 0.0))
            whole = two
        done, start = then(done, whole), goal
    return done


def then(here: Reached[Any], step: Reached[Any]) -> Reached[Any]:
    """Return where a further step ends, and what both have cost."""
    return Reached(step.state, here.work + step.work, here.lost + step.lost)


def step_of(row: Any, state: Any, goal: Any) -> Reached[Any]:
    """Return as `Row.step`."""
    reached: Reached[Any] = row.step(state, goal)
    return reached


def middle_of(row: Any, state: Any, start: Any, goal: Any) -> tuple[bool, Any]:
    """Return whether a step may have to be halved, and its middle."""
    middle = row.halfway(state, start, goal)
    return (False, goal) if middle is None else (True, middle)


def apart_of(row: Any, one: Reached[Any], two: Reached[Any]) -> float:
    """Return as `Row.apart`."""
    return float(row.apart(one, two))


def order_of(row: Any) -> int:
    """Return as `Row.order`; zero for none."""
    return row.order or 0
