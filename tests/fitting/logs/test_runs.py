"""Logs of bounces and of pins on discs: the numbers they were made with, within their stated errors."""

from __future__ import annotations

import numpy as np
import pytest
from made_files import table
from scipy.stats import t as student

from winkler.fitting.logs.runs import BounceTimes, PinOnDisc
from winkler.study.inspection.inspect import inspect_file
from winkler.values.errors import InvalidInput

WORLDS = 800


def _within(estimate, truth):
    return abs(estimate.value - truth) <= student.ppf(0.975, estimate.freedom) * estimate.error


def _bounces(restitution, jitter, rng, count=12):
    """Flight after flight: a body thrown up with v falls back after 2 v/g."""
    speed, time, times = 3.0, 0.3, []
    for _ in range(count):
        times.append(time)
        time += 2.0 * speed / 9.81
        speed *= restitution
    return np.array(times) + jitter * rng.normal(size=count)


def test_restitution_of_bounces_without_noise():
    assert BounceTimes(_bounces(0.83, 0.0, np.random.default_rng(0))).restitution.value == pytest.approx(0.83, rel=1e-9)


@pytest.mark.slow
def test_intervals_of_the_restitution_hold_the_truth():
    """95 % intervals hold it in 0.92 to 0.98 of the worlds."""
    rng = np.random.default_rng(42)
    held = [_within(BounceTimes(_bounces(0.83, 1e-3, rng)).restitution, 0.83) for _ in range(WORLDS)]
    assert 0.92 <= np.mean(held) <= 0.98


def _pin(rng, correlation):
    distance = np.linspace(0.0, 1000.0, 800)
    noise = rng.normal(size=(2, 800))
    for place in range(1, 800):
        noise[:, place] = correlation * noise[:, place - 1] + np.sqrt(1.0 - correlation**2) * noise[:, place]
    friction = 0.6 - 0.2 * np.exp(-distance / 40.0) + 0.02 * noise[0]
    loss = 5e-9 * distance + 2e-6 * (1.0 - np.exp(-distance / 40.0)) + 1e-7 * noise[1]
    return PinOnDisc(distance, friction, loss)


@pytest.mark.slow
@pytest.mark.parametrize("correlation", [0.0, 0.6])
def test_intervals_of_friction_and_wear_hold_the_truth(correlation):
    """Also where the noise is slow: 95 % intervals hold them in 0.92 to 0.98 of the worlds."""
    rng = np.random.default_rng(7)
    worlds = [_pin(rng, correlation) for _ in range(WORLDS)]
    friction = np.mean([_within(one.steady_friction, 0.6) for one in worlds])
    wear = np.mean([_within(one.wear_per_distance, 5e-9) for one in worlds])
    assert 0.92 <= friction <= 0.98
    assert 0.92 <= wear <= 0.98


def test_logs_are_recognised_and_say_their_numbers(tmp_path):
    rng = np.random.default_rng(3)
    found = inspect_file(table(tmp_path / "ball.csv", "bounce time [s]", _bounces(0.83, 1e-4, rng)))
    assert found.taken_for == "bounces by their times"
    assert found.done[0].startswith("coefficient of restitution 0.8")
    pin = _pin(rng, 0.5)
    path = table(tmp_path / "pin.csv", "distance [m], cof, wear depth [um]", pin.distance, pin.friction,
                 1e6 * pin.height_loss)  # fmt: skip
    found = inspect_file(path)
    assert found.taken_for == "log of a pin on a disc"
    assert [column.name for column in found.columns] == ["distance", "friction", "height_loss"]
    assert found.done[0].startswith("coefficient of friction 0.6")
    assert "per kilometre" in found.done[1]
    only = inspect_file(table(tmp_path / "mu.csv", "distance [m], mu", pin.distance, pin.friction))
    assert len(only.done) == 1


def test_too_few_bounces_are_refused():
    with pytest.raises(InvalidInput, match="at least 5 times"):
        BounceTimes([0.0, 1.0, 1.5])
    with pytest.raises(InvalidInput, match="each later than the last"):
        BounceTimes([0.0, 1.0, 0.5, 2.0, 3.0])
    with pytest.raises(InvalidInput, match="a distance that grows"):
        PinOnDisc(np.arange(30.0)[::-1], np.zeros(30), np.zeros(0))
