"""Solve problems step by step (`winkler.problems.answer.March`), with progress, checkpoints, and early stops."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple

from winkler.io.processes.stopping import INTERRUPTED, clear_interrupt, raise_pending
from winkler.problems.answer import March
from winkler.study.batch.checkpoint import CheckpointStore
from winkler.values.errors import WinklerError

Watch = Callable[[Iterable[Any], int | None], Iterable[Any]]
"""Passes states on, one after the other; its second argument is their number, if known."""


class MarchResult(NamedTuple):
    """The result of a march.

    Parameters
    ----------
    solution
        Of the points that were reached.
    stopped
        Sentence that states why it ended before the end of its path; empty if it did not.
    code
        Exit code of the command line: 0 if it reached the end, 130 if it was interrupted, else that of the error.
    """

    solution: Any
    stopped: str = ""
    code: int = 0


def unwatched(states: Iterable[Any], total: int | None) -> Iterator[Any]:
    """Yield the states unchanged."""
    yield from states


NO_CHECKPOINTS = CheckpointStore("", "")
"""Stores nothing, and holds no states."""


def solve_march(problem: March, watch: Watch = unwatched, keep: CheckpointStore = NO_CHECKPOINTS) -> MarchResult:
    """Solve a problem step by step, and return the states reached if it ends early.

    Parameters
    ----------
    problem
        The problem that was solved.
    watch
        Passes every state on.
    keep
        Store of the states of problems whose march can be continued.

    Returns
    -------
    Marched

    Raises
    ------
    WinklerError, KeyboardInterrupt
        If it ends before there are states enough for a solution.
    """
    states = _ReachedStates(problem, watch, keep if keep.resumes(problem) else NO_CHECKPOINTS)
    try:
        solution = problem.gathered(states)
    except WinklerError as error:  # too few states for a solution
        raise states.end or error from None
    if states.end is None:
        return MarchResult(solution)
    code = INTERRUPTED if isinstance(states.end, KeyboardInterrupt) else states.end.exit_code
    return MarchResult(solution, states.sentence, code)


class _ReachedStates:
    """The states of a march up to where it ends, and what ended it early."""

    def __init__(self, problem: March, watch: Watch, keep: CheckpointStore) -> None:
        self._problem, self._watch, self._keep = problem, watch, keep
        self._count = 0
        self.end: WinklerError | KeyboardInterrupt | None = None

    def __iter__(self) -> Iterator[Any]:
        problem, keep = self._problem, self._keep
        earlier = keep.stored_states(problem) if keep != NO_CHECKPOINTS else []
        marching = problem.steps(start=earlier[-1]) if earlier else problem.steps()  # type: ignore[call-arg]
        stored: list[Any] = []
        try:
            for state in self._watch(itertools.chain(earlier, marching), problem.total):
                if keep != NO_CHECKPOINTS:
                    stored.append(state)
                    if len(stored) > len(earlier):
                        keep.write(problem, stored)
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
    def sentence(self) -> str:
        """Why the march ended early, in one sentence."""
        why = "it was interrupted" if isinstance(self.end, KeyboardInterrupt) else str(self.end)
        many = "states" if self._problem.total is None else f"of {self._problem.total} points of the path"
        sentence = f"After {self._count} {many}, which are kept, the calculation ended: {why}"
        return sentence if sentence.endswith(".") else f"{sentence}."
