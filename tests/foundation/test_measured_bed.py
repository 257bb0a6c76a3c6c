"""One force curve is enough: the bed behind it solves every other load, and refuses what it does not determine."""

from __future__ import annotations

import dataclasses
import os
import pathlib
import pickle

import numpy as np
import pytest

import winkler as wk
from winkler.foundation.measured import MeasuredBed

GLASS = wk.HalfSpace.between(wk.Elastic(70e9, 0.2))
DEPTH = np.linspace(0.0, 2e-6, 201)
SHARED = pathlib.Path(
    os.environ.get("WINKLER_SHARED_DATA", pathlib.Path(__file__).parents[2] / ".." / "shared" / "data")
)


def shared(name: str) -> pathlib.Path:
    path = SHARED / name
    if not path.exists():
        pytest.skip(f"{path} is not there: set WINKLER_SHARED_DATA")
    return path


def curve(profile):
    return wk.Indentation(wk.Foundation(profile, GLASS), wk.Depth(DEPTH)).solve()


@pytest.mark.few(2)
@pytest.mark.parametrize(
    ("profile", "tolerance"),
    [
        (wk.Paraboloid(1e-3), 1e-12),
        (wk.Cone(1.5), 1e-12),
        (wk.PowerLaw(1e6, 4.0), 1e-9),
        (wk.Sphere(1e-4), 1e-8),
        (wk.SpheroConical(1e-4, 1.4), 2e-5),
        (wk.RoundedPunch(3e-5, 1e-3), 2e-5),
    ],
)
def test_predicts_the_rest(profile, tolerance):
    measured = curve(profile)
    bed = MeasuredBed.from_curve(DEPTH, measured.force, GLASS.modulus)
    between = DEPTH[20:-1:9] + 0.3 * DEPTH[1]
    true = wk.Indentation(wk.Foundation(profile, GLASS), wk.Depth(between)).solve()
    found = wk.Indentation(bed, wk.Depth(between)).solve()
    np.testing.assert_allclose(found.force, true.force, rtol=tolerance)
    np.testing.assert_allclose(found.radius, true.radius, rtol=30.0 * tolerance)
    np.testing.assert_allclose(found.stiffness, true.stiffness, rtol=30.0 * tolerance)
    pressed = wk.Indentation(bed, wk.Force(true.force)).solve()
    np.testing.assert_allclose(pressed.depth, between, rtol=10.0 * tolerance)
    assert pressed.at(5).energy == pytest.approx(true.at(5).energy, rel=10.0 * tolerance + 1e-8)
    assert pressed.at(5).validity


def test_flat_end():
    """A punch with a flat end: the bed starts with its radius, and the springs beyond wait."""
    d = np.linspace(0.0, 1e-6, 101)
    k0, k1 = 2.0 * GLASS.modulus * 1e-5, 1e12
    bed = MeasuredBed.from_curve(d, k0 * d + 0.5 * k1 * d * d, GLASS.modulus)
    assert bed.radii[0] == pytest.approx(1e-5, rel=1e-9)
    assert bed.depths[0] == 0.0
    found = wk.Indentation(bed, wk.Depth(d[5:-1:10])).solve()
    np.testing.assert_allclose(found.force, k0 * d[5:-1:10] + 0.5 * k1 * d[5:-1:10] ** 2, rtol=1e-8)
    assert bed.gap(np.array([0.5e-5]))[0] == 0.0


def test_points_between_three_lists():
    """Measured radii, stiffnesses and depths, a paraboloid's: power laws are met exactly between the points."""
    a = np.geomspace(1e-6, 1e-4, 7)
    bed = MeasuredBed(a, 2.0 * GLASS.modulus * a, a**2 / 1e-3)
    x = np.array([1e-7, 3e-6, 9e-5])
    np.testing.assert_allclose(bed.gap(x), x**2 / 1e-3, rtol=1e-12)
    np.testing.assert_allclose(bed.gap_slope(x), 2.0 * x / 1e-3, rtol=1e-12)
    np.testing.assert_allclose(bed.normal_stiffness(x), GLASS.modulus, rtol=1e-12)
    np.testing.assert_allclose(bed.gap_load(x), 2.0 * GLASS.modulus * x**3 / 3e-3, rtol=1e-12)
    np.testing.assert_allclose(bed.height(x[1:]), x[1:] ** 2 / 2e-3, rtol=1e-8)


