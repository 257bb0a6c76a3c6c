"""Checks of the places at which a field is requested: numbers in metres, of shapes that broadcast."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from winkler.values.checks.physical_size import LARGEST_NUMBER, as_text, refuse_size
from winkler.values.checks.plain_numbers import REAL, Argument, plain
from winkler.values.errors import InvalidInput

Array: TypeAlias = NDArray[Any]


def finite_places(requested: str, name: str, content: ArrayLike) -> Array:
    """Return places [m] as an array, converted from quantities; refuse what is not a number, or not finite.

    Parameters
    ----------
    requested : str
        What is computed there, as the beginning of a sentence.
    name : str
        Of the coordinate.
    content : array_like
        As given.
    """
    argument = Argument(f"{requested}: {name}", lambda: "m")
    found = plain(content, argument)
    if type(found) not in REAL and not (isinstance(found, np.ndarray) and found.dtype == float):
        raise argument.refused(f"is {as_text(content)}", "give a number or an array{unit}")
    if type(found) is int:
        refuse_size(argument.where, found)
    numbers = np.asarray(found, dtype=float)
    if not np.all(np.abs(numbers) < LARGEST_NUMBER):
        raise InvalidInput(
            f"{requested}: {name} holds values that are not finite, or beyond {LARGEST_NUMBER:g}; give places in m."
        )
    return numbers


def common_places(requested: str, **coordinates: ArrayLike) -> tuple[Array, ...]:
    """Return coordinates [m] broadcast to one shape; refuse shapes that do not fit each other.

    Parameters
    ----------
    requested : str
        As of `finite_places`.
    **coordinates : array_like
        By their names.
    """
    places = [finite_places(requested, name, content) for name, content in coordinates.items()]
    try:
        return tuple(np.broadcast_arrays(*places))
    except ValueError:
        shapes = ", ".join(f"{name} {place.shape}" for name, place in zip(coordinates, places, strict=True))
        raise InvalidInput(
            f"{requested}: the coordinates have shapes that do not broadcast ({shapes}); give arrays of one shape, or "
            "single numbers."
        ) from None
