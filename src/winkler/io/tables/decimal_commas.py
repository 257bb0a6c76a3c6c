"""Numbers with a decimal comma, as instruments write them in many countries.

``0,25`` and ``12,5`` can only be decimal; ``1,000`` may be a thousand or one.  A file is read with decimal commas if at
least one of its numbers can be nothing else, and none has a decimal point.
"""

from __future__ import annotations

from winkler.errors import InvalidInput
from winkler.io.tables.table_cells import is_number
from winkler.units import comma_hint, comma_readings

__all__ = ["DecimalCommas"]


class DecimalCommas:
    """The cells of one file that have a comma, and whether their meaning is certain.

    Parameters
    ----------
    file : str
        Its name, for messages.
    """

    def __init__(self, file: str) -> None:
        self.file = file
        self._doubtful: tuple[str, int] | None = None
        self._certain = ""

    def with_point(self, cell: str, line: int) -> str:
        """Return a cell with a point in place of its decimal comma; one that has none, or thousands, as it is.

        Raises
        ------
        InvalidInput
            If a decimal point stands in another cell of the same line or file, so that the comma may group thousands.
        """
        if "," not in cell:
            return cell
        readings = comma_readings(cell)
        point = cell.replace(",", ".")
        if "." in cell or cell.count(",") != 1 or not is_number(point):
            return cell
        if len(readings) == 1 or not readings:
            self._certain = self._certain or cell
        elif self._doubtful is None:
            self._doubtful = (cell, line)
        return point

    def refuse_ambiguous(self) -> None:
        """Refuse the file if a comma may group thousands and no other number says what commas mean in it.

        Raises
        ------
        InvalidInput
        """
        if self._doubtful is not None and not self._certain:
            cell, line = self._doubtful
            raise InvalidInput(f"{self.file}, line {line}: '{cell}' has {comma_hint(cell)}.")
