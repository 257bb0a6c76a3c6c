"""Height maps that attract each other, against closed forms, rings, springs and the balance of energies."""

from __future__ import annotations

import math
import tracemalloc

import numpy as np
import pytest
from attracted_rings import pull_off, walled_pull_off

import winkler as wk
from winkler.numerics.attracted.attraction import EightTwo, Exponential, RoundedStep
from winkler.problems.rough import map_memory
from winkler.problems.surface_adhesion import march
from winkler.problems.surface_adhesion.adhesion import memory_of
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

UNIT = wk.HalfSpace(wk.Elastic(1.0, 0.0))


def ball(count: int, radius: float, off: float = 0.0) -> wk.Topography:
    """Return a ball on pixels of one metre."""
    x = np.arange(count) - 0.5 * (count - 1) + off
    return wk.Topography(-(x[:, None] ** 2 + x**2) / (2.0 * radius), [count, count])


def spanned(law: type, span: float, tabor: float) -> tuple[wk.LennardJones | wk.ExponentialAttraction, float]:
    """Return a law whose zone spans these pixels of one metre at E* = 1, and the radius of such a ball."""
    peak = 16.0 / (9.0 * math.sqrt(3.0)) if law is wk.LennardJones else 1.0
    reach = 1e-3
    work = reach**2 / (span * peak**2)
    return law(work, reach), tabor**3 * reach**3 / work**2


def drawn_off(surface, law, depths, **more) -> wk.SurfaceAdhesionSolution:
    """Return the solution."""
    return wk.SurfaceAdhesion(surface, UNIT, law, wk.Depth(depths), **more).solve()


@pytest.mark.parametrize(
    ("law", "gaps"), [(Exponential(), (0.0, 9.0)), (EightTwo(), (0.7, 9.0)), (RoundedStep(0.4), (0.0, 2.0))]
)
def test_a_law_is_the_slope_of_its_energy(law, gaps):
    """The well is one deep, its slope is the pull, and the slope of that the stiffness."""
    gap, h = np.linspace(*gaps, 400), 1e-6
    above, below = law.terms(gap + h), law.terms(gap - h)
    np.testing.assert_allclose((above[0] - below[0]) / (2.0 * h), law.terms(gap)[1], atol=2e-9, rtol=1e-7)
    np.testing.assert_allclose((above[1] - below[1]) / (2.0 * h), law.terms(gap)[2], atol=5e-6, rtol=1e-6)
    assert law.terms(np.array([law.touch]))[0][0] == pytest.approx(-1.0, abs=1e-15)
    assert law.terms(np.array([1e9]))[0][0] == pytest.approx(0.0, abs=1e-15)
    assert np.max(law.terms(np.linspace(*gaps, 4001))[1]) == pytest.approx(law.peak, rel=1e-5)


@pytest.mark.slow
def test_pull_off_of_a_ball_under_the_lennard_jones_law():
    """As on rings, which know nothing of the grid, with a Tabor number of three halves."""
    law, radius = spanned(wk.LennardJones, 2.5, 1.5)
    found = drawn_off(ball(64, radius), law, 1e-3 * np.linspace(-0.5, -3.0, 11))
    assert found.pull_off_force == pytest.approx(-pull_off(1.5) * math.pi * radius * law.work, rel=5e-3)


@pytest.mark.parametrize(("tabor", "count"), [(1.0, 48), pytest.param(2.0, 128, marks=pytest.mark.long)])
def test_pull_off_of_a_ball_under_dugdales_stress(tabor, count):
    """As Maugis has it, by springs."""
    strength, work = 1.0, 1.0
    span = {1.0: 6.0, 2.0: 5.0}[tabor]
    scale = 1e-3
    strength, work = scale / span, scale**2 / span
    law = wk.Dugdale(work, strength)
    radius = tabor**3 * scale**3 / work**2
    found = drawn_off(ball(count, radius), law, scale * np.linspace(0.2, -2.0, 23))
    by_springs = wk.PullOff(wk.Foundation(wk.Paraboloid(radius), UNIT), law).solve().force
    assert found.pull_off_force == pytest.approx(by_springs, rel=8e-3)


