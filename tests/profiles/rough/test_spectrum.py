"""Spectra of rough surfaces: closed forms, what is measured on maps, and two instruments joined."""

from __future__ import annotations

import numpy as np
import pytest
from mpmath import mp, mpf, quad, sqrt

from winkler.profiles.rough.map_spectrum import spectrum_of
from winkler.profiles.rough.random_rough import random_topography
from winkler.profiles.rough.spectrum import PowerSpectrum, SelfAffine
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput

BLASTED = SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=1e-5, roll_off=2.5e-4)


@pytest.mark.parametrize("hurst", ["0.1", "0.5", "0.8", "1"])
@pytest.mark.parametrize("roll_off", ["2.5e-4", "1e-3", "inf"])
def test_a_self_affine_surface_has_its_height_and_slope(hurst, roll_off):
    """Against integrals of the plain power law at 30 digits."""
    spectrum = SelfAffine(float(hurst), rms_height=1e-6, longest=1e-3, shortest=1e-5, roll_off=float(roll_off))
    with mp.workdps(30):
        low, high = 2 * mp.pi / mpf("1e-3"), 2 * mp.pi / mpf("1e-5")
        bend = max(low, 2 * mp.pi / mpf(roll_off))

        def shape(q):
            return (max(q / bend, mpf(1))) ** (-2 * (mpf(hurst) + 1))

        height = 2 * mp.pi * quad(lambda q: q * shape(q), [low, bend, 10 * bend, high])
        slope = 2 * mp.pi * quad(lambda q: q**3 * shape(q), [low, bend, 10 * bend, high])
        expected = float(mpf("1e-6") * sqrt(slope / height))
        density = float(mpf("1e-12") / height * shape(mpf(10**5)))
    assert spectrum.rms_slope == pytest.approx(expected, rel=1e-13)
    assert float(spectrum.at(np.array(1e5))) == pytest.approx(density, rel=1e-13)
    assert spectrum.at(np.array([6e3, 7e5])).tolist() == [0.0, 0.0]


def test_numbers_between_which_it_is_a_power_law():
    """C = q^-4 from 1 to 100, and level above: heights and slopes in closed form."""
    spectrum = PowerSpectrum([1.0, 3.0, 10.0, 100.0, 200.0], [1.0, 3.0**-4, 1e-4, 1e-8, 1e-8])
    height = 2.0 * np.pi * (0.5 * (1.0 - 1e-4) + 1e-8 * 0.5 * (200.0**2 - 100.0**2))
    slope = 2.0 * np.pi * (np.log(100.0) + 1e-8 * 0.25 * (200.0**4 - 100.0**4))
    assert spectrum.rms_height == pytest.approx(height**0.5, rel=1e-14)
    assert spectrum.rms_slope == pytest.approx(slope**0.5, rel=1e-14)
    np.testing.assert_allclose(spectrum.at(np.array([2.0, 50.0, 150.0])), [2.0**-4, 50.0**-4, 1e-8], rtol=1e-13)
    assert spectrum.at(np.array([0.5, 201.0])).tolist() == [0.0, 0.0]


def test_a_wave_has_its_power_at_its_wave_number():
    """A cosine of amplitude h has the mean square h^2 / 2, all of it at one wave number."""
    x = np.arange(256) / 256
    rough = Topography(np.cos(2.0 * np.pi * 20.0 * x)[:, None] + 1e-9 * np.cos(60.0 * np.pi * x), [1.0, 1.0], True)
    spectrum = spectrum_of(rough)
    highest = spectrum.wave_numbers[np.argmax(spectrum.densities)]
    assert highest == pytest.approx(2.0 * np.pi * 20.0, rel=0.06)  # half a bin


