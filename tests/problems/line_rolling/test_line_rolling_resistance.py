"""Cylinders on bodies that relax against their integral equation, Fourier integrals, Hertz's limits and CONTACT."""

from __future__ import annotations

import tomllib

import numpy as np
import pytest
from scipy.special import expi, ive, kve

import winkler as wk
from winkler.numerics.transforms.passing_strip import first_tail

SOLID = wk.Prony(1e6, [2e6, 5e6, 1e6, 20e6], [1e-4, 1e-3, 4e-3, 0.1])
BED = wk.LineFoundation(wk.Paraboloid(0.1), wk.ViscoelasticHalfSpace(SOLID))
CREEP = BED.medium.creep


def rolled(load, speed, bed=BED):
    return wk.LineRollingResistance(bed, load, speed).solve()


def clustered(low, high, count=240):
    """Places and weights that crowd at both ends, for roots and logarithms there."""
    node, weight = np.polynomial.legendre.leggauss(count)
    u, w = 0.5 * (node + 1.0), 0.5 * weight
    place = u**4 * (35.0 - 84.0 * u + 70.0 * u**2 - 20.0 * u**3)
    return low + (high - low) * place, (high - low) * w * 140.0 * (u * (1.0 - u)) ** 3


def scaled_exponential_integral(y):
    """exp(y) E_1(y), its principal value for y < 0; by 12 terms of its asymptotic series where these have 12 digits."""
    far = np.abs(y) > 60.0
    near = np.where(far, 1.0, y)
    series, term = np.zeros(y.shape), 1.0 / np.where(far, y, 60.0)
    for m in range(12):
        series += term
        term = -(m + 1) * term / np.where(far, y, 60.0)
    return np.where(far, series, -np.exp(near) * expi(-near))


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("speed", [1e-3, 0.3, 5.0, 300.0])
def test_the_pressure_solves_the_integral_equation(speed):
    """2 int p(s) [C_0/(x - s) + sum C_k/(v lambda_k) exp(y) E_1(y)] ds / pi = x/R, y = (x - s)/(v lambda_k)."""
    one = rolled(wk.HalfWidth(1e-3), speed)
    first, last = one.trailing_edge, one.leading_edge
    n = 3000
    angle = np.pi * np.arange(1, n + 1) / (n + 1)
    places = 0.5 * (first + last) + 1e-3 * np.cos(angle)
    weight = np.pi / (n + 1) * np.sin(angle) * 1e-3 * one.pressure(places)
    for k in (10, 700, 1500, 2400, 2990):
        x = 0.5 * (first + last) + 1e-3 * np.cos(np.pi * (2 * k - 1) / (2 * n + 2))
        slope = CREEP.glassy * np.sum(weight / (x - places))
        for compliance, time in zip(CREEP.compliances, CREEP.times, strict=True):
            for low, high in ((first, x), (x, last)):
                s, w = clustered(low, high)
                s, w = s[s != x], w[s != x]
                y = (x - s) / (speed * time)
                kernel = scaled_exponential_integral(y)
                slope += compliance / (speed * time) * (w @ (kernel * one.pressure(s)))
        assert 2.0 / np.pi * slope == pytest.approx(x / 0.1, abs=1e-9 * 1e-3 / 0.1), (speed, k)


def test_force_and_resistance_are_integrals_of_the_pressure():
    one = rolled(wk.LineForce(300.0), 0.3)
    s, w = clustered(one.trailing_edge, one.leading_edge)
    pressure = one.pressure(s)
    assert w @ pressure == pytest.approx(300.0, rel=1e-12)
    assert w @ (pressure * s) / 0.1 == pytest.approx(one.shear_force_per_length, rel=1e-11)
    assert one.coefficient == pytest.approx(one.shear_force_per_length / 300.0, rel=1e-14)
    assert np.max(pressure) < one.peak_pressure < 1.001 * np.max(pressure)
    assert not one.pressure(np.array([1.01 * one.trailing_edge, 1.01 * one.leading_edge])).any()


