"""Lines that wear on power laws: integrals of the grid, the loss of a cycle, volume, the limit and its contact."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.special import betainc

import winkler as wk
from winkler.numerics.transforms.grid_transforms import SurfaceTransform, cuts_of
from winkler.numerics.transforms.strips.strip_transforms import StripTransforms

RADIUS, LOAD, MU = 0.6, 1e4, 0.5
SWING = 0.5 * MU * LOAD
NODE, WEIGHT = np.polynomial.legendre.leggauss(200)
EXPONENTS = [-0.3, 0.2, 0.5, 0.8]


def bed(k):
    solid = wk.PowerLawGraded(young=30e6, depth_scale=1.0, exponent=k, poisson=0.3)
    return wk.PowerLawLineFoundation(wk.Paraboloid(RADIUS), wk.GradedHalfSpace(solid, solid))


def half_width(k):
    return float(wk.LineIndentation(bed(k), wk.LineForce(LOAD)).solve().half_width)


def summed(function, low, high):
    """Return an integral, with the places gathered at its end."""
    t = 0.5 * (1.0 - NODE)
    places = high - (high - low) * t**4
    return float(function(places) @ (2.0 * (high - low) * t**3 * WEIGHT))


@pytest.mark.parametrize("k", EXPONENTS)
def test_the_grid_sums_up_what_integrals_do(k):
    """Profile to load, load to pressure, and load to distance, of functions that are straight in x^2."""
    nodes = np.array([0.0, 0.2, 0.5, 0.9, 1.4])
    height = np.array([0.0, 0.3, 0.1, 0.8, 0.6])
    grid, q = StripTransforms(nodes, k, 1.3, 0.7), 0.5 * (1.0 + k)
    slopes = np.diff(height) / np.diff(nodes**2)
    for row, a in enumerate(nodes[1:].tolist(), 1):
        angles = np.arcsin(nodes[: row + 1] / a)
        parts = [
            summed(lambda t, a=a: 2.0 * a ** (2.0 + k) * np.sin(t) ** 2 * np.cos(t) ** k, low, high)
            for low, high in zip(angles[:-1], angles[1:], strict=True)
        ]
        assert float(grid.gap[row] @ height) == pytest.approx(1.3 * float(slopes[:row] @ parts), rel=1e-7)

    lacking = np.array([1.0, 0.7, 0.2, -0.4, -1.0])  # it passes zero at the edge
    cut, falls = cuts_of(grid.squares, lacking), -np.diff(lacking) / np.diff(nodes**2)
    edge = math.sqrt(cut[-1].place)
    cells = list(zip(falls.tolist(), nodes.tolist(), [*nodes[1:3].tolist(), edge], strict=False))
    beyond = [
        sum(
            -fall * summed(lambda c, x=x: 2.0 * c * betainc(q, 0.5, 1.0 - (x / c) ** 2), high, max(low, x))
            for fall, low, high in cells
            if high > x
        )
        for x in grid.borders.tolist()
    ]
    borne = grid.borne(lacking, cut) * grid.areas
    np.testing.assert_allclose(borne, -np.diff([*beyond, 0.0]), rtol=1e-7, atol=1e-9)

    def apart(x, c):
        """The integral of (t^2 - c^2)^-q from c to x, with t^2 = c^2 + (x^2 - c^2) u^(1/(1-q))."""
        square, u = (x * x - c * c)[:, None], 0.5 * (1.0 + NODE)
        inner = (0.25 / np.sqrt(c[:, None] ** 2 + square * u ** (1.0 / (1.0 - q)))) @ WEIGHT
        return square[:, 0] ** (1.0 - q) / (1.0 - q) * inner

    surface, cut = SurfaceTransform(grid)(-lacking, cuts_of(grid.squares, -lacking)), [edge, 0.9, 1.4]
    for row in (3, 4):
        x = float(nodes[row])
        opened = sum(
            falls[cell] * summed(lambda c, x=x: 2.0 * c * apart(x, c), low, high)
            for cell, low, high in zip(range(2, row), cut[:-1], cut[1:], strict=False)
        )
        assert surface[row] == pytest.approx(0.7 * opened, rel=1e-7)


@pytest.mark.parametrize("k", EXPONENTS)
def test_the_first_state_is_the_contact_before_wear(k):
    a = half_width(k)
    x = np.linspace(0.0, 1.5 * a, 200)
    contact, grid = bed(k), bed(k).grid_transforms(x)
    lacking = LOAD / contact.medium.modulus - contact.load_profile(x)
    borne = contact.medium.modulus * grid.borne(lacking, cuts_of(grid.squares, lacking))
    means = contact.mean_pressures(np.append(grid.borders, x[-1]), a, 0.0)
    np.testing.assert_allclose(borne, means, atol=2e-3 * means[0])
    worn = wk.LineSlidingWear(contact, wk.Archard(1e-13), wk.LineForce(LOAD), [0.0, 10.0]).solve()
    assert worn.half_width[0] == pytest.approx(a, rel=1e-5)
    assert worn.worn_volume_per_length[1] == pytest.approx(1e-13 * LOAD * 10.0, rel=1e-3)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("k", EXPONENTS)
def test_fretting_begins_with_the_loss_of_a_cycle_and_ends_at_the_limit(k):
    forces = wk.LineForce(LOAD), wk.LineShearForce(SWING)
    fretted = wk.LineFrettingWear(bed(k), wk.Archard(1e-9), wk.Coulomb(MU), *forces, cycles=[0.0, 1e6]).solve()
    path = wk.LinePath(LOAD, SWING * np.array([0.0, 1.0, -1.0, 1.0]))
    cycle = wk.LineTangential(bed(k), wk.Coulomb(MU), path).solve().loss_per_cycle_per_length
    assert fretted.dissipation_per_length[0] == pytest.approx(cycle, rel=1e-4)
    limit = wk.LineLimitingProfile(bed(k), wk.Coulomb(MU), *forces).solve()
    assert limit.stick_half_width == pytest.approx(half_width(k) * 0.5 ** (1.0 / (2.0 + k)), rel=1e-9)
    np.testing.assert_allclose(fretted.stick_half_width, limit.stick_half_width, rtol=0.01)
    assert fretted.worn_volume_per_length[1] == pytest.approx(limit.worn_volume_per_length, rel=0.02)
    assert fretted.worn_volume_per_length[1] < 1.001 * limit.worn_volume_per_length


@pytest.mark.parametrize("k", [-0.3, 0.5])
def test_in_the_limit_the_worn_surfaces_just_touch(k):
    """The surface under the pressure of the core, with x = c sin(t), meets the worn profile up to where it ends."""
    limit = wk.LineLimitingProfile(bed(k), wk.Coulomb(MU), wk.LineForce(LOAD), wk.LineShearForce(SWING)).solve()
    c, end, medium = limit.stick_half_width, limit.half_width, bed(k).medium
    level = math.cos(0.5 * math.pi * k) / (math.pi * medium.modulus)
    level *= math.sqrt(math.pi) * math.gamma(0.5 * k) / math.gamma(0.5 * (1.0 + k))
    node, weight = np.polynomial.legendre.leggauss(4000)
    gathered = 0.5 * (1.0 - node)
    angle = 0.5 * np.pi * (1.0 - gathered**3)
    s = np.minimum(c * np.sin(angle), c * (1.0 - 1e-15))
    load = limit.pressure(s) * c * np.cos(angle) * 0.75 * np.pi * gathered**2 * weight
    assert 2.0 * float(np.sum(load)) == pytest.approx(LOAD, rel=1e-5)
    x = c + (end - c) * np.array([0.05, 0.3, 0.6, 0.9, 1.0])
    sunk = np.array([level * float(load @ ((at - s) ** -k + (at + s) ** -k)) for at in x])
    touching = sunk + limit.height(x)
    np.testing.assert_allclose(touching, touching[0], atol=1e-5 * np.ptp(sunk))
    assert limit.worn(x)[2] > 0.01 * np.ptp(sunk)


def test_a_half_plane_is_the_limit():
    plain = wk.LineFoundation(wk.Paraboloid(RADIUS), wk.HalfSpace.between(*(wk.Elastic(30e6, 0.3),) * 2))
    forces = wk.LineForce(LOAD), wk.LineShearForce(SWING)
    for k, error in ((0.0, 1e-10), (1e-6, 1e-4)):
        one, other = (wk.LineLimitingProfile(each, wk.Coulomb(MU), *forces).solve() for each in (bed(k), plain))
        assert one.worn_volume_per_length == pytest.approx(other.worn_volume_per_length, rel=error)
        assert one.half_width == pytest.approx(other.half_width, rel=error)
        one, other = (
            wk.LineFrettingWear(each, wk.Archard(1e-11), wk.Coulomb(MU), *forces, cycles=[0.0, 1e4]).solve()
            for each in (bed(k), plain)
        )
        np.testing.assert_allclose(one.worn_depth, other.worn_depth, rtol=10.0 * error)
        np.testing.assert_allclose(one.dissipation_per_length, other.dissipation_per_length, rtol=10.0 * error)
