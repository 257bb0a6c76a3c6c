"""Which function draws a class: the pictures register themselves here."""

from __future__ import annotations

import abc
import functools
from collections.abc import Callable
from typing import Any

from winkler.plot.panel import Sheet
from winkler.profiles.profile import Shape
from winkler.values.errors import InvalidInput

DRAWABLE = (
    "a profile, a Foundation, PlaneFoundation or MeasuredBed, a coated, graded or viscoelastic half-space, a solid "
    "that relaxes, a height map or a spectrum, a solution of a problem, restored fields, a Staircase, a ForceCurve, "
    "a Fit, or a Comparison"
)
SHAPE_ATTRIBUTES = ("height", "gap", "reach", "rim", "size", "kinks")


@functools.singledispatch
def sheet_of(item: Any, *, extent: float | None = None) -> Sheet:
    """Return the panels that show `item`, as plain data; parameters and errors as for `draw`."""
    if all(hasattr(item, name) for name in SHAPE_ATTRIBUTES):
        return sheet_of.dispatch(Shape)(item, extent=extent)
    raise InvalidInput(f"draw: there is no picture of a {type(item).__name__}; give {DRAWABLE}.")


class Answered(abc.ABC):
    """Any answer: a dataclass with the field `problem`. A picture of it serves where its own class has none."""

    @property
    @abc.abstractmethod
    def problem(self) -> Any:
        """The problem that was solved."""

    @classmethod
    def __subclasshook__(cls, other: type) -> bool:
        return "problem" in getattr(other, "__dataclass_fields__", ())


def without_extent(*kinds: type) -> Callable[[Callable[[Any], Sheet]], Callable[[Any], Sheet]]:
    """Register a function as the picture of some classes; an extent, which it has none of, is refused."""

    def registered(drawn: Callable[[Any], Sheet]) -> Callable[[Any], Sheet]:
        @functools.wraps(drawn)
        def sheet(item: Any, *, extent: float | None = None) -> Sheet:
            if extent is not None:
                raise InvalidInput(f"draw: the curves of a {type(item).__name__} have no extent; leave it out.")
            return drawn(item)

        for kind in kinds:
            sheet_of.register(kind)(sheet)
        return drawn

    return registered
