"""Height maps: what they refuse, what they compute, and how they are changed."""

from __future__ import annotations

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from winkler.io.topography_file import read_topography
from winkler.loading.loads import Force
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace
from winkler.problems.rough.surface_contact import SurfaceContact
from winkler.profiles.rough.map_notes import map_notes
from winkler.profiles.rough.random_rough import random_topography
from winkler.profiles.rough.spectrum import SelfAffine
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput


def wave(nx=64, ny=48):
    x = np.arange(nx) / nx
    return Topography(np.sin(2.0 * np.pi * 3.0 * x)[:, None] + np.zeros(ny), [1.0, 2.0], periodic=True)


def test_a_wave():
    """Sine of amplitude one: Sq = 1/sqrt(2), Ssk = 0, Sku = 3/2."""
    rough = wave()
    assert rough.pixel == (1.0 / 64, 2.0 / 48)
    assert rough.area == 2.0
    assert rough.missing == 0
    assert rough.rms_height == pytest.approx(0.5**0.5, rel=1e-12)
    assert rough.skewness == pytest.approx(0.0, abs=1e-12)
    assert rough.kurtosis == pytest.approx(1.5, rel=1e-12)
    step = 2.0 * np.pi * 3.0 / 64
    assert rough.rms_slope == pytest.approx(2.0 * np.sin(step / 2.0) * 64 / 2.0**0.5, rel=1e-12)
    assert np.min(rough.gaps) == 0.0
    assert np.max(rough.gaps) == pytest.approx(2.0, rel=1e-2)


def test_gaussian_heights():
    """10^6 numbers: Ssk = 0, Sku = 3 within five standard errors, sqrt(6/n) and sqrt(24/n)."""
    rough = Topography(2e-9 * np.random.default_rng(0).standard_normal((1000, 1000)), [1e-6, 1e-6])
    assert rough.rms_height == pytest.approx(2e-9, rel=5.0 / (2e6) ** 0.5)
    assert rough.skewness == pytest.approx(0.0, abs=5.0 * (6e-6) ** 0.5)
    assert rough.kurtosis == pytest.approx(3.0, abs=5.0 * (24e-6) ** 0.5)


def test_a_tilted_plane_has_its_slope_on_pixels_that_are_not_square():
    x, y = np.arange(10.0)[:, None] * 0.5, np.arange(40.0)[None, :] * 0.1
    rough = Topography(0.3 * x - 0.4 * y, [5.0, 4.0])
    assert rough.pixel == (0.5, 0.1)
    assert rough.rms_slope == pytest.approx(0.5, rel=1e-12)


def test_statistics_leave_missing_heights_out():
    heights = np.array([[0.0, 2.0, np.nan], [2.0, 0.0, np.nan], [0.0, 2.0, np.nan]])
    rough = Topography(heights, [3.0, 3.0])
    assert rough.missing == 3
    assert rough.rms_height == 1.0
    assert rough.kurtosis == 1.0
    np.testing.assert_array_equal(rough.gaps[:, :2], 2.0 - heights[:, :2])
    assert np.isnan(rough.gaps[:, 2]).all()


def test_masked_arrays_keep_their_mask():
    """As SurfaceTopography returns maps with missing heights; the number below a mask is no height."""
    heights = np.ma.masked_greater(np.array([[0.0, 1.0, 0.0], [1.0, 1e30, 1.0], [0.0, 1.0, 0.0]]), 1e29)
    rough = Topography(heights, [1.0, 1.0])
    assert rough.missing == 1
    assert np.isnan(rough.heights[1, 1])


def test_a_map_does_not_change_with_the_array_it_was_made_from():
    heights = np.zeros((3, 3))
    rough = Topography(heights, [1.0, 1.0])
    heights[0, 0] = 1.0
    assert rough.heights[0, 0] == 0.0
    with pytest.raises(ValueError, match="read-only"):
        rough.heights[0, 0] = 1.0


