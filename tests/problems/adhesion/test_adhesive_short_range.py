"""Adhesion of short range against closed forms at 30 digits: spheres, powers, cones, flats, graded and coated media."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

import winkler as wk
from winkler.foundation.measured import MeasuredBed
from winkler.laws.adhesion import DerjaguinMullerToporov, ShortRange
from winkler.materials.graded import PowerLawGraded
from winkler.materials.layered import Layer
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.problems.adhesion import griffith
from winkler.problems.adhesion.edge_states import ShortStates, force_of
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.problems.adhesion.pull_off import PullOff
from winkler.values.errors import InvalidInput, OutsideValidity

mp.mp.dps = 30
UNIT = wk.HalfSpace.between(wk.Elastic(young=1.0, poisson=0.0))
GEL = wk.HalfSpace.between(wk.Elastic(young=3e4, poisson=0.5))
E = 3e4 / 0.75
R, W = 2e-3, 0.04
BALL = wk.Foundation(wk.Paraboloid(R), GEL)
LAW = ShortRange(W)
GRIPS = math.inf


def ball(power_of_r, power_of_w, power_of_e):
    return R**power_of_r * W**power_of_w / E**power_of_e


def test_sphere_at_its_limits():
    """Theory 4: a, F and d of both limits, of no load and of no depth."""
    dead, grips = PullOff(BALL, LAW).solve(), PullOff(BALL, LAW, GRIPS).solve()
    a_f = (9.0 * math.pi / 8.0) ** (1 / 3) * ball(2 / 3, 1 / 3, 1 / 3)
    assert dead.radius == pytest.approx(a_f, rel=1e-12)
    assert dead.force == pytest.approx(-1.5 * math.pi * R * W, rel=1e-13)
    assert dead.depth == pytest.approx(-(a_f**2) / (3.0 * R), rel=1e-12)
    assert grips.radius == pytest.approx((math.pi / 8.0) ** (1 / 3) * ball(2 / 3, 1 / 3, 1 / 3), rel=1e-12)
    assert grips.force == pytest.approx(-5.0 / 6.0 * math.pi * R * W, rel=1e-12)
    assert grips.depth == pytest.approx(-0.75 * (math.pi**2 * W**2 * R / E**2) ** (1 / 3), rel=1e-13)
    free = AdhesiveIndentation(BALL, LAW, wk.Force(0.0)).solve()
    a_0 = (4.5 * math.pi) ** (1 / 3) * ball(2 / 3, 1 / 3, 1 / 3)
    assert free.radius == pytest.approx(a_0, rel=1e-13)
    assert free.depth == pytest.approx(a_0**2 / (3.0 * R), rel=1e-13)
    level = AdhesiveIndentation(BALL, LAW, wk.Depth(0.0)).solve()
    assert level.radius == pytest.approx((2.0 * math.pi) ** (1 / 3) * ball(2 / 3, 1 / 3, 1 / 3), rel=1e-13)
    assert level.force == pytest.approx(-4.0 / 3.0 * math.pi * R * W, rel=1e-13)
    assert free.pull_off == dead


def test_energies():
    """Jump into contact, work of pulling off, and what is left: theory 4, and by quadrature at 30 digits."""
    scale = (W**5 * R**4 / E**2) ** (1 / 3)

    def potential(load):
        contact = AdhesiveIndentation(BALL, LAW, load).solve()
        return (contact.energy - W * math.pi * contact.radius**2) / scale

    grips = PullOff(BALL, LAW, GRIPS).solve()
    jump_in, left = potential(wk.Depth(0.0)), potential(wk.Radius(grips.radius))
    # E* = R = w = 1: d = a^2 - sqrt(2 pi a), F = 4/3 a^3 - sqrt(8 pi a^3)
    depth = lambda a: a**2 - mp.sqrt(2 * mp.pi * a)  # noqa: E731
    force = lambda a: mp.mpf(4) / 3 * a**3 - mp.sqrt(8 * mp.pi * a**3)  # noqa: E731
    a_0, a_1 = mp.cbrt(mp.pi / 8), mp.cbrt(2 * mp.pi)
    work = -mp.quad(lambda a: force(a) * mp.diff(depth, a), [a_0, a_1])
    rest = mp.quad(lambda a: force(a) * mp.diff(depth, a), [mp.mpf(0), a_0 / 64, a_0])
    assert left - jump_in == pytest.approx(float(work), rel=1e-9)
    assert left == pytest.approx(float(rest), rel=1e-9)
    assert jump_in == pytest.approx(-6.418315112, abs=2e-9)
    assert left == pytest.approx(0.673880860, abs=2e-9)
    assert left - jump_in == pytest.approx(7.092195972, abs=2e-9)


def kappa(n):
    n = mp.mpf(n)
    return mp.sqrt(mp.pi) * n * mp.gamma(n / 2) / (2 * mp.gamma((n + 1) / 2))


@pytest.mark.parametrize("n", [0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0])
def test_powers(n):
    c, w = mp.mpf("0.3"), mp.mpf("0.02")
    k = kappa(n) * c
    bed = wk.Foundation(wk.PowerLaw(coefficient=0.3, exponent=n), UNIT)
    dead, grips = PullOff(bed, ShortRange(0.02)).solve(), PullOff(bed, ShortRange(0.02), GRIPS).solve()
    for result, factor, force in ((dead, 9, (2 * n - 1) / (2 * n + 2)), (grips, 1, (2 * n + 1) / (2 * n + 2))):
        a = (factor * mp.pi * w / (2 * mp.mpf(n) ** 2 * k**2)) ** (1 / (2 * mp.mpf(n) - 1))
        stretch = mp.sqrt(2 * mp.pi * a * w)
        assert result.radius == pytest.approx(float(a), rel=1e-11)
        assert result.force == pytest.approx(float(-2 * a * stretch * force), rel=1e-11)
        assert result.depth == pytest.approx(float(k * a**n - stretch), rel=1e-11)
    assert grips.depth == pytest.approx(float(-stretch * (2 * n - 1) / (2 * n)), rel=1e-11)


def test_cone_and_flat():
    angle = 1.2
    slope = 1.0 / math.tan(angle)
    cone = PullOff(wk.Foundation(wk.Cone(angle), GEL), LAW).solve()
    assert cone.radius == pytest.approx(18.0 * W / (math.pi * E * slope**2), rel=1e-12)
    assert cone.force == pytest.approx(-54.0 * W**2 / (math.pi * E * slope**3), rel=1e-12)
    for machine in (0.0, 1.0, GRIPS):  # Kendall 1971: whatever holds it
        flat = PullOff(wk.Foundation(wk.FlatPunch(1e-3), GEL), LAW, machine).solve()
        assert flat.force == pytest.approx(-math.sqrt(8.0 * math.pi * E * W * 1e-9), rel=1e-13)
        assert flat.radius == 1e-3


@pytest.mark.parametrize("machine", [0.0, 0.3, 3.0, 40.0, GRIPS])
def test_machine_stiffness(machine):
    """The sphere's limit on a machine, from theory 4's condition at 30 digits."""
    soft = 0.0 if machine == GRIPS else 1.0

    def condition(a):
        stretch = mp.sqrt(2 * mp.pi * a)
        first, second = 2 * a - stretch / (2 * a), 2 * (2 * a**2 - mp.mpf(3) / 2 * stretch)
        return first * (1 if not soft else mp.mpf(machine)) + soft * second

    a = mp.findroot(condition, (mp.mpf("0.7"), mp.mpf("1.6")), solver="anderson")
    result = PullOff(wk.Foundation(wk.Paraboloid(1.0), UNIT), ShortRange(1.0), machine).solve()
    assert result.radius == pytest.approx(float(a), rel=1e-12)


def shapes():
    """Profile, its g, and the integral of g, at 30 digits."""
    t = mp.mpf("0.1")
    angle = math.pi / 2 - math.atan(0.1)
    b = mp.mpf("0.2")
    yield (
        "exact sphere",
        wk.Sphere(1.0),
        lambda x: x * mp.atanh(x),
        None,
        (0.05, 0.3),
    )
    yield (
        "rounded cone",
        wk.RoundedCone(2.0, angle),
        lambda x: x**2 * t / b if x <= b else t * x * (x / b - mp.sqrt(x**2 / b**2 - 1) + mp.acos(b / x)),
        b,
        (0.21, 3.0),
    )
    yield (
        "truncated cone",
        wk.TruncatedCone(angle, 0.2),
        lambda x: 0 if x <= b else t * x * mp.acos(b / x),
        b,
        (0.2001, 3.0),
    )
    yield (
        "rounded punch",
        wk.RoundedPunch(0.2, 1.0),
        lambda x: 0 if x <= b else x * (mp.sqrt(x**2 - b**2) - b * mp.acos(b / x)),
        b,
        (0.2001, 1.5),
    )
    yield (
        "hyperboloid",
        wk.Hyperboloid(0.5, math.pi / 4),
        lambda x: x * mp.atan(x / mp.mpf("0.5")),
        None,
        (0.02, 0.9),
    )


@pytest.mark.few(3)
@pytest.mark.parametrize("case", list(shapes()), ids=lambda case: case[0])
def test_other_shapes(case):
    """d(a), F(a) and the dead load's limit: g at 30 digits, its integral by quadrature."""
    name, profile, g, kink, (low, high) = case
    w = mp.mpf("1e-4")

    def force(a):
        edges = [0, kink, a] if kink is not None and a > kink else [0, a]
        return 2 * a * (g(a) - mp.sqrt(2 * mp.pi * a * w)) - 2 * mp.quad(g, edges)

    bed = wk.Foundation(profile, UNIT)
    radii = np.linspace(low * 1.02, high, 7)
    contact = AdhesiveIndentation(bed, ShortRange(1e-4), wk.Radius(radii)).solve()
    np.testing.assert_allclose(contact.force, [float(force(mp.mpf(a))) for a in radii], rtol=1e-9, atol=1e-12)
    depth = [float(g(mp.mpf(a)) - mp.sqrt(2 * mp.pi * mp.mpf(a) * w)) for a in radii]
    np.testing.assert_allclose(contact.depth, depth, rtol=1e-10, atol=1e-14)
    result = PullOff(bed, ShortRange(1e-4)).solve()
    # between samples of the least force, then by golden section: not by a derivative
    nodes, weights = np.polynomial.legendre.leggauss(64)

    def quick(a):
        """F / E* in floating point, by quadrature in sqrt(x - edge)."""
        total = 0.0
        for start, stop in zip(
            [0.0, *([float(kink)] if kink and a > kink else [])],
            [*([float(kink)] if kink and a > kink else []), a],
            strict=True,
        ):
            t = 0.5 * (1.0 + nodes)
            x = start + (stop - start) * t**2
            total += float((weights * t * (stop - start)) @ np.array([float(g(mp.mpf(v))) for v in x]))
        return 2.0 * a * (float(g(mp.mpf(a))) - math.sqrt(2.0 * math.pi * a * 1e-4)) - 2.0 * total

    with mp.workdps(15):
        a = np.linspace(0.5 * low, high, 60)
        sampled = np.array([quick(x) for x in a])
        index = int(np.argmin(sampled[1:-1])) + 1
        left, right = a[index - 1], a[index + 1]
        ratio = 0.5 * (math.sqrt(5.0) - 1.0)
        for _ in range(34):
            one, two = right - ratio * (right - left), left + ratio * (right - left)
            left, right = (left, two) if quick(one) < quick(two) else (one, right)
    least = mp.mpf(0.5 * (left + right))
    if name == "truncated cone":  # the edge of the flat holds: F falls with a up to it, and rises beyond
        assert abs(least - kink) < 1e-6
        least = kink
    assert result.radius == pytest.approx(float(least), rel=3e-6)
    assert result.force == pytest.approx(float(force(least)), rel=1e-9)


