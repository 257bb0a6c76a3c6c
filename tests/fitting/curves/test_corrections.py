"""Each correction takes away exactly what was put on a clean curve, and refuses what it cannot know."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest
from synthetic import hertz, jkr, there_and_back

from winkler.fitting.curves import corrections
from winkler.fitting.curves.curve import ForceCurve
from winkler.values.errors import InvalidInput


def clean() -> ForceCurve:
    position, _ = there_and_back(-2e-6, 1e-6, 300)
    return ForceCurve(position, hertz(position, 1e4, 5e-6), time=np.linspace(0.0, 2.0, 600), name="clean")


def test_baseline_and_tilt():
    curve = clean()
    line = 3e-10 + 2e-4 * curve.position
    found = corrections.free_line(dataclasses.replace(curve, force=curve.force + line))
    assert found.tilt == pytest.approx(2e-4, rel=1e-9)
    np.testing.assert_allclose(found.at(curve.position), line, rtol=1e-9)
    assert found.noise == pytest.approx(0.0, abs=1e-18)
    mended = corrections.without_baseline(dataclasses.replace(curve, force=curve.force + line), found)
    np.testing.assert_allclose(mended.force, curve.force, atol=1e-18)


def test_the_noise_of_the_baseline():
    curve = clean()
    noisy = curve.force + 1e-11 * np.random.default_rng(1).standard_normal(curve.count)
    assert corrections.free_line(dataclasses.replace(curve, force=noisy)).noise == pytest.approx(1e-11, rel=0.1)


def test_the_free_part_ends_before_contact():
    free = corrections.free_part(clean())
    assert -3e-7 < free.position.max() < 0.0


def test_the_free_part_of_a_sticky_curve_leaves_the_pull_out():
    position, inward = there_and_back(-4e-6, 1e-6, 300)
    force = hertz(position, 1e4, 5e-6)
    force[~inward & (position < 0.0) & (position > -1e-6)] = -2e-9
    free = corrections.free_part(ForceCurve(position, force))
    assert np.all(free.force[free.direction < 0.0] == 0.0)
    assert np.any(free.direction < 0.0)


def test_no_baseline_is_refused():
    curve = clean()
    with pytest.raises(InvalidInput, match="no_baseline: curve 'clean' has . points out of contact"):
        corrections.free_line(curve.chosen(curve.position > 1e-8))


def test_drift_of_position():
    curve = clean()
    drifting = dataclasses.replace(curve, position=curve.position + 5e-9 * (curve.time - curve.time[0]))
    mended = corrections.without_drift(drifting, 5e-9)
    np.testing.assert_allclose(mended.position, curve.position, atol=1e-20)


def test_the_rate_of_drift_is_read_from_a_hold():
    time = np.linspace(3.0, 8.0, 50)
    hold = ForceCurve(1e-7 + 4e-10 * time, np.full(50, 1e-9), time=time, direction=np.zeros(50))
    assert corrections.drift_rate(hold) == pytest.approx(4e-10, rel=1e-10)


def test_drift_needs_times():
    curve = dataclasses.replace(clean(), time=np.zeros(0))
    with pytest.raises(InvalidInput, match="curve 'clean' has no times"):
        corrections.without_drift(curve, 1e-9)
    with pytest.raises(InvalidInput, match="all times of curve 'clean' are the same"):
        corrections.drift_rate(dataclasses.replace(clean(), time=np.zeros(600)))


def test_drag_pushes_against_the_motion():
    curve = clean()
    dragged = dataclasses.replace(curve, force=curve.force + 1e-10 * curve.direction)
    found = corrections.drag_force(dragged)
    assert found == pytest.approx(1e-10, rel=1e-12)
    np.testing.assert_allclose(corrections.without_drag(dragged, found).force, curve.force, atol=1e-20)


def test_drag_needs_both_directions():
    with pytest.raises(InvalidInput, match="drag: curve 'clean' has 0 free points on retract"):
        corrections.drag_force(clean().approach)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: corrections.on_frame(clean(), -1.0), "frame_compliance is -1.0"),
        (lambda: corrections.on_frame(clean(), math.inf), "frame_compliance is inf"),
    ],
)
def test_a_frame_that_is_no_spring_is_refused(call, message):
    with pytest.raises(InvalidInput, match=message):
        call()


def test_frame_and_cantilever_are_springs_in_series():
    curve = dataclasses.replace(clean(), machine_stiffness=4e6)
    framed = corrections.on_frame(curve, 1e-7)
    assert framed.compliance == pytest.approx(0.25e-6 + 1e-7, rel=1e-14)
    assert corrections.on_frame(clean(), 0.0).machine_stiffness == math.inf


@pytest.mark.parametrize("tilt", [-60.0, -20.0, 20.0, 60.0])
@pytest.mark.parametrize("adhesive", [False, True])
def test_free_points_on_a_tilted_baseline(tilt, adhesive):
    """A tilt of many times the noise is neither contact nor tension: most free points are found, and the drag."""
    position, inward = there_and_back(-1e-6, 1e-6, 200)
    force = jkr(position, inward, 1.33e4, 5e-6, 1e-4, 0.05) if adhesive else hertz(position, 1.33e4, 5e-6)
    level = 3e-11
    force = force + level * (tilt * 1e6 * position + 10.0 * np.where(inward, 1.0, -1.0))
    force += level * np.random.default_rng(1).standard_normal(400)
    curve = ForceCurve(position, force, 0.05, direction=np.where(inward, 1.0, -1.0))
    free = corrections.free_part(curve)
    for sign in (1.0, -1.0):
        assert 60 < np.count_nonzero(free.direction == sign) <= 100
    assert corrections.drag_force(curve) == pytest.approx(10.0 * level, abs=0.4 * level)  # 4 errors of 80 points each
