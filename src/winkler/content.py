"""What may stand in the fields of a value, read from their types; and numbers beyond all physics.

`winkler.values.value` asks this page for every class.  A class's own checks come first, as their sentences are better;
what they let through is looked at here, so that no bed is a number and no radius a text or 1e308 m.
"""

from __future__ import annotations

import contextlib
import dataclasses
import functools
import math
import re
import typing
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple, ParamSpec, TypeVar

import numpy as np

from winkler.contract import fits, lacking, listed
from winkler.errors import InvalidInput, NotConverged, OutsideValidity, WinklerError
from winkler.vocabulary import word

__all__ = [
    "FAULTS",
    "LARGEST",
    "Expected",
    "careful",
    "expected_of",
    "guarded",
    "guarded_answer",
    "guarded_stream",
    "refuse_size",
    "refuse_wrong",
]

P = ParamSpec("P")
R = TypeVar("R")

SMALLEST, LARGEST = 1e-60, 1e60
"""Numbers in SI units of what is given lie between these; squares and cubes of them are still numbers."""
LONGEST = 40
"""Bits of a whole number: nothing that is counted is counted further."""
GIVEN = ("materials", "laws", "profiles", "media", "loading", "path", "path_steps", "program")
"""Floors on which every value was given; on others only problems were, and these:"""
GIVEN_TOO = ("Contacts", "ForceCurve", "MeasuredBed")
NEVER_ZERO = (
    "curvature_radius", "deep_young", "depth_scale", "mass", "surface_young", "thickness", "transition_width", "young",
)  # fmt: skip
"""Fields that must be positive, and whose tiniest numbers keep solvers busy for ever; others may come near zero."""
NO_PART = (float, int, bool, complex, str, bytes, tuple, list, dict, set, object, type(None), np.ndarray)
"""What is never a part made of other values."""
NO_NUMBERS = (str, bytes, complex, dict, set, object, type(None))
NUMBERS = ("Array", "Quantity", "Array | float")
WORDS = {"float": "a number", "int": "a whole number below 10^12", "str": "a text", "bool": "True or False"}
FAULTS = (TypeError, ValueError, AttributeError, ArithmeticError, LookupError, RuntimeError)


class Expected(NamedTuple):
    """A field, how its type is written, what sort of content that is, and whether its size is looked at."""

    name: str
    written: str
    sort: str
    sized: bool


def expected_of(cls: Any) -> tuple[Expected, ...]:
    """Return what the fields of a dataclass may hold; fields whose type says nothing are left out."""
    parts = cls.__module__.split(".")
    given = len(parts) > 1 and (parts[1] in GIVEN or hasattr(cls, "solve") or cls.__name__ in GIVEN_TOO)
    found = []
    for field in dataclasses.fields(cls):
        written = field.type if isinstance(field.type, str) else getattr(field.type, "__name__", "")
        if sort := _sort(written):
            found.append(Expected(field.name, written, sort, given and field.init and _has_size(cls, field.name)))
    return tuple(found)


def _has_size(cls: Any, field: str) -> bool:
    """Return whether a field has a unit, and none with a power that depends on other fields."""
    try:
        unit = word(cls.__name__, field).unit
    except KeyError:
        return False
    return bool(unit) and not re.search(r"\([^)]*[a-zA-Z]", str(unit).replace("(m K)", ""))


def careful(cls: type) -> bool:
    """Return whether numbers that overflow in the checks of a class end them: those of values that are given."""
    parts = cls.__module__.split(".")
    return len(parts) > 1 and parts[1] in GIVEN


def _sort(written: str) -> str:
    if written in WORDS:
        return written
    if written in NUMBERS:
        return "numbers"
    if re.search(r"\b(Any|Array|Quantity|Callable)\b", written):
        return ""
    if re.fullmatch(r"[A-Z]\w*( \| [A-Z]\w*)*", written):
        return "part"
    return "parts" if re.fullmatch(r"tuple\[[A-Z]\w*( \| [A-Z]\w*)*, \.\.\.\]", written) else ""


