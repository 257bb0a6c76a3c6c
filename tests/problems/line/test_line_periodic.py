"""Wavy half-planes against Westergaard's closed forms, and other ridges against sums over all strips by quadrature."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest

import winkler as wk

STEEL = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
MODULUS = 210e9 / 1.82
AMPLITUDE, PITCH = 1e-6, 1e-3
CLOSURE = float(mp.pi * mp.mpf(MODULUS) * mp.mpf(AMPLITUDE) / mp.mpf(PITCH))
WAVE = wk.Wavy(AMPLITUDE, PITCH)


def pressed(profile, load, medium=PAIR):
    return wk.PeriodicIndentation(wk.LineFoundation(profile, medium), PITCH, load).solve()


def test_a_wavy_half_plane_is_westergaards():
    share = np.array([0.0, 1e-8, 1e-3, 0.1, 0.5, 0.9, 0.999])
    waves = pressed(WAVE, wk.NominalPressure(CLOSURE * share))
    exact = [float(PITCH / mp.pi * mp.asin(mp.sqrt(mp.mpf(float(s))))) for s in share]
    np.testing.assert_allclose(waves.half_width, exact, rtol=1e-12)
    np.testing.assert_allclose(waves.contact_share, 2.0 * np.array(exact) / PITCH, rtol=1e-12)
    np.testing.assert_allclose(waves.peak_pressure, 2.0 * CLOSURE * np.sqrt(share), rtol=1e-12)
    assert waves.closure_pressure == pytest.approx(CLOSURE, rel=1e-14)
    for index in (2, 4, 6):
        one = waves.at(index)
        a = one.half_width
        x = a * np.array([0.0, 0.2, -0.6, 0.99])
        root = np.sqrt(np.sin(np.pi * a / PITCH) ** 2 - np.sin(np.pi * x / PITCH) ** 2)
        pressure = 2.0 * CLOSURE * np.cos(np.pi * x / PITCH) * root
        np.testing.assert_allclose(one.pressure(x), pressure, rtol=1e-12)
        np.testing.assert_allclose(one.pressure(x - 3.0 * PITCH), pressure, rtol=1e-9)
        np.testing.assert_array_equal(one.pressure(np.array([1.001 * a, 0.5 * PITCH])), 0.0)


def test_a_closed_one_bears_more_load_evenly():
    for share in (1.0, 1.3):
        closed = pressed(WAVE, wk.NominalPressure(share * CLOSURE))
        x = PITCH * np.linspace(-0.5, 1.2, 9)
        exact = CLOSURE * (share + np.cos(2.0 * np.pi * x / PITCH))
        np.testing.assert_allclose(closed.pressure(x), exact, rtol=1e-12, atol=1e-12 * CLOSURE)
        assert closed.half_width == pytest.approx(0.5 * PITCH, rel=1e-7)
        np.testing.assert_allclose(closed.separation(x), 0.0, atol=1e-18)
    assert pressed(WAVE, wk.HalfWidth(0.5 * PITCH)).nominal_pressure == pytest.approx(CLOSURE, rel=1e-14)


def test_a_little_load_is_that_of_cylinders():
    cylinder = wk.LineIndentation(
        wk.LineFoundation(wk.Paraboloid(PITCH**2 / (4.0 * np.pi**2 * AMPLITUDE)), PAIR), wk.LineForce(1.0)
    ).solve()
    assert pressed(WAVE, wk.LineForce(1.0)).half_width == pytest.approx(cylinder.half_width, rel=1e-4)


@pytest.mark.few(1)
@pytest.mark.parametrize("share", [0.2, 0.7, 1.5])
def test_several_waves_close_as_their_sum(share):
    """Two waves of one crest: beyond closure p = nominal + the sum of p* cos; the strip before obeys the integral."""
    second = wk.Wavy(0.1 * AMPLITUDE, 0.5 * PITCH)
    waves = pressed(WAVE + second, wk.NominalPressure(share * CLOSURE))
    assert waves.closure_pressure == pytest.approx(0.8 * CLOSURE, rel=1e-12)
    if share > 0.8:
        x = PITCH * np.linspace(0.0, 0.5, 7)
        phase = 2.0 * np.pi * x / PITCH
        exact = CLOSURE * (share + np.cos(phase) + 0.2 * np.cos(2.0 * phase))
        np.testing.assert_allclose(waves.pressure(x), exact, rtol=1e-11)
    else:
        obeys_the_integral(waves, lambda x: WAVE.slope(x) + second.slope(x))


def obeys_the_integral(contact, slope):
    """The slope of the surface by all strips, a principal value with cot, by the rule of Gauss and Chebyshev."""
    a, pitch = contact.half_width, contact.problem.pitch
    count = 200
    node = np.cos(np.pi * np.arange(1, count + 1) / (count + 1))
    weight = np.pi / (count + 1) * np.sin(np.pi * np.arange(1, count + 1) / (count + 1)) ** 2
    place = np.cos(np.pi * (2.0 * np.arange(1, count + 2) - 1.0) / (2.0 * (count + 1)))[::29]
    smooth = contact.pressure(a * node) / np.sqrt(1.0 - node**2)  # of sqrt(1 - t^2), t over a
    kernel = np.pi / np.tan(np.pi * a * (place[:, None] - node) / pitch) / pitch
    found = 2.0 / (np.pi * contact.problem.bed.medium.modulus) * a * (kernel @ (weight * smooth))
    np.testing.assert_allclose(found, np.sign(place) * slope(np.abs(a * place)), atol=1e-9 * np.max(np.abs(found)))
    total = a * np.sum(weight * smooth)
    assert total == pytest.approx(contact.force_per_length, rel=1e-9)


def test_ridges_of_cylinders_obey_the_integral_of_all_strips():
    for share in (0.3, 0.8):
        ridge = wk.Paraboloid(10e-3)
        contact = pressed(ridge, wk.HalfWidth(0.5 * share * PITCH))
        obeys_the_integral(contact, ridge.slope)
        again = pressed(ridge, wk.NominalPressure(contact.nominal_pressure))
        assert again.half_width == pytest.approx(contact.half_width, rel=1e-12)
    assert contact.closure_pressure == np.inf


def test_the_stresses_are_those_of_all_strips():
    """Flamant's line loads, summed over the strips: their sum is a derivative of cot and has a closed form."""
    contact = pressed(WAVE, wk.NominalPressure(0.4 * CLOSURE))
    a = contact.half_width
    angle = np.pi * (np.arange(300) + 0.5) / 300
    s = a * np.cos(angle)
    load = contact.pressure(s) * a * np.sin(angle) * np.pi / 300
    x, z = PITCH * np.array([0.05, -0.3, 0.5, 1.2]), 0.13 * PITCH
    k = np.pi / PITCH
    zeta = k * (x[:, None] + 1j * z - s)
    f = (k / np.pi / np.tan(zeta)) @ load
    slope = (-(k**2) / np.pi / np.sin(zeta) ** 2) @ load
    found = contact.stresses(x, z)
    np.testing.assert_allclose(found.zz_stress, f.imag - z * slope.real, rtol=1e-10)
    np.testing.assert_allclose(found.xx_stress, f.imag + z * slope.real, rtol=1e-10, atol=1e-10 * CLOSURE)
    np.testing.assert_allclose(found.xz_stress, -z * slope.imag, rtol=1e-10, atol=1e-10 * CLOSURE)
    deep = contact.stresses(PITCH * np.array([0.1, 0.4]), 9.0 * PITCH)
    np.testing.assert_allclose(deep.zz_stress, -0.4 * CLOSURE, rtol=1e-10)
    far = contact.stresses(x, 3.9 * PITCH)
    np.testing.assert_allclose(far.zz_stress, -0.4 * CLOSURE, rtol=1e-8)