@pytest.mark.parametrize("k", [-0.3, 0.0, 0.2, 0.5, 0.8, 1.0])
def test_graded(k):
    """Theory 8.1: a sphere comes off at (3 + k)/2 pi R w; where, for both controls."""
    poisson = 0.5 if k == 1.0 else 0.3
    medium = GradedHalfSpace.between(PowerLawGraded(young=1e6, depth_scale=1e-4, exponent=k, poisson=poisson))
    bed = wk.Foundation(wk.Paraboloid(R), medium)
    e = medium.modulus / 1e-4**k
    dead = PullOff(bed, LAW).solve()
    assert dead.force == pytest.approx(-0.5 * (3.0 + k) * math.pi * R * W, rel=1e-12)
    # a g' = (3+k)/2 l with g = a^2 / ((1+k) R), l = sqrt(2 pi a^(1-k) w / e)
    a = ((3.0 + k) * (1.0 + k) * R / 4.0 * math.sqrt(2.0 * math.pi * W / e)) ** (2.0 / (3.0 + k))
    assert dead.radius == pytest.approx(a, rel=1e-12)
    if k < 1.0:
        grips = PullOff(bed, LAW, GRIPS).solve()
        a = ((1.0 - k) * (1.0 + k) * R / 4.0 * math.sqrt(2.0 * math.pi * W / e)) ** (2.0 / (3.0 + k))
        assert grips.radius == pytest.approx(a, rel=1e-11)
    free = AdhesiveIndentation(bed, LAW, wk.Force(0.0)).solve()
    assert free.energy_release_rate == pytest.approx(W, rel=1e-12)
    if k == 0.0:
        assert free.stress_intensity == pytest.approx(math.sqrt(2.0 * medium.modulus * W), rel=1e-12)
    else:
        with pytest.raises(OutsideValidity, match="energy_release_rate"):
            _ = free.stress_intensity


