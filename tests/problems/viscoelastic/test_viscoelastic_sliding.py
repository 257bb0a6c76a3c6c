"""A rigid body that slides over an elastomer: closed forms, the hereditary integral, energy, and three dimensions."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from scipy.integrate import quad

import winkler as wk
from winkler.loading.loads import Depth, Force, Radius
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.materials.viscoelastic import Prony
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.springs.exponential_sums import CreepSeries
from winkler.problems.viscoelastic.sliding import SlidingResistance, share_of_line
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Standing

R, DEPTH, TAU = 2.0, 0.02, 1.3
VOIGT = KelvinVoigt(0.25, 0.25 * TAU)
RUBBER = Prony(0.05, [0.2, 0.3], [0.3, 1.0])
"""E* = 4 G: 0.2 Pa relaxed, 2.2 Pa glassy."""
ELASTIC = wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.3)))
PROFILES = [wk.Paraboloid(R), wk.Cone(half_angle=1.4), wk.PowerLaw(0.1, 3.0)]


def bed(solid, profile=None) -> wk.Foundation:
    return wk.Foundation(wk.Paraboloid(R) if profile is None else profile, ViscoelasticHalfSpace(solid))


def test_kelvin_voigt_ball():
    v = np.array([1e-6, 1e-2, 0.1, 1.0, 30.0])
    result = SlidingResistance(bed(VOIGT), Depth(DEPTH), v).solve()
    a, lag = math.sqrt(R * DEPTH), TAU * v
    edge = lag - np.sqrt(lag**2 + a**2)
    force = ((a**2 * a - a**3 / 3 + lag * a**2) - (a**2 * edge - edge**3 / 3 + lag * edge**2)) / R
    shear = (a**4 / 2 - a**4 / 4 + 2 * lag * a**3 / 3) - (a**2 * edge**2 / 2 - edge**4 / 4 + 2 * lag * edge**3 / 3)
    assert result.trailing_edge == pytest.approx(edge, rel=1e-12)
    assert result.force == pytest.approx(force, rel=1e-12)
    assert result.line_shear_force == pytest.approx(2.0 * shear / R**2, rel=1e-9)


@pytest.mark.parametrize("profile", PROFILES)
@pytest.mark.parametrize("v", [0.02, 0.3])
def test_the_hereditary_integral(profile, v):
    result = SlidingResistance(bed(RUBBER, profile), Depth(DEPTH), v).solve()
    line, a, kernel = result.line(), result.radius, ViscoelasticHalfSpace(RUBBER).relaxation

    def slope(x):
        return math.copysign(1.0, x) * float(profile.gap_slope(np.array([abs(x)]))[0])

    def load(x):
        corner = [0.0] if x < 0.0 else None
        inner = quad(lambda s: float(kernel.at(np.array((s - x) / v))) * slope(s), x, a, points=corner, epsrel=1e-11)
        return inner[0]

    for index in (100, 400, 700):
        assert line.line_load[index] == pytest.approx(max(load(line.position[index]), 0.0), rel=1e-5, abs=1e-12)
    assert load(result.trailing_edge) == pytest.approx(0.0, abs=1e-6 * line.line_load.max())
    force = quad(load, result.trailing_edge, a, points=[0.0], epsrel=1e-7)[0]
    assert result.force == pytest.approx(force, rel=2e-6)
    work = quad(lambda x: load(x) * slope(x), result.trailing_edge, a, points=[0.0], epsrel=1e-7)[0]
    assert result.line_shear_force == pytest.approx(work, rel=2e-6)


@pytest.mark.parametrize("n", [1.0, 2.0, 3.0, 5.0])
def test_slow_bodies_lose_what_their_moving_pressure_loses(n):
    """In three dimensions F_x = -pi tau v Int p f' r dr, of the elastic pressure; on the line twice that."""
    profile, v = wk.PowerLaw(0.1, n), 1e-7
    result = SlidingResistance(bed(RUBBER, profile), Depth(DEPTH), v).solve()
    relaxed = wk.Foundation(profile, wk.HalfSpace(wk.Elastic(0.15, 0.5)))
    contact = wk.Indentation(relaxed, Depth(DEPTH)).solve()
    # p r' dr with r = a sin t, against the singular slope of p at the edge
    node, weight = np.polynomial.legendre.leggauss(60)
    t = 0.25 * np.pi * (node + 1.0)
    r = contact.radius * np.sin(t)
    pressure = wk.restore(contact, r).pressure
    # -Int p' f' r dr = Int p (r f')' dr, (r f')' = n^2 c r^(n-1)
    loss = np.sum(0.25 * np.pi * weight * contact.radius * np.cos(t) * pressure * 0.1 * n**2 * r ** (n - 1.0))
    tau = (0.8 * 0.3 + 1.2 * 1.0) / 0.2
    assert result.shear_force == pytest.approx(np.pi * tau * v * loss, rel=1e-4)
    assert result.line_shear_force == pytest.approx(2.0 * result.shear_force, rel=1e-5)


