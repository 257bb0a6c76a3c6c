"""Numbers at a place for ``[[expect]]``: of a field on the surface or inside the bodies, or along x.

A number behind the name is an index among many contacts, ``pressure.-1`` the last load or point of a path; then that of
a component, ``traction.-1.0`` the traction along x there.
"""

from __future__ import annotations

import re
from typing import Any

import numpy as np

from winkler.fields.restoration import restore, restore_body
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, suggest


def number_at(solution: Any, quantity: str, place: dict[str, float]) -> float:
    """Return one number of a field, or of a function of the springs.

    Parameters
    ----------
    solution
        The answer to a problem.
    quantity
        Name of the field or function, with numbers behind it where there are many loads, points or components; a
        function may be that of a part, ``first.temperature``.
    place
        x along the springs; r on the surface, r and z below it; or x, y, z in the axes of the bodies [m].

    Raises
    ------
    InvalidInput
        If there is no such field, function, point or component.
    """
    if list(place) == ["x"]:
        return _function_value(solution, quantity, place["x"])
    name, rows = _split_name(quantity)
    contact, rows = _contact(solution, name, rows)
    where = [np.array([number]) for number in place.values()]
    fields = restore_body(contact, *where) if "y" in place else restore(contact, *where)
    content = None if name.startswith("_") else getattr(fields, name, None)
    if not isinstance(content, np.ndarray) or name in place:
        public = (key for key in dir(fields) if not key.startswith("_") and key not in ("r", "x", "y", "z"))
        names = [key for key in public if not callable(getattr(fields, key))]
        raise InvalidInput(
            f"expect: quantity '{name}' is not one of {type(fields).__name__}{suggest(name, names)}; there are "
            f"{', '.join(names)}."
        )
    return _component(name, content, rows)


def _function_value(solution: Any, quantity: str, x: float) -> float:
    """Return the number of a function of x of the solution, or of one of its parts, ``first.temperature``."""
    owner, *parts = quantity.split(".")
    function = getattr(solution, owner, None)
    for part in parts:
        function = None if part.startswith("_") else getattr(function, part, None)
    if not callable(function):
        raise InvalidInput(f"expect: {quantity} is no function of x of {type(solution).__name__}; leave x out.")
    return float(np.ravel(function(np.array([x])))[0])


def _split_name(quantity: str) -> tuple[str, list[int]]:
    """Return the name, and the numbers behind it."""
    name, numbers = re.fullmatch(r"(.*?)((?:\.-?\d{1,9})*)", quantity, re.DOTALL).groups()  # type: ignore[union-attr]
    return name, [int(number) for number in numbers.split(".")[1:]]


def _contact(solution: Any, name: str, rows: list[int]) -> tuple[Any, list[int]]:
    """Return the contact of one load, or at one point of a path, and the numbers that are left."""
    count = len(getattr(solution, "states", ())) or sum(np.shape(getattr(solution, "depth", 0.0)))
    if not count:
        return solution, rows
    if not rows:
        raise InvalidInput(f"expect: {name} is of {count} contacts; name one, as {name}.-1 the last.")
    if not -count <= rows[0] < count:
        raise InvalidInput(f"expect: {name}.{rows[0]} asks for one of {count} contacts; count from 0.")
    return solution.at(rows[0]), rows[1:]


def _component(name: str, content: Array, rows: list[int]) -> float:
    """Return the only number, or one of the components of a direction."""
    numbers = np.ravel(content)
    if len(rows) != (numbers.size > 1):
        advice = "name one by a number behind it, from 0" if numbers.size > 1 else "leave out the number behind it"
        raise InvalidInput(f"expect: {name} has {numbers.size} component{'s' * (numbers.size > 1)}; {advice}.")
    if rows and not -numbers.size <= rows[0] < numbers.size:
        raise InvalidInput(f"expect: {name} has {numbers.size} components, but {rows[0]} is asked for; count from 0.")
    return float(numbers[rows[0] if rows else 0])
