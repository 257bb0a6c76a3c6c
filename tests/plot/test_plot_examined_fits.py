"""Pictures of fits examined further: whole, labelled, and of the numbers that they show."""

from __future__ import annotations

import numpy as np
import pytest
from synthetic import hertz

import winkler as wk
from winkler.plot import draw
from winkler.plot.fitting.examined import depth_sheet, shared_sheet
from winkler.plot.marks import Area, Line
from winkler.plot.render import render
from winkler.values.vocabulary import Word

E = "bed.medium.first.young"
FREE = [E, "contact_point", "baseline"]
WORD = Word("E", "Pa", "Young's modulus")


def model(profile):
    return wk.Indentation(wk.Foundation(profile, wk.HalfSpace.between(wk.Elastic(3e4, 0.5))), wk.Depth(0.0))


@pytest.fixture(scope="module")
def curves():
    depth, random = np.linspace(-1e-6, 1e-6, 150), np.random.default_rng(1)
    force = hertz(depth, 1e4 / 0.75, 5e-6)
    return [wk.ForceCurve(depth + 2e-6, force + 2e-11 * random.standard_normal(150)) for _ in range(2)]


def labels(figure):
    return [(axes.get_xlabel(), axes.get_ylabel()) for axes in figure.axes]


def test_a_number_over_depth(curves):
    series = wk.over_depth(curves[0], model(wk.Paraboloid(5e-6)), free=FREE, count=4)
    sheet = depth_sheet(series, "Young's modulus", WORD)
    line = next(mark for mark in sheet.panels[0].marks if isinstance(mark, Line))
    assert line.y.tolist() == series.values.tolist()
    ((across, upright),) = labels(render(sheet))
    assert across.endswith("m]")
    assert "depth" in across
    assert upright.startswith("Young's modulus")
    assert upright.endswith("[kPa]")


def test_models_with_their_residuals(curves):
    profiles = {"ball": wk.Paraboloid(5e-6), "cone": wk.Cone(1.2)}
    comparison = wk.compare(curves[0], {name: (model(tip), FREE) for name, tip in profiles.items()})
    figure = draw(comparison)
    assert [axes.get_title(loc="left") or axes.get_title() for axes in figure.axes] == ["", *comparison.models]
    found = labels(figure)
    assert all(upright.endswith("N]") for _, upright in found)
    assert found[-1][0].endswith("[\u00b5m]")
    assert found[0][0] == ""


def test_what_each_curve_says_of_a_shared_number(curves):
    joint = wk.fit_together(curves, model(wk.Paraboloid(5e-6)), free=FREE, shared=[E])
    sheet = shared_sheet(joint, 0, ("a", "b"), "Young's modulus", WORD)
    band = next(mark for mark in sheet.panels[0].marks if isinstance(mark, Area))
    assert (float(band.low[0]), float(band.high[0])) == joint.interval(E)
    ((across, upright),) = labels(render(sheet))
    assert across == "number of the curve"
    assert upright.endswith("[kPa]")
