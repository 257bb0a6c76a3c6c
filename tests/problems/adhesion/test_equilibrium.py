"""The whole curve of equilibrium: every branch and jump against brute-force searches with formulas of their own."""

from __future__ import annotations

import functools
import math

import numpy as np
import pytest
from scipy.special import struve

import winkler as wk
from winkler.laws.adhesion import DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.problems.adhesion.equilibrium import Equilibrium
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.problems.adhesion.pull_off import PullOff
from winkler.values.errors import InvalidInput, OutsideValidity

UNIT = wk.HalfSpace.between(wk.Elastic(young=1.0, poisson=0.0))
GRIPS = math.inf


class Guduru:
    """E* = R = 1: g, its integral and derivative with Struve's functions, and what follows from them."""

    def __init__(self, amplitude, wavelength, work):
        self.h, self.length, self.w = amplitude, wavelength, work
        self.k = 2.0 * math.pi / wavelength
        profile = wk.Sum((wk.Paraboloid(1.0), wk.Wavy(amplitude, wavelength)))
        self.bed, self.law = wk.Foundation(profile, UNIT), ShortRange(work)

    def depth(self, a):
        t = self.k * a
        return a**2 + 0.5 * math.pi * self.h * t * struve(0, t) - np.sqrt(2.0 * math.pi * a * self.w)

    def force(self, a):
        t = self.k * a
        gaps = a**3 / 3.0 + 0.5 * math.pi * self.h * a * struve(1, t)
        return 2.0 * a * self.depth(a) - 2.0 * gaps

    @functools.cache  # noqa: B019
    def levels(self, machine, reach, count):
        """Dense samples of the position of the machine."""
        a = np.linspace(0.0, reach, count)[1:]
        return a, self.depth(a) if machine == GRIPS else self.force(a) + machine * self.depth(a)

    def rising(self, machine, reach, count):
        """Stable stretches by brute force: where the position of the machine grows between dense samples."""
        a, level = self.levels(machine, reach, count)
        up = np.diff(level) > 0.0
        edges = np.flatnonzero(up[1:] != up[:-1]) + 1
        limits = a[edges]
        limits = np.concatenate([[a[0]] if up[0] else [], limits, [reach] if up[-1] else []])
        return limits[0::2], limits[1::2], a[1] - a[0]


