"""A *value*: a frozen dataclass that compares and hashes by content, arrays included.

Every problem and every solution of winkler is a value.  Two studies with equal content are equal, so a
value can be a key of a cache, a point of a sweep, or one side of an assertion.  Arrays become read-only copies
(again after unpickling), lists become tuples, so that nothing changes behind the reader's back.
What its names mean stands in the glossary, or, if they mean something else in one class, there in ``__words__``.

A wrong name of an attribute or an argument of a value, with the right one suggested.

What is right costs nothing more: ``__getattr__`` is called for attributes only that are not there, and arguments are
compared with the signature only after Python has refused them.
"""

from __future__ import annotations

import dataclasses
import functools
import hashlib
import inspect
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, NoReturn, TypeVar, dataclass_transform

import numpy as np

from winkler.values.checks.field_checks import checks_of
from winkler.values.checks.float_range import guarded, guarded_result, guarded_stream
from winkler.values.checks.outline import refuse_outline, refuse_relaxing
from winkler.values.display import html_table, short
from winkler.values.errors import InvalidInput, WinklerError, suggest
from winkler.values.vocabulary import Word, word

T = TypeVar("T")


def words(**entries: tuple[str, str | None, str]) -> Mapping[str, Word]:
    """Return the words of one class, for its attribute ``__words__``: symbol, unit and one line of each name.

    Examples
    --------
    >>> words(radius=("b", "m", "radius of the punch"))["radius"].unit
    'm'
    """
    return MappingProxyType({name: Word(*entry) for name, entry in entries.items()})


def frozen_array(array: Any) -> np.ndarray:
    """Return a read-only float (or bool, complex, text) copy of `array`; what is masked in it is nan.

    An array of such numbers that nobody writes to, because it is frozen already, is returned as it is.
    """
    if type(array) is np.ndarray and array.base is None and not array.flags.writeable and array.dtype.kind in "fbcU":
        return array
    masked = hasattr(array, "mask") and isinstance(array, np.ma.MaskedArray)  # numpy loads its parts on demand
    if masked and array.dtype.kind in "iuf":
        array = np.ma.filled(array.astype(float), np.nan)  # a number below a mask is none
    result = np.array(array)
    if result.dtype.kind in "iu":
        result = result.astype(float)
    result.flags.writeable = False
    return result


FROZEN_TYPES = {float, int, str, bool}
"""What is frozen already, values themselves among it; a sweep has a million of them."""


def _frozen(content: Any) -> Any:
    if type(content) is tuple and FROZEN_TYPES.issuperset(map(type, content)):
        return content
    if isinstance(content, np.ndarray):
        if hasattr(content, "units") or hasattr(content, "unit"):
            return content  # the unit of another library, about which its argument decides
        return float(content) if content.ndim == 0 and content.dtype.kind in "iuf" else frozen_array(content)
    if isinstance(content, np.generic):
        return content.item() if content.dtype.kind in "biufcUS" else content
    if isinstance(content, list | tuple) and not hasattr(content, "_fields"):
        return tuple(_frozen(item) for item in content)
    return content


LARGE = 4096
"""Bytes of an array beyond which its digest is kept and compared in place of its numbers."""


def _key(content: Any) -> Any:
    """Return something hashable that is equal exactly when `content` is."""
    if isinstance(content, np.ndarray):
        numbers = content.tobytes()
        if len(numbers) > LARGE:
            numbers = hashlib.blake2b(numbers).digest()
        return content.shape, content.dtype.str, numbers
    if isinstance(content, tuple):
        return tuple(_key(item) for item in content)
    if isinstance(content, dict):
        return frozenset((name, _key(item)) for name, item in content.items())
    return content


def _content(self: Any) -> tuple[Any, ...]:
    """Return the contents of a value; they are kept, since caches compare their keys again and again."""
    kept: tuple[Any, ...] | None = self.__dict__.get("_content")
    if kept is None:
        kept = tuple(_key(getattr(self, field.name)) for field in dataclasses.fields(self))
        object.__setattr__(self, "_content", kept)
    return kept


def _equal(self: Any, other: object) -> bool:
    if type(other) is not type(self):
        return NotImplemented  # type: ignore[no-any-return]
    if self is other:
        return True
    same: bool = _content(self) == _content(other)
    if same:  # the next comparison of the two finds one and the same content
        object.__setattr__(other, "_content", _content(self))
    return same


def _hash(self: Any) -> int:
    stored = self.__dict__.get("_hash")
    if stored is None:
        stored = hash((type(self).__qualname__, _content(self)))
        object.__setattr__(self, "_hash", stored)
    return int(stored)


def _getstate(self: Any) -> dict[str, Any]:
    return {field.name: getattr(self, field.name) for field in dataclasses.fields(self)}


def _setstate(self: Any, state: dict[str, Any]) -> None:
    for name, content in state.items():
        object.__setattr__(self, name, _frozen(content))


def quantity(self: Any, name: str) -> Any:
    """Return a field or a result as a `pint` quantity, a number or array with its unit.

    Parameters
    ----------
    name : str
        Name of the field or result, for example ``"depth"``.

    Returns
    -------
    pint.Quantity
        The value in SI units. Its registry is that of the application (``pint.get_application_registry()``).

    Raises
    ------
    InvalidInput
        If the field has no unit, or a unit that depends on another argument.

    Examples
    --------
    >>> from winkler.loading.loads import Force
    >>> Force(1e3).quantity("force").to("kN").magnitude
    1.0
    """
    from winkler.values.units import is_fixed  # exact fractions

    content = getattr(self, name)
    try:
        unit = word(type(self), name).unit
    except KeyError:
        unit = None
    if unit is None or not is_fixed(unit) or not isinstance(content, float | int | np.ndarray):
        owner = type(self).__name__
        raise InvalidInput(f"{owner}: {name} is no quantity with a unit of its own; read it as {owner}.{name}.")
    import pint  # takes most of a second to load

    registry: Any = pint.get_application_registry()  # type: ignore[no-untyped-call]
    return registry.Quantity(np.array(content) if isinstance(content, np.ndarray) else content, unit)


