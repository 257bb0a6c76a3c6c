"""Line contacts against closed forms by mpmath, and against forces along lines summed by their own quadrature."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest

import winkler as wk
from winkler.problems.line.half_width import borne_at_most

STEEL = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
MODULUS = 210e9 / 1.82
"""E* of steel on steel."""
RADIUS = 10e-3
POINTS = np.linspace(0.0, 1e-4, 9)
SHARE = np.array([0.0, 1e-6, 0.1, 0.5, 0.9, 0.99])
"""Places over the half-width."""


def pressed(profile, load=wk.LineForce(100e3)):  # noqa: B008 (values are immutable)
    return wk.LineIndentation(wk.LineFoundation(profile, PAIR), load).solve()


def load_integral(slope, a, edges=()):
    """The integral of x f'/sqrt(a^2 - x^2) from 0 to a at 30 digits; f' takes and returns mpf."""
    with mp.workdps(30):
        a = mp.mpf(a)
        ends = [mp.mpf(0), *(mp.asin(mp.mpf(b) / a) for b in edges if b < a), mp.pi / 2]
        return float(mp.quad(lambda t: a * mp.sin(t) * slope(a * mp.sin(t)), ends))


def pressure_integral(growth, x, a, start=0.0):
    """(1/pi) times the integral of w'(c)/sqrt(c^2 - x^2) from max(x, start) to a at 30 digits; mpf in, mpf out."""
    with mp.workdps(30):
        x, a = mp.mpf(x), mp.mpf(a)
        low = max(x, mp.mpf(start))
        return float(
            mp.quad(lambda t: growth(mp.hypot(x, t)) / mp.hypot(x, t), [mp.sqrt(low**2 - x**2), mp.sqrt(a**2 - x**2)])
            / mp.pi
        )


# ---------------------------------------------------------------------------------------------------- closed forms


def test_a_cylinder_presses_as_hertz_and_parts_the_surfaces_as_mcewen():
    roller = pressed(wk.Paraboloid(RADIUS))
    a = float(mp.sqrt(mp.mpf(4) * 100e3 * RADIUS / (mp.pi * mp.mpf(MODULUS))))
    p0 = float(2 * mp.mpf(100e3) / (mp.pi * a))
    np.testing.assert_allclose([roller.half_width, roller.peak_pressure], [a, p0], rtol=1e-13)
    np.testing.assert_allclose(roller.pressure(SHARE * a), p0 * np.sqrt(1.0 - SHARE**2), rtol=1e-12)
    np.testing.assert_array_equal(roller.pressure(np.array([-1.5, -1.001, 1.001, 7.0]) * a), 0.0)
    wide = np.array([-1.5, 1.01, 3.0, 20.0])
    away = np.abs(wide)
    beside = a * a / (2.0 * RADIUS) * (away * np.sqrt(away**2 - 1.0) - np.arccosh(away))
    np.testing.assert_allclose(roller.separation(wide * a), beside, rtol=1e-11)
    np.testing.assert_array_equal(roller.separation(SHARE * a), 0.0)


def test_a_wedge_presses_as_the_inverse_hyperbolic_cosine():
    slope = 1.0 / np.tan(np.radians(85.0))
    wedge = pressed(wk.Cone(np.radians(85.0)))
    assert wedge.half_width == pytest.approx(100e3 / (MODULUS * slope), rel=1e-13)
    share = SHARE[1:]
    exact = MODULUS * slope / np.pi * np.arccosh(1.0 / share)
    np.testing.assert_allclose(wedge.pressure(share * wedge.half_width), exact, rtol=1e-12)
    assert wedge.peak_pressure == np.inf
    assert wedge.mean_pressure == pytest.approx(0.5 * MODULUS * slope, rel=1e-13)


def test_a_flat_punch_presses_as_sadowsky():
    punch = pressed(wk.FlatPunch(1e-3))
    x = SHARE * 1e-3
    np.testing.assert_allclose(punch.pressure(x), 100e3 / (np.pi * np.sqrt(1e-6 - x * x)), rtol=1e-12)
    assert (punch.half_width, punch.peak_pressure) == (1e-3, np.inf)