@pytest.mark.parametrize(
    ("tabor", "count", "error"),
    [(2.5, 64, 4e-3), pytest.param(5.0, 256, 3e-3, marks=pytest.mark.long)],
)
def test_short_range_is_an_exponential_law(tabor, count, error):
    """As on rings, whose exponential law has the same range; above JKR's force, with the Tabor number stated."""
    work = 1e-6
    reach = math.sqrt(2.0 * work)
    radius = tabor**3 * reach**3 / work**2
    depths = reach * np.linspace(*((-0.5, -2.5) if tabor < 3.0 else (-2.0, -6.0)), 9)
    found = drawn_off(ball(count, radius), wk.ShortRange(work), depths)
    assert found.pull_off_force == pytest.approx(-walled_pull_off(tabor) * math.pi * radius * work, rel=error)
    assert found.pull_off_force < -1.5 * math.pi * radius * work
    assert found.problem.tabor == pytest.approx(tabor, rel=1e-9)
    assert any(f"Tabor number of {tabor:g}" in note.statement for note in found.validity)


@pytest.mark.parametrize(
    "count", [pytest.param(128, marks=pytest.mark.slow), pytest.param(256, marks=pytest.mark.long)]
)
def test_pull_off_without_range_is_that_of_jkr(count):
    """3/2 pi R w, of a ball off the middle of its pixels; on 256 its shortest range has a Tabor number of 5."""
    work, tabor = 1e-6, 5.0 * math.sqrt(count / 256.0)
    reach = math.sqrt(2.0 * work)
    radius = tabor**3 * reach**3 / work**2
    depths = wk.Depth(reach * (np.linspace(-3.0, -4.8, 7) if count == 256 else np.linspace(-2.0, -3.4, 7)))
    sticky = wk.SurfaceAdhesion(ball(count, radius, off=0.3), UNIT, wk.ShortRange(work), depths)
    limit = sticky.pull_off_without_range()
    closed = -1.5 * math.pi * radius * work
    assert limit.force == pytest.approx(closed, rel=5e-3)
    assert abs(limit.force - closed) < limit.error < 0.02 * abs(closed)
    assert limit.forces[1] < limit.forces[0] < 1.01 * closed
    assert limit.ranges == pytest.approx([math.sqrt(span * work) for span in (3.0, 6.0)], rel=1e-12)


@pytest.mark.parametrize(("tabor", "count"), [(2.01, 48), (2.01, 64), pytest.param(2.5, 96, marks=pytest.mark.slow)])
def test_the_error_without_range_holds_wherever_it_is_stated(tabor, count):
    """Of balls on pixels as coarse as are taken, the first of which ends where it still attracts, and finer ones."""
    limit = drawn_without_range(tabor, count).pull_off_without_range()
    closed = -1.5 * math.pi * 1e-6 * radius_of(tabor)
    assert abs(limit.force - closed) < limit.error < (0.1 if count == 48 else 0.035) * abs(closed)


@pytest.mark.parametrize("tabor", [0.3, 0.6, 1.0, 1.5, 1.99])
def test_pixels_that_do_not_tell_the_limit_without_range_are_refused(tabor):
    with pytest.raises(OutsideValidity, match=r"on a ball as curved as the map. .* follows from 2 on: use pixels"):
        drawn_without_range(tabor, 24).pull_off_without_range()


def radius_of(tabor: float) -> float:
    """Return the radius of a ball that has this number under a range whose zone is three pixels of one metre."""
    return tabor**3 * math.sqrt(3e-6) ** 3 / 1e-12


def drawn_without_range(tabor: float, count: int) -> wk.SurfaceAdhesion:
    """Return a ball that is drawn off."""
    depths = wk.Depth(math.sqrt(3e-6) * np.linspace(-1.0, -2.6, 9))
    return wk.SurfaceAdhesion(ball(count, radius_of(tabor), off=0.3), UNIT, wk.ShortRange(1e-6), depths)


