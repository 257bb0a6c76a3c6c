"""Picture of a worn elliptic contact."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.plot import sheet_of

STEEL = wk.Elastic(210e9, 0.3)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
OVAL, NEEDLE = wk.CurvedBodies(20e-3, 5e-3), wk.CurvedBodies(1.0, 1e-3)
BOTH = wk.PairWear(wk.Archard(1e-17), wk.Archard(1e-15))


def worn(wear=BOTH, bodies=OVAL):
    return wk.EllipticWear(bodies, PAIR, wear, wk.Force(100.0), distance=1.0, angle=0.5).solve()


def test_it_shows_a_map_of_the_slider_and_the_section_of_the_track():
    item = worn()
    slider, track = sheet_of(item).panels
    assert np.max(slider.marks[0].z) == pytest.approx(item.worn_depth, rel=1e-12)
    (x0, y0), (x1, y1) = slider.marks[2].start, slider.marks[2].stop
    assert np.arctan2(y1 - y0, x1 - x0) == pytest.approx(0.5)
    assert np.min(track.marks[0].y) == pytest.approx(-item.track_depth, rel=1e-12)
    assert track.marks[0].y[0] == 0.0


def test_without_a_track_it_shows_sections_of_the_slider():
    item = worn(wk.Archard(1e-17), NEEDLE)
    slider, sections = sheet_of(item).panels
    assert not slider.equal
    assert [line.name for line in sections.marks] == ["along x", "along y"]
    assert all(np.max(line.y) == pytest.approx(item.worn_depth, rel=1e-12) for line in sections.marks)
