"""Numbers with a decimal comma, as instruments write them in many countries.

``0,25`` and ``12,5`` can only be decimal; ``1,000`` may be a thousand or one.  A file is read with decimal commas if at
least one of its numbers can be nothing else, and none has a decimal point.
"""

from __future__ import annotations

from collections.abc import Sequence

from winkler.io.tables.table_cells import is_number
from winkler.values.errors import InvalidInput
from winkler.values.units import comma_hint, comma_readings


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
        self._comma: tuple[str, int] | None = None
        self._certain = False
        self._point = ""

    def see_points(self, cells: Sequence[str]) -> None:
        """Remember a cell with a decimal point, if there is one."""
        self._point = self._point or next((cell for cell in cells if "." in cell and is_number(cell)), "")

    def with_point(self, cell: str, line: int) -> str:
        """Return a cell with a point in place of its decimal comma; one that has none, or thousands, as it is."""
        if "," not in cell:
            self.see_points((cell,))
            return cell
        point = cell.replace(",", ".")
        if "." in cell or cell.count(",") != 1 or not is_number(point):
            return cell
        self._comma = self._comma or (cell, line)
        if len(comma_readings(cell)) <= 1:
            self._certain = True
        elif self._doubtful is None:
            self._doubtful = (cell, line)
        return point

    def refuse_ambiguous(self) -> None:
        """Refuse the file if a comma may group thousands, or if commas and points are decimal in it.

        Raises
        ------
        InvalidInput
        """
        if self._doubtful is not None and not self._certain:
            cell, line = self._doubtful
            raise InvalidInput(f"{self.file}, line {line}: '{cell}' has {comma_hint(cell)}.")
        if self._comma is not None and self._point:
            cell, line = self._comma
            raise InvalidInput(
                f"{self.file}, line {line}: '{cell}' has a comma, and '{self._point}' a point; write one decimal sign "
                "in the whole file."
            )
