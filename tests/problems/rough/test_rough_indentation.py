"""Rough balls on lines of springs: between single peaks and the smooth ball, and against boundary elements."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth, Force
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.problems.normal.indentation import Indentation
from winkler.problems.rough.line_indentation import RoughIndentation
from winkler.problems.rough.spring_line import line_seeds
from winkler.problems.rough.surface_contact import SurfaceContact
from winkler.profiles.flat import FlatPunch
from winkler.profiles.power import Paraboloid
from winkler.profiles.rough.random_rough import random_line, random_topography
from winkler.profiles.rough.spectrum import SelfAffine
from winkler.profiles.rough.topography import Topography
from winkler.profiles.sphere import Sphere
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Standing

ONE = HalfSpace(Elastic(1.0, 0.0))
BALL = Foundation(Paraboloid(1.0), ONE)
FINE = SelfAffine(hurst=0.8, rms_height=1e-3, longest=0.25, shortest=1.0 / 32)


def test_it_is_the_sum_over_its_springs():
    """F = E* dx sum (d - (z_max - z)), z = h - x^2 / R, written out for one line."""
    result = RoughIndentation(FINE, BALL, 2.0, Depth([0.01, 0.1]), realisations=1, count=1000, seed=4).solve()
    x = (np.arange(1000) - 499.5) * 2e-3
    heights = random_line(FINE, 1000, 2.0, line_seeds(4, 1)[0]) - x**2
    pressed = np.maximum(np.array([[0.01], [0.1]]) - (heights.max() - heights), 0.0)
    assert result.force == pytest.approx(2e-3 * pressed.sum(axis=1), rel=1e-12)
    assert result.stiffness == pytest.approx(2e-3 * (pressed > 0.0).sum(axis=1), rel=1e-12)


def test_under_great_forces_the_ball_is_smooth():
    forces = np.array([0.01, 0.03])
    result = RoughIndentation(FINE, BALL, 1.5, Force(forces)).solve()
    smooth = Indentation(BALL, Force(forces)).solve()
    assert result.stiffness == pytest.approx(smooth.stiffness, rel=2e-3)
    assert result.smooth_stiffness == pytest.approx(smooth.stiffness, rel=1e-12)
    assert np.all(np.abs(result.depth - smooth.depth) < 3.0 * FINE.rms_height)
    assert np.all(result.area < np.pi * smooth.radius**2)
    assert result.area == pytest.approx(np.pi * smooth.radius**2, rel=7e-2)


def test_persson_ring_by_ring():
    """Under the pressures of Hertz, summed by another rule."""
    from scipy.integrate import quad
    from scipy.special import erf

    result = RoughIndentation(FINE, BALL, 1.5, Force([1e-3]), realisations=1).solve()
    smooth = Indentation(BALL, Force(1e-3)).solve()
    peak = 2.0 * smooth.radius / np.pi

    def ring(r):
        return 2.0 * np.pi * r * erf(np.sqrt(2.0) * peak * np.sqrt(1.0 - (r / smooth.radius) ** 2) / FINE.rms_slope)

    assert result.area[0] == pytest.approx(quad(ring, 0.0, smooth.radius, epsrel=1e-10)[0], rel=1e-6)


def test_lightly_pressed_it_bears_on_peaks():
    """Softer than the smooth ball by a factor that grows as the force falls, and deeper."""
    forces = np.geomspace(1e-7, 1e-4, 4)
    result = RoughIndentation(FINE, BALL, 1.0, Force(forces), realisations=100).solve()
    ratio = result.stiffness / result.smooth_stiffness
    assert np.all(np.diff(ratio) > 0.0)
    assert ratio[1] < 0.7
    assert np.all(result.depth > Indentation(BALL, Force(forces)).solve().depth)


def test_a_rough_flat_punch_is_pinned_at_its_rim():
    punch = Foundation(FlatPunch(0.3), ONE)
    result = RoughIndentation(FINE, punch, 1.0, Force([1.0, 10.0]), realisations=3).solve()
    assert result.stiffness == pytest.approx([0.6, 0.6], rel=2e-3)  # 2 E* a, to half a spring
    assert result.area == pytest.approx(np.pi * 0.09, rel=1e-6)


def test_against_boundary_elements():
    """Four maps of 128 x 128 pixels: stiffness and depth within a fifth where single peaks bear, 2 per cent beyond."""
    forces = np.array([1e-5, 1e-3, 1e-2])
    x = (np.arange(128) + 0.5) / 128 - 0.5
    ball = -0.5 * (x[:, None] ** 2 + x**2)
    rows = []
    for seed in range(4):
        rough = random_topography(FINE, (128, 128), [1.0, 1.0], seed).heights
        result = SurfaceContact(Topography(rough + ball, [1.0, 1.0]), ONE, Force(forces)).solve()
        rows.append((result.stiffness, result.depth))
    stiffness, depth = np.median(rows, axis=0)
    line = RoughIndentation(FINE, BALL, 1.0, Force(forces), realisations=100).solve()
    assert line.stiffness[0] / stiffness[0] == pytest.approx(1.0, abs=0.3)
    assert line.stiffness[1:] / stiffness[1:] == pytest.approx(1.0, abs=0.02)
    assert line.depth / depth == pytest.approx(1.0, abs=0.15)
    assert line.depth[2] / depth[2] == pytest.approx(1.0, abs=0.03)


def test_what_is_not_known_is_stated():
    result = RoughIndentation(FINE, BALL, 0.2, Force(1e-5), realisations=2, count=64).solve()
    statements = [note.statement for note in result.validity]
    assert any("longer than the line" in sentences for sentences in statements)
    assert any("area stated here is Persson's" in sentences for sentences in statements)
    assert all(note.standing is not Standing.OUTSIDE for note in result.validity)


def test_wrong_questions_are_refused():
    with pytest.raises(OutsideValidity, match="end of the line of 0.1 m; give a longer one"):
        RoughIndentation(FINE, BALL, 0.1, Force(0.1)).solve()
    with pytest.raises(OutsideValidity, match="reaches 0.05 m, beyond which nothing is known"):
        RoughIndentation(FINE, Foundation(Sphere(0.05), ONE), 1.0, Depth(1.0), realisations=1).solve()
    with pytest.raises(InvalidInput, match="the bed is a str; give a bed, such as Foundation"):
        RoughIndentation(FINE, "ball", 1.0, Force(1.0))
    with pytest.raises(InvalidInput, match="length is 0"):
        RoughIndentation(FINE, BALL, 0, Force(1.0))
    with pytest.raises(InvalidInput, match="load -1 is not positive"):
        RoughIndentation(FINE, BALL, 1.0, Force([1.0, -1.0]))