def test_scatter():
    """Noise of one per cent of the greatest force: force within that, stiffness within a few; and it is stated."""
    random = np.random.default_rng(5)
    measured = curve(wk.Paraboloid(1e-3))
    noise = 0.01 * measured.force[-1]
    bed = MeasuredBed.from_curve(DEPTH, measured.force + noise * random.standard_normal(DEPTH.size), GLASS.modulus)
    assert bed.scatter == pytest.approx(noise, rel=0.2)
    found = wk.Indentation(bed, wk.Depth(DEPTH[20:-5])).solve()
    assert np.max(np.abs(found.force - measured.force[20:-5])) < noise
    assert np.max(np.abs(found.stiffness / measured.stiffness[20:-5] - 1.0)) < 0.06
    assert any("root mean square" in note.statement for note in found.validity)


def test_fields_are_refused():
    bed = MeasuredBed.from_curve(DEPTH, curve(wk.Paraboloid(1e-3)).force, GLASS.modulus)
    contact = wk.Indentation(bed, wk.Depth(1e-6)).solve()
    with pytest.raises(wk.OutsideValidity, match="restore: the field needs a round contact"):
        wk.restore(contact, 0.0)
    with pytest.raises(wk.OutsideValidity, match="restore: the field needs a round contact"):
        wk.restore(contact, 0.0, 1e-6)
    known = dataclasses.replace(bed, disc=True)
    with pytest.raises(wk.OutsideValidity, match="neither the body nor the medium"):
        wk.restore(wk.Indentation(known, wk.Depth(1e-6)).solve(), 0.0)
    with pytest.raises(wk.OutsideValidity, match="mindlin_ratio"):
        bed.tangential_stiffness(np.array([1e-6]))
    with pytest.raises(wk.OutsideValidity, match="beyond the reach"):
        wk.Indentation(bed, wk.Depth(1e-5)).solve()


def test_tangential():
    bed = MeasuredBed.from_curve(DEPTH, curve(wk.Paraboloid(1e-3)).force, GLASS.modulus, mindlin_ratio=8.0 / 9.0)
    np.testing.assert_allclose(bed.tangential_stiffness(np.array([2e-5])), GLASS.shear_modulus, rtol=1e-9)


@pytest.mark.parametrize(
    ("change", "what"),
    [
        ({"radii": np.arange(7.0)}, "give three one-dimensional arrays of equal length"),
        ({"stiffnesses": np.array([1.0, 2, 3, 2.5, 5, 6])}, "stiffnesses does not rise from index 2"),
        ({"depths": np.array([1.0, 2, 3, 3, 5, 6])}, "depths does not rise"),
        ({"depths": np.array([1.0, 2, np.nan, 4, 5, 6])}, "finite"),
        ({"radii": np.array([-1.0, 2, 3, 4, 5, 6])}, "negative"),
        ({"scatter": -1.0}, "scatter"),
    ],
)
def test_bad_points(change, what):
    rise = np.arange(1.0, 7.0)
    with pytest.raises(wk.InvalidInput, match=what):
        MeasuredBed(**({"radii": rise, "stiffnesses": rise, "depths": rise} | change))


@pytest.mark.parametrize(
    ("depth", "force", "what"),
    [
        (DEPTH, np.sqrt(DEPTH), "convex"),
        (DEPTH[:4], DEPTH[:4], "at least 6"),
        (DEPTH - 1e-6, DEPTH, "negative"),
        (DEPTH, -DEPTH, "compression is positive"),
        (DEPTH, DEPTH[1:], "equal length"),
    ],
)
def test_bad_curves(depth, force, what):
    with pytest.raises(wk.InvalidInput, match=what):
        MeasuredBed.from_curve(depth, force, 1e9)


# ------------------------------------------------------------------------------------------------ other people's curves


