"""The cases of worn line contacts are recomputed without winkler."""

from __future__ import annotations

import tomllib
from pathlib import Path

import numpy as np
import pytest
from line_wear_solutions import WORN_LINES

import winkler

CASES = Path(winkler.__file__).parent / "cases"


@pytest.mark.parametrize("name", WORN_LINES)
def test_a_case_states_what_the_reference_solution_gives(name):
    case = tomllib.loads((CASES / f"{name}.toml").read_text(encoding="utf-8"))
    stated = [float(number) for number in WORN_LINES[name]()]
    np.testing.assert_allclose([item["value"] for item in case["expect"]], stated, rtol=1e-13)


def test_each_worn_line_of_the_ledger_is_recomputed():
    kinds = {"line_fretting_wear", "line_sliding_wear", "line_limiting_profile"}
    cases = {path.stem: tomllib.loads(path.read_text(encoding="utf-8")) for path in CASES.glob("line_*.toml")}
    assert {name for name, case in cases.items() if case["problem"]["kind"] in kinds} == set(WORN_LINES)