@given(st.lists(st.floats(-1e-3, 1e-3), min_size=6, max_size=6), st.booleans())
def test_trends_are_taken_away_also_beside_holes(strengths, holes):
    x, y = np.linspace(-1.0, 1.0, 20)[:, None], np.linspace(-1.0, 1.0, 31)[None, :]
    terms = (1.0, x, y, x**2, x * y, y**2)
    bent = sum(strength * term for strength, term in zip(strengths, terms, strict=True)) + np.zeros((20, 31))
    if holes:
        bent[3:6, 4:9] = np.nan
    rough = Topography(bent, [1e-3, 5e-4])
    assert np.nanmax(np.abs(rough.detrended(2).heights)) < 1e-16
    assert rough.detrended(1).missing == rough.missing
    assert np.nanmean(rough.detrended(0).heights) == pytest.approx(0.0, abs=1e-16)
    flat = Topography(sum(s * t for s, t in zip(strengths[:3], terms[:3], strict=True)) + 0.0 * bent, [1e-3, 5e-4])
    assert np.nanmax(np.abs(flat.detrended().heights)) < 1e-16


def test_detrended_heights_are_what_least_squares_leave():
    """Nothing of a plane is left in them, and detrending again changes nothing."""
    rough = Topography(np.random.default_rng(1).standard_normal((17, 23)), [1.0, 3.0]).detrended(1)
    for term in (np.ones((17, 1)), np.arange(17.0)[:, None], np.arange(23.0)[None, :]):
        assert np.sum(rough.heights * term) == pytest.approx(0.0, abs=1e-11)
    np.testing.assert_allclose(rough.detrended(1).heights, rough.heights, atol=1e-14)


def test_holes_are_bridged_by_laplace():
    """Linear heights solve Laplace's equation, so they come back exactly."""
    x, y = np.arange(12.0)[:, None], np.arange(9.0)[None, :]
    plane = 2.0 * x - y
    holes = plane.copy()
    holes[4:8, 2:6] = holes[0, 0] = np.nan
    filled = Topography(holes, [1.0, 1.0]).filled()
    assert filled.missing == 0
    assert np.allclose(filled.heights[1:], plane[1:], atol=1e-12)
    assert np.nanmin(holes) <= filled.heights[0, 0] <= np.nanmax(holes)
    whole = Topography(plane, [1.0, 1.0])
    assert whole.filled() is whole


def test_what_is_not_trusted_is_masked():
    rough = wave()
    cut = rough.masked(rough.heights > 0.9)
    assert cut.missing == np.count_nonzero(rough.heights > 0.9)
    assert cut.periodic
    assert np.nanmax(cut.heights) <= 0.9
    with pytest.raises(
        InvalidInput, match=r"True or False for each of \(64, 48\) pixels; there is an array of float64"
    ):
        rough.masked(np.zeros((64, 48)))
    with pytest.raises(InvalidInput, match=r"with the shape \(2, 2\)"):
        rough.masked([[True, False], [False, False]])
    with pytest.raises(InvalidInput, match="all missing"):
        rough.masked(np.ones((64, 48), dtype=bool))


@pytest.mark.parametrize("periodic", [False, True])
def test_spikes_are_taken_away_and_nothing_else(periodic):
    rng = np.random.default_rng(2)
    x = np.arange(96) / 96
    smooth = np.cos(2.0 * np.pi * x)[:, None] * np.sin(4.0 * np.pi * x)[None, :]
    clean = Topography(smooth + 0.05 * rng.standard_normal((96, 96)), [1.0, 1.0], periodic)
    assert clean.without_spikes().missing == 0
    heights = clean.heights.copy()
    grains = [(0, 0), *((i, j) for i in (40, 41, 42, 43) for j in (40, 41, 42)), (95, 50)]
    for place in grains:
        heights[place] += 6.0
    found = Topography(heights, [1.0, 1.0], periodic).without_spikes()
    assert [tuple(place) for place in np.argwhere(np.isnan(found.heights))] == grains
    assert np.max(np.abs(found.filled().heights - clean.heights)) < 0.3
    with pytest.raises(InvalidInput, match=r"times = 0.0; give a positive number"):
        clean.without_spikes(0.0)


def scarred(clean, scars):
    """Return a map with scars (rows, columns, height), and where they are."""
    heights, where = clean.heights.copy(), np.zeros(clean.heights.shape, dtype=bool)
    for rows, columns, height in scars:
        heights[rows, columns] += height
        where[rows, columns] = True
    return Topography(heights, clean.lengths, clean.periodic), where


