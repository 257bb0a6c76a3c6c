"""Errors while a file is read: whatever is raised becomes one sentence of `InvalidInput`.

Every reader of files stands behind `reader`, and every call of a library that reads one behind `sentence_of`: what the
readers of forty formats raise is not known beforehand.
"""

from __future__ import annotations

import contextlib
import functools
import inspect
import os
import warnings
from collections.abc import Callable, Iterator
from typing import ParamSpec, TypeVar

from winkler.errors import InvalidInput, WinklerError

__all__ = ["quiet", "reader", "reason_of", "sentence_of", "shown"]

P = ParamSpec("P")
R = TypeVar("R")

LONGEST = 200
"""Characters of a reason, and of a path in a sentence."""


def shown(path: object) -> str:
    """Return a path as a sentence names it: the end of one that is very long."""
    text = os.fspath(path) if isinstance(path, str | os.PathLike) else repr(path)
    text = str(text)
    return text if len(text) <= LONGEST else f"...{text[-LONGEST:]}"


def reason_of(error: BaseException) -> str:
    r"""Return what an error says in its first line, or what kind of error it is.

    Examples
    --------
    >>> reason_of(ValueError("not enough data\nfor a header")), reason_of(EOFError()), reason_of(KeyError("unit"))
    ('not enough data', 'EOFError', "KeyError: 'unit'")
    """
    message = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
    line = next((line.strip() for line in message.splitlines() if line.strip()), "")
    line = "".join(letter if letter.isprintable() else "?" for letter in line[:LONGEST]).rstrip(".")
    kind = type(error).__name__
    if not line:
        return kind
    return f"{kind}: {line}" if isinstance(error, LookupError) else line


@contextlib.contextmanager
def sentence_of(path: object, wrong: str, remedy: str, *, also: tuple[type[BaseException], ...] = ()) -> Iterator[None]:
    """Turn whatever is raised inside into one sentence: ``{path}: {wrong} ({reason}); {remedy}.``

    Parameters
    ----------
    path : str or path
        The file that is read.
    wrong : str
        Such as "no contacts can be read from it".
    remedy : str
        What to do about it.
    also : tuple of types, optional
        Errors that are no `Exception`, as some libraries have them.

    Raises
    ------
    InvalidInput
        For everything but an error of winkler, which says already what is wrong.
    """
    try:
        yield
    except WinklerError:
        raise
    except MemoryError as error:  # numpy's own words tell how much is needed
        raise InvalidInput(
            f"{shown(path)}: it does not fit the memory of this machine ({reason_of(error)}); save a part of it."
        ) from None
    except BaseException as error:
        if not isinstance(error, (Exception, *also)):
            raise
        raise InvalidInput(f"{shown(path)}: {wrong} ({reason_of(error)}); {remedy}.") from None


@contextlib.contextmanager
def quiet() -> Iterator[None]:
    """Keep back the warnings of a library: they are about its own code, not about the file."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield


def reader(what: str) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Let a function that reads the file ``path`` raise nothing but one sentence.

    Parameters
    ----------
    what : str
        What it reads: "a profile".
    """

    def guarded(read: Callable[P, R]) -> Callable[P, R]:
        place = list(inspect.signature(read).parameters).index("path")

        @functools.wraps(read)
        def reading(*args: P.args, **kwargs: P.kwargs) -> R:
            path = kwargs.get("path", args[place] if place < len(args) else "")
            with sentence_of(path, f"{what} cannot be read from it", "check the file, or save it anew"):
                return read(*args, **kwargs)

        return reading

    return guarded
