"""The place on the sample that stands above a table: lines ``x [um]: 3.5`` and ``y [um]: 2``."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

from winkler.values.errors import InvalidInput
from winkler.values.units import scale

__all__ = ["place_in"]

PLACE_LINE = re.compile(
    r"[#%\s]*+(?P<axis>[xy])\s*+[\[(](?P<unit>[nuµm]?m)[\])]\s*+[:=]\s*+(?P<number>[0-9.,eE+-]{1,100}+)\s*+"
)


def place_in(head: Sequence[str], where: object) -> tuple[float, float]:
    """Return the place [m] that lines above a table state, NaN for what they do not.

    Parameters
    ----------
    head : sequence of str
        Lines above the table.
    where
        The file, for messages.

    Raises
    ------
    InvalidInput
        If a place is no finite number.

    Examples
    --------
    >>> place_in(["# x [um]: 3.5", "# y [um]: 2", "depth [nm], force [nN]"], "gel.csv")
    (3.5e-06, 2e-06)
    """
    found = {"x": math.nan, "y": math.nan}
    for match in filter(None, map(PLACE_LINE.fullmatch, head)):
        try:
            number = float(match["number"])
        except ValueError:
            number = math.nan
        if not math.isfinite(number):
            raise InvalidInput(
                f"{where}: the place {match['axis']} is '{match['number']}', which is no number; write it with a "
                "decimal point, as in 'x [um]: 3.5', or leave the line out."
            )
        found[match["axis"]] = number * scale(match["unit"], "m")
    return found["x"], found["y"]
