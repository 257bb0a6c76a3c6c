"""What nobody should give as an argument, and what may become of it: a refusal, or the value that it stands for."""

from __future__ import annotations

import dataclasses
import datetime
import math
from collections.abc import Callable, Iterator
from decimal import Decimal
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
import pandas as pd
import pint
import xarray as xr

import winkler as wk

UNITS = pint.UnitRegistry()


class Uncertain:
    """A number with an uncertainty, as the package uncertainties has it."""

    nominal_value, std_dev = 0.5, 0.1

    def __repr__(self) -> str:
        return "0.5+/-0.1"


class Foreign(np.ndarray):
    """An array with the units of another library."""

    unit = "lbf"


class ClaimsArray:
    """Offers an array and has none."""

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        raise RuntimeError("on another device")


ROW = (0.25, 0.5)
WRONG: dict[str, Any] = {
    "none": None,
    "truth": True,
    "truth of NumPy": np.bool_(True),
    "text": "1 N",
    "bytes": b"12",
    "bytearray": bytearray(b"12"),
    "complex": 1.0 + 2.0j,
    "complex without imaginary part": np.complex128(1.0),
    "complex array": np.array([1.0 + 1.0j, 2.0]),
    "set": {0.5},
    "table": {"a": 0.5},
    "object": object(),
    "class": wk.Sphere,
    "function": len,
    "generator": (number for number in ROW),
    "nan": math.nan,
    "huge": 10**400,
    "empty": [],
    "ragged": [[1.0], [1.0, 2.0]],
    "with a text": [1.0, "2"],
    "with none": [1.0, None],
    "with a truth": [1.0, True],
    "texts": np.array(["1", "2"]),
    "truths": np.array([True, False]),
    "array of one row": np.array([[0.25, 0.5]]),
    "records": np.zeros(2, dtype=[("a", float)]),
    "duration": np.timedelta64(5, "ns"),
    "dates": pd.Series(pd.date_range("2026-01-01", periods=2)),
    "time": datetime.timedelta(seconds=1.0),
    "data frame": pd.DataFrame({"a": [0.25, 0.5]}),
    "column of texts": pd.Series(["1", "2"]),
    "column with a gap": pd.Series([1, None], dtype="Int64"),
    "data set": xr.Dataset({"a": ("x", [0.25, 0.5])}),
    "unit of no argument": UNITS.Quantity(1.0, "mol**3"),
    "units of no argument": UNITS.Quantity([0.25, 0.5], "mol**3"),
    "quantities beside numbers": [UNITS.Quantity(1.0, "mol**3"), 1.0],
    "labelled, unit of no argument": xr.DataArray([0.25, 0.5], attrs={"units": "mol^3"}),
    "labelled, no unit": xr.DataArray([0.25, 0.5], attrs={"units": 3}),
    "unit of nobody": np.array([0.25, 0.5]).view(Foreign),
    "uncertain": Uncertain(),
    "uncertain quantity": UNITS.Quantity(Uncertain(), "N"),
    "array of nobody": ClaimsArray(),
    "another value": wk.Springs(*(np.ones(1) for _ in range(4))),
    # what may well be meant
    "decimal": Decimal("0.5"),
    "fraction": Fraction(1, 2),
    "number of NumPy": np.float32(0.5),
    "array without dimension": np.array(0.5),
    "column": pd.Series(ROW),
    "labelled": xr.DataArray(list(ROW)),
    "decimals": [Decimal("0.25"), Fraction(1, 2)],
    "objects": np.array([0.25, Decimal("0.5")], dtype=object),
    "range": range(2),
}
MEANT: dict[str, Any] = {
    "decimal": 0.5,
    "fraction": 0.5,
    "number of NumPy": 0.5,
    "array without dimension": 0.5,
    "column": ROW,
    "labelled": ROW,
    "decimals": ROW,
    "objects": ROW,
    "range": (0.0, 1.0),
    "column with a gap": (1.0, math.nan),
}
"""The numbers that some of them stand for."""


def meant(name: str, given: Any, stored: Any) -> bool:
    """Return whether what is stored is what was given: the same thing, or the numbers that it stands for."""
    if stored is given or (type(stored) is type(given) and isinstance(given, bool | float | str) and stored == given):
        return True
    if name == "truth of NumPy":
        return stored is True
    if name in ("array of one row", "truths", "texts"):
        return np.array_equal(np.asarray(stored), given)
    if name == "empty":
        return isinstance(stored, tuple | np.ndarray) and len(stored) == 0
    if name == "nan":
        return isinstance(stored, float) and math.isnan(stored)
    if name not in MEANT:
        return False
    kinds = {stored.dtype.type} if isinstance(stored, np.ndarray) else {*map(type, np.atleast_1d(stored).tolist())}
    plain = isinstance(stored, float | tuple | np.ndarray) and kinds <= {float, np.float64}
    return plain and np.array_equal(np.asarray(stored), np.asarray(MEANT[name]), equal_nan=True)


class Fault(NamedTuple):
    """Something that became neither a refusal in one sentence nor what was meant."""

    argument: str
    wrong: str
    what: str


def faults(owner: str, argument: str, take: Callable[[Any], Any], *, named: bool = True) -> Iterator[Fault]:
    """Yield what goes wrong as an argument takes one wrong content after the other, and returns what it keeps of it.

    The sentence of a refusal is `named` after the argument; where other arguments are compared with it, after them.
    """
    for name, given in WRONG.items():
        try:
            kept = take(given)
        except (wk.InvalidInput, wk.OutsideValidity) as refusal:
            sentence = str(refusal)
            unnamed = named and argument not in sentence
            if unnamed or "\n" in sentence or " at 0x" in sentence or not sentence.endswith("."):
                yield Fault(f"{owner}.{argument}", name, sentence)
        except Exception as error:
            yield Fault(f"{owner}.{argument}", name, f"{type(error).__name__}: {error}")
        else:
            if not meant(name, given, kept):
                yield Fault(f"{owner}.{argument}", name, f"kept as {kept!r:.80}")


def public_values() -> list[Any]:
    """Return the public classes of values."""
    classes = [getattr(wk, name) for name in wk.__all__]
    return [cls for cls in classes if isinstance(cls, type) and dataclasses.is_dataclass(cls)]