def test_coated_between_its_limits():
    """Thin against the film: the film alone; wide: the base; between: F(a) has its least value at the limit."""
    film, base = wk.Elastic(5e6, 0.4), wk.Elastic(1e6, 0.4)
    medium = CoatedHalfSpace((Layer(film, 1e-4),), on=base)
    narrow = PullOff(wk.Foundation(wk.Paraboloid(1e-8), medium), ShortRange(1e-7)).solve()
    alone = PullOff(wk.Foundation(wk.Paraboloid(1e-8), wk.HalfSpace.between(film)), ShortRange(1e-7)).solve()
    assert narrow.force == pytest.approx(alone.force, rel=1e-9)
    assert narrow.radius == pytest.approx(alone.radius, rel=1e-5)
    same = wk.Foundation(wk.Paraboloid(2e-3), CoatedHalfSpace((Layer(base, 1e-4),), on=base))
    plain = PullOff(wk.Foundation(wk.Paraboloid(2e-3), wk.HalfSpace.between(base)), LAW).solve()
    assert PullOff(same, LAW).solve().radius == pytest.approx(plain.radius, rel=1e-9)
    bed = wk.Foundation(wk.Paraboloid(2e-3), medium)
    result = PullOff(bed, LAW).solve()
    a = result.radius * np.linspace(0.9, 1.1, 401)
    force = force_of(ShortStates(bed, W), a)
    assert abs(a[np.argmin(force)] / result.radius - 1.0) < 1e-3
    assert np.min(force) >= result.force * (1.0 + 1e-12)
    assert -2.0 < result.force / (math.pi * 2e-3 * W) < -1.0


