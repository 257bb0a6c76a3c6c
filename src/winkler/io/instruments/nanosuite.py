"""Methods of NanoSuite, saved as text: formulas of channels and inputs, without a curve."""

from __future__ import annotations

from collections.abc import Sequence

from winkler.values.errors import InvalidInput

__all__ = ["refuse_method"]


def refuse_method(head: Sequence[str], path: object) -> None:
    """Refuse a text that holds the method of a test.

    Raises
    ------
    InvalidInput
    """
    if any(line.startswith("Method Name :") for line in head[:3]):
        method = head[0].partition(":")[2].strip().rpartition("\\")[2]
        raise InvalidInput(
            f"{path}: there is no table of a force curve in this text; it is the method '{method}' of NanoSuite "
            "(channels and inputs), and its curves are in the workbook (.xls) that NanoSuite exports."
        )
