"""The typed tree between the source of a kernel and what is written of it.

Every expression knows its type: a number (`REAL`, `INT`, `BOOL`), an array of numbers whose last axis is contiguous, a
tuple of these, or a slice.  Statements hold expressions; a routine is a kernel for given types of its arguments.
"""

from __future__ import annotations

from typing import Any, NamedTuple


class TranslatedType(NamedTuple):
    """What an expression is.

    Parameters
    ----------
    kind : str
        "real", "int", "bool", "void", "slice", "array" or "tuple".
    parts : tuple of TranslatedType
        Of a tuple its entries; of an array what it holds.
    axes : int
        Of an array.
    """

    kind: str
    parts: tuple[Any, ...] = ()
    axes: int = 0

    @property
    def is_number(self) -> bool:
        """Whether it is one number."""
        return self.kind in ("real", "int", "bool")

    @property
    def item(self) -> TranslatedType:
        """What an array holds."""
        held: TranslatedType = self.parts[0]
        return held

    def __str__(self) -> str:
        if self.kind == "array":
            return f"{self.item}[{', '.join(':' * self.axes)}]"
        return f"({', '.join(map(str, self.parts))})" if self.kind == "tuple" else self.kind


REAL, INT, BOOL = TranslatedType("real"), TranslatedType("int"), TranslatedType("bool")
VOID, SLICE = TranslatedType("void"), TranslatedType("slice")


def array_of(axes: int, item: TranslatedType = REAL) -> TranslatedType:
    """Return the type of an array."""
    return TranslatedType("array", (item,), axes)


def tuple_of(*parts: TranslatedType) -> TranslatedType:
    """Return the type of a tuple."""
    return TranslatedType("tuple", parts)


class Typed(NamedTuple):
    """Something that has a value.

    Parameters
    ----------
    type : TranslatedType
    form : str
        "number", "name", "constant", "unary", "binary", "compare", "choose", "cast", "call", "function", "item",
        "view", "size", "tuple", "part", "new", "room" or "slice".
    text : str
        A literal, a name, an operator, or which function.
    parts : tuple of Typed
    detail : Any
        Of a view which of its indices are slices, of a part its place, of a call the routine.
    """

    type: TranslatedType
    form: str
    text: str = ""
    parts: tuple[Any, ...] = ()
    detail: Any = None


class Statement(NamedTuple):
    """Something that is done.

    Parameters
    ----------
    form : str
        "assign", "store", "fill", "do", "if", "while", "range", "items", "break", "continue" or "return".
    name : str
        The variable that is assigned or counts.
    parts : tuple of Typed
    bodies : tuple of tuples of Statement
    comment : str
    """

    form: str
    name: str = ""
    parts: tuple[Typed, ...] = ()
    bodies: tuple[tuple[Any, ...], ...] = ()
    comment: str = ""


class Constant(NamedTuple):
    """A number, or a row of numbers, of the module of a kernel; `place` is module and name there."""

    name: str
    type: TranslatedType
    numbers: tuple[float | int, ...]
    place: tuple[str, str] = ("", "")


class Routine(NamedTuple):
    """A kernel for given types of its arguments.

    Parameters
    ----------
    name : str
    kernel : Any
        From which it was translated.
    arguments : tuple of (str, TranslatedType)
    result : TranslatedType
    variables : dict
        Name -> type of what is no argument.
    body : tuple of Statement
    writes : bool
        Whether it changes arrays it is given.
    arrays_made : int
        How many arrays it makes.
    """

    name: str
    kernel: Any
    arguments: tuple[tuple[str, TranslatedType], ...]
    result: TranslatedType
    variables: dict[str, TranslatedType]
    body: tuple[Statement, ...]
    writes: bool
    arrays_made: int


class TranslationUnit(NamedTuple):
    """Everything that one or more kernels need, in the order in which it must be written."""

    constants: tuple[Constant, ...]
    routines: tuple[Routine, ...]
    entries: tuple[Routine, ...]
