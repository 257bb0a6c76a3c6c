"""The cases of rolling lines are recomputed without winkler."""

from __future__ import annotations

import tomllib
from pathlib import Path

import numpy as np
import pytest
from line_rolling_solutions import ROLLING_LINES

import winkler

CASES = Path(winkler.__file__).parent / "cases"


@pytest.mark.parametrize("name", ROLLING_LINES)
def test_a_case_states_what_the_reference_solution_gives(name):
    case = tomllib.loads((CASES / f"{name}.toml").read_text(encoding="utf-8"))
    stated = [float(number) for number in ROLLING_LINES[name]()]
    np.testing.assert_allclose([item["value"] for item in case["expect"]], stated, rtol=1e-13)


def test_each_rolling_line_of_the_ledger_is_recomputed():
    kinds = {"line_rolling", "line_rolling_start", "line_rolling_resistance"}
    cases = {path.stem: tomllib.loads(path.read_text(encoding="utf-8")) for path in CASES.glob("line_*.toml")}
    computed = {
        name for name, case in cases.items() if case["problem"]["kind"] in kinds and case["grade"] != "cross-code"
    }
    assert computed == set(ROLLING_LINES)