SCARS = [
    (slice(40, 140), slice(30, 31), 7e-7),
    (slice(0, 256), slice(90, 91), -6e-7),
    (slice(200, 206), slice(150, 152), 9e-7),
    (slice(20, 45), slice(200, 203), -9e-7),
    (slice(240, 241), slice(10, 60), 7e-7),
    (slice(60, 160), slice(255, 256), 9e-7),
]
"""Long and short, one to three pixels wide, up and down, along both directions, and the last line."""


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("periodic", [False, True])
def test_scars_are_found_along_their_whole_length(periodic):
    """Lower than the roughness (1 um), so that no height among those around betrays them."""
    surface = SelfAffine(0.8, rms_height=1e-6, longest=1e-3, shortest=2e-5)
    clean = Topography(random_topography(surface, (256, 256), [1e-3, 1e-3], seed=2).heights, [1e-3, 1e-3], periodic)
    rough, where = scarred(clean, SCARS)
    found = rough.spikes()
    assert not np.any(found.where & ~where)
    for rows, columns, _ in SCARS:
        assert np.mean(found.where[rows, columns]) > 0.95
    np.testing.assert_array_equal(np.isnan(rough.without_spikes().heights), found.where)
    bridged = rough.without_spikes().filled().heights
    np.testing.assert_allclose(found.height, rough.heights - bridged, atol=1e-20)
    assert np.sqrt(np.mean((bridged - clean.heights)[found.where] ** 2)) < 2e-7
    assert re.fullmatch(r"\d+ of 65536 pixels stand out by up to [\d.e-]+ m: \d+ of grains.*, \d+ of scars", str(found))
    assert str(clean.spikes()) == "no spikes"


def test_ground_surfaces_have_no_scars():
    """Every line of theirs has its own height, by chance."""
    lines = np.random.default_rng(3).standard_normal((1024, 1))
    assert Topography(np.tile(lines, 64), [16.0, 1.0]).without_spikes().missing == 0


@pytest.mark.slow
def test_scars_bear_nothing_of_a_real_scan(shared_data):
    """A scan of an atomic force microscope, on which lines of one pixel bear most of a load: found, they bear none."""
    pytest.importorskip("SurfaceTopography", reason="the extra 'topography' is not installed")
    scan = read_topography(shared_data / "topographies" / "di-3.di").detrended(1)
    assert scan.spikes().where.sum() < 20
    lines = [(slice(10, 60), slice(155, 156), 8e-8), (slice(70, 120), slice(210, 211), 8e-8)]
    lines += [(slice(0, 30), slice(39, 40), 8e-8), (slice(225, 256), slice(2, 3), 9e-8)]
    rough, where = scarred(scan, lines)
    medium = HalfSpace(Elastic(3e9, 0.4))

    def share(surface):
        pressure = SurfaceContact(surface, medium, Force(5e-4)).solve().last.pressure
        return np.sum(pressure[where]) / np.sum(pressure)

    assert share(rough) > 0.69
    assert np.mean(rough.spikes().where[where]) > 0.95
    assert share(rough.without_spikes().filled()) < 1.5 * share(scan) + 0.01


@pytest.mark.slow
def test_one_pixel_peaks_of_a_real_map_bear_less(shared_data):
    """They bore two thirds of a load after the grains alone had been taken away; two levels of noise are left."""
    pytest.importorskip("SurfaceTopography", reason="the extra 'topography' is not installed")
    scan = read_topography(shared_data / "topographies" / "sur-2.sur")
    medium, shares = HalfSpace(Elastic(210e9, 0.3)), []
    for surface in (scan.masked(scan.spikes().grains), scan.without_spikes()):
        smooth = surface.filled().detrended(2)
        peaks = np.zeros(smooth.heights.shape, dtype=bool)
        for axis in (0, 1):
            step = np.diff(np.moveaxis(smooth.heights, axis, 0), axis=0)
            above = np.minimum(step[:-1], -step[1:]) > 3.0 * np.median(np.abs(step))
            peaks |= np.moveaxis(np.pad(above, [(1, 1), (0, 0)]), 0, axis)
        pressure = SurfaceContact(smooth, medium, Force(1e-2)).solve().last.pressure
        shares.append(np.sum(pressure[peaks]) / np.sum(pressure))
    assert 0.6 < shares[0] < 0.75
    assert shares[1] < 0.8 * shares[0]


