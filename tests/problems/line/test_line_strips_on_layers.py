"""Sections in several strips on layers: other discretisations, line loads summed, the base, other engines as limits."""

from __future__ import annotations

import numpy as np
import pytest
from layer_waves import excesses
from strips_of_layers import Kernel

import winkler as wk
from winkler.problems.line_strips.strip_search import Pushed, _elements, _first_grid

NU = 0.3
SHEAR = 0.5 * (1.0 - NU)
"""E* = 1 of the layer under a rigid body."""
PAIR = wk.CylinderRow([50.0, 50.0], [-0.75, 0.75], [0.0, 0.0])


def solid(share=1.0, **more):
    return wk.Elastic(2.0 * SHEAR * (1.0 + NU) * share, NU, **more)


def coated(contrast, thickness):
    return wk.CoatedHalfSpace([wk.Layer(solid(), thickness)], solid(contrast))


def excess(contrast, thickness=1.0):
    return lambda k: excesses([(SHEAR, NU, thickness)], (contrast * SHEAR, NU), k)[0]


def pressed(section, medium, force, alignment=None, **more):
    return wk.LineProfileContact(section, medium, wk.LineForce(force), alignment or wk.Tilt(0.0), **more).solve()


def alone(medium, half_width, radius=50.0):
    return wk.LineIndentation(wk.LayeredLineFoundation(wk.Paraboloid(radius), medium), wk.HalfWidth(half_width)).solve()


def by_collocation(kernel, start, end, slope, count=120):
    """Load of two mirrored strips that close smoothly at both edges, after Erdogan and Gupta, and what is left over."""
    half, middle = 0.5 * (end - start), 0.5 * (end + start)
    angle = np.pi * np.arange(1, count + 1) / (count + 1)
    s, shares = middle + half * np.cos(angle), half * np.pi * np.sin(angle) ** 2 / (count + 1)
    x = middle + half * np.cos(np.pi * (np.arange(1, count + 2) - 0.5) / (count + 1))
    rows, side = (kernel(x, s) + kernel(x, -s)) * shares, 0.5 * np.pi * slope(x)
    found = np.linalg.lstsq(rows, side, rcond=None)[0]
    return 2.0 * float(shares @ found), np.max(np.abs(rows @ found - side)) / np.max(np.abs(side))


@pytest.mark.few(2)
@pytest.mark.parametrize("share", [3.0, 0.3, 10.0])
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_two_strips_by_another_discretisation(contrast, share):
    """The equations hold on the edges that were found, with the same load: waves by matrix exponentials."""
    thickness = 0.5 / share
    force = 2.0 * float(alone(coated(contrast, thickness), 0.5).force_per_length)
    found = pressed(PAIR, coated(contrast, thickness), force)
    (_, start), end = found.edges[1, 0] * np.ones(2), found.edges[1, 1]
    kernel = Kernel(excess(contrast), 2.0 * end / thickness)
    load, left = by_collocation(
        kernel, start / thickness, end / thickness, lambda x: (x - 0.75 / thickness) * thickness / 50.0
    )
    assert load * thickness == pytest.approx(force, rel=1e-9)
    assert left < 1e-9
    assert found.refined
    assert found.strip_error < 1e-11