@pytest.mark.slow
def test_coated_wide():
    """A contact a hundred times wider than the film is thick comes off as from the base."""
    base = wk.Elastic(1e6, 0.4)
    medium = CoatedHalfSpace((Layer(wk.Elastic(5e6, 0.4), 1e-4),), on=base)
    wide = PullOff(wk.Foundation(wk.Paraboloid(0.1), medium), ShortRange(40.0)).solve()
    plain = PullOff(wk.Foundation(wk.Paraboloid(0.1), wk.HalfSpace.between(base)), ShortRange(40.0)).solve()
    assert wide.force == pytest.approx(plain.force, rel=0.02)
    assert wide.radius == pytest.approx(plain.radius, rel=0.05)


def test_griffith_is_the_release_of_energy():
    """On every medium: G = -(dU/da at fixed d) / (2 pi a), U = Int k'(d-g)^2/2 by quadrature of its own."""
    graded = GradedHalfSpace.between(PowerLawGraded(1e6, 1e-4, 0.4, 0.3))
    coated = CoatedHalfSpace((Layer(wk.Elastic(5e6, 0.4), 1e-4),), on=wk.Elastic(1e6, 0.4))
    nodes, weights = np.polynomial.legendre.leggauss(60)
    for medium in (GEL, graded, coated):
        bed = wk.Foundation(wk.Sphere(R), medium)
        a, h = 1.2e-4, 1e-9
        d = float(griffith.depth_of(bed, W, np.array([a]))[0])

        def energy(end, bed=bed, d=d):
            # the part that moves with the edge only
            x = 1.1e-4 + (end - 1.1e-4) * 0.5 * (1.0 + nodes)
            return float(0.5 * (end - 1.1e-4) * weights @ (bed.normal_stiffness(x) * (d - bed.gap(x)) ** 2))

        # held at d, a wider contact stores more: what a receding edge sets free
        released = (energy(a + h) - energy(a - h)) / (2.0 * h) / (2.0 * math.pi * a)
        assert released == pytest.approx(W, rel=1e-7)
        h = 1e-6 * a
        states, places = ShortStates(bed, W), np.array([a - h, a + h])
        risen = states.depth(places), force_of(states, places)
        for values, slope in zip(risen, states.slopes(np.array([a])), strict=True):
            assert slope[0] == pytest.approx((values[1] - values[0]) / (2.0 * h), rel=1e-6)


