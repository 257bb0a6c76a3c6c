r"""The coefficients of the area function of a tip, :math:`A(h)=\sum_n C_n\,h^{2^{1-n}}`: each has a unit of its own."""

from __future__ import annotations

import functools
import math
from typing import Annotated, Any, NamedTuple, TypeAlias

import numpy as np

from winkler.values.checks.number_checks import Check
from winkler.values.checks.physical_size import as_text
from winkler.values.checks.plain_numbers import REAL, Argument, plain

MOST_COEFFICIENTS = 100
"""Of an area function: from about fifty on the powers of the depth are zero."""


def coefficient_unit(place: int) -> str:
    """Return the unit of the coefficient at a place.

    Examples
    --------
    >>> coefficient_unit(0), coefficient_unit(1), coefficient_unit(2)
    ('', 'm^1', 'm^1.5')
    """
    return f"m^{2.0 - 2.0 ** (1 - place):g}" if place else ""


class RowOfCoefficients(NamedTuple):
    """Finite numbers, at least one of them not zero."""

    def check(self, argument: Argument) -> Check:
        """Return what makes a tuple of the coefficients, and refuses what are none."""

        def number(place: int, content: Any) -> Any:
            unit = functools.partial(coefficient_unit, place)
            return plain(content, argument._replace(where=f"{argument.where}[{place}]", unit=unit))

        def checked(content: Any) -> Any:
            found = content
            if type(found) is not tuple:
                row = plain(content, argument)
                found = tuple(row.tolist()) if isinstance(row, np.ndarray) and row.dtype == float else ()
            if len(found) > MOST_COEFFICIENTS:
                raise argument.refused(f"are {len(found)} numbers", f"give at most {MOST_COEFFICIENTS}")
            found = tuple(number(place, coefficient) for place, coefficient in enumerate(found))
            if not all(type(one) in REAL and math.isfinite(one) for one in found) or not any(found):
                demand = "give finite numbers C0, C1, ... of which at least one is not zero"
                raise argument.refused(f"are {as_text(content)}", demand)
            return tuple(map(float, found))

        return checked


AreaCoefficients: TypeAlias = Annotated[tuple[float, ...], RowOfCoefficients()]