def test_between_the_strips_the_surfaces_open_as_hertz_in_the_sine():
    contact = pressed(WAVE, wk.NominalPressure(0.3 * CLOSURE))
    a, k = contact.half_width, np.pi / PITCH
    edge = np.sin(k * a)
    x = np.array([1.1 * a, 0.4 * PITCH, 0.5 * PITCH])
    # h' = 4 pi h/pitch cos(k x) sqrt(sin(k x)^2 - edge^2)
    ratio = np.sin(k * x) / edge
    exact = 2.0 * AMPLITUDE * edge**2 * (ratio * np.sqrt(ratio**2 - 1.0) - np.arccosh(ratio))
    np.testing.assert_allclose(contact.separation(x + 2.0 * PITCH), exact, rtol=1e-10)
    assert contact.separation(0.99 * a) == 0.0


def test_notes_state_closure_yield_and_checks():
    strong = wk.HalfSpace.between(wk.Elastic(210e9, 0.3, strength=1e9), STEEL)
    yields = pressed(WAVE, wk.NominalPressure(1.9 * CLOSURE), strong)
    notes = {note.assumption: note for note in yields.validity}
    assert (
        notes[wk.Assumption.EQUILIBRIUM].statement
        == "The surfaces are in full contact; additional load adds a uniform pressure."
    )
    assert notes[wk.Assumption.ELASTIC].standing is wk.Standing.EXACT
    weak = wk.HalfSpace.between(wk.Elastic(210e9, 0.3, strength=1e7), STEEL)
    notes = {note.assumption: note for note in pressed(WAVE, wk.NominalPressure(0.1 * CLOSURE), weak).validity}
    assert notes[wk.Assumption.ELASTIC].standing is wk.Standing.OUTSIDE