@pytest.mark.parametrize("hurst", [0.3, 0.8])
@pytest.mark.parametrize("roll_off", [1e-3, 3e-4])
@pytest.mark.parametrize(("shape", "lengths"), [((256, 256), (1e-3, 1e-3)), ((200, 300), (1e-3, 1.2e-3))])
def test_parseval(hurst, roll_off, shape, lengths):
    """The height of the spectrum is that of the map: all waves have been counted, the longest ones too."""
    made_from = SelfAffine(hurst, rms_height=1e-6, longest=1e-3, shortest=1e-5, roll_off=roll_off)
    rough = random_topography(made_from, shape, lengths, seed=1)
    measured = spectrum_of(rough)
    assert measured.rms_height == pytest.approx(rough.rms_height, rel=0.04)
    assert measured.rms_slope == pytest.approx(made_from.rms_slope, rel=0.04)
    q = np.geomspace(5e4, 5e5, 9)
    np.testing.assert_allclose(measured.at(q), made_from.at(q), rtol=0.06)


def waves(amplitudes, number=256):
    """Return a periodic map of parallel waves: amplitude -> mean square height h^2/2 and gradient (q h)^2/2."""
    x = 2.0 * np.pi * np.arange(number) / number
    heights = sum(h * np.cos(k * x + 0.7 * k) for k, h in amplitudes.items())
    height = sum(0.5 * h**2 for h in amplitudes.values()) ** 0.5
    slope = sum(0.5 * (2.0 * np.pi * k * h) ** 2 for k, h in amplitudes.items()) ** 0.5
    return Topography(np.tile(heights[:, None], number), [1.0, 1.0], True), height, slope


@pytest.mark.parametrize(
    "amplitudes",
    [
        {20: 1.0},
        {1: 1.0},
        {127: 3.0},
        {k: 1.0 / k for k in range(16, 128, 16)},  # turned: a feed and its overtones
        {k: abs(np.cos(3.0 * k)) / k for k in range(1, 128)},  # ground: lines of all wavelengths
    ],
    ids=["sine", "longest", "shortest", "turned", "ground"],
)
def test_lines_keep_their_power(amplitudes):
    """Parseval, to rounding: a sine of rms height 0.707 came back as 0.127."""
    rough, height, slope = waves(amplitudes)
    spectrum = spectrum_of(rough)
    assert spectrum.rms_height == pytest.approx(height, rel=1e-11)
    assert spectrum.rms_slope == pytest.approx(slope, rel=1e-10)
    again = random_topography(spectrum, (256, 256), (1.0, 1.0), seed=1)
    assert again.rms_height == pytest.approx(height, rel=0.04)


@pytest.mark.few(12)
@pytest.mark.parametrize("number", range(1, 32))
def test_a_line_beside_noise_keeps_its_power(number):
    """Wherever it lies between the rings."""
    x = 2.0 * np.pi * np.arange(64) / 64
    noise = 1e-3 * np.random.default_rng(1).standard_normal((64, 64))
    rough = Topography(np.cos(number * x)[:, None] + noise, [1.0, 1.0], True)
    power = np.abs(np.fft.fft2(rough.heights - rough.heights.mean())) ** 2 / rough.heights.size**2
    q = 2.0 * np.pi * np.fft.fftfreq(64, 1.0 / 64)
    assert spectrum_of(rough).rms_height == pytest.approx(rough.rms_height, rel=1e-11)
    assert spectrum_of(rough).rms_slope == pytest.approx(np.sum(power * (q[:, None] ** 2 + q**2)) ** 0.5, rel=1e-10)


@pytest.mark.parametrize("shape", [(256, 256), (200, 300), (64, 8), (5, 7)])
def test_parseval_holds_up_to_the_corners(shape):
    """Waves of all directions and amplitudes, up to the shortest that the pixels bear."""
    rng = np.random.default_rng(4)
    rough = Topography(rng.standard_normal(shape).cumsum(0), [2.0, 3.0], True)
    power = np.abs(np.fft.fft2(rough.heights - rough.heights.mean())) ** 2 / rough.heights.size**2
    qx, qy = (2.0 * np.pi * np.fft.fftfreq(n, step) for n, step in zip(shape, rough.pixel, strict=True))
    spectrum = spectrum_of(rough)
    assert spectrum.rms_height == pytest.approx(rough.rms_height, rel=1e-11)
    assert spectrum.rms_slope == pytest.approx(np.sum(power * (qx[:, None] ** 2 + qy**2)) ** 0.5, rel=1e-10)