def flat_with_round_edges(share, start):
    """Half of p E*^-1 R a^-1 at x = a cos(psi), b = a sin(phi0): Ciavarella, Hills and Monno (1998), eq. (8)."""
    phi0, phi = mp.asin(start), mp.asin(share)
    return (
        (mp.pi - 2 * phi0) * mp.cos(phi)
        + mp.log(abs(mp.sin(phi + phi0) / mp.sin(phi - phi0)) ** mp.sin(phi))
        + mp.log(abs(mp.tan((phi + phi0) / 2) * mp.tan((phi - phi0) / 2)) ** mp.sin(phi0))
    )


def test_a_flat_with_rounded_edges_presses_as_ciavarella_hills_and_monno():
    b = 1e-3
    for start in (0.999, 0.8, 0.3):
        a = b / start
        punch = pressed(wk.RoundedPunch(b, RADIUS), wk.HalfWidth(a))
        phi0 = mp.asin(mp.mpf(start))
        load = mp.mpf(b) ** 2 * MODULUS / (2 * RADIUS) * ((mp.pi / 2 - phi0) / start**2 - mp.cot(phi0))
        assert punch.force_per_length == pytest.approx(float(load), rel=1e-10 if start > 0.99 else 1e-12)
        scale = 2 * load / (mp.pi * a) / (mp.pi - 2 * phi0 - mp.sin(2 * phi0))
        share = np.array([0.1, 0.25, 0.5, 0.95])
        exact = [float(scale * flat_with_round_edges(mp.mpf(float(s)), mp.mpf(start))) for s in share]
        np.testing.assert_allclose(punch.pressure(share * a), exact, rtol=1e-10 if start > 0.99 else 1e-12)


@pytest.mark.parametrize("n", [0.5, 1.5, 3.0, 4.0, 7.5])
def test_a_power_bears_what_its_gamma_functions_say(n):
    a = 0.4e-3
    body = pressed(wk.PowerLaw(coefficient=2.0, exponent=n), wk.HalfWidth(a))
    with mp.workdps(30):
        grows = 2 * mp.mpf(n) * mp.sqrt(mp.pi) * mp.gamma((mp.mpf(n) + 1) / 2) / (2 * mp.gamma(mp.mpf(n) / 2 + 1))
    assert body.force_per_length == pytest.approx(MODULUS * float(grows * mp.mpf(a) ** n), rel=1e-13)
    assert pressed(body.problem.bed.profile, wk.LineForce(body.force_per_length)).half_width == pytest.approx(
        a, rel=1e-13
    )
    exact = [MODULUS * pressure_integral(lambda c: n * grows * c ** (n - 1), s * a, a) for s in (0.1, 0.5, 0.9)]
    np.testing.assert_allclose(body.pressure(np.array([0.1, 0.5, 0.9]) * a), exact, rtol=1e-12)


# ---------------------------------------------------------------------------------------------------- any profile


BENT = {
    "sphere": (wk.Sphere(5e-3), lambda x: x / mp.sqrt(mp.mpf(5e-3) ** 2 - x * x), ()),
    "formula": (wk.Formula("r**2/(2*R) + A*r**4", R=RADIUS, A=1e6), lambda x: x / RADIUS + 4 * mp.mpf(1e6) * x**3, ()),
    "truncated wedge": (
        wk.TruncatedCone(np.radians(80.0), 0.3e-3),
        lambda x: mp.mpf(1 / np.tan(np.radians(80.0))) * (x > 0.3e-3),
        (0.3e-3,),
    ),
    "wave": (
        wk.Paraboloid(RADIUS) + wk.Wavy(1e-7, 0.5e-3),
        lambda x: (
            x / mp.mpf(RADIUS) + mp.mpf(1e-7) * 2 * mp.pi / mp.mpf(0.5e-3) * mp.sin(2 * mp.pi * x / mp.mpf(0.5e-3))
        ),
        (),
    ),
}


@pytest.mark.parametrize("name", BENT)
def test_any_profile_bears_its_integral(name):
    profile, slope, edges = BENT[name]
    a = np.array([0.35e-3, 1e-3, 2e-3])
    body = pressed(profile, wk.HalfWidth(a))
    np.testing.assert_allclose(
        body.force_per_length, [MODULUS * load_integral(slope, float(x), edges) for x in a], rtol=1e-12
    )
    again = pressed(profile, wk.LineForce(body.force_per_length)).half_width
    np.testing.assert_allclose(again, a, rtol=1e-12)


