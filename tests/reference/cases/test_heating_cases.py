"""The numbers of the heating cases, against sums of point sources and rings of heat, and the closed forms besides."""

import tomllib
from pathlib import Path

import mpmath
import numpy as np
import pytest
from theory_solutions import moving

from winkler.reference.heating import (
    disc_centre_rise,
    hertz_heat_temperature,
    moving_point_temperature,
    tian_kennedy_parabolic,
    uniform_heat_mean,
    uniform_heat_temperature,
)

CASES = Path(__file__).resolve().parents[3] / "src" / "winkler" / "cases"
RADIUS, LAMBDA, KAPPA = 1e-4, 45.0, 12e-6
FORCE = 4.0 / 3.0 * 210e9 / (2.0 * (1.0 - 0.09)) * RADIUS**3 / 10e-3


def expected(case):
    content = tomllib.loads((CASES / f"{case}.toml").read_text(encoding="utf-8"))
    return {item["quantity"]: item["value"] for item in content["expect"]}


def test_slow_sliding():
    numbers = expected("heating_at_rest")
    heat = 0.3 * FORCE * 1e-9
    assert numbers["heat_rate"] == pytest.approx(heat, rel=1e-14)
    assert numbers["first_max_temperature"] == pytest.approx(3.0 * heat / (8.0 * LAMBDA * RADIUS), rel=1e-14)
    assert numbers["first_mean_temperature"] == pytest.approx(9.0 * heat / (32.0 * LAMBDA * RADIUS), rel=1e-14)
    assert moving(0.0, 0.0) == pytest.approx(0.375, rel=1e-10)


def test_a_moving_plate_shared_by_blok():
    numbers = expected("heating_moving_ball")
    x = np.linspace(0.26, 0.30, 41)
    best = np.polynomial.Polynomial.fit(x - 0.28, [moving(1.0, each) for each in x], 8)
    top = max(
        float(best(root.real)) for root in best.deriv().roots() if abs(root.imag) < 1e-9 and abs(root.real) < 0.02
    )
    heat = 0.3 * FORCE * 0.24
    assert numbers["first_share"] == pytest.approx(0.375 / (0.375 + top), rel=1e-10)
    together = 1.0 / (1.0 / 0.375 + 1.0 / top) * heat / (LAMBDA * RADIUS)
    assert numbers["flash_temperature"] == pytest.approx(together, rel=1e-10)


def test_the_fit():
    heat = 0.3 * FORCE * 0.24
    fit = tian_kennedy_parabolic(heat, RADIUS, LAMBDA, 1.0)
    assert expected("heating_tian_kennedy")["first_max_temperature"] == pytest.approx(float(fit), rel=1e-5)


def test_a_contact_that_begins_to_rub():
    numbers = expected("heating_begins")["flash_temperature"]
    heat = 0.3 * FORCE * 1e-3
    for number, tau in zip(numbers, ("0.1", "1", "10"), strict=True):
        length = mpmath.sqrt(mpmath.mpf(tau))
        rings = mpmath.quad(lambda r: mpmath.sqrt(1 - r * r) * mpmath.erfc(r / (2 * length)), [0, 1])  # noqa: B023
        wanted = float(1.5 / mpmath.pi * rings) * heat / (2.0 * LAMBDA * RADIUS)
        assert number == pytest.approx(wanted, rel=1e-13)


def test_the_closed_forms_hang_together():
    """Outside the disc and far away both fluxes are a point source; the mean is the integral over the disc."""
    far = 200.0 * RADIUS
    point = moving_point_temperature(2.0, LAMBDA, KAPPA, 0.0, far, 0.0)
    assert hertz_heat_temperature(2.0, RADIUS, LAMBDA, far) == pytest.approx(float(point), rel=1e-5)
    edge = hertz_heat_temperature(2.0, RADIUS, LAMBDA, RADIUS * np.array([1.0, 1.0 + 1e-12]))
    assert edge[1] == pytest.approx(edge[0], rel=1e-5)
    r = mpmath.quad(lambda s: 2 * s * mpmath.ellipe(s * s) * 2 / mpmath.pi**2, [0, 1])
    assert uniform_heat_mean(1.0, 1.0, 1.0) == pytest.approx(float(r), rel=1e-12)
    assert uniform_heat_temperature(np.pi, 1.0, 1.0, 0.0) == pytest.approx(1.0, rel=1e-14)
    assert uniform_heat_temperature(np.pi, 1.0, 1.0, 1.0) == pytest.approx(2.0 / np.pi, rel=1e-14)
    behind = moving_point_temperature(1.0, 1.0, 1.0, 4.0, [1.0, -1.0], 0.0)
    assert behind[0] == pytest.approx(1.0 / (2.0 * np.pi))
    assert behind[1] == pytest.approx(np.exp(-4.0) / (2.0 * np.pi))
    assert float(disc_centre_rise(1e6)) == pytest.approx(1.0, abs=1e-3)
