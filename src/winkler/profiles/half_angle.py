"""The half-angle that a conical shape is made from: a number of radians, and the most frequent mistake is degrees."""

from __future__ import annotations

import math
from typing import Annotated, Any, NamedTuple, TypeAlias

from winkler.values.checks.number_checks import Check, Number
from winkler.values.checks.physical_size import as_text
from winkler.values.checks.plain_numbers import Argument, plain

RIGHT_ANGLE = 0.5 * math.pi
HALF_ANGLE_RANGE = Number("measured from the axis it must lie between 0 and pi/2", 0.0, RIGHT_ANGLE, (0.0, RIGHT_ANGLE))


class AngleBetween(NamedTuple):
    """A half-angle between 0 and pi/2, both excluded; a number that looks like degrees is refused with its radians."""

    def check(self, argument: Argument) -> Check:
        """Return what refuses contents of a field that are no such angle."""

        def checked(content: Any) -> Any:
            angle = plain(content, argument)
            if not HALF_ANGLE_RANGE.admits(angle):
                degrees = type(angle) in (float, int) and RIGHT_ANGLE <= angle < 90.0
                hint = f"; if {angle:g} are degrees, give math.radians({angle:g})" if degrees else ""
                raise argument.refused(f"is {as_text(angle)} rad", f"{HALF_ANGLE_RANGE.demand}{hint}")
            return angle

        return checked


HalfAngle: TypeAlias = Annotated[float, AngleBetween()]
