"""Names for the arrays that travel through the house."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numpy.typing import ArrayLike, NDArray

__all__ = ["Array", "ArrayLike", "ComplexArray", "Curve", "Quantity"]

Array = NDArray[Any]
"""Floating-point numbers (or truth values derived from them) of any shape."""
ComplexArray = NDArray[Any]
Quantity = float | Array
"""A number, or an array of numbers where many cases are asked at once."""
Curve = Callable[[Array], Array]
"""A function of one real variable, evaluated element by element."""
