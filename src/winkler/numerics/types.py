"""Names for the arrays that travel through the house."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Array", "ArrayLike", "ComplexArray", "Curve", "Quantity"]

Array = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]
Quantity = float | Array
"""A number, or an array of numbers where many cases are asked at once."""
Curve = Callable[[Array], Array]
"""A function of one real variable, evaluated element by element."""
