"""Stresses inside layers under partial slip: half-space limit, balance of forces, full slip, both bodies, picture."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

STEEL, RIGID, MU, H = wk.Elastic(210e9, 0.3), wk.Rigid(), 0.3, 100e-6
NAMES = ("xx_stress", "yy_stress", "zz_stress", "xy_stress", "xz_stress", "yz_stress")
MOVED = ("x_displacement", "y_displacement", "z_displacement")


def coated(young, second=RIGID):
    return wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, 0.3), H)], on=STEEL, second=second)


def pushed(kind, medium, turns=(0.0, 2e-7, -1e-7, 0.0)):
    path = wk.Path(np.arange(float(len(turns))), wk.Depth(1e-6), wk.Shift(list(turns)))
    return kind(wk.Foundation(wk.Paraboloid(10e-3), medium), wk.Coulomb(MU), path).solve()


def around(radius, count=30):
    random = np.random.default_rng(5)
    return (*random.uniform(-1.5 * radius, 1.5 * radius, (2, count)), random.uniform(0.0, 2.0 * radius, count))


@pytest.mark.few(1)
@pytest.mark.parametrize("index", [1, 2, 3])
def test_layers_of_one_solid_are_a_half_space(index):
    one, two = pushed(wk.CoatedTangential, coated(210e9)), pushed(wk.Tangential, wk.HalfSpace(STEEL))
    places = around(one.radius[0])
    found, wanted = (wk.restore_body(solution.at(index), *places) for solution in (one, two))
    for name in (*NAMES, *MOVED):
        scale = np.max(np.abs(getattr(wanted, name)))
        assert getattr(found, name) == pytest.approx(getattr(wanted, name), abs=1e-11 * scale), name
    r = np.linspace(0.05, 1.9, 9) * one.radius[0]
    on, base = wk.restore(one.at(index), r), wk.restore(two.at(index), r)
    for name in ("pressure", "traction", "tangential_displacement", "slip"):
        scale = np.max(np.abs(getattr(base, name)))
        assert getattr(on, name) == pytest.approx(getattr(base, name), abs=1e-8 * scale), name


def ring(inner, outer, nodes=40):
    x, w = np.polynomial.legendre.leggauss(nodes)
    return 0.5 * (inner + outer) + 0.5 * (outer - inner) * x, 0.5 * (outer - inner) * w


ANGLES = 0.25 * np.pi * np.arange(8)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("young", "index"), [(2.1e12, 2), (21e9, 2)])
def test_a_cylinder_cut_out_of_the_stack_is_in_balance(young, index):
    """What friction drags on its top passes through its wall and its bottom; the bottom lies in the base."""
    state = pushed(wk.CoatedTangential, coated(young)).at(index)
    radius, bottom = 1.3 * state.radius, 1.4 * H
    along, across = np.cos(ANGLES), np.sin(ANGLES)
    below = 0.0
    for r, weight in (ring(0.0, 0.5 * radius), ring(0.5 * radius, radius)):
        field = wk.restore_body(state, np.outer(r, along), np.outer(r, across), bottom)
        below += 2.0 * np.pi * float(weight * r @ np.mean(field.xz_stress, axis=1))
    wall = 0.0
    for z, weight in (ring(0.0, 0.2 * H), ring(0.2 * H, H), ring(H, bottom)):
        field = wk.restore_body(state, radius * along, radius * across, z[:, None])
        wall += (
            2.0 * np.pi * radius * float(weight @ np.mean(field.xx_stress * along + field.xy_stress * across, axis=1))
        )
    assert state.shear_force + wall + below == pytest.approx(0.0, abs=2e-7 * abs(state.shear_force))
    assert abs(wall / state.shear_force) > 0.1


@pytest.mark.slow
def test_the_surface_bears_the_traction_and_the_other_body_its_opposite():
    state = pushed(wk.CoatedTangential, coated(60e9, wk.Elastic(70e9, 0.2))).at(2)
    x = np.array([-0.9, -0.3, 0.2, 0.6, 0.97, 1.4]) * state.radius
    traction = state.traction(np.abs(x))
    first, second = (wk.restore_body(state, x, 0.0, z) for z in (0.0, -1e-12 * state.radius))
    scale = np.max(np.abs(traction))
    assert first.xz_stress == pytest.approx(-traction, abs=1e-7 * scale)
    assert second.xz_stress == pytest.approx(traction, abs=1e-7 * scale)
    r = np.array([0.3, 0.8]) * state.radius
    x, y = np.outer(r, np.cos(ANGLES)), np.outer(r, np.sin(ANGLES))
    above, below = (wk.restore_body(state, x, y, z).x_displacement for z in (0.0, -1e-12 * state.radius))
    assert np.mean(above - below, axis=1) == pytest.approx(state.shift - state.slip(r), rel=1e-7)
    assert state.slip(r[:1]) == pytest.approx(0.0, abs=1e-9 * abs(state.shift))  # it sticks there


def test_where_all_slides_the_stress_is_that_of_the_pressure_dragged():
    medium = coated(600e9)
    state = pushed(wk.CoatedTangential, medium, (0.0, 1e-5)).at(1)
    assert state.stick_radius == 0.0
    x, y, z = around(state.radius)
    found = wk.restore_body(state, x, y, z)
    bed = wk.Foundation(wk.Paraboloid(10e-3), medium)
    rest = wk.Indentation(bed, wk.Depth(1e-6)).solve()
    normal = wk.restore_body(rest, x, y, z)
    dragged = medium.dragged_interior(rest.pressed, x, y, z, below=True)
    for name in (*NAMES, *MOVED):
        wanted = getattr(normal, name) + MU * getattr(dragged, name)
        assert getattr(found, name) == pytest.approx(wanted, abs=1e-6 * np.max(np.abs(wanted))), name


def test_the_traction_near_the_axis_is_that_on_it():
    state = pushed(wk.CoatedTangential, coated(2.1e12)).at(2)
    r = np.append(0.0, np.geomspace(1e-8, 1e-4, 40)) * state.radius
    assert state.traction(r) == pytest.approx(state.traction(np.zeros(1))[0], rel=1e-6)


@pytest.mark.parametrize("index", [1, 2])
def test_the_stress_on_the_axis_is_that_beside_it(index):
    """What the tables of layers leave of a slope at the axis is no apex."""
    layer = wk.Layer(wk.Elastic(420e9, 0.25), 50e-6)
    state = pushed(wk.CoatedTangential, wk.CoatedHalfSpace([layer], on=STEEL), (0.0, 3e-7, 1e-7)).at(index)
    field = wk.restore_body(state, np.array([0.0, 1e-3]) * state.radius, 0.0, 0.0)
    assert field.von_mises[0] == pytest.approx(field.von_mises[1], rel=1e-3)
    cone = wk.Indentation(wk.Foundation(wk.Cone(1.4), wk.HalfSpace(STEEL)), wk.Depth(1e-6)).solve()
    assert np.isinf(wk.restore_body(cone, 0.0, 0.0, 0.0).von_mises)


@pytest.mark.slow
def test_the_greatest_stress_and_its_picture():
    from winkler.plot import draw

    state = pushed(wk.CoatedTangential, coated(2.1e12)).at(1)
    peak = wk.peak_stress(state)
    assert peak.z == H  # the stiff layer bends: its lower face bears more than its surface at the edge behind
    assert abs(peak.x) < 0.2 * state.radius
    behind = wk.restore_body(state, *np.array([[-state.radius], [0.0], [0.0]])).von_mises
    assert peak.von_mises > 1.02 * float(behind[0])
    places = around(state.radius, 200)
    assert np.max(wk.restore_body(state, *places).von_mises) < peak.von_mises
    titles = [axes.get_title(loc="left") for axes in draw(state).axes]
    assert "stress below the surface" in titles
