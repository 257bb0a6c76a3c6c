"""Sections that touch in many strips: closed forms, superposed line loads, elements and refined strips, refusals."""

from __future__ import annotations

import dataclasses

import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import quad

import winkler as wk
from winkler.problems.line_strips.strip_search import Pushed, _elements, _first_grid

UNIT = wk.HalfSpace(wk.Elastic(1.0, 0.0))  # E* = 1
STEEL = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
ROUGH = wk.FormulaSection(
    "h*cos(2*pi*x/l) + 0.6*h*cos(3.4*pi*x/l) + 0.3*h*sin(9*x/l) + 0.2*h*sin(17*x/l) + (x - L/2)**2/(2*R)",
    1e-2, h=1e-6, l=1e-3, L=1e-2, R=1.0,
)  # fmt: skip


def pressed(section, force, alignment=None, medium=UNIT, **more):
    """Return the solution of one load."""
    return wk.LineProfileContact(section, medium, wk.LineForce(force), alignment or wk.Tilt(0.0), **more).solve()


def row(*places, radius=1.0):
    """Return equal cylinders."""
    return wk.CylinderRow(len(places) * [radius], list(places), len(places) * [0.0])


@pytest.mark.parametrize("force", [1e-9, 1e-2, 10.0])
def test_one_cylinder_is_that_of_hertz(force):
    found = pressed(row(0.3), force)
    a = 2.0 * np.sqrt(force / np.pi)
    assert found.refined
    np.testing.assert_allclose(found.edges, [[0.3 - a, 0.3 + a]], rtol=0.0, atol=1e-12 * max(a, 0.3))
    assert found.peak_pressure == pytest.approx(np.sqrt(force / np.pi), rel=1e-12)
    found = pressed(row(0.0), force)
    x = a * np.linspace(-2.0, 2.0, 40)
    hertz = np.sqrt(force / np.pi) * np.sqrt(np.maximum(1.0 - (x / a) ** 2, 0.0))
    np.testing.assert_allclose(found.pressure(x), hertz, rtol=0.0, atol=1e-12 * found.peak_pressure)


def test_stresses_of_one_cylinder_are_those_of_a_line_contact():
    known = wk.LineIndentation(wk.LineFoundation(wk.Paraboloid(1e-2), PAIR), wk.LineForce(1e5)).solve()
    found = pressed(row(0.0, radius=1e-2), 1e5, medium=PAIR)
    x, z = np.linspace(-2e-4, 2e-4, 9)[:, None], np.array([0.0, 1e-6, 5e-5, 3e-4])
    for sign in (1.0, -1.0):
        one, other = known.stresses(x, sign * z[1:], 0.3), found.stresses(x, sign * z[1:], 0.3)
        for name in ("xx_stress", "yy_stress", "zz_stress", "xz_stress"):
            level = known.peak_pressure
            np.testing.assert_allclose(getattr(other, name), getattr(one, name), rtol=0.0, atol=1e-12 * level)
    surface = found.stresses(x[:, 0], np.zeros(9), 0.3)
    np.testing.assert_allclose(surface.zz_stress, -found.pressure(x[:, 0]), rtol=0.0, atol=1e-9 * known.peak_pressure)
    np.testing.assert_allclose(found.separation(x), known.separation(x), rtol=0.0, atol=1e-13 * 1e-6)


@pytest.mark.parametrize("force", [0.01, 0.1, 0.2])
def test_two_cylinders_have_the_edges_of_elliptic_integrals(force):
    c = mp.mpf("0.5")

    def outer(m):
        return 2 * c * mp.ellipk(m) / mp.pi

    def load(m):
        return mp.pi / 4 * outer(m) ** 2 * (2 - m) - c * outer(m) * mp.ellipe(m)

    m = mp.findroot(lambda m: load(m) - force, (mp.mpf("0.01"), mp.mpf("0.99")), solver="anderson")
    b = float(outer(m))
    a = float(outer(m) * mp.sqrt(1 - m))
    found = pressed(row(-0.5, 0.5), force)
    np.testing.assert_allclose(found.edges, [[-b, -a], [a, b]], rtol=1e-12)
    np.testing.assert_allclose(found.strip_forces, 0.5 * force, rtol=1e-12)
    x = 0.5 * (a + b)
    expected = x / np.pi * np.sqrt((x * x - a * a) * (b * b - x * x)) * _finite_part(x, a, b)
    assert found.pressure(np.array([x]))[0] == pytest.approx(expected, rel=1e-9)


