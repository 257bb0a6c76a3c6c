"""The greatest stresses of a contact against closed forms of ball, ellipse and cylinder, and against fields."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar

import winkler as wk

STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))


def of_ellipse(along, across, medium=STEEL):
    return wk.ContactStress(wk.EllipticIndentation(wk.CurvedBodies(along, across), medium, wk.Force(100.0))).solve()


def rolled(over):
    """Lundberg's and Palmgren's shear stress over p0, and its depth over the axis of rolling."""
    t = brentq(lambda t: math.sqrt((t * t - 1.0) * (2.0 * t - 1.0)) - over, 1.0, 3.0 + over, xtol=1e-15)
    root = math.sqrt(2.0 * t - 1.0)
    return root / (2.0 * t * (t + 1.0)), 1.0 / ((t + 1.0) * root)


def hertz_on_axis(depth, poisson):
    """Half the difference of the principal stresses on the axis of a ball, over p0 (K. L. Johnson 1985, 3.45)."""
    axial = -1.0 / (1.0 + depth**2)
    radial = -(1.0 + poisson) * (1.0 - depth * math.atan2(1.0, depth)) + 0.5 / (1.0 + depth**2)
    return 0.5 * (radial - axial)


def test_below_a_ball():
    """0.310 p0 at 0.481 a for nu = 0.3, twice that of von Mises; 0.2139 p0 at 0.351 a along the surface."""
    for contact in (wk.Force(100.0), wk.Radius(1e-4), wk.Depth(1e-6)):
        found = wk.ContactStress(wk.Indentation(wk.Foundation(wk.Paraboloid(10e-3), STEEL), contact)).solve()
        a, p0 = found.contact.radius, found.peak_pressure
        shear, depth = found.max_shear / p0, found.max_shear_depth / a
        assert (round(shear, 3), round(depth, 3)) == (0.310, 0.481)
        assert shear == pytest.approx(hertz_on_axis(depth, 0.3), rel=1e-12)
        beside = [hertz_on_axis(depth + step, 0.3) for step in (-1e-3, 1e-3)]
        assert max(beside) < shear
        assert found.von_mises == pytest.approx(2.0 * found.max_shear, rel=1e-12)
        expected = rolled(1.0)
        for name in ("orthogonal_shear", "long_axis_shear"):
            assert getattr(found, name) / p0 == pytest.approx(expected[0], rel=1e-12)
            assert getattr(found, f"{name}_depth") / a == pytest.approx(expected[1], rel=1e-7)


@pytest.mark.parametrize("radii", [(10e-3, 1e-3), (1e-3, 10e-3), (1e-3, 1e-3), (2e-3, 1.0)])
def test_below_an_ellipse_along_both_axes(radii):
    found = of_ellipse(*radii)
    shorter, longer = sorted((found.contact.longitudinal_semi_axis, found.contact.lateral_semi_axis))
    for name, axis, over in (
        ("orthogonal_shear", shorter, shorter / longer),
        ("long_axis_shear", longer, longer / shorter),
    ):
        value, depth = rolled(over)
        assert getattr(found, name) / found.peak_pressure == pytest.approx(value, rel=1e-9)
        assert getattr(found, f"{name}_depth") == pytest.approx(depth * axis, rel=1e-6)


def test_below_a_cylinder():
    """0.30028 p0 at 0.78615 a, and p0/4 at a/2: what Johnson's (4.45) rounds; along its axis there is none."""
    bed = wk.LineFoundation(wk.Paraboloid(10e-3), STEEL)
    found = wk.ContactStress(wk.LineIndentation(bed, wk.LineForce(1e5))).solve()
    a, p0 = found.contact.half_width, found.peak_pressure
    assert found.max_shear / p0 == pytest.approx(0.30028310600078, rel=1e-12)
    assert found.max_shear_depth / a == pytest.approx(0.786151377757, rel=1e-9)
    assert found.orthogonal_shear / p0 == pytest.approx(0.25, rel=1e-12)
    assert found.orthogonal_shear_depth / a == pytest.approx(0.5, rel=1e-9)
    assert found.von_mises / p0 == pytest.approx(0.558, abs=5e-4)
    assert (found.long_axis_shear, found.long_axis_shear_depth) == (0.0, a)
    needle = of_ellipse(1e5, 1e-3)
    for name in ("max_shear", "orthogonal_shear", "von_mises"):
        ratio = getattr(needle, name) / needle.peak_pressure
        assert ratio == pytest.approx(getattr(found, name) / p0, rel=1e-3)
    depth = needle.long_axis_shear_depth / needle.contact.lateral_semi_axis
    assert depth == pytest.approx(1.0, rel=1e-2)


