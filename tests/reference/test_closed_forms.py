"""Every closed form of a shape against quadrature of its definition in 40 digits (theory 1.1)."""

from __future__ import annotations

import math

import mp_solutions
import mpmath as mp
import numpy as np
import pytest

from winkler.reference import capped, cone, hertz, power, punch, rounded, sphere, truncated, wavy

FAR = (1.02, 1.5, 4.0)
"""Distances r/a outside the contact."""


def exact(**numbers: float) -> dict[str, mp.mpf]:
    """The same doubles as exact numbers."""
    return {name: mp.mpf(number) for name, number in numbers.items()}


SHAPES = {
    "cone": (mp_solutions.cone, cone, "cone", {"half_angle": 1.25}, (0.3, 2.0)),
    "power_law 1.5": (mp_solutions.power_law, power, "power_law", {"coefficient": 0.7, "exponent": 1.5}, (0.4, 1.0)),
    "power_law 3": (mp_solutions.power_law, power, "power_law", {"coefficient": 0.7, "exponent": 3.0}, (0.4, 1.0)),
    "power_law 4": (mp_solutions.power_law, power, "power_law", {"coefficient": 0.7, "exponent": 4.0}, (0.4, 1.0)),
    "power_law 6.5": (mp_solutions.power_law, power, "power_law", {"coefficient": 0.7, "exponent": 6.5}, (0.4, 1.0)),
    "hertz": (mp_solutions.paraboloid, hertz, "hertz", {"curvature_radius": 1.7}, (0.1, 0.9)),
    "sphere": (mp_solutions.sphere, sphere, "sphere", {"curvature_radius": 1.3}, (0.001, 0.2, 0.5, 1.2)),
    "ellipsoid": (
        mp_solutions.ellipsoid,
        sphere,
        "ellipsoid",
        {"radial_semi_axis": 1.3, "axial_semi_axis": 0.4},
        (0.01, 0.7),
    ),
    "hyperboloid": (
        mp_solutions.hyperboloid,
        sphere,
        "hyperboloid",
        {"curvature_radius": 0.8, "half_angle": 1.1},
        (0.002, 0.2, 3.0),
    ),
    "truncated_cone": (
        mp_solutions.truncated_cone,
        truncated,
        "truncated_cone",
        {"half_angle": 1.3, "flat_radius": 0.2},
        (0.21, 0.5, 5.0),
    ),
    "truncated_paraboloid": (
        mp_solutions.truncated_paraboloid,
        truncated,
        "truncated_paraboloid",
        {"curvature_radius": 1.1, "flat_radius": 0.2},
        (0.25, 0.7),
    ),
    "capped_paraboloid": (
        mp_solutions.capped_paraboloid,
        capped,
        "capped_paraboloid",
        {"curvature_radius": 1.1, "cap_curvature_radius": 3.0, "cap_radius": 0.2},
        (0.1, 0.7),
    ),
    "rounded_punch": (
        mp_solutions.rounded_punch,
        rounded,
        "rounded_punch",
        {"flat_radius": 0.2, "edge_radius": 0.9},
        (0.3, 0.5, 2.0),
    ),
    "rounded_cone": (
        mp_solutions.rounded_cone,
        rounded,
        "rounded_cone",
        {"curvature_radius": 0.5, "half_angle": 1.2},
        (0.15, 0.3, 4.0),
    ),
    "sphero_conical": (
        mp_solutions.sphero_conical,
        rounded,
        "sphero_conical",
        {"curvature_radius": 0.5, "half_angle": 1.2},
        (0.15, 0.3, 0.5, 4.0),
    ),
    "wavy": (mp_solutions.wavy, wavy, "wavy", {"amplitude": 0.02, "wavelength": 0.9}, (0.01, 0.2, 0.6)),
}
EVERY = [(name, a) for name, (*_, radii) in SHAPES.items() for a in radii]
WITH_PRESSURE = [name for name, (_, module, word, *_) in SHAPES.items() if hasattr(module, f"{word}_pressure")]
WITH_DISPLACEMENT = [name for name, (_, module, word, *_) in SHAPES.items() if hasattr(module, f"{word}_displacement")]


def close(given: float, expected: mp.mpf, tolerance: float = 1e-12) -> None:
    assert abs(mp.mpf(float(given)) - expected) <= tolerance * abs(expected), (float(given), mp.nstr(expected, 20))