@pytest.mark.parametrize("profile", PROFILES)
def test_fast_bodies_lose_what_a_glass_loses(profile):
    """F_x = 2 U / (t v) with the glass' elastic energy U, whose stress falls by dt/t in a time dt."""
    v = 1e5
    result = SlidingResistance(bed(RUBBER, profile), Depth(DEPTH), v).solve()
    glass = wk.Foundation(profile, wk.HalfSpace(wk.Elastic(2.2 * 0.75, 0.5)))
    energy = wk.Indentation(glass, Depth(DEPTH)).solve().energy
    fall = (0.8 / 0.3 + 1.2 / 1.0) / 2.2
    assert result.shear_force == pytest.approx(2.0 * energy * fall / v, rel=1e-4)
    assert result.line_shear_force == pytest.approx(result.shear_force, rel=1e-4)


def test_a_ball_at_low_speed():
    slow = SlidingResistance(bed(VOIGT), Force(1e-3), 1e-6).solve()
    assert slow.coefficient == pytest.approx(TAU * 1e-6 / R, rel=1e-4)
    assert any(note.standing is Standing.APPROXIMATE and "twice" in note.statement for note in slow.validity)


@pytest.mark.slow
def test_force_and_depth_give_the_same_solution():
    v = np.logspace(-6, 6, 13)
    for solid in (RUBBER, VOIGT, Maxwell(0.25, 0.3)):
        under = SlidingResistance(bed(solid), Force(1e-3), v).solve()
        assert under.force == pytest.approx(1e-3, rel=1e-9)
        again = SlidingResistance(bed(solid), Depth(float(under.depth[6])), v[6:7]).solve()
        assert again.force[0] == pytest.approx(1e-3, rel=1e-9)
        assert np.all(np.diff(under.depth) < 0.0)
        half = under.shear_force / under.line_shear_force
        assert np.all((half > 0.4999) & (half < 1.0001))
    assert SlidingResistance(bed(RUBBER), Force(1e-3), v[None, :]).solve().depth.shape == (1, 13)


@pytest.mark.slow
def test_a_depth_that_rounding_hides():
    """Warm rubber at low speed is pressed by Hertz's depth, which the search begins at: no sign changes above it."""
    prony = Prony(1e6, [1e6, 2e6, 4e6], [0.1, 0.01, 0.001])
    law = wk.WilliamsLandelFerry(298.15, first_constant=8.86, second_constant=32.83546322857449)
    rubber = bed(wk.AtTemperature(prony, law, 333.15), wk.Paraboloid(5e-3))
    rolling = SlidingResistance(rubber, Force(1.0), np.geomspace(1e-6, 10.0, 29), count=300).solve()
    np.testing.assert_allclose(rolling.force, 1.0, rtol=1e-12)
    hertz = (9.0 / (16.0 * 5e-3 * 4e6**2)) ** (1.0 / 3.0)
    np.testing.assert_allclose(rolling.depth[:9], hertz, rtol=1e-8)


