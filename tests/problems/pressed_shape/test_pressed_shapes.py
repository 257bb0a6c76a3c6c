"""Ellipses and nearly round bodies pressed on layers by pixels, against the round engine and matrix exponentials."""

from __future__ import annotations

import math

import numpy as np
import pytest

from problems.layer_waves import base, crossed
from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth, Force, Radius
from winkler.materials.depth_grading import ExponentialGrading
from winkler.materials.elastic import Elastic
from winkler.materials.graded import PowerLawGraded
from winkler.materials.layered import Layer, StackLayer
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.halfspace import HalfSpace
from winkler.media.layered.coated import CoatedHalfSpace, SlidingFilm, StackedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.problems.normal.elliptic import EllipticIndentation, pressed_ellipse
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.near_round import NearlyRoundIndentation
from winkler.problems.pressed_shape.pressed_map import edge_error, grid_error, pressed_levels
from winkler.profiles.ellipse import CurvedBodies
from winkler.profiles.power import Paraboloid
from winkler.profiles.sphere import Sphere
from winkler.values.errors import InvalidInput, OutsideValidity

BASE = Elastic(1.0, 0.3)
SLENDER = CurvedBodies(30.0, 10.0)
MEDIA = {
    "soft coating": CoatedHalfSpace((Layer(Elastic(0.1, 0.4), 0.03),), BASE),
    "film": SlidingFilm((Layer(Elastic(3.0, 0.25), 0.04),), BASE),
    "stack": StackedHalfSpace(
        (StackLayer(Elastic(0.2, 0.4), 0.03), StackLayer(Elastic(5.0, 0.2), 0.05, bonded=False)), BASE
    ),
    "grading": DepthGradedHalfSpace(ExponentialGrading(1.0, 3.0, depth_scale=0.1, poisson=0.3)),
    "power law": GradedHalfSpace(PowerLawGraded(young=1.0, depth_scale=0.1, exponent=0.5, poisson=0.3)),
}
PAIRS = [(0.1, 3.0), (10.0, 0.3), (0.1, 0.3), (0.1, 10.0), (10.0, 3.0), (10.0, 10.0)]
CONTRASTS = [pytest.param(*pair, marks=[pytest.mark.slow] if n > 1 else []) for n, pair in enumerate(PAIRS)]
TURNS = 2.0 * math.pi * np.arange(32) / 32


def coated(contrast, thickness, poisson=0.2):
    return CoatedHalfSpace((Layer(Elastic(contrast, poisson), thickness),), BASE)


def as_stated(found, exact, edges):
    """Return what differs by more than the stated errors."""
    return [
        (word, getattr(found, word) / number - 1.0, error)
        for numbers, error in ((exact, found.grid_error), (edges, found.edge_error))
        for word, number in numbers.items()
        if abs(getattr(found, word) / number - 1.0) > error
    ]


def compared_with_the_round_engine(medium, radius=0.1):
    ball = Indentation(Foundation(Paraboloid(10.0), medium), Radius(radius)).solve()
    found = EllipticIndentation(CurvedBodies(10.0, 10.0), medium, Force(float(ball.force))).solve()
    assert found.grid_error < 3e-4
    assert found.edge_error < 0.05
    exact = {"depth": ball.depth, "peak_pressure": ball.peak_pressure}
    edges = {"stiffness": ball.stiffness, "area": math.pi * radius**2}
    return as_stated(found, exact, edges | {f"{name}_semi_axis": radius for name in ("longitudinal", "lateral")})


@pytest.mark.few(2)
@pytest.mark.parametrize("name", MEDIA)
def test_a_ball_on_each_medium_is_that_of_the_round_engine(name):
    assert compared_with_the_round_engine(MEDIA[name]) == []


@pytest.mark.parametrize(("contrast", "ratio"), CONTRASTS)
def test_a_ball_on_coatings_is_that_of_the_round_engine(contrast, ratio):
    assert compared_with_the_round_engine(coated(contrast, 0.1 / ratio)) == []


