"""Line contacts on layers: half-widths under many loads, from nothing.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.foundation import layered_line, strip_sums

pytestmark = pytest.mark.bench

STRIP = wk.LayeredLineFoundation(
    wk.Paraboloid(10e-3), wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1e6, 0.3), 1e-3)], on=wk.Rigid())
)
LOADS = np.geomspace(1.0, 3e3, 200)


def forget() -> None:
    """Leave out what was kept of earlier half-widths."""
    strip_sums._kept.cache_clear()
    strip_sums._octaves.cache_clear()
    layered_line._carried.cache_clear()


def bench_two_hundred_loads(benchmark, below):
    """Half-widths of 200 loads on a strip, 0.1 to 3 thicknesses wide."""
    solved = benchmark.pedantic(wk.LineIndentation(STRIP, wk.LineForce(LOADS)).solve, setup=forget, rounds=5)
    assert np.all(np.diff(solved.half_width) > 0.0)
    below(0.5, "line contact on a strip, 200 loads, from nothing")
