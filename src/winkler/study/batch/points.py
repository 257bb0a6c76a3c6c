"""The points of a study: solved, recalled from a journal, or failed."""

from __future__ import annotations

import functools
from collections.abc import Iterator
from typing import Any, cast

import numpy as np

from winkler.numerics.types import Array, Quantity
from winkler.problems.answer import is_history, is_march, many_loads
from winkler.study.batch.events import Event, events_of
from winkler.study.batch.marching import solve_march
from winkler.study.language.study import Expectation
from winkler.values.validity import Note
from winkler.values.value import value

IN_THE_PLANE = (
    ("shear_force_x", "shear_force_y"),
    ("longitudinal_force", "lateral_force"),
    ("x_force", "y_force"),
    ("longitudinal_creepage", "lateral_creepage"),
)
"""Components of forces and creepages that are sums over many elements."""
MOMENTS = ("moment", "torque")
PASSED = frozenset(("time", "distance", "cycles", "cycle", "shear_force"))
"""Answers of paths and histories."""
ROUNDING, ALONG_PATH = 1e-7, 1e-12
"""Parts that are rounding: of the greatest force or component in the plane, to which grids are solved; of the greatest
number along a path."""


def _without_rounding(answers: dict[str, Array], *, along_path: bool, of: Any) -> dict[str, Array]:
    """Return answers with zero for rounding; of a problem, whose path they may be along."""
    sizes = {name: _greatest(answers.get(name.removesuffix("_per_cycle"), answers[name])) for name in answers}
    least = {name: ALONG_PATH * size * along_path for name, size in sizes.items()}
    for pair in IN_THE_PLANE:
        if all(name in answers for name in pair):
            whole = pair if "creepage" in pair[0] else (*pair, "force")
            size = max(sizes[name] for name in whole if name in answers)
            least |= dict.fromkeys(pair, ROUNDING * size)
            if "force" in whole:
                arm = max(map(_greatest, (answers.get("area", np.zeros(1)) ** 0.5, sides_of_map(of))))
                least |= {name: ROUNDING * size * arm for name in MOMENTS if name in answers}
    return {name: np.where(np.abs(content) < least[name], 0.0, content) for name, content in answers.items()}


def _greatest(content: Any) -> float:
    """Return the size of the greatest finite number; zero where there is none."""
    return float(np.max(np.abs(content), initial=0.0, where=np.isfinite(content)))


def sides_of_map(problem: Any) -> Array:
    """Return the sides of the height map of a problem, or of the contact that it takes [m]; empty without one.

    Parameters
    ----------
    problem
        Any.
    """
    if isinstance(side := getattr(problem, "side", None), float):
        return np.array([side, side])
    sides = getattr(getattr(getattr(problem, "contact", problem), "topography", None), "lengths", None)
    return np.zeros(0) if sides is None else np.asarray(sides)


class _WithAnswers:
    """A point with answers and a solution."""

    found: tuple[tuple[str, Quantity], ...]
    solution: Any

    @property
    def answers(self) -> dict[str, Array]:
        """Name -> numbers of shape (loads,), SI."""
        count = max((content.size for _, content in self.found if isinstance(content, np.ndarray)), default=1)
        return {
            name: np.broadcast_to(number.ravel(), (count,))
            if isinstance(number, np.ndarray)
            else np.full(count, number)
            for name, number in self.found
        }

    @property
    def readable(self) -> dict[str, Array]:
        """The same, with zero for what is rounding alone, as readers are shown it.

        Rounding is what remains of a component of forces, creepages or moments in the plane whose parts cancel, of a
        number along a path that returns to zero, and of the difference of two cycles.
        """
        problem, answers = cast("Any", self).problem, self.answers
        return _without_rounding(answers, along_path=is_march(problem) or not PASSED.isdisjoint(answers), of=problem)

    @property
    def each(self) -> tuple[Any, ...]:
        """The solution load by load: one scalar solution for every load."""
        return tuple(_loads(self.solution))


