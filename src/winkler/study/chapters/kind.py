"""One line of the catalogue: a kind that a study file may name.

Classes and functions are named by their path and loaded when they are first needed: a study of one contact does not
wait for the modules of all others.
"""

from __future__ import annotations

import functools
import importlib
from collections.abc import Callable
from typing import Any, NamedTuple

__all__ = ["Kind", "kind", "path_of"]


class Kind(NamedTuple):
    """One line of the catalogue."""

    path: str
    """Where the class stands, as ``"winkler.loading:Force"``."""
    example: dict[str, Any]
    cites: tuple[str, ...] = ()
    reader_path: str = ""
    """Where the function stands that reads the value from the file that the key ``file`` names, in place of the other
    keys; its keyword-only arguments are keys that go with the file."""
    within: dict[str, Any] | list[dict[str, Any]] | None = None
    """What an example study puts in its place, with the kind inside, where the kind alone would have no answer."""
    problem: str = ""
    """Which problem an example study asks, where the first that has a place for the kind would refuse it."""

    @property
    def cls(self) -> type:
        """The class."""
        found: type = _loaded(self.path)
        return found

    @property
    def reader(self) -> Callable[..., Any] | None:
        """The function that reads a file; None if there is none."""
        return _loaded(self.reader_path) if self.reader_path else None


@functools.cache
def _loaded(path: str) -> Any:
    module, _, name = path.partition(":")
    return getattr(importlib.import_module(module), name)


def path_of(cls: type) -> str:
    """Return the path that a line of the catalogue names a class by."""
    return f"{cls.__module__}:{cls.__qualname__}"


def kind(
    path: str,
    /,
    *cites: str,
    reader: str = "",
    within: dict[str, Any] | list[dict[str, Any]] | None = None,
    problem: str = "",
    **example: Any,
) -> Kind:
    """Return a line: the path of a class, the papers it stands on, and an example."""
    return Kind(path, example, cites, reader, within, problem)