def test_the_pressure_of_a_formula_is_that_of_its_powers():
    """P' of x^2/(2R) + A x^4 is (pi c/(2R) + 3 pi A c^3) E*."""
    a = 1.5e-3
    body = pressed(wk.Formula("r**2/(2*R) + A*r**4", R=RADIUS, A=1e6), wk.HalfWidth(a))
    places = np.array([0.0, 0.3, 0.8, 0.98])
    exact = [
        MODULUS * pressure_integral(lambda c: mp.pi * c / (2 * RADIUS) + 3 * mp.pi * 1e6 * c**3, s * a, a)
        for s in places
    ]
    np.testing.assert_allclose(body.pressure(places * a), exact, rtol=1e-12)


def test_the_pressure_bends_the_surfaces_to_the_profile():
    """Flamant: the slopes f' = (2/(pi E*)) times the principal value of p(s)/(x - s), by Gauss-Chebyshev nodes."""
    bodies = (wk.Formula("r**2/(2*R) + A*r**4", R=RADIUS, A=1e6), wk.Paraboloid(RADIUS) + wk.Wavy(1e-7, 2e-3))
    for body in bodies:
        contact = pressed(body, wk.HalfWidth(1e-3))
        n = 60  # p = sqrt(1 - s^2) phi: exact between the nodes for polynomials phi (Erdogan and Gupta)
        k = np.arange(1, n + 1)
        s, weight = np.cos(np.pi * k / (n + 1)), np.pi / (n + 1) * np.sin(np.pi * k / (n + 1)) ** 2
        between = np.cos(np.pi * (2 * np.arange(1, n + 2) - 1) / (2 * (n + 1)))
        smooth = contact.pressure(1e-3 * s) / np.sqrt(1.0 - s * s)
        turned = 2.0 / (np.pi * MODULUS) * (weight * smooth / (between[:, None] - s)).sum(axis=1)
        wanted = np.sign(between) * body.slope(1e-3 * np.abs(between))
        np.testing.assert_allclose(turned, wanted, atol=1e-12 * np.max(np.abs(wanted)) + 1e-12)


def test_a_measured_cylinder_comes_closer_to_hertz_with_every_point_more():
    """Points of x^2/(2R) + A x^4, whose spline is not exact: the error falls at least as the square."""
    true = wk.Formula("r**2/(2*R) + A*r**4", R=RADIUS, A=1e8)
    wanted = pressed(true)
    errors = []
    for count in (11, 21, 41):
        x = np.linspace(0.0, 1e-3, count)
        errors.append(abs(pressed(wk.Measured(x, true.height(x))).half_width / wanted.half_width - 1.0))
    assert errors[0] > 4.0 * errors[1] > 16.0 * errors[2]
    assert errors[2] < 1e-5


def test_mean_pressures_and_forces_are_the_same_question():
    loads = np.geomspace(1.0, 1e7, 30)
    for profile in (wk.Paraboloid(RADIUS), wk.RoundedPunch(1e-3, RADIUS), wk.FlatPunch(1e-3)):
        by_force = pressed(profile, wk.LineForce(loads))
        by_mean = pressed(profile, wk.MeanPressure(by_force.mean_pressure))
        np.testing.assert_allclose(by_mean.half_width, by_force.half_width, rtol=1e-12)
        np.testing.assert_allclose(by_mean.force_per_length, loads, rtol=1e-12)
        one = by_force.at(3)
        assert (one.force_per_length, one.half_width) == (loads[3], by_force.half_width[3])
        assert one.problem.load == wk.LineForce(loads[3])


def test_the_order_of_loads_and_no_load_do_not_matter():
    loads = np.array([[1e5, 0.0], [3e6, 2.0]])
    contact = pressed(wk.RoundedPunch(1e-3, RADIUS), wk.LineForce(loads))
    assert contact.half_width.shape == (2, 2)
    assert contact.half_width[0, 1] == contact.mean_pressure[0, 1] == contact.peak_pressure[0, 1] == 0.0
    apart = contact.at((0, 1))
    assert np.all(apart.pressure([0.0, 1e-3]) == 0.0)
    np.testing.assert_array_equal(apart.separation([-2e-3]), apart.problem.bed.profile.height(np.array([2e-3])))


# ---------------------------------------------------------------------------------------------------- refusals


