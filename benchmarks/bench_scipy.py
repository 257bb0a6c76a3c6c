"""What scipy has of what winkler computes by itself: integrals with singular ends, and indices of Sobol.

Run it:  pytest benchmarks/bench_scipy.py -m bench -n 0 --benchmark-only

Each result is compared with a closed form; its greatest relative error is in extra_info.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats
from scipy.integrate import tanhsinh

from winkler.numerics.equations.sobol_indices import sobol_indices
from winkler.numerics.integrals.adaptive_quadrature import TOLERANCE, settled
from winkler.study.language.designs import Sensitivity

pytestmark = pytest.mark.bench

POWERS = {"inverse roots": (-0.5, -0.1), "roots": (0.3, 0.9), "weak": (1.5, 2.5), "smooth": (4.0, 12.0)}


def by_settled(powers):
    """Return the integrals of t^p, by the ladder of winkler."""
    return settled(lambda node, index: node ** powers[index, None], powers.size, "powers")


def by_tanhsinh(powers):
    """Return the same by scipy."""
    return tanhsinh(lambda t, p: t**p, 0.0, 1.0, args=(powers,), rtol=TOLERANCE).integral


@pytest.mark.parametrize("count", [1, 1000])
@pytest.mark.parametrize("name", POWERS)
@pytest.mark.parametrize("way", [by_settled, by_tanhsinh])
def bench_powers(benchmark, way, name, count):
    """Powers of the distance from the end: alone, and a thousand at once."""
    powers = np.linspace(*POWERS[name], count)
    found = benchmark(way, powers)
    error = np.max(np.abs(found * (powers + 1.0) - 1.0))
    benchmark.extra_info["error"] = f"{error:.1e}"
    assert error < 1e-12


def of_winkler(first, second, mixed):
    """Return the ends of the intervals of total order, with a seed, by percentiles."""
    found = sobol_indices(first, second, mixed, seed=1)
    return found.total_order, found.total_order_low, found.total_order_high


def of_scipy(first, second, mixed):
    """Return the same by scipy: without a seed, by its accelerated percentiles."""
    func = {"f_A": first[None], "f_B": second[None], "f_AB": mixed[:, None]}
    found = stats.sobol_indices(func=func, n=first.size)
    ends = found.bootstrap(n_resamples=1000).total_order.confidence_interval
    return found.total_order, ends.low, ends.high


@pytest.mark.parametrize("count", [256, 2048])
@pytest.mark.parametrize("way", [of_winkler, of_scipy])
def bench_sobol(benchmark, way, count):
    """A sum of four independent numbers, for which both indices are known."""
    weights = np.array([4.0, 3.0, 2.0, 1.0])
    rows = (Sensitivity(count, 3).shares(4) @ weights).reshape(count, 6)
    best, low, high = benchmark.pedantic(way, (rows[:, 0], rows[:, 1], rows[:, 2:].T), rounds=3)
    np.testing.assert_allclose(best, weights**2 / 30.0, atol=0.01)
    assert np.all((low < best) & (best < high))