def test_the_resistance_is_what_all_waves_lose():
    """Q = (2/pi) int |p(k)|^2 Im C(k v) dk over the wave numbers k, with the transform p(k) of the pressure."""
    one = rolled(wk.HalfWidth(1e-3), 0.3)
    s, w = clustered(one.trailing_edge, one.leading_edge, 1200)
    borne = w * one.pressure(s)
    edges = np.concatenate([[0.0], np.geomspace(1.0, 4e5, 60)])
    node, weight = np.polynomial.legendre.leggauss(24)
    waves = (0.5 * (edges[:-1, None] + edges[1:, None]) + 0.5 * np.diff(edges)[:, None] * node).ravel()
    sizes = (0.5 * np.diff(edges)[:, None] * weight).ravel()
    height = np.array([abs(np.sum(borne * np.exp(1j * k * s))) ** 2 for k in waves])
    turns = waves[:, None] * 0.3 * CREEP.times
    loss = (turns / (1.0 + turns**2)) @ CREEP.compliances
    assert 2.0 / np.pi * (sizes @ (height * loss)) == pytest.approx(one.shear_force_per_length, rel=1e-6)


def test_slowly_and_fast_it_is_hertz():
    for speed, shear in ((1e-11, 1e6), (1e9, 29e6)):
        one, level = rolled(wk.HalfWidth(1e-3), speed), 4.0 * shear * 1e-3 / (2.0 * 0.1)
        assert one.force_per_length == pytest.approx(0.5 * np.pi * level * 1e-3, rel=1e-6)
        assert [-one.trailing_edge, one.leading_edge] == pytest.approx([1e-3, 1e-3], rel=1e-5)
        assert one.peak_pressure == pytest.approx(level, rel=1e-6)
        x = 1e-3 * np.array([-0.9, 0.0, 0.5])
        np.testing.assert_allclose(one.pressure(x), level * np.sqrt(1.0 - (x / 1e-3) ** 2), rtol=1e-5)


@pytest.mark.parametrize("speed", [1e-9, 1e-7])
def test_slowly_the_resistance_grows_with_the_speed(speed):
    """Q/P = v sum C_k lambda_k / (C(oo) R), on both sides of where creep counts as immediate."""
    first = speed * float(CREEP.compliances @ CREEP.times) / (1.0 / 4e6) / 0.1
    assert rolled(wk.HalfWidth(1e-3), speed).coefficient == pytest.approx(first, rel=2e-3)


def test_loads_say_the_same():
    speeds = np.geomspace(1e-3, 10.0, 5)
    by_force = rolled(wk.LineForce(300.0), speeds)
    for index, speed in enumerate(speeds):
        by_width = rolled(wk.HalfWidth(float(by_force.half_width[index])), float(speed))
        by_mean = rolled(wk.MeanPressure(float(by_force.mean_pressure[index])), float(speed))
        for other in (by_width, by_mean, by_force.at(index)):
            assert other.force_per_length == pytest.approx(300.0, rel=1e-12)
            assert other.coefficient == pytest.approx(by_force.coefficient[index], rel=1e-10)
    np.testing.assert_allclose(by_force.peak_pressure, [by_force.at(k).peak_pressure for k in range(5)], rtol=1e-12)


def test_pressures_do_not_pull():
    for ratio in (1.01, 10.0, 1e4):
        for time in (1e-4, 1e-2, 1.0, 1e2):
            solid = wk.StandardSolid(relaxed_shear=1.0, shear=ratio - 1.0, relaxation_time=time)
            one = rolled(
                wk.HalfWidth(0.01), 1.0, wk.LineFoundation(wk.Paraboloid(1.0), wk.ViscoelasticHalfSpace(solid))
            )
            x = np.linspace(one.trailing_edge, one.leading_edge, 2001)
            assert np.min(one.pressure(x)) >= 0.0


def test_polyamide_rollers_press_as_in_contact(shared_data):
    """viscoelastic_rollers of CONTACT: elements of 0.16 mm; their traction leaves the pressure alone."""
    table = tomllib.loads((shared_data / "reference" / "contact" / "viscoelastic_rollers.toml").read_text())
    glassy = table["inputs"]["glassy_shear_modulus_Pa"]
    for case in table["case"]:
        if case.get("retardation_time_s", 0.0) == 0.0:
            continue
        solid = wk.GeneralisedKelvin(1.0 / glassy, [1.0 / glassy], [case["retardation_time_s"]], poisson=0.4)
        bed = wk.LineFoundation(wk.Paraboloid(0.05), wk.ViscoelasticHalfSpace(solid, solid))
        one = rolled(wk.LineForce(600e3), 1.0, bed)
        assert one.trailing_edge == pytest.approx(case["trailing_end_m"], abs=0.16e-3)
        assert one.leading_edge == pytest.approx(case["leading_end_m"], abs=0.16e-3)
        assert one.peak_pressure == pytest.approx(case["peak_pressure_Pa"], rel=1e-3)