@pytest.mark.parametrize(("name", "a"), EVERY)
def test_depth(name, a):
    make, module, word, numbers, _ = SHAPES[name]
    close(getattr(module, f"{word}_depth")(a, **numbers), make(**exact(**numbers)).gap(mp.mpf(a)))


@pytest.mark.parametrize(("name", "a"), EVERY)
def test_force(name, a):
    make, module, word, numbers, _ = SHAPES[name]
    given = getattr(module, f"{word}_force")(a, modulus=2.5, **numbers)
    close(given, make(**exact(**numbers)).force(mp.mpf(a), mp.mpf(2.5)), 2e-12)


@pytest.mark.few(1, slow=2)
@pytest.mark.parametrize("fraction", [0.1, 0.8])
@pytest.mark.parametrize("name", WITH_PRESSURE)
def test_pressure(name, fraction):
    make, module, word, numbers, radii = SHAPES[name]
    a = radii[-1]
    given = getattr(module, f"{word}_pressure")(fraction * a, a, modulus=2.5, **numbers)
    with mp.workdps(20):
        body = make(**exact(**numbers))
        expected = body.pressure(mp.mpf(fraction * a), mp.mpf(a), mp.mpf(2.5), body.gap(mp.mpf(a)))
    close(given, expected)


@pytest.mark.parametrize("name", WITH_DISPLACEMENT)
def test_displacement(name):
    make, module, word, numbers, radii = SHAPES[name]
    body, a = make(**exact(**numbers)), radii[-1]
    depth = body.gap(mp.mpf(a))
    for r in (0.1 * a, 0.7 * a, *(factor * a for factor in FAR)):
        given = getattr(module, f"{word}_displacement")(r, a, **numbers)
        close(given, body.displacement(mp.mpf(r), mp.mpf(a), depth))


@pytest.mark.parametrize("name", SHAPES)
def test_arrays_give_the_same_as_numbers(name):
    _, module, word, numbers, radii = SHAPES[name]
    depth, force = getattr(module, f"{word}_depth"), getattr(module, f"{word}_force")
    a = np.array(radii)
    np.testing.assert_array_equal(depth(a, **numbers), [depth(item, **numbers) for item in radii])
    np.testing.assert_allclose(
        force(a, modulus=2.5, **numbers), [force(item, modulus=2.5, **numbers) for item in radii], rtol=1e-15
    )


@pytest.mark.parametrize("name", WITH_PRESSURE)
def test_no_pressure_outside(name):
    _, module, word, numbers, radii = SHAPES[name]
    a = radii[-1]
    outside = np.array([a, 1.5 * a, 100.0 * a])
    np.testing.assert_array_equal(getattr(module, f"{word}_pressure")(outside, a, modulus=2.5, **numbers), 0.0)


@pytest.mark.parametrize("name", WITH_DISPLACEMENT)
def test_the_displacement_is_continuous_at_the_edge(name):
    _, module, word, numbers, radii = SHAPES[name]
    a = radii[-1]
    displacement = getattr(module, f"{word}_displacement")
    inside, outside = displacement(np.array([a * (1 - 1e-13), a]), a, **numbers)
    assert inside == pytest.approx(outside, rel=1e-11)


@pytest.mark.parametrize("word", ["truncated_cone", "truncated_paraboloid"])
def test_a_flat_end_bears_nothing_before_the_contact_has_left_it(word):
    _, module, _, numbers, _ = SHAPES[word]
    for a in (0.1, 0.2):
        assert getattr(module, f"{word}_depth")(a, **numbers) == 0.0


def test_infinite_pressures():
    assert cone.cone_pressure(0.0, 1.0, half_angle=1.0, modulus=1.0) == math.inf
    numbers = {"curvature_radius": 1.0, "flat_radius": 0.5, "modulus": 1.0}
    assert truncated.truncated_paraboloid_pressure(0.5, 1.0, **numbers) == math.inf
    assert punch.flat_punch_pressure(1.0, 1.0, depth=1.0, modulus=1.0) == math.inf
    assert punch.flat_punch_pressure(1.1, 1.0, depth=1.0, modulus=1.0) == 0.0


def test_quartic_pressure():
    r = np.linspace(0.0, 2.0, 9)
    general = power.power_law_pressure(r, 2.0, coefficient=0.3, exponent=4.0, modulus=1.5)
    np.testing.assert_allclose(
        power.quartic_pressure(r, 2.0, coefficient=0.3, modulus=1.5), general, rtol=1e-13, atol=1e-15
    )


