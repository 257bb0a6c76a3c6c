"""What fretting and sliding have in common: how a worn contact begins, and what is known of it at each of its goals."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np

from winkler.errors import OutsideValidity
from winkler.numerics.types import Array
from winkler.problems.normal.indentation import Indentation
from winkler.problems.wear.grids import wear_grid
from winkler.problems.wear.march import WearMoment, WearProblem, march_wear, scale_of
from winkler.problems.wear.nodes import first_nodes
from winkler.problems.wear.worn_grid import WornContact

__all__ = ["PressedMoment", "pressed_moment", "round_nodes", "worn_states"]


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
        places = nodes()
        moment = WearMoment(0.0, 0.0, places, np.zeros((2, places.size)))
        if problem.goals[0] == 0.0:
            yield problem.state(moment)
    else:
        moment = start.moment
    for reached in march_wear(problem, problem.goals, moment, everywhere=everywhere):
        yield problem.state(reached)


def round_nodes(problem: Any, core: Callable[[float, Array], float] | None = None) -> Array:
    """Return the radii on which a round contact begins to wear.

    Where something sticks, `core` returns the stick radius before wear, from the contact radius and even nodes [m].
    """
    radius = float(Indentation(problem.bed, problem.normal).solve().radius)
    if not radius > 0.0:
        owner = type(problem).__name__
        raise OutsideValidity(f"{owner}: the bodies do not touch under this load; press them together.")
    nodes = first_nodes(problem.bed, problem.normal, radius, 0.0, problem.count)
    if core is None:
        return nodes
    # it gets a node of its own
    return first_nodes(problem.bed, problem.normal, radius, core(radius, nodes), problem.count)


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
