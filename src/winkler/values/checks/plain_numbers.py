"""What is a number, and what an array of numbers: the same for all arguments of the package.

A number is a float or an int; one of NumPy, a Decimal, a Fraction.  Numbers are a row of them, rows of one length, an
array, or what becomes one (a column of pandas, a DataArray of xarray).  A quantity of pint, and a DataArray or a column
with ``attrs["units"]``, is converted to the SI unit of the argument.  No value is changed in silence: a quantity of
another dimension, a number with an uncertainty, a complex one, a truth value, a text is refused.  None of these
libraries is loaded for it.
"""

from __future__ import annotations

import numbers
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from winkler.values.checks.physical_size import as_text
from winkler.values.errors import InvalidInput

REAL = frozenset((float, int))
"""The types of a plain number."""
NUMPY_REAL = frozenset((np.float64, np.float32, np.int64, np.int32))
NO_NUMBERS = (str, bytes, bytearray, memoryview, bool, complex, dict, set, frozenset, type(None), type)
READING_FAULTS = (TypeError, ValueError, OverflowError, RuntimeError, AttributeError, NotImplementedError)
"""What other libraries raise when something of theirs is no array of numbers."""


class Argument(NamedTuple):
    """An argument that is checked: `where` it is taken, its SI `unit`, looked up when it is needed, and an advice."""

    where: str
    unit: Callable[[], str | None] = str
    advice: str = ""

    def ended(self, demand: str) -> str:
        """Return what is allowed with the unit and the advice, as the end of a sentence."""
        unit = self.unit()
        return demand.format(unit=f" in {unit}" if unit else "") + (f": {self.advice}" if self.advice else "")

    def refused(self, what: str, demand: str) -> InvalidInput:
        """Return the refusal of a content that is `what`, with what is demanded in its place."""
        return InvalidInput(f"{self.where} {what}; {self.ended(demand)}.")

    def converted(self, content: Any, unit: str) -> Any:
        """Return plain numbers of another unit in that of the argument."""
        from winkler.values.units import converted, is_fixed  # exact fractions, needed for quantities alone

        own = self.unit()
        if own is None:
            raise InvalidInput(f"{self.where} is a quantity in '{unit}'; give plain numbers, in SI units.")
        if not is_fixed(own):
            raise InvalidInput(
                f"{self.where} is a quantity in '{unit}'; its unit {own} follows from other arguments: give a plain "
                "number in it."
            )
        return converted(content, unit, own, what=self.where)


def plain(content: Any, argument: Argument) -> Any:
    """Return numbers as a float, an int or a read-only array of floats; what holds others is returned as it is.

    Raises
    ------
    InvalidInput
        If they are numbers that would be changed: with a unit of another dimension, or an uncertainty.
    """
    made = type(content)
    if made in REAL or made in NO_NUMBERS:
        return content
    if made is np.ndarray:
        return _of_array(content, argument)
    if made is tuple or made is list:
        return _of_row(content, argument)
    if isinstance(content, np.generic):
        return _of_array(np.asarray(content), argument)
    if isinstance(content, numbers.Number):
        return _of_number(content)
    return _of_other(content, argument)


def _of_number(content: Any) -> Any:
    """Return the float nearest to a Decimal, a Fraction or another real number."""
    try:
        return float(content)
    except READING_FAULTS:  # a complex one, or one beyond all floats
        return content


def _of_array(content: NDArray[Any], argument: Argument) -> Any:
    """Return the numbers of an array of NumPy."""
    kind = content.dtype.kind
    if kind == "O":
        found = _of_row(tuple(content.flat), argument)
        if not isinstance(found, np.ndarray) or found.ndim != 1:
            return content
        content = found.reshape(content.shape)
    elif kind not in "iuf":
        return content
    if content.ndim == 0:
        return int(content) if kind in "iu" else float(content)
    return _read_only(content)


