"""What all benchmarks share: steel, and a target that a median must stay below."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

import winkler as wk


@pytest.fixture(scope="session")
def steel_on_steel() -> wk.HalfSpace:
    """The medium between two steel bodies."""
    steel = wk.Elastic(young=210e9, poisson=0.3)
    return wk.HalfSpace.between(steel, steel)


@pytest.fixture
def below(benchmark: Any) -> Callable[[float, str], None]:
    """State a target [s] after the measurement; the median must stay below it."""

    def check(target: float, what: str) -> None:
        benchmark.extra_info.update(target=target, what=what)
        if benchmark.enabled:
            median = benchmark.stats.stats.median
            assert median < target, f"{what}: the median is {1e3 * median:.3g} ms, the target {1e3 * target:.3g} ms"

    return check
