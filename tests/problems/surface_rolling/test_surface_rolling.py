"""Steady rolling of height maps: Kalker's coefficients, CONTACT's curves, saturation, and what it refuses."""

from __future__ import annotations

import csv
import math
import tomllib

import numpy as np
import pytest
from scipy.optimize import fsolve

import winkler as wk
from winkler.numerics.surfaces import rolled_surface
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

RADIUS, MU = 100.0, 0.3


def pair(nu: float, shear: float = 1.0) -> wk.HalfSpace:
    body = wk.Elastic(2.0 * shear * (1.0 + nu), nu)
    return wk.HalfSpace(body, body)


def bodies(medium: wk.HalfSpace, a: float, b: float, force: float) -> wk.CurvedBodies:
    """Return curvatures that touch on an ellipse."""

    def off(logarithms):
        found = wk.CurvedBodies(*np.exp(logarithms)).semi_axes(medium.modulus, force)
        return np.log(np.array(found) / (a, b))

    start = np.log(4.0 * medium.modulus * a * b * max(a, b) / (3.0 * force))
    return wk.CurvedBodies(*np.exp(fsolve(off, [start, start], xtol=1e-13)))


def rolled(medium, a, b, force, creepage, count=48, friction=MU) -> wk.SurfaceRollingSolution:
    """Roll an ellipse, `count` pixels along each semi-axis pair."""
    wide = count + 8
    side = np.array([a, b]) * 2.0 * wide / count
    topography = wk.SampledProfile(side, bodies(medium, a, b, force), (wide, wide))
    return wk.SurfaceRolling(topography, medium, wk.Force(force), wk.Coulomb(friction), creepage).solve()


@pytest.mark.few(2, slow=2)
@pytest.mark.parametrize(("count", "part"), [
    (72, 5e-3),
    pytest.param(144, 2e-3, marks=pytest.mark.slow),
])  # fmt: skip
@pytest.mark.parametrize(("nu", "slender", "longitudinal", "lateral", "spin"), [
    (0.0, 1.0, 3.40, 3.40, 1.33),
    (0.25, 1.0, 4.12, 3.67, 1.47),
    (0.5, 1.0, 5.20, 3.98, 1.63),
    (0.25, 0.5, 3.62, 3.01, 0.929),
])  # fmt: skip
def test_coefficients_of_kalker(nu, slender, longitudinal, lateral, spin, count, part):
    """All sticks: forces over G c^2, with c^2 the product of the semi-axes that the pixels have; Kalker's table E3.

    To 0.5 % on 72 pixels and 0.2 % on 144, twice as much for spin, and the half of the last digit of the table.
    """
    medium, small = pair(nu), 1e-9
    b = 1.0 / slender
    creepage = wk.Creepage([small, 0.0, 0.0], [0.0, small, 0.0], [0.0, 0.0, small])
    done = rolled(medium, 1.0, b, 1e-2 * medium.modulus, creepage, count, friction=1e3)
    square = np.count_nonzero(done.last.pressure > 0.0) * (2.0 / count) ** 2 * b / np.pi
    found = np.array([done.longitudinal_force[0], done.lateral_force[1], done.lateral_force[2]]) / small
    found /= square ** np.array([1.0, 1.0, 1.5])
    table = np.array([longitudinal, lateral, spin])
    last_digit = np.where(table < 1.0, 5e-4, 5e-3)
    assert np.all(np.abs(found - table) < part * np.array([1.0, 1.0, 2.0]) * table + last_digit)
    # Maxwell and Betti: lateral creepage turns as much as spin pushes
    assert -done.moment[1] == pytest.approx(done.lateral_force[2], rel=1e-5)


