"""What fretting and sliding have in common: how a worn contact begins, and what is known of it at each of its goals."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from winkler.errors import OutsideValidity
from winkler.numerics.types import Array
from winkler.problems.normal.indentation import Indentation
from winkler.problems.wear.line import WearLine, WornContact, wear_line
from winkler.problems.wear.march import WearMoment, WearProblem, first_nodes, march_wear, scale_of

__all__ = ["pressed_moment", "worn_states"]


def worn_states(problem: Any, start: Any, core: Callable[[float, Array], float] | None = None) -> Iterator[Any]:
    """Yield the states of a contact at its goals, after a state reached before if one is given.

    Where something sticks, `core` returns the stick radius before wear, from the contact radius and even nodes [m].
    """
    if start is None:
        radius = float(Indentation(problem.bed, problem.normal).solve().radius)
        if not radius > 0.0:
            owner = type(problem).__name__
            raise OutsideValidity(f"{owner}: the bodies do not touch under this load; press them together.")
        nodes = first_nodes(problem.bed, problem.normal, radius, 0.0, problem.count)
        if core is not None:  # it gets a node of its own
            nodes = first_nodes(problem.bed, problem.normal, radius, core(radius, nodes), problem.count)
        moment = WearMoment(0.0, 0.0, nodes, np.zeros((2, nodes.size)))
        if problem.goals[0] == 0.0:
            yield problem.state(moment)
    else:
        moment = start.moment
    for reached in march_wear(problem, problem.goals, moment, everywhere=core is None):
        yield problem.state(reached)


def pressed_moment(problem: WearProblem, moment: WearMoment) -> tuple[WearLine, WornContact, dict[str, Any]]:
    """Return the springs, the contact on them, and the numbers of a `winkler.problems.wear.states.WearState`."""
    line, worn = wear_line(problem.bed, moment.nodes), moment.worn.sum(axis=0)
    contact = line.press(worn, problem.normal)
    problem.refuse(contact, moment.elapsed)
    radius = line.touching(contact, worn, problem.tolerance * scale_of(problem, contact))
    common = {"bed": problem.bed, "elapsed": moment.elapsed, "jump": moment.jump, "radii": moment.nodes,
             "first_worn": moment.worn[0], "second_worn": moment.worn[1], "depth": contact.depth,
             "force": contact.force, "radius": radius, "pressure": contact.pressure}  # fmt: skip
    return line, contact, common
