"""Pictures of sweeps: the numbers that they show, their units, and which picture a design gets."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.plot.render import render
from winkler.plot.series import Series
from winkler.plot.sweeps import VariancePart, cloud_sheet, map_sheet, part_sheet
from winkler.study.batch.run import run
from winkler.study.language.designs import Sensitivity, Sobol, Zipped
from winkler.study.language.study import Study
from winkler.study.language.varied import Axis, Range
from winkler.study.report.figures import answers_over
from winkler.study.report.sweep_figures import mapped, varied_series
from winkler.values.vocabulary import GLOSSARY

BED = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace(wk.Elastic(1e9, 0.25)))
PROBLEM = wk.Indentation(BED, wk.Force(1.0))


def named(name: str, content) -> Series:
    return Series(name, GLOSSARY[name], np.asarray(content, dtype=float))


def test_a_map_shows_every_number_in_its_place():
    force, depth = np.geomspace(1.0, 100.0, 12), np.linspace(1e-6, 3e-6, 13)[::-1]
    content = np.arange(12 * 13, dtype=float).reshape(12, 13) + 1.0
    content[3, 4] = np.nan
    axes, bar = render(map_sheet(named("force", force), named("depth", depth), named("radius", 1e-6 * content))).axes
    shown = axes.collections[0].get_array().reshape(13, 12)
    np.testing.assert_allclose(shown.filled(np.nan), content[:, ::-1].T)
    assert axes.get_xscale() == "log"
    assert axes.get_xlabel().endswith("[N]")
    assert axes.get_ylabel().endswith("[µm]")
    assert bar.get_ylabel().endswith("[µm]")
    edges = axes.collections[0].get_coordinates()[0, :, 0]
    assert np.all((edges[:-1] < force) & (force < edges[1:]))


def test_a_cloud_has_a_panel_for_every_key():
    drawn = np.random.default_rng(0).random(50)
    figure = render(
        cloud_sheet([named("force", drawn), named("depth", 1e-6 * drawn)], named("radius", 1e-3 * drawn**2))
    )
    first, second = figure.axes
    for panel in (first, second):
        np.testing.assert_allclose(panel.collections[0].get_offsets()[:, 1], drawn**2 * 1e3)
    assert first.get_ylabel().endswith("[µm]")
    assert second.get_ylabel() == ""
    assert second.get_xlabel().endswith("[nm]")


def test_bars_show_the_indices_and_their_intervals():
    part = VariancePart("alone", np.array([0.7, 0.2]), np.array([0.6, 0.1]), np.array([0.8, 0.35]))
    sheet = part_sheet(["load.force", "bed.medium.first.young"], [part, part._replace(label="both")])
    (axes,) = render(sheet).axes
    assert [bar.get_width() for bar in axes.patches] == [0.7, 0.2, 0.7, 0.2]
    ends = [line.get_segments() for line in axes.collections]
    np.testing.assert_allclose([segment[:, 0] for segment in ends[0]], [[0.6, 0.8], [0.1, 0.35]])
    assert [label.get_text() for label in axes.get_yticklabels()] == ["load.force", "bed.medium.first.young"]


def test_keys_of_one_name_are_distinguished():
    keys = ("problem.bed.medium.first.young", "problem.bed.medium.second.young", "problem.load.force")
    bed = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace.between(wk.Elastic(1e9, 0.25), wk.Elastic(1e9, 0.25)))
    study = Study("x", wk.Indentation(bed, wk.Force(1.0)), sweep=tuple(Axis(key, (1e9, 2e9)) for key in keys))
    names = [varied_series(study, axis).name for axis in study.axes]
    assert names == ["bed.medium.first.young", "bed.medium.second.young", "force"]


FINE = tuple(np.linspace(1.0, 2.0, 12).tolist())


@pytest.mark.parametrize(
    ("sweep", "design", "expected"),
    [
        ((Axis("problem.load.force", FINE), Axis("problem.bed.medium.first.young", FINE)), None, True),
        ((Axis("problem.load.force", FINE), Axis("problem.bed.medium.first.young", FINE[:11])), None, False),
        ((Axis("problem.load.force", FINE), Axis("problem.bed.medium.first.young", FINE)), Zipped(), False),
        ((Axis("problem.load.force", FINE),), None, False),
    ],
)
def test_two_long_keys_make_a_map(sweep, design, expected):
    assert mapped(Study("x", PROBLEM, sweep=sweep, **({} if design is None else {"design": design}))) is expected


@pytest.mark.few(1)
@pytest.mark.parametrize(
    ("design", "names"),
    [(Sobol(8), ["answer_depth"]), (Sensitivity(8), ["sensitivity_depth", "sensitivity_radius"])],
)
def test_drawn_points_are_dots(design, names):
    study = Study("x", PROBLEM, sweep=(Range("problem.load.force", 1.0, 2.0),), design=design)
    shown = answers_over(run(study))
    found = [next(shown) for _ in names]
    assert [one.name for one in found] == names
    assert all(one.drawing for one in found)