def test_the_creep_curve_of_contact(shared_data):
    """44 elements across, thirty creepages: to 0.15 % of the friction, from nearly all sticking to sliding."""
    file = shared_data / "reference" / "contact" / "creep_curve_ellipse.csv"
    rows = list(csv.DictReader(file.open().readlines()[1:]))
    creep, force = (np.array([abs(float(row[name])) for row in rows]) for name in ("creep_x", "force_x_N"))
    share = np.array([float(row["elements_stick"]) / float(row["elements"]) for row in rows])
    medium, normal = pair(0.28, 82e9), 106.7e3
    done = rolled(medium, 6.304e-3, 12.61e-3, normal, wk.Creepage(longitudinal=creep), 44, friction=0.33)
    np.testing.assert_allclose(done.longitudinal_force, force, atol=1.5e-3 * 0.33 * normal)
    np.testing.assert_allclose(done.stick_share, share, atol=0.01)
    np.testing.assert_allclose(done.loss_per_distance, creep * done.longitudinal_force, rtol=1e-12)


@pytest.mark.few(1)
@pytest.mark.parametrize(("mode", "name"), [("long", "longitudinal"), ("lat", "lateral"), ("spin", "spin")])
def test_curves_of_a_circle(shared_data, mode, name):
    with (shared_data / "reference" / "rolling_creep_curves_circle.csv").open(encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if (row["mode"], row["nu"], row["n"]) == (mode, "0.0", "48")]
    medium = pair(0.0)
    force = 4.0 / 3.0 * medium.modulus / RADIUS
    creepage = np.array([float(row["u"]) for row in rows]) * MU * force
    done = rolled(medium, 1.0, 1.0, force, wk.Creepage(**{name: creepage}), 44)
    for column, found in (
        ("Fx/(muFN)", done.longitudinal_force),
        ("Fy/(muFN)", done.lateral_force),
        ("Mz/(mu*FN*a)", done.moment),
    ):
        expected = [float(row[column]) for row in rows]
        np.testing.assert_allclose(found / (MU * force), expected, atol=6e-3)


def test_lateral_creepage_and_spin_together(shared_data):
    """CONTACT states 1 % of force and moment on 40 elements; both codes are of first order in them."""
    file = shared_data / "reference" / "contact" / "spin_ellipse.toml"
    given = tomllib.loads(file.read_text(encoding="utf-8"))
    inputs, case = given["inputs"], given["case"][0]
    medium = pair(inputs["poisson"], inputs["shear_modulus_Pa"])
    creepage = wk.Creepage(lateral=inputs["creep_y"], spin=inputs["spin_1_per_m"])
    done = rolled(medium, inputs["semi_axis_a_m"], inputs["semi_axis_b_m"], inputs["normal_force_N"], creepage, 40)
    assert done.lateral_force == pytest.approx(-case["force_y_N"], rel=2e-2)
    assert done.moment == pytest.approx(-case["moment_z_Nm"], rel=2.5e-2)
    assert done.stick_share == pytest.approx(case["elements_stick"] / case["elements"], abs=0.02)


def test_a_large_ellipse_that_slides_everywhere(shared_data):
    file = shared_data / "reference" / "contact" / "large_ellipse_sliding.toml"
    given = tomllib.loads(file.read_text(encoding="utf-8"))
    inputs, case = given["inputs"], given["case"][0]
    medium = pair(inputs["poisson"], inputs["shear_modulus_Pa"])
    curved = wk.CurvedBodies(inputs["curvature_radius_x_m"], inputs["curvature_radius_y_m"])
    topography = wk.SampledProfile([51 * 0.4e-3, 39 * 0.4e-3], curved, (51, 39))
    creepage = wk.Creepage(inputs["creep_x"], inputs["creep_y"], inputs["spin_1_per_m"])
    done = wk.SurfaceRolling(topography, medium, wk.Depth(inputs["depth_m"]), wk.Coulomb(0.3), creepage).solve()
    assert done.force == pytest.approx(case["normal_force_N"], rel=1e-3)
    assert done.longitudinal_force == pytest.approx(-case["force_x_N"], rel=5e-3)
    assert done.lateral_force == pytest.approx(-case["force_y_N"], rel=5e-3)
    assert done.moment == pytest.approx(-case["moment_z_Nm"], rel=1e-2)
    assert done.loss_per_distance * inputs["speed_m_per_s"] == pytest.approx(-case["friction_power_W"], rel=5e-3)
    assert done.stick_share == 0.0