def test_a_map_that_stands_alone_has_its_height_in_the_mean():
    """Of a sine with many periods the window takes nothing: 20 periods, of which it leaves the power."""
    rough, height, slope = waves({20: 1.0})
    alone = spectrum_of(Topography(rough.heights, rough.lengths))
    assert alone.rms_height == pytest.approx(height, rel=1e-3)
    assert alone.rms_slope == pytest.approx(slope, rel=1e-2)


def test_a_map_that_stands_alone_is_faded_out():
    """Cut-outs of a rough surface, tilted: the mean of their spectra is that of the surface."""
    rough = random_topography(BLASTED, (768, 768), (3e-3, 3e-3), seed=5)
    q, stated = np.geomspace(4e4, 5e5, 9), []
    for first in ((0, 0), (0, 400), (400, 0), (400, 400)):
        part = rough.cropped(first, (256, 256))
        tilted = Topography(part.heights + 1e-4 * np.linspace(0.0, 1.0, 256)[:, None], part.lengths)
        stated.append(spectrum_of(tilted).at(q))
    # a power of chance scatters by all of itself; 20 bins a decade, half of the waves follow from the other half, and
    # Hann's window joins (3/2)^2 of them
    waves = 4 * 0.5 * 2.0 * np.pi * (q / (2.0 * np.pi * 1e3)) ** 2 * np.log(10.0) / 20.0 / 1.5**2
    scatter = (np.mean(stated, axis=0) / BLASTED.at(q) - 1.0) * np.sqrt(waves)
    assert np.max(np.abs(scatter)) < 3.5
    assert waves[-1] > 4000.0
    no_window = np.abs(np.fft.fft2(tilted.heights)) ** 2
    assert no_window[1, 0] > 1e3 * no_window[0, 1]  # what the tilt would have done


def test_two_instruments_become_one():
    q = np.geomspace(1e3, 1e5, 30)
    first = PowerSpectrum(q, q**-3.6)
    second = PowerSpectrum(q * 30.0, 2.0 * (q * 30.0) ** -3.6)
    both = first.joined(second)
    assert both == second.joined(first)
    assert both.smallest == first.smallest
    assert both.greatest == second.greatest
    assert both.at(np.array([2e3])) == pytest.approx((2e3) ** -3.6, rel=1e-9)
    assert both.at(np.array([2e6])) == pytest.approx(2.0 * (2e6) ** -3.6, rel=1e-9)
    middle = 30.0**0.5 * 1e4  # as far inside of one as of the other
    assert both.at(np.array([middle])) / middle**-3.6 == pytest.approx(2.0**0.5, rel=0.02)
    assert both.at(np.array([1e2, 1e8])).tolist() == [0.0, 0.0]


def test_two_instruments_with_a_gap_between_them():
    """A power law bridges what neither has measured."""
    first, second = PowerSpectrum([1.0, 10.0], [1.0, 1e-3]), PowerSpectrum([1e3, 1e4], [1e-9, 1e-12])
    both = first.joined(second)
    assert both.wave_numbers.tolist() == [1.0, 10.0, 1e3, 1e4]
    assert both.at(np.array([100.0])) == pytest.approx(1e-6, rel=1e-12)


def test_maps_at_two_scales_are_joined():
    """A coarse map of a large part and a fine map of a small one give the surface that both are of."""
    surface = SelfAffine(hurst=0.7, rms_height=1e-6, longest=1e-3, shortest=2e-6, roll_off=3e-4)
    coarse = spectrum_of(random_topography(surface, (256, 256), (1e-3, 1e-3), seed=1))
    fine = spectrum_of(random_topography(surface, (256, 256), (1e-4, 1e-4), seed=2))
    both = coarse.joined(fine)
    assert both.rms_height == pytest.approx(1e-6, rel=0.03)
    assert both.rms_slope == pytest.approx(surface.rms_slope, rel=0.03)
    assert coarse.rms_slope < 0.9 * surface.rms_slope