@pytest.mark.parametrize("hurst", [0.2, 0.8])
def test_rough_surfaces_have_no_spikes(hurst):
    surface = SelfAffine(hurst, rms_height=1e-6, longest=1e-3, shortest=8e-6)
    assert random_topography(surface, (256, 256), [1e-3, 1e-3], seed=0).without_spikes().missing == 0


def test_shapes_have_no_spikes():
    """Their ridges and apices belong to them."""
    x, y = np.arange(-40.0, 41.0)[:, None], np.arange(-40.0, 41.0)[None, :]
    for shape in (-np.hypot(x, y), -np.maximum(np.abs(x), np.abs(y)), -(x**2) - 3.0 * y**2, np.abs(x) + 0.0 * y):
        assert Topography(shape, [1.0, 1.0]).without_spikes().missing == 0


def test_a_part_and_a_coarser_map():
    rough = Topography(np.arange(24.0).reshape(4, 6), [4.0, 3.0], periodic=True)
    part = rough.cropped((1, 2), (2, 3))
    assert part.heights.tolist() == [[8.0, 9.0, 10.0], [14.0, 15.0, 16.0]]
    assert part.lengths.tolist() == [2.0, 1.5]
    assert part.pixel == rough.pixel
    assert not part.periodic
    coarse = rough.coarsened(2)
    assert coarse.heights.tolist() == [[3.5, 5.5, 7.5], [15.5, 17.5, 19.5]]
    assert coarse.lengths.tolist() == [4.0, 3.0]
    assert coarse.periodic


def test_blocks_that_are_not_whole_are_left_out():
    rough = Topography(np.arange(35.0).reshape(5, 7), [5.0, 14.0], periodic=True)
    coarse = rough.coarsened(2)
    assert coarse.heights.shape == (2, 3)
    assert coarse.lengths.tolist() == [4.0, 12.0]
    assert coarse.pixel == (2.0, 4.0)
    assert not coarse.periodic
    holed = rough.masked(np.arange(35).reshape(5, 7) == 8)
    assert np.argwhere(np.isnan(holed.coarsened(2).heights)).tolist() == [[0, 0]]


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (([1.0, 2.0], [1.0, 1.0]), r"heights have the shape \(2,\); give a map of at least 2 x 2 pixels, \(nx, ny\)"),
        ((np.zeros((3, 3)), [1.0, 0.0]), "two positive lengths in m"),
        ((np.zeros((3, 3)), [1.0, np.nan]), "two positive lengths in m"),
        ((np.zeros((3, 3)), [1.0]), "two positive lengths in m"),
        ((np.zeros((3, 3)), ["1 mm", "1 mm"]), "two positive lengths in m"),
        ((np.full((3, 3), np.nan), [1.0, 1.0]), "all missing"),
        ((np.full((3, 3), np.inf), [1.0, 1.0]), "infinite"),
        (("heights", [1.0, 1.0]), "give a number or an array of numbers"),
        (([[1.0, 2.0], [3.0]], [1.0, 1.0]), "give a number or an array of numbers"),
    ],
)
def test_what_is_no_map_is_refused(arguments, sentence):
    with pytest.raises(InvalidInput, match=f"^Topography: .*{sentence}"):
        Topography(*arguments)


def test_wrong_changes_are_refused():
    rough = wave()
    with pytest.raises(InvalidInput, match="detrend to the order 3"):
        rough.detrended(3)
    for first, count in (((60, 0), (10, 10)), ((-1, 0), (10, 10)), ((0, 0), (1, 10))):
        with pytest.raises(InvalidInput, match="not inside a map"):
            rough.cropped(first, count)
    with pytest.raises(InvalidInput, match="two whole numbers twice"):
        rough.cropped((0.5, 0), (10, 10))
    for times in (40, 0, 2.5, True):
        with pytest.raises(InvalidInput, match=f"cannot be coarsened {times} times"):
            rough.coarsened(times)


