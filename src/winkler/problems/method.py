"""Methods by which a contact that slips is followed."""

from __future__ import annotations

from collections.abc import Sequence
from enum import StrEnum

from winkler.values.errors import InvalidInput


class Method(StrEnum):
    """The method of computing stick and slip; by default the most accurate one available."""

    AUTO = "auto"
    """Rings where the medium knows its own shear kernel, springs by gap where they are exact, else springs."""
    EXACT = "exact"
    """Springs of one gap as one: exact where tangential and normal stiffness have one ratio."""
    RINGS = "rings"
    """Rings that bear their own pressure times the coefficient, with the kernels of layers and gradings."""
    SPRINGS = "springs"
    """Springs one by one: any law, any medium, paths in the plane; layers within the stated error only."""
    ELEMENTS = "elements"
    """Boundary elements of a line contact or a map: any medium that bears them, and a bulk stress beside."""


def refuse_method(owner: str, method: Method, known: Sequence[Method]) -> None:
    """Refuse a method by which a kind of problem is not followed.

    Raises
    ------
    InvalidInput
    """
    if method not in known:
        *others, last = (str(each) for each in known)
        raise InvalidInput(
            f"{owner}: the method {method} does not follow this kind of contact; give {', '.join(others)} or {last}."
        )
