"""Pictures of line contacts that slip."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.plot import sheet_of
from winkler.plot.marks import Band, Line

STEEL = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, STEEL)


def sheared(profile, path, medium=PAIR):
    return wk.LineTangential(wk.LineFoundation(profile, medium), wk.Coulomb(0.5), path).solve()


def marks(panel, kind):
    return [mark for mark in panel.marks if isinstance(mark, kind)]


def test_a_path_shows_its_loop_traction_and_slip():
    solution = sheared(wk.Paraboloid(10e-3), wk.LinePath(1e5, [0.0, 3e4, -3e4], bulk_stress=100e6, count=4))
    loop, traction, slip = sheet_of(solution).panels
    assert np.array_equal(marks(loop, Line)[0].y, solution.shear_force_per_length)
    (stick,) = marks(traction, Band)
    c, e = solution.stick_half_width[-1], solution.stick_middle[-1]
    assert (stick.low, stick.high) == pytest.approx((e - c, e + c))
    (rubbed,) = [mark for mark in marks(traction, Line) if mark.name == "$q$"]
    assert rubbed.y == pytest.approx(solution.at(-1).traction(rubbed.x))
    (ahead,) = [mark for mark in marks(slip, Line) if mark.name]
    assert np.max(np.abs(ahead.x)) <= solution.half_width[-1]


def test_a_state_shows_the_stress_of_a_body_that_deforms():
    path = wk.LinePath(1e5, [0.0, 3e4])
    assert len(sheet_of(sheared(wk.Paraboloid(10e-3), path).at(-1)).panels) == 3
    soft = wk.HalfSpace(wk.Rigid(), wk.Elastic(210e9, 0.5))
    assert len(sheet_of(sheared(wk.Paraboloid(10e-3), path, soft).at(-1)).panels) == 2


@pytest.mark.slow
def test_a_path_out_of_phase_shows_what_was_marched():
    path = wk.LinePath(1e5, [0.0, 3e4, -1e4], bulk_stress=[1e8, 0.0, 1.5e8])
    solution = sheared(wk.Cone(1.5), path)
    _, traction, slip = sheet_of(solution).panels
    (stick,) = marks(traction, Band)
    assert stick.high - stick.low == pytest.approx(2.0 * solution.stick_half_width[-1])
    assert all(np.all(np.isfinite(mark.y)) for mark in marks(slip, Line))
    assert len(sheet_of(solution.at(-1)).panels) == 3


def test_the_last_contact_is_shown_where_the_bodies_part():
    parted = sheared(wk.Paraboloid(10e-3), wk.LinePath([1e5, 0.0], [1e4, 0.0]))
    assert [panel.title for panel in sheet_of(parted).panels][1:] == ["traction (last contact)", "slip (last contact)"]
    assert [panel.title for panel in sheet_of(sheared(wk.Paraboloid(10e-3), wk.LinePath(0.0, 0.0))).panels][1] == (
        "no contact"
    )
    assert len(sheet_of(parted.at(-1)).panels) == 1


def test_an_infinite_traction_is_cut_off():
    """At a sharp tip mu p has no bound."""
    panel = sheet_of(sheared(wk.Cone(1.5), wk.LinePath(1e5, [0.0, 3e4])).at(-1)).panels[0]
    assert all(np.nanmax(np.abs(mark.y)) < np.inf for mark in marks(panel, Line))
