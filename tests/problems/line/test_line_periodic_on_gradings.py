"""Wavy bodies on gradings: full contact in closed form, another derivation, half-planes, layers, one strip, ghosts."""

from __future__ import annotations

import functools

import numpy as np
import pytest
from graded_ghost import Ghost
from scipy.interpolate import CubicSpline
from slip_of_gradings import SlippingOnGrading, compliance

import winkler as wk
from winkler.numerics.transforms.strips.strip_harmonics import far_harmonics, harmonic_rows

NU = 0.3
YOUNG = 1.0 - NU**2
"""E* = 1 of the surface under a rigid body."""
SHORTEST = 3e3


def young(contrast):
    return lambda z: YOUNG * (contrast + (1.0 - contrast) * np.exp(-z))


def graded(contrast, profile, scale=1.0):
    grading = wk.ExponentialGrading(YOUNG, contrast * YOUNG, depth_scale=scale, poisson=NU)
    return wk.LayeredLineFoundation(profile, wk.DepthGradedHalfSpace(grading))


@functools.cache
def weighted(contrast):
    """(1 + k) M over the wave number, from Riccati's equation in the depth."""
    places = np.append(0.0, np.geomspace(1e-2, SHORTEST, 60))
    found = np.array([-0.5 * compliance(young(contrast), NU, 25.0, max(one, 1e-6))[1, 1] - 1.0 for one in places])
    return CubicSpline(np.log1p(1e2 * places), (1.0 + places) * found)


def excess(contrast, k):
    """M at wave numbers; beyond `SHORTEST` it falls like 1 / k."""
    return weighted(contrast)(np.log1p(1e2 * np.minimum(k, SHORTEST))) / (1.0 + k)


def wave(pitch):
    return wk.Wavy(1e-3 * pitch, pitch)


def pressed(bed, pitch, load):
    return wk.PeriodicIndentation(bed, pitch, load).solve()


@pytest.mark.slow
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_a_wave_in_full_contact_is_one_wave_of_pressure(contrast):
    """p = mean + pi E* h / (lambda (1 + M)) cos: the grading answers each wave by itself."""
    pitch = 2.0
    one = np.pi * 1e-3 / (1.0 + excess(contrast, np.array([np.pi]))[0])
    closed = pressed(graded(contrast, wave(pitch)), pitch, wk.NominalPressure(2.0 * one))
    assert closed.closure_pressure == pytest.approx(one, rel=2e-6)
    x = pitch * np.array([0.0, 0.1, 0.37, 0.5])
    np.testing.assert_allclose(closed.pressure(x), 2.0 * one + one * np.cos(2.0 * np.pi * x / pitch), rtol=2e-6)
    assert closed.half_width == 0.5 * pitch


def by_collocation(contrast, pitch, half_width, slope, count):
    """Load of a strip, after Erdogan and Gupta, with the cotangent and the waves that the grading adds.

    Of what falls like 1 / k the sum is a straight line with a jump, which is integrated mode by mode.
    """
    unit = 2.0 * np.pi / pitch
    number = np.arange(1.0, max(2.0 * count, SHORTEST / unit))
    added = excess(contrast, unit * number)
    tail = SHORTEST * excess(contrast, np.array([SHORTEST]))[0]
    angle = np.pi * np.arange(1, count + 1) / (count + 1)
    s, shares = half_width * np.cos(angle), half_width * np.pi * np.sin(angle) ** 2 / (count + 1)
    x = half_width * np.cos(np.pi * (np.arange(1, count + 2) - 0.5) / (count + 1))
    far = x[:, None] - s
    apart = 2.0 * half_width * np.linspace(0.0, 1.0, 500) ** 2
    rest = np.sin(unit * np.outer(apart, number)) @ (unit * added - tail / number)
    smooth = CubicSpline(apart, rest - 0.5 * tail * unit * apart)
    kernel = np.pi / pitch / np.tan(np.pi * far / pitch) + np.sign(far) * smooth(np.abs(far))
    kernel += 0.5 * np.pi * tail * SlippingOnGrading.signs(x, s)
    return float(shares @ np.linalg.lstsq(kernel * shares, 0.5 * np.pi * slope(x), rcond=None)[0])


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("half_width", [0.3, 3.0, 10.0])
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_strips_by_another_derivation(contrast, half_width):
    pitch = 3.0 * half_width
    unit = 2.0 * np.pi / pitch
    found = pressed(graded(contrast, wave(pitch)), pitch, wk.HalfWidth(half_width))
    coarse, fine = (
        by_collocation(contrast, pitch, half_width, lambda x: 1e-3 * pitch * unit * np.sin(unit * x), count)
        for count in (80, 160)
    )
    assert found.force_per_length == pytest.approx(fine, rel=5e-6 + 0.4 * abs(coarse / fine - 1.0))
    back = pressed(graded(contrast, wave(pitch)), pitch, wk.LineForce(found.force_per_length))
    assert back.half_width == pytest.approx(half_width, rel=1e-9)