def test_the_shear_of_compressible_cylinders_is_the_greatest_near_the_surface():
    """Between z and y, where nu < 0.2: (1/2 - nu) p0 on the surface and a little more below (McEwen's axis)."""

    def shear(d):
        root = math.sqrt(1.0 + d * d)
        along, down = 2.0 * d - (1.0 + 2.0 * d * d) / root, -1.0 / root
        stresses = (along, 0.05 * (along + down), down)
        return 0.5 * (max(stresses) - min(stresses))

    best = minimize_scalar(lambda d: -shear(d), bounds=(0.0, 0.3), method="bounded", options={"xatol": 1e-10})
    soft = wk.HalfSpace.between(wk.Elastic(1e9, 0.05), wk.Elastic(1e9, 0.05))
    contact = wk.LineIndentation(wk.LineFoundation(wk.Paraboloid(10e-3), soft), wk.LineForce(1e3))
    found = wk.ContactStress(contact).solve()
    assert found.max_shear / found.peak_pressure == pytest.approx(-best.fun, rel=1e-12)
    assert found.max_shear_depth / found.contact.half_width == pytest.approx(best.x, rel=1e-6)
    assert -best.fun > 0.45


@pytest.mark.parametrize("profile", [wk.Sphere(1e-3), wk.PowerLaw(1e9, 4.0), wk.RoundedPunch(5e-5, 1e-3)])
def test_no_place_of_other_profiles_is_stressed_more(profile):
    contact = wk.Indentation(wk.Foundation(profile, STEEL), wk.Radius(1e-4))
    found = wk.ContactStress(contact).solve()
    r, z = np.linspace(0.0, 1.3e-4, 66)[:, None], np.linspace(0.0, 1.5e-4, 61)[1:]
    fields = wk.restore(contact.solve(), r, z)
    for name, mapped in (
        ("von_mises", fields.von_mises),
        ("max_shear", fields.max_shear),
        ("orthogonal_shear", np.abs(fields.shear_stress)),
    ):
        assert 0.98 < np.max(mapped) / getattr(found, name) <= 1.0 + 1e-9


def test_of_unlike_bodies_it_is_the_greater_one():
    """The shear stress is greater where nu is smaller; depths are negative in the second body."""
    for first, second, sign in ((0.1, 0.4, 1.0), (0.4, 0.1, -1.0)):
        medium = wk.HalfSpace(wk.Elastic(1e9, first), wk.Elastic(3e9, second))
        found = of_ellipse(2e-3, 1e-3, medium)
        alone = of_ellipse(2e-3, 1e-3, wk.HalfSpace(wk.Elastic(1e9, 0.1)))
        assert math.copysign(1.0, found.max_shear_depth) == sign
        assert found.max_shear / found.peak_pressure == pytest.approx(alone.max_shear / alone.peak_pressure, rel=1e-9)


def test_refused():
    ball = wk.Foundation(wk.Paraboloid(1e-3), STEEL)
    with pytest.raises(wk.InvalidInput, match="loads"):
        wk.ContactStress(wk.Indentation(ball, wk.Force([1.0, 2.0]))).solve()
    zinc = wk.TransverselyIsotropic(161e9, 34.2e9, 50.1e9, 61e9, 38.3e9)
    for medium in (
        wk.TransverselyIsotropicHalfSpace(zinc),
        wk.StackedHalfSpace([wk.StackLayer(zinc, 1e-6)], on=wk.Elastic(1e9, 0.3)),
    ):
        with pytest.raises(wk.InvalidInput, match="under round contacts only"):
            wk.ContactStress(wk.EllipticIndentation(wk.CurvedBodies(1e-3, 2e-3), medium, wk.Force(1.0)))
    strip = wk.LineFoundation(wk.Paraboloid(1e-3), STEEL)
    for contact in (wk.Indentation(ball, wk.Force(0.0)), wk.LineIndentation(strip, wk.LineForce(0.0))):
        with pytest.raises(wk.OutsideValidity, match="do not touch"):
            wk.ContactStress(contact).solve()
    for contact in (
        wk.Indentation(wk.Foundation(wk.Cone(1.4), STEEL), wk.Force(1.0)),
        wk.LineIndentation(wk.LineFoundation(wk.Cone(1.4), STEEL), wk.LineForce(1.0)),
    ):
        with pytest.raises(wk.OutsideValidity, match="infinite"):
            wk.ContactStress(contact).solve()


HARD, SOFT = wk.Elastic(420e9, 0.25, strength=2e9), wk.Elastic(70e9, 0.33, strength=0.4e9)
PLAIN = wk.Elastic(210e9, 0.3)
LIKE = wk.CoatedHalfSpace((wk.Layer(PLAIN, 20e-6),), PLAIN, second=PLAIN)
KINDS = ("von_mises", "max_shear", "orthogonal_shear", "long_axis_shear")


