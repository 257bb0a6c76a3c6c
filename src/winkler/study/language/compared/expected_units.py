"""The unit of an expected number: that of the answer in its own problem.

A name may mean something else in two problems: the resistance of a constriction is in ohms where current flows, in
K/W where heat does.  A path is followed through the types of the solution, and through the problem itself.
"""

from __future__ import annotations

import functools
import types
import typing
from collections.abc import Iterable
from typing import Any

from winkler.study.language.study import named
from winkler.values.errors import InvalidInput, suggest
from winkler.values.vocabulary import GLOSSARY, own_word


@functools.cache
def solution_types(problem: type) -> tuple[type, ...]:
    """Return the classes of solutions that ``solve`` of a class of problems states to return."""
    return _classes(typing.get_type_hints(problem.solve).get("return"))  # type: ignore[attr-defined]


def unit_of_quantity(quantity: str, problem: Any = None) -> str:
    """Return the unit of an expected quantity; of a path such as ``problem.bed.medium.modulus``, that of its end.

    Parameters
    ----------
    quantity
        A name, or a path with points; numbers at the end count among many answers, ``shear_force.-1`` is the last one.
    problem
        The problem whose solution is asked; without one, the glossary knows the unit.

    Raises
    ------
    InvalidInput
        If neither the solution nor the glossary knows the name as a quantity.
    """
    last = named(quantity)
    parts = [part for part in quantity.split(".") if not part.removeprefix("-").isdecimal()]
    owners = () if problem is None else solution_types(problem.__class__)
    if problem is not None and parts[0] == "problem":
        owners = (type(problem),)
        for part in parts[1:-1]:
            problem = getattr(problem, part, None)
            owners = (type(problem),)
    else:
        for part in parts[:-1]:
            owners = tuple(dict.fromkeys(cls for owner in owners for cls in _classes(_hint(owner, part))))
    for found in (*(own_word(owner, last) for owner in owners), GLOSSARY.get(last)):
        if found is not None and found.unit is not None:
            return found.unit
    names = sorted({*_quantities(GLOSSARY), *(name for owner in owners for name in _own_quantities(owner))})
    raise InvalidInput(f"quantity is '{last}'{suggest(last, names)}; give an answer of the problem or its path.")


def _quantities(entries: Any) -> Iterable[str]:
    return (name for name, entry in entries.items() if entry.unit is not None)


def _own_quantities(owner: type) -> Iterable[str]:
    return (name for cls in owner.__mro__ for name in _quantities(vars(cls).get("__words__", {})))


def _hint(owner: type, name: str) -> Any:
    """Return the type of a field or property of a class, None if it states none."""
    member = getattr(owner, name, None)
    getter = getattr(member, "fget", None) or getattr(member, "func", None)
    try:
        return typing.get_type_hints(getter).get("return") if getter else typing.get_type_hints(owner).get(name)
    except NameError:  # a name that is imported for type checkers alone
        return None


def _classes(hint: Any) -> tuple[type, ...]:
    """Return the classes of a type, of each of its alternatives."""
    if typing.get_origin(hint) in (typing.Union, types.UnionType, tuple):
        return tuple(cls for one in typing.get_args(hint) for cls in _classes(one))
    return (hint,) if isinstance(hint, type) else ()
