"""Type names for the numbers and arrays of the package."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from winkler.checks.number_checks import ComplexNumbers

__all__ = ["Array", "ArrayLike", "ComplexArray", "Curve", "Quantity", "shaped"]

Array = NDArray[Any]
"""Floating-point numbers (or truth values derived from them) of any shape."""
ComplexArray = Annotated[NDArray[Any], ComplexNumbers()]
Quantity = float | Array
"""A number, or an array of numbers for many cases at once."""
Curve = Callable[[Array], Array]
"""A function of one real variable, evaluated element by element."""


def shaped(result: Quantity, shape: tuple[int, ...] | None = None) -> Quantity:
    """Return a result as a number for one argument, as an array for many.

    Parameters
    ----------
    result : float or ndarray
        Of the shape of the argument; of as many numbers, in a row, if `shape` is given.
    shape : tuple of int, optional
        That of the question.
    """
    numbers = np.asarray(result) if shape is None else np.reshape(result, shape)
    return float(numbers) if numbers.ndim == 0 else numbers