def _finite_part(x, a, b, c=0.5):
    """Minus the integral of f'(s) = s - c over s (s^2 - x^2) sqrt, with v = s^2; that of a constant vanishes."""

    def smooth(t):
        s = np.sqrt(0.5 * (a * a + b * b) - 0.5 * (b * b - a * a) * np.cos(t))
        return -c / (s * x * (s + x)) if s != x else -c / (2.0 * x**3)

    return -quad(smooth, 0.0, np.pi, epsabs=1e-14)[0] / 2.0


@pytest.mark.parametrize("tilt", [0.0, 0.05, -0.12])
def test_a_tilted_wedge_has_its_closed_form(tilt):
    s = 1.0 / np.tan(1.4)
    angle = np.pi * (s + tilt) / (2.0 * s)
    half = 0.01 / (s * np.sin(angle))
    found = pressed(wk.MirroredSection(wk.Cone(1.4), 2.0), 0.01, wk.Tilt(tilt))
    middle = -half * np.cos(angle)
    np.testing.assert_allclose(found.edges[0], [middle - half, middle + half], rtol=1e-11)
    assert found.peak_pressure == np.inf
    theta = np.linspace(0.1, 3.0, 7)
    expected = s / np.pi * np.log(np.abs(np.sin(0.5 * (theta + angle)) / np.sin(0.5 * (theta - angle))))
    np.testing.assert_allclose(found.pressure(middle + half * np.cos(theta)), expected, rtol=1e-10)


def test_rounded_edges_are_those_of_a_line_contact():
    shape = wk.RoundedPunch(0.1, 1.0)
    known = wk.LineIndentation(wk.LineFoundation(shape, UNIT), wk.LineForce(0.02)).solve()
    found = pressed(wk.MirroredSection(shape, 2.0), 0.02)
    assert 0.5 * found.contact_length == pytest.approx(known.half_width, rel=1e-8)
    x = known.half_width * np.array([0.1, 0.7, 0.95])
    np.testing.assert_allclose(found.pressure(x), known.pressure(x), rtol=1e-7)


@pytest.mark.parametrize("drop", [0.0, 0.01])
def test_two_punches_share_the_load_by_elliptic_integrals(drop):
    a, b, force = 0.3, 1.0, 0.05
    found = pressed(wk.PunchRow([-b, a], [-a, b], [0.0, drop]), force)
    lean = drop * b / (4.0 * float(mp.ellipk((a / b) ** 2)))  # p = (P |x|/pi -+ lean)/sqrt(...), E* = 1
    x = np.array([0.35, 0.6, 0.9])
    root = np.sqrt((x**2 - a**2) * (b**2 - x**2))
    np.testing.assert_allclose(found.pressure(x), (force * x / np.pi - lean) / root, rtol=1e-12)
    np.testing.assert_allclose(found.pressure(-x), (force * x / np.pi + lean) / root, rtol=1e-12)
    assert found.peak_pressure == np.inf


def test_a_tilted_punch_lifts_one_edge():
    half, force, tilt = 0.5, 0.01, 0.05
    found = pressed(wk.PunchRow([-half], [half], [0.0]), force, wk.Tilt(tilt))
    assert found.edges[0, 1] == half  # p = (E* tilt/2) sqrt((x - l)/(b - x)), its sum E* tilt pi (b - l)/4
    assert found.contact_length == pytest.approx(4.0 * force / (np.pi * tilt), rel=1e-11)
    x = half - found.contact_length * np.array([0.2, 0.5, 0.9])
    level = 0.5 * tilt * np.sqrt((x - found.edges[0, 0]) / (half - x))
    np.testing.assert_allclose(found.pressure(x), level, rtol=1e-10)