@pytest.mark.slow
def test_a_body_that_does_not_change_is_a_half_plane():
    plain = pressed(wk.LineFoundation(wave(2.0), wk.HalfSpace(wk.Elastic(YOUNG, NU))), 2.0, wk.HalfWidth(0.4))
    ours = pressed(graded(1.0, wave(2.0)), 2.0, wk.HalfWidth(0.4))
    for name in ("force_per_length", "peak_pressure", "closure_pressure"):
        assert getattr(ours, name) == pytest.approx(getattr(plain, name), rel=1e-10), name
    x = np.array([0.0, 0.1, 0.42, 0.8])
    np.testing.assert_allclose(ours.separation(x), plain.separation(x), atol=1e-13)


@pytest.mark.slow
def test_the_depth_is_felt_and_decides_under_a_thin_grading():
    """Ridges three times as wide as the grading is deep feel what lies below; under a thin one they feel that alone."""
    loads = [pressed(graded(one, wave(9.0)), 9.0, wk.HalfWidth(3.0)).force_per_length for one in (0.1, 0.2)]
    assert loads[0] < 0.8 * loads[1]
    deep = pressed(wk.LineFoundation(wave(2.0), wk.HalfSpace(wk.Elastic(0.1 * YOUNG, NU))), 2.0, wk.HalfWidth(0.5))
    missed = [
        pressed(graded(0.1, wave(2.0), scale), 2.0, wk.HalfWidth(0.5)).force_per_length / deep.force_per_length - 1.0
        for scale in (0.02, 0.01, 0.005)
    ]
    assert missed[2] < 0.58 * missed[1] < 0.34 * missed[0]
    assert missed[2] < 0.07


def test_sharp_ridges_are_refused():
    with pytest.raises(wk.OutsideValidity, match="give a smooth profile"):
        pressed(graded(0.1, wk.Cone(0.1)), 6.0, wk.HalfWidth(1.5))


@pytest.mark.slow
def test_ridges_of_rollers_on_many_layers():
    """Of twice as many layers the error is a fourth; narrow ridges far apart stand alone."""
    profile = wk.Paraboloid(3.0)

    def layered(count):
        edges = 14.0 * np.linspace(0.0, 1.0, count + 1) ** 2
        middles = 0.5 * (edges[1:] + edges[:-1])
        layers = [
            wk.Layer(wk.Elastic(float(young(0.1)(z)), NU), float(h))
            for z, h in zip(middles, np.diff(edges), strict=True)
        ]
        return wk.LayeredLineFoundation(profile, wk.CoatedHalfSpace(layers, wk.Elastic(0.1 * YOUNG, NU)))

    coarse, fine, ours = (
        pressed(bed, 6.0, wk.HalfWidth(1.5)).force_per_length
        for bed in (layered(24), layered(48), graded(0.1, profile))
    )
    assert ours == pytest.approx((4.0 * fine - coarse) / 3.0, rel=2e-4)
    alone = wk.LineIndentation(graded(0.1, profile), wk.HalfWidth(0.5)).solve().force_per_length
    missed = [
        pressed(graded(0.1, profile), pitch, wk.HalfWidth(0.5)).force_per_length / alone - 1.0
        for pitch in (100.0, 200.0)
    ]
    assert missed[0] / missed[1] == pytest.approx(4.0, rel=0.1)


@pytest.mark.slow
def test_a_grading_of_no_family_closes_with_the_same_numbers():
    known = graded(10.0, wave(2.0))
    ghost = wk.LayeredLineFoundation(wave(2.0), Ghost(known.medium))
    loads = [pressed(bed, 2.0, wk.HalfWidth(0.4)).force_per_length for bed in (known, ghost)]
    assert loads[0] == loads[1]


def test_stresses_inside_are_refused_and_notes_speak_of_the_grading():
    found = pressed(graded(0.1, wave(2.0)), 2.0, wk.HalfWidth(0.4))
    with pytest.raises(wk.OutsideValidity, match="layers that follow it"):
        found.stresses(0.0, 1.0)
    text = " ".join(map(str, found.validity))
    assert "graded with depth" in text
    assert "half-planes" not in text


@pytest.mark.slow
def test_sharp_valleys_are_pressed_almost_flat():
    """Ridges of a roller under a load, and how far they may be pressed."""
    bed = graded(0.1, wk.Paraboloid(3.0))
    given = pressed(bed, 6.0, wk.HalfWidth(1.5))
    back = pressed(bed, 6.0, wk.LineForce(given.force_per_length))
    assert back.half_width == pytest.approx(1.5, rel=1e-9)
    with pytest.raises(wk.OutsideValidity, match="give at most 2.85"):
        pressed(bed, 6.0, wk.HalfWidth(2.99))


def test_nothing_is_borne_where_nothing_touches():
    found = pressed(graded(0.1, wave(2.0)), 2.0, wk.HalfWidth(0.0))
    assert found.force_per_length == 0.0
    assert "do not touch" in " ".join(map(str, found.validity))


@pytest.mark.parametrize("phase", [0.2, 0.8, 1.3])
def test_the_slow_part_of_products_of_modes_is_told_far_out(phase):
    """Means over many waves of the products themselves, which are integrals over angles."""
    number = np.arange(800.0, 1000.0)
    window = np.sin(np.pi * (np.arange(number.size) + 0.5) / number.size) ** 4
    rows, (sides, _) = harmonic_rows(phase, 12, number), far_harmonics(phase, 12, number)
    whole = (rows * window) @ rows.T
    slow = sum((side * window) @ side.T for side in sides)
    np.testing.assert_allclose(slow, whole, atol=2e-3 * np.max(whole))