@dataclass_transform(frozen_default=True, eq_default=False, field_specifiers=(dataclasses.field,))
def value(cls: type[T]) -> type[T]:
    """Make `cls` a value: a frozen dataclass with read-only arrays, compared and hashed by content.

    The fields are frozen and compared with their types (`winkler.values.checks`); then a class's own ``__post_init__``
    runs, the place to check what several fields have to do with each other.  Its ``solve`` and its ``steps``, and the
    properties of a solution, state in one sentence if numbers leave the range of floating-point numbers.  Its ``repr``
    takes a few lines (`winkler.values.display`); ``quantity("depth")`` gives a number with its unit (`quantity`);
    a wrong name raises an error with the right one.
    """
    check: Callable[[Any], None] | None = getattr(cls, "__post_init__", None)
    check = getattr(check, "own", check)  # the fields of a parent are checked with one's own
    overflow: Any = dict.fromkeys(("over", "divide", "invalid"), "raise")

    def __post_init__(self: Any) -> None:
        refuse_outline(self)
        refuse_relaxing(self)
        contents = self.__dict__
        for name, checked in checks_of_fields():
            content = contents[name]
            try:
                unchanging = content if type(content) in FROZEN_TYPES else _frozen(content)
                if checked is not None:
                    unchanging = checked(unchanging)
            except RecursionError:
                raise InvalidInput(f"{cls.__name__}: {name} holds itself, or lists in lists without end.") from None
            if unchanging is not content:
                contents[name] = unchanging
        if check is not None:
            try:
                with np.errstate(**overflow):
                    check(self)
            except WinklerError:
                raise
            except ArithmeticError as error:
                raise InvalidInput(f"{cls.__name__}: {error}; check the numbers and their units.") from error

    __post_init__.own = check  # type: ignore[attr-defined]
    for name, method in (
        ("__post_init__", __post_init__),
        ("__eq__", _equal),
        ("__hash__", _hash),
        ("__getstate__", _getstate),
        ("__setstate__", _setstate),
        ("__getattr__", unknown_attribute),
        ("__repr__", vars(cls).get("__repr__", short)),
        ("_repr_html_", html_table),
    ):
        setattr(cls, name, method)
    if "quantity" not in vars(cls).get("__annotations__", {}):
        cls.quantity = quantity  # type: ignore[attr-defined]
    for name, guard in (("solve", guarded), ("steps", guarded_stream)):
        if callable(vars(cls).get(name)):  # a field may have the same name
            setattr(cls, name, guard(vars(cls)[name]))
    if "problem" in vars(cls).get("__annotations__", {}):  # a solution: its properties are computed on demand
        for name, member in list(vars(cls).items()):
            if isinstance(member, property) and member.fget is not None:
                setattr(cls, name, property(guarded_result(member.fget), doc=member.__doc__))
    made: Any = dataclasses.dataclass(frozen=True, eq=False, repr=False)(cls)
    made.__init__ = checked_arguments(made, made.__init__)
    checks_of_fields = functools.cache(functools.partial(checks_of, made))
    FROZEN_TYPES.add(made)
    result: type[T] = made
    return result


def unknown_attribute(self: Any, name: str) -> NoReturn:
    """Raise for an attribute that a value does not have; it becomes the ``__getattr__`` of its class.

    Raises
    ------
    AttributeError
        With the attribute that was probably meant; or, if a property of that name failed, what made it fail.
    """
    cls = self.__class__
    if name in _public(cls) and hasattr(cls, name):
        object.__getattribute__(self, name)  # raises once more what a property hides behind its absence
    raise AttributeError(_sentence(cls, name), name=name)


@functools.lru_cache(maxsize=1024)
def _sentence(cls: type, name: str) -> str:
    near = "" if name.startswith("_") else suggest(name, _public(cls) - {name})
    return f"'{cls.__name__}' object has no attribute '{name}'{near}"


@functools.cache
def _public(cls: type) -> frozenset[str]:
    """Return the public fields, properties and methods of a class."""
    return frozenset(
        name for name in (*getattr(cls, "__dataclass_fields__", ()), *dir(cls)) if not name.startswith("_")
    )


def checked_arguments(cls: type, construct: Callable[..., None]) -> Callable[..., None]:
    """Return the ``__init__`` of a class, which suggests for an unknown argument the one that was probably meant.

    Parameters
    ----------
    cls : type
        The class that is constructed.
    construct : callable
        Its ``__init__``.
    """

    @functools.wraps(construct)
    def __init__(self: Any, *positional: Any, **named: Any) -> None:
        try:
            construct(self, *positional, **named)
        except TypeError as error:
            if error.__traceback__ is not None and error.__traceback__.tb_next is None:  # the call itself was refused
                _refuse_unknown(cls, construct, named)
            raise

    return __init__


def _refuse_unknown(cls: type, construct: Callable[..., None], named: dict[str, Any]) -> None:
    names = [name for name in inspect.signature(construct).parameters if name != "self"]
    for name in named:
        if name not in names:
            takes = f"it accepts {', '.join(names)}" if names else "it accepts none"
            raise TypeError(f"{cls.__name__}: there is no argument '{name}'{suggest(name, names)}; {takes}.") from None