@pytest.mark.slow
def test_the_middle_of_many_waves_is_westergaards():
    pitch, height = 0.1, 1e-3
    found = pressed(wk.MirroredSection(wk.Wavy(height, pitch), 2.05), 3e-3)
    middle = len(found.edges) // 2
    nominal, half = found.strip_forces[middle] / pitch, 0.5 * np.diff(found.edges)[middle, 0]
    assert len(found.edges) == 21
    assert nominal == pytest.approx(np.pi * height / pitch * np.sin(np.pi * half / pitch) ** 2, rel=1e-4)


@pytest.mark.few(1)
@pytest.mark.parametrize("force", [1e-6, 3e-6])
def test_refined_strips_are_those_of_line_loads_summed(force):
    found = pressed(ROUGH, force)
    assert found.refined
    assert found.strip_count == {1e-6: 2, 3e-6: 8}[force]
    assert found.strip_error < 1e-11
    node, weight = np.polynomial.legendre.leggauss(120)
    angle = 0.5 * np.pi * (node + 1.0)
    half, middle = 0.5 * np.diff(found.edges), found.edges.mean(axis=1, keepdims=True)
    s = middle - half * np.cos(angle)
    load = found.pressure(s) * half * np.sin(angle) * 0.5 * np.pi * weight
    assert load.sum() == pytest.approx(force, rel=1e-10)
    x = np.array([3.2e-3, 3.9e-3, 5.5e-3, 6.1e-3])
    x = x[found.pressure(x) == 0.0]
    place = np.append(x, found.edges[0, 0])
    sunk = -2.0 / np.pi * np.sum(load * np.log(np.abs(place[:, None, None] - s)), axis=(1, 2))
    apart = ROUGH.height(place) + sunk
    np.testing.assert_allclose(found.separation(x), apart[:-1] - apart[-1], rtol=0.0, atol=1e-5 * 1e-6)


@pytest.mark.slow
def test_elements_come_close_to_refined_strips():
    found = pressed(ROUGH, 3e-6)
    changes = []
    for count in (2048, 8192):
        load = Pushed(1.0, 3e-6, 0.0, np.nan, count)
        coarse = _elements(ROUGH, load, _first_grid(ROUGH, load))
        assert len(coarse.edges) == 8
        assert np.sum(coarse.forces) == pytest.approx(3e-6, rel=1e-12)
        changes.append(np.max(np.abs(coarse.forces - found.strip_forces)) / 3e-6)
    assert changes[0] < 1e-2
    assert changes[1] < 0.25 * changes[0]


def test_a_force_off_the_middle_tilts_the_body():
    found = pressed(row(-0.5, 0.5), 0.1, wk.LineOfAction(0.1))
    assert found.line_of_action == pytest.approx(0.1, rel=1e-12)
    assert found.tilt > 0.0
    again = pressed(row(-0.5, 0.5), 0.1, wk.Tilt(found.tilt))
    np.testing.assert_allclose(again.edges, found.edges, rtol=1e-10)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("place", [0.2, 0.45, 0.71])
def test_a_free_cylinder_rolls_to_the_force(place):
    """x - m = theta R: however narrow the contact is, it moves along under the force."""
    cylinder = wk.FormulaSection("(x - m)**2/(2*R) + h*cos(2*pi*x/l)", 1.0, h=1e-9, l=0.5, m=0.5, R=10.0, cut_off=True)
    found = pressed(cylinder, 1e-10, wk.LineOfAction(place))
    assert found.line_of_action == pytest.approx(place, rel=1e-12)
    assert found.refined
    bent = 1e-9 * (4.0 * np.pi) * np.sin(4.0 * np.pi * place)
    assert found.tilt == pytest.approx((place - 0.5) / 10.0 - bent, rel=1e-6)


def test_a_force_beside_the_cylinders_is_refused():
    """A cylinder of the radius 1 at 0.5 ends at 1.5."""
    assert pressed(row(-0.5, 0.5), 1e-3, wk.LineOfAction(1.4)).tilt == pytest.approx(0.9, rel=1e-6)
    with pytest.raises(wk.InvalidInput, match="between -1.5 m and 1.5 m"):
        pressed(row(-0.5, 0.5), 1e-3, wk.LineOfAction(50.0))


