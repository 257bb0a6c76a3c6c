"""What type checkers are asked of the answers of all public problems, as lines of Python."""

from __future__ import annotations

import functools
import inspect
import re
import typing
from collections.abc import Iterator

import winkler
from winkler.numerics.types import PerLoad

HEADER = "import winkler as wk\nfrom winkler.numerics.types import Array\n"


def public_problems() -> dict[str, type]:
    """Return the public classes that are solved."""
    found = {name: getattr(winkler, name) for name in winkler.__all__}
    return {name: each for name, each in found.items() if inspect.isclass(each) and hasattr(each, "solve")}


def hints_of(of: object) -> object:
    """Return the class or the union of classes that a method returns, or its items if it yields."""
    returned = typing.get_type_hints(inspect.unwrap(of))["return"]
    items = typing.get_args(returned)
    return items[0] if typing.get_origin(returned) is Iterator else returned


def names_of(kind: object) -> list[str]:
    """Return the public fields and properties of a class, of a union those that all of its classes have."""
    classes = typing.get_args(kind) or (kind,)
    each = [
        {
            *(name for base in one.__mro__ for name, note in inspect.get_annotations(base).items()
              if "ClassVar" not in str(note)),
            *(name for name, _ in inspect.getmembers(one, lambda part: isinstance(part, property))),
            *(name for name, _ in inspect.getmembers(one, lambda part: isinstance(part, functools.cached_property))),
        }
        for one in classes
    ]  # fmt: skip
    return sorted(name for name in set.intersection(*each) if not name.startswith("_"))


def questions() -> tuple[str, dict[int, str]]:
    """Return lines that ask for the type of each public answer to one load, and line -> answer."""
    lines, asked = HEADER.splitlines(), {}

    def ask(expression: str, answer: str) -> None:
        lines.append(f"    reveal_type({expression})")
        asked[len(lines)] = answer

    for name, problem in public_problems().items():
        per_load = issubclass(problem, PerLoad)
        lines.append(f"def one_{name}(problem: wk.{name}{'[float]' if per_load else ''}) -> None:")
        lines.append("    solution = problem.solve()")
        kind = hints_of(problem.solve)
        for answer in names_of(kind):
            ask(f"solution.{answer}", f"{name}: {answer}")
        if "states" in names_of(kind):
            states = typing.get_args(typing.get_type_hints(kind)["states"])[0]
            for answer in names_of(states):
                ask(f"solution.states[0].{answer}", f"{name}: state {answer}")
        elif callable(getattr(problem, "steps", None)):
            lines.append("    for state in problem.steps():")
            for answer in names_of(hints_of(problem.steps)):
                lines.append(f"        reveal_type(state.{answer})")
                asked[len(lines)] = f"{name}: state {answer}"
        if per_load and hasattr(kind, "at"):
            lines.append(f"def many_{name}(problem: wk.{name}[Array]) -> None:")
            ask(f"problem.solve().at(0).{kind.per_load}", f"{name}: one of many {kind.per_load}")
    return "\n".join(lines) + "\n", asked


def undecided(told: str, page: str, asked: dict[int, str]) -> tuple[dict[str, str], set[str]]:
    """Return answer -> type of those that are anything, or a number as well as an array, and all that was told of.

    Parameters
    ----------
    told : str
        What mypy wrote.
    page : str
        Name of the file of `questions`.
    asked : dict
        Line -> answer.
    """
    found = re.findall(rf'{page}:(\d+): note: Revealed type is "(.*)"', told)
    types = {asked[int(line)]: re.sub(r"numpy\.ndarray\[.*?\]\]", "Array", kind) for line, kind in found}
    wrong = {answer: kind for answer, kind in types.items() if re.search(r"\bAny\b|\bfloat \| Array\b", kind)}
    return wrong, set(types)
