"""The sheet of an attracted height map."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.plot import draw

SOFT = wk.HalfSpace(wk.Elastic(1e6, 0.5))
BALL = wk.SampledProfile([240e-6, 240e-6], wk.Sphere(1e-3), (32, 32))
LAW = wk.ExponentialAttraction(50e-3, 0.8e-6)


def test_maps_and_loops():
    """Six panels of a loop: tension, pressure and distance, then force, areas and energies, with what was lost."""
    depths = np.array([-4.0, -1.5, 0.5, -1.0, -2.0, -4.0]) * 1e-6
    found = wk.SurfaceAdhesion(BALL, SOFT, LAW, wk.Depth(depths)).solve()
    figure = draw(found)
    titles = [axes.get_title(loc="left") or axes.get_title() for axes in figure.axes if axes.get_xlabel()]
    assert titles[:3] == ["tension", "pressure", "distance of the surfaces"]
    assert titles[3:] == ["force", "area", "work spent and energy"]
    force = figure.axes[[axes.get_ylabel().startswith("force") for axes in figure.axes].index(True)]
    drawn = next(line for line in force.lines if len(line.get_xdata()) == depths.size)
    np.testing.assert_allclose(np.ravel(drawn.get_xdata()) / np.ravel(drawn.get_xdata())[0], depths / depths[0])
    assert any("lost along the path" in text.get_text() for text in force.texts)


def test_one_displacement_has_maps_alone():
    """Far away there is no pressure to draw, and no loop of one point."""
    figure = draw(wk.SurfaceAdhesion(BALL, SOFT, LAW, wk.Depth([-2e-6])).solve())
    assert [axes.get_xlabel() != "" for axes in figure.axes].count(True) == 2
    with pytest.raises(wk.InvalidInput, match="no extent"):
        draw(wk.SurfaceAdhesion(BALL, SOFT, LAW, wk.Depth([-2e-6])).solve(), extent=1.0)
