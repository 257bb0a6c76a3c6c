"""What fretting and sliding have in common: how a worn contact begins, and what is known of it at each of its goals."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from typing import Any, ClassVar, NamedTuple, TypeVar

import numpy as np

from winkler.laws.wear import WearLaw
from winkler.numerics.types import Array
from winkler.problems.answer import gather
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.wear.grids import wear_grid
from winkler.problems.wear.march import WearMoment, WearProblem, march_wear, scale_of
from winkler.problems.wear.nodes import first_nodes
from winkler.problems.wear.states import goals_of
from winkler.problems.wear.worn_grid import WornContact
from winkler.problems.wear.worn_layers import laws_on, layer_loses, refuse_thin, refuse_wear_of_layers
from winkler.values.errors import OutsideValidity
from winkler.values.value import words

Solution = TypeVar("Solution")


class AtGoals:
    """The part of a problem of wear that says after how many cycles or distances its contact is returned."""

    __words__ = words(
        goals=("n", None, "after how many cycles, or which distances, the contact is returned"),
    )

    bed: Any
    wear: WearLaw
    layer_wears: bool

    _along: ClassVar[str] = "cycles"
    _unit: ClassVar[str] = ""

    def __post_init__(self) -> None:
        refuse_wear_of_layers(type(self).__name__, self.bed.medium, self.wear, layer_wears=self.layer_wears)
        _ = self.goals  # refused if they do not rise

    @property
    def laws(self) -> WearLaw:
        """How the bodies wear: one law alone is that of the first, or on layers that stay as they are, the second."""
        return laws_on(self.bed.medium, self.wear, layer_wears=self.layer_wears)

    @property
    def goals(self) -> Array:
        """Where the contact is returned: after these cycles, or distances [m], ``(steps,)``."""
        return goals_of(type(self).__name__, self._along, self._unit, getattr(self, self._along))

    @property
    def total(self) -> int:
        """How many states `steps` yields: one for each of `goals`."""
        return int(self.goals.size)

    def reached(self, elapsed: float) -> str:
        """Return how far wear has come, in words and with its unit."""
        return f"{elapsed:.6g} cycles"

    @property
    def most_worn(self) -> float:
        """Infinite: sliding goes on, and where fretting ends is not known before."""
        return math.inf

    def refuse(self, contact: WornContact, elapsed: float) -> None:
        """Refuse to wear much of a layer."""
        if layer_loses(self.bed.medium, self.wear, layer_wears=self.layer_wears):
            refuse_thin(type(self).__name__, self.bed.medium, contact.worn_depth, self.reached(elapsed))


class OfDistance(AtGoals):
    """The part of a problem of steady sliding that says where its contact is returned; wear has no end."""

    _along: ClassVar[str] = "distance"
    _unit: ClassVar[str] = " in m"

    def reached(self, elapsed: float) -> str:
        """As `AtGoals.reached`: a distance."""
        return f"{elapsed:.6g} m of sliding"

    def slipped(self, grid: Any, contact: WornContact) -> Array:
        """Return how far the surfaces slip per distance: all of it."""
        return np.ones(grid.nodes.size)


def worn_states(problem: Any, start: Any, nodes: Callable[[], Array], *, everywhere: bool) -> Iterator[Any]:
    """Yield the states of a contact at its goals, after a state reached before if one is given.

    Parameters
    ----------
    problem : WearProblem
        With `goals` and `state`.
    start : WearState, LineWearState or None
    nodes : callable
        Returns the nodes on which wear begins [m].
    everywhere : bool
        As of `march_wear`.
    """
    if start is None:
        moment = unworn(nodes())
        if problem.goals[0] == 0.0:
            yield problem.state(moment)
    else:
        moment = start.moment
    for reached in march_wear(problem, problem.goals, moment, everywhere=everywhere):
        yield problem.state(reached)


def unworn(nodes: Array) -> WearMoment:
    """Return the moment before wear, on these nodes [m]."""
    return WearMoment(0.0, 0.0, nodes, np.zeros((2, nodes.size)))


def round_nodes(problem: Any, core: Callable[[IndentationSolution], float] | None = None) -> Array:
    """Return the radii on which a round contact begins to wear.

    Where something sticks, `core` returns the stick radius before wear [m], which gets a node of its own.
    """
    pressed = Indentation(problem.bed, problem.normal).solve()
    radius = float(pressed.radius)
    if not radius > 0.0:
        owner = type(problem).__name__
        raise OutsideValidity(f"{owner}: the bodies do not touch under this load; press them together.")
    return first_nodes(problem.bed, problem.normal, radius, core(pressed) if core else 0.0, problem.count)


class PressedMoment(NamedTuple):
    """A contact that has come so far.

    Parameters
    ----------
    contact : WornContact
    touching : float
        Up to where the surfaces touch [m].
    common : dict
        Fields that all states of worn contacts have.
    """

    contact: WornContact
    touching: float
    common: dict[str, Any]


def pressed_moment(problem: WearProblem, moment: WearMoment) -> PressedMoment:
    """Return the contact at a moment; refuse one that cannot go on."""
    grid, worn = wear_grid(problem.bed, moment.nodes), moment.worn.sum(axis=0)
    contact = grid.press(worn, problem.normal)
    problem.refuse(contact, moment.elapsed)
    touching = grid.touching(contact, worn, problem.tolerance * scale_of(problem, grid, contact))
    common = {"bed": problem.bed, "elapsed": moment.elapsed, "jump": moment.jump, "first_worn": moment.worn[0],
              "second_worn": moment.worn[1], "pressure": contact.pressure}  # fmt: skip
    return PressedMoment(contact, touching, common)


def worn_history(solution: type[Solution], problem: AtGoals, states: Iterable[Any]) -> Solution:
    """Return the solution made of these states, of the whole path or of its beginning."""
    reached = list(states)
    return gather(solution, problem, reached, **{problem._along: np.array([state.elapsed for state in reached])})