@pytest.mark.few(2, slow=3)
@pytest.mark.parametrize("machine", [GRIPS, 0.0, 0.05])
@pytest.mark.parametrize(
    ("amplitude", "wavelength", "work", "reach"),
    [
        (1e-4, 0.02, 1e-4, 0.3),
        (1e-4, 0.02, 1e-6, 0.4),
        (5e-5, 0.01, 1e-6, 0.5),
        (1e-4, 0.1, 1e-4, 1.0),
        (1e-4, 0.01, 1e-7, 1.0),  # a hundred waves
    ],
)
def test_wavy_branches(amplitude, wavelength, work, reach, machine):
    case = Guduru(amplitude, wavelength, work)
    starts, stops, step = case.rising(machine, reach, 40_001)
    curve = Equilibrium(case.bed, case.law, reach, machine).solve()
    assert len(curve.starts) == len(starts)
    np.testing.assert_allclose(curve.starts, starts, atol=2.0 * step)
    np.testing.assert_allclose(curve.stops, stops, atol=2.0 * step)
    np.testing.assert_allclose(curve.depth[1:], case.depth(curve.radius[1:]), rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(curve.force[1:], case.force(curve.radius[1:]), rtol=1e-9, atol=1e-13)


def follow(case, machine, reach, count=50_001):
    """Pull off from `reach` by brute force: descend along the samples, jump to the next place that is as low."""
    a, level = case.levels(machine, reach, count)
    at, jumps = count - 2, []
    while True:
        falling = np.flatnonzero(np.diff(level[: at + 1]) <= 0.0)
        at = falling[-1] + 1 if falling.size else 0  # the last sample before which the level no longer falls
        inside = np.flatnonzero(level[:at] <= level[at])
        inside = inside[inside < at - 1]
        # skip the flat bottom: the level must first have risen inward
        lower = inside[-1] if inside.size else -1
        jumps.append((a[at], a[lower] if lower >= 0 else 0.0))
        if lower < 0:
            return jumps
        at = lower


@pytest.mark.few(1)
@pytest.mark.parametrize("machine", [GRIPS, 0.0])
def test_wavy_jumps(machine):
    case = Guduru(1e-4, 0.02, 1e-4)
    expected = follow(case, machine, 0.3)
    curve = Equilibrium(case.bed, case.law, 0.3, machine).solve()
    jumps = {round(jump.start, 4): jump for jump in curve.jumps if jump.stop < jump.start}
    assert len(expected) >= 5
    for start, stop in expected:
        jump = min(jumps.values(), key=lambda jump, start=start: abs(jump.start - start))
        assert jump.start == pytest.approx(start, abs=2e-5)
        if stop == 0.0 or jump.stop == 0.0:
            assert stop == 0.0 == jump.stop or stop < 1e-3
        else:
            assert jump.stop == pytest.approx(stop, abs=5e-5)
    held = (
        (lambda jump: (jump.start_depth, jump.stop_depth))
        if machine == GRIPS
        else (lambda jump: (jump.start_force, jump.stop_force))
    )
    for jump in curve.jumps:
        if jump.stop > 0.0:
            before, after = held(jump)
            assert after == pytest.approx(before, rel=1e-9, abs=1e-12)
    assert any(jump.stop > jump.start for jump in curve.jumps)
    last = PullOff(case.bed, case.law, machine).solve()
    level = [branch.start_depth if machine == GRIPS else branch.start_force for branch in curve.branches]
    assert (last.depth if machine == GRIPS else last.force) == pytest.approx(min(level), rel=1e-12)


def test_the_widest_of_many():
    """Of several stable contacts under one load the widest is returned, and the notes count them."""
    case = Guduru(1e-4, 0.02, 1e-4)
    force = -3e-4
    a, level = case.levels(0.0, 0.4, 40_001)
    crossing = np.flatnonzero((level[:-1] < force) & (level[1:] >= force))
    assert crossing.size > 1
    contact = AdhesiveIndentation(case.bed, case.law, wk.Force(force)).solve()
    assert contact.radius == pytest.approx(a[crossing[-1]], abs=2e-5)
    assert any(f"Up to {crossing.size} contact radii" in str(note) for note in contact.validity)
    many = AdhesiveIndentation(case.bed, case.law, wk.Depth(np.linspace(-0.0035, 0.05, 200))).solve()
    np.testing.assert_allclose(case.depth(many.radius), many.depth, rtol=1e-9, atol=1e-12)
    assert np.all(np.diff(many.radius) > 0.0)


def test_a_kink_holds_the_edge():
    """A truncated cone: the edge of its flat is a limit of its own, beside that of the cone."""
    slope, b = 0.1, 0.2
    bed = wk.Foundation(wk.TruncatedCone(math.pi / 2 - math.atan(slope), b), UNIT)
    curve = Equilibrium(bed, ShortRange(1e-4), 3.0, 0.0).solve()
    assert curve.starts[0] == b
    assert curve.branches[0].start_force == pytest.approx(-math.sqrt(8.0 * math.pi * 1e-4 * b**3), rel=1e-12)
    # more adhesion: the edge holds only a little, and the cone's own limit lies far out
    curve = Equilibrium(bed, ShortRange(3e-3), 3.0, 0.0).solve()
    a = np.geomspace(b * (1.0 + 1e-9), 3.0, 400_000)
    g = slope * a * np.arccos(b / a)
    whole = slope * 0.5 * (a**2 * np.arccos(b / a) - b * np.sqrt(a**2 - b**2))
    force = 2.0 * a * (g - np.sqrt(2.0 * math.pi * a * 3e-3)) - 2.0 * whole
    up = np.diff(force) > 0.0
    limits = a[np.flatnonzero(up[1:] != up[:-1]) + 1]
    result = np.array([x for branch in curve.branches for x in (branch.start, branch.stop)])
    assert result[0] == b
    assert result[-1] == 3.0
    np.testing.assert_allclose(result[1:-1], limits, rtol=1e-4)


def test_stable_points_and_shapes():
    bed, law = wk.Foundation(wk.Paraboloid(1.0), UNIT), ShortRange(1.0)
    curve = Equilibrium(bed, law, 5.0, count=200).solve()
    assert curve.radius.shape == curve.depth.shape == curve.force.shape == curve.stable.shape
    assert 200 <= curve.radius.size <= 202
    np.testing.assert_array_equal(curve.stable, curve.radius >= curve.starts[0])
    assert (curve.radius[0], curve.depth[0], curve.force[0]) == (0.0, pytest.approx(0.0, abs=1e-70), 0.0)
    (lost,) = curve.jumps
    assert (lost.stop, lost.stop_force, lost.stop_depth) == (0.0, 0.0, lost.start_depth)
    assert Equilibrium(bed, law, 0.1).solve().branches == ()
    assert hash(Equilibrium(bed, law, 5.0).solve()) == hash(Equilibrium(bed, law, 5.0).solve())
    flat = Equilibrium(wk.Foundation(wk.FlatPunch(1.0), UNIT), law, 1.0).solve()
    assert [(branch.start, branch.stop) for branch in flat.branches] == [(1.0, 1.0)]


def test_other_laws():
    bed = wk.Foundation(wk.Paraboloid(1.0), UNIT)
    far = Equilibrium(bed, DerjaguinMullerToporov(1.0), 3.0).solve()
    assert [(branch.start, branch.stop) for branch in far.branches] == [(0.0, 3.0)]
    assert far.jumps == ()
    np.testing.assert_allclose(far.force, 4.0 / 3.0 * far.radius**3 - 2.0 * math.pi, rtol=1e-12)
    ring = Equilibrium(bed, Dugdale(1.0, 1.0), 3.0, 0.0, count=300).solve()
    level = ring.force
    up = np.flatnonzero(np.diff(level) > 0.0)
    assert ring.starts[0] == pytest.approx(ring.radius[up[0]], abs=0.05)
    assert ring.starts[0] == PullOff(bed, Dugdale(1.0, 1.0)).solve().radius


def test_refusals():
    bed, law = wk.Foundation(wk.Paraboloid(1.0), UNIT), ShortRange(1.0)
    for reach in (0.0, -1.0, math.inf, math.nan, "1 mm"):
        with pytest.raises(InvalidInput, match="reach"):
            Equilibrium(bed, law, reach)
    with pytest.raises(InvalidInput, match="count"):
        Equilibrium(bed, law, 1.0, count=1)
    with pytest.raises(OutsideValidity, match="beyond the end"):
        Equilibrium(wk.Foundation(wk.FlatPunch(1.0), UNIT), law, 1.1)
    with pytest.raises(OutsideValidity, match="rises for good"):
        AdhesiveIndentation(wk.Foundation(wk.Wavy(1e-4, 0.01), UNIT), ShortRange(1e-7), wk.Force(0.0)).solve()
