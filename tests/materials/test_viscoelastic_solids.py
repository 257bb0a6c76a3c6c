"""Viscoelastic solids: closed forms, mpmath, temperature, and what is refused."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

from winkler.materials.fractional import FractionalZener, PowerLawSolid
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.materials.temperature import Arrhenius, WilliamsLandelFerry
from winkler.materials.viscoelastic import GeneralisedKelvin, Prony
from winkler.values.errors import InvalidInput, OutsideValidity

TIMES = np.array([1e-3, 0.1, 1.0, 20.0])
OMEGA = np.array([1e-3, 0.3, 1.0, 50.0])


def test_closed_forms():
    voigt = KelvinVoigt(2.0, 3.0)
    assert voigt.relaxation(TIMES) == pytest.approx(2.0 + 0.0 * TIMES)
    assert voigt.creep(TIMES) == pytest.approx(-np.expm1(-2.0 * TIMES / 3.0) / 2.0, rel=1e-13)
    assert voigt.loss(OMEGA) == pytest.approx(3.0 * OMEGA, rel=1e-14)
    maxwell = Maxwell(2.0, 3.0)
    assert maxwell.relaxation(TIMES) == pytest.approx(2.0 * np.exp(-TIMES / 3.0), rel=1e-14)
    assert maxwell.storage(OMEGA) == pytest.approx(2.0 * (3 * OMEGA) ** 2 / (1 + (3 * OMEGA) ** 2), rel=1e-13)
    zener = StandardSolid(0.2, 0.8, 0.3)
    assert zener.creep(TIMES) == pytest.approx(5.0 - 4.0 * np.exp(-TIMES * 0.2 / 0.3), rel=1e-12)
    assert zener.loss(OMEGA) == pytest.approx(0.8 * 0.3 * OMEGA / (1.0 + (0.3 * OMEGA) ** 2), rel=1e-13)


def test_kelvin_and_prony_are_the_same_solid():
    gel = GeneralisedKelvin(1e-3, [2e-3, 1e-3], [5.0, 0.1], fluidity=1e-4)
    series = gel.series
    same = Prony(series.relaxed, series.moduli, series.times)
    assert same.creep(TIMES) == pytest.approx(gel.creep(TIMES), rel=1e-12)
    exact = 1e-3 + 1e-4 * TIMES - 2e-3 * np.expm1(-TIMES / 5.0) - 1e-3 * np.expm1(-TIMES / 0.1)
    assert gel.creep(TIMES) == pytest.approx(exact, rel=1e-12)


@pytest.mark.parametrize(
    "solid",
    [
        Prony(1e3, [1e3, 5e2], [0.1, 3.0]),
        StandardSolid(1e3, 3e3, 2.0),
        Maxwell(1e3, 0.5),
        GeneralisedKelvin(1e-3, [1e-3, 2e-3], [0.5, 5.0]),
        FractionalZener(0.5e6, 50e6, relaxation_time=0.1, exponent=0.6, shortest=1e-4, longest=100.0),
        PowerLawSolid(1e3, 1.0, 0.2, shortest=1e-4, longest=1e3),
    ],
    ids=lambda solid: type(solid).__name__,
)
@pytest.mark.parametrize("time", [0.05, 1.0, 20.0])
def test_creep_and_relaxation_undo_each_other(solid, time):
    """Int_0^t G(t - s) J(s) ds = t, by panels that crowd at both ends."""
    edge = np.logspace(-7.0, -1.0, 25)
    breaks = time * np.concatenate([[0.0], edge, [0.5], 1.0 - edge[::-1], [1.0]])
    nodes, weights = np.polynomial.legendre.leggauss(20)
    low, high = breaks[:-1, None], breaks[1:, None]
    s = 0.5 * (high - low) * nodes + 0.5 * (high + low)
    total = np.sum(0.5 * (high - low) * weights * solid.relaxation(time - s) * solid.creep(s))
    assert total == pytest.approx(time, rel=1e-12)


@pytest.mark.parametrize("alpha", [0.05, 0.2, 0.5, 0.9])
@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-8])
def test_springpot(alpha, tolerance):
    solid = PowerLawSolid(3.0, 2.0, alpha, shortest=1e-3, longest=1e2, tolerance=tolerance)
    t = np.geomspace(1e-3, 1e2, 977)
    error = np.abs(solid.relaxation(t) / (3.0 * (t / 2.0) ** -alpha) - 1.0).max()
    assert error <= 1.02 * solid.series_error <= 1.02 * tolerance
    # in the middle of the span the dynamic modulus is Gamma(1 - alpha) (i omega t0)^alpha
    exact = 3.0 * math.gamma(1.0 - alpha) * (2.0j) ** alpha
    assert float(solid.storage(1.0)) == pytest.approx(exact.real, rel=max(30.0 * tolerance, 0.02))
    assert solid.series.times.size <= 120


def mittag_leffler(alpha: float, x: float) -> float:
    """E_alpha(-x) by its integral over the spectrum (Gorenflo, Mainardi 1997), by mpmath."""
    t = mp.mpf(x) ** (1 / mp.mpf(alpha))

    def kernel(y):
        s = mp.exp(y)
        top = s**alpha * mp.sin(mp.pi * alpha)
        return mp.exp(-s * t) * top / (mp.pi * (s ** (2 * alpha) + 2 * s**alpha * mp.cos(mp.pi * alpha) + 1))

    return float(mp.quad(kernel, mp.linspace(-120 / alpha, 120, 60)))


@pytest.mark.slow
def test_the_reference_of_the_fractional_solid():
    """E_{1/2}(-x) = exp(x^2) erfc(x)."""
    assert mittag_leffler(0.5, 0.7) == pytest.approx(float(mp.exp(mp.mpf("0.49")) * mp.erfc(mp.mpf("0.7"))), rel=1e-10)


@pytest.mark.slow
@pytest.mark.parametrize(
    "alpha", [0.3, pytest.param(0.5, marks=pytest.mark.slow), pytest.param(0.8, marks=pytest.mark.slow)]
)
def test_fractional_zener(alpha):
    solid = FractionalZener(0.5, 2.0, 0.1, alpha, shortest=1e-4, longest=1e3, tolerance=1e-6)
    for t in (1e-4, 0.03, 1.0, 1e3):
        exact = 0.5 + 2.0 * mittag_leffler(alpha, (t / 0.1) ** alpha)
        assert float(solid.relaxation(t)) == pytest.approx(exact, rel=1.5e-6)
    assert solid.series_error <= 1e-6


def test_temperature():
    law = WilliamsLandelFerry(reference_temperature=373.0, first_constant=10.0, second_constant=100.0)
    assert law.factor(373.0) == 1.0
    assert law.factor(473.0) == pytest.approx(1e-5)
    hot = Maxwell(2.0, 3.0, 0.4).slowed(law.factor(473.0))
    assert float(hot.relaxation(3e-5)) == pytest.approx(2.0 / math.e)
    assert hot.poisson == 0.4
    assert Arrhenius(300.0, 50e3).factor(280.0) == pytest.approx(math.exp(50e3 / 8.314462618 * (1 / 280 - 1 / 300)))
    slow = KelvinVoigt(2.0, 3.0).slowed(10.0)
    assert float(slow.creep(15.0)) == pytest.approx(-math.expm1(-1.0) / 2.0)
    with pytest.raises(OutsideValidity, match="gives no value"):
        law.factor(200.0)


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: Maxwell(0.0, 1.0), "Maxwell: shear is 0.0"),
        (lambda: KelvinVoigt(1.0, -1.0), "viscosity is -1.0"),
        (lambda: StandardSolid(1.0, 1.0, math.inf), "relaxation_time is inf"),
        (lambda: Prony(1.0, [1.0], [1.0, 2.0]), "one time for each"),
        (lambda: Prony(0.0, [], []), "nothing resists"),
        (lambda: Prony(1.0, [[1.0]], [[1.0]]), "a row of positive"),
        (lambda: Prony(1.0, [1.0], [0.0]), "relaxation_times"),
        (lambda: GeneralisedKelvin(0.0, [], []), "all compliances are zero"),
        (lambda: Maxwell(1.0, 1.0, 0.6), "poisson is 0.6"),
        (lambda: Maxwell(1.0, 1.0).relaxation(-1.0), "time"),
        (lambda: PowerLawSolid(1.0, 1.0, 1.0, 1e-3, 1.0), "exponent is 1.0"),
        (lambda: PowerLawSolid(1.0, 1.0, 0.5, 2.0, 1.0), "is empty"),
        (lambda: FractionalZener(-1.0, 1.0, 1.0, 0.5, 1e-3, 1.0), "relaxed_shear"),
        (lambda: Arrhenius(300.0, 1e4).factor(-3.0), "temperature is -3.0"),
    ],
)
def test_what_is_refused(make, sentence):
    with pytest.raises(InvalidInput, match=sentence):
        make()