def test_friction_takes_what_creepage_gives():
    """In the steady state nothing is stored: the slip loses the work of the creepage, but for the pixels."""
    medium = pair(0.3)
    force = 4.0 / 3.0 * medium.modulus / RADIUS
    done = rolled(medium, 1.0, 1.0, force, wk.Creepage(2e-3, 1e-3, 1e-3), 64)
    last = done.last
    patch = (2.0 * 72 / 64 / 72) ** 2
    lost = float(np.sum(last.traction * last.creep)) * patch
    assert lost == pytest.approx(float(done.loss_per_distance), rel=5e-2)
    size = np.hypot(*last.traction)
    assert np.all(size <= MU * last.pressure * (1.0 + 1e-9))
    assert np.all(np.sum(last.traction * last.creep, 0) >= -1e-12 * np.max(size))


def test_nothing_creeps_and_everything_slides():
    medium = pair(0.0)
    force = 4.0 / 3.0 * medium.modulus / RADIUS
    done = rolled(medium, 1.0, 1.0, force, wk.Creepage(longitudinal=[0.0, 1.0]), 32)
    np.testing.assert_allclose(done.longitudinal_force, [0.0, MU * force], rtol=1e-6)
    np.testing.assert_allclose(done.saturation, [0.0, 1.0], rtol=1e-6)
    np.testing.assert_array_equal(done.stick_share, [1.0, 0.0])


@pytest.mark.parametrize(("change", "error", "sentence"), [
    ({"load": wk.Force(1.0)}, OutsideValidity, "the contact reaches the border of the map"),
    ({"load": wk.Force([1.0, 2.0])}, InvalidInput, "one positive number"),
    ({"friction": wk.Coulomb(math.inf)}, InvalidInput, "positive, finite coefficient"),
    ({"topography": wk.Topography([[0.0, np.nan], [1.0, 2.0]], [1.0, 1.0])}, InvalidInput,
     "1 of 4 heights are missing"),
    ({"topography": wk.Topography(np.eye(8), [1.0, 1.0], periodic=True)}, InvalidInput, "has no leading edge"),
])  # fmt: skip
def test_what_it_refuses(change, error, sentence):
    stated = {
        "topography": wk.SampledProfile([2.5, 2.5], wk.Paraboloid(RADIUS), (24, 24)),
        "medium": pair(0.3),
        "load": wk.Force(1e-2),
        "friction": wk.Coulomb(MU),
        "drive": wk.Creepage(1e-3),
    }
    with pytest.raises(error, match=sentence):
        wk.SurfaceRolling(**(stated | change)).solve()


def test_too_few_rounds_are_not_converged(monkeypatch):
    monkeypatch.setattr(rolled_surface, "MOST_ROUNDS", 2)
    with pytest.raises(NotConverged, match=r"at the creepage \(0.002, 0\) with a spin of 0 1/m, .* after 2 rounds"):
        rolled(pair(0.0), 1.0, 1.0, 1e-2, wk.Creepage(2e-3))