@pytest.mark.parametrize(
    ("shape", "power", "constant", "error"),
    [("ellipsoid_R2", 1.5, 1.6014550, 3e-4), ("square_pyramid", 2.0, 0.737617, 3e-4)],
)
def test_bodies_that_are_not_round(shape, power, constant, error):
    """F(d) of ContactMechanics 1.8.3, E* = 1: what lies between its points, the stiffness, Mindlin's ratio of it."""
    lines = shared("reference/shapes_force_depth.csv").read_text().splitlines()
    rows = [line.rsplit(",", 8) for line in lines if line.startswith(shape)]  # formulas hold commas
    d, force = (np.array([float(row[column]) for row in rows]) for column in (1, 4))
    bed = MeasuredBed.from_curve(d, force, 1.0, mindlin_ratio=0.8)
    between = 0.5 * (d[1:] + d[:-1])
    found = wk.Indentation(bed, wk.Depth(between)).solve()
    np.testing.assert_allclose(found.force, constant * between**power, rtol=error)
    np.testing.assert_allclose(found.stiffness, power * constant * between ** (power - 1.0), rtol=10.0 * error)
    np.testing.assert_allclose(2.0 * found.radius, found.stiffness, rtol=1e-8)  # the disc of equal stiffness, E* = 1
    a = found.radius[3]
    x, weights = np.polynomial.legendre.leggauss(40)
    springs = bed.tangential_stiffness(0.5 * a * (x + 1.0))
    assert a * (weights @ springs) == pytest.approx(0.8 * found.stiffness[3], rel=1e-4)


def test_a_nanoindenter():
    """Steel to 158 nm (Hysitron): snap-in, drift and vibration; loading alone, from first touch, makes a bed."""
    lines = shared("nanoindentation/RobinSteel0000LC.txt").read_text(encoding="latin1").splitlines()[5:]
    table = np.array([[float(word) for word in line.split("\t")[:3]] for line in lines if line.strip()])
    depth, force, time = table.T * np.array([[1e-9], [1e-6], [1.0]])

    def bed(chosen):
        return MeasuredBed.from_curve(depth[chosen] - depth[chosen].min(), force[chosen], 200e9)

    with pytest.raises(wk.InvalidInput, match="not one loading"):
        bed(time < np.inf)
    with pytest.raises(wk.InvalidInput, match="subtract about"):
        bed((time > 1.0) & (time < 12.0))  # the approach comes along
    with pytest.raises(wk.InvalidInput, match="add to them about"):
        bed((time > 2.2) & (time < 12.0))  # at 48 uN already
    loading = (time > 2.0) & (time < 12.0)
    measured = bed(loading)
    assert measured.scatter < 5e-6
    found = wk.Indentation(measured, wk.Force(np.array([0.5e-3, 1.5e-3, 2.2e-3]))).solve()
    near = [np.abs(force[loading] - each) < 1e-5 for each in found.force]
    observed = [np.mean(depth[loading][close]) - depth[loading].min() for close in near]
    np.testing.assert_allclose(found.depth, observed, atol=1e-9)


# --------------------------------------------------------------------------------------------------------- as a value


def test_a_bed_of_lists_is_a_value():
    a = [1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6]
    bed = MeasuredBed(a, [1e9 * x for x in a], [1e3 * x * x for x in a])
    same = MeasuredBed(np.array(a), np.array([1e9 * x for x in a]), tuple(1e3 * x * x for x in a))
    assert bed == same == pickle.loads(pickle.dumps(bed))
    assert len({bed, same, pickle.loads(pickle.dumps(bed))}) == 1
    with pytest.raises(ValueError, match="read-only"):
        bed.radii[0] = 1.0
    with pytest.raises(wk.InvalidInput, match="radii is .*; give a row of at least 6 finite numbers in m"):
        MeasuredBed(["wide"] * 6, a, a)


