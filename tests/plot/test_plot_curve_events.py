"""Picture of a measured curve: bands for what was done, marks where something happened, units on the axes."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.plot import draw, sheet_of
from winkler.plot.panel import Band, Line


@pytest.fixture
def curve():
    """A ball in and out: free over 2 of 3 um, a step of 1 nN while pressed in, a tension of 3 nN, light, and times."""
    leg = np.linspace(-2e-6, 1e-6, 600)
    position = np.concatenate([leg, np.full(200, 1e-6), leg[::-1]])
    order = np.arange(1400)
    force = 4e-8 * np.maximum(position * 1e6, 0.0) ** 1.5 - 1e-9 * ((order >= 520) & (position > 0.0))
    force = force + 1e-8 * position * 1e6 * ((order > 800) & (position < 0.0) & (position > -3e-7))
    force += 1e-10 * np.cos(position / 5e-8) + 3e-11 * np.random.default_rng(1).standard_normal(1400)
    return wk.ForceCurve(position, force, 0.05, time=1e-3 * order)


def test_bands_names_and_marks(curve):
    left, right = draw(curve).axes
    assert [text.get_text() for text in left.texts] == ["baseline", "loading", "hold", "last unloading", "baseline"]
    assert left.get_xlabel() == "time $t$ [s]"
    assert right.get_xlabel() == "position $D$ [µm]"
    assert left.get_ylabel() == right.get_ylabel() == "force $F$ [nN]"
    names = [text.get_text() for text in right.get_legend().get_texts()]
    assert names[:4] == ["loading", "hold", "last unloading", "baseline"]
    assert [name.split(",")[0] for name in names[4:]] == ["pop-in", "pull-off", "interference"]


def test_bands_follow_each_other_and_marks_lie_on_the_curve(curve):
    left, right = sheet_of(curve).panels
    bands = [mark for mark in left.marks if isinstance(mark, Band)]
    assert [band.low for band in bands[1:]] == [band.high for band in bands[:-1]]
    assert (bands[0].low, bands[-1].high) == (0.0, curve.time[-1])
    assert bands[0].high == pytest.approx(0.4, abs=0.03)
    marked = {mark.name.split(",")[0]: mark for mark in right.marks if isinstance(mark, Line)}
    (at,) = marked["pop-in"].x
    assert at == pytest.approx(curve.position[519], abs=2e-8)
    assert marked["pull-off"].y[0] == pytest.approx(-3e-9, rel=0.1)
