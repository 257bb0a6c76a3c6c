"""Greatest stresses below height maps on layers: the half-space, the round engine, and matrix exponentials."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import winkler as wk
from problems.layer_waves import base, crossed
from winkler.media.interior.map_field import MapField
from winkler.media.interior.periodic_map_field import PeriodicMapField
from winkler.media.layered.map_interior import MapInLayers
from winkler.problems.normal.map_yield import greatest_in_parts
from winkler.problems.normal.strong_parts import solid_parts

BASE = wk.Elastic(1.0, 0.3, strength=0.02)
RADIUS, FORCE = 1.0, 2e-3


def coated(young, thickness, poisson=0.25, second=None):
    layers = [wk.Layer(wk.Elastic(young, poisson, strength=0.05), thickness)]
    return wk.CoatedHalfSpace(layers, on=BASE) if second is None else wk.CoatedHalfSpace(layers, BASE, second)


def ball(pixels, side, shape=RADIUS):
    return wk.SampledProfile([side, side], wk.Paraboloid(shape), (pixels, pixels))


def skewed(shape=(24, 18)):
    """A load without any symmetry, with tractions along both axes."""
    x, y = (np.linspace(-1.0, 1.0, n) for n in shape)
    hill = np.maximum(1.0 - (x[:, None] - 0.2) ** 2 / 0.4 - (y + 0.1) ** 2 / 0.3, 0.0)
    parts = 1.0 + 0.5 * x[:, None], 0.5 - 0.2 * y, 0.3 * x[:, None] * y - 0.2
    return np.stack([part * hill for part in parts])


@pytest.mark.parametrize("periodic", [False, True])
@pytest.mark.parametrize("thickness", [0.05, 0.3, 2.0])
def test_equal_layers_have_the_field_of_the_half_space(thickness, periodic):
    """Closed forms of pixels in the half-space; in the base all of the field is a sum of waves."""
    loads, pixel = skewed(), (0.02, 0.03)
    layers = wk.CoatedHalfSpace([wk.Layer(BASE, thickness)], on=BASE)
    inside = MapInLayers(layers, loads, pixel, periodic=periodic)
    field = (PeriodicMapField if periodic else MapField)(loads, pixel, 0.3)
    size, unit = field.at_depth(0.06), 0.5 / BASE.shear
    places = np.random.default_rng(1).random((7, 3)) * [0.48, 0.54, 0.0]
    for z in (0.0, 0.7 * thickness, 1.0001 * thickness + 0.06, 2.0 * thickness + 0.1):
        found, expected = inside.at_depth(z), field.at_depth(z)
        # waves are those of smooth pressures, pixels are even: they differ as the square of a pixel over the depth
        assert found[:6] == pytest.approx(expected[:6], abs=4e-3 * np.max(np.abs(size[:6])))
        assert found[6:] == pytest.approx(unit * expected[6:], abs=4e-3 * unit * np.max(np.abs(size[6:])))
        places[:, 2] = z
        between, exact = inside.at_places(places), field.at_places(places)
        assert between[:6] == pytest.approx(exact[:6], abs=4e-3 * np.max(np.abs(size[:6])))
        assert between[6:] == pytest.approx(unit * exact[6:], abs=4e-3 * unit * np.max(np.abs(size[6:])))


@pytest.mark.parametrize("contrast", [0.1, pytest.param(10.0, marks=pytest.mark.slow)])
def test_a_dragged_ball_on_a_coating_by_hankel_integrals(contrast):
    """At places in the layer and in the base, off both axes: the round engine knows no pixels."""
    a = float(
        wk.Indentation(wk.Foundation(wk.Paraboloid(RADIUS), coated(contrast, 0.05)), wk.Force(FORCE)).solve().radius
    )
    for ratio in (0.3, 1.0):
        medium = coated(contrast, ratio * a)
        pressed = wk.Indentation(wk.Foundation(wk.Paraboloid(RADIUS), medium), wk.Force(FORCE)).solve().pressed
        radius, pixels = pressed.radius, 64
        pixel = 2.2 * radius / pixels
        middle = (np.arange(pixels) + 0.5) * pixel - 1.1 * radius
        r = np.hypot(middle[:, None], middle)
        pressure = np.where(r < radius, medium.pressure(pressed, np.minimum(r, (1 - 1e-9) * radius)), 0.0)
        pressure *= FORCE / (np.sum(pressure) * pixel**2)
        inside = MapInLayers(medium, np.multiply.outer([1.0, 0.4, 0.0], pressure), (pixel, pixel))
        i, j = np.array([24, 40, 45, 20]), np.array([30, 50, 35, 18])
        x, y = middle[i], middle[j]
        for depth in (0.5, 1.2):
            z = np.full(x.shape, depth * ratio * a + 0.2 * a)
            found = inside.at_depth(float(z[0]))[:, i, j]
            moved = found[6:] / float(pressed.depth)
            found = found[:6]
            pushed = medium.dragged_interior(pressed, x, y, z, below=True)
            at = wk.restore_body(
                wk.Indentation(wk.Foundation(wk.Paraboloid(RADIUS), medium), wk.Force(FORCE)).solve(), x, y, z
            )
            expected = np.stack([getattr(at, f"{part}_stress") for part in ("xx", "yy", "zz", "xy", "xz", "yz")])
            expected = expected + 0.4 * np.stack(pushed[:6])
            assert found == pytest.approx(expected, abs=5e-3 * float(np.max(pressure)))
            shifts = np.stack([getattr(at, f"{part}_displacement") for part in "xyz"]) + 0.4 * np.stack(pushed[6:])
            assert moved == pytest.approx(shifts / float(pressed.depth), abs=2e-3)


@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_a_wave_of_a_periodic_map_is_that_of_matrix_exponentials(contrast):
    """A mean pressure and one wave along x, in a layer and in its base, which keep their width."""
    h, poisson, side, n = 0.2, 0.2, 1.0, 32
    k = 2.0 * np.pi / side
    x = (np.arange(n) + 0.5) * side / n
    load = np.broadcast_to((1.0 + 0.6 * np.cos(k * x))[:, None], (n, 6))
    layers = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(contrast, poisson), h)], on=wk.Elastic(1.0, 0.3))
    inside = MapInLayers(layers, np.multiply.outer([1.0, 0.0, 0.0], load), (side / n, side / n), periodic=True)
    shear = 0.5 * contrast / (1.0 + poisson)
    scale = np.array([1.0, 1.0, shear, shear])[:, None]
    on = base((0.5 / 1.3, 0.3))
    waves = np.array([k])
    at_top = scale * (crossed(poisson, waves * h) @ (on / scale))
    amounts = np.linalg.solve(at_top[:, 2:], [[[0.0], [-1.0]]])
    z = 1.6 * h
    inner = np.array([1.0, 1.0, 0.5 / 1.3, 0.5 / 1.3])[:, None]
    state = inner * (crossed(0.3, -waves * (z - h)) @ (on / inner)) @ amounts
    u, _, t, down = state[0, :, 0]
    main = (2.0 * 0.5 / 1.3 * u + 0.3 * down) / 0.7
    found = inside.at_depth(z)[:, :, 2]
    held = -0.3 / 0.7
    assert found[2] == pytest.approx(-1.0 + 0.6 * down * np.cos(k * x), abs=1e-8)
    assert found[0] == pytest.approx(held + 0.6 * main * np.cos(k * x), abs=1e-8)
    assert found[1] == pytest.approx(held + 0.6 * 0.3 * (main + down) * np.cos(k * x), abs=1e-8)
    assert found[4] == pytest.approx(0.6 * t * np.sin(k * x), abs=1e-8)


@pytest.mark.parametrize(
    ("contrast", "ratio"),
    [
        (0.1, 1.0),
        (10.0, 0.3),
        *(pytest.param(*each, marks=pytest.mark.slow) for each in [(0.1, 0.3), (10.0, 1.0), (10.0, 3.0)]),
    ],
)
def test_a_ball_on_a_map_has_the_greatest_stresses_of_the_round_engine(contrast, ratio):
    """ContactStress of a Foundation: springs and Hankel integrals; the map has 40 pixels across its contact."""
    a = float(
        wk.Indentation(wk.Foundation(wk.Paraboloid(RADIUS), coated(contrast, 0.05)), wk.Force(FORCE)).solve().radius
    )
    medium = coated(contrast, ratio * a, second=wk.Elastic(3.0, 0.2, strength=0.1))
    known = wk.ContactStress(wk.Indentation(wk.Foundation(wk.Paraboloid(RADIUS), medium), wk.Force(FORCE))).solve()
    contact = wk.SurfaceContact(ball(96, 5.0 * a), medium, wk.Force(FORCE)).solve()
    parts = solid_parts(medium)
    spots = greatest_in_parts(contact.surface_load, medium, parts)
    assert [part.name for part in parts] == [row.name for row in known.parts]
    for spot, row in zip(spots, known.parts, strict=True):
        assert spot.value == pytest.approx(row.von_mises, rel=0.015)
        assert spot.z == pytest.approx(abs(row.von_mises_depth), abs=0.06 * a)
    greatest = max(spots[:2], key=lambda spot: spot.value)
    assert contact.greatest_stress() == greatest
    shares = [row.von_mises / part.solid.strength for row, part in zip(known.parts, parts, strict=True)]
    worst = int(np.argmax(shares))
    (note,) = [each for each in contact.validity if each.assumption is wk.Assumption.ELASTIC]
    assert f"strength of the {parts[worst].name}" in note.statement
    assert (note.standing is wk.Standing.OUTSIDE) == (shares[worst] >= 1.0)


def test_a_map_is_mirrored_and_turned_with_its_load():
    medium, load = coated(4.0, 0.1), wk.SurfaceLoad(skewed()[0], [0.48, 0.54], *skewed()[1:])
    parts = solid_parts(medium)[:2]
    for spot, mirrored, turned in zip(
        greatest_in_parts(load, medium, parts),
        greatest_in_parts(
            dataclasses.replace(
                load, pressure=load.pressure[::-1], x_traction=-load.x_traction[::-1], y_traction=load.y_traction[::-1]
            ),
            medium,
            parts,
        ),
        greatest_in_parts(load.turned(), medium, parts),
        strict=True,
    ):
        assert mirrored == pytest.approx((spot.value, 0.48 - spot.x, spot.y, spot.z), rel=1e-6)
        assert turned == pytest.approx((spot.value, spot.y, spot.x, spot.z), rel=1e-6)


def test_the_load_of_yield_on_a_coating_is_that_of_the_round_engine():
    """The uncoated limit is met as well: p0 = 1.60 Y for nu = 0.3."""
    medium = coated(5.0, 0.08)
    onset = wk.YieldOnset(wk.Foundation(wk.Paraboloid(RADIUS), medium)).solve()
    contact = wk.SurfaceContact(ball(96, 5.0 * float(onset.radius)), medium, wk.Force(0.8 * float(onset.force))).solve()
    assert contact.yield_force() == pytest.approx(float(onset.force), rel=0.03)


@pytest.mark.parametrize("contrast", [0.1, pytest.param(10.0, marks=pytest.mark.slow)])
def test_stresses_at_places_below_a_map_on_a_coating_are_those_of_the_round_engine(contrast):
    """Stresses over the greatest pressure and displacements over the depth: in the layer, the base and the ball."""
    a = float(
        wk.Indentation(wk.Foundation(wk.Paraboloid(RADIUS), coated(contrast, 0.05)), wk.Force(FORCE)).solve().radius
    )
    medium, side = coated(contrast, 0.6 * a, second=wk.Elastic(3.0, 0.2)), 5.0 * a
    round_one = wk.Indentation(wk.Foundation(wk.Paraboloid(RADIUS), medium), wk.Force(FORCE)).solve()
    contact = wk.SurfaceContact(ball(96, side), medium, wk.Force(FORCE)).solve()
    x, y = np.random.default_rng(3).uniform(-0.9 * a, 0.9 * a, (2, 6))
    for z in (0.2 * a, 0.9 * a, -0.4 * a):
        found = contact.stresses(x + 0.5 * side, y + 0.5 * side, np.full(6, z))
        known = wk.restore_body(round_one, x, y, np.full(6, z))
        for part in ("xx", "yy", "zz", "xy", "xz", "yz"):
            expected = getattr(known, f"{part}_stress")
            assert getattr(found, f"{part}_stress") == pytest.approx(expected, abs=1e-3 * round_one.peak_pressure)
        for part in "xyz":
            expected = getattr(known, f"{part}_displacement")
            assert getattr(found, f"{part}_displacement") == pytest.approx(expected, abs=1e-3 * round_one.depth)


def test_planes_and_depths_in_layers_have_the_fields_of_their_places():
    medium, side, depths = coated(4.0, 0.1), 0.6, np.array([0.05, 0.2])
    contact = wk.SurfaceContact(ball(24, side, 2.0), medium, wk.Force(FORCE)).solve()
    at_y, at_x = contact.stresses_on_plane(depths, y=0.31), contact.stresses_on_plane(depths, x=0.31)
    places = contact.surface_load.places[0]
    known = contact.stresses(places[:, None], np.full((24, 2), 0.31), np.broadcast_to(depths, (24, 2)))
    assert at_y.xz_stress == pytest.approx(known.xz_stress, abs=1e-12)
    assert at_y.z_displacement == pytest.approx(known.z_displacement, abs=1e-12)
    known = contact.stresses(np.full((24, 2), 0.31), places[:, None], np.broadcast_to(depths, (24, 2)))
    assert at_x.yz_stress == pytest.approx(known.yz_stress, abs=1e-12)
    assert at_x.xy_stress == pytest.approx(known.xy_stress, abs=1e-12)
    flat = contact.stresses_at_depth(0.2)
    below = contact.stresses(flat.x, flat.y, flat.z)
    assert flat.von_mises == pytest.approx(below.von_mises, rel=1e-9)
    with pytest.raises(wk.OutsideValidity, match="beside the map of pressures"):
        contact.stresses(side + 0.1, 0.0, 0.05)