def test_what_a_flat_or_a_periodic_map_has_not():
    flat = Topography(np.zeros((4, 4)), [1.0, 1.0], True)
    for requested in (lambda: flat.skewness, lambda: flat.kurtosis):
        with pytest.raises(InvalidInput, match="a flat map has no skewness and no kurtosis"):
            requested()
    with pytest.raises(InvalidInput, match="would not fit its neighbours any more"):
        flat.detrended(1)
    assert flat.detrended(0) == flat
    for wrong in ("a", True, -1.0):
        with pytest.raises(InvalidInput, match="give a positive number"):
            flat.without_spikes(wrong)
    with pytest.raises(InvalidInput, match="periodic is 'no'; give True or False"):
        Topography(np.zeros((4, 4)), [1.0, 1.0], "no")
    with pytest.raises(InvalidInput, match="give a number or an array of numbers"):
        Topography(np.ones((4, 4)) * 1j, [1.0, 1.0])


@pytest.mark.parametrize("along", ["x", "y"])
def test_scan_lines_are_levelled(along):
    """A surface whose lines were shifted, tilted and bent one by one: what was added is found again."""
    rng = np.random.default_rng(5)
    lines, x = 24, np.linspace(-1.0, 1.0, 41)
    bend = np.stack([x**0, x, x**2])
    surface = rng.normal(size=(lines, 41))
    surface -= surface @ np.linalg.pinv(bend) @ bend  # without a parabola along any line
    added = rng.normal(size=(lines, 3)) * 5.0

    def levelled(by, strengths, rough=surface):
        drifted = rough + strengths @ bend
        drifted[3, 7] = np.nan
        heights = drifted.T if along == "x" else drifted
        return Topography(heights, [1.0, 1.0]).levelled(by, along)

    def lines_of(found):
        return found.heights.T if along == "x" else found.heights

    for by, kept in (("line", [1.0, 1.0, 0.0]), ("parabola", [1.0, 1.0, 1.0])):
        found = lines_of(levelled(by, added * kept))
        complete = np.delete(np.arange(lines), 3)
        given = surface + (added * kept) @ bend
        given[3, 7] = np.nan
        assert np.nanmean(found) == pytest.approx(np.nanmean(given), abs=1e-12)
        np.testing.assert_allclose(np.ptp(found[complete] - surface[complete]), 0.0, atol=1e-9)
    medians = np.nanmedian(lines_of(levelled("median", added)), axis=1)
    np.testing.assert_allclose(medians, medians[0], atol=1e-12)
    # a step that all lines share, and hills: the differences leave them, medians would not
    shared = np.where(x > 0.2, 3.0, 0.0) * np.ones((lines, 1))
    found = levelled("differences", added * [1.0, 0.0, 0.0], shared)
    np.testing.assert_allclose(np.ptp(lines_of(found)[4:] - shared[4:]), 0.0, atol=1e-12)
    assert found.removed == (f"of each scan line along {along} the median of its differences from the line before")
    assert any(note.statement == f"Removed from the measured heights: {found.removed}." for note in map_notes(found))


def test_lines_that_share_no_point_are_levelled_by_an_earlier_one():
    """Neighbours of which one half each is missing: the line after them is as far off as it was shifted."""
    heights = np.zeros((8, 5)) + np.array([0.0, 3.0, -200.0, 70.0, 1.0])
    heights[:4, 2] = heights[4:, 3] = np.nan
    found = Topography(heights, [1.0, 1.0]).levelled("differences").heights
    assert np.nanmax(found) - np.nanmin(found) < 1e-12
    heights[4:, :2] = np.nan
    with pytest.raises(InvalidInput, match="scan line 2 has no measured point beside one of a line before it"):
        Topography(heights, [1.0, 1.0]).levelled("differences")


def test_lines_that_cannot_be_levelled():
    wave = Topography(np.random.default_rng(0).random((8, 8)), [1.0, 1.0], periodic=True)
    assert np.ptp(np.median(wave.levelled().heights, axis=0)) < 1e-15
    with pytest.raises(InvalidInput, match="would not fit its neighbours"):
        wave.levelled("line")
    with pytest.raises(InvalidInput, match=r"by 'medain' \(did you mean 'median'\?\); give median, "):
        wave.levelled("medain")
    with pytest.raises(InvalidInput, match="run along 'z'; give x or y"):
        wave.levelled(along="z")
