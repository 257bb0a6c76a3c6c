"""The measured-like tip that ships with the project: made as its script says, and solved as its geometry demands."""

from __future__ import annotations

import dataclasses
import math
import subprocess
import sys

import numpy as np

import winkler as wk
from winkler.study.batch.run import run
from winkler.study.language.reading import read_study
from winkler.study.language.study import Fields


def test_the_script_makes_the_file(root, tmp_path):
    data = root / "examples" / "data"
    subprocess.run([sys.executable, str(data / "make_measured_tip.py")], cwd=tmp_path, check=True, capture_output=True)
    made = (tmp_path / "measured_tip.csv").read_text(encoding="utf-8")
    shipped = (data / "measured_tip.csv").read_text(encoding="utf-8")
    assert "NOT a real measurement" in shipped
    assert [line for line in made.splitlines() if line[0] not in "-0123456789"] == [
        line for line in shipped.splitlines() if line[0] not in "-0123456789"
    ]
    skip = shipped.count("\n#") + 2
    one, two = (np.loadtxt(text.splitlines(), delimiter=",", skiprows=skip) for text in (made, shipped))
    np.testing.assert_allclose(one, two, atol=0.011)


def test_the_study_finds_the_tip_behind_the_scatter(root):
    """Depths agree with the known geometry to the scatter of the points, 0.2 nm."""
    study = dataclasses.replace(read_study(root / "examples/studies/normal/measured_tip.toml"), fields=Fields())
    outcome = run(study)
    assert outcome.failed == ()
    tip = wk.SpheroConical(curvature_radius=120e-9, half_angle=math.radians(35.0))
    bed = wk.Foundation(tip, study.problem.bed.medium)
    force = outcome.answer("force")[:, 0]
    known = wk.Indentation(bed, wk.Force(force)).solve()
    difference = outcome.answer("depth")[:, 0] - known.depth
    assert force.size == 9
    assert np.max(np.abs(difference)) < 0.2e-9
    assert any("smoothed" in note.statement for note in outcome.validity)
