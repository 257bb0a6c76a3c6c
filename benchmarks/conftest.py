"""What all benchmarks share: steel, and a target.

The fastest round must stay below the target: on a machine that does other things too, the slower ones measure those.
"""

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
    """State a target [s] after the measurement; the fastest round must stay below it."""

    def check(target: float, what: str) -> None:
        benchmark.extra_info.update(target=target, what=what)
        if benchmark.enabled:
            fastest = benchmark.stats.stats.min
            assert fastest < target, f"{what}: the fastest is {1e3 * fastest:.3g} ms, the target {1e3 * target:.3g} ms"

    return check