@pytest.mark.parametrize(
    ("numbers", "sentence"),
    [
        ({"hurst": 1.2, "rms_height": 1e-6, "longest": 1e-3, "shortest": 1e-6}, "hurst is 1.2; give a number above 0"),
        ({"hurst": 0.0, "rms_height": 1e-6, "longest": 1e-3, "shortest": 1e-6}, "hurst is 0.0; give a number above 0"),
        ({"hurst": 0.8, "rms_height": 0.0, "longest": 1e-3, "shortest": 1e-6}, "rms_height is 0.0; it must be"),
        ({"hurst": 0.8, "rms_height": 1e-6, "longest": "1 mm", "shortest": 1e-6}, "longest is '1 mm'; it must be"),
        ({"hurst": 0.8, "rms_height": 1e-6, "longest": 1e-6, "shortest": 1e-3}, "not in order; give shortest"),
        (
            {"hurst": 0.8, "rms_height": 1e-6, "longest": 1e-3, "shortest": 1e-6, "roll_off": 1e-7},
            "not in order; give shortest",
        ),
    ],
)
def test_wrong_numbers_are_refused(numbers, sentence):
    with pytest.raises(InvalidInput, match=f"^SelfAffine: .*{sentence}"):
        SelfAffine(**numbers)


@pytest.mark.parametrize(
    ("wave_numbers", "densities", "sentence"),
    [
        ([1.0, 3.0, 2.0], [1.0, 1.0, 1.0], "wave_numbers does not rise"),
        ([1.0, 2.0], [1.0, 1.0, 1.0], "there are 2 wave_numbers and 3 densities"),
        ([0.0, 2.0], [1.0, 1.0], "wave_numbers .*; give a row of at least 2 positive, finite numbers"),
        ([1.0, 2.0], [1.0, np.nan], "densities .*; give a row of at least 2 positive, finite numbers"),
        ([1.0], [1.0], "wave_numbers .*; give a row of at least 2"),
        (["a", "b"], [1.0, 1.0], "wave_numbers is .*; give a row of"),
    ],
)
def test_wrong_rows_are_refused(wave_numbers, densities, sentence):
    with pytest.raises(InvalidInput, match=f"^PowerSpectrum: {sentence}"):
        PowerSpectrum(wave_numbers, densities)


def test_maps_without_a_spectrum_are_refused():
    with pytest.raises(InvalidInput, match="the map is flat"):
        spectrum_of(Topography(np.zeros((8, 8)), [1.0, 1.0]))
    with pytest.raises(InvalidInput, match="1 heights are missing; fill them with topography.filled"):
        spectrum_of(Topography([[0.0, 1.0], [np.nan, 2.0]], [1.0, 1.0]))


@pytest.mark.parametrize("periodic", [False, True])
def test_surface_topography_finds_the_same(periodic):
    """An independent program; it counts per frequency, (2 pi)^2 times as much, and has bins of its own."""
    reference = pytest.importorskip("SurfaceTopography", reason="the extra 'topography' is not installed")
    rough = random_topography(BLASTED, (512, 512), (2e-3, 2e-3), seed=1)
    if not periodic:
        rough = rough.cropped((0, 0), (256, 200)).detrended(1)
    sizes = tuple((rough.lengths * 1e6).tolist())
    other = reference.Topography(rough.heights * 1e6, sizes, unit="um", periodic=periodic)
    assert rough.rms_height * 1e6 == pytest.approx(other.Sq(), rel=1e-9)
    assert rough.rms_slope == pytest.approx(other.rms_gradient(), rel=1e-9 if periodic else 2e-3)
    ratios = []
    edges = np.geomspace(5e-2, 0.5, 11)
    _, density = other.power_spectrum_from_area(collocation=edges)
    own = spectrum_of(rough)
    for first, last, theirs in zip(edges[:-1], edges[1:], density, strict=True):
        q = np.geomspace(first * 1e6, last * 1e6, 20001)
        mean = 2.0 * np.trapezoid(own.at(q) * q, q) / (q[-1] ** 2 - q[0] ** 2)
        ratios.append(mean / (theirs * 1e-24 / (2.0 * np.pi) ** 2))
    np.testing.assert_allclose(ratios, 1.0, rtol=0.02 if periodic else 0.3)
    assert np.mean(ratios) == pytest.approx(1.0, abs=0.01 if periodic else 0.05)
