"""The range of numbers in SI units: a number beyond all physics is in a wrong unit, and is refused."""

from __future__ import annotations

import dataclasses
import math
import re
from collections.abc import Iterator
from typing import Any

import numpy as np

from winkler.values.errors import InvalidInput

SMALLEST_NUMBER, LARGEST_NUMBER = 1e-60, 1e60
"""Physical numbers in SI units lie between these in size; squares and cubes of them are still numbers."""
LONGEST_BITS = 200
"""Bits of the greatest whole number below `LARGEST_NUMBER`."""


def refuse_size(where: str, content: Any, smallest: float = 0.0) -> None:
    """Refuse a number, or an array of numbers, beyond all physics.

    Parameters
    ----------
    where
        Who takes it, and what it is called there: ``Sphere: curvature_radius``.
    content
        In SI units.
    smallest
        Least size of a single number that is not zero.

    Raises
    ------
    InvalidInput
    """
    if not _is_sound(content, smallest):
        raise InvalidInput(
            f"{where} is {_size(content)}; numbers in SI units are between {SMALLEST_NUMBER:g} and {LARGEST_NUMBER:g} "
            "in size: check the unit."
        )


def beyond_physics(content: Any) -> Iterator[str]:
    """Yield in words what is beyond all physics in a value and in the values inside it."""
    if not dataclasses.is_dataclass(content):
        return
    for field in dataclasses.fields(content):
        inside = getattr(content, field.name)
        for part in inside if isinstance(inside, tuple) else (inside,):
            yield from beyond_physics(part)
        if isinstance(inside, float | int | np.ndarray) and not _is_sound(inside):
            yield f"{field.name} of {type(content).__name__} is {_size(inside)}"


def as_text(content: Any) -> str:
    """Return a content of a field as a sentence shows it: in one line, and cut if it is long."""
    if isinstance(content, int) and content.bit_length() > LONGEST_BITS:
        return f"a whole number of about {round(content.bit_length() * math.log10(2.0))} digits"
    if isinstance(content, np.ndarray):
        kind = "" if content.dtype.kind == "f" else f" of {content.dtype}"
        return f"an array{kind} of the shape {content.shape}"
    if shape := getattr(content, "shape", ()):
        return f"a {type(content).__name__} of the shape {shape}"
    if isinstance(content, np.generic) and content.dtype.kind in "bc":
        content = content.item()
    text = (str if hasattr(content, "dimensionality") else repr)(content)
    text = " ".join(re.sub(r" at 0x[0-9A-Fa-f]+", "", text).split())
    return text if len(text) <= 60 else f"{text[:57]}..."


def _is_sound(content: Any, smallest: float = SMALLEST_NUMBER) -> bool:
    """Return whether a number is zero, or of a size that is met in physics; rows may begin near zero."""
    if _is_row(content):
        content = np.asarray(content, dtype=float)
    kind = type(content)
    if kind is float:
        return content == 0.0 or not math.isfinite(content) or smallest <= abs(content) <= LARGEST_NUMBER
    if kind is int:
        return bool(content.bit_length() < LONGEST_BITS)
    if kind is np.ndarray and content.dtype.kind == "f":
        return bool(np.max(np.abs(content[np.isfinite(content)]), initial=0.0) <= LARGEST_NUMBER)
    return True


def _size(content: Any) -> str:
    """Return a number, or the greatest of many, as an error sentence writes it."""
    row = isinstance(content, np.ndarray) or _is_row(content)
    return f"up to {np.nanmax(np.abs(content)):g} in size" if row else as_text(content)


def _is_row(content: Any) -> bool:
    """Return whether something is a tuple of numbers."""
    return type(content) is tuple and bool(content) and all(type(part) in (float, int) for part in content)
