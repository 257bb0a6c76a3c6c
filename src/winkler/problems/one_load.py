"""One load out of an array of loads, with its depth, force and contact radius, or one state of a path."""

from __future__ import annotations

import functools
from collections.abc import Iterator, Sequence
from typing import Any, Generic, TypeVar

import numpy as np

from winkler.loading.loads import Depth, Force, Load, Radius
from winkler.numerics.types import Quantity
from winkler.values.errors import InvalidInput

State = TypeVar("State")


class RestoredStates(Sequence[State]):
    """The states of a path that was followed in blocks: restored by its steps, when another than the last is asked for.

    Parameters
    ----------
    problem
        What was solved.
    last
        The state at the last point.
    """

    def __init__(self, problem: Any, last: State) -> None:
        self.problem, self.last = problem, last

    @functools.cached_property
    def _all(self) -> tuple[State, ...]:
        return tuple(self.problem.steps())

    def __len__(self) -> int:
        return int(self.problem.total)

    def __getitem__(self, index: Any) -> Any:
        return self.last if index in (-1, len(self) - 1) else self._all[index]

    def __iter__(self) -> Iterator[State]:
        return iter(self._all)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, RestoredStates | tuple) and self._all == tuple(other)

    def __hash__(self) -> int:
        return hash(self._all)

    def __repr__(self) -> str:
        return f"{len(self)} x {type(self.last).__name__}"

    def __reduce__(self) -> Any:
        return RestoredStates, (self.problem, self.last)


class OfPath(Generic[State]):
    """The part of a solution that holds its states, one for each point of a path."""

    states: Sequence[State]

    def at(self, index: int) -> State:
        """Return the state at one point of the path.

        Parameters
        ----------
        index : int
            Which one.

        Raises
        ------
        InvalidInput
            If there is no such point.
        """
        try:
            return self.states[index]
        except (IndexError, TypeError):
            raise InvalidInput(
                f"solution.at: there is no point {index!r} on a path of {len(self.states)} points."
            ) from None


def picked(
    load: Load, index: int | tuple[int, ...], depth: Quantity, force: Quantity, radius: Quantity
) -> tuple[Force[float] | Depth[float] | Radius[float], float, float, float]:
    """Return one load, of the kind that was prescribed, and its depth [m], force [N] and radius [m].

    Parameters
    ----------
    load : Force, Depth or Radius
        What was prescribed.
    index : int or tuple of int
        Which one.
    depth, force, radius : float or ndarray
        The results, of one shape.

    Raises
    ------
    InvalidInput
        If there is no such load.
    """
    d, f, a = one_of(index, depth, force, radius)
    match load:
        case Depth():
            return Depth(d), d, f, a
        case Force():
            return Force(f), d, f, a
        case _:
            return Radius(a), d, f, a


def one_of(index: int | tuple[int, ...], *results: Quantity) -> tuple[float, ...]:
    """Return one number of each of several results of one shape.

    Parameters
    ----------
    index : int or tuple of int
        Which one.
    *results : float or ndarray
        Of one shape.

    Raises
    ------
    InvalidInput
        If there is no such load.
    """
    try:
        return tuple(float(np.asarray(result)[index]) for result in results)
    except (IndexError, TypeError):
        raise InvalidInput(
            f"solution.at: there is no load {index!r} in a solution of shape {np.shape(results[0])}."
        ) from None


def single(depth: Quantity, requested: str) -> float:
    """Return the depth of a solution of one load; refuse an array of them, of which nothing can be drawn or restored.

    Parameters
    ----------
    depth : float or ndarray
        d [m].
    requested : str
        What is requested, the end of the error sentence.

    Raises
    ------
    InvalidInput
        If there are many.
    """
    if np.ndim(depth) != 0:
        raise InvalidInput(
            f"This solution holds {np.size(depth)} loads; pick one with solution.at(index) before requesting its "
            f"{requested}."
        )
    return float(depth)