def test_a_pull_off_without_range_needs_it_between_displacements():
    surface, law = ball(24, radius_of(2.1)), wk.ShortRange(1e-6)
    with pytest.raises(InvalidInput, match="lowest force is at the end of the path"):
        wk.SurfaceAdhesion(surface, UNIT, law, wk.Depth(1e-3 * np.array([0.0, -0.1]))).pull_off_without_range()
    ranged = wk.ExponentialAttraction(1e-6, 1e-2)
    with pytest.raises(InvalidInput, match="ExponentialAttraction has a range"):
        wk.SurfaceAdhesion(surface, UNIT, ranged, wk.Depth([0.0, -1e-3])).pull_off_without_range()


@pytest.mark.slow
def test_what_comes_off_is_no_snap_in():
    """Drawn apart from near full contact, where forces fall as stripes of pixels come off one after the other."""
    amplitude, count, wide = 1e-3, 64, 4
    x = (np.arange(count) + 0.5) / count
    wave = wk.Topography(
        amplitude * np.cos(2.0 * np.pi * x)[:, None] + np.zeros(wide), [1.0, wide / count], periodic=True
    )
    law = wk.ShortRange(0.5 * (0.5 * math.pi * amplitude) ** 2)
    path = amplitude * np.concatenate((np.linspace(-2.0, 0.95, 12), np.linspace(0.8, -3.0, 12)))
    jumps = drawn_off(wave, law, path).jumps
    assert [jump.closing for jump in jumps] == [True] + [False] * (len(jumps) - 1)
    assert any(jump.force_after < jump.force_before and jump.area_after < jump.area_before for jump in jumps[1:])


@pytest.mark.slow
def test_memory_is_counted():
    """What numpy held at most, of a map in part in touch, is less than what is stated, and not much less."""
    drawn_off(ball(16, 100.0), wk.ShortRange(1e-3), [0.0])  # what is imported is not counted
    for periodic in (False, True):
        rough = ball(96, 1e4)
        surface = wk.Topography(rough.heights, rough.lengths, periodic)
        stated = wk.SurfaceAdhesion(surface, UNIT, wk.ShortRange(1e-2), wk.Depth([0.03, 0.02, -0.1]))
        tracemalloc.start()
        try:
            stated.solve()
            most = tracemalloc.get_traced_memory()[1]
        finally:
            tracemalloc.stop()
        assert 0.4 * memory_of(surface) < most < memory_of(surface)


def test_a_map_for_which_too_little_memory_is_free_is_refused(monkeypatch):
    monkeypatch.setattr(map_memory, "STATED_BYTES", 0)
    monkeypatch.setattr(map_memory, "free_memory", lambda: 1000.0)
    with pytest.raises(InvalidInput, match=r"SurfaceAdhesion: a map of 16 x 16 pixels takes about 0.00019 GiB"):
        drawn_off(ball(16, 100.0), wk.ShortRange(1e-3), [0.0])


def test_what_does_not_deform():
    """Of rigid bodies the force is the sum of the stresses over the gaps; of a ball in touch 2 pi R w (DMT)."""
    stiff = wk.HalfSpace(wk.Elastic(1e6, 0.0))
    law, radius = wk.ExponentialAttraction(1e-3, 1.0), 10.0
    surface = ball(64, radius)
    depths = np.array([-3.0, -1.0, -1e-3])
    found = wk.SurfaceAdhesion(surface, stiff, law, wk.Depth(depths)).solve()
    gaps = surface.gaps - depths[:, None, None]
    np.testing.assert_allclose(found.force, -np.sum(1e-3 * np.exp(-gaps), axis=(1, 2)), rtol=1e-6)
    np.testing.assert_allclose(found.energy, -np.sum(1e-3 * np.exp(-gaps), axis=(1, 2)), rtol=1e-6)
    assert found.force[-1] == pytest.approx(-2.0 * math.pi * radius * 1e-3, rel=0.03)  # as many as pixels make it
    assert not found.jumps
    assert found.area[-1] == 0.0


