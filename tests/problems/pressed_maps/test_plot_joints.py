"""Pictures of joints, flow factors, statistics of maps and line scans: what they show, with labels and units."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.plot import draw

STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
ROUGH = wk.random_topography(wk.SelfAffine(0.8, 1e-6, 0.5e-3, 8e-5), (48, 48), [1e-3, 1e-3], seed=1)
METAL = wk.ThermalConductor(50.0, 1e-5)


def axes_of(figure):
    return {axes.get_title(loc="left"): axes for axes in figure.axes if axes.get_title(loc="left")}


def test_a_joint_shows_what_spots_and_gap_carry():
    contact = wk.SurfaceContact(ROUGH, STEEL, wk.Force([3.0, 30.0]))
    joint = wk.ThermalJoint(contact, wk.HeatConductors(METAL, METAL), gap_conductivity=0.026).solve()
    axes = axes_of(draw(joint))
    assert list(axes) == ["heat flux per kelvin", "gap, white: contact", "conductance over force"]
    both, spots, gap = (line.get_ydata() for line in axes["conductance over force"].lines[:3])
    np.testing.assert_allclose(both, np.asarray(spots) + np.asarray(gap), rtol=1e-12)
    assert "W/K" in axes["conductance over force"].get_ylabel()
    vacuum = wk.ThermalJoint(contact, wk.HeatConductors(METAL, METAL)).solve()
    lines = axes_of(draw(vacuum))["conductance over force"].lines
    assert len([line for line in lines if line.get_label() in ("both", "spots", "gap")]) == 2


def test_flow_factors_over_the_distance():
    (axes,) = axes_of(draw(wk.flow_factors(ROUGH, [3e-6, 1e-6, 2e-6]))).values()
    assert axes.get_xlabel() == "separation $h$ [µm]"
    np.testing.assert_allclose(axes.lines[0].get_xdata(), [1.0, 2.0, 3.0])


@pytest.mark.parametrize("tip_radius", [0.0, 1e-3])
def test_statistics_show_their_curves(tip_radius):
    rough = wk.Topography(ROUGH.heights, ROUGH.lengths, tip_radius=tip_radius)
    axes = axes_of(draw(wk.map_statistics(rough)))
    names = ["heights", "cuts through the middle", "bearing curve", "autocorrelation", "power spectrum", "curvature"]
    assert list(axes) == names
    half = [line for line in axes["curvature"].lines if line.get_label() == "half the curvature of the tip"]
    assert len(half) == (1 if tip_radius else 0)
    bearing = max(axes["bearing curve"].lines, key=lambda line: len(line.get_xdata()))
    assert np.all(np.diff(bearing.get_ydata()) <= 0.0)
    starts = [line.get_ydata()[0] for line in axes["autocorrelation"].lines if len(line.get_xdata()) > 2]
    assert starts == pytest.approx([1.0, 1.0], abs=1e-12)


def test_statistics_of_a_map_with_holes():
    holed = wk.Topography(np.where(ROUGH.gaps < 0.2e-6, np.nan, ROUGH.heights), ROUGH.lengths)
    texts = [text.get_text() for axes in draw(wk.map_statistics(holed)).axes for text in axes.texts]
    assert any(text.startswith("no spectrum: ") for text in texts)


def test_a_scan():
    x = np.arange(200) * 1e-6
    axes = axes_of(draw(wk.LineScan(x, 1e-3 * x + 1e-7 * np.sin(x / 5e-6))))
    assert list(axes) == ["heights without tilt", "bearing curve", "spectrum of an isotropic surface"]
    assert axes["heights without tilt"].get_ylabel() == "height $z$ [nm]"
