"""Problems that march along a path: watched point after point, and kept if they stop early."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple

import numpy as np

from winkler.errors import WinklerError
from winkler.problems.tangential import Tangential, TangentialSolution
from winkler.problems.torsion import Torsion, TorsionSolution
from winkler.problems.torsion_states import TorsionState

__all__ = ["INTERRUPTED", "MARCHES", "March", "Watch", "marched", "unwatched"]

INTERRUPTED = 130
"""What the command line returns if it was interrupted."""


def _twisted(problem: Torsion, states: list[TorsionState]) -> TorsionSolution:
    """Gather states, of the whole path or of its beginning."""
    words = [field.name for field in dataclasses.fields(TorsionSolution) if field.name not in ("problem", "states")]
    columns = {word: np.array([getattr(state, word) for state in states]) for word in words}
    return TorsionSolution(problem, **columns, states=tuple(states))


MARCHES: dict[type, Callable[[Any, list[Any]], Any]] = {Tangential: TangentialSolution.of, Torsion: _twisted}
"""Problem -> what makes its answer from the states along its path, or from the first of them."""

Watch = Callable[[Iterable[Any], int], Iterable[Any]]
"""Passes states on, one after the other, told how many there will be."""


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


def unwatched(states: Iterable[Any], total: int) -> Iterator[Any]:
    """Yield the states; nobody watches."""
    yield from states


def marched(problem: Any, watch: Watch = unwatched) -> March:
    """Solve a problem of `MARCHES`, and keep what was reached if it ends early.

    Parameters
    ----------
    problem
        What to solve.
    watch
        Sees every state on its way.

    Returns
    -------
    March

    Raises
    ------
    WinklerError, KeyboardInterrupt
        If it ends before its first point.
    """
    total = int(problem.path.time.size)
    states: list[Any] = []
    stopped, code = "", 0
    try:
        for state in watch(problem.steps(), total):
            states.append(state)
    except KeyboardInterrupt:
        if not states:
            raise
        stopped, code = "it was interrupted", INTERRUPTED
    except WinklerError as error:
        if not states:
            raise
        stopped, code = str(error), error.exit_code
    if stopped:
        stopped = f"After {len(states)} of {total} points of the path, which are kept, the march ended: {stopped}"
        stopped = stopped if stopped.endswith(".") else f"{stopped}."
    return March(MARCHES[type(problem)](problem, states), stopped, code)
