"""One line of the catalogue: a kind that a study file may name.

Classes and functions are named by their path and loaded when they are first needed, so that a study of one contact
loads no modules of others.
"""

from __future__ import annotations

import functools
import importlib
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple


class Words(NamedTuple):
    """What people call a kind, and what they ask that it answers: words of the trade, read by the search.

    Parameters
    ----------
    en, de, fr
        Words and questions in English, German and French.
    key
        Common words that mean this kind above all others.
    """

    en: str = ""
    de: str = ""
    fr: str = ""
    key: str = ""


class Kind(NamedTuple):
    """One line of the catalogue."""

    path: str
    """Module and name of the class, as ``"winkler.loading.loads:Force"``."""
    example: dict[str, Any]
    cites: tuple[str, ...] = ()
    reader_path: str = ""
    """Module and name of the function that reads the value from the file of the key ``file``, in place of other keys;
    its keyword-only arguments are keys beside ``file``."""
    within: dict[str, Any] | list[dict[str, Any]] | None = None
    """Value of an example study that contains the kind, where the kind alone would have no solution."""
    problem: str = ""
    """Problem of an example study, where the first one that has a place for the kind would refuse it."""
    beside: Mapping[str, Any] = MappingProxyType({})
    """Other keys of what holds it in an example study, where it would be refused beside those of its example."""
    words: Words = Words()
    """What people call it; a kind without words is found by its name alone."""

    @property
    def cls(self) -> type:
        """The class."""
        loaded: type = _loaded(self.path)
        return loaded

    @property
    def reader(self) -> Callable[..., Any] | None:
        """The function that reads a file; None if there is none."""
        return _loaded(self.reader_path) if self.reader_path else None


@functools.cache
def _loaded(path: str) -> Any:
    module, _, name = path.partition(":")
    return getattr(importlib.import_module(module), name)


def kind(
    path: str,
    /,
    *cites: str,
    reader: str = "",
    within: dict[str, Any] | list[dict[str, Any]] | None = None,
    problem: str = "",
    beside: Mapping[str, Any] = MappingProxyType({}),
    en: str = "",
    de: str = "",
    fr: str = "",
    key: str = "",
    **example: Any,
) -> Kind:
    """Return a line: the path of a class, its papers, what people call it (see `Words`), and an example."""
    return Kind(path, example, cites, reader, within, problem, beside, Words(en, de, fr, key))
