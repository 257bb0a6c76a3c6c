"""What is found of a map before it is pressed: texture, curvature, the limit of its tip, what is bad about it."""

from __future__ import annotations

import math

import numpy as np
import pytest

from winkler.profiles.rough.correlation import correlation_lengths
from winkler.profiles.rough.map_notes import border_leap, map_notes
from winkler.profiles.rough.map_statistics import map_statistics
from winkler.profiles.rough.random_surface import RandomTopography
from winkler.profiles.rough.spectrum import SelfAffine
from winkler.profiles.rough.tip_limit import curvature_over_distance, share_below, tip_limit
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput
from winkler.values.validity import Standing

COUNT = 256
X = (np.arange(COUNT) + 0.5) / COUNT


def hills(along, across, angle, seed=3):
    """Random phases under amplitudes whose autocorrelation is exp(-u^2 / 2 along^2 - v^2 / 2 across^2), turned."""
    q = 2.0 * np.pi * np.fft.fftfreq(COUNT, 1.0 / COUNT)
    u = q[:, None] * math.cos(angle) + q[None, :] * math.sin(angle)
    v = -q[:, None] * math.sin(angle) + q[None, :] * math.cos(angle)
    white = np.fft.fft2(np.random.default_rng(seed).standard_normal((COUNT, COUNT)))
    heights = np.fft.ifft2(white / np.abs(white) * np.exp(-((u * along) ** 2 + (v * across) ** 2) / 4.0)).real
    return Topography(1e-3 * heights / np.std(heights), [1.0, 1.0], periodic=True)


@pytest.mark.parametrize(("angle", "across"), [(0.0, 0.015), (math.radians(30.0), 0.015), (math.radians(135.0), 0.02)])
def test_texture_of_elongated_hills(angle, across):
    """Less the share m = 2 pi l_1 l_2 of the mean, the autocorrelation is (exp(-r^2 / 2 l^2) - m) / (1 - m)."""
    found = correlation_lengths(hills(0.04, across, angle))
    mean = 2.0 * math.pi * 0.04 * across
    reach = math.sqrt(-2.0 * math.log(0.2 + 0.8 * mean))
    assert found.shortest == pytest.approx(across * reach, rel=1e-3)
    assert found.longest == pytest.approx(0.04 * reach, rel=1e-3)
    assert found.aspect == pytest.approx(across / 0.04, rel=2e-3)
    assert math.degrees(found.direction) == pytest.approx(math.degrees(angle), abs=1.1)


def test_texture_of_a_part_with_holes():
    """A part of the map that stands alone, a tenth of its heights missing, says nearly the same, in all units."""
    whole = hills(0.02, 0.02, 0.0)
    lost = np.random.default_rng(0).random((COUNT, COUNT)) < 0.1
    part = Topography(np.where(lost, np.nan, whole.heights), [1.0, 1.0])
    found, there = correlation_lengths(part), correlation_lengths(whole)
    assert found.shortest == pytest.approx(there.shortest, rel=0.1)
    small = correlation_lengths(Topography(1e-9 * part.heights, [1e-9, 1e-9]))
    assert small.shortest == pytest.approx(1e-9 * found.shortest, rel=1e-9)


def test_a_trend_is_correlated_everywhere_along_it():
    grooves = Topography(np.cos(2.0 * np.pi * 8.0 * X)[:, None] + 0.0 * X, [1.0, 1.0], periodic=True)
    found = map_statistics(grooves)
    assert found.correlation_length == pytest.approx(math.acos(0.2) / (16.0 * math.pi), rel=1e-3)
    assert found.texture_aspect == 0.0
    assert found.texture_direction == pytest.approx(0.5 * math.pi, abs=0.02)
    with pytest.raises(InvalidInput, match="flat map has no correlation"):
        correlation_lengths(Topography(np.zeros((8, 8)), [1.0, 1.0]))


@pytest.mark.parametrize("periodic", [True, False])
def test_curvature_of_crossed_waves(periodic):
    """Half the second difference of A cos k x is A (1 - cos k h) / h^2 of the wave, on pixels that are not square."""
    nx, ny = 64, 48
    x, y = np.arange(nx) / nx, np.arange(ny) / ny * 2.0
    k, m = 2.0 * np.pi * 3.0, 2.0 * np.pi * 2.0
    rough = Topography(0.2 * np.cos(k * x)[:, None] + 0.1 * np.cos(m * y), [1.0, 2.0], periodic=periodic)
    bent = [a * (1.0 - math.cos(q * h)) / h**2 for a, q, h in ((0.2, k, 1.0 / nx), (0.1, m, 2.0 / ny))]
    assert map_statistics(rough).rms_curvature == pytest.approx(
        math.hypot(*bent) / math.sqrt(2.0), rel=1e-12 if periodic else 0.05
    )


