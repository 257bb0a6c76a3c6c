"""Pictures of line contacts of bodies that relax."""

from __future__ import annotations

import numpy as np

import winkler as wk
from winkler.plot import sheet_of
from winkler.plot.marks import Line

PATH = wk.LineForcePath([0.0, 1.0, 2.0, 3.0], [0.0, 1e3, 1e3, 0.0], count=5)


def pressed(profile, path=PATH):
    rubber = wk.ViscoelasticHalfSpace(wk.StandardSolid(relaxed_shear=1e6, shear=4e6, relaxation_time=0.5))
    return wk.LineViscoelasticIndentation(wk.LineFoundation(profile, rubber), path, count=100).solve()


def test_a_path_shows_force_width_and_pressures():
    solution = pressed(wk.Paraboloid(10e-3))
    force, width, pressure = sheet_of(solution).panels
    assert np.array_equal(force.marks[0].y, solution.force_per_length)
    assert np.array_equal(width.marks[0].y, solution.half_width)
    curves = [mark for mark in pressure.marks if isinstance(mark, Line)]
    assert len(curves) >= 4
    widest = solution.at(int(np.argmax(solution.half_width)))
    assert any(np.array_equal(curve.y, widest.pressure(curve.x)) for curve in curves)


def test_a_state_shows_its_pressure():
    solution = pressed(wk.Cone(1.4))
    (panel,) = sheet_of(solution.at(3)).panels
    (curve,) = [mark for mark in panel.marks if isinstance(mark, Line)]
    middle = np.argmin(np.abs(curve.x))
    assert np.isnan(curve.y[middle])  # infinite below the tip
    assert np.nanmax(curve.y) <= 3.0 * solution.at(3).mean_pressure
    assert sheet_of(solution.at(-1)).panels[0].title == "no contact"
