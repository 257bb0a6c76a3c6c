"""Intervals hold what they promise: of many noisy curves, at least 91 % lie inside the 95 % interval, memory or not."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import binom
from synthetic import hertz_on_spring, jkr, noise, there_and_back

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.laws.adhesion import ShortRange
from winkler.problems.adhesion.indentation import AdhesiveIndentation

R, YOUNG, WORK, SPRING = 5e-6, 1e4, 1e-4, 0.05
MODULUS = YOUNG / 0.75
BED = wk.Foundation(wk.Paraboloid(R), wk.HalfSpace.between(wk.Elastic(3e4, 0.5)))
TRUTH = {"bed.medium.first.young": YOUNG, "contact_point": 2e-6, "baseline": 1e-10}


def hits(sticky: bool, memory: float, seeds: range, points: int) -> dict[str, int]:
    position, inward = there_and_back(-1e-6, 1e-6, points)
    truth = dict(TRUTH)
    if sticky:
        force, model = (
            jkr(position, inward, MODULUS, R, WORK, SPRING),
            AdhesiveIndentation(BED, ShortRange(1e-3), wk.Depth(0.0)),
        )
        truth["law.work"] = WORK
    else:
        force, model = hertz_on_spring(position, MODULUS, R, SPRING), wk.Indentation(BED, wk.Depth(0.0))
    inside = dict.fromkeys(truth, 0)
    for seed in seeds:
        disturbed = force + 1e-10 + 3e-11 * noise(np.random.default_rng(seed), position.size, memory)
        found = fit(ForceCurve(position + 2e-6, disturbed, SPRING), model, free=list(truth))
        if memory == 0.7:
            exact = position.size * (1.0 - memory) / (1.0 + memory)
            assert 0.5 * exact < found.effective_count < 2.2 * exact
        for name, number in truth.items():
            low, high = found.interval(name)
            inside[name] += low <= number <= high
    return inside


@pytest.mark.few(1)
@pytest.mark.parametrize("memory", [0.0, 0.7])
def test_some_curves(memory):
    """Eight curves: fewer hits than this happen once in a thousand tests of an honest interval."""
    least = int(binom.ppf(1e-3, 8, 0.95))
    assert min(hits(False, memory, range(8), 150).values()) >= least


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("memory", [0.0, 0.7])
@pytest.mark.parametrize("sticky", [False, True], ids=["Hertz", "JKR"])
def test_a_hundred_curves(sticky, memory):
    """Other seeds than those of the quick test; of white noise the baseline may have all (its slow part is unknown)."""
    inside = hits(sticky, memory, range(90_000, 90_100), 250)
    least = int(binom.ppf(1e-3, 100, 0.92))
    assert all(count >= least for count in inside.values()), inside