def compliance(contrast, poisson, thickness, k):
    """w k / p of a coating, by matrix exponentials."""
    shear = 0.5 * contrast / (1.0 + poisson)
    scale = np.array([1.0, 1.0, shear, shear])[:, None]
    on = base((0.5 / 1.3, 0.3))
    fields = scale * (crossed(poisson, np.minimum(k * thickness, 20.0)) @ (on / scale))
    return -(fields[:, :2] @ np.linalg.inv(fields[:, 2:]))[:, 1, 1]


@pytest.mark.parametrize(("contrast", "ratio"), CONTRASTS)
def test_pressures_under_an_ellipse_sink_it_as_matrix_exponentials_do(contrast, ratio):
    """u + h = d at places in the contact, u an integral over waves in all directions of the pressures of the pixels."""
    thickness, load = 0.06 / ratio, 1e-4 * contrast**0.5
    _, fine = pressed_ellipse(SLENDER, coated(contrast, thickness), Force(load))
    a, b = fine.contour((0.0, 0.5 * math.pi))
    assert a > 1.5 * b  # no ball
    nodes, weights = np.polynomial.legendre.leggauss(24)
    edges = np.concatenate([[0.0], np.geomspace(0.02, 24.0, 12)]) / b
    k = (edges[:-1, None] + 0.5 * np.diff(edges)[:, None] * (nodes + 1.0)).ravel()
    dk = (0.5 * np.diff(edges)[:, None] * weights).ravel()
    across = 0.5 * math.pi * (1.0 - 0.5 * (np.polynomial.legendre.leggauss(64)[0] + 1.0))
    turn = 0.25 * math.pi * np.polynomial.legendre.leggauss(64)[1]
    kx, ky = np.outer(k, np.cos(across)).ravel(), np.outer(k, np.sin(across)).ravel()
    half = fine.x.size // 2
    along, aside = np.cos(np.outer(kx, fine.x[half:])), np.cos(np.outer(ky, fine.y[half:]))
    quarter = fine.pressure[half:, half:] * math.prod(fine.pixel)
    fades = np.sinc(kx * fine.pixel[0] / (2.0 * math.pi)) * np.sinc(ky * fine.pixel[1] / (2.0 * math.pi))
    borne = 4.0 * np.sum((along @ quarter) * aside, axis=1) * fades
    share = np.outer(compliance(contrast, 0.2, thickness, k) * dk, turn).ravel() * borne / math.pi**2
    for x, y in ((0.0, 0.0), (0.5 * a, 0.0), (0.0, 0.5 * b), (0.5 * a, 0.5 * b)):
        sunk = float(np.sum(share * np.cos(kx * x) * np.cos(ky * y)))
        assert sunk + 0.5 * (x**2 / 30.0 + y**2 / 10.0) == pytest.approx(fine.depth, rel=2e-3)
    assert float(np.sum(fine.pressure) * math.prod(fine.pixel)) == pytest.approx(load, rel=1e-12)


@pytest.mark.slow
def test_the_force_is_the_slope_of_the_energy_and_the_stiffness_that_of_the_force():
    """Two depths beside each other: dF/dd by their difference is the stiffness of the punch."""
    medium = coated(5.0, 0.02)
    found = EllipticIndentation(SLENDER, medium, Depth([0.9e-3, 1e-3, 1.1e-3])).solve()
    slope = float(np.diff(found.force[::2])[0]) / 0.2e-3
    assert slope == pytest.approx(found.stiffness[1], rel=float(found.edge_error[1]) + 2e-3)
    assert found.at(1).force == found.force[1]
    back = EllipticIndentation(SLENDER, medium, Force(float(found.force[1]))).solve()
    assert back.depth == pytest.approx(1e-3, rel=1e-5)
    assert back.pressure(0.0, 0.0) == pytest.approx(back.peak_pressure, rel=1e-6)
    assert back.pressure(1.02 * back.longitudinal_semi_axis, 0.0) == 0.0


