"""Sheets of rough surfaces show what they say."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.plot import draw
from winkler.plot.panel import Sheet
from winkler.plot.render import render
from winkler.plot.rough.roughness import MOST_PIXELS, heights_of, map_panel
from winkler.plot.style import RELIEFS

STEEL = wk.HalfSpace(wk.Elastic(210e9, 0.3))
BLASTED = wk.SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=60e-6)
STAMP = wk.RandomTopography([1e-3, 0.5e-3], BLASTED, (48, 24), seed=1, periodic=False)


def titles(picture):
    return [axes.get_title("left") for axes in picture.axes if axes.get_title("left")]


def test_a_map_with_cuts_and_spectrum():
    picture = draw(STAMP)
    assert titles(picture) == ["heights", "cuts through the middle", "power spectrum, all directions"]
    relief, cuts, spectrum = picture.axes[:3]
    image = relief.images[0]
    assert image.get_extent() == pytest.approx([0.0, 1.0, 0.0, 0.5])  # millimetres
    shown = 1e6 * (STAMP.heights - STAMP.heights.mean())
    np.testing.assert_allclose(np.asarray(image.get_array()), shown.T, rtol=1e-12)
    along_x, along_y = cuts.lines
    np.testing.assert_allclose(along_x.get_ydata(), shown[:, 12])
    np.testing.assert_allclose(along_y.get_ydata(), shown[24])
    found = wk.spectrum_of(STAMP)
    drawn = spectrum.lines[0].get_ydata()
    window = found.densities < 1e-10 * found.densities.max()  # what leaks through it is not drawn
    assert 0 < np.count_nonzero(window) < window.size
    assert np.isnan(drawn[window]).all()
    np.testing.assert_allclose(drawn[~window], found.densities[~window])
    with pytest.raises(wk.InvalidInput, match="no extent"):
        draw(STAMP, extent=1.0)


def test_missing_heights_are_white_and_have_no_spectrum():
    heights = np.array(STAMP.heights)
    heights[3, 4] = np.nan
    picture = draw(wk.Topography(heights, STAMP.lengths))
    assert titles(picture) == ["heights", "cuts through the middle"]
    assert "1 missing" in picture.get_suptitle()
    assert np.isnan(np.ma.filled(picture.axes[0].images[0].get_array(), np.nan)).sum() == 1


def test_large_maps_are_shown_with_means():
    large = wk.Topography(np.add.outer(np.arange(1100.0), np.zeros(64)), [1.1, 0.064])
    axes = render(Sheet((map_panel(large, heights_of(large), RELIEFS, lowest=np.inf),))).axes[0]
    shown = np.asarray(axes.images[0].get_array())
    assert max(shown.shape) <= MOST_PIXELS
    assert np.ptp(shown) == pytest.approx(1097.0, abs=3.0)


def test_a_contact_under_many_loads():
    found = wk.SurfaceContact(STAMP, STEEL, wk.Force([1.0, 10.0, 100.0])).solve()
    picture = draw(found)
    assert titles(picture)[1:] == [
        "pressure",
        "distance of the surfaces",
        "force over depth",
        "stiffness over force",
        "contact area over force",
    ]
    share = 100.0 * found.area[-1] / STAMP.area
    assert titles(picture)[0] == f"contact (red): {share:.3g} % of the map"
    pressure = np.asarray(picture.axes[1].images[0].get_array())
    assert np.nanmax(pressure) == pytest.approx(1e-9 * found.last.pressure.max())
    assert (
        np.isnan(np.ma.filled(picture.axes[1].images[0].get_array(), np.nan)).sum() == (found.last.pressure == 0).sum()
    )
    single = draw(wk.SurfaceContact(STAMP, STEEL, wk.Force(10.0)).solve())
    assert len(titles(single)) == 3
    assert "10 N" in single.get_suptitle()


def test_conduction_between_its_bounds():
    metal = wk.ElectricalConductor(16e-9)
    contact = wk.SurfaceContact(STAMP, STEEL, wk.Force([1.0, 10.0, 100.0]))
    problem = wk.SurfaceConduction(contact, wk.ElectricalConductors(metal, metal), realisations=4)
    found = problem.solve()
    picture = draw(found)
    stiffness, conductance, area = picture.axes[:3]
    labels = ["bounds", "eight lines of ten", "boundary elements", "lines of springs"]
    assert conductance.get_legend_handles_labels()[1] == labels
    np.testing.assert_allclose(1e6 * stiffness.lines[0].get_ydata(), found.stiffness)
    unit = found.conductance[0] / conductance.lines[0].get_ydata()[0]
    np.testing.assert_allclose(unit * conductance.lines[1].get_ydata(), 1.0 / found.line_resistance)
    np.testing.assert_allclose(area.lines[1].get_ydata(), 100.0 * found.line.area / STAMP.area)
    bars = draw(wk.SurfaceConduction(wk.SurfaceContact(STAMP, STEEL, wk.Force(10.0)), problem.conductors).solve())
    assert [text.get_text() for text in bars.axes[0].get_yticklabels()][1:3] == [
        "boundary elements",
        "lines of springs",
    ]


def test_lines_with_bands():
    found = wk.RoughContact(BLASTED, STEEL, 1e-3, wk.Force([1.0, 10.0, 100.0]), realisations=5, count=256).solve()
    picture = draw(found)
    assert titles(picture) == [
        "power spectrum",
        "depth over force",
        "stiffness over force",
        "true contact area over force",
    ]
    depth = picture.axes[1]
    assert len(depth.collections) == 1  # the band
    ball = wk.Foundation(wk.Paraboloid(10e-3), STEEL)
    rough = wk.RoughIndentation(BLASTED, ball, 4e-3, wk.Force(10.0), realisations=5, count=256).solve()
    assert titles(draw(rough)) == ["power spectrum", "depth under 10 N", "stiffness under 10 N", "area under 10 N"]


def test_contours_are_rounded_between_their_directions():
    profiles = tuple(wk.Paraboloid(radius) for radius in (10e-3, 11e-3) * 4)
    one = draw(wk.NearlyRoundIndentation(profiles, STEEL, wk.Depth(1e-6)).solve())
    smooth, dots = one.axes[0].lines
    assert len(dots.get_xdata()) == 8
    assert len(smooth.get_xdata()) > 200
    # the smooth contour goes through the points
    distance = np.hypot(
        smooth.get_xdata()[:, None] - dots.get_xdata(), smooth.get_ydata()[:, None] - dots.get_ydata()
    ).min(axis=0)
    assert np.max(distance) < 1e-9 * np.max(dots.get_xdata())
    many = draw(wk.NearlyRoundIndentation(profiles, STEEL, wk.Depth(np.array([1e-6, 2e-6]))).solve())
    assert titles(many) == ["contour of the contact", "force over depth"]


def test_an_ellipse_and_rubber():
    bodies = wk.CurvedBodies(20e-3, 10e-3)
    one = wk.EllipticIndentation(bodies, STEEL, wk.Force(100.0)).solve()
    picture = draw(one)
    shown = np.asarray(picture.axes[0].images[0].get_array())
    assert np.nanmax(shown) == pytest.approx(1e-9 * one.peak_pressure, rel=1e-3)
    many = wk.EllipticIndentation(bodies, STEEL, wk.Force([1.0, 10.0, 100.0])).solve()
    assert titles(draw(many)) == ["force over depth", "semi-axes over depth"]
    rubber = wk.StandardSolid(relaxed_shear=1e6, shear=3e6, relaxation_time=0.1)
    slid = wk.ElastomerFriction(BLASTED, rubber, np.geomspace(1e-5, 1e-1, 9)).solve()
    picture = draw(slid)
    np.testing.assert_allclose(picture.axes[0].lines[0].get_ydata(), slid.coefficient)
    assert titles(draw(BLASTED)) == ["power spectrum"]


def test_an_ellipse_without_a_load():
    with pytest.raises(wk.OutsideValidity, match="do not touch"):
        draw(wk.EllipticIndentation(wk.CurvedBodies(8e-3, 3e-3), STEEL, wk.Force(0.0)).solve())


def test_a_needle_fills_its_picture():
    """Axes of 70 : 1 have scales of their own: coloured is the share of an ellipse in a box 1.2 times as wide."""
    needle = wk.EllipticIndentation(wk.CurvedBodies(1.0, 1e-3), STEEL, wk.Force(100.0)).solve()
    assert needle.longitudinal_semi_axis > 50.0 * needle.lateral_semi_axis
    axes = draw(needle).axes[0]
    shown = np.isfinite(np.ma.filled(axes.images[0].get_array().astype(float), np.nan))
    assert np.mean(shown) == pytest.approx(0.25 * np.pi / 1.2**2, rel=1e-2)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("$x$ [mm]", "$y$ [µm]")
    assert axes.get_aspect() == "auto"


def test_a_pit_does_not_take_all_colours():
    """Colours end where all but a few pixels do; the bar says by an arrow that some lie beyond."""
    heights = np.array(STAMP.heights)
    heights[5, 7] -= 200e-6
    relief, *_ = draw(wk.Topography(heights, STAMP.lengths)).axes
    low, high = relief.images[0].get_clim()
    assert -20.0 < low < 0.0 < high < 20.0
    assert relief.images[0].colorbar.extend == "min"
    plain, *_ = draw(STAMP).axes
    assert plain.images[0].colorbar.extend == "neither"