@pytest.mark.parametrize(("count", "worst"), [(128, 0.03), pytest.param(512, 0.01, marks=pytest.mark.slow)])
def test_johnsons_sticky_wave(count, worst):
    """The mean pressure of a wavy surface without range, p* sin^2 A - sqrt(2 E* w tan A / lambda), A = pi a / lambda.

    K. L. Johnson, Int. J. Solids Struct. 32 (1995) 423-430, doi:10.1016/0020-7683(94)00111-9
    """
    amplitude, wide = 1e-3, 4
    x = (np.arange(count) + 0.5) / count
    wave = wk.Topography(
        amplitude * np.cos(2.0 * np.pi * x)[:, None] + np.zeros(wide), [1.0, wide / count], periodic=True
    )
    full = math.pi * amplitude  # at E* = 1 and lambda = 1
    work = 0.5 * (0.25 * full) ** 2
    path = wk.Depth(amplitude * np.linspace(0.8, -0.3, 12))
    found = wk.SurfaceAdhesion(wave, UNIT, wk.ShortRange(work), path).solve()
    touching = found.area / (wide / count)
    mean = found.force / (wide / count)
    angle = 0.5 * math.pi * touching
    closed = full * np.sin(angle) ** 2 - np.sqrt(2.0 * work * np.tan(angle))
    assert np.max(np.abs(mean - closed)) < worst * full
    every = np.linspace(1e-3, 0.25 * math.pi, 4001)
    torn = np.min(full * np.sin(every) ** 2 - np.sqrt(2.0 * work * np.tan(every)))
    assert np.min(mean) == pytest.approx(torn, rel=0.05)


@pytest.mark.slow
def test_energies_balance():
    """Force is the slope of the energy; over a loop the work that forces do is what jumps have lost."""
    law, radius = spanned(wk.ExponentialAttraction, 3.0, 2.0)
    fine = np.linspace(-4.0, 0.5, 91)
    depths = 1e-3 * np.concatenate((fine, fine[-2::-1]))
    found = drawn_off(ball(48, radius), law, depths)
    step = np.diff(depths)
    work = np.concatenate(([0.0], np.cumsum(0.5 * (found.force[1:] + found.force[:-1]) * step)))
    scale = np.max(np.abs(found.energy))
    kinds = [jump.closing for jump in found.jumps if jump.loss > 1e-2 * scale]
    assert kinds == [True, False]
    assert all(jump.loss > 0.0 for jump in found.jumps)
    np.testing.assert_allclose(work - found.dissipation, found.energy - found.energy[0], atol=0.015 * scale)
    assert found.dissipation[-1] == pytest.approx(work[-1], rel=0.05)
    slope = (found.energy[72:88] - found.energy[70:86]) / (depths[72:88] - depths[70:86])
    np.testing.assert_allclose(slope, found.force[71:87], atol=0.02 * np.max(np.abs(found.force)))
    assert found.energy_misfit[-1] < 0.01


def test_balance_by_the_sum_over_all_pixels():
    """Tractions displace the surface as Love has it, pull as the law where it gapes, and no more on the wall."""
    law, radius = spanned(wk.ExponentialAttraction, 2.5, 1.5)
    surface = ball(24, radius, off=0.3)
    state = drawn_off(surface, law, 1e-3 * np.array([0.0, -0.7])).last
    x = np.arange(24.0)
    i, j = (part.ravel() for part in np.meshgrid(x, x, indexing="ij"))

    def corner(u: np.ndarray, v: np.ndarray) -> np.ndarray:
        return u * np.arcsinh(v / np.abs(u)) + v * np.arcsinh(u / np.abs(v))

    u, v = i[:, None] - i, j[:, None] - j
    love = (
        corner(u + 0.5, v + 0.5) - corner(u - 0.5, v + 0.5) - corner(u + 0.5, v - 0.5) + corner(u - 0.5, v - 0.5)
    ) / math.pi
    p, gap = state.pressure.ravel(), state.separation.ravel()
    np.testing.assert_allclose(surface.gaps.ravel() - state.depth + love @ p, gap, atol=1e-9)
    pull = law.strength * np.exp(-gap / law.range)
    away = gap > 0.0
    assert 0 < np.count_nonzero(~away) < 300
    np.testing.assert_allclose(p[away], -pull[away], atol=2e-6 * law.strength)
    assert np.all(p[~away] >= -pull[~away] * (1.0 + 1e-6))
    assert state.force == pytest.approx(float(np.sum(p)), rel=1e-12)


