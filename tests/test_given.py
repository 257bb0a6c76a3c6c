"""What a number that is given may be, and the one sentence that refuses it."""

from __future__ import annotations

import math
import re

import pytest
from winkler.given import not_negative, poisson_ratio, positive, positive_fields, whole_number

from winkler.errors import InvalidInput
from winkler.materials.spring_and_dashpot import Maxwell

NO_NUMBERS = (True, "1", None, math.nan, math.inf, -math.inf, 1j)


@pytest.mark.parametrize("given", [*NO_NUMBERS, 0.0, -0.0, 0, -1e-300])
def test_what_is_not_positive_is_refused(given):
    with pytest.raises(InvalidInput, match=rf"^Ball: mass is {re.escape(repr(given))}; it must be a positive, f"):
        positive("Ball", "mass", given, "kg")


@pytest.mark.parametrize("given", [5e-324, 1, 1e308])
def test_what_is_positive_passes(given):
    positive("Ball", "mass", given, "kg")
    not_negative("Ball", "mass", given, "kg")


def test_a_plain_number_is_told_without_a_unit():
    with pytest.raises(InvalidInput, match=r"finite number\.$"):
        positive("Law", "exponent", 0.0, "")


@pytest.mark.parametrize("given", [*NO_NUMBERS, -1e-300, -1])
def test_what_is_negative_is_refused(given):
    with pytest.raises(InvalidInput, match=r"give zero or a positive, finite number in ohm\.$"):
        not_negative("Film", "resistance", given, "ohm")
    not_negative("Film", "resistance", 0.0, "ohm")


@pytest.mark.parametrize("given", [*NO_NUMBERS, -1.0, 0.5000001])
def test_what_is_no_poisson_ratio_is_refused(given):
    with pytest.raises(InvalidInput, match="a Poisson ratio is above -1 and at most 0.5"):
        poisson_ratio("Solid", given)
    for fine in (-0.999, 0, 0.5):
        poisson_ratio("Solid", fine)


@pytest.mark.parametrize(
    ("given", "least", "most"), [(1.0, 1, 9), (True, 0, 9), (0, 1, 9), (10, 1, 9), (3, 4, math.inf)]
)
def test_what_is_no_whole_number_within_bounds_is_refused(given, least, most):
    allowed = f"at least {least}" if most == math.inf else f"from {least} to {most}"
    with pytest.raises(InvalidInput, match=f"give a whole number,? {allowed}"):
        whole_number("March", "count", given, least, most)
    whole_number("March", "count", least, least, most)


def test_fields_are_refused_in_the_order_in_which_they_are_named():
    fluid = Maxwell(1.0, 1.0)
    object.__setattr__(fluid, "shear", -1.0)
    object.__setattr__(fluid, "relaxation_time", -2.0)
    with pytest.raises(InvalidInput, match=r"^Maxwell: relaxation_time is -2.0; .* in s\.$"):
        positive_fields(fluid, relaxation_time="s", shear="Pa")
