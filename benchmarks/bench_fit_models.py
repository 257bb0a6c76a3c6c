"""Fits of 2,000 points with four free numbers by several models, of 64,000 points, and of the modulus of a film.

Run it:  pytest benchmarks/bench_fit_models.py -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest
from film_tables import forget
from scipy.interpolate import CubicSpline

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit

pytestmark = pytest.mark.bench

RADIUS, YOUNG, COUNT = 5e-6, 1e4, 2000
FOUR = ["bed.medium.first.young", "contact_point", "baseline", "tilt"]
FILM = "bed.medium.layers[0].solid.young"
RADII = np.linspace(0.0, 4e-6, 81)
TIPS = {
    "ball": wk.Sphere(RADIUS),
    "paraboloid": wk.Paraboloid(RADIUS),
    "cone": wk.Cone(half_angle=np.radians(35.0)),
    "measured tip": wk.Measured(RADII, RADII**2 / (2.0 * RADIUS) + 3e-9 * (1.0 - np.cos(RADII / 4e-7))),
}


def noisy(bed: wk.Foundation, noise: float, count: int = COUNT) -> ForceCurve:
    position = np.linspace(-1e-6, 1e-6, count)
    depth = np.linspace(0.0, 1e-6, 200)[1:]
    force = wk.Indentation(bed, wk.Depth(depth)).solve().force
    smooth = CubicSpline(np.append(0.0, np.sqrt(depth)), np.append(0.0, force))
    random = np.random.default_rng(0).standard_normal(count)
    measured = smooth(np.sqrt(np.maximum(position, 0.0))) + noise * force[-1] * random
    return ForceCurve(position + 2e-6, measured + 0.01 * force[-1])


@pytest.mark.parametrize("name", TIPS)
def bench_tip(benchmark, below, name):
    """From a modulus that is a hundred times too large."""
    bed = wk.Foundation(TIPS[name], wk.HalfSpace.between(wk.Elastic(YOUNG, 0.5)))
    far = wk.Indentation(bed.with_medium(wk.HalfSpace.between(wk.Elastic(1e6, 0.5))), wk.Depth(0.0))
    curve = noisy(bed, 1e-3)
    found = benchmark.pedantic(lambda: fit(curve, far, free=FOUR), rounds=10, warmup_rounds=1)
    assert abs(found.value(FOUR[0]) - YOUNG) < 5.0 * found.error(FOUR[0])
    below(0.08 if name == "measured tip" else 0.05, f"fit of 2,000 points, {name}, four free numbers")


def bench_many_points(benchmark, below):
    """Beside scipy's `curve_fit` of Hertz' law with three numbers, which states no doubt: see docs/benchmarks.md."""
    bed = wk.Foundation(TIPS["paraboloid"], wk.HalfSpace.between(wk.Elastic(YOUNG, 0.5)))
    model, curve = wk.Indentation(bed, wk.Depth(0.0)), noisy(bed, 1e-3, 64_000)
    found = benchmark.pedantic(lambda: fit(curve, model, free=FOUR[:3]), rounds=5, warmup_rounds=1)
    assert abs(found.value(FOUR[0]) - YOUNG) < 5.0 * found.error(FOUR[0])
    below(0.25, "fit of 64,000 points, paraboloid, three free numbers")


@pytest.mark.parametrize("ratio", [0.01, 100.0])
@pytest.mark.parametrize("width", [0.01, 0.1, 1.0, 10.0, 100.0])
def bench_film(benchmark, below, ratio, width):
    """From three times the modulus, every table forgotten."""
    thickness = np.sqrt(RADIUS * 1e-6) / width

    def bed(young: float) -> wk.Foundation:
        layer = wk.Layer(wk.Elastic(young, 0.45), thickness)
        return wk.Foundation(wk.Paraboloid(RADIUS), wk.CoatedHalfSpace([layer], on=wk.Elastic(1e6, 0.4)))

    curve, far = noisy(bed(1e6 * ratio), 1e-3), wk.Indentation(bed(3e6 * ratio), wk.Depth(0.0))
    free = [FILM, "contact_point", "baseline"]
    found = benchmark.pedantic(lambda: fit(curve, far, free=free), setup=forget, rounds=2)
    assert abs(found.value(FILM) - 1e6 * ratio) < 5.0 * found.error(FILM)
    below(2.0, f"fit of 2,000 points, film of {ratio:g} times the substrate's modulus, a/h = {width:g}, from nothing")