def test_retraction_pulls_more_than_approach():
    """A rough periodic map has a loop; far away nothing is left."""
    rough = wk.random_topography(
        wk.SelfAffine(0.8, rms_height=0.5e-6, longest=2e-4, shortest=50e-6), (48, 48), [4e-4, 4e-4], seed=4
    )
    law = wk.ExponentialAttraction(0.05, 0.8e-6)
    depths = 1e-6 * np.array([-6.0, -2.0, -1.0, 0.0, 0.5, 0.0, -1.0, -2.0, -9.0])
    found = wk.SurfaceAdhesion(rough, wk.HalfSpace(wk.Elastic(1e6, 0.5)), law, wk.Depth(depths)).solve()
    assert np.all(found.force[5:7] <= found.force[[3, 2]])
    assert found.force[6] < 1.05 * found.force[2]
    assert found.dissipation[-1] > 0.0
    assert abs(found.force[-1]) < 1e-3 * abs(found.pull_off_force)
    assert float(np.mean(found.last.pressure)) * rough.area == pytest.approx(found.force[-1], rel=1e-12)
    assert np.max(found.residual) <= 1e-6


def test_where_all_pixels_touch():
    """Pressed so deep that the border touches, the force is that of the map without attraction, less the attraction."""
    surface, medium = ball(24, 100.0), wk.HalfSpace(wk.Elastic(1.0, 0.0))
    law = wk.ExponentialAttraction(1e-9, 1e-3)
    found = wk.SurfaceAdhesion(surface, medium, law, wk.Depth([9.0])).solve()
    assert np.all(found.last.separation == 0.0)
    assert found.residual[-1] <= 1e-6
    bare = wk.SurfaceContact(surface, medium, wk.Depth(9.0), tolerance=1e-9).solve()
    assert found.force[-1] == pytest.approx(float(bare.force), rel=1e-6)


def test_refusals():
    """One sentence each: zones below the grid, hysteresis of the law, closed maps, missing heights, no row."""
    surface, radius = ball(16, 100.0), 100.0
    with pytest.raises(OutsideValidity, match=r"1e-07 m, 1e-07 pixels. This law needs 2, .*a range of at least"):
        drawn_off(surface, wk.ExponentialAttraction(1e-3, 1e-5), [0.0])
    with pytest.raises(OutsideValidity, match="This law needs 4"):
        drawn_off(surface, wk.Dugdale(1e-3, 1.0), [0.0])
    with pytest.raises(OutsideValidity, match=r"needs 2\.5.*a spacing of at least"):
        drawn_off(surface, wk.LennardJones(1e-3, 1e-3), [0.0])
    with pytest.raises(InvalidInput, match="no energy to be minimal"):
        drawn_off(surface, wk.ShortRange(work_closing=1e-4, work_opening=1e-3), [0.0])
    with pytest.raises(InvalidInput, match="one after the other"):
        wk.SurfaceAdhesion(surface, UNIT, wk.ShortRange(1e-3), wk.Depth([[0.0, 1.0]]))
    wave = wk.Topography(surface.heights, surface.lengths, periodic=True)
    with pytest.raises(OutsideValidity, match="closes the periodic map"):
        drawn_off(wave, wk.ShortRange(1e-3), [0.0, radius])
    holed = wk.Topography(np.where(surface.heights == surface.heights.max(), np.nan, surface.heights), [16, 16])
    with pytest.raises(InvalidInput, match="4 of 256 heights are missing"):
        drawn_off(holed, wk.ShortRange(1e-3), [0.0])


def test_an_unreachable_balance_is_named(monkeypatch):
    """Where no rest is found, the displacement is named."""

    def nowhere(*_: object) -> None:
        raise NotConverged("tractions are out of balance by 1")

    monkeypatch.setattr(march.AdhesionMarch, "go", nowhere)
    with pytest.raises(NotConverged, match=r"at index 1 of the path \(-1 m\) tractions"):
        drawn_off(ball(16, 100.0), wk.ShortRange(1e-3), [0.0, -1.0])
