"""A wrong name of an attribute or an argument of a value, with the right one suggested.

What is right costs nothing more: ``__getattr__`` is called for attributes only that are not there, and arguments are
compared with the signature only after Python has refused them.
"""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable
from typing import Any, NoReturn

from winkler.values.errors import suggest

__all__ = ["checked_arguments", "unknown_attribute"]


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
            takes = f"it takes {', '.join(names)}" if names else "it takes none"
            raise TypeError(f"{cls.__name__}: there is no argument '{name}'{suggest(name, names)}; {takes}.") from None
