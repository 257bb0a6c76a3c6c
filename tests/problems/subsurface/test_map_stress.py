"""Stresses below given maps and below height maps: digits of Hertz, axes, yield, files, refusals."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.problems.normal.elliptic_stress import greatest_under_ellipse

STEEL = wk.Elastic(210e9, 0.3, strength=1e9)
HILL = 1e8 * np.array([[1.0, 2.0, 1.0], [2.0, 4.0, 3.0]])
PARTS = tuple(f"{part}_{kind}" for kind, parts in (("stress", ("xx", "yy", "zz", "xy", "xz", "yz")),) for part in parts)


def pressed_ball(count, first=STEEL, second=STEEL):
    x = (np.arange(count) + 0.5) / count * 1.2e-3 - 0.6e-3
    ball = wk.Topography(-(x[:, None] ** 2 + x**2) / (2 * 10e-3), [1.2e-3, 1.2e-3])
    return wk.SurfaceContact(ball, wk.HalfSpace(first, second), wk.Force(100.0)).solve()


def test_a_pressed_ball_has_the_stresses_of_hertz():
    """Boundary elements with the stresses of their pixels against the springs' closed form, second order."""
    ball = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace(STEEL, STEEL))
    hertz = wk.Indentation(ball, wk.Force(100.0)).solve()
    r = np.array([0.0, 0.1e-3, 0.25e-3, 0.4e-3])
    z = np.array([0.1e-3, 0.05e-3, 0.15e-3, 0.3e-3])
    exact = wk.restore(hertz, r, z)
    largest = float(np.max(exact.von_mises))
    errors = []
    for count in (32, 64, 128):
        found = pressed_ball(count).stresses(0.6e-3 + r, 0.6e-3, z)
        pairs = (("xx", "radial"), ("yy", "hoop"), ("zz", "axial"), ("xz", "shear"))
        errors.append(
            max(float(np.max(np.abs(getattr(found, f"{a}_stress") - getattr(exact, f"{b}_stress")))) for a, b in pairs)
            / largest
        )
    assert errors[2] < 2e-3
    assert errors[0] / errors[2] > 9.0
    np.testing.assert_allclose(found.x_displacement, exact.radial_displacement, atol=2e-3 * hertz.depth)
    np.testing.assert_allclose(found.z_displacement, exact.axial_displacement, rtol=5e-3)


@pytest.mark.slow
def test_the_greatest_stress_of_both_bodies_and_the_yield_note():
    soft = wk.Elastic(70e9, 0.2, strength=0.3e9)
    contact = pressed_ball(96, soft, STEEL)
    peak = (6.0 * 100.0 * contact.problem.medium.modulus**2 / (math.pi**3 * (10e-3) ** 2)) ** (1 / 3)
    for below, solid in ((True, soft), (False, STEEL)):
        spot = contact.greatest_stress(below=below)
        assert spot.value == pytest.approx(greatest_under_ellipse(1.0, solid.poisson).value * peak, rel=2e-3)
        assert [spot.x, spot.y] == pytest.approx([0.6e-3, 0.6e-3], abs=1e-6)
    notes = [note for note in contact.validity if note.assumption is wk.Assumption.ELASTIC]
    assert [note.standing for note in notes] == [wk.Standing.OUTSIDE]
    share = contact.greatest_stress().value / 0.3e9
    assert f"{share:.3g} times the strength of the first body" in notes[0].statement
    strong = pressed_ball(48, wk.Elastic(70e9, 0.2, strength=5e9), STEEL)
    notes = [note for note in strong.validity if note.assumption is wk.Assumption.ELASTIC]
    assert [note.standing for note in notes] == [wk.Standing.ASYMPTOTIC]


@pytest.mark.slow
def test_the_force_at_which_a_ball_yields():
    """(pi R)^2 p_Y^3 pi / (6 E*^2) with the pressure of Hertz that makes the strength."""
    pressed = pressed_ball(64)
    modulus = pressed.problem.medium.modulus
    limit = 1e9 / greatest_under_ellipse(1.0, 0.3).value
    expected = math.pi**3 * limit**3 * (10e-3) ** 2 / (6.0 * modulus**2)
    assert pressed.yield_force() == pytest.approx(expected, rel=5e-3)
    assert pressed_ball(32, wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3)).yield_force() == math.inf


def test_planes_and_depths_are_those_of_places():
    load = wk.SurfaceLoad(HILL, [2e-3, 3e-3], 0.2 * HILL, -0.1 * HILL, [1e-3, -1e-3])
    solution = wk.MapStress(load, STEEL).solve()
    assert [solution.force, solution.x_force, solution.y_force] == pytest.approx([1300.0, 260.0, -130.0])
    depths = [0.2e-3, 1e-3]
    for plane in (
        solution.stresses_on_plane(depths, x=1.7e-3),
        solution.stresses_on_plane(depths, y=0.2e-3),
        solution.stresses_at_depth(0.4e-3),
    ):
        places = solution.stresses(plane.x, plane.y, plane.z)
        for name in (*PARTS, "x_displacement", "y_displacement", "z_displacement"):
            size = np.max(np.abs(getattr(places, name)))
            np.testing.assert_allclose(getattr(plane, name), getattr(places, name), atol=1e-12 * size)
    assert load.places[0] == pytest.approx([1.5e-3, 2.5e-3])
    assert plane.x[:, 0] == pytest.approx(load.places[0])
    found = solution.stresses(solution.x, solution.y, solution.z)
    assert float(found.von_mises) == pytest.approx(solution.von_mises, rel=1e-9)
    assert solution.yield_factor == pytest.approx(1e9 / solution.von_mises)


