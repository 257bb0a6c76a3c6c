"""The laws of adhesion are records: what they accept, what they refuse, how they compare."""

from __future__ import annotations

import math
import pickle
from dataclasses import replace

import pytest

from winkler.laws.adhesion import DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.values.errors import InvalidInput


def test_one_work_is_two_equal_ones():
    assert ShortRange(0.1) == ShortRange(work_closing=0.1, work_opening=0.1) == ShortRange(work=0.1, work_opening=0.1)
    assert hash(ShortRange(0.1)) == hash(ShortRange(work_closing=0.1, work_opening=0.1))
    law = ShortRange(work_closing=0.0, work_opening=0.2)
    assert (law.work, law.work_closing, law.work_opening) == (0.2, 0.0, 0.2)
    assert ShortRange(0.2, work_closing=0.05) == ShortRange(work_closing=0.05, work_opening=0.2)
    assert pickle.loads(pickle.dumps(law)) == law
    assert replace(Dugdale(0.1, 1e8), work=0.2).work == 0.2


@pytest.mark.parametrize(
    ("given", "text"),
    [
        ({}, "no work was given"),
        ({"work_closing": 0.1}, "work_closing alone"),
        ({"work": 0.0}, "positive"),
        ({"work": -0.1}, "-0.1"),
        ({"work": math.nan}, "nan"),
        ({"work": math.inf}, "inf"),
        ({"work": "0.1"}, "'0.1'"),
        ({"work": True}, "True"),
        ({"work": 0.1, "work_opening": 0.2}, "leave one of them out"),
        ({"work_closing": 0.2, "work_opening": 0.1}, "exceeds"),
        ({"work_closing": -0.1, "work_opening": 0.1}, "zero or a positive"),
        ({"work_closing": math.nan, "work_opening": 0.1}, "nan"),
    ],
)
def test_short_range_refuses(given, text):
    with pytest.raises(InvalidInput, match="ShortRange") as caught:
        ShortRange(**given)
    assert text in str(caught.value)


def test_the_others_refuse():
    for wrong in (0.0, -1.0, math.nan, None):
        with pytest.raises(InvalidInput, match="work"):
            DerjaguinMullerToporov(wrong)
        with pytest.raises(InvalidInput, match="strength"):
            Dugdale(0.1, wrong)
    assert Dugdale(0.1, 1e8).range == pytest.approx(1e-9, rel=1e-15, abs=0.0)
