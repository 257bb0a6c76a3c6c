"""What is told beside a file of force curves, because the file may not state it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

__all__ = ["Given"]


class Given(NamedTuple):
    """Facts that a caller gives.

    Parameters
    ----------
    spring_constant : float, optional
        Of the cantilever [N/m]; replaces that of the file.
    sensitivity : float, optional
        Deflection per volt [m/V].
    units : mapping
        Of columns without one; see `winkler.io.tables.given_units`.
    columns : mapping
        Numbers of columns, counted from 1, by the word of the quantity; names are not looked at then.
    rigid : bool
        Whether a position is the travel of the tip where neither file nor caller states a spring, as in nanoindenters.
    """

    spring_constant: float | None = None
    sensitivity: float | None = None
    units: Mapping[str, str] = {}
    columns: Mapping[str, int] = {}
    rigid: bool = False
