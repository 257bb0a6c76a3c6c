"""A column that a table is asked for: its names, and the unit in which it is returned."""

from __future__ import annotations

from collections.abc import Sequence

from winkler.values.value import value


@value
class Column:
    """A column to read from a table.

    Parameters
    ----------
    word : str
        Name of the quantity, for messages.
    names : tuple of str
        Names that it may have in the header, in lower case.
    unit : str
        SI unit in which it is returned; empty for a plain number, which needs no unit in the header.
    usual : str, optional
        A customary unit, for messages; the SI unit unless given.
    foremost : str, optional
        Which of the names is meant where several of them stand in a header.
    """

    word: str
    names: tuple[str, ...]
    unit: str
    usual: str = ""
    foremost: str = ""

    @property
    def example(self) -> str:
        """How it may stand in a header."""
        unit = self.usual or self.unit
        return f"{self.names[0]} [{unit}]" if unit else self.names[0]


def example_of(columns: Sequence[Column]) -> str:
    """Return how all of them may stand in a header."""
    return ", ".join(column.example for column in columns)
