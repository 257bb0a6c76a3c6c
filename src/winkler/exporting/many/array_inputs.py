"""What goes into a step of many contacts: shapes and numbers are checked before anything changes."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.exporting.many.loops import first_beyond
from winkler.numerics.types import Array
from winkler.values.checks.physical_size import LARGEST_NUMBER, SMALLEST_NUMBER
from winkler.values.errors import InvalidInput, OutsideValidity

WIDTHS = {"depth": (), "motion": (2,), "twist": (), "roll": (2,), "duration": ()}
"""Axes of what goes in, after that of the contacts."""


def checked_entry(word: str, given: Any, size: int) -> Array:
    """Return what goes in as an array of numbers with a row for each contact, or one row for all.

    Raises
    ------
    InvalidInput
        If its shape does not agree, or a number is not finite, beyond all physics, or a negative duration, or one that
        is tiny but not zero: its rate would have no number.
    """
    width = WIDTHS[word]
    try:
        array = np.asarray(given, dtype=float)
    except (TypeError, ValueError):
        raise InvalidInput(f"ContactArray: {word} holds what is no number; give numbers in SI units.") from None
    numbers, shape = np.ascontiguousarray(array), array.shape
    if shape == width and width:
        numbers = numbers[np.newaxis]
    elif shape == ():
        numbers = np.full((1, *width), float(numbers.ravel()[0]))
    elif shape != (size, *width):
        raise InvalidInput(f"ContactArray: {word} has the shape {shape}; give {(size, *width)}, or one for all.")
    place = first_beyond(numbers.ravel(), 0.0 if word == "duration" else -LARGEST_NUMBER, LARGEST_NUMBER)
    if place >= 0:
        least = "from 0" if word == "duration" else f"from {-LARGEST_NUMBER:g}"
        raise InvalidInput(
            f"ContactArray: {word} is {numbers.ravel()[place]:g} at contact {place // max(int(np.prod(width)), 1)}; "
            f"give finite numbers in SI units {least} to {LARGEST_NUMBER:g}."
        )
    if word == "duration":
        tiny = np.flatnonzero((numbers > 0.0) & (numbers < SMALLEST_NUMBER))
        if tiny.size:
            raise InvalidInput(
                f"ContactArray: duration is {numbers[tiny[0]]:g} s at contact {tiny[0]}; give {SMALLEST_NUMBER:g} s or "
                "more, or zero."
            )
    return numbers


def checked_depth_of(depth: Array, deepest: Array, kind: np.ndarray[Any, Any]) -> None:
    """Refuse depths beyond the greatest of the law of each contact.

    Raises
    ------
    OutsideValidity
        The message names the first such contact.
    """
    place = first_beyond(depth, -LARGEST_NUMBER, float(np.min(deepest)))
    if place >= 0 and deepest.size > 1:
        depth = np.broadcast_to(depth, kind.shape)
        beyond = np.flatnonzero(depth > deepest[kind])
        place = int(beyond[0]) if beyond.size else -1
    if place >= 0:
        most = deepest[kind[place if kind.size > 1 else 0]]
        raise OutsideValidity(
            f"ContactArray: contact {place} is pressed {float(depth[place]):g} m deep, beyond the {most:g} m of its "
            "law; no contact was moved: give smaller steps, or a law that reaches deeper."
        )


def whole_numbers(word: str, given: Any, least: int, beyond: int) -> np.ndarray[Any, np.dtype[np.int64]]:
    """Return whole numbers in a row, each at least `least` and below `beyond`.

    Raises
    ------
    InvalidInput
        If they are none.
    """
    numbers = np.asarray(given)
    if numbers.size == 0 and numbers.ndim == 1:
        return np.zeros(0, dtype=np.int64)
    if numbers.ndim != 1 or numbers.dtype.kind not in "iu":
        raise InvalidInput(
            f"ContactArray: {word} has the shape {numbers.shape} and the type {numbers.dtype}; give whole numbers in "
            "a row."
        )
    low, high = int(numbers.min()), int(numbers.max())
    if low < least or high >= beyond:
        raise InvalidInput(
            f"ContactArray: {word} holds {low if low < least else high}; give whole numbers from {least} to "
            f"{beyond - 1}."
        )
    return numbers.astype(np.int64)


def checked_places(word: str, given: Any, size: int) -> np.ndarray[Any, np.dtype[np.bool_]]:
    """Return which contacts are meant, ``(size,)``, from truth values for all or from their numbers.

    Raises
    ------
    InvalidInput
        If it is neither.
    """
    which = np.asarray(given)
    if which.dtype.kind == "b":
        if which.shape != (size,):
            raise InvalidInput(f"ContactArray: {word} has the shape {which.shape} for {size} contacts; give {(size,)}.")
        return which
    meant = np.zeros(size, dtype=bool)
    meant[whole_numbers(word, given, 0, size)] = True
    return meant