def _of_row(content: Sequence[Any], argument: Argument) -> Any:
    """Return the numbers of a row, or of rows in a row."""
    kinds = set(map(type, content))
    if not (kinds <= REAL or kinds <= NUMPY_REAL):
        parts = [plain(part, argument) for part in content]
        if not all(type(part) in REAL or (isinstance(part, np.ndarray) and part.dtype == float) for part in parts):
            return content
        if len({np.shape(part) for part in parts}) > 1 or len({hasattr(part, "units") for part in content}) > 1:
            return content  # rows of different lengths, or plain numbers beside quantities
        content = parts
    try:
        return _read_only(np.array(content, dtype=float))
    except OverflowError:
        return content


def _of_other(content: Any, argument: Argument) -> Any:
    """Return the numbers of something of another library."""
    if hasattr(content, "nominal_value") and hasattr(content, "std_dev"):
        raise InvalidInput(
            f"{argument.where} is {as_text(content)}, whose uncertainty would be lost; give its nominal_value, "
            "or carry it through the computation with uncertainties.wrap."
        )
    if hasattr(content, "magnitude") and hasattr(content, "dimensionality"):
        return _of_quantity(content, argument)
    if hasattr(content, "iloc") and hasattr(content, "columns"):
        raise InvalidInput(
            f"{argument.where} is a table ({type(content).__name__}); give one of its columns, or all as an array."
        )
    attributes = getattr(content, "attrs", None)
    if isinstance(attributes, Mapping):
        return _of_labelled(content, attributes.get("units"), argument)
    if isinstance(content, np.ma.MaskedArray):
        if content.dtype.kind not in "iuf":
            return content
        return _of_array(np.ma.filled(content.astype(float), np.nan), argument)  # a number below a mask is none
    if (unit := getattr(content, "units", getattr(content, "unit", None))) is not None:
        raise InvalidInput(
            f"{argument.where} is a {type(content).__name__} in {unit}, of a library whose units are not read; "
            f"{argument.ended('give plain numbers{unit}, or a quantity of pint')}."
        )
    if hasattr(content, "__array__") or hasattr(content, "__array_interface__"):
        return _of_arraylike(content, argument)
    return _of_row(tuple(content), argument) if isinstance(content, Sequence) else content


def _of_arraylike(content: Any, argument: Argument) -> Any:
    """Return the numbers of what makes an array of itself."""
    try:
        array = np.asarray(content)
    except READING_FAULTS:
        return content
    found = _of_array(array, argument)
    return content if found is array and array.dtype != float else found


def _of_labelled(content: Any, unit: Any, argument: Argument) -> Any:
    """Return the numbers of a DataArray of xarray, or a column of pandas, in the unit that its attributes name."""
    inside = getattr(content, "data", None)
    if hasattr(inside, "dimensionality"):
        return plain(inside, argument)
    found = _of_arraylike(content, argument)
    if unit is None or found is content:
        return found
    if not isinstance(unit, str):
        raise InvalidInput(f"{argument.where}: the attribute units is {as_text(unit)}; give a text such as 'mm'.")
    return _converted(found, unit, argument)


def _of_quantity(content: Any, argument: Argument) -> Any:
    """Return the numbers of a quantity of pint in the unit of the argument."""
    from winkler.values.unit_grammar import Unreadable, unit_of

    magnitude = plain(content.magnitude, argument)
    unit = f"{content.units:~D}"
    try:
        unit_of(unit)
    except Unreadable:  # a unit that its user has defined
        root = content.to_root_units()
        magnitude, unit = plain(root.magnitude, argument), f"{root.units:~D}"
    return _converted(magnitude, unit, argument)


def _converted(content: Any, unit: str, argument: Argument) -> Any:
    if type(content) in REAL:
        return argument.converted(content, unit)
    return _read_only(argument.converted(content, unit)) if isinstance(content, np.ndarray) else content


def _read_only(array: NDArray[Any]) -> NDArray[Any]:
    """Return an array of floats that nobody writes to: itself if it is one, otherwise a copy."""
    if array.dtype != float or array.base is not None or array.flags.writeable:
        array = np.array(array, dtype=float)
        array.flags.writeable = False
    return array