def refuse_wrong(content: Any, expected: tuple[Expected, ...]) -> None:
    """Refuse a value one of whose fields holds what its type does not allow.

    Raises
    ------
    InvalidInput
        With the name of the field, what it was, and what is allowed.
    """
    for field in expected:
        inside = getattr(content, field.name)
        if _wrong(inside, field.sort) or not _fits(type(content), field, inside):
            wanted = _wanted(type(content), field)
            if field.sort == "part":
                lacks = lacking(type(content), field.name, inside)
                raise InvalidInput(
                    f"{type(content).__name__}: the {field.name} is a {type(inside).__name__}{lacks}; give {wanted}."
                )
            raise InvalidInput(f"{type(content).__name__}: {field.name} is {_shown(inside)}; give {wanted}.")
        if field.sized:
            smallest = SMALLEST if field.name in NEVER_ZERO else 0.0
            refuse_size(type(content).__name__, field.name, inside, smallest)


def refuse_size(owner: str, word: str, inside: Any, smallest: float = 0.0) -> None:
    """Refuse a number, or an array of numbers, beyond all physics.

    Parameters
    ----------
    owner, word
        Who takes it, and what it is called there.
    inside
        In SI units.
    smallest
        Least size of a single number that is not zero.

    Raises
    ------
    InvalidInput
    """
    if not _sized(inside, smallest):
        raise InvalidInput(
            f"{owner}: {word} is {_size(inside)}; numbers in SI units are between {SMALLEST:g} and {LARGEST:g} in "
            "size: check the unit."
        )


def _wrong(inside: Any, sort: str) -> bool:
    kind = type(inside)
    if sort == "float":
        return kind is not float and kind is not int
    if sort == "numbers":
        return kind in NO_NUMBERS or kind is bool or (kind is np.ndarray and inside.dtype.kind not in "fbc")
    if sort == "int":
        return kind is not int or bool(inside.bit_length() > LONGEST)
    if sort == "part":
        return kind in NO_PART
    if sort == "parts":
        return kind is not tuple or any(type(part) in NO_PART for part in inside)
    return kind is not {"str": str, "bool": bool}[sort]


def _fits(cls: type, field: Expected, inside: Any) -> bool:
    """Return whether the parts in a field are of the kinds that it names."""
    return field.sort not in ("part", "parts") or fits(cls, field.name, inside if field.sort == "parts" else (inside,))


def _sized(inside: Any, smallest: float = SMALLEST) -> bool:
    """Return whether a number is zero, or of a size that is met in physics; rows may begin near zero."""
    if _is_row(inside):
        inside = np.asarray(inside, dtype=float)
    kind = type(inside)
    if kind is float:
        return inside == 0.0 or not math.isfinite(inside) or smallest <= abs(inside) <= LARGEST
    if kind is int:
        return bool(inside.bit_length() < 200)
    if kind is np.ndarray and inside.dtype.kind == "f":
        return bool(np.max(np.abs(inside[np.isfinite(inside)]), initial=0.0) <= LARGEST)
    return True


def _wanted(cls: type, field: Expected) -> str:
    if field.sort in WORDS:
        return WORDS[field.sort]
    if field.sort == "numbers":
        return "a number or an array of numbers"
    try:
        hint = typing.get_type_hints(cls)[field.name]
    except (NameError, TypeError):  # a type that is known to type checkers only
        hint = field.written
    inner = typing.get_args(hint)
    if field.sort == "parts":
        return f"a list of {listed(inner[0])}"
    return listed(hint)


def _shown(inside: Any) -> str:
    if isinstance(inside, int) and inside.bit_length() > 200:
        return f"a whole number of about {round(inside.bit_length() * math.log10(2.0))} digits"
    if isinstance(inside, np.ndarray):
        return f"an array of the shape {inside.shape}"
    text = " ".join(repr(inside).split())
    return text if len(text) <= 60 else f"{text[:57]}..."


