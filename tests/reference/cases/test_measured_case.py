"""A curve that was measured, and what the instrument itself made of it."""

from __future__ import annotations

import shutil
import zipfile
from pathlib import Path

import pytest

from winkler.study.ledger.ledger import remarks, run_case

CASE = Path(__file__).parents[1] / "measured" / "chiaro_bead.toml"


@pytest.mark.slow
def test_a_bead_on_a_soft_sample(tmp_path, shared_data):
    (curve,) = (shared_data / "force_curves").glob("fmt-chiaro-txt_AEBP1_*.zip")
    with zipfile.ZipFile(curve) as packed:
        packed.extractall(tmp_path)
    (text,) = tmp_path.glob("*.txt")
    stated = dict(
        line.split("\t")[:2] for line in text.read_text(encoding="latin1").splitlines() if line.startswith("E[")
    )
    assert {word: float(number) for word, number in stated.items()} == {
        "E[eff] (Pa)": 156.009,
        "E[v=0.500] (Pa)": 117.007,
    }
    shutil.copy(CASE, tmp_path)
    entry = run_case(tmp_path / CASE.name)
    assert entry.grade == "measured"
    assert entry.passed
    (verdict,) = entry.verdicts
    assert f"E = {verdict.got:.2f} Pa" in remarks()
