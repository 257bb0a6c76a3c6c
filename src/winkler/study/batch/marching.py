"""Problems that march (`winkler.problems.answer.March`): watched point after point, and kept if they stop early."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple

from winkler.errors import WinklerError
from winkler.problems.answer import March
from winkler.study.batch.checkpoint import Keep
from winkler.study.batch.stopping import INTERRUPTED, clear_interrupt, raise_pending

__all__ = ["ANEW", "Marched", "Watch", "marched", "unwatched"]


Watch = Callable[[Iterable[Any], int | None], Iterable[Any]]
"""Passes states on, one after the other, told how many there will be, if that is known."""


class Marched(NamedTuple):
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


def marched(problem: March, watch: Watch = unwatched, keep: Keep = ANEW) -> Marched:
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
    Marched

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
        return Marched(solution)
    code = INTERRUPTED if isinstance(states.end, KeyboardInterrupt) else states.end.exit_code
    return Marched(solution, states.told, code)


class _Reached:
    """The states of a march up to where it ends, and what ended it early."""

    def __init__(self, problem: March, watch: Watch, keep: Keep) -> None:
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
                raise_pending()
                self._count += 1
                yield state
        except (KeyboardInterrupt, WinklerError) as end:
            if not self._count:
                raise
            if isinstance(end, KeyboardInterrupt):
                clear_interrupt()
            self.end = end

    @property
    def told(self) -> str:
        """Why the march ended early, in one sentence."""
        why = "it was interrupted" if isinstance(self.end, KeyboardInterrupt) else str(self.end)
        many = "states" if self._problem.total is None else f"of {self._problem.total} points of the path"
        told = f"After {self._count} {many}, which are kept, the march ended: {why}"
        return told if told.endswith(".") else f"{told}."
