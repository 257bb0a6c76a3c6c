"""Problems that march along a path: watched point after point, and kept if they stop early.

A problem with ``steps()`` is a march.  Its ``total`` tells how many states there will be, None if that shows only on
the way, and ``gathered(states)`` makes the answer of all of them or of the first.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple, Protocol, TypeGuard

from winkler.errors import WinklerError
from winkler.study.batch.checkpoint import Keep
from winkler.study.batch.stopping import INTERRUPTED, answered, look

__all__ = ["ANEW", "March", "Marching", "Watch", "is_march", "marched", "unwatched"]


class Marching(Protocol):
    """A problem that marches."""

    @property
    def total(self) -> int | None:
        """How many states `steps` yields, at most; None if that shows only on the way."""

    def steps(self) -> Iterator[Any]:
        """Yield state after state."""

    def gathered(self, states: Iterable[Any]) -> Any:
        """Return the answer from the states of the whole march or of its beginning."""


def is_march(problem: Any) -> TypeGuard[Marching]:
    """Return whether a problem marches."""
    return callable(getattr(type(problem), "steps", None))


Watch = Callable[[Iterable[Any], int | None], Iterable[Any]]
"""Passes states on, one after the other, told how many there will be, if that is known."""


class March(NamedTuple):
    """What a march came to.

    Parameters
    ----------
    solution
        Of the points that were reached.
    stopped
        Why it ended before the end of its path, in one sentence; empty if it did not.
    code
        What the command line returns: 0 if it reached the end, 130 if it was interrupted, else that of the error.
    """

    solution: Any
    stopped: str = ""
    code: int = 0


def unwatched(states: Iterable[Any], total: int | None) -> Iterator[Any]:
    """Yield the states; nobody watches."""
    yield from states


ANEW = Keep("", "")
"""Keeps nothing, and knows of nothing."""


def marched(problem: Marching, watch: Watch = unwatched, keep: Keep = ANEW) -> March:
    """Solve a problem that marches, and keep what was reached if it ends early.

    Parameters
    ----------
    problem
        What to solve.
    watch
        Sees every state on its way.
    keep
        Where states are kept, and found again, of problems whose march can go on from one.

    Returns
    -------
    March

    Raises
    ------
    WinklerError, KeyboardInterrupt
        If it ends before there is anything to answer from.
    """
    states = _Reached(problem, watch, keep if keep.takes(problem) else ANEW)
    try:
        solution = problem.gathered(states)
    except WinklerError as error:  # too few states for an answer
        raise states.end or error from None
    if states.end is None:
        return March(solution)
    code = INTERRUPTED if isinstance(states.end, KeyboardInterrupt) else states.end.exit_code
    return March(solution, states.told, code)


class _Reached:
    """The states of a march up to where it ends, and what ended it early."""

    def __init__(self, problem: Marching, watch: Watch, keep: Keep) -> None:
        self._problem, self._watch, self._keep = problem, watch, keep
        self._count = 0
        self.end: WinklerError | KeyboardInterrupt | None = None

    def __iter__(self) -> Iterator[Any]:
        problem, keep = self._problem, self._keep
        before = keep.reached(problem) if keep != ANEW else []
        marching = problem.steps(start=before[-1]) if before else problem.steps()  # type: ignore[call-arg]
        kept: list[Any] = []
        try:
            for state in self._watch(itertools.chain(before, marching), problem.total):
                if keep != ANEW:
                    kept.append(state)
                    if len(kept) > len(before):
                        keep.write(problem, kept)
                look()
                self._count += 1
                yield state
        except (KeyboardInterrupt, WinklerError) as end:
            if not self._count:
                raise
            if isinstance(end, KeyboardInterrupt):
                answered()
            self.end = end

    @property
    def told(self) -> str:
        """Why the march ended early, in one sentence."""
        why = "it was interrupted" if isinstance(self.end, KeyboardInterrupt) else str(self.end)
        many = "states" if self._problem.total is None else f"of {self._problem.total} points of the path"
        told = f"After {self._count} {many}, which are kept, the march ended: {why}"
        return told if told.endswith(".") else f"{told}."
