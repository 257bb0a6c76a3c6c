"""A number of a value as a quantity of pint, in the unit that the glossary states for it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.vocabulary import word

if TYPE_CHECKING:
    import pint

__all__ = ["quantity"]


def quantity(self: Any, name: str) -> pint.Quantity:
    """Return a field or a result as a quantity of pint; it becomes the method ``quantity`` of each value.

    Parameters
    ----------
    name : str
        Of the field or the result, as ``"depth"``.

    Returns
    -------
    pint.Quantity
        In the SI unit of the glossary, of the application's registry (``pint.get_application_registry()``).

    Raises
    ------
    InvalidInput
        If it is no quantity, or one whose unit follows from another argument.

    Examples
    --------
    >>> from winkler.loading import Force
    >>> Force(1e3).quantity("force").to("kN").magnitude
    1.0
    """
    from winkler.units import is_fixed  # exact fractions

    content = getattr(self, name)
    try:
        unit = word(type(self), name).unit
    except KeyError:
        unit = None
    if unit is None or not is_fixed(unit) or not isinstance(content, float | int | np.ndarray):
        owner = type(self).__name__
        raise InvalidInput(f"{owner}: {name} is no quantity with a unit of its own; read it as {owner}.{name}.")
    import pint  # takes most of a second to load

    registry = pint.get_application_registry()
    return registry.Quantity(np.array(content) if isinstance(content, np.ndarray) else content, unit)