@pytest.mark.slow
def test_the_friction_of_rubber_has_one_peak():
    v = np.logspace(-5, 5, 41)
    rubber = SlidingResistance(bed(StandardSolid(0.05, 0.45, 1.0)), Force(1e-3), v).solve()
    top = int(np.argmax(rubber.coefficient))
    assert 5 < top < 35
    assert np.all(np.diff(rubber.coefficient[: top + 1]) > 0.0)
    assert np.all(np.diff(rubber.coefficient[top:]) < 0.0)


def test_the_error_falls_with_the_square():
    def resistance(count):
        return SlidingResistance(bed(RUBBER, wk.PowerLaw(0.1, 3.3)), Depth(DEPTH), 0.1, count=count).solve()

    best = resistance(6400)
    errors = [abs(resistance(n).line_shear_force - best.line_shear_force) for n in (50, 100, 200)]
    assert errors[0] > 3.5 * errors[1] > 12.0 * errors[2]
    assert errors[2] < 1e-5 * best.line_shear_force


def love(x, y, h):
    """Sinking of a half-space with E* = 1 under a unit pressure on a square."""

    def corner(p, q):
        near = 1e-300
        return p * np.arcsinh(q / np.maximum(np.abs(p), near)) + q * np.arcsinh(p / np.maximum(np.abs(q), near))

    b = 0.5 * h
    return (corner(x + b, y + b) - corner(x - b, y + b) - corner(x + b, y - b) + corner(x - b, y - b)) / np.pi