def test_measured_bed_and_tip():
    a = np.geomspace(1e-6, 1e-3, 60)
    with pytest.raises(OutsideValidity, match="adhesion, whose edge runs round the contact, needs a round contact"):
        PullOff(MeasuredBed(a, 2.0 * E * a, a**2 / R), LAW)
    bed = MeasuredBed(a, 2.0 * E * a, a**2 / R, disc=True)
    assert PullOff(bed, LAW).solve().force == pytest.approx(-1.5 * math.pi * R * W, rel=1e-9)
    r = np.linspace(0.0, 1e-3, 400)
    tip = wk.Foundation(wk.Measured(r, r**2 / (2.0 * R)), GEL)
    assert PullOff(tip, LAW).solve().force == pytest.approx(-1.5 * math.pi * R * W, rel=1e-6)
    plane = wk.PlaneFoundation(wk.PowerLaw(coefficient=1.0 / R, exponent=2.0), GEL)
    assert PullOff(plane, LAW).solve().force == pytest.approx(-1.5 * math.pi * R * W, rel=1e-10)


def test_loads_agree_and_have_shapes():
    force = np.linspace(-1.49, 30.0, 24).reshape(4, 6) * math.pi * R * W
    by_force = AdhesiveIndentation(BALL, LAW, wk.Force(force)).solve()
    by_depth = AdhesiveIndentation(BALL, LAW, wk.Depth(by_force.depth)).solve()
    by_radius = AdhesiveIndentation(BALL, LAW, wk.Radius(by_force.radius)).solve()
    for other in (by_depth, by_radius):
        np.testing.assert_allclose(other.force, force, rtol=1e-9, atol=1e-12 * W * R)
        np.testing.assert_allclose(other.radius, by_force.radius, rtol=1e-9)
        assert other.stable.all()
        assert other.stable.shape == (4, 6)
    # JKR's own: a^3 = (3R/4E*)(F + 3 pi w R + sqrt(6 pi w R F + (3 pi w R)^2))
    p = 3.0 * math.pi * W * R
    a = (0.75 * R / E * (force + p + np.sqrt(2.0 * p * force + p * p))) ** (1 / 3)
    np.testing.assert_allclose(by_force.radius, a, rtol=1e-11)
    np.testing.assert_allclose(by_force.energy_release_rate, W, rtol=1e-11)
    np.testing.assert_allclose(by_force.stress_intensity, math.sqrt(2.0 * E * W), rtol=1e-11)
    numeric = np.gradient(by_force.force.ravel(), by_force.depth.ravel())
    np.testing.assert_allclose(by_force.stiffness.ravel()[8:-1], numeric[8:-1], rtol=2e-2)
    single = by_force.at((2, 3))
    assert isinstance(single.depth, float)
    assert single == AdhesiveIndentation(BALL, LAW, wk.Force(single.force)).solve()
    with pytest.raises(InvalidInput, match="pick one"):
        _ = by_force.pressed
    with pytest.raises(InvalidInput, match="no load"):
        by_force.at(7)


