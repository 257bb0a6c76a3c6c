"""Steady rolling under given forces: CONTACT's curve turned round, moments, saturation, and what it refuses."""

from __future__ import annotations

import csv

import numpy as np
import pytest

import winkler as wk
from winkler.numerics.surfaces.rolled_surface import roll
from winkler.problems.surface_rolling import creepages
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

RADIUS, MU = 100.0, 0.3


def pair(nu: float, shear: float = 1.0) -> wk.HalfSpace:
    body = wk.Elastic(2.0 * shear * (1.0 + nu), nu)
    return wk.HalfSpace(body, body)


MEDIUM = pair(0.3)
NORMAL = 4.0 / 3.0 * MEDIUM.modulus / RADIUS
BALL = wk.SampledProfile([2.4, 2.4], wk.Paraboloid(RADIUS), (30, 30))


def rolled(drive, **more):
    stated = {"topography": BALL, "medium": MEDIUM, "load": wk.Force(NORMAL), "friction": wk.Coulomb(MU)}
    return wk.SurfaceRolling(**(stated | more), drive=drive).solve()


@pytest.mark.slow
def test_the_creep_curve_of_contact_turned_round(shared_data):
    """Its forces give its creepages, as near as both codes agree at given creepages: 0.15 % of the friction."""
    file = shared_data / "reference" / "contact" / "creep_curve_ellipse.csv"
    rows = list(csv.DictReader(file.open().readlines()[1:]))
    creep, force = (np.array([abs(float(row[name])) for row in rows]) for name in ("creep_x", "force_x_N"))
    used = force < 0.99 * 0.33 * 106.7e3
    creep, force = creep[used], force[used]
    sides = np.array([6.304e-3, 12.61e-3]) * 2.0 * 52 / 44
    wheel = wk.SampledProfile(sides, wk.CurvedBodies(0.625, 1.77672), (52, 52))
    done = rolled(
        wk.CreepForce(force), topography=wheel, medium=pair(0.28, 82e9), load=wk.Force(106.7e3),
        friction=wk.Coulomb(0.33),
    )  # fmt: skip
    np.testing.assert_allclose(done.longitudinal_force, force, atol=1e-7 * 0.33 * 106.7e3)
    np.testing.assert_allclose(np.interp(done.longitudinal_creepage, creep, force), force, atol=1.5e-3 * 0.33 * 106.7e3)
    np.testing.assert_allclose(done.longitudinal_creepage, creep, rtol=0.02)
    np.testing.assert_allclose(done.lateral_creepage, 0.0, atol=1e-9)


@pytest.mark.slow
def test_few_rolls_find_them(monkeypatch):
    """A curve of forces takes some six rolls each, with no spin and with spin."""
    counted = []
    monkeypatch.setattr(creepages, "roll", lambda *given, **more: counted.append(1) or roll(*given, **more))
    push = np.array([0.1, 0.3, 0.5, 0.7, 0.9]) * MU * NORMAL
    rolled(wk.CreepForce(push, -0.2 * push))
    assert len(counted) <= 6 * push.size + 3
    counted.clear()
    rolled(wk.CreepForce(push, -0.2 * push, wk.Spin(2e-3)))
    assert len(counted) <= 10 * push.size + 3


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("seed", range(20))
def test_random_forces_and_back(seed):
    """The creepages that are found give the forces, and the stated misfit contains what is missing."""
    rng = np.random.default_rng(seed)
    most = MU * NORMAL
    push, towards = rng.uniform(0.0, 0.98, 5) * most, rng.uniform(0.0, 2.0 * np.pi, 5)
    along, across = push * np.cos(towards), push * np.sin(towards)
    spin = 10.0 ** rng.uniform(-5.0, -2.0, 5)
    moment = 0.2 * (most - push) * rng.uniform(-1.0, 1.0, 5)
    for twist in (wk.Spin(spin), wk.Torque(moment)):
        done = rolled(wk.CreepForce(along, across, twist))
        off = np.hypot(done.longitudinal_force - along, done.lateral_force - across) / most
        assert np.all(off <= 2.0**0.5 * done.misfit + 1e-12)
        assert np.all(done.misfit <= 1e-7)
        if isinstance(twist, wk.Torque):
            np.testing.assert_allclose(done.moment, moment, atol=1e-7 * most)
        else:
            np.testing.assert_array_equal(done.spin_creepage, spin)
        found = wk.Creepage(done.longitudinal_creepage, done.lateral_creepage, done.spin_creepage)
        again = rolled(found)
        for name in ("longitudinal_force", "lateral_force", "moment", "loss_per_distance"):
            size = most * (np.hypot(done.longitudinal_creepage, done.lateral_creepage) if "loss" in name else 1.0)
            np.testing.assert_allclose(getattr(again, name), getattr(done, name), atol=np.max(1e-4 * size))
        assert np.all(done.loss_per_distance > 0.0)


def test_a_spin_without_forces_drives_the_pair_aside():
    """Free to move, a spinning pair creeps so that no force is left; turned about, it creeps the other way."""
    done = rolled(wk.CreepForce(0.0, 0.0, wk.Spin([1e-4, -1e-4])))
    np.testing.assert_allclose(done.lateral_force, 0.0, atol=1e-7 * MU * NORMAL)
    assert done.lateral_creepage[0] == pytest.approx(-done.lateral_creepage[1], rel=1e-4)
    assert done.lateral_creepage[0] < 0.0
    np.testing.assert_allclose(done.longitudinal_creepage, 0.0, atol=1e-9)