def resistance_in_three_dimensions(creep, profile, force, speed, half, n):
    """Return F_x of a steadily sliding body from pressures on a grid, each square with its trace of creep."""
    h = 2.0 * half / n
    x, y = np.arange(-(n - 1), n)[:, None] * h, np.arange(n)[None, :] * h
    sinking = creep.glassy * love(x, y, h)
    node, weight = np.polynomial.legendre.leggauss(4)
    for compliance, time in zip(creep.compliances, creep.times, strict=True):
        length = speed * time
        distances = np.unique(np.concatenate([np.arange(2 * n) * h, 2 * n * h * 1.5 ** np.arange(40)]))
        distances = np.append(distances[distances < 40.0 * length], 40.0 * length)
        for low, high in zip(distances[:-1], distances[1:], strict=True):
            for s, part in zip(0.5 * (low + high) + 0.5 * (high - low) * node, weight, strict=True):
                share = compliance / length * math.exp(-s / length) * 0.5 * (high - low) * part
                sinking = sinking + share * love(x + s, y, h)
    c = (np.arange(n) - 0.5 * (n - 1)) * h
    r = np.hypot(c[:, None], c[None, :])
    height = profile.height(r)
    active = height < np.sort(height.ravel())[n * n // 3]
    for _ in range(60):
        i, j = np.nonzero(active)

        def block(k, m, i=i, j=j):
            return sinking[k[:, None] - i + n - 1, np.abs(m[:, None] - j)]

        matrix = np.zeros((i.size + 1, i.size + 1))
        matrix[:-1, :-1], matrix[:-1, -1], matrix[-1, :-1] = block(i, j), -1.0, h * h
        solution = np.linalg.solve(matrix, np.append(-height[i, j], force))
        pressure = np.zeros((n, n))
        pressure[i, j] = solution[:-1]
        k, m = np.nonzero(~active)
        overlap = np.zeros((n, n), dtype=bool)
        overlap[k, m] = height[k, m] + block(k, m) @ solution[:-1] < solution[-1]
        new = (active & (pressure > 0.0)) | overlap
        if np.array_equal(new, active):
            break
        active = new
    slope = profile.slope(r) * c[:, None] / r
    return float(np.sum(pressure * slope) * h * h)


@pytest.mark.parametrize("v", [0.1, 1.0, 10.0])
def test_the_share_of_the_line_is_that_of_the_waves_of_a_parabola(v):
    """The waves of 1 - x^2 are known in closed form; over them by an adaptive rule."""

    def square(k):
        return ((math.sin(k) - k * math.cos(k)) / k**3) ** 2 if k > 1e-3 else (1.0 - 0.1 * k * k) ** 2 / 9.0

    def ahead(k):
        turn = (k * v) ** 2
        return square(k) * turn / (1.0 + turn)

    def around(k):
        turn = (k * v) ** 2
        return square(k) * turn / (math.sqrt(1.0 + turn) * (1.0 + math.sqrt(1.0 + turn)))

    edges = [0.0, *np.geomspace(1e-3, 1.0, 7), *np.arange(3.0, 201.0, 2.0)]
    whole, part = (
        sum(quad(wave, *ends, epsrel=1e-11, epsabs=0.0)[0] for ends in itertools.pairwise(edges))
        for wave in (ahead, around)
    )
    x = np.linspace(-1.0, 1.0, 10_001)
    creep = CreepSeries(1.0, 0.0, np.array([2.0]), np.array([1.0]))
    assert share_of_line(creep, v, x, 1.0 - x * x) == pytest.approx(part / whole, rel=2e-6)


@pytest.mark.parametrize(
    ("glassy", "v", "allowed"),
    [
        (2.0, 0.1, 0.05),
        pytest.param(2.0, 0.3, 0.07, marks=pytest.mark.slow),
        (2.0, 3.0, 0.03),
        pytest.param(10.0, 0.1, 0.24, marks=pytest.mark.slow),
        (10.0, 1.0, 0.06),
        pytest.param(10.0, 10.0, 0.03, marks=pytest.mark.slow),
    ],
)
def test_three_dimensions(glassy, v, allowed):
    relaxed = 0.5 / glassy
    solid = StandardSolid(relaxed, 0.5 - relaxed, 1.0)
    force = 0.3 * 4.0 * relaxed
    line = SlidingResistance(bed(solid, wk.Paraboloid(1.0)), Force(force), v).solve()
    creep = ViscoelasticHalfSpace(solid).creep
    true = resistance_in_three_dimensions(creep, wk.Paraboloid(1.0), force, v, 1.15 * line.radius, 22)
    assert line.shear_force == pytest.approx(true, rel=allowed)
    assert 0.99 * true < line.line_shear_force < 2.02 * true


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: SlidingResistance(ELASTIC, Depth(0.1), 1.0), "HalfSpace"),
        (lambda: SlidingResistance(bed(RUBBER), Radius(0.1), 1.0), "give Depth"),
        (lambda: SlidingResistance(bed(RUBBER), Depth([0.1, 0.2]), 1.0), "one positive number"),
        (lambda: SlidingResistance(bed(RUBBER), Force(-1.0), 1.0), "one positive number"),
        (lambda: SlidingResistance(bed(RUBBER), Force(1.0), 0.0), "speed"),
        (lambda: SlidingResistance(bed(RUBBER), Force(1.0), "fast"), "speed"),
        (lambda: SlidingResistance(bed(RUBBER), Force(1.0), 1.0, count=2.5), "count"),
    ],
)  # fmt: skip
def test_wrong_input_is_refused(make, message):
    with pytest.raises(InvalidInput, match=message):
        make()


def test_what_is_outside_validity_is_refused():
    with pytest.raises(OutsideValidity, match="corner"):
        SlidingResistance(bed(RUBBER, wk.FlatPunch(0.1)), Depth(0.01), 1.0).solve()
    result = SlidingResistance(bed(RUBBER), Depth(0.01), [1.0, 2.0]).solve()
    with pytest.raises(InvalidInput, match="no speed 7"):
        result.line(7)
