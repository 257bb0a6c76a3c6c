"""Fits: 2,000 points and four free numbers, one curve of a batch that begins near the answer, and modulus, contact
point and baseline of different curves without adhesion.

Run it:  pytest benchmarks/bench_fit.py -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.elastic.response import response
from winkler.fitting.fit import fit
from winkler.laws.adhesion import ShortRange
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.problems.adhesion.law_states import states_of

pytestmark = pytest.mark.bench

RADIUS, YOUNG, WORK, SPRING, NOISE = 5e-6, 1e4, 1e-4, 0.05, 3e-11
PATH = "bed.medium.first.young"
FREE = [PATH, "law.work", "contact_point", "baseline"]


def sticky(young: float, work: float) -> AdhesiveIndentation:
    bed = wk.Foundation(wk.Sphere(RADIUS), wk.HalfSpace.between(wk.Elastic(young, 0.5)))
    return AdhesiveIndentation(bed, ShortRange(work), wk.Depth(0.0))


def there_and_back(count: int) -> ForceCurve:
    """A sphere that snaps in and comes off, on a cantilever, with noise."""
    path = np.linspace(-1e-6, 1.5e-6, count // 2)
    model = sticky(YOUNG, WORK)
    solution = response(states_of(model.bed, model.law), 1.0 / SPRING, 1.5e-6)
    inward = np.where(path >= 0.0, solution.closing(path).force, 0.0)
    outward = np.where(path >= solution.loss()[0], solution.opening(path, 1.5e-6).force, 0.0)
    force = np.concatenate([inward, outward[::-1]])
    noise = NOISE * np.random.default_rng(0).standard_normal(count)
    return ForceCurve(np.concatenate([path, path[::-1]]) + 2e-6, force + 1e-10 + noise, SPRING)


def check(found) -> None:
    assert abs(found.value(PATH) - YOUNG) < 5.0 * found.error(PATH)
    assert abs(found.value("law.work") - WORK) < 5.0 * found.error("law.work")


def pressed(count: int, seed: int) -> ForceCurve:
    """A paraboloid pressed into a soft half-space, with noise."""
    depth = np.linspace(-1e-6, 1e-6, count)
    force = 4.0 / 3.0 * YOUNG / 0.75 * np.sqrt(RADIUS) * np.maximum(depth, 0.0) ** 1.5
    return ForceCurve(depth + 3e-6, force + 1e-10 + NOISE * np.random.default_rng(seed).standard_normal(count))


@pytest.mark.parametrize(("count", "curves"), [(2000, 20), (64_000, 3)])
def bench_modulus_point_and_baseline(benchmark, count, curves):
    """Different curves in a row, so that no fit finds what the one before kept of its curve."""
    bed = wk.Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace.between(wk.Elastic(3e4, 0.5)))
    model, measured = wk.Indentation(bed, wk.Depth(0.0)), [pressed(count, seed) for seed in range(curves)]
    free = [PATH, "contact_point", "baseline"]
    found = benchmark.pedantic(lambda: [fit(curve, model, free=free) for curve in measured], rounds=3, warmup_rounds=1)
    assert all(abs(one.value(PATH) - YOUNG) < 5.0 * one.error(PATH) for one in found)


def bench_two_thousand_points(benchmark, below):
    """From a modulus and a work of adhesion that are hundreds of times too large."""
    curve, model = there_and_back(2000), sticky(3e6, 0.03)
    check(benchmark.pedantic(lambda: fit(curve, model, free=FREE), rounds=10, warmup_rounds=1))
    below(0.5, "fit of 2,000 points, adhesive, four free numbers")


def bench_one_of_a_batch(benchmark, below):
    """The next curve of a map: begins where the one before ended."""
    curve, model = there_and_back(1000), sticky(1.1e4, 1.1e-4)
    free = {PATH: 1.1e4, "law.work": 1.1e-4, "contact_point": 2.01e-6, "baseline": ()}
    check(benchmark.pedantic(lambda: fit(curve, model, free=free), rounds=10, warmup_rounds=1))
    below(0.06, "fit of 1,000 points beginning near the answer, one of a batch")
