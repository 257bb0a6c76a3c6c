"""The cases of moving bands and ellipses of heat agree with `moving_heat_solutions`, and these with closed forms."""

import tomllib
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest
from moving_heat_solutions import REFERENCES, hertz_band, hertz_band_mean

import winkler

CASES = Path(winkler.__file__).parent / "cases"


@pytest.mark.parametrize("name", REFERENCES)
def test_a_case_states_what_the_reference_solution_gives(name):
    expected = tomllib.loads((CASES / f"{name}.toml").read_text(encoding="utf-8"))["expect"]
    np.testing.assert_allclose(
        [item["value"] for item in expected], [float(number) for number in REFERENCES[name]()], rtol=1e-13
    )


def test_a_slow_band_is_as_warm_as_line_sources_that_hardly_move():
    """K0(z) is -ln(z/2) - gamma; the mean of -ln|x - s| under a half-ellipse is ln 2 + 1/2 - x^2."""
    wave, x = mp.mpf("1e-12"), mp.mpf("0.3")
    slow = (mp.log(4 / wave) - mp.euler + mp.log(2) + mp.mpf(1) / 2 - x**2) / mp.pi
    assert float(hertz_band(x, wave) / slow) == pytest.approx(1.0, rel=1e-10)


def test_the_mean_of_a_slow_band():
    """The mean of x^2 is 1/3."""
    wave = mp.mpf("1e-9")
    slow = (mp.log(4 / wave) - mp.euler + mp.log(2) + mp.mpf(1) / 6) / mp.pi
    with mp.workdps(25):
        assert float(hertz_band_mean(wave) / slow) == pytest.approx(1.0, rel=1e-8)