@pytest.mark.parametrize(
    ("section", "force", "alignment"),
    [
        (wk.MirroredSection(wk.Cone(1.5), 8.0), 0.01, wk.Tilt(0.02)),
        (wk.CylinderRow([50.0, 20.0, 30.0], [-1.2, 0.0, 0.8], [0.0, 0.01, 0.0]), 0.01, wk.LineOfAction(-0.1)),
        (wk.PunchRow([-1.0, 0.2], [-0.3, 1.0], [0.0, 0.002]), 0.03, wk.Tilt(0.0)),
    ],
)
@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_gaps_are_those_of_line_loads_summed(contrast, section, force, alignment):
    """Corners, walls and a free tilt: h = f - theta x - u, u from the pressures by their own quadrature."""
    found = pressed(section, coated(contrast, 0.2), force, alignment)
    assert found.refined
    node, weight = np.polynomial.legendre.leggauss(400)
    ramp = np.pi * (node + 1.0) / 2.0
    tips = [
        place for place, _, _ in section.breaks if np.any((found.edges[:, 0] < place) & (place < found.edges[:, 1]))
    ]
    pieces = np.sort(np.concatenate([found.edges.ravel(), tips, tips])).reshape(-1, 2)
    middle, half = pieces.mean(axis=1, keepdims=True), 0.5 * np.diff(pieces)
    s = middle - half * np.cos(ramp)
    load = (found.pressure(s) * half * np.sin(ramp) * 0.5 * np.pi * weight).ravel()
    assert np.sum(load) == pytest.approx(force, rel=2e-5)  # a tip and walls are integrated as they are
    x = np.append(found.edges[0, 0], found.edges[-1, 1] if isinstance(section, wk.PunchRow) else [-3.9, 3.0, 3.8])
    x = x[np.isfinite(section.height(x))]
    kernel = Kernel(excess(contrast), 5.0 / 0.2)
    sunk = -np.log(np.abs(x[:, None] - s.ravel())) @ load
    waves = np.cos(np.subtract.outer(x, s.ravel())[..., None] * kernel.k / 0.2) - 1.0
    sunk += np.einsum("xsk,s,k->x", waves, load, kernel.weighted / kernel.k)
    apart = section.height(x) - found.tilt * x + 2.0 / np.pi * sunk
    expected = np.zeros(x.size) if isinstance(section, wk.PunchRow) else found.separation(x)
    np.testing.assert_allclose(apart - apart[0], expected - expected[0], rtol=0.0, atol=5e-6)


@pytest.mark.parametrize(
    "medium",
    [
        coated(10.0, 0.1),
        wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1.0, 0.5), 0.3)], wk.Rigid(), wk.Elastic(3.0, 0.2)),
        wk.StackedHalfSpace(
            [wk.StackLayer(wk.TransverselyIsotropic(3.0, 1.0, 0.8, 2.0, 0.6), 0.2), wk.StackLayer(solid(), 0.3, False)],
            solid(0.2),
        ),
    ],
)
def test_one_strip_is_that_of_another_engine(medium):
    """Chebyshev modes of `LineIndentation`, with a place, a load and stresses of the layers."""
    known = alone(medium, 0.5)
    found = pressed(wk.CylinderRow([50.0], [7.0], [0.0]), medium, known.force_per_length)
    np.testing.assert_allclose(found.edges, [[6.5, 7.5]], rtol=1e-11)
    x = np.array([0.1, 0.45, 0.8, 1.7])
    np.testing.assert_allclose(found.pressure(7.0 + x), known.pressure(x), rtol=0.0, atol=1e-10 * known.peak_pressure)
    np.testing.assert_allclose(found.separation(7.0 + x), known.separation(x), rtol=0.0, atol=1e-12)


@pytest.mark.slow
def test_stresses_are_those_of_a_line_contact_and_of_the_load():
    medium = wk.CoatedHalfSpace([wk.Layer(solid(), 0.3)], solid(10.0), wk.Elastic(3.0, 0.2))
    known = alone(medium, 0.5)
    found = pressed(wk.CylinderRow([50.0], [7.0], [0.0]), medium, known.force_per_length)
    x, z = np.linspace(-1.0, 1.0, 5)[:, None], np.array([0.01, 0.3, 0.5])
    for down in (z, -z):
        one, other = known.stresses(x, down, 0.3), found.stresses(7.0 + x, down, 0.3)
        for name in ("xx_stress", "yy_stress", "zz_stress", "xz_stress"):
            level = 1e-12 * known.peak_pressure
            np.testing.assert_allclose(getattr(other, name), getattr(one, name), rtol=0.0, atol=level)
    uneven = pressed(wk.CylinderRow([50.0, 30.0], [-0.7, 0.7], [0.0, 0.0]), medium, known.force_per_length)
    x = np.linspace(-30.0, 30.0, 2001)
    across = -uneven.stresses(x, np.full(x.size, 0.2)).zz_stress
    assert np.trapezoid(across, x) == pytest.approx(uneven.force_per_length, rel=1e-5)
    assert np.trapezoid(across * x, x) == pytest.approx(uneven.force_per_length * uneven.line_of_action, rel=1e-3)