def test_between_the_limits_only_grips_hold():
    dead, grips = PullOff(BALL, LAW).solve(), PullOff(BALL, LAW, GRIPS).solve()
    a = 0.5 * (dead.radius + grips.radius)
    given = AdhesiveIndentation(BALL, LAW, wk.Radius(a)).solve()
    assert given.stable is False
    held = AdhesiveIndentation(BALL, LAW, wk.Depth(given.depth)).solve()
    assert held.radius == pytest.approx(a, rel=1e-12)
    assert held.stable is True
    assert held.stiffness < 0.0
    assert AdhesiveIndentation(BALL, LAW, wk.Radius(0.0)).solve().stable is False


def test_below_the_pull_off():
    limit = -1.5 * math.pi * R * W
    with pytest.raises(OutsideValidity, match=r"at index 1, 3 is below the pull-off") as caught:
        AdhesiveIndentation(BALL, LAW, wk.Force(np.array([0.0, 1.1, 0.9, 1.2]) * limit)).solve()
    assert f"{limit:.6g}" in str(caught.value)
    depth = -0.75 * (math.pi**2 * W**2 * R / E**2) ** (1 / 3)
    with pytest.raises(OutsideValidity, match="below the pull-off"):
        AdhesiveIndentation(BALL, LAW, wk.Depth(1.001 * depth)).solve()
    assert AdhesiveIndentation(BALL, LAW, wk.Force(limit)).solve().force == limit
    r = np.linspace(0.0, 1e-3, 40)
    tip = wk.Foundation(wk.Measured(r, r**2 / (2.0 * R)), GEL)
    with pytest.raises(OutsideValidity, match="reach"):
        AdhesiveIndentation(tip, LAW, wk.Force(1e3)).solve()
    with pytest.raises(OutsideValidity, match="reach"):
        AdhesiveIndentation(tip, LAW, wk.Radius(1.1e-3)).solve()
    with pytest.raises(OutsideValidity, match=r"r\^\(1/2\)"):
        PullOff(wk.Foundation(wk.PowerLaw(1.0, 0.5), UNIT), LAW).solve()
    with pytest.raises(InvalidInput, match="give Force, Depth or Radius"):
        AdhesiveIndentation(BALL, LAW, 3.0).solve()
    with pytest.raises(InvalidInput, match="law is a float"):
        AdhesiveIndentation(BALL, 0.1, wk.Force(1.0)).solve()
    with pytest.raises(InvalidInput, match="machine_stiffness"):
        PullOff(BALL, LAW, -1.0)


