"""Sheets of strips side by side show their pressures, surfaces and forces, and nothing where there is none."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.plot import sheet_of

UNIT = wk.HalfSpace(wk.Elastic(1.0, 0.0))


def pressed(section, force):
    return wk.LineProfileContact(section, UNIT, wk.LineForce(force)).solve()


@pytest.mark.parametrize(
    "section",
    [
        wk.CylinderRow([1.0, 1.0], [-0.5, 0.5], [0.0, 0.0]),
        wk.PunchRow([-1.0, 0.5], [-0.5, 1.0], [0.0, 0.01]),
        wk.MeasuredSection(np.linspace(-1.0, 1.0, 41), 0.5 * np.linspace(-1.0, 1.0, 41) ** 2),
    ],
)
def test_the_pressure_of_a_sheet_sums_to_the_force(section):
    found = pressed(section, 0.05)
    pressures, surfaces, forces = sheet_of(found).panels
    (line,) = pressures.marks
    p = np.nan_to_num(np.asarray(line.y), nan=0.0)
    assert np.trapezoid(p, line.x) == pytest.approx(0.05, rel=0.1)
    assert len(surfaces.marks) == 2
    np.testing.assert_allclose(forces.marks[0].y, found.strip_forces)


def test_many_loads_and_none_are_drawn():
    row = wk.CylinderRow([1.0, 1.0], [-0.5, 0.5], [0.0, 0.0])
    assert len(sheet_of(pressed(row, np.array([0.0, 0.01, 0.1]))).panels) == 3
    assert len(sheet_of(pressed(row, 0.0)).panels) == 3