def test_the_second_body_is_dragged_the_other_way():
    load = wk.SurfaceLoad(HILL, [2e-3, 3e-3], 0.2 * HILL)
    assert np.array_equal(load.reversed().x_traction, -load.x_traction)
    assert load.reversed().reversed() == wk.SurfaceLoad(HILL, [2e-3, 3e-3], 0.2 * HILL, periodic=False)
    contact = pressed_ball(32)
    first, second = (contact.stresses(0.6e-3, 0.6e-3, z) for z in (0.1e-3, -0.1e-3))
    assert float(first.zz_stress) == float(second.zz_stress)


def test_periodic_maps_hold_their_width():
    """Under an even pressure that goes on for ever nothing stretches: nu / (1 - nu) of it across."""
    even = wk.SurfaceLoad(np.full((4, 4), 2e8), [1e-3, 1e-3], periodic=True)
    found = wk.MapStress(even, STEEL).solve().stresses(0.1e-3, 0.2e-3, 0.3e-3)
    assert float(found.zz_stress) == pytest.approx(-2e8)
    assert float(found.xx_stress) == pytest.approx(-2e8 * 0.3 / 0.7)


def test_tables_and_arrays_are_read(tmp_path):
    table = tmp_path / "map.csv"
    rows = ["x [mm], y [mm], pressure [MPa], tx [MPa]"]
    rows += [f"{i}, {2 * j}, {HILL[i, j] / 1e6}, {HILL[i, j] / 1e7}" for j in (2, 0, 1) for i in (1, 0)]
    table.write_text("\n".join(rows), encoding="utf-8")
    load = wk.read_surface_load(table)
    np.testing.assert_allclose(load.pressure, HILL)
    np.testing.assert_allclose(load.x_traction, 0.1 * HILL)
    assert load.corner == pytest.approx([-0.5e-3, -1e-3])
    assert load.lengths == pytest.approx([2e-3, 6e-3])
    table.write_text("\n".join(rows[:-1]), encoding="utf-8")
    assert wk.read_surface_load(table).pressure[0, 1] == 0.0
    np.savez(tmp_path / "map.npz", pressure=HILL, lengths=[1.0, 2.0], y_traction=HILL)
    assert wk.read_surface_load(tmp_path / "map.npz", periodic=True).y_force == pytest.approx(13e8 / 3.0)


@pytest.mark.parametrize(
    ("rows", "sentence"),
    [
        (["x [mm], y [mm], p [MPa]", "0,0,1", "1,0,1", "1.3,1,1", "2,1,1"], "lies between the pixels"),
        (["x [mm], y [mm], p [MPa]", "0,0,1", "0,1,1"], "all places lie at one x"),
        (["x [mm], y [mm], p [MPa]", "0,0,1", "1,1,1", "1,1,2"], "listed twice"),
        (["x [mm], y [mm], p [MPa]", "0,0,0", "1,1,0"], "all pressures and tractions are zero"),
        (["x [mm], y [mm]", "0,0", "1,1"], "pressure"),
    ],
)
def test_other_tables_are_refused(tmp_path, rows, sentence):
    table = tmp_path / "map.csv"
    table.write_text("\n".join(rows), encoding="utf-8")
    with pytest.raises(wk.InvalidInput, match=sentence):
        wk.read_surface_load(table)


def test_refusals():
    with pytest.raises(wk.InvalidInput, match="the same pixels"):
        wk.SurfaceLoad(HILL, [1.0, 1.0], np.ones((2, 2)))
    with pytest.raises(wk.InvalidInput, match="finite numbers in Pa"):
        wk.SurfaceLoad(np.array([[1.0, np.nan]]), [1.0, 1.0])
    with pytest.raises(wk.InvalidInput, match="give two positive lengths"):
        wk.SurfaceLoad(HILL, [1.0])
    with pytest.raises(wk.InvalidInput, match="the corner"):
        wk.SurfaceLoad(HILL, [1.0, 1.0], corner=[1.0])
    with pytest.raises(wk.InvalidInput, match="begins at .0, 1e.30. m, so far away that pixels of 0.333333 m"):
        wk.SurfaceLoad(HILL, [1.0, 1.0], corner=[0.0, 1e30])
    contact = pressed_ball(32, STEEL, wk.Rigid())
    with pytest.raises(wk.OutsideValidity, match="rigid"):
        contact.stresses(0.0, 0.0, -1e-4)
    with pytest.raises(wk.InvalidInput, match="both bodies"):
        contact.stresses(0.0, 0.0, [-1e-4, 1e-4])
    with pytest.raises(wk.InvalidInput, match="one depth"):
        contact.stresses_at_depth([1e-4, 2e-4])
    with pytest.raises(wk.InvalidInput, match="a plane stands at one x or at one y"):
        contact.stresses_on_plane([1e-4])
    with pytest.raises(wk.InvalidInput, match="a plane stands at one x or at one y"):
        contact.stresses_on_plane([1e-4], x=0.0, y=0.0)