@pytest.mark.slow
def test_measured_points_come_close_to_the_formula():
    x = np.linspace(0.0, 1e-2, 4001)
    lines, curved = (
        pressed(wk.MeasuredSection(x, ROUGH.height(x), curved=curved), 3e-6, elements=8192) for curved in (False, True)
    )
    exact = pressed(ROUGH, 3e-6)
    assert not lines.refined
    np.testing.assert_allclose(lines.strip_forces, exact.strip_forces, rtol=0.0, atol=0.01 * 3e-6)
    np.testing.assert_allclose(curved.strip_forces, exact.strip_forces, rtol=0.0, atol=0.003 * 3e-6)
    assert curved.peak_pressure == pytest.approx(exact.peak_pressure, rel=2e-3)
    assert lines.strip_error > 0.0
    x = np.linspace(*exact.edges[2], 5)
    z = 0.5e-3 * np.ones(5)
    level = exact.peak_pressure
    np.testing.assert_allclose(
        lines.stresses(x, z).von_mises, exact.stresses(x, z).von_mises, rtol=0.0, atol=2e-3 * level
    )


def test_units_do_not_change_digits():
    one = pressed(row(-0.5, 0.5), 0.1)
    other = pressed(row(-0.5e-6, 0.5e-6, radius=1e-6), 0.1e-6 * PAIR.modulus, medium=PAIR)
    np.testing.assert_allclose(other.edges, 1e-6 * one.edges, rtol=1e-12)


def test_loads_of_an_array_are_those_of_each():
    loads = np.array([[0.0, 0.01], [0.1, 0.2]])
    found = pressed(row(-0.5, 0.5), loads)
    assert found.contact_length.shape == loads.shape
    assert found.at((1, 0)).edges.tolist() == pressed(row(-0.5, 0.5), 0.1).edges.tolist()
    nothing = found.at((0, 0))
    assert (nothing.strip_count, nothing.peak_pressure, nothing.edges.shape) == (0.0, 0.0, (0, 2))
    assert nothing.pressure([0.0]).tolist() == [0.0]
    assert found.mean_pressure[0, 0] == 0.0


def test_what_is_not_known_is_refused():
    two = row(-0.5, 0.5)
    with pytest.raises(wk.OutsideValidity, match="tensile"):
        pressed(two, -1.0)
    with pytest.raises(wk.OutsideValidity, match="reaches the end of the section"):
        pressed(ROUGH, 3e-4)
    found = pressed(two, 0.1)
    with pytest.raises(wk.InvalidInput, match="pressure: x"):
        found.pressure("left")
    with pytest.raises(wk.InvalidInput, match="do not broadcast"):
        found.stresses([0.0, 1.0], [1.0, 2.0, 3.0])
    with pytest.raises(wk.InvalidInput, match="coefficient"):
        found.stresses(0.0, 1.0, [0.1])
    with pytest.raises(wk.InvalidInput, match="coefficient"):
        found.stresses(0.0, 1.0, "rough")
    with pytest.raises(wk.OutsideValidity, match="no surface"):
        pressed(wk.PunchRow([-1.0], [1.0], [0.0]), 0.1).separation(2.0)
    with pytest.raises(wk.InvalidInput, match="holds 2 loads"):
        pressed(two, np.array([0.1, 0.2])).pressure(0.0)
    with pytest.raises(wk.OutsideValidity, match="press harder"):
        pressed(two, 0.0).stresses(0.0, 1.0)