@pytest.mark.parametrize(
    ("exponent", "kappa"),
    [
        (1.0, "1.5707963268"),
        (2.0, "2"),
        (3.0, "2.3561944902"),
        (4.0, "2.6666666667"),
        (5.0, "2.9452431127"),
        (6.0, "3.2"),
    ],
)
def test_stretch_of_theory(exponent, kappa):
    assert float(power.stretch(exponent)) == pytest.approx(float(kappa), rel=2e-11)


def test_numbers_of_theory():
    """The test numbers of section 1.1, E* = 1."""
    angle = math.atan(10.0)
    found = {
        0.274653072167027: sphere.sphere_depth(0.5, curvature_radius=1.0),
        0.186632680417569: sphere.sphere_force(0.5, curvature_radius=1.0, modulus=1.0),
        0.0579639740363704: truncated.truncated_cone_depth(0.5, half_angle=angle, flat_radius=0.2),
        0.0381471384080969: truncated.truncated_cone_force(0.5, half_angle=angle, flat_radius=0.2, modulus=1.0),
        0.113200836675051: rounded.rounded_punch_depth(0.5, flat_radius=0.2, edge_radius=1.0),
        0.0886784482022164: rounded.rounded_punch_force(0.5, flat_radius=0.2, edge_radius=1.0, modulus=1.0),
        1.0 / 6.0: hertz.hertz_force(0.5, curvature_radius=1.0, modulus=1.0),
    }
    for expected, given in found.items():
        assert float(given) == pytest.approx(expected, rel=5e-15)
    assert float(hertz.hertz_peak_pressure(0.5, curvature_radius=1.0, modulus=1.0)) == pytest.approx(
        0.318309886, rel=1e-9
    )
    assert float(hertz.hertz_displacement(1.0, 0.5, curvature_radius=1.0)) == pytest.approx(0.0544988905, rel=1e-9)


def test_flat_punch():
    body, a, d = mp_solutions.flat_punch(mp.mpf(2)), mp.mpf(2), mp.mpf(0.5)
    close(punch.flat_punch_pressure(0.7, 2.0, depth=0.5, modulus=2.5), body.pressure(mp.mpf(0.7), a, mp.mpf(2.5), d))
    for r in (0.5, 2.5, 30.0):
        close(punch.flat_punch_displacement(r, 2.0, depth=0.5), body.displacement(mp.mpf(r), a, d))
    assert punch.flat_punch_force(0.5, radius=2.0, modulus=2.5) == 5.0
    assert punch.flat_punch_depth(5.0, radius=2.0, modulus=2.5) == 0.5


def test_pinned_contact_carries_the_force_of_its_pressure():
    """F(b) + 2 E* b (d - g(b)) against the force of p, integrated."""
    big, b, d = 1.3, 0.4, 0.5
    rim_depth = hertz.hertz_depth(b, curvature_radius=big)
    rim_force = hertz.hertz_force(b, curvature_radius=big, modulus=2.5)
    given = punch.pinned_force(d, rim=b, rim_depth=rim_depth, rim_force=rim_force, modulus=2.5)
    # r = b sin(phi): the edge singularity goes with the surface element
    node, weight = np.polynomial.legendre.leggauss(30)
    phi = 0.25 * np.pi * (1.0 + node)
    r = b * np.sin(phi)
    pressure = hertz.hertz_pressure(r, b, curvature_radius=big, modulus=2.5)
    pressure += punch.flat_punch_pressure(r, b, depth=d - rim_depth, modulus=2.5)
    expected = 0.25 * np.pi * np.dot(weight, 2.0 * np.pi * r * pressure * b * np.cos(phi))
    assert float(given) == pytest.approx(expected, rel=1e-12)


def test_hertz_inverse():
    a = hertz.hertz_radius(np.array([0.0, 1.0, 5e3]), curvature_radius=0.3, modulus=7.0)
    np.testing.assert_allclose(hertz.hertz_force(a, curvature_radius=0.3, modulus=7.0), [0.0, 1.0, 5e3], rtol=1e-14)


@pytest.mark.parametrize(("area", "degrees"), [(24.5, 70.30), (3.0 * math.sqrt(3.0) / 2.0, 42.28), (math.pi, 45.0)])
def test_equal_area_angle(area, degrees):
    assert math.degrees(cone.equal_area_angle(area)) == pytest.approx(degrees, abs=5e-3)