def test_a_bed_answers_every_load():
    bed = MeasuredBed.from_curve(DEPTH, curve(wk.Paraboloid(1e-3)).force, GLASS.modulus, mindlin_ratio=0.8)
    a = 3e-5
    by_radius = wk.Indentation(bed, wk.Radius(a)).solve()
    assert by_radius.depth == pytest.approx(a**2 / 1e-3, rel=1e-10)
    by_force = wk.Indentation(bed, wk.Force(by_radius.force)).solve()
    assert by_force.radius == pytest.approx(a, rel=1e-9)
    assert by_force.energy == pytest.approx(0.4 * by_radius.force * by_radius.depth, rel=1e-9)  # Hertz: U = 2 F d / 5
    with pytest.raises(wk.OutsideValidity, match="The area of the contact is not known"):
        _ = by_force.mean_pressure
    disc = wk.Indentation(dataclasses.replace(bed, disc=True), wk.Force(by_radius.force)).solve()
    assert disc.mean_pressure == pytest.approx(by_radius.force / (np.pi * a**2), rel=1e-9)
    load = by_force.line_load(np.array([0.0, 0.5 * a, 2.0 * a]))
    np.testing.assert_allclose(load, GLASS.modulus * by_radius.depth * np.array([1.0, 0.75, 0.0]), rtol=1e-8)
    row = wk.Springs.of(bed, a, 200)
    assert np.sum(row.force(by_radius.depth)) == pytest.approx(by_radius.force, rel=1e-3)


# ---------------------------------------------------------------------------------------------- where depths count from


HERTZ = 4.0 / 3.0 * GLASS.modulus * np.sqrt(1e-3)


@pytest.mark.parametrize("noise", [0.0, 1e-3])
@pytest.mark.parametrize("shift", [-0.3, -0.1, 0.05, 0.3])
def test_of_a_shifted_curve_the_shift_is_stated(shift, noise):
    """A ball's curve with the approach left in (negative shift), or begun in contact."""
    offset = shift * DEPTH[-1]
    force = HERTZ * np.maximum(DEPTH + offset, 0.0) ** 1.5
    force = force + noise * force[-1] * np.random.default_rng(1).standard_normal(DEPTH.size)
    with pytest.raises(wk.InvalidInput, match="add to them about" if shift > 0.0 else "subtract about") as caught:
        MeasuredBed.from_curve(DEPTH, force, GLASS.modulus)
    words = str(caught.value).split("about ")[1].split()
    assert float(words[0]) == pytest.approx(abs(offset), rel=0.15)


def test_adhesion_is_named():
    with pytest.raises(wk.InvalidInput, match="adhesive"):
        MeasuredBed.from_curve(DEPTH, HERTZ * (DEPTH**1.5 - 0.05 * DEPTH[-1] ** 1.5), GLASS.modulus)


def test_where_unloading_begins_is_stated():
    there_and_back = np.minimum(DEPTH, 1.6 * DEPTH[-1] - DEPTH)
    with pytest.raises(wk.InvalidInput, match=r"from the depth 1\.[56]\d*e-06 m on the slope falls"):
        MeasuredBed.from_curve(DEPTH, HERTZ * there_and_back**1.5, GLASS.modulus)


@pytest.mark.few(1)
@pytest.mark.parametrize("count", [200, 10_000])
@pytest.mark.parametrize("noise", [1e-3, 1e-2])
def test_the_scatter_is_what_was_added(count, noise):
    """A cone's curve: force and stiffness from a tenth of the depth on."""
    d = np.linspace(0.0, 1e-6, count)
    exact = 1e12 * d**2
    force = exact + noise * exact[-1] * np.random.default_rng(8).standard_normal(count)
    bed = MeasuredBed.from_curve(d, force, GLASS.modulus)
    assert bed.scatter == pytest.approx(noise * exact[-1], rel=0.15)
    found = wk.Indentation(bed, wk.Depth(np.linspace(0.1, 0.95, 10) * d[-1])).solve()
    error = 6.0 * noise / np.sqrt(count)
    assert np.max(np.abs(found.force - 1e12 * found.depth**2)) < error * exact[-1]
    assert np.max(np.abs(found.stiffness - 2e12 * found.depth)) < 10.0 * error * 2e12 * d[-1]
