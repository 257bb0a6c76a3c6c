"""Sheets of seals and true areas show what they say."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.plot import draw

STEEL = wk.HalfSpace(wk.Elastic(210e9, 0.3))
SPECTRUM = wk.SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=8e-5)
ROUGH = wk.random_topography(SPECTRUM, (32, 32), [1e-3, 1e-3], seed=2)


def titles(picture):
    return [axes.get_title("left") for axes in picture.axes if axes.get_title("left")]


def test_a_seal():
    found = wk.Seal(wk.SurfaceContact(ROUGH, STEEL, wk.Force([10.0, 100.0])), 1e-3, 1e5).solve()
    picture = draw(found)
    assert titles(picture)[1:] == [
        "pressure of the fluid",
        "gaps",
        "leak rate over force",
        "flow factor over force",
        "critical gap over force",
    ]
    relief, fluid = picture.axes[:2]
    gap = np.ma.filled(relief.images[0].get_array(), np.nan)
    place = found.last_passage().path.place
    assert gap.T[place] == pytest.approx(1e6 * found.critical_gap[1])
    (mark,) = (line for line in relief.lines if len(line.get_xdata()) == 1)
    assert relief.get_title(loc="left").endswith("ring: narrowest")
    assert mark.get_xdata()[0] == pytest.approx((place[0] + 0.5) / 32)
    assert np.nanmax(np.ma.filled(fluid.images[0].get_array(), np.nan)) == pytest.approx(
        1e-3 * np.nanmax(found.fluid_pressure())
    )
    assert len(titles(draw(wk.Seal(wk.SurfaceContact(ROUGH, STEEL, wk.Force(10.0)), 1e-3, 1e5).solve()))) == 3


def test_a_tight_seal_and_one_pressed_flat():
    for force in (3e4, 3e6):
        tight = wk.Seal(wk.SurfaceContact(ROUGH, STEEL, wk.Force([force, 1.1 * force])), 1e-3, 1e5).solve()
        assert tight.leak_rate.tolist() == [0.0, 0.0]
        assert "nothing leaks" in draw(tight).get_suptitle()


def test_true_areas():
    found = wk.TrueArea(wk.SurfaceContact(ROUGH, STEEL, wk.Force([10.0, 100.0]))).solve()
    picture = draw(found)
    assert titles(picture) == [
        "patches of contact",
        "pressures",
        "gaps",
        "sizes of the patches",
        "area over force",
        "peak pressure over force",
    ]
    shown = np.ma.filled(picture.axes[0].images[0].get_array(), np.nan)
    assert np.nanmax(shown) == pytest.approx(1e6 * found.largest_patch[1])
    assert f"{found.patch_count[1]:.0f} patches" in picture.get_suptitle()
    whole = wk.TrueArea(wk.SurfaceContact(ROUGH, STEEL, wk.Force(3e6))).solve()
    assert whole.area == pytest.approx(1e-6, rel=1e-12)
    assert len(titles(draw(whole))) == 4
