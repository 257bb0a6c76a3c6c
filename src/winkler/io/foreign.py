"""Errors raised while a file is read, turned into one sentence of `InvalidInput`.

Every function that reads a file is decorated by `reader`, and every call of a library that reads one is wrapped by
`sentence_of`, since libraries for some forty formats raise errors of many types.
"""

from __future__ import annotations

import contextlib
import functools
import importlib
import inspect
import logging
import os
import sys
import warnings
from collections.abc import Callable, Iterator
from typing import ParamSpec, TypeVar

from winkler.values.errors import InvalidInput, WinklerError

P = ParamSpec("P")
R = TypeVar("R")

MOST_CHARACTERS = 200
"""Longest reason, and longest path, in a sentence [characters]."""


def path_text(path: object) -> str:
    """Return a path for a sentence; of a very long one only its end."""
    text = os.fspath(path) if isinstance(path, str | os.PathLike) else repr(path)
    text = str(text)
    return text if len(text) <= MOST_CHARACTERS else f"...{text[-MOST_CHARACTERS:]}"


def reason_of(error: BaseException) -> str:
    r"""Return the first line of an error's message, or its type if it has none.

    Examples
    --------
    >>> reason_of(ValueError("not enough data\nfor a header")), reason_of(EOFError()), reason_of(KeyError("unit"))
    ('not enough data', 'EOFError', "KeyError: 'unit'")
    """
    message = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
    line = next((line.strip() for line in message.splitlines() if line.strip()), "")
    line = "".join(letter if letter.isprintable() else "?" for letter in line[:MOST_CHARACTERS]).rstrip(".")
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
        For every error but those of winkler, which already are such sentences.
    """
    try:
        yield
    except WinklerError:
        raise
    except MemoryError as error:  # numpy's message states how much is needed
        raise InvalidInput(
            f"{path_text(path)}: it does not fit the memory of this machine ({reason_of(error)}); save a part of it."
        ) from None
    except BaseException as error:
        if not isinstance(error, (Exception, *also)):
            raise
        raise InvalidInput(f"{path_text(path)}: {wrong} ({reason_of(error)}); {remedy}.") from None


@contextlib.contextmanager
def in_file(path: object) -> Iterator[None]:
    """Put the name of a file before the sentence that refuses its contents."""
    try:
        yield
    except InvalidInput as error:
        raise InvalidInput(f"{path}: {error}") from None


@contextlib.contextmanager
def quiet() -> Iterator[None]:
    """Suppress warnings and logs of a library: they concern its own code, or print what a damaged file holds."""
    before = logging.root.manager.disable
    logging.disable(logging.CRITICAL)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    finally:
        logging.disable(before)


@contextlib.contextmanager
def without_stale_sizes() -> Iterator[None]:
    """Read waves of Igor; what a damaged one leaves in igor2, its stated sizes, would refuse all that follow."""
    try:
        yield
    except BaseException:
        if (module := sys.modules.get("igor2.binarywave")) is not None:
            importlib.reload(module)
        raise


def reader(what: str) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Decorate a function that reads the file ``path``, so that it raises one sentence and nothing else.

    Parameters
    ----------
    what : str
        What it reads: "a profile".
    """

    def decorated(read: Callable[P, R]) -> Callable[P, R]:
        signature = inspect.signature(read)
        needed = [
            name
            for name, one in signature.parameters.items()
            if one.default is one.empty and name not in ("path", "kwargs")
        ]

        @functools.wraps(read)
        def wrapped(*args: P.args, **kwargs: P.kwargs) -> R:
            given = signature.bind_partial(*args, **kwargs).arguments  # a wrong call is no fault of the file
            missing = [name for name in needed if name not in given]
            if "path" not in given:
                raise TypeError(f"{read.__name__}() lacks its path")
            path = given["path"]
            if missing:
                raise InvalidInput(f"{path_text(path)}: {what} is read with {' and '.join(missing)}; give it.")
            with sentence_of(path, f"{what} cannot be read from it", "check the file, or save it anew"):
                return read(*args, **kwargs)

        return wrapped

    return decorated
