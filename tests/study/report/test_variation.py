"""What is worth a curve: what varies by more than rounding, and than what a solver leaves of zero."""

from pathlib import Path

import numpy as np
import pytest

from winkler.study.batch.run import run
from winkler.study.language.reading import parse_study, read_study
from winkler.study.language.template import whole_text
from winkler.study.report.figures import answers_over
from winkler.study.report.variation import variation_shows
from winkler.web.pictures.histories import curves_of

UP = np.array([0.0, 0.5, 1.0])


@pytest.mark.parametrize(("content", "shows"), [
    (UP, True),
    (1.0 + 1e-4 * UP, True),
    (1.0 + 1e-5 * UP, False),
    (np.array([np.nan, 1.0]), False),
    (np.array([np.nan, 1.0, 2.0]), True),
    (np.zeros(3), False),
])  # fmt: skip
def test_rounding_is_no_variation(content, shows):
    assert variation_shows("force", {"force": content}) is shows


@pytest.mark.parametrize(("name", "beside"), [
    ("shear_force_y", "shear_force_x"),
    ("shift_x", "shift_y"),
    ("lateral_force", "longitudinal_force"),
    ("longitudinal_creepage", "lateral_creepage"),
])  # fmt: skip
def test_a_component_is_compared_with_that_along_another_direction(name, beside):
    assert variation_shows(name, {name: 1e-9 * UP, "force": UP, "torque": UP})
    assert not variation_shows(name, {name: 1e-9 * UP, beside: UP})
    assert variation_shows(name, {name: 1e-5 * UP, beside: UP})
    assert variation_shows(beside, {name: 1e-9 * UP, beside: UP})


def test_a_push_along_x_has_no_curves_along_y():
    outcome = run(parse_study(whole_text("surface_tangential")))
    drawn = curves_of(outcome, outcome.solved[0])
    assert ("shift_x", "shear_force_x") in drawn
    assert not {name for pair in drawn for name in pair} & {"shift_y", "shear_force_y", "angle", "torque"}


@pytest.mark.slow
def test_patches_are_drawn_over_what_was_swept():
    """Near the flange there are two patches; each has its curve, with its own force."""
    study = read_study(Path(__file__).resolve().parents[3] / "examples" / "studies" / "rolling" / "wheel_rail.toml")
    outcome = run(study)
    figures = {one.name: one for one in answers_over(outcome, pictured=False)}
    (axes,) = figures["answer_force"].picture.axes
    first, second = (line.get_xydata() for line in axes.lines)
    assert axes.get_xlabel().startswith("lateral")
    np.testing.assert_allclose(first[:, 0], [-4.0, -2.0, 0.0, 2.0, 3.0])
    forces = outcome.points[-1].answers["force"] / 1e3
    assert forces.size == 2
    np.testing.assert_allclose([first[-1, 1], second[-1, 1]], forces)
    assert np.isnan(second[:-1, 1]).all()
    (axes,) = figures["answer_depth"].picture.axes
    assert len(axes.lines) == 1  # both patches share it
