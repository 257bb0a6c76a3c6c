"""The cases of moving bands and ellipses of heat agree with `moving_heat_solutions`, and these with closed forms."""

import tomllib
from pathlib import Path

import numpy as np
import pytest
from moving_heat_solutions import REFERENCES, band, elliptic, hertz_band, hertz_band_mean
from scipy.special import k0e, k1e

import winkler

CLOSE = {"elliptic_heating_skew": 1e-12, "line_heating_discs": 1e-12}
"""What quadratures repeat on another machine."""
CASES = Path(winkler.__file__).parent / "cases"


@pytest.mark.few(1, slow=2)
@pytest.mark.parametrize("name", REFERENCES)
def test_a_case_states_what_the_reference_solution_gives(name):
    expected = tomllib.loads((CASES / f"{name}.toml").read_text(encoding="utf-8"))["expect"]
    np.testing.assert_allclose(
        [item["value"] for item in expected],
        [float(number) for number in REFERENCES[name]()],
        rtol=CLOSE.get(name, 1e-13),
    )


def test_a_slow_band_is_as_warm_as_line_sources_that_hardly_move():
    """K0(z) is -ln(z/2) - gamma; under a half-ellipse -ln|x - s| is ln 2 + 1/2 - x^2 in the mean."""
    wave, x = 1e-12, 0.3
    middle = np.log(4.0 / wave) - np.euler_gamma + np.log(2.0) + 0.5
    assert hertz_band(x, wave) == pytest.approx((middle - x * x) / np.pi, rel=1e-11)
    assert hertz_band_mean(wave) == pytest.approx((middle - 1.0 / 3.0) / np.pi, rel=1e-11)


def test_the_mean_of_a_band_has_bessel_functions():
    """The integral of exp(t) K0(t) is t exp(t) (K0 + K1) - 1, from which an even flux has its mean."""
    wave = 10.0
    even = 0.5 * np.pi * sum(
        w * np.cos(0.5 * np.pi * n) * band(np.sin(0.5 * np.pi * n), wave, lambda angle: 0.5 * np.cos(angle))
        for n, w in zip(*np.polynomial.legendre.leggauss(60), strict=True)
    ) / 2.0  # fmt: skip
    node, weight = np.polynomial.legendre.leggauss(200)
    z = 0.25 * wave * (node + 1.0) * 2.0
    down = z * (k0e(z) + k1e(z)) - 1.0
    up = 1.0 - z * np.exp(-2.0 * z) * (k1e(z) - k0e(z))
    wanted = float(np.sum((down + up) * weight)) / 2.0 / (np.pi * wave)
    assert even == pytest.approx(wanted, rel=1e-7)


def test_the_sum_of_point_sources_is_the_closed_form_of_a_ball():
    """Under Hertz' flux of 1 W on the unit disc at rest lambda T is 3 (2 - r^2)/16."""
    for x, y in ((0.0, 0.0), (0.3, -0.5)):
        assert elliptic(x, y, (1.0, 1.0), 0.0, 0.0) == pytest.approx(3.0 * (2.0 - x * x - y * y) / 16.0, rel=1e-12)
