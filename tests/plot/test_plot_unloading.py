"""Pictures of measured indentations: every kind of segment has its name, and what was read lies where it was read."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.plot import draw


@pytest.fixture
def curve():
    """20 nm, held until 21, with a partial unloading during loading; the last one leaves 12 nm."""
    up = np.linspace(0.0, 1.0, 60)
    force = np.concatenate([0.5 * up, 0.5 - 0.4 * up[1:], 0.1 + 0.9 * up[1:], np.ones(40), 1.0 - up[1:]])
    peak = np.maximum.accumulate(force)
    depth = np.sqrt(peak) * (0.7 + 0.3 * (force / np.maximum(peak, 1e-9)) ** (2.0 / 3.0)) * 20e-9
    depth[177:217] += np.linspace(0.0, 1e-9, 40)
    depth[217:] = 12e-9 + 9e-9 * force[217:] ** (2.0 / 3.0)
    return wk.ForceCurve(depth, 1e-4 * force)


def legend(axes):
    return [text.get_text() for text in axes.get_legend().get_texts()]


KINDS = ["loading", "hold", "partial unloading", "last unloading"]


def test_segments_are_named(curve):
    left, right = draw(curve).axes
    assert sorted(text.get_text() for text in left.texts) == sorted([*KINDS, "loading"])
    assert legend(right) == KINDS
    assert left.get_xlabel() == "point"
    timed = wk.ForceCurve(curve.position, curve.force, time=np.linspace(0.0, 5.0, curve.count))
    assert draw(timed).axes[0].get_xlabel() == "time $t$ [s]"


def test_a_reading_shows_law_stiffness_and_contact_depth(curve):
    found = wk.OliverPharr(curve, wk.Berkovich()).solve()
    left, right = draw(found).axes
    assert sorted(text.get_text() for text in left.texts) == sorted([*KINDS, "loading"])
    assert legend(right)[:4] == KINDS
    lines = {line.get_label(): line for line in right.get_lines()}
    law = lines[next(name for name in lines if name.startswith("$F"))]
    assert law.get_xdata()[-1] == pytest.approx(21.0, rel=0.01)
    assert law.get_ydata()[-1] == pytest.approx(100.0, rel=0.01)
    tangent = lines["stiffness $S$"]
    slope = np.diff(tangent.get_ydata())[0] / np.diff(tangent.get_xdata())[0]
    assert slope == pytest.approx(1.5 * 100.0 / 9.0, rel=0.01)
    contact = lines["contact depth $h_c$"].get_xdata()[0]
    assert contact == pytest.approx(21.0 - 0.75 * 9.0 / 1.5, rel=0.01)


def test_there_is_no_extent(curve):
    with pytest.raises(wk.InvalidInput, match="the curves of a ForceCurve have no extent"):
        draw(curve, extent=1e-9)