@pytest.mark.slow
def test_the_base_is_felt_and_thin_layers_vanish():
    """At a / h of about three the base decides; as h vanishes the strips become those of its half-plane, as h."""
    soft, hard = (pressed(PAIR, coated(contrast, 0.2), 0.02).contact_length for contrast in (0.1, 10.0))
    assert soft > 1.3 * hard
    plain = pressed(PAIR, wk.HalfSpace(solid(2.0)), 0.01).contact_length
    missed = [pressed(PAIR, coated(2.0, h), 0.01).contact_length / plain - 1.0 for h in (0.02, 0.01)]
    assert 1.6 < missed[0] / missed[1] < 2.1
    assert abs(missed[1]) < 0.03
    equal = pressed(PAIR, coated(1.0, 0.2), 0.01)
    np.testing.assert_allclose(equal.edges, pressed(PAIR, wk.HalfSpace(solid()), 0.01).edges, rtol=1e-12)


def test_elements_come_close_to_refined_strips():
    medium = coated(0.1, 0.2)
    fine, changes = pressed(PAIR, medium, 0.01), []
    for count in (512, 2048):
        load = Pushed(medium.modulus, 0.01, 0.0, np.nan, count, medium.response)
        found = _elements(PAIR, load, _first_grid(PAIR, load))
        changes.append(abs(found.peaks[0] / fine.strip_peaks[0] - 1.0))
    assert changes[0] < 1e-2
    assert changes[1] < 0.3 * changes[0]


@pytest.mark.slow
def test_strips_on_a_grading_are_elements():
    grading = wk.DepthGradedHalfSpace(wk.ExponentialGrading(0.91, 4.55, 0.5, 0.3))
    known = alone(grading, 0.5)
    found = pressed(wk.CylinderRow([50.0], [0.0], [0.0]), grading, known.force_per_length)
    assert not found.refined
    assert abs(found.contact_length - 1.0) < found.strip_error < 0.01
    assert found.peak_pressure == pytest.approx(known.peak_pressure, rel=1e-5)
    layers = [
        wk.Layer(wk.Elastic(float(grading.grading.young_at(np.array(z))), 0.3), 0.1) for z in np.arange(25) * 0.1 + 0.05
    ]
    many = wk.CoatedHalfSpace(layers, wk.Elastic(4.55, 0.3))
    one, other = (pressed(PAIR, medium, 0.02) for medium in (grading, many))
    assert one.contact_length == pytest.approx(other.contact_length, rel=0.01)
    with pytest.raises(wk.OutsideValidity, match="CoatedHalfSpace of layers"):
        found.stresses(0.0, 1.0)


@pytest.mark.slow
def test_notes_speak_of_layers_and_yield_in_each():
    strong = wk.CoatedHalfSpace([wk.Layer(solid(), 0.2)], solid(10.0, strength=0.01))
    found = pressed(PAIR, strong, 0.02)
    text = " ".join(map(str, found.validity))
    assert "Linear elastic layers" in text
    assert "half-plane" not in text
    assert "body under the layers" in text
    note = next(note for note in found.validity if note.assumption is wk.Assumption.ELASTIC)
    x, z = np.linspace(-2.0, 2.0, 81)[:, None], np.linspace(0.2001, 1.5, 60)
    share = float(np.max(found.stresses(x, z).von_mises)) / 0.01
    assert note.standing is (wk.Standing.OUTSIDE if share >= 1.0 else wk.Standing.EXACT)
    stated = float(str(note).split("stress is ")[1].split(" of")[0])
    assert stated == pytest.approx(share, rel=5e-3)


def test_friction_on_a_sliding_layer_is_refused():
    film = wk.StackedHalfSpace([wk.StackLayer(solid(), 0.2, False)], solid())
    found = pressed(PAIR, film, 0.01)
    assert np.isfinite(found.stresses(0.0, 0.1).von_mises)
    with pytest.raises(wk.OutsideValidity, match="slide"):
        found.stresses(0.0, 0.1, 0.3)