@pytest.mark.parametrize(
    ("made", "sentence"),
    [
        (lambda: wk.CylinderRow([1.0], [0.0, 1.0], [0.0]), "one of each"),
        (lambda: wk.CylinderRow([1.0, 1.0], [1.0, 0.0], [0.0, 0.0]), "ascending"),
        (lambda: wk.PunchRow([0.0, 0.5], [1.0, 2.0], [0.0, 0.0]), "ascending"),
        (lambda: wk.MirroredSection(wk.FlatPunch(1.0), 3.0), "ends at 1 m"),
        (lambda: wk.MeasuredSection(np.arange(5.0), np.arange(5.0)), "from 16"),
        (lambda: wk.MeasuredSection(np.zeros(20), np.zeros(20)), "ascending"),
        (lambda: wk.FormulaSection("log(x)", 1.0), "not finite at x = 0 m"),
        (lambda: wk.FormulaSection("x", 1.0, corners=[2.0]), "between 0 and the width"),
        (lambda: wk.FormulaSection("y", 1.0), "unknown"),
    ],
)
def test_a_section_that_is_none_is_refused(made, sentence):
    with pytest.raises(wk.InvalidInput, match=sentence):
        made()


def test_a_formula_with_a_stated_corner_is_refined():
    bent = wk.FormulaSection("s*sqrt((x - m)**2) + (x - m)**2/(2*R)", 1.0, corners=[0.5], s=0.01, m=0.5, R=1.0)
    known = wk.LineFoundation(wk.Cone(float(np.arctan2(1.0, 0.01))) + wk.Paraboloid(1.0), UNIT)
    found = pressed(bent, 0.01)
    assert found.refined
    exact = wk.LineIndentation(known, wk.LineForce(0.01)).solve()
    assert 0.5 * found.contact_length == pytest.approx(exact.half_width, rel=1e-9)


def test_validity_states_yield_and_resolution():
    strong = wk.HalfSpace(wk.Elastic(210e9, 0.3, strength=100e6))
    notes = pressed(row(-0.25e-3, 0.25e-3, radius=1e-2), 2e5, medium=strong).validity
    standing = {note.assumption: note.standing for note in notes}
    assert standing[wk.Assumption.ELASTIC] is wk.Standing.OUTSIDE
    assert standing[wk.Assumption.RESOLUTION] is wk.Standing.EXACT
    coarse = wk.MeasuredSection(np.linspace(-1.0, 1.0, 33), 0.5 * np.linspace(-1.0, 1.0, 33) ** 2)
    notes = pressed(coarse, 0.01).validity
    assert wk.Standing.OUTSIDE in {note.standing for note in notes if note.assumption is wk.Assumption.RESOLUTION}


def test_a_read_trace_is_the_section(tmp_path):
    x = np.linspace(-1.0, 1.0, 41)
    path = tmp_path / "trace.csv"
    path.write_text("place [mm],height [um]\n" + "\n".join(f"{a:.6f},{-b:.9f}" for a, b in zip(x, x**2, strict=True)))
    read = wk.read_section(path, peak=True, cut_off=True)
    assert read == wk.MeasuredSection(read.places, read.heights, cut_off=True)
    np.testing.assert_allclose(read.heights, 1e-6 * x**2, rtol=0.0, atol=1e-14)
    assert dataclasses.replace(read, cut_off=False).pads == ()


def test_cylinders_whose_valley_almost_closes_stay_apart():
    row_of_three = wk.CylinderRow([1.0, 2.0, 1.0], [-1.0, 0.0, 0.8], [0.0, 0.0, 0.0])
    found = pressed(row_of_three, 0.6)
    assert (found.strip_count, found.refined) == (3.0, True)
    assert found.strip_error < 1e-8
    gap = found.edges[1:, 0] - found.edges[:-1, 1]
    assert np.all(gap > 0.0)
    valleys = [place for place, jump, _ in row_of_three.breaks if -1.0 < place < 0.8]
    assert np.all((found.edges[:-1, 1] < valleys) & (valleys < found.edges[1:, 0]))


def test_a_force_beyond_the_body_is_refused():
    with pytest.raises(wk.InvalidInput, match="tip the section over"):
        pressed(wk.PunchRow([-1.0], [1.0], [0.0]), 0.1, wk.LineOfAction(1.5))


def test_a_smooth_crest_is_no_tip():
    """Beside the middle the slope of a wave is a number next to zero, and not zero."""
    assert wk.MirroredSection(wk.Wavy(1e-6, 1e-3), 4.5e-3).breaks == ()
    assert len(wk.MirroredSection(wk.Cone(1.5), 4.5e-3).breaks) == 1