@pytest.mark.slow
def test_forms_of_the_same_force():
    """A shear force is a creep force without spin; F_y mirrored mirrors the creepage."""
    push = 0.5 * MU * NORMAL
    short, long = rolled(wk.ShearForce([push, 0.3 * push])), rolled(wk.CreepForce(push, 0.3 * push))
    assert short.longitudinal_creepage == long.longitudinal_creepage
    assert rolled(wk.ShearForce(push)).lateral_force == pytest.approx(0.0, abs=1e-7 * push)
    mirrored = rolled(wk.CreepForce(push, -0.3 * push))
    assert mirrored.longitudinal_creepage == pytest.approx(long.longitudinal_creepage, rel=1e-5)
    assert mirrored.lateral_creepage == pytest.approx(-long.lateral_creepage, rel=1e-5)


@pytest.mark.slow
def test_friction_takes_what_forces_and_creepages_give():
    """The power of forces over creepages is that which the slip of all pixels takes, but for their size."""
    most, lost = MU * NORMAL, []
    for count in (30, 60):
        fine = wk.SampledProfile([2.4, 2.4], wk.Paraboloid(RADIUS), (count, count))
        done = rolled(wk.CreepForce(0.7 * most, 0.3 * most, wk.Spin(1e-3)), topography=fine)
        taken = float(np.sum(done.last.traction * done.last.creep)) * (2.4 / count) ** 2
        lost.append(1.0 - taken / float(done.loss_per_distance))
    assert 0.0 < lost[1] < 0.6 * lost[0] < 0.06


@pytest.mark.slow
def test_from_rest_under_a_force_and_a_spin():
    """Rolled far enough, the start is the steady state, which takes the slip of a spin a quarter of a pixel ahead."""
    most = MU * NORMAL
    ball = wk.SampledProfile([2.4, 2.4], wk.Paraboloid(RADIUS), (20, 20))
    stated = (ball, MEDIUM, wk.Force(NORMAL), wk.Coulomb(MU), wk.CreepForce(0.4 * most, 0.2 * most, wk.Spin(1e-3)))
    begun, steady = wk.SurfaceRollingStart(*stated, distance=5.0).solve(), wk.SurfaceRolling(*stated).solve()
    np.testing.assert_allclose(begun.longitudinal_force, 0.4 * most, rtol=1e-7)
    np.testing.assert_array_equal(begun.spin_creepage, [0.0, *[1e-3] * (begun.distance.size - 1)])
    assert begun.longitudinal_creepage[-1] == pytest.approx(steady.longitudinal_creepage, rel=2e-2)
    ahead = 0.25 * ball.pixel[0] * 1e-3
    assert begun.lateral_creepage[-1] == pytest.approx(steady.lateral_creepage + ahead, rel=3e-2)


@pytest.mark.slow
def test_from_rest_under_a_moment():
    """Without a force across there is no arm of a quarter of a pixel: the spin is that of steady rolling."""
    most = MU * NORMAL
    ball = wk.SampledProfile([2.4, 2.4], wk.Paraboloid(RADIUS), (20, 20))
    stated = (ball, MEDIUM, wk.Force(NORMAL), wk.Coulomb(MU), wk.CreepForce(0.0, 0.0, wk.Torque(0.1 * most)))
    begun, steady = wk.SurfaceRollingStart(*stated, distance=5.0).solve(), wk.SurfaceRolling(*stated).solve()
    np.testing.assert_allclose(begun.moment, 0.1 * most, rtol=1e-7)
    assert begun.spin_creepage[-1] == pytest.approx(steady.spin_creepage, rel=6e-2)


@pytest.mark.parametrize(("drive", "error", "sentence"), [
    (wk.CreepForce(MU * NORMAL), OutsideValidity,
     r"under the force \(.*, 0\) N with a spin of 0 1/m, a shear force of .* is prescribed, but the friction limit is"),
    (wk.CreepForce([0.0, 0.8 * MU * NORMAL], 0.8 * MU * NORMAL), OutsideValidity, "would slide away; give a smaller"),
    (wk.CreepForce(0.0, 0.0, wk.Torque(MU * NORMAL)), OutsideValidity, "would turn away; give a smaller one"),
])  # fmt: skip
def test_forces_that_friction_does_not_bear(drive, error, sentence):
    with pytest.raises(error, match=sentence):
        rolled(drive)


def test_forces_that_are_none():
    with pytest.raises(InvalidInput, match=r"shapes of F_x, F_y and the twist do not fit each other: \(2,\), \(3,\)"):
        wk.CreepForce([1.0, 2.0], [1.0, 2.0, 3.0])
    with pytest.raises(InvalidInput, match="several forces as CreepForce"):
        rolled(wk.ShearForce([1.0, 2.0, 3.0]))
    with pytest.raises(InvalidInput, match="CreepForce"):
        wk.CreepForce(np.inf)


def test_too_few_rolls_are_not_converged(monkeypatch):
    monkeypatch.setattr(creepages, "MOST_ROLLS", 1)
    with pytest.raises(NotConverged, match=r"under the force .* are missed by .* after 1 rolls; allowed are 1e-07"):
        rolled(wk.CreepForce(0.8 * MU * NORMAL))


def test_what_was_reached_of_many_forces():
    problem = wk.SurfaceRolling(
        BALL, MEDIUM, wk.Force(NORMAL), wk.Coulomb(MU), wk.CreepForce(np.array([1.0, 2.0, 3.0]) * 1e-1 * MU * NORMAL)
    )
    states = problem.steps()
    part = problem.gathered([next(states), next(states)])
    assert part.problem.drive == wk.CreepForce([0.1 * MU * NORMAL, 0.2 * MU * NORMAL], [0.0, 0.0], wk.Spin([0.0, 0.0]))
    assert part.longitudinal_creepage.shape == (2,)