def test_rims_hold_the_edge():
    """A capped cylinder: free until the edge reaches the rim, then with k = 2 E* b, and G below w."""
    b = 1e-4
    bed = wk.Foundation(wk.CappedCylinder(b, wk.Paraboloid(R)), GEL)
    at_rim = AdhesiveIndentation(bed, LAW, wk.Radius(b)).solve()
    d = b**2 / R - math.sqrt(2.0 * math.pi * b * W / E)
    f = 2.0 * E * b * d - 2.0 * E * b**3 / (3.0 * R)
    assert (at_rim.depth, at_rim.force) == (pytest.approx(d, rel=1e-12), pytest.approx(f, rel=1e-12))
    pressed = AdhesiveIndentation(bed, LAW, wk.Force(f + np.array([0.0, 1e-3, 1e-2]))).solve()
    np.testing.assert_array_equal(pressed.radius, b)
    np.testing.assert_allclose(pressed.depth, d + np.array([0.0, 1e-3, 1e-2]) / (2.0 * E * b), rtol=1e-12)
    np.testing.assert_allclose(pressed.stiffness, 2.0 * E * b, rtol=1e-12)
    assert np.all(np.diff(np.abs(pressed.energy_release_rate - W)) > 0.0)
    by_depth = AdhesiveIndentation(bed, LAW, wk.Depth(pressed.depth)).solve()
    np.testing.assert_allclose(by_depth.force, pressed.force, rtol=1e-12)
    # the end face is wider than the plain ball's last contact: the rim alone holds
    assert PullOff(bed, LAW).solve().radius < b or PullOff(bed, LAW).solve().radius == b


def test_derjaguin_muller_toporov():
    law = DerjaguinMullerToporov(W)
    pull = 2.0 * math.pi * R * W
    contact = AdhesiveIndentation(BALL, law, wk.Force(np.array([-pull, 0.0, 5.0 * pull]))).solve()
    np.testing.assert_allclose(
        contact.radius, (0.75 * R / E * np.array([0.0, pull, 6.0 * pull])) ** (1 / 3), rtol=1e-12, atol=0.0
    )
    np.testing.assert_allclose(contact.depth, contact.radius**2 / R, rtol=1e-12)
    assert contact.pull_off.force == pytest.approx(-pull, rel=1e-15)
    assert (contact.pull_off.radius, contact.pull_off.depth) == (0.0, 0.0)
    assert np.all(contact.stress_intensity == 0.0)
    plain = wk.Indentation(BALL, wk.Force(6.0 * pull)).solve()
    r = np.linspace(0.0, 2.0, 9) * plain.radius
    np.testing.assert_allclose(
        wk.restore(contact.at(2), r).pressure, wk.restore(plain, r).pressure, rtol=1e-10, atol=1e-3
    )
    # an exact sphere and a sum have the same R at their apex
    for profile in (wk.Sphere(R), wk.Sum((wk.Paraboloid(2.0 * R), wk.Paraboloid(2.0 * R))), wk.RoundedCone(R, 1.2)):
        assert PullOff(wk.Foundation(profile, GEL), law).solve().force == pytest.approx(-pull, rel=1e-9)
    for profile in (wk.Cone(1.2), wk.FlatPunch(1e-3), wk.PowerLaw(1.0, 3.0), wk.TruncatedCone(1.2, 1e-5)):
        with pytest.raises(OutsideValidity, match="use ShortRange"):
            AdhesiveIndentation(wk.Foundation(profile, GEL), law, wk.Force(1.0)).solve()


def test_notes():
    contact = AdhesiveIndentation(BALL, LAW, wk.Force(0.0)).solve()
    message = " ".join(str(note) for note in contact.validity)
    assert "JKR" in message
    assert "steepest slope" in message
    assert "yield" not in message
    assert "stable under one load" not in message
    assert len(PullOff(BALL, LAW).solve().validity) >= 3
