"""One line of the catalogue: a kind that a study file may name."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

__all__ = ["Kind", "kind"]


class Kind(NamedTuple):
    """One line of the catalogue."""

    cls: type
    example: dict[str, Any]
    cites: tuple[str, ...] = ()
    reader: Callable[..., Any] | None = None
    """Reads the value from the file that the key ``file`` names, in place of the other keys; its keyword-only
    arguments are keys that go with the file."""
    within: dict[str, Any] | list[dict[str, Any]] | None = None
    """What an example study puts in its place, with the kind inside, where the kind alone would have no answer."""
    problem: str = ""
    """Which problem an example study asks, where the first that has a place for the kind would refuse it."""


def kind(
    cls: type,
    *cites: str,
    reader: Callable[..., Any] | None = None,
    within: dict[str, Any] | list[dict[str, Any]] | None = None,
    problem: str = "",
    **example: Any,
) -> Kind:
    """Return a line: a class, the papers it stands on, and an example."""
    return Kind(cls, example, cites, reader, within, problem)
