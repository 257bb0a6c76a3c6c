"""Type names for the numbers and arrays of the package."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from winkler.values.checks.number_checks import ComplexNumbers

__all__ = ["ZERO", "Array", "ArrayLike", "ComplexArray", "Curve", "N", "PerLoad", "Q", "Quantity", "like", "shaped"]

Array = NDArray[Any]
"""Floating-point numbers (or truth values derived from them) of any shape."""
ComplexArray = Annotated[NDArray[Any], ComplexNumbers()]
Quantity = float | Array
"""A number, or an array of numbers for many cases at once."""
if TYPE_CHECKING:
    from typing import Generic as PerLoad

    from typing_extensions import TypeVar

    Q = TypeVar("Q", bound=Quantity, default=Quantity, covariant=True)
    N = TypeVar("N", bound=Quantity)
else:

    class PerLoad:
        """A load or a solution of one load, which holds numbers, or of many, which holds arrays of their shape.

        Type checkers tell them apart by its argument ``Q``, a float or an array; nothing else looks at it.
        """

        def __class_getitem__(cls, _: Any) -> type:
            return cls

    N = Q = Quantity
ZERO: Any = 0.0
"""The default of what may be an array: type checkers see what is given only."""
Curve = Callable[[Array], Array]
"""A function of one real variable, evaluated element by element."""


def shaped(result: Quantity, shape: tuple[int, ...] | None = None) -> N:  # type: ignore[type-var]
    """Return a result as a number for one argument, as an array for many; type checkers take the one that is expected.

    Parameters
    ----------
    result : float or ndarray
        Of the shape of the argument; of as many numbers, in a row, if `shape` is given.
    shape : tuple of int, optional
        That of the question.
    """
    numbers = np.asarray(result) if shape is None or np.shape(result) == shape else np.reshape(result, shape)
    return float(numbers) if numbers.ndim == 0 else numbers  # type: ignore[return-value]


def like(result: Quantity, given: N) -> N:
    """Return a result of as many numbers as `given` has as a number, or as an array of its shape."""
    return shaped(result, np.shape(given))
