"""One load and speed out of an array of them, in any problem of steady frictional heat."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, TypeVar

import numpy as np

from winkler.numerics.types import Quantity
from winkler.values.errors import InvalidInput

Place = tuple[int, ...]
SPEEDS = ("first_speed", "second_speed")
Problem = TypeVar("Problem", bound=Any)


def one_result(solution: Any, index: int | Place) -> tuple[Place, dict[str, float]]:
    """Return the place of a result in the arrays of a solution, and its numbers by their names.

    Parameters
    ----------
    solution
        All of its fields but `problem` and `contact` are of one shape.
    index : int or tuple of int
        Which result.

    Raises
    ------
    InvalidInput
        If there is none.
    """
    shape = np.shape(getattr(solution, solution.per_load))
    try:
        which = int(np.arange(math.prod(shape)).reshape(shape)[index])
    except (IndexError, TypeError):
        raise InvalidInput(f"solution.at: there is no result {index!r} in a solution of shape {shape}.") from None
    place = tuple(int(each) for each in np.unravel_index(which, shape))
    names = [field.name for field in dataclasses.fields(solution) if field.name not in ("problem", "contact")]
    return place, {name: _one(getattr(solution, name), shape, place) for name in names}


def contact_at(contact: Any, loads: Place, shape: Place, place: Place) -> Any:
    """Return the contact of one result.

    Parameters
    ----------
    contact
        Of all loads.
    loads, shape : tuple of int
        Shape of the loads, and that of the results.
    place : tuple of int
        Which result.
    """
    if not loads:
        return contact
    which = np.broadcast_to(np.arange(math.prod(loads)).reshape(loads), shape)[place]
    return contact.at(tuple(int(each) for each in np.unravel_index(int(which), loads)))


def one_problem(
    problem: Problem, shape: Place, place: Place, *, many: tuple[str, ...] = SPEEDS, **given: Any
) -> Problem:
    """Return the problem of one result: the fields that may be of `many` results, and those that are `given`."""
    ones = {name: _one(getattr(problem, name), shape, place) for name in many}
    changed: Problem = dataclasses.replace(problem, **ones, **given)
    return changed


def _one(quantity: Quantity, shape: Place, place: Place) -> float:
    return float(np.broadcast_to(quantity, shape)[place])