def scanned_spike(radius, height):
    """What a ball of a radius reports of a needle on a floor: its own cap."""
    x = np.arange(-80, 81) * 0.01
    r = np.hypot(x[:, None], x[None, :])
    cap = height - radius + np.sqrt(np.maximum(radius**2 - r**2, 0.0))
    return Topography(np.where(r < radius, np.maximum(cap, 0.0), 0.0), [1.61, 1.61], tip_radius=radius)


@pytest.mark.parametrize(("radius", "height"), [(0.2, 0.05), (0.3, 0.02), (0.1, 0.1)])
def test_the_limit_of_a_tip_on_a_needle(radius, height):
    """Over places a apart the second difference is 2 H / a^2, half the curvature of the tip at 2 a = 4 sqrt(R H)."""
    assert tip_limit(scanned_spike(radius, height)) == pytest.approx(4.0 * math.sqrt(radius * height), rel=1e-9)


@pytest.mark.slow
def test_the_limit_beside_that_of_surface_topography():
    library = pytest.importorskip("SurfaceTopography", reason="the extra 'topography' is not installed")
    rough = RandomTopography([1.0, 1.0], SelfAffine(0.8, 0.02, 0.5, 0.02), (128, 128), seed=1, periodic=False)
    sharp = curvature_over_distance(rough).sharpest[0]
    for times in (2.0, 8.0):
        tip = times / sharp
        mine = Topography(rough.heights, rough.lengths, tip_radius=tip)
        found = [
            library.Topography(z, (1.0, 1.0)).scanning_probe_reliability_cutoff(tip)
            for z in (rough.heights, rough.heights.T)
        ]
        assert tip_limit(mine) == pytest.approx(max(found), rel=0.1)
    blunt = Topography(rough.heights, rough.lengths, tip_radius=0.4 / sharp)
    assert tip_limit(blunt) == 0.0
    assert tip_limit(Topography(rough.heights, rough.lengths, tip_radius=1e6)) == 1.0
    assert tip_limit(rough) == 0.0


def test_the_share_of_slopes_below_a_length():
    """Over a length s the slope of a wave is A sin(k s / 2) / (s / 2), on the grid as between neighbours."""
    long, short = 2.0 * np.pi * 2.0, 2.0 * np.pi * 32.0
    z = 0.1 * np.cos(long * X) + 0.01 * np.cos(short * X)
    rough = Topography(z[:, None] + np.zeros((COUNT, 8)), [1.0, 8.0 / COUNT], periodic=True)

    def square(s):
        return sum(0.5 * (a * math.sin(0.5 * k * s) / (0.5 * s)) ** 2 for a, k in ((0.1, long), (0.01, short)))

    length = 8.0 / COUNT
    assert share_below(rough, length) == pytest.approx(1.0 - square(length) / square(1.0 / COUNT), rel=1e-9)


def test_contacts_are_told_of_the_tip():
    sharp = scanned_spike(0.2, 0.05)
    (note,) = map_notes(sharp)
    assert note.standing is Standing.OUTSIDE
    assert "Below 0.4 m, 40 pixels, a tip of 0.2 m has rounded the map" in note.statement
    blunt = Topography(hills(0.1, 0.1, 0.0).heights, [1.0, 1.0], tip_radius=1e-3)
    (fine,) = map_notes(blunt)
    assert fine.standing is Standing.ASYMPTOTIC
    for changed in (blunt.detrended(1), blunt.filled(), blunt.coarsened(2), blunt.cropped((3, 4), (20, 30))):
        assert changed.tip_radius == 1e-3


def test_contacts_are_told_what_was_taken_out():
    heights = hills(0.05, 0.05, 0.0).heights.copy()
    heights[40:42, 100] += 0.1
    heights[200, 30:90] += 0.05
    clean = Topography(heights, [1.0, 1.0]).without_spikes().filled()
    assert clean.missing == 0
    (note,) = map_notes(clean)
    assert note.statement.startswith("Removed from the measured heights, and bridged: 6")
    assert "of grains and dropouts" in note.statement
    assert "of scars" in note.statement
    untouched = hills(0.05, 0.05, 0.0)
    assert untouched.without_spikes() is untouched


def test_a_part_of_a_surface_is_not_periodic():
    """Every second one of many parts of a map leaps more than any step inside; whole maps do not."""
    whole = hills(0.06, 0.06, 0.0)
    assert border_leap(whole) < 1.5
    assert map_notes(whole) == ()
    part = Topography(whole.heights[:90, :], [90 / 256, 1.0], periodic=True)
    (note,) = map_notes(part)
    assert note.standing is Standing.OUTSIDE
    assert note.statement.endswith("The periodic continuation has a cliff there: leave periodic out.")
    assert map_notes(Topography(part.heights, part.lengths)) == ()
