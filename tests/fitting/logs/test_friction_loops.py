"""Loops of friction of sliders in parallel behind a soft frame: the numbers they were made with come out.

The sliders are written here: the curve of Mindlin's ball on its first way is that of springs which slide one after the
other, and they are followed step by step, without Masing's doubling.
"""

from __future__ import annotations

import functools

import numpy as np
import pytest

from winkler.fitting.logs.friction_log import FrictionLog
from winkler.fitting.logs.friction_loops import FrictionLoops
from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Force
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.profiles.power import Paraboloid
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Standing

RADIUS, LOAD, MU, FRAME = 5e-3, 20.0, 0.5, 60e-9
STEEL = Elastic(210e9, 0.3)
BED = Foundation(Paraboloid(RADIUS), HalfSpace.between(STEEL, STEEL))
CONTACT = np.cbrt(0.75 * LOAD * RADIUS / (210e9 / 1.82))
STIFFNESS = 8.0 * CONTACT * 210e9 / 2.6 / 3.4


@functools.cache
def sliders(mu, elements=600):
    """Slopes and ways after which springs slide: sums of them are mu F (1 - (1 - s/s_1)^(3/2))."""
    most = 1.5 * mu * LOAD / STIFFNESS
    ends = most * np.linspace(0.0, 1.0, elements + 1)
    curve = mu * LOAD * (1.0 - (1.0 - ends / most) ** 1.5)
    slopes = np.append(np.diff(curve) / np.diff(ends), 0.0)
    return -np.diff(slopes), ends[1:]


