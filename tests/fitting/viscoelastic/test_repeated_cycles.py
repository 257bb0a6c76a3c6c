"""Fits of curves that go in again and again, against the closed hereditary integral of a flat punch."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import winkler as wk
from winkler.fitting.outcome import ViscoelasticFit

PUNCH, RELAXED, SHEAR, TIME = 2e-6, 300.0, 700.0, 0.4
CONTACT, BASELINE, SCATTER = 4e-7, 3e-11, 6e-11
TURNS = np.array([-0.5, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0])
DEPTHS = 1e-6 * np.array([-0.25, 0.0, 1.0, 0.7, 1.3, 0.95, 1.5])
FIRST = "bed.medium.first."
FREE = {f"{FIRST}relaxed_shear": RELAXED, f"{FIRST}shear": SHEAR, f"{FIRST}relaxation_time": TIME,
        "contact_point": CONTACT, "baseline": BASELINE}  # fmt: skip


def forces(time):
    """F = 2 a int E*(t - s) d'(s) ds with E* = 4 (G + g exp(-t / tau)), while the punch stays in contact."""
    total = np.zeros(time.size)
    for begin, end, low, high in zip(TURNS[1:-1], TURNS[2:], DEPTHS[1:-1], DEPTHS[2:], strict=True):
        rate = (high - low) / (end - begin)
        upper = np.clip(time, begin, end)
        faded = np.exp(-(time - upper) / TIME) - np.exp(-np.maximum(time - begin, 0.0) / TIME)
        total += rate * np.where(time > begin, RELAXED * (upper - begin) + SHEAR * TIME * faded, 0.0)
    return 8.0 * PUNCH * total


def cycles(seed, count=160, spring=np.inf):
    rng = np.random.default_rng(seed)
    time = np.linspace(TURNS[0], TURNS[-1], count)
    depth, force = np.interp(time, TURNS, DEPTHS), forces(time)
    assert np.all(force[time > 0.0] > 0.0)
    leg = np.searchsorted(TURNS, time, "right").clip(1, TURNS.size - 1)
    direction = np.sign(np.diff(DEPTHS))[leg - 1]
    noisy = force + BASELINE + SCATTER * rng.standard_normal(count)
    return wk.ForceCurve(depth + CONTACT + force / spring, noisy, spring, time, direction, "cycles")


def start():
    bed = wk.Foundation(wk.FlatPunch(PUNCH), wk.ViscoelasticHalfSpace(wk.StandardSolid(1e3, 1e3, 1.5)))
    return wk.ViscoelasticIndentation(bed, wk.Path([0.0], wk.Depth(0.0)))


def judged(seeds):
    scores = []
    for seed in seeds:
        found = wk.fit(cycles(seed), start(), free=list(FREE))
        assert isinstance(found, ViscoelasticFit)
        assert "misfit" not in [flag.name for flag in found.flags]
        ends = [found.interval(name) for name in FREE]
        scores.append([low <= truth <= high for (low, high), truth in zip(ends, FREE.values(), strict=True)])
    return np.array(scores)


@pytest.mark.slow
def test_three_cycles_give_the_solid():
    assert np.mean(judged(range(2))) >= 0.7


@pytest.mark.long
def test_intervals_of_many_curves_of_cycles():
    assert np.all(np.mean(judged(range(100, 108)), axis=0) >= 0.6)


def test_cycles_through_a_soft_cantilever_are_refused():
    with pytest.raises(wk.InvalidInput, match="goes in again, and the machine bends"):
        wk.fit(cycles(0, spring=5e-3), start(), free=list(FREE))


def test_a_curve_that_begins_with_the_retraction_is_refused():
    curve = cycles(0)
    late = dataclasses.replace(curve, direction=np.where(curve.time < 0.5, -1.0, curve.direction))
    with pytest.raises(wk.InvalidInput, match="begins with the retraction"):
        wk.fit(late, start(), free=list(FREE))
