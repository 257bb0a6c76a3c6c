"""Lines on power laws: the singular integral by quadrature, limits, closed forms, what is refused."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

import winkler as wk
from winkler.profiles.profile import RisingShape
from winkler.values.value import value

CYLINDER = wk.Paraboloid(1.7)


def medium(k, poisson=0.3):
    return wk.GradedHalfSpace(wk.PowerLawGraded(2.0, 1.3, k, poisson))


def bed(k, profile=CYLINDER, poisson=0.3):
    return wk.PowerLawLineFoundation(profile, medium(k, poisson))


def sunk(contact, x, a):
    """Return the displacement under a line load B |x|^-k: point loads B_3 r^(-1-k) along y, B_3 by a stiff disc."""
    k, solid = contact.medium.exponent, contact.medium
    point = solid.depth_scale**k * math.cos(0.5 * math.pi * k) / (math.pi * solid.modulus)
    line = point * math.sqrt(math.pi) * math.gamma(0.5 * k) / math.gamma(0.5 * (1.0 + k))

    # on each side s = x + t^(1/(1-k)) away from the singularity
    def side(sign):
        end = (a - sign * x) ** (1.0 - k)
        power = 1.0 / (1.0 - k)

        def share(t):
            s = x + sign * float(t) ** power
            return float(contact.pressure(np.array([s]), a, 0.0)[0])

        return float(mp.quad(share, [0.0, 0.5 * end, end])) * power

    return line * (side(1.0) + side(-1.0))


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("k", [-0.4, 0.05, 0.5, 0.9])
@pytest.mark.parametrize("shape", ["cylinder", pytest.param("rounded", marks=pytest.mark.slow)])
def test_the_surface_follows_the_body(k, shape):
    """The kernel is that of point loads of the round contact; the depth is the one of `depth` where k > 0."""
    profile = CYLINDER if shape == "cylinder" else wk.PowerLaw(0.3, 4.0)
    contact, a = bed(k, profile), 0.8
    followed = [sunk(contact, x, a) + float(profile.height(np.array([x]))[0]) for x in (0.05, 0.4, 0.7)]
    np.testing.assert_allclose(followed, followed[0], rtol=2e-6)
    if k > 0.0:
        assert float(contact.depth(np.array(a), np.array(0.0))) == pytest.approx(followed[0], rel=2e-6)


def test_a_cylinder_has_closed_forms():
    """Giannakopoulos & Pallot: P ~ a^(2+k), p ~ (a^2 - x^2)^((1+k)/2); the mean pressure by the beta function."""
    k, a = 0.5, 0.8
    contact = wk.LineIndentation(bed(k), wk.HalfWidth(np.array([a, 2.0 * a]))).solve()
    assert contact.force_per_length[1] / contact.force_per_length[0] == pytest.approx(2.0 ** (2.0 + k), rel=1e-13)
    mean = math.sqrt(math.pi) * math.gamma(0.5 * (3.0 + k)) / (2.0 * math.gamma(2.0 + 0.5 * k))
    np.testing.assert_allclose(contact.mean_pressure / contact.peak_pressure, mean, rtol=1e-12)
    np.testing.assert_allclose(contact.depth, [a * a / (2.0 * k * 1.7), 4.0 * a * a / (2.0 * k * 1.7)], rtol=1e-12)


def test_a_half_plane_is_the_limit():
    plain = wk.LineFoundation(CYLINDER, wk.HalfSpace(wk.Elastic(2.0, 0.3)))
    x, a = np.linspace(0.0, 0.79, 7), 0.8
    for k, error in ((1e-4, 2e-3), (1e-6, 2e-5)):
        np.testing.assert_allclose(bed(k).pressure(x, a, 0.0), plain.pressure(x, a, 0.0), rtol=error)
        beside = bed(k).separation(np.array([1.0, 2.0]), a, 0.0)
        np.testing.assert_allclose(beside, plain.separation(np.array([1.0, 2.0]), a, 0.0), rtol=error)


def test_gibsons_solid_is_a_bed_of_springs():
    """k = 1, nu = 1/2: p = 2/3 E_0 / c_0 (d - f)."""
    contact = wk.LineIndentation(bed(1.0, poisson=0.5), wk.HalfWidth(0.8)).solve()
    depth = 0.8**2 / 3.4
    assert contact.depth == pytest.approx(depth, rel=1e-12)
    np.testing.assert_allclose(
        contact.pressure([0.0, 0.4]), 2.0 / 3.0 * 2.0 / 1.3 * (depth - np.array([0.0, 0.16 / 3.4]))
    )


@value
class Parabola(RisingShape):
    """The cylinder, known by its values alone."""

    def height(self, r):
        return r * r / 3.4

    def slope(self, r):
        return r / 1.7

    def curvature(self, r):
        return np.full(np.shape(r), 1.0 / 1.7)


@pytest.mark.parametrize("k", [-0.4, 0.5])
def test_a_parabola_that_is_no_paraboloid_gives_the_same_numbers(k):
    known, ghost = (wk.LineIndentation(bed(k, each), wk.LineForce(0.3)).solve() for each in (CYLINDER, Parabola()))
    assert ghost.half_width == pytest.approx(known.half_width, rel=1e-10)
    assert ghost.peak_pressure == pytest.approx(known.peak_pressure, rel=1e-8)
    x = np.array([0.5, 1.5, 3.0]) * known.half_width
    np.testing.assert_allclose(ghost.separation(x), known.separation(x), rtol=1e-8, atol=1e-12)


def test_load_of_pressures_work_and_slope():
    """The load is the integral of the pressure, and of k > 0 dP = K d(depth)."""
    contact, a, step = bed(0.3, wk.RoundedPunch(0.5, 1.0)), 0.8, 1e-5
    edges = np.linspace(0.0, a, 200)
    load = float(contact.load_profile(np.array([a]))[0])
    borne = 2.0 * float(contact.mean_pressures(edges, a, 0.0) @ np.diff(edges)) / contact.medium.modulus
    assert borne == pytest.approx(load, rel=1e-6)
    ends = np.array([a - step, a + step])
    pressed = np.diff(contact.load_profile(ends)) * contact.medium.modulus
    sank = np.diff(contact.depth(ends, np.zeros(2)))
    assert pressed / sank == pytest.approx(contact.punch_stiffness(np.array([a])), rel=1e-7)


def test_what_power_laws_do_not_tell():
    hard = wk.LineIndentation(bed(-0.4), wk.LineForce(0.3)).solve()
    with pytest.raises(wk.OutsideValidity, match="exponent -0.4"):
        _ = hard.depth
    soft = wk.LineIndentation(bed(0.5), wk.LineForce(0.3)).solve()
    assert soft.approach() == soft.depth
    with pytest.raises(wk.OutsideValidity, match="far away"):
        soft.approach(3.0)
    with pytest.raises(wk.OutsideValidity, match="stresses"):
        soft.stresses(0.0, 0.1)
    assert "power" in " ".join(note.statement for note in soft.validity)