@pytest.mark.slow
def test_from_rest_to_rolling_under_a_force(shared_data):
    """A ball under 0.657 of the friction, on the pixels of CONTACT, whose steps and pixels err by 1 to 2 %."""
    folder = shared_data / "reference" / "contact"
    inputs = tomllib.loads((folder / "cattaneo_to_carter.toml").read_text(encoding="utf-8"))["inputs"]
    rows = list(csv.DictReader((folder / "cattaneo_to_carter.csv").open().readlines()[1:]))
    medium, normal, mu = pair(inputs["poisson"]), inputs["normal_force"], inputs["friction"]
    push = -inputs["force_x_ratio"] * mu * normal
    ball = wk.SampledProfile([34 * 0.25, 33 * 0.25], wk.Paraboloid(0.5 / inputs["gap_coefficient_B"]), (34, 33))
    begun = wk.SurfaceRollingStart(
        ball, medium, wk.Force(normal), wk.Coulomb(mu), wk.ShearForce(push), distance=14.0
    ).solve()
    np.testing.assert_allclose(begun.distance, [float(row["distance"]) for row in rows])
    expected = np.array([float(row["creep_x"] or 0.0) for row in rows])
    np.testing.assert_allclose(begun.longitudinal_creepage, expected, rtol=1.5e-2)
    np.testing.assert_allclose(begun.longitudinal_force, push, rtol=1e-7)
    np.testing.assert_allclose(begun.lateral_creepage, 0.0, atol=1e-7)
    # rolled far enough, it is steady rolling at that creepage
    steady = wk.SurfaceRolling(
        ball, medium, wk.Force(normal), wk.Coulomb(mu), wk.Creepage(begun.longitudinal_creepage[-1])
    ).solve()
    assert steady.longitudinal_force == pytest.approx(push, rel=1e-3)
    assert steady.stick_share == pytest.approx(begun.stick_share[-1], abs=0.01)


@pytest.mark.slow
def test_from_rest_to_rolling_with_creepage_and_spin():
    medium = pair(0.3)
    force = 4.0 / 3.0 * medium.modulus / RADIUS
    creepage = wk.Creepage(1e-3, -5e-4, 1e-3)
    ball = wk.SampledProfile([2.8, 2.8], wk.Paraboloid(RADIUS), (28, 28))
    stated = (ball, medium, wk.Force(force), wk.Coulomb(MU))
    begun = wk.SurfaceRollingStart(*stated, creepage, distance=6.0).solve()
    steady = wk.SurfaceRolling(*stated, creepage).solve()
    assert (begun.longitudinal_force[0], begun.longitudinal_creepage[0]) == (0.0, 0.0)
    np.testing.assert_allclose(begun.longitudinal_creepage[1:], 1e-3)
    assert np.all(np.diff(begun.longitudinal_force[:6]) > 0.0)
    for name in ("longitudinal_force", "lateral_force"):
        assert getattr(begun, name)[-1] == pytest.approx(getattr(steady, name), abs=2e-2 * MU * force)


def test_a_start_that_would_slide_away():
    ball = wk.SampledProfile([2.5, 2.5], wk.Paraboloid(RADIUS), (24, 24))
    stated = (ball, pair(0.3), wk.Force(1e-2), wk.Coulomb(MU))
    with pytest.raises(OutsideValidity, match="a shear force of 0.003 N is prescribed, but the friction limit"):
        wk.SurfaceRollingStart(*stated, wk.ShearForce(3e-3), distance=1.0).solve()
    with pytest.raises(InvalidInput, match="one CreepForce, or one Creepage"):
        wk.SurfaceRollingStart(*stated, wk.Creepage([1e-3, 2e-3]), distance=1.0)


@pytest.mark.parametrize(
    ("creepage", "standing"),
    [
        (wk.Creepage(0.01, 0.02), wk.Standing.ASYMPTOTIC),
        (wk.Creepage(0.03, 0.04), wk.Standing.APPROXIMATE),
        (wk.Creepage(0.09, 0.12), wk.Standing.OUTSIDE),
        (wk.Creepage(spin=1.0), wk.Standing.OUTSIDE),
    ],
)
def test_creepages_that_are_not_small_are_noted(creepage, standing):
    rough = wk.SampledProfile([2.5, 2.5], wk.Paraboloid(RADIUS), (24, 24))
    stated = wk.SurfaceRolling(rough, pair(0.3), wk.Force(1e-2), wk.Coulomb(MU), creepage)
    begun = wk.SurfaceRollingStart(rough, pair(0.3), wk.Force(1e-2), wk.Coulomb(MU), creepage, distance=0.1)
    for solution in (stated.solve(), begun.solve()):
        (note,) = (note for note in solution.validity if "creepages small compared with one" in note.statement)
        assert note.standing is standing
        assert ("its limit is 10 per cent" in note.statement) == (standing is wk.Standing.OUTSIDE)