@pytest.mark.slow
def test_the_base_is_felt_and_a_thin_layer_is_none():
    """Ten per cent of the base at a/h = 3; the difference from the base's half-space falls with the thickness."""
    load = Force(1e-4)
    soft, stiff = (CoatedHalfSpace((Layer(BASE, 0.02),), Elastic(young, 0.3)) for young in (0.5, 2.0))
    depths = [EllipticIndentation(SLENDER, medium, load).solve().depth for medium in (soft, stiff)]
    assert depths[0] > 1.5 * depths[1]
    bare = EllipticIndentation(SLENDER, HalfSpace(BASE), load).solve().depth
    thin = [EllipticIndentation(SLENDER, coated(4.0, h), load).solve().depth / bare - 1.0 for h in (2e-3, 1e-3)]
    assert 1.6 < thin[0] / thin[1] < 2.3
    assert abs(thin[1]) < 0.05


@pytest.mark.slow
def test_depth_and_pressure_converge_with_the_square_of_the_pixels():
    medium = coated(10.0, 0.03)

    def gap(x, y):
        return 0.5 * (x**2 / 30.0 + y**2 / 10.0)

    levels = [pressed_levels("", gap, medium, Force(1e-4), (0.05, 0.05), pixels=n)[1] for n in (64, 128, 256, 512)]
    for word in ("depth", "peak_pressure"):
        changes = -np.diff([getattr(level, word) for level in levels])
        assert np.all(changes[:-1] / changes[1:] > 3.0)
    assert grid_error(levels[2], levels[3]) < 1e-4
    assert edge_error(levels[2], levels[3], (0.0,)) < 0.01


@pytest.mark.slow
def test_a_nearly_round_body_is_the_ellipse_that_it_is():
    """32 profiles of the paraboloid against the ellipse; off the axes the contour too."""
    medium = coated(0.1, 0.03)
    bends = np.cos(TURNS) ** 2 / 20.0 + np.sin(TURNS) ** 2 / 10.0
    body = tuple(Paraboloid(float(1.0 / bend)) for bend in bends)
    round_like = NearlyRoundIndentation(body, medium, Force(1e-4)).solve()
    ellipse = EllipticIndentation(CurvedBodies(20.0, 10.0), medium, Force(1e-4)).solve()
    assert round_like.depth == pytest.approx(ellipse.depth, rel=2e-5)
    assert round_like.stiffness == pytest.approx(ellipse.stiffness, rel=round_like.edge_error)
    axes = ellipse.longitudinal_semi_axis, ellipse.lateral_semi_axis
    assert round_like.contour[[0, 8]] == pytest.approx(axes, rel=round_like.edge_error)
    drawn = 1.0 / np.hypot(np.cos(TURNS) / axes[0], np.sin(TURNS) / axes[1])
    assert round_like.contour == pytest.approx(drawn, rel=round_like.edge_error)  # nearly an ellipse on layers, too
    sunk = NearlyRoundIndentation(body, medium, Depth([0.5, 1.0] * np.array(float(round_like.depth)))).solve()
    assert sunk.force[1] == pytest.approx(1e-4, rel=1e-4)


def test_what_pixels_refuse():
    with pytest.raises(OutsideValidity, match="tensile"):
        EllipticIndentation(SLENDER, MEDIA["film"], Force(-1.0)).solve()
    with pytest.raises(InvalidInput, match="homogeneous"):
        _ = EllipticIndentation(SLENDER, MEDIA["film"], Force(1.0)).bed
    with pytest.raises(OutsideValidity, match="beyond the reach"):
        NearlyRoundIndentation((Sphere(1.0),) * 8, MEDIA["film"], Force(3.0)).solve()
    none = EllipticIndentation(SLENDER, MEDIA["film"], Depth([0.0, -1.0])).solve()
    assert np.all(none.force == 0.0)
    assert np.all(none.area == 0.0)
