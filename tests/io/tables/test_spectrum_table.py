"""Measured spectra from tables: what may stand in the columns, what densities are counted per, and refusals."""

from __future__ import annotations

import math

import numpy as np
import pytest

from winkler.io.tables.spectrum_table import read_spectrum
from winkler.study.language.reading import parse_study
from winkler.values.errors import InvalidInput

Q = np.array([1.0, 2.0, 5.0, 20.0])
"""In 1/um."""
C = np.array([8.0, 1.0, 0.064, 1e-3])
"""In um^4."""
PER_FREQUENCY = (2.0 * np.pi) ** 2


@pytest.fixture
def file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)

    def write(header, first=Q, second=C):
        rows = "".join(f"{a!r},{b!r}\n" for a, b in zip(first.tolist(), second.tolist(), strict=True))
        (tmp_path / "psd.csv").write_text(header + "\n" + rows, encoding="utf-8")
        return "psd.csv"

    return write


@pytest.mark.parametrize(
    ("header", "first", "factor"),
    [
        ("wave_number [1/um], density [um^4]", Q, 1.0),
        ("q [rad/um], psd [um^4]", Q, 1.0),
        ("Wavevector (µm⁻¹),PSD (µm⁴)", Q, 1.0),
        ("wavelength [um], c [um^4]", 2.0 * np.pi / Q, 1.0),
        # a density per frequency squared is that per wave number times (2 pi)^2
        ("frequency [1/um], density [um^4]", Q / (2.0 * np.pi), 1.0 / PER_FREQUENCY),
    ],
)
def test_columns(file, header, first, factor):
    spectrum = read_spectrum(file(header, first))
    np.testing.assert_allclose(spectrum.wave_numbers, Q * 1e6, rtol=1e-14)
    np.testing.assert_allclose(spectrum.densities, C * 1e-24 * factor, rtol=1e-14)


def test_what_a_density_is_counted_per(file):
    """Frequencies q / (2 pi) in an area (2 pi)^2 times smaller, for the same mean square height."""
    name = file("q [1/um], psd [um^4]")
    np.testing.assert_allclose(read_spectrum(name, per="frequency").densities, C * 1e-24 / PER_FREQUENCY, rtol=1e-14)
    np.testing.assert_array_equal(read_spectrum(name, per="wave number").densities, read_spectrum(name).densities)
    name = file("f [1/um], psd [um^4]")
    np.testing.assert_allclose(read_spectrum(name, per="wave number").densities, C * 1e-24, rtol=1e-14)


@pytest.mark.parametrize(
    ("header", "first", "second", "sentence"),
    [
        ("q [1/um], psd [um^2]", Q, C, "psd.csv, line 1, density: 'um^2' is the unit of an area, not of a quantity in"),
        ("q [1/um], psd [um^3]", Q, 1.0 / C, "psd.csv: spectrum_of_lines: the densities do not fall"),
        ("q [um], psd [um^4]", Q, C, "psd.csv, line 1, wave number: 'um' is the unit of a length, not of an inverse"),
        ("x [um], psd [um^4]", Q, C, "psd.csv: the header has no wave number (wave_number, wave number, wavenumber"),
        ("q [1/um], psd [um^4]", Q - 1.0, C, "psd.csv, line 2: the wave number is not positive; delete the line."),
        (
            "q [1/um], psd [um^4]",
            Q,
            C - 1.0,
            "psd.csv: PowerSpectrum: densities is 0.0 at index ",
        ),
        ("q [1/um], psd [um^4]", np.ones(4), C, "psd.csv: PowerSpectrum: wave_numbers does not rise"),
    ],
)
def test_refusals(file, header, first, second, sentence):
    with pytest.raises(InvalidInput) as caught:
        read_spectrum(file(header, first, second))
    assert str(caught.value).startswith(sentence)


def test_an_unknown_count_is_refused(file):
    with pytest.raises(InvalidInput, match=r"^read_spectrum: per is 'q'; give 'wave number' or 'frequency'\.$"):
        read_spectrum(file("q [1/um], psd [um^4]"), per="q")
    with pytest.raises(InvalidInput, match="there is no such file"):
        read_spectrum("nowhere.csv")


@pytest.mark.parametrize("hurst", [0.3, 0.8, 1.0])
def test_line_scans_are_stated_by_their_unit(file, hurst):
    """Lines on a surface with C = q^(-2 (H + 1)): sqrt(pi) Gamma(H + 1/2) / Gamma(H + 1) q^(-2 H - 1)."""
    line = math.sqrt(math.pi) * math.gamma(hurst + 0.5) / math.gamma(hurst + 1.0) * Q ** (-2.0 * hurst - 1.0)
    text = [
        read_spectrum(file("q [1/um], psd [um^3]", Q, line)),
        read_spectrum(file("q [rad/um], psd [um^3]", Q[::-1], line[::-1])),
        read_spectrum(file("f [1/um], psd [um^3]", Q / (2.0 * np.pi), line * 2.0 * np.pi)),
        read_spectrum(file("q [1/um], psd [um^3]", Q, line * 2.0 * np.pi), per="frequency"),
    ]
    for spectrum in text:
        np.testing.assert_allclose(spectrum.wave_numbers, Q * 1e6, rtol=1e-14)
        np.testing.assert_allclose(spectrum.densities, 1e-24 * Q ** (-2.0 * hurst - 2.0), rtol=1e-12)


STUDY = """
[problem]
kind = "rough_contact"
side = "1 mm"
realisations = 1
load = { kind = "force", force = "1 N" }
spectrum = { kind = "power_spectrum", file = "psd.csv", per = "frequency" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 GPa", poisson = 0.3 } }
"""


def test_a_study_takes_the_table(file, tmp_path):
    name = file("q [1/um], psd [um^4]")
    assert parse_study(STUDY, folder=tmp_path).problem.spectrum == read_spectrum(name, per="frequency")
    with pytest.raises(InvalidInput, match="per is 'area'; give 'wave number' or 'frequency'"):
        parse_study(STUDY.replace('"frequency"', '"area"'), folder=tmp_path)
