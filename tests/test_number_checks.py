"""What numbers the fields of values hold, and the one sentence that refuses others."""

from __future__ import annotations

import math
import re
from typing import Annotated, Any

import numpy as np
import pytest

from winkler.materials.spring_and_dashpot import Maxwell
from winkler.values.checks.number_checks import (
    POSITIVE,
    Advice,
    Count,
    Finite,
    FiniteQuantity,
    Fraction,
    NonNegative,
    NonNegativeQuantity,
    Numbers,
    PoissonRatio,
    Positive,
    PositiveNotTiny,
    PositiveOfAnySize,
    PositiveOrInfinite,
    PositiveRow,
    Whole,
    between,
    checked,
)
from winkler.values.errors import InvalidInput
from winkler.values.value import value

NO_NUMBERS = (True, "1", None, math.nan, 1j, [1.0], np.array([1.0, 2.0]))
ENDLESS = (math.inf, -math.inf)


def made(hint):
    """Return a value with one field, the mass, of a type."""
    return value(type("Ball", (), {"__annotations__": {"mass": hint}, "__module__": __name__}))


def refused(hint, given, sentence):
    with pytest.raises(InvalidInput, match=sentence) as caught:
        made(hint)(given)
    assert str(caught.value).startswith("Ball: mass ")


@pytest.mark.parametrize("given", [*NO_NUMBERS[:-2], *ENDLESS, 0.0, -0.0, 0, -1e-300])
def test_what_is_not_positive_is_refused(given):
    refused(Positive, given, rf"is {re.escape(repr(given))}; it must be a positive, finite number in kg\.$")


@pytest.mark.parametrize(
    ("hint", "sentence", "bad", "good"),
    [
        (Positive, "positive, finite", (), (5e-324, 1, 1e60)),
        (PositiveNotTiny, "positive, finite", (0.0,), (1e-60, 1, 1e60)),
        (PositiveOfAnySize, "positive, finite", (0.0,), (5e-324, 1e308)),
        (PositiveOrInfinite, "positive number in kg, or infinite", (0.0, -math.inf), (1e-9, math.inf)),
        (NonNegative, "zero or a positive, finite number in kg", (-1e-300, math.inf), (0, 0.0, 2.5)),
        (Finite, "a finite number in kg", ENDLESS, (-3.0, 0, 1e60)),
        (PoissonRatio, "above -1 and at most 0.5", (-1.0, 0.5000001, *ENDLESS), (-0.999, 0, 0.5)),
        (Fraction, "from 0 to 1", (-1e-9, 1.0000001), (0, 1, 0.5)),
        (Annotated[float, between(1e-9, 0.1)], "between 1e-9 and 0.1 in kg", (0.0, 0.2), (1e-9, 0.1)),
        (Annotated[Positive, Advice("weigh it")], r"finite number in kg: weigh it\.$", (0.0,), (1.0,)),
    ],
)
def test_numbers_within_bounds(hint, sentence, bad, good):
    for given in (*NO_NUMBERS, *bad):
        refused(hint, given, sentence)
    for given in good:
        assert made(hint)(given).mass == given


@pytest.mark.parametrize("given", [1e61, 2**201, 10**5000], ids=["float", "whole", "huge"])
def test_what_is_beyond_physics_is_refused_with_its_size(given):
    refused(Positive, given, "numbers in SI units are between 1e-60 and 1e.60 in size: check the unit")
    refused(FiniteQuantity, given, "check the unit")
    refused(PositiveNotTiny, 1e-61, "mass is 1e-61; .* check the unit")


@pytest.mark.parametrize(
    ("given", "least", "most"),
    [(1.0, 1, 9), (True, 0, 9), (0, 1, 9), (10, 1, 9), (3, 4, math.inf), (2**41, 1, math.inf)],
)
def test_what_is_no_whole_number_within_bounds_is_refused(given, least, most):
    allowed = f"at least {least}" if most == math.inf else f"from {least} to {most}"
    refused(Annotated[int, Whole(least, most)], given, f"give a whole number,? {allowed}")
    assert made(Count)(least + 1).mass == least + 1


@pytest.mark.parametrize(
    ("hint", "given", "sentence"),
    [
        (PositiveRow, [1.0, 0.0, 2.0], "is 0.0 at index 1; give a row of positive, finite numbers in kg"),
        (PositiveRow, [math.nan] * 7, "is nan at index 0, 1, 2, 3, 4 and 2 more"),
        (PositiveRow, [[1.0, 2.0]], r"has the shape \(1, 2\)"),
        (PositiveRow, [], "is empty"),
        (PositiveRow, ["1"], "is .*; give a row"),
        (PositiveRow, [True], "give a row"),
        (Annotated[Any, Numbers(fewest=3)], [1.0, 2.0], "has 2 numbers; give a row of at least 3 finite numbers"),
        (Annotated[Any, Numbers(most=2)], [1.0, 2.0, 3.0], "3 numbers are too many; give at most 2"),
        (Annotated[Any, Numbers(order="rising")], [1.0, 1.0], r"does not rise from index 0 \(1\) to the next \(1\)"),
        (Annotated[Any, Numbers(order="never falling")], [1.0, 1.0, 0.5], "falls from index 1"),
        (NonNegativeQuantity, np.array([[1.0], [-1.0]]), "is -1.0 at index 1; .*, none of them negative"),
        (PositiveRow, [1e61], "up to 1e.61 in size"),
    ],
)
def test_rows_are_refused_with_the_place(hint, given, sentence):
    with pytest.raises(InvalidInput, match=sentence):
        made(hint)(given)


def test_rows_become_read_only_arrays_of_floats():
    row = made(PositiveRow)([1, 2]).mass
    assert row.dtype == float
    assert not row.flags.writeable
    assert made(FiniteQuantity)(3).mass == 3
    assert made(FiniteQuantity)([[1], [2]]).mass.shape == (2, 1)


def test_fields_are_refused_in_the_order_in_which_they_stand():
    with pytest.raises(InvalidInput, match=r"^Maxwell: shear is -1.0; .* in Pa\.$"):
        Maxwell(-1.0, -2.0)


def test_a_number_of_numpy_is_a_number():
    assert checked(POSITIVE, "owner", "length", np.float64(2.0), "m") == 2.0
    assert checked(POSITIVE, "owner", "length", np.float32(2.0), "m") == 2.0
    with pytest.raises(InvalidInput, match=r"length is True; it must be"):
        checked(POSITIVE, "owner", "length", np.True_, "m")
