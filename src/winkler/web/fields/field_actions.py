"""The changes that a form makes to its study."""

from __future__ import annotations

from typing import Any, Protocol

from winkler.web.fields.range_field import RangeActions

__all__ = ["FieldActions"]


class FieldActions(RangeActions, Protocol):
    """Changes that a form makes to its study."""

    def change(self, path: str, text: str, takes: str) -> None:
        """Set the typed content of a key."""
        ...

    def choose(self, path: str, kind: str) -> None:
        """Set a kind at a path; an empty one removes it."""
        ...

    def add(self, path: str, kind: str) -> None:
        """Add a kind to a list."""
        ...

    def read(self, path: str, name: str) -> None:
        """Replace numbers by a file; an empty name restores numbers."""
        ...

    def pick(self, path: str) -> None:
        """Set the path for which the next upload is meant."""
        ...

    def content(self, path: str) -> Any:
        """Return the content of a key."""
        ...

    def is_assumed(self, path: str) -> bool:
        """Return whether a key holds what an example says, and nobody has given."""
        ...