def pressed(shape, medium, load):
    """A ball, an ellipse or a cylinder."""
    if shape == "ball":
        return wk.Indentation(wk.Foundation(wk.Paraboloid(10e-3), medium), wk.Force(load))
    if shape == "ellipse":
        return wk.EllipticIndentation(wk.CurvedBodies(20e-3, 5e-3), medium, wk.Force(load))
    bed = wk.LayeredLineFoundation if isinstance(medium, wk.CoatedHalfSpace) else wk.LineFoundation
    return wk.LineIndentation(bed(wk.Paraboloid(10e-3), medium), wk.LineForce(load))


@pytest.mark.parametrize(
    ("shape", "load", "tolerance"),
    [
        pytest.param("ball", 5.0, 1e-6, marks=pytest.mark.slow),
        ("cylinder", 1e4, 1e-6),
        pytest.param("ellipse", 5.0, 0.0, marks=pytest.mark.long),
    ],
)
def test_layers_like_their_base_are_a_half_space(shape, load, tolerance):
    found, plain = (wk.ContactStress(pressed(shape, medium, load)).solve() for medium in (LIKE, STEEL))
    for kind in KINDS:
        off = max(tolerance, found.stress_error)
        assert getattr(found, kind) == pytest.approx(getattr(plain, kind), rel=off), kind
        below = [abs(getattr(one, f"{kind}_depth")) for one in (found, plain)]
        assert below[0] == pytest.approx(below[1], rel=max(1e-3, off)), kind
    assert [part.name for part in found.parts] == ["layer 1", "body under the layers", "second body"]


@pytest.mark.parametrize(
    ("shape", "tolerance", "soft_below"),
    [
        pytest.param("ball", 1e-6, True, marks=pytest.mark.slow),
        pytest.param("ball", 1e-6, False, marks=pytest.mark.long),
        pytest.param("cylinder", 1e-7, True, marks=pytest.mark.long),
        pytest.param("cylinder", 1e-7, False, marks=pytest.mark.slow),
        *(pytest.param("ellipse", 0.0, soft, marks=pytest.mark.long) for soft in (True, False)),
    ],
)
def test_at_its_onset_of_yield_each_part_bears_its_strength(shape, tolerance, soft_below):
    solids = (HARD, SOFT) if soft_below else (SOFT, HARD)
    medium = wk.CoatedHalfSpace((wk.Layer(solids[0], 20e-6),), solids[1])
    if shape == "ball":
        onsets = wk.YieldOnset(pressed(shape, medium, 1.0).bed).solve().onsets
    elif shape == "ellipse":
        onsets = wk.EllipticYieldOnset(wk.CurvedBodies(20e-3, 5e-3), medium).solve().onsets
    else:
        onsets = wk.LineYieldOnset(pressed(shape, medium, 1.0).bed).solve().onsets
    for onset in onsets:
        load = onset.force_per_length if shape == "cylinder" else onset.force
        found = wk.ContactStress(pressed(shape, medium, load)).solve()
        part = found.parts[onset.part - 1]
        off = max(tolerance, found.stress_error)
        assert part.name == onset.name
        assert part.von_mises == pytest.approx(solids[onset.part - 1].strength, rel=off)
        assert part.von_mises_depth == pytest.approx(onset.z, rel=1e-3, abs=1e-9) or off > 1e-3


@pytest.mark.slow
@pytest.mark.parametrize("shape", ["ball", "cylinder"])
def test_no_place_in_a_layer_is_stressed_more(shape):
    """The greatest stress of each part and kind against the fields of the contact on a dense grid."""
    medium = wk.StackedHalfSpace(
        (wk.StackLayer(HARD, 12e-6), wk.StackLayer(SOFT, 15e-6)), wk.Elastic(210e9, 0.3), second=PLAIN
    )
    if shape == "ball":
        contact = pressed(shape, medium, 5.0)
    else:
        bed = wk.LayeredLineFoundation(wk.Paraboloid(10e-3), medium)
        contact = wk.LineIndentation(bed, wk.LineForce(1e4))
    found = wk.ContactStress(contact).solve()
    solution, width = contact.solve(), 60e-6
    spans = [(0.0, 12e-6), (12e-6, 27e-6), (27e-6, 3.0 * width), (0.0, -2.0 * width)]
    assert len(found.parts) == len(spans)
    for part, (top, bottom) in zip(found.parts, spans, strict=True):
        x = np.linspace(0.0, 1.5 * width, 61)[:, None]
        z = top + (bottom - top) * np.linspace(1e-6, 1.0, 61)[None, :]
        if bottom < 0.0:
            z[0, 0] = -1e-12
        fields = wk.restore(solution, x, z) if shape == "ball" else solution.stresses(x, z)
        along = np.abs(fields.shear_stress if shape == "ball" else fields.xz_stress)
        for kind, level in zip(KINDS, (fields.von_mises, fields.max_shear, along), strict=False):
            assert np.max(level) <= getattr(part, kind) * (1.0 + 1e-6), (part.name, kind)
            assert np.max(level) >= getattr(part, kind) * (1.0 - 5e-3), (part.name, kind)