@pytest.mark.parametrize(
    ("profile", "load", "sentence"),
    [
        (wk.Paraboloid(RADIUS), wk.LineForce(-1.0), "tensile"),
        (wk.Cone(1.5), wk.MeanPressure(1e6), "sharp tip"),
        (wk.RoundedPunch(1e-3, RADIUS), wk.HalfWidth(0.5e-3), "flat up to 0.001 m"),
        (wk.FlatPunch(1e-3), wk.HalfWidth(2e-3), "beyond the rim"),
        (wk.Wavy(1e-6, 1e-3), wk.LineForce(1e6), "press harder, give a smoother profile"),
        (wk.Wavy(1e-6, 1e-3), wk.LineForce(1e-3), "overlap at 0.001 m, at another crest"),
        (wk.Wavy(1e-6, 1e-3) + wk.Paraboloid(1e4), wk.LineForce(1e3), "overlap at 0.001 m, at another crest"),
        (wk.Measured(POINTS, 50.0 * POINTS**2), wk.LineForce(1e6), "reach of the profile"),
    ],
)  # fmt: skip
def test_what_has_no_answer_is_refused_in_one_sentence(profile, load, sentence):
    with pytest.raises(wk.WinklerError, match=sentence) as refused:
        pressed(profile, load)
    assert "\n" not in str(refused.value)


def test_a_designed_profile_is_read_in_its_own_panels():
    parabola = wk.Designed(np.array([0.0, 0.5e-3, 1e-3]), np.array([[0.025, 0.025], [0.075, 0.025]]), tolerance=1e-10)
    contact = pressed(parabola, wk.HalfWidth(0.7e-3))
    assert contact.force_per_length == pytest.approx(np.pi / 4.0 * MODULUS * 0.7e-3**2 / 10e-3, rel=1e-12)
    assert contact.pressure(0.2e-3) == pytest.approx(MODULUS * np.sqrt(0.7**2 - 0.2**2) * 1e-3 / 20e-3, rel=1e-11)


def test_the_sections_of_a_round_tip_are_no_profile_of_a_strip():
    with pytest.raises(wk.InvalidInput, match="round cross-sections of a tip"):
        wk.LineFoundation(wk.AreaFunction([24.5, 1e-7]), wk.HalfSpace(STEEL))


@pytest.mark.long
def test_a_conforming_groove_yields_before_its_upright_end():
    strong = wk.HalfSpace(wk.Elastic(210e9, 0.3, strength=0.7e9), wk.Elastic(210e9, 0.3))
    groove = wk.LineFoundation(wk.BallInSocket(10e-3, 10.1e-3), strong)
    onset = wk.LineYieldOnset(groove).solve()
    assert 5e-3 < onset.half_width < 9e-3
    again = wk.LineIndentation(groove, wk.HalfWidth(onset.half_width)).solve()
    assert again.greatest_stress().value == pytest.approx(0.7e9, rel=1e-9)
    with pytest.raises(wk.OutsideValidity, match="the strength is not reached"):
        wk.LineYieldOnset(wk.LineFoundation(groove.profile, wk.HalfSpace(wk.Elastic(2e9, 0.3, strength=1e13)))).solve()


def test_a_wave_too_high_for_one_strip_is_refused_inside_and_beside():
    high = wk.Paraboloid(RADIUS) + wk.Wavy(20e-6, 1e-3)
    with pytest.raises(wk.OutsideValidity, match="in several strips"):
        pressed(high, wk.HalfWidth(0.3e-3))
    with pytest.raises(wk.OutsideValidity, match="would pull"):
        pressed(high, wk.HalfWidth(1.1e-3))


def test_other_bodies_are_refused_and_many_loads_have_no_single_pressure():
    with pytest.raises(wk.InvalidInput, match="not implemented for line contacts"):
        wk.LineFoundation(wk.Paraboloid(RADIUS), wk.CoatedHalfSpace([wk.Layer(STEEL, 1e-3)], on=wk.Rigid()))
    many = pressed(wk.Paraboloid(RADIUS), wk.LineForce([1.0, 2.0]))
    with pytest.raises(wk.InvalidInput, match="pick one"):
        many.pressure(0.0)
    with pytest.raises(wk.InvalidInput, match="no load 7"):
        many.at(7)