def test_yield_below_ridges_is_stated_from_a_grid():
    """Narrow strips are Hertz' cylinders: von Mises 0.5575 p0 (nu = 0.3), 0.704 a deep; the grid is coarser."""
    strong = wk.HalfSpace.between(wk.Elastic(210e9, 0.3, strength=1e9), STEEL)
    ridges = pressed(wk.Paraboloid(10e-3), wk.HalfWidth(5e-6), strong)
    (note,) = (one for one in ridges.validity if one.assumption is wk.Assumption.ELASTIC)
    assert note.standing is wk.Standing.APPROXIMATE
    share = float(note.statement.split("stress is ")[1].split(" of")[0])
    assert share == pytest.approx(0.5575 * float(ridges.peak_pressure) / 1e9, rel=1e-2)


@pytest.mark.slow
def test_waves_that_close_beside_their_valleys_close_without_tension():
    """Equal p* of both: p = nominal + p* (cos + cos 2), least at cos = -1/4, so that all closes at 9/8 of p*."""
    both = WAVE + wk.Wavy(0.5 * AMPLITUDE, 0.5 * PITCH)
    for load in (wk.NominalPressure(1.2 * CLOSURE), wk.HalfWidth(0.5 * PITCH)):
        closed = pressed(both, load)
        assert closed.closure_pressure == pytest.approx(1.125 * CLOSURE, rel=1e-10)
        phase = np.linspace(0.0, np.pi, 41)
        exact = closed.nominal_pressure + CLOSURE * (np.cos(phase) + np.cos(2.0 * phase))
        np.testing.assert_allclose(closed.pressure(PITCH * phase / (2.0 * np.pi)), exact, atol=1e-9 * CLOSURE)
    for share in (0.6, 1.1):
        with pytest.raises(wk.OutsideValidity, match="more strips than crests|several strips"):
            pressed(both, wk.NominalPressure(share * CLOSURE))


@pytest.mark.slow
def test_crests_that_touch_as_soon_are_not_passed_over():
    with pytest.raises(wk.InvalidInput, match="as high at 0.0005 m as at the crest"):
        pressed(wk.Wavy(AMPLITUDE, 0.5 * PITCH), wk.NominalPressure(1.0))
    with pytest.raises(wk.InvalidInput, match="as high at 0.000333333 m as at the crest"):
        pressed(wk.Wavy(AMPLITUDE, PITCH / 3.0), wk.NominalPressure(1.0))
    with pytest.raises(wk.OutsideValidity, match="several strips"):  # not full contact with a closure below zero
        pressed(WAVE + wk.Wavy(AMPLITUDE, 0.1 * PITCH), wk.NominalPressure(0.3 * CLOSURE))


@pytest.mark.slow
def test_refusals_are_one_sentence():
    with pytest.raises(wk.InvalidInput, match="before the valley at half of the pitch"):
        pressed(wk.Sphere(0.4e-3), wk.NominalPressure(1e6))
    with pytest.raises(wk.OutsideValidity, match="more than half of the pitch"):
        pressed(WAVE, wk.HalfWidth(0.6e-3))
    with pytest.raises(wk.OutsideValidity, match=r"sharp and never close; give at most"):
        pressed(wk.Paraboloid(10e-3), wk.NominalPressure(1e12))
    with pytest.raises(wk.OutsideValidity, match="tensile"):
        pressed(WAVE, wk.LineForce(-1.0))
    with pytest.raises(wk.OutsideValidity, match="several strips|parted"):
        pressed(WAVE + wk.Wavy(0.5 * AMPLITUDE, PITCH / 5.0), wk.NominalPressure(0.3 * CLOSURE))


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("pitch", [1e-3, 1.5e-3, 2e-3])
def test_a_designed_parabola_is_a_paraboloid(pitch):
    """Two panels of f' = 50 r: valleys at a joint, between joints, and at the end of what is known."""
    designed = wk.Designed([0.0, 0.5e-3, 1e-3], [[0.0125, 0.0125], [0.0375, 0.0125]], 1e-10)
    medium = wk.HalfSpace(wk.Elastic(210e9, 0.3))
    one, other = (
        wk.PeriodicIndentation(
            wk.LineFoundation(profile, medium), pitch, wk.NominalPressure(np.array([1e6, 1e8]))
        ).solve()
        for profile in (designed, wk.Paraboloid(20e-3))
    )
    np.testing.assert_allclose(one.half_width, other.half_width, rtol=1e-10)
    np.testing.assert_allclose(one.peak_pressure, other.peak_pressure, rtol=1e-9)
    for requested in (one.at(0).pressure, one.at(0).separation, lambda x: one.at(0).stresses(x, 1e-4)):
        with pytest.raises(wk.InvalidInput, match="'left'"):
            requested("left")
