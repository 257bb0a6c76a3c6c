"""Names for the numbers and arrays that travel through the house."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Array", "ArrayLike", "ComplexArray", "Curve", "Quantity", "shaped"]

Array = NDArray[Any]
"""Floating-point numbers (or truth values derived from them) of any shape."""
ComplexArray = NDArray[Any]
Quantity = float | Array
"""A number, or an array of numbers where many cases are asked at once."""
Curve = Callable[[Array], Array]
"""A function of one real variable, evaluated element by element."""


def shaped(answer: Quantity, shape: tuple[int, ...] | None = None) -> Quantity:
    """Return an answer as a number where one was asked for, as an array where many were.

    Parameters
    ----------
    answer : float or ndarray
        Of the shape that was asked for; of as many numbers, in a row, if `shape` is given.
    shape : tuple of int, optional
        That of the question.
    """
    numbers = np.asarray(answer) if shape is None else np.reshape(answer, shape)
    return float(numbers) if numbers.ndim == 0 else numbers