def test_a_steel_wheel_presses_as_in_the_boundary_elements_of_contact(shared_data):
    """carter_line of CONTACT: 50 elements across, three digits; those at the edges are wide for its root."""
    steel = wk.Elastic(2.0 * 1.28 * 82e9, 0.28)
    wheel = wk.LineFoundation(wk.Paraboloid(0.5), wk.HalfSpace.between(steel, steel))
    contact = wk.LineIndentation(wheel, wk.LineForce(178.9e3)).solve()
    assert contact.half_width == pytest.approx(0.0010000104855494379, rel=1e-12)
    assert contact.peak_pressure == pytest.approx(1.139e8, rel=5e-4)
    file = shared_data / "reference" / "contact" / "carter_line_tractions.csv"
    rows = np.genfromtxt(file, delimiter=",", names=True, skip_header=1)
    inner = rows[np.abs(rows["x_m"]) < 0.9e-3]
    assert inner.size > 40
    np.testing.assert_allclose(inner["pressure_Pa"], contact.pressure(inner["x_m"]), atol=0.005 * contact.peak_pressure)


def test_a_designed_parabola_is_a_cylinder():
    """Two panels of a slope that rises from 0 to 0.1 over 2 mm: R = 20 mm."""
    designed = wk.Designed(np.array([0.0, 1e-3, 2e-3]), np.array([[0.025, 0.025], [0.075, 0.025]]), tolerance=1e-10)
    medium = wk.HalfSpace(wk.Elastic(210e9, 0.3))
    found, cylinder = (
        wk.LineIndentation(wk.LineFoundation(profile, medium), wk.LineForce(1e6)).solve()
        for profile in (designed, wk.Paraboloid(20e-3))
    )
    assert found.half_width == pytest.approx(cylinder.half_width, rel=1e-9)
    assert found.pressure(1e-4) == pytest.approx(float(cylinder.pressure(1e-4)), rel=1e-9)


def test_a_vertical_end_bears_what_the_load_grows_to():
    """w of f' = 3 h/(4 R) (1 - r/R)^(-1/4) is finite at R, that of (1 - r/R)^(-1/2) grows as a logarithm."""
    medium = wk.HalfSpace(wk.Elastic(1.0, 0.0))
    blunt = wk.LineFoundation(wk.Formula("h*(1 - (1 - r/R)**0.75)", reach=1.0, R=1.0, h=0.1), medium)
    most = float(mp.quad(lambda y: 0.3 * (1 - y**4) / mp.sqrt(2 - y**4), [0, 1]))  # with 1 - x = y^4
    assert most * (1.0 - 0.01) < borne_at_most(blunt) < most
    with pytest.raises(wk.OutsideValidity, match="beyond the reach"):
        wk.LineIndentation(blunt, wk.LineForce(1.01 * most)).solve()
    assert wk.LineIndentation(blunt, wk.LineForce(0.5 * most)).solve().half_width < 1.0
    steep = wk.LineFoundation(wk.Formula("h*(1 - sqrt(1 - r/R))", reach=1.0, R=1.0, h=0.1), medium)
    assert borne_at_most(steep) == np.inf
    assert 0.4 < wk.LineIndentation(steep, wk.LineForce(0.03)).solve().half_width < 0.6
    assert borne_at_most(wk.LineFoundation(wk.Sphere(1.0), medium)) == np.inf


def test_what_does_not_settle_at_the_end_is_no_vertical_end(monkeypatch):
    bed = wk.LineFoundation(wk.Formula("r**2 + r**4", reach=1.0), wk.HalfSpace(wk.Elastic(1.0, 0.0)))

    def unsettled(profile, a):
        raise wk.NotConverged("still moves")

    monkeypatch.setattr("winkler.foundation.line.line_load", unsettled)
    with pytest.raises(wk.NotConverged, match="what the profile carries at its end, 1 m"):
        borne_at_most(bed)


@pytest.mark.parametrize(
    ("content", "sentence"),
    [("left", "x is 'left'"), ([[1.0], [1.0, 2.0]], "give a number or an array"), (np.nan, "not finite")],
)
def test_places_that_are_none_are_refused(content, sentence):
    bed = wk.LineFoundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.0)))
    solution = wk.LineIndentation(bed, wk.HalfWidth(0.1)).solve()
    for requested in (solution.pressure, solution.separation, lambda x: solution.stresses(x, 0.1)):
        with pytest.raises(wk.InvalidInput, match=sentence):
            requested(content)
    with pytest.raises(wk.InvalidInput, match="do not broadcast"):
        solution.stresses([0.0, 0.1], [0.1, 0.2, 0.3])
