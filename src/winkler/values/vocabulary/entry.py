"""What the glossary says of one name."""

from __future__ import annotations

from typing import NamedTuple


class Word(NamedTuple):
    """One entry of the glossary: symbol (LaTeX, without dollars), SI unit (None if no quantity), one line."""

    symbol: str
    unit: str | None
    meaning: str
