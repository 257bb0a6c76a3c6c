"""Many contacts at once: against the exact solver of one direction, published impacts, and the law of energy."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.laws.friction import Coulomb
from winkler.loading.path import Path
from winkler.problems.friction.tangential import Tangential
from winkler.problems.impact.impact import Impact
from winkler.problems.particles.contacts import Contacts
from winkler.problems.particles.impacts import BallImpacts
from winkler.values.validity import Standing, worst

STEEL = wk.HalfSpace.between(wk.Elastic(2.0, 0.3), wk.Elastic(2.0, 0.3))
MU = 0.3
BETA = MU * STEEL.modulus / STEEL.shear_modulus
MAW = {
    0.1: 0.0206, 0.5: 0.0480, 1.0: -0.0596, 1.5: -0.4280, 2.0: -0.8372, 3.0: -1.3797, 4.0: -1.4365, 4.5: -1.2176,
    5.0: -0.7647, 6.0: 0.2353,
}  # fmt: skip
"""Maw, Barber and Fawcett: sliding velocity after over before an impact at nu = 0.3, in their units."""


def apart(many=1, *, count=32, reach=0.011, arm=0.0) -> Contacts:
    return Contacts.apart(
        STEEL, curvature_radius=np.ones(many), coefficient=MU, reach=reach, rolling_arm=arm, count=count
    )


def history(seed: int, many: int, steps: int):
    """Return depths, motions, twists and rolls of contacts that press, slide, part and touch again."""
    rng = np.random.default_rng(seed)
    depth = rng.uniform(-0.003, 0.01, (many, steps))
    motion = rng.normal(size=(many, steps, 2)) * 0.004
    twist = rng.normal(size=(many, steps)) * 0.05
    return depth, motion, twist, rng.normal(size=(many, steps, 2)) * 0.02


def cut(depth, motion, twist, roll, parts):
    """Return the same history with every step in equal parts."""
    start = np.concatenate([np.zeros((len(depth), 1)), depth[:, :-1]], axis=1)
    share = np.arange(1, parts + 1) / parts
    fine = start[:, :, None] + (depth - start)[:, :, None] * share
    many = len(depth)
    return (
        fine.reshape(many, -1),
        np.repeat(motion / parts, parts, axis=1),
        np.repeat(twist / parts, parts, axis=1),
        np.repeat(roll / parts, parts, axis=1),
    )


# ---------------------------------------------------------------------------------------------------------------------
# forces


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_one_direction_agrees_with_the_exact_solver(seed):
    rng = np.random.default_rng(seed)
    depth, shift = rng.uniform(0.003, 0.01, 40), np.cumsum(rng.normal(size=40)) * 0.3 * BETA * 0.01
    bed = wk.Foundation(wk.Paraboloid(1.0), STEEL)
    exact = Tangential(bed, Coulomb(MU), Path(np.arange(40.0), wk.Depth(depth), wk.Shift(shift))).solve()
    errors = []
    for count in (32, 128):
        first = apart(count=count).moved([depth[0]])
        motion = np.zeros((1, 40, 2))
        motion[0, :, 0] = np.diff(shift, prepend=0.0)
        _, trace = first.along(depth[np.newaxis], motion=motion)
        most = MU * np.max(exact.force)
        errors.append(np.max(np.abs(trace.shear_force[0, :, 0] - exact.shear_force)) / most)
        assert trace.force[0] == pytest.approx(exact.force, rel=1e-12)
        assert trace.dissipation[0] == pytest.approx(exact.dissipation, abs=2e-3 * exact.dissipation[-1])
        assert np.all(trace.shear_force[:, :, 1] == 0.0)
    assert errors[0] < 1e-3
    assert errors[1] < errors[0] / 8.0


def test_in_one_direction_no_step_is_too_long():
    """Cut into seven, a step ends with the same force, heat and memory: each was followed exactly."""
    depth, motion, twist, roll = history(8, 40, 30)
    motion[:, :, 1] = 0.0
    whole, trace = apart(40).along(depth, motion=motion)
    d, m, *_ = cut(depth, motion, twist, roll, 7)
    parts, fine = apart(40).along(d, motion=m)
    assert fine.shear_force[:, 6::7] == pytest.approx(trace.shear_force, abs=1e-13)
    assert fine.dissipation[:, 6::7] == pytest.approx(trace.dissipation, rel=1e-9, abs=1e-17)
    assert parts.displaced == pytest.approx(whole.displaced, abs=1e-14)


def test_without_friction_nothing_is_borne():
    slippery = Contacts.apart(STEEL, curvature_radius=[1.0], coefficient=0.0, reach=0.01)
    slippery = slippery.moved([0.005], motion=[[1e-3, 2e-3]], twist=[0.1]).moved([0.007], motion=[[-1e-3, 0.0]])
    assert np.all(slippery.shear_force == 0.0)
    assert np.all(slippery.torque == 0.0)
    assert np.all(slippery.dissipation == 0.0)


def test_no_contacts_at_all():
    after, trace = apart(0).along(np.zeros((0, 3)))
    assert after.force.shape == (0,)
    assert trace.dissipation.shape == (0, 3)


def test_any_direction_alike():
    """A history along a slanted line is that along x, turned."""
    depth, motion, *_ = history(5, 20, 30)
    motion[:, :, 1] = 0.0
    _, straight = apart(20).along(depth, motion=motion)
    turned = np.stack([0.6 * motion[:, :, 0], 0.8 * motion[:, :, 0]], axis=-1)
    _, slanted = apart(20).along(depth, motion=turned)
    assert slanted.shear_force @ np.array([0.6, 0.8]) == pytest.approx(straight.shear_force[:, :, 0], abs=1e-14)
    assert slanted.shear_force @ np.array([0.8, -0.6]) == pytest.approx(0.0, abs=1e-14)
    assert slanted.dissipation == pytest.approx(straight.dissipation, abs=1e-16)


def test_sliding_all_over():
    contacts = apart(3).moved([0.01, 0.004, 0.001]).moved([0.01, 0.004, 0.001], motion=[[0.3, 0.4]] * 3)
    size = np.hypot(*contacts.shear_force.T)
    assert np.abs(size / (MU * contacts.force) - 1.0) == pytest.approx(0.0, abs=5e-3)
    # a sum of midpoints over a parabola that ends between two: a quarter of the squared spacing, and little more
    assert abs(size[0] / (MU * contacts.force[0]) - 1.0) < 0.26 / 32**2 * (0.011 / 0.01)
    assert contacts.shear_force[:, 1] / contacts.shear_force[:, 0] == pytest.approx(4.0 / 3.0, rel=1e-12)


def test_turning_in_the_plane_converges_with_the_steps():
    angle = np.linspace(0.0, 4.0 * np.pi, 33)[1:]
    around = 0.4 * BETA * 0.01 * np.stack([np.cos(angle) - 1.0, np.sin(angle)], axis=-1)
    motion = np.diff(around, axis=0, prepend=np.zeros((1, 2)))[np.newaxis]
    depth = np.full((1, 32), 0.01)
    still = np.zeros((1, 32))
    forces = []
    for parts in (1, 4, 16, 64, 256):
        d, m, *_ = cut(depth, motion, still, np.zeros((1, 32, 2)), parts)
        after, _ = apart().moved([0.01]).along(np.full_like(d, 0.01), motion=m)
        forces.append(after.shear_force[0])
    misses = [np.linalg.norm(force - forces[-1]) for force in forces[:-1]]
    assert misses[1] < 0.4 * misses[0]
    assert misses[3] < 0.4 * misses[2]
    assert misses[2] < 0.01 * np.linalg.norm(forces[-1])


# ---------------------------------------------------------------------------------------------------------------------
# energy


@pytest.mark.parametrize("seed", range(4))
def test_no_history_creates_energy(seed):
    depth, motion, twist, roll = history(seed, 200, 60)
    _, trace = apart(200, arm=0.01).along(depth, motion=motion, twist=twist, roll=roll)
    assert np.min(np.diff(trace.dissipation, axis=1, prepend=0.0)) >= 0.0
    assert np.min(trace.dissipation[:, -1]) > 0.0
    # a sum over midpoints exceeds the friction force most where one spring alone is in contact, at sqrt(3)/2 spacings:
    # 2/sqrt(3) times; where n are, by 1/8n^2
    friction = MU * trace.force
    size = np.hypot(*np.moveaxis(trace.shear_force, -1, 0))
    assert np.all(size <= (2.0 / math.sqrt(3.0) + 1e-12) * friction)
    wide = depth > 0.0025
    assert np.all(size[wide] <= (1.0 + 0.126 / 15.0**2) * friction[wide])
    apart_now = depth <= 0.0
    assert np.all(trace.stored_energy[apart_now] == 0.0)
    assert np.all(trace.shear_force[apart_now] == 0.0)


def test_the_work_is_stored_or_lost():
    """The trapezium of force times motion approaches what is stored and lost, with the steps, for every contact."""
    given = history(11, 50, 20)
    misses = []
    for parts in (20, 80, 320):
        depth, motion, twist, roll = cut(*given, parts)
        _, trace = apart(50, arm=0.01).along(depth, motion=motion, twist=twist, roll=roll)
        work = np.zeros(50)
        for borne, moved in (
            (trace.shear_force, motion),
            (trace.torque[:, :, np.newaxis], twist[:, :, np.newaxis]),
            (trace.rolling_moment, roll),
        ):
            before = np.concatenate([np.zeros_like(borne[:, :1]), borne[:, :-1]], axis=1)
            work += np.sum(0.5 * (before + borne) * moved, axis=(1, 2))
        remaining = trace.stored_energy[:, -1] + trace.dissipation[:, -1]
        misses.append(np.max(np.abs(work - remaining)) / np.max(remaining))
    assert misses[0] < 0.05
    assert misses[1] < misses[0] / 2.5
    assert misses[2] < misses[1] / 2.5


def test_steps_one_by_one_are_the_steps_at_once():
    depth, motion, twist, roll = history(3, 10, 12)
    contacts = apart(10, arm=0.01)
    at_once, trace = contacts.along(depth, motion=motion, twist=twist, roll=roll)
    for t in range(12):
        contacts = contacts.moved(depth[:, t], motion=motion[:, t], twist=twist[:, t], roll=roll[:, t])
        assert contacts.shear_force == pytest.approx(trace.shear_force[:, t], abs=1e-15)
        assert contacts.torque == pytest.approx(trace.torque[:, t], abs=1e-17)
        assert contacts.rolling_moment == pytest.approx(trace.rolling_moment[:, t], abs=1e-17)
        assert contacts.stored_energy == pytest.approx(trace.stored_energy[:, t], abs=1e-17)
    assert np.array_equal(contacts.displaced, at_once.displaced)
    assert contacts.dissipation == pytest.approx(at_once.dissipation, rel=1e-12)


# ---------------------------------------------------------------------------------------------------------------------
# twist and rolling


def test_small_twist_and_rolling_are_those_of_a_stuck_disc():
    contacts = apart(arm=0.05).moved([0.01]).moved([0.01], twist=[1e-5], roll=[[1e-5, -2e-5]])
    a = 0.1
    # Reissner and Sagoci; a disc that is tilted: 16/3 G_t a^3 and 4/3 E* a^3
    assert contacts.torque == pytest.approx(16.0 / 3.0 * (1.0 / 2.6) * a**3 * 1e-5, rel=1e-12)
    assert contacts.rolling_moment[0] == pytest.approx(
        4.0 / 3.0 * STEEL.modulus * a**3 * np.array([1e-5, -2e-5]), rel=1e-12
    )
    assert contacts.dissipation == pytest.approx(0.0, abs=1e-20)


def test_large_twist_and_rolling_slide():
    contacts = apart(arm=0.05).moved([0.01]).moved([0.01], twist=[-1.0], roll=[[3.0, 4.0]])
    assert contacts.torque == pytest.approx(-3.0 * math.pi / 16.0 * MU * contacts.force * 0.1, rel=1e-12)  # Lubkin
    assert np.hypot(*contacts.rolling_moment[0]) == pytest.approx(0.05 * contacts.force[0], rel=1e-12)
    assert contacts.rolling_moment[0, 1] / contacts.rolling_moment[0, 0] == pytest.approx(4.0 / 3.0, rel=1e-12)


def test_a_growing_contact_keeps_its_torque():
    contacts = apart().moved([0.004]).moved([0.004], twist=[1e-4])
    grown = contacts.moved([0.009])
    assert grown.torque == pytest.approx(contacts.torque, rel=1e-12)
    shrunk = grown.moved([0.004])
    assert np.all(np.abs(shrunk.torque) < np.abs(contacts.torque))
    assert np.all(shrunk.dissipation + shrunk.stored_energy <= contacts.stored_energy * (1.0 + 1e-12))


# ---------------------------------------------------------------------------------------------------------------------
# impacts


def maw(psi, *, steps=200, count=32):
    """Let solid spheres strike at the inclinations psi; return psi after it, and the solution."""
    sliding = np.zeros((len(psi), 2))
    sliding[:, 0] = np.asarray(psi) * BETA * 1e-3
    hit = BallImpacts(STEEL, 1.0, MU, 1.0, 3.5, 1e-3, sliding, steps, count).solve()
    return hit.sliding_velocity[:, 0] / (BETA * 1e-3), hit


def test_oblique_impacts_of_maw_barber_and_fawcett():
    after, hit = maw(list(MAW))
    assert after == pytest.approx(list(MAW.values()), abs=2e-4)  # the table itself is good to 1e-4
    assert hit.restitution == pytest.approx(1.0, abs=1e-7)
    assert hit.balance == pytest.approx(1.0, abs=3e-5)
    finer = maw(list(MAW), steps=800)[1]
    assert np.max(np.abs(finer.balance - 1.0)) < np.max(np.abs(hit.balance - 1.0)) / 8.0


@pytest.mark.slow
def test_one_impact_of_many_is_the_impact_alone():
    bed = wk.Foundation(wk.Paraboloid(1.0), STEEL)
    psi = [0.3, 1.2, 3.3, 5.5]
    after, hit = maw(psi, steps=1000, count=128)
    for index, inclination in enumerate(psi):
        alone = Impact(
            bed,
            Coulomb(MU),
            mass=1.0,
            velocity=1e-3,
            lateral_velocity=inclination * BETA * 1e-3,
            inertia=0.4,
            lever=1.0,
        ).solve()
        assert after[index] == pytest.approx(alone.sliding_velocity[-1] / (BETA * 1e-3), abs=2e-5)
        assert hit.dissipation[index] == pytest.approx(alone.dissipation[-1], rel=2e-4)
        assert hit.duration[index] == pytest.approx(alone.duration, rel=2e-3)
        assert hit.greatest_depth[index] == pytest.approx(np.max(alone.depth), rel=1e-4)
        assert hit.greatest_shear_force[index] == pytest.approx(np.max(np.abs(alone.shear_force)), rel=1e-3)


def test_impacts_in_any_direction():
    _, straight = maw([2.0, 2.0])
    sliding = np.array([[0.6, 0.8], [-0.8, 0.6]]) * 2.0 * BETA * 1e-3
    hit = BallImpacts(STEEL, 1.0, MU, 1.0, 3.5, 1e-3, sliding).solve()
    expected = straight.sliding_velocity[0, 0] * np.array([[0.6, 0.8], [-0.8, 0.6]])
    assert hit.sliding_velocity == pytest.approx(expected, abs=1e-15)


def test_the_cores_share_what_one_does_alone():
    rng = np.random.default_rng(0)
    sliding = rng.normal(size=(700, 2)) * 1e-3
    together = BallImpacts(STEEL, 1.0, MU, 1.0, 3.5, 1e-3, sliding).solve()
    some = BallImpacts(STEEL, 1.0, MU, 1.0, 3.5, 1e-3, sliding[340:360]).solve()
    assert np.array_equal(together.sliding_velocity[340:360], some.sliding_velocity)
    assert np.min(together.dissipation) >= 0.0
    assert together.balance == pytest.approx(1.0, abs=5e-5)


# ---------------------------------------------------------------------------------------------------------------------
# words


def test_what_is_refused():
    with pytest.raises(wk.InvalidInput, match="count"):
        apart(count=0)
    with pytest.raises(wk.InvalidInput, match="one number for all"):
        Contacts.apart(STEEL, curvature_radius=[1.0, 2.0], coefficient=[0.1, 0.2, 0.3], reach=1.0)
    with pytest.raises(wk.InvalidInput, match="coefficient"):
        Contacts.apart(STEEL, curvature_radius=1.0, coefficient=-0.1, reach=1.0)
    with pytest.raises(wk.InvalidInput, match="reach"):
        Contacts.apart(STEEL, curvature_radius=1.0, coefficient=0.1, reach=0.0)
    with pytest.raises(wk.InvalidInput, match="motion has the shape"):
        apart(2).moved([0.0, 0.0], motion=[[1.0, 2.0]])
    with pytest.raises(wk.InvalidInput, match="no finite number"):
        apart().moved([math.nan])
    with pytest.raises(wk.OutsideValidity, match="contact 1 is pressed"):
        apart(2).moved([0.001, 0.2])


@pytest.mark.parametrize(
    ("word", "wrong"),
    [
        ("velocity", 0.0),
        ("mass", -1.0),
        ("mobility", [1.0, 2.0]),
        ("coefficient", math.nan),
        ("steps", 1),
        ("count", 2.5),
        ("sliding_velocity", [1.0]),
    ],
)
def test_impacts_that_are_refused(word, wrong):
    given = {
        "medium": STEEL,
        "curvature_radius": 1.0,
        "coefficient": 0.3,
        "mass": 1.0,
        "mobility": 3.5,
        "velocity": 1.0,
        "sliding_velocity": np.zeros((3, 2)),
        word: wrong,
    }
    with pytest.raises(wk.InvalidInput, match=word):
        BallImpacts(**given)


def test_together_they_are_called_approximate():
    notes = apart().validity
    assert worst(notes) is Standing.APPROXIMATE
    assert any("uncoupled" in note.statement for note in notes)