def _far(content: Any) -> Iterator[str]:
    """Yield what is beyond all physics in a value and in the values inside it."""
    if not dataclasses.is_dataclass(content):
        return
    for field in dataclasses.fields(content):
        inside = getattr(content, field.name)
        for part in inside if isinstance(inside, tuple) else (inside,):
            yield from _far(part)
        if isinstance(inside, float | int | np.ndarray) and not _sized(inside):
            yield f"{field.name} of {type(content).__name__} is {_size(inside)}"


def _size(inside: Any) -> str:
    """Return a number, or the greatest of many, as a sentence tells them."""
    row = isinstance(inside, np.ndarray) or _is_row(inside)
    return f"up to {np.nanmax(np.abs(inside)):g} in size" if row else _shown(inside)


def _is_row(inside: Any) -> bool:
    """Return whether something is a tuple of numbers."""
    return type(inside) is tuple and bool(inside) and all(type(part) in (float, int) for part in inside)


def guarded(solve: Callable[..., Any]) -> Callable[..., Any]:
    """Return a solver that tells in one sentence if numbers left the range of floating-point numbers.

    Numbers that a solver expects to overflow it treats itself; any other overflow, division by zero or undefined
    number ends it.
    """

    @functools.wraps(solve)
    def answered(self: Any, *given: Any, **named: Any) -> Any:
        with _told(self):
            return _known(solve(self, *given, **named))

    return answered


def guarded_answer(told: Callable[P, R]) -> Callable[P, R]:
    """Return what tells something of a solution, its first argument, guarded as what has solved its problem."""

    @functools.wraps(told)
    def answered(*given: P.args, **named: P.kwargs) -> R:
        with _told(getattr(given[0], "problem", given[0])):
            return told(*given, **named)

    return answered


def guarded_stream(steps: Callable[..., Iterator[Any]]) -> Callable[..., Iterator[Any]]:
    """Return a march whose every step is guarded as `guarded` does it; who iterates is left alone between them."""

    @functools.wraps(steps)
    def streamed(self: Any, *given: Any, **named: Any) -> Iterator[Any]:
        states = steps(self, *given, **named)
        while True:
            with _told(self):
                try:
                    state = _known(next(states))
                except StopIteration:
                    return
            yield state

    return streamed


def _known(answer: Any) -> Any:
    """Return an answer none of whose numbers is undefined; compiled kernels do not tell of those they meet."""
    for field in dataclasses.fields(answer) if dataclasses.is_dataclass(answer) else ():
        inside = getattr(answer, field.name)
        if isinstance(inside, np.ndarray):
            undefined = inside.dtype == float and bool(np.isnan(inside).any())
        else:
            undefined = isinstance(inside, float) and math.isnan(inside)
        if undefined:
            raise FloatingPointError(f"the {field.name} comes out undefined")
    return answer


@contextlib.contextmanager
def _told(problem: Any) -> Iterator[None]:
    """Turn arithmetic that leaves the range of numbers into one sentence about a problem."""
    try:
        with np.errstate(over="raise", divide="raise", invalid="raise"):
            yield
    except NotConverged as error:
        far = next(_far(problem), "")
        if not far:
            raise
        # what does not settle is the size of the numbers, not the shape
        raise OutsideValidity(
            f"{type(problem).__name__}: {far}, so that it cannot be computed; check the numbers and their units."
        ) from error
    except WinklerError:
        raise
    except FAULTS as error:
        far = next(_far(problem), "")
        if not far and not isinstance(error, ArithmeticError):
            raise
        why = far or "the numbers are too large, too small or too far from each other"
        raise OutsideValidity(
            f"{type(problem).__name__}: {why}, so that it cannot be computed ({error}); check the numbers and their "
            "units."
        ) from error