def followed(mu, amplitude, cycles, points=80, frame=FRAME):
    """Return displacement of the drive and shear force of a contact that swings by an amplitude."""
    stiffness, most = sliders(mu)
    at = np.arange(cycles * points + points // 4 + 1)
    slip = -amplitude * np.sin(2.0 * np.pi * at / points)
    stretched, force = np.zeros(stiffness.size), np.zeros(slip.size)
    for place in range(1, slip.size):
        stretched = np.clip(stretched + slip[place] - slip[place - 1], -most, most)
        force[place] = stiffness @ stretched
    return slip + frame * force, force


@functools.cache
def clean(mu=MU, amplitude=2.5e-6, cycles=3):
    return followed(mu, amplitude, cycles)


def solved(way, force, **more):
    return FrictionLoops(BED, Force(LOAD), FrictionLog(way, force), **more).solve()


def test_friction_frame_loss_and_way_of_a_ball():
    way, force = clean()
    found = solved(way, force)
    assert found.coefficient == pytest.approx(MU, rel=2e-3)
    assert found.series_compliance == pytest.approx(FRAME, rel=1e-2)
    assert found.expected_stiffness == pytest.approx(STIFFNESS, rel=1e-6)
    assert found.contact_stroke == pytest.approx(5e-6, rel=2e-3)
    last = slice(2 * 80 + 20, 3 * 80 + 21)
    work = np.sum(0.5 * (force[last][1:] + force[last][:-1]) * np.diff(way[last]))
    assert found.loss_per_cycle == pytest.approx(work, rel=1e-6)


def test_partial_slip_tells_the_coefficient_too():
    """The ball never slides all over: its core sticks, and the loop opens by slip of the ring alone."""
    most = 1.5 * MU * LOAD / STIFFNESS
    way, force = clean(amplitude=0.8 * most)
    assert np.max(force) < 0.95 * MU * LOAD
    found = solved(way, force)
    assert found.coefficient == pytest.approx(MU, rel=1e-2)
    assert found.series_compliance == pytest.approx(FRAME, rel=2e-2)


def test_a_known_frame_leaves_the_contact():
    way, force = clean()
    assert solved(way, force).contact_stiffness == pytest.approx(1.0 / (FRAME + 1.0 / STIFFNESS), rel=1e-2)
    known = solved(way, force, frame_compliance=FRAME)
    assert known.contact_stiffness == pytest.approx(STIFFNESS, rel=1e-2)
    assert not any("softer" in note.statement for note in known.validity)
    assert any("softer" in note.statement for note in solved(way, force).validity)
    with pytest.raises(OutsideValidity, match="less than the machine alone"):
        solved(way, force, frame_compliance=1e-6)


def test_a_force_of_the_other_sign_is_turned():
    way, force = clean()
    log = FrictionLog(way, -force)
    assert log.reversed
    np.testing.assert_array_equal(log.force, force)
    assert np.all(log.loss_per_cycle > 0.0)


def test_a_measured_normal_force_counts_for_the_coefficient():
    way, force = clean()
    log = FrictionLog(way, force, np.full(way.size, 2.0 * LOAD))
    found = FrictionLoops(BED, Force(LOAD), log).solve()
    assert found.coefficient == pytest.approx(0.5 * MU, rel=2e-3)
    assert any("The normal force is" in note.statement for note in found.validity)


def test_what_only_sticks_tells_no_coefficient():
    rng = np.random.default_rng(2)
    way = 1e-7 * np.sin(np.linspace(0.0, 8.0 * np.pi, 400))
    found = solved(way, 4e6 * way + 0.01 * rng.standard_normal(400))
    assert any(note.standing is Standing.OUTSIDE and "not determined" in note.statement for note in found.validity)
    assert 1.0 / (1.0 / found.expected_stiffness + found.series_compliance) == pytest.approx(4e6, rel=0.05)


def test_loops_of_another_shape_are_doubted():
    """A force that grows with the cube of the way is no contact that slides."""
    way = 2e-6 * np.sin(np.linspace(0.0, 8.0 * np.pi, 400))
    drag = 3.0 * np.sign(np.cos(np.linspace(0.0, 8.0 * np.pi, 400)))
    found = solved(way, 8.0 * (way / 2e-6) ** 5 + drag)
    assert found.validity[0].standing is Standing.OUTSIDE


def test_cycles_are_found_below_noise_and_with_pauses():
    way, force = clean(cycles=4)
    rng = np.random.default_rng(1)
    low = int(np.argmin(way[:40]))
    paused = np.insert(np.arange(way.size), low, np.full(60, low))
    log = FrictionLog(way[paused] + 2e-8 * rng.standard_normal(paused.size), force[paused])
    assert len(log.cycles) == 3
    np.testing.assert_allclose(log.stroke, np.ptp(way), rtol=0.03)


def test_a_log_without_a_whole_cycle_is_refused():
    ramp = np.linspace(0.0, 1e-6, 50)
    with pytest.raises(InvalidInput, match="no whole cycle"):
        FrictionLog(ramp, ramp)
    with pytest.raises(InvalidInput, match="differ in length"):
        FrictionLog(ramp, ramp[1:])


def _held(estimate, error, freedom, truth):
    from scipy.stats import t as student

    return abs(estimate - truth) <= student.ppf(0.975, freedom) * error


@pytest.mark.parametrize("cycles", [pytest.param(2, marks=pytest.mark.slow), pytest.param(24, marks=pytest.mark.long)])
def test_intervals_hold_the_truth(cycles):
    """Of few cycles (by residuals) and of many (by scatter): 95 % intervals hold it in 0.92 to 0.98 of 200 worlds."""
    way, force = followed(MU, 2.5e-6, cycles + 1, points=60)
    held = {"coefficient": 0, "compliance": 0, "loss": 0}
    true_loss = FrictionLog(way, force).loss_per_cycle[-1]
    for seed in range(200):
        rng = np.random.default_rng(seed)
        noise = rng.standard_normal((2, way.size))
        found = solved(way + 3e-9 * noise[0], force + 0.05 * noise[1])
        held["coefficient"] += _held(found.coefficient, found.coefficient_error, found.freedom, MU)
        held["compliance"] += _held(found.series_compliance, found.series_compliance_error, found.freedom, FRAME)
        held["loss"] += _held(found.loss_per_cycle, found.loss_error, found.freedom, true_loss)
    assert all(0.92 * 200 <= count <= 0.98 * 200 for count in held.values()), held
