"""The protocols of solutions that studies, tables, fields and pictures rely on, and how states become a solution.

A `Solution` names its problem and says how far it can be trusted; its public fields and properties that the glossary
gives a unit are its numbers, all along one axis (`Solution.other_axes` names those that are not).  A problem that is a
`March` yields state after state along its path, and `gather` makes columns of them.  A state or a solution for one load
that is `Restorable` holds the displacement of its springs, from which the fields in the bodies follow.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any, ClassVar, Protocol, TypeGuard, TypeVar

import numpy as np

from winkler.values.checks.contract import keeps

if TYPE_CHECKING:
    from winkler.foundation.bed import PressedSprings
    from winkler.foundation.sheared import ShearedSprings
    from winkler.foundation.sheared_fields import BodyFields, ShearedFields
    from winkler.media.medium import Medium
    from winkler.numerics.types import Array
    from winkler.values.validity import Note

Result = TypeVar("Result")


class Posed(Protocol):
    """What names the problem that it belongs to."""

    @property
    def problem(self) -> Any:
        """What was solved."""


class Assessed(Protocol):
    """What states its assumptions."""

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""


class Solution(Posed, Assessed, Protocol):
    """What the ``solve()`` of a problem returns.

    A class may have an attribute ``other_axes``: the names of its arrays that run along another axis than its numbers,
    such as places in the contact beside loads; they are no columns of its table.
    """


class March(Protocol):
    """A problem that is solved step by step along its path: it can be watched, and stopped with what it has reached."""

    @property
    def total(self) -> int | None:
        """How many states `steps` yields, at most; None if that is not known before."""

    def steps(self) -> Iterator[Any]:
        """Yield state after state."""

    def gathered(self, states: Iterable[Any]) -> Any:
        """Return the solution from the states of the whole march or of its beginning."""


class History(Protocol):
    """A solution that holds the state at each point of its path."""

    @property
    def states(self) -> tuple[Any, ...]:
        """All jumps in the order of the path."""


class ManyLoads(Protocol):
    """A solution of one load, or of many loads at once."""

    per_load: ClassVar[str]
    """Name of a number that it has for each load."""

    def at(self, index: Any) -> Any:
        """Return the solution of one of them."""


class Restorable(Protocol):
    """A solution whose springs are known."""

    @property
    def pressed(self) -> PressedSprings:
        """The displacement of the springs."""


class Dragged(Protocol):
    """A solution whose springs are known along the surface too."""

    @property
    def sheared(self) -> ShearedSprings:
        """The displacement of the springs, across and along the surface."""


class SelfRestoring(Protocol):
    """A state that restores its own fields, since those along the surface are none of its springs across it."""

    @property
    def radius(self) -> float:
        """Radius of the contact [m]."""

    @property
    def medium(self) -> Medium:
        """The bodies."""

    def sharp_places(self) -> tuple[float, ...]:
        """Return distances from the axis at which stresses on the surface are infinite [m]."""

    def surface_fields(self, r: Array) -> ShearedFields:
        """Return what happens on the surface at distances from the axis [m]."""

    def body_fields(self, x: Array, y: Array, z: Array) -> BodyFields:
        """Return stresses and displacements at places inside the bodies [m]."""


class Worn(Protocol):
    """A state of a contact that wears: what both bodies have lost, place by place."""

    @property
    def first_worn(self) -> Array:
        """Lost by the first body [m]."""

    @property
    def second_worn(self) -> Array:
        """Lost by the second body [m]."""


class Recovering(Protocol):
    """A state whose springs are known one by one, also those that have let go and recover on their own."""

    @property
    def position(self) -> Array:
        """Places of the springs [m]."""

    @property
    def recess(self) -> Array:
        """How far each is pressed in [m]."""

    @property
    def depth(self) -> float:
        """Depth of the body [m]."""

    @property
    def radius(self) -> float:
        """Radius of the contact [m]."""


def is_solution(solution: Any) -> TypeGuard[Solution]:
    """Return whether a value is what a problem's ``solve()`` returns."""
    return dataclasses.is_dataclass(solution) and not isinstance(solution, type) and keeps(solution, Solution)


def is_march(problem: Any) -> TypeGuard[March]:
    """Return whether a problem marches."""
    return keeps(problem, March)


def is_history(solution: Any) -> TypeGuard[History]:
    """Return whether a solution holds its states."""
    return keeps(solution, History)


def many_loads(solution: Any) -> TypeGuard[ManyLoads]:
    """Return whether a solution can be reduced to one of its loads."""
    return keeps(solution, ManyLoads)


def is_restorable(solution: Any) -> TypeGuard[Restorable]:
    """Return whether a solution has springs; they are not computed for the test."""
    return keeps(solution, Restorable)


def is_dragged(solution: Any) -> TypeGuard[Dragged]:
    """Return whether a solution has springs along the surface; they are not computed for the test."""
    return keeps(solution, Dragged)


def is_self_restoring(solution: Any) -> TypeGuard[SelfRestoring]:
    """Return whether a state restores its own fields."""
    return keeps(solution, SelfRestoring)


def is_worn(state: Any) -> TypeGuard[Worn]:
    """Return whether a state is one of a contact that wears."""
    return keeps(state, Worn)


def is_recovering(solution: Any) -> bool:
    """Return whether a state holds springs that have let go."""
    return keeps(solution, Recovering)


def gather(solution: type[Result], problem: Any, states: Iterable[object], **others: Any) -> Result:
    """Return the solution of a march: every quantity as an array over the states, in the order of the march.

    Parameters
    ----------
    solution : type
        The class; its fields are attributes of the states, but for ``problem``, ``states`` and the ``last`` of them.
    problem
        What was solved.
    states : iterable
        Of the whole march or of its beginning.
    **others
        Fields that are computed by other means.
    """
    reached = tuple(states)
    fields = {"problem": problem, "states": reached, **({"last": reached[-1]} if reached else {}), **others}
    return solution(
        **{
            name: fields[name] if name in fields else np.array([getattr(state, name) for state in reached])
            for name in getattr(solution, "__dataclass_fields__", ())
        }
    )
