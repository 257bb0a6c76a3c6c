"""The greatest stresses below Hertz's ellipse and its onset of yield: known numbers, the ball, the cylinder."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq

import winkler as wk

PAIR = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))


def pressed(along, across, force=100.0, medium=PAIR):
    return wk.EllipticIndentation(wk.CurvedBodies(along, across), medium, wk.Force(force)).solve()


def of_ratio(ratio):
    """Bodies whose ellipse has this b/a: Hertz's ratio of curvatures of an ellipse, from Carlson's integrals."""
    from scipy.special import elliprd

    return pressed(1e-3 * float(elliprd(0.0, 1.0, ratio**2) / elliprd(0.0, ratio**2, 1.0)), 1e-3)


@pytest.mark.parametrize(
    ("along", "value", "depth", "digits"),
    [(1e-3, 0.310, 0.481, 3), (1e6, 0.300, 0.786, 3)],
    ids=["circle", "line"],
)
def test_greatest_shear_stress(along, value, depth, digits):
    """Johnson (3.45), (4.45): 0.310 p0 at 0.481 a below a circle, 0.300 p0 at 0.786 a below a line, nu = 0.3."""
    contact = pressed(along, 1e-3)
    place = contact.greatest_stress(measure="max_shear")
    assert round(place.value / contact.peak_pressure, digits) == value
    assert round(place.z / contact.lateral_semi_axis, digits) == depth
    assert (place.x, place.y) == (0.0, 0.0)


@pytest.mark.parametrize("ratio", [1.0, 0.7, 0.2, 0.01])
def test_orthogonal_shear(ratio):
    """Lundberg and Palmgren: tau = p0 sqrt(2 t - 1)/(2 t (t + 1)) at the depth b/((t + 1) sqrt(2 t - 1))."""
    t = brentq(lambda t: math.sqrt((t * t - 1.0) * (2.0 * t - 1.0)) - ratio, 1.0, 2.0, xtol=1e-15)
    contact = of_ratio(ratio)
    assert contact.lateral_semi_axis / contact.longitudinal_semi_axis == pytest.approx(ratio, rel=1e-9)
    place = contact.greatest_stress(measure="orthogonal_shear")
    expected = math.sqrt(2.0 * t - 1.0) / (2.0 * t * (t + 1.0))
    assert place.value / contact.peak_pressure == pytest.approx(expected, rel=1e-9)
    depth = 1.0 / ((t + 1.0) * math.sqrt(2.0 * t - 1.0))
    assert place.z / contact.lateral_semi_axis == pytest.approx(depth, rel=1e-6)


def test_orthogonal_shear_of_a_line():
    contact = pressed(1e6, 1e-3)
    place = contact.greatest_stress(measure="orthogonal_shear")
    assert place.value / contact.peak_pressure == pytest.approx(0.25, abs=1e-6)
    assert abs(place.y) / contact.lateral_semi_axis == pytest.approx(math.sqrt(0.75), abs=1e-5)
    assert place.z / contact.lateral_semi_axis == pytest.approx(0.5, abs=1e-5)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("friction", [0.1, 0.25, 0.5])
def test_sliding_circle_and_line(friction):
    """The circle slides alike in all directions, as the ball; across its long axis an endless ellipse is a cylinder."""
    circle = pressed(1e-3, 1e-3)
    found = [circle.greatest_stress(friction, angle) for angle in (0.0, 0.7, 0.5 * math.pi, -2.0)]
    values = np.array([place.value for place in found])
    on_edge = found[0].z == 0.0  # where the stress has a cusp, of the square root of rounding
    assert values == pytest.approx(values[0], rel=2e-8 if on_edge else 1e-12)
    turned = math.atan2(found[1].y, found[1].x) % math.pi
    assert turned == pytest.approx(0.7, abs=2e-4 if on_edge else 1e-5)
    opposite = math.atan2(found[3].y, found[3].x) % math.pi
    assert opposite == pytest.approx(math.pi - 2.0, abs=2e-4 if on_edge else 1e-5)
    ball = wk.Tangential(
        wk.Foundation(wk.Paraboloid(1e-3), PAIR),
        wk.Coulomb(friction),
        wk.Path([0.0, 1.0], wk.Force(100.0), wk.Shift([0.0, 1e-3])),
    ).solve()
    x, z = np.array([found[0].x]), np.array([found[0].z])
    assert float(wk.restore_body(ball.at(-1), x, 0.0, z).von_mises[0]) == pytest.approx(values[0], rel=1e-7)
    long = pressed(1e7, 1e-3)
    bed = wk.LineFoundation(wk.Paraboloid(1e-3), PAIR)
    roller = wk.LineIndentation(bed, wk.HalfWidth(long.lateral_semi_axis)).solve()
    expected, place = roller.greatest_stress(friction), long.greatest_stress(friction, 0.5 * math.pi)
    assert place.value / long.peak_pressure == pytest.approx(expected.value / roller.peak_pressure, rel=1e-5)


@pytest.mark.parametrize("along", [1e-3, 3e-3, 1.0])
def test_the_surfaces_meet(along):
    """Within the ellipse both surfaces sink by the depth less their distance before, x^2/2R_x + y^2/2R_y."""
    medium = wk.HalfSpace(wk.Elastic(210e9, 0.3), wk.Elastic(70e9, 0.1))
    contact = pressed(along, 1e-3, medium=medium)
    x = contact.longitudinal_semi_axis * np.array([0.0, 0.5, 0.9, 0.3, -1.0])
    y = contact.lateral_semi_axis * np.array([0.0, 0.7, 0.0, 0.9, 0.0])
    sunk = contact.stresses(x, y, 0.0 * x).z_displacement
    sunk = sunk + contact.stresses(x, y, np.full(x.shape, -1e-25)).z_displacement
    assert sunk == pytest.approx(contact.depth - 0.5 * x * x / along - 0.5 * y * y / 1e-3, rel=1e-9)


def test_second_body_and_refusals():
    medium = wk.HalfSpace(wk.Elastic(210e9, 0.3), wk.Elastic(70e9, 0.1))
    contact = pressed(2e-3, 1e-3, medium=medium)
    a, b = contact.longitudinal_semi_axis, contact.lateral_semi_axis
    z = -0.3 * b
    below = contact.stresses(0.5 * a, [0.0, 0.2 * a], z, 0.2, 1.0)
    alone = pressed(2e-3, 1e-3, medium=wk.HalfSpace(wk.Elastic(70e9, 0.1), wk.Elastic(210e9, 0.3)))
    assert below.z == pytest.approx(z)
    assert below.von_mises == pytest.approx(alone.stresses(0.5 * a, [0.0, 0.2 * a], -z, 0.2, 1.0).von_mises)
    assert below.von_mises != pytest.approx(contact.stresses(0.5 * a, [0.0, 0.2 * a], -z, 0.2, 1.0).von_mises)
    on_second, on_first = contact.stresses(0.0, 0.0, -0.0), contact.stresses(0.0, 0.0, 0.0)
    for fields, nu in ((on_second, 0.1), (on_first, 0.3)):  # Johnson (3.69), (3.70) at the middle
        expected = -contact.peak_pressure * np.array(
            [2 * nu + (1 - 2 * nu) * share for share in (b / (a + b), a / (a + b))]
        )
        assert [float(fields.xx_stress), float(fields.yy_stress)] == pytest.approx(expected, rel=1e-10)
    with pytest.raises(wk.InvalidInput, match="lie in both bodies"):
        contact.stresses(0.0, 0.0, [-1e-5, 1e-5])
    with pytest.raises(wk.InvalidInput, match="give one of von_mises, max_shear, orthogonal_shear, longitudinal_shear"):
        contact.greatest_stress(measure="tresca")
    for friction in (math.nan, "0.1", [0.1, 0.2]):
        with pytest.raises(wk.InvalidInput, match="finite coefficient"):
            contact.stresses(0.0, 0.0, 1e-5, friction)
    with pytest.raises(wk.InvalidInput, match="give one of"):
        contact.greatest_stress(measure=["von_mises"])
    for places in ((math.nan, 0.0, 0.0), (0.0, math.inf, 0.0), (0.0, 0.0, [1e-5, math.nan]), ("a", 0.0, 0.0)):
        with pytest.raises(wk.InvalidInput, match="EllipticSolution: [xyz] (is|holds)"):
            contact.stresses(*places)
    with pytest.raises(wk.InvalidInput, match="do not broadcast"):
        contact.stresses([0.0, 1.0], [0.0, 1.0, 2.0], 0.0)
    with pytest.raises(wk.InvalidInput, match="EllipticSolution: x holds"):
        contact.pressure(math.nan, 0.0)
    with pytest.raises(wk.OutsideValidity, match="do not touch"):
        pressed(2e-3, 1e-3, 0.0).stresses(0.0, 0.0, 1e-5)
    with pytest.raises(wk.OutsideValidity, match="rigid, layered or not isotropic.*SurfaceContact"):
        pressed(2e-3, 1e-3, medium=wk.HalfSpace(wk.Elastic(1e9, 0.3))).stresses(0.0, 0.0, -1e-5)
    many = wk.EllipticIndentation(wk.CurvedBodies(2e-3, 1e-3), PAIR, wk.Force([1.0, 100.0])).solve()
    with pytest.raises(wk.InvalidInput, match="holds 2 loads"):
        many.stresses(0.0, 0.0, 1e-5)
    one, alone = many.at(1), pressed(2e-3, 1e-3).stresses(0.0, 0.0, 1e-5)
    assert one.stresses(0.0, 0.0, 1e-5).zz_stress == pytest.approx(alone.zz_stress)
    with pytest.raises(wk.InvalidInput, match="no load 2"):
        many.at(2)


def onset(bodies, medium, *sliding):
    return wk.EllipticYieldOnset(bodies, medium, *sliding).solve()


@pytest.mark.slow
def test_onset_of_yield():
    """At the onset the greatest stress is the strength, of the body that comes first to it; on the axis by Thomas."""
    strong, weak = wk.Elastic(210e9, 0.3, 900e6), wk.Elastic(70e9, 0.33, 250e6)
    bodies = wk.CurvedBodies(8e-3, 3e-3)
    for mu, angle in ((0.0, 0.0), (0.3, 0.0), (0.3, 1.0), (0.6, 0.5 * math.pi)):
        found = onset(bodies, wk.HalfSpace(strong, weak), wk.Coulomb(mu), angle)
        line = np.linspace(-1.2, 1.2, 41)
        x, y = line * found.longitudinal_semi_axis, line * found.lateral_semi_axis
        z = np.geomspace(1e-3, 1.5, 12) * found.lateral_semi_axis
        around = found.contact.stresses(x[:, None, None], y[:, None], -z, mu, angle).von_mises
        assert np.max(around) < 250e6 * (1.0 + 1e-9)
        assert math.copysign(1.0, found.z) < 0.0
        there = found.contact.stresses(found.x, found.y, min(found.z, -1e-20), mu, angle)
        assert float(there.von_mises) == pytest.approx(250e6, rel=1e-5)
    first = onset(bodies, wk.HalfSpace(wk.Elastic(210e9, 0.3, 90e6), weak))
    assert first.z > 0.0
    steel = wk.HalfSpace.between(strong, strong)
    ball = wk.YieldOnset(wk.Foundation(wk.Paraboloid(5e-3), steel)).solve()
    round_one = onset(wk.CurvedBodies(5e-3, 5e-3), steel)
    assert round_one.force == pytest.approx(ball.force, rel=1e-9)
    assert round_one.z == pytest.approx(ball.z, rel=1e-6)
    assert round_one.depth == pytest.approx(ball.depth, rel=1e-9)
    with pytest.raises(wk.InvalidInput, match="no body has a strength"):
        onset(bodies, PAIR)
    with pytest.raises(wk.InvalidInput, match="in radians"):
        onset(bodies, steel, wk.Coulomb(0.1), math.inf)


def test_bearing_of_another_program():
    """Steel, 3.77 mm x 124 mm, strength 1.2 GPa: 766 N."""
    steel = wk.Elastic(208e9, 0.3, 1.2e9)
    found = onset(wk.CurvedBodies(3.77e-3, 124e-3), wk.HalfSpace.between(steel, steel))
    assert found.force == pytest.approx(766.0, rel=1e-3)


@pytest.mark.slow
def test_yield_note_of_a_sliding_ellipse():
    """What slides fully is judged by the stresses under friction along the direction of shear, on either side."""
    steel = wk.Elastic(210e9, 0.3, 900e6)
    medium = wk.HalfSpace.between(steel, steel)
    bodies = wk.CurvedBodies(8e-3, 3e-3)
    along = wk.EllipticFoundation(bodies, medium)
    for bed, angle in ((along, 0.0), (along.turned, 0.5 * math.pi)):
        limit = onset(bodies, medium, wk.Coulomb(0.5), angle).force
        for factor, standing in ((0.9999, wk.Standing.EXACT), (1.0001, wk.Standing.OUTSIDE)):
            path = wk.Path([0.0, 1.0], wk.Force(factor * limit), wk.Shift([0.0, 1e-3]))
            notes = wk.Tangential(bed, wk.Coulomb(0.5), path).solve().validity
            assert next(note for note in notes if note.assumption is wk.Assumption.ELASTIC).standing is standing
