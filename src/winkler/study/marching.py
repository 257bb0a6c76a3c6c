"""Problems that march along a path: watched point after point, and kept if they stop early."""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple

import numpy as np

from winkler.errors import WinklerError
from winkler.loading import Force
from winkler.problems.fretting_wear import FrettingSolution, FrettingWear
from winkler.problems.sliding_wear import SlidingSolution, SlidingWear
from winkler.problems.surface_contact import SurfaceContact, SurfaceContactSolution
from winkler.problems.tangential import Tangential, TangentialSolution
from winkler.problems.torsion import Torsion, TorsionSolution
from winkler.problems.viscoelastic import ViscoelasticIndentation, ViscoelasticSolution
from winkler.problems.viscoelastic_adhesion import ViscoelasticAdhesion, ViscoelasticAdhesionSolution
from winkler.problems.viscoelastic_tangential import ViscoelasticTangential, ViscoelasticTangentialSolution
from winkler.study.keeping import KEPT, Keep

__all__ = ["ANEW", "INTERRUPTED", "MARCHES", "March", "Watch", "marched", "unwatched"]

INTERRUPTED = 130
"""What the command line returns if it was interrupted."""


def _gathered(answer: type) -> Callable[[Any, list[Any]], Any]:
    """Return what gathers states, of a whole path or of its beginning, into an answer with the same words."""
    words = [field.name for field in dataclasses.fields(answer) if field.name not in ("problem", "states")]
    keeps = any(field.name == "states" for field in dataclasses.fields(answer))

    def of(problem: Any, states: list[Any]) -> Any:
        columns: dict[str, Any] = {word: np.array([getattr(state, word) for state in states]) for word in words}
        return answer(problem, **columns, **({"states": tuple(states)} if keeps else {}))

    return of


MARCHES: dict[type, Callable[[Any, list[Any]], Any]] = {
    FrettingWear: FrettingSolution.of,
    SlidingWear: SlidingSolution.of,
    SurfaceContact: SurfaceContactSolution.of,
    Tangential: TangentialSolution.of,
    Torsion: _gathered(TorsionSolution),
    ViscoelasticAdhesion: _gathered(ViscoelasticAdhesionSolution),
    ViscoelasticIndentation: _gathered(ViscoelasticSolution),
    ViscoelasticTangential: ViscoelasticTangentialSolution.of,
}
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


ANEW = Keep("", "")
"""Keeps nothing, and knows of nothing."""


def _points(problem: Any) -> int:
    """Return how many states a march has."""
    if isinstance(problem, SurfaceContact):
        return int(np.size(problem.load.force if isinstance(problem.load, Force) else problem.load.depth))
    return int(problem.goals.size if isinstance(problem, KEPT) else problem.path.time.size)


def marched(problem: Any, watch: Watch = unwatched, keep: Keep = ANEW) -> March:
    """Solve a problem of `MARCHES`, and keep what was reached if it ends early.

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
        If it ends before its first point.
    """
    total = _points(problem)
    before = keep.reached(problem) if keep != ANEW else []
    marching = problem.steps(start=before[-1]) if before else problem.steps()
    states: list[Any] = []
    stopped, code = "", 0
    try:
        for state in watch(itertools.chain(before, marching), total):
            states.append(state)
            if keep != ANEW and len(states) > len(before):
                keep.write(problem, states)
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
