"""The cases of worn elliptic contacts are recomputed without winkler."""

from __future__ import annotations

import tomllib
from pathlib import Path

import numpy as np
import pytest
from elliptic_wear_solutions import WORN_ELLIPSES

import winkler

CASES = Path(winkler.__file__).parent / "cases"


@pytest.mark.parametrize("name", WORN_ELLIPSES)
def test_a_case_states_what_the_reference_solution_gives(name):
    case = tomllib.loads((CASES / f"{name}.toml").read_text(encoding="utf-8"))
    stated = [float(number) for number in WORN_ELLIPSES[name]()]
    np.testing.assert_allclose([item["value"] for item in case["expect"]], stated, rtol=1e-13)


def test_each_worn_ellipse_of_the_ledger_is_recomputed():
    cases = {path.stem: tomllib.loads(path.read_text(encoding="utf-8")) for path in CASES.glob("*.toml")}
    worn = {name for name, case in cases.items() if case.get("problem", {}).get("kind") == "elliptic_wear"}
    assert worn == set(WORN_ELLIPSES)