@pytest.mark.parametrize("kappa", [1e-8, 0.3, 40.0, 1e4])
def test_the_first_tail_is_its_integral(kappa):
    """L_1 = int exp(-kappa (cosh t - 1) - t) dt."""
    t, w = clustered(0.0, min(np.arccosh(1.0 + 45.0 / kappa), 45.0), 400)
    expected = w @ np.exp(-2.0 * kappa * np.sinh(0.5 * t) ** 2 - t)
    assert float(first_tail(np.array([kappa]))[0]) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(("kappa", "other"), [(0.3, 1e-3), (40.0, 7.0), (7.0, 40.0), (3.0, 3.1), (1e3, 2e-3)])
def test_the_sum_over_the_waves_telescopes(kappa, other):
    """Sum n L_n(k) exp(-k') I_n(k') = k k'/(2 (k - k')) [I_0(k') K_1(k) + I_1(k') K_0(k) - 1/k], exponentials aside."""
    n = np.arange(1, 120)
    t, w = clustered(0.0, min(np.arccosh(1.0 + 45.0 / kappa), 45.0), 400)
    tails = np.array([w @ np.exp(-2.0 * kappa * np.sinh(0.5 * t) ** 2 - each * t) for each in n])
    summed = np.sum(n * tails * ive(n, other))
    closed = ive(0, other) * kve(1, kappa) + ive(1, other) * kve(0, kappa) - 1.0 / kappa
    assert summed == pytest.approx(0.5 * kappa * other / (kappa - other) * closed, rel=1e-9)


def test_weak_modes_do_not_spoil_the_strip():
    """A mode of hardly any strength relaxes in nearly the time in which it creeps; without it nothing changes."""
    plain = rolled(wk.LineForce(300.0), np.geomspace(1e-3, 10.0, 5))
    weak = wk.Prony(1e6, [2e6, 5e6, 1e6, 20e6, 1e-6], [1e-4, 1e-3, 4e-3, 0.1, 0.03])
    bed = wk.LineFoundation(wk.Paraboloid(0.1), wk.ViscoelasticHalfSpace(weak))
    also = rolled(wk.LineForce(300.0), np.geomspace(1e-3, 10.0, 5), bed)
    np.testing.assert_allclose(also.coefficient, plain.coefficient, rtol=1e-10)


@pytest.mark.parametrize(
    ("bed", "load", "sentence"),
    [
        (
            wk.LineFoundation(wk.Paraboloid(0.1), wk.ViscoelasticHalfSpace(wk.Maxwell(1e6, 1.0))),
            wk.HalfWidth(1e-3),
            "creeps without limit",
        ),
        (
            wk.LineFoundation(wk.Paraboloid(0.1), wk.ViscoelasticHalfSpace(wk.KelvinVoigt(1e6, 1e3))),
            wk.HalfWidth(1e-3),
            "resists a step of strain without bound",
        ),
        (wk.LineFoundation(wk.Cone(1.4), BED.medium), wk.HalfWidth(1e-3), "only a round body"),
        (
            wk.LineFoundation(wk.Paraboloid(0.1), wk.HalfSpace(wk.Elastic(1e6, 0.5))),
            wk.HalfWidth(1e-3),
            "does not resist",
        ),
        (BED, wk.LineForce(-1.0), "does not press"),
        (BED, wk.LineForce([1.0, 2.0]), "with one number"),
    ],
)
def test_what_has_no_answer_is_refused(bed, load, sentence):
    with pytest.raises(wk.WinklerError, match=sentence):
        rolled(load, 1.0, bed)


def test_there_is_no_such_speed():
    with pytest.raises(wk.InvalidInput, match="there is no speed"):
        rolled(wk.HalfWidth(1e-3), [1.0, 2.0]).at(2)
    with pytest.raises(wk.InvalidInput, match="pressure"):
        rolled(wk.HalfWidth(1e-3), [1.0, 2.0]).pressure(0.0)