@value
class Solved(_WithAnswers):
    """A point of the study that was solved; see the module for its parts.

    A march that ended before the end of its path states why in `stopped`; `code` is then the exit code.
    """

    index: tuple[int, ...]
    settings: tuple[Any, ...]
    problem: Any
    solution: Any
    found: tuple[tuple[str, Quantity], ...]
    surface: tuple[Any, ...] = ()
    subsurface: tuple[Any, ...] = ()
    stopped: str = ""
    code: int = 0

    @property
    def answer_type(self) -> type:
        """Class of the solution."""
        return type(self.solution)

    def events(self, name: str) -> tuple[tuple[Event, ...], ...]:
        """Return one row for each event of a kind (`winkler.study.batch.events`)."""
        return events_of(self.solution, name)

    @functools.cached_property
    def validity(self) -> tuple[Note, ...]:
        """What was assumed and checked; it may take as long as solving."""
        return tuple(getattr(self.solution, "validity", ()))


def _loads(solution: Any) -> Iterator[Any]:
    if is_history(solution):
        yield from solution.states
        return
    shape = np.shape(getattr(solution, solution.per_load)) if many_loads(solution) else ()
    if not shape:
        yield solution
        return
    for index in np.ndindex(shape):
        yield solution.at(index[0] if len(index) == 1 else index)


@value
class Failed:
    """A point of the study that has no answer, and why.

    Parameters
    ----------
    index, settings, problem
        As for `Solved`.
    reason
        The sentence of the error.
    code
        Exit code of the command line: 2 input, 3 not converged, 4 outside validity, 70 a mistake of winkler.
    traceback
        Traceback of an error that winkler does not raise on purpose: a mistake of its own, or too little memory.
        Such a point is tried again when a stopped sweep is continued; empty for all others.
    """

    index: tuple[int, ...]
    settings: tuple[Any, ...]
    problem: Any
    reason: str
    code: int
    traceback: str = ""


@value
class ComparedNumber:
    """Comparison of an expected with a computed number.

    Parameters
    ----------
    index
        Point of the sweep.
    expectation
        The expected number.
    got : float or ndarray
        The computed number.
    deviation
        Largest deviation, relative to the scale of the expectation; infinite if there is no number.
    """

    index: tuple[int, ...]
    expectation: Expectation
    got: Quantity
    deviation: float

    @property
    def passed(self) -> bool:
        """Whether the deviation is within the tolerance."""
        return self.deviation <= self.expectation.tolerance

    @property
    def digits(self) -> float:
        """Decimal digits that agree, at most 16."""
        return float(min(16.0, max(0.0, -np.log10(max(self.deviation, 1e-16)))))


@value
class Recalled(_WithAnswers):
    """A point of the study of which only the numbers were kept: of a long sweep, or from a journal.

    Parameters
    ----------
    index, settings, problem, found, surface, subsurface, stopped, code
        As for `Solved`.
    answer_type
        Class of the solution.
    validity
        What was assumed and checked.
    event_rows
        ``(kind of event, rows)``.
    verdicts
        Comparisons with the expected numbers.
    """

    index: tuple[int, ...]
    settings: tuple[Any, ...]
    problem: Any
    found: tuple[tuple[str, Quantity], ...]
    answer_type: type
    validity: tuple[Note, ...] = ()
    event_rows: tuple[tuple[str, tuple[tuple[Event, ...], ...]], ...] = ()
    verdicts: tuple[ComparedNumber, ...] = ()
    surface: tuple[Any, ...] = ()
    subsurface: tuple[Any, ...] = ()
    stopped: str = ""
    code: int = 0

    def events(self, name: str) -> tuple[tuple[Event, ...], ...]:
        """Return one row for each event of a kind (`winkler.study.batch.events`)."""
        return dict(self.event_rows).get(name, ())

    @property
    def solution(self) -> Any:
        """The solution, computed once more."""
        return _solved_again(self.problem)


SolvedPoint = Solved | Recalled
Point = Solved | Recalled | Failed


@functools.lru_cache(maxsize=1)
def _solved_again(problem: Any) -> Any:
    return solve_march(problem).solution if is_march(problem) else problem.solve()
