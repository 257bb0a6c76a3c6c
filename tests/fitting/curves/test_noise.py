"""The memory of noise, and what it does to the covariance, against known processes and brute force."""

from __future__ import annotations

import numpy as np
import pytest
from synthetic import noise

from winkler.fitting.curves.noise import memory, memory_of_fit, spread


@pytest.mark.parametrize("remembered", [0.3, 0.7, 0.9])
def test_first_order_memory_is_found(remembered):
    found = memory(noise(np.random.default_rng(3), 20_000, remembered))
    np.testing.assert_allclose(found.correlations[:5], remembered ** np.arange(5), atol=0.03)
    exact = 20_000 * (1.0 - remembered) / (1.0 + remembered)  # n / (1 + 2 sum rho^k)
    assert found.effective_count == pytest.approx(exact, rel=0.15)


def test_white_noise_has_no_memory():
    counts = [memory(noise(np.random.default_rng(seed), 500)).effective_count for seed in range(40)]
    assert np.mean(np.array(counts) == 500.0) > 0.9


def test_a_second_order_process():
    random = np.random.default_rng(5)
    white = random.standard_normal(50_000)
    process = np.zeros(50_000)
    for i in range(2, 50_000):
        process[i] = 0.5 * process[i - 1] - 0.3 * process[i - 2] + white[i]
    first = 0.5 / 1.3  # Yule-Walker by hand: rho_1 = phi_1/(1 - phi_2), rho_2 = phi_1 rho_1 + phi_2
    found = memory(process).correlations
    np.testing.assert_allclose(found[:3], [1.0, first, 0.5 * first - 0.3], atol=0.02)


def test_nothing_and_few_points():
    assert memory(np.zeros(100)).effective_count == 100.0
    assert memory(np.array([1.0, -1.0, 1.0])).effective_count == 3.0


def test_the_covariance_of_white_noise_is_the_textbooks():
    jacobian = np.stack([np.ones(50), np.linspace(0.0, 1.0, 50)], axis=1)
    white = np.zeros(50)
    white[0] = 1.0
    covariance, used = spread(jacobian, white)
    np.testing.assert_allclose(covariance, np.linalg.inv(jacobian.T @ jacobian), rtol=1e-12)
    assert used == 2.0


def test_the_covariance_with_memory_is_the_full_product():
    jacobian = np.stack([np.ones(80), np.linspace(0.0, 1.0, 80) ** 2], axis=1)
    correlations = 0.8 ** np.arange(80)
    table = correlations[np.abs(np.subtract.outer(np.arange(80), np.arange(80)))]
    inverse = np.linalg.inv(jacobian.T @ jacobian)
    covariance, used = spread(jacobian, correlations)
    np.testing.assert_allclose(covariance, inverse @ jacobian.T @ table @ jacobian @ inverse, rtol=1e-10)
    projector = jacobian @ inverse @ jacobian.T
    assert used == pytest.approx(np.trace(projector @ table), rel=1e-10)


def test_what_a_fit_takes_of_the_noise_is_given_back():
    """Four columns, 300 points that remember: the residuals alone claim nearly a tenth too many independent points."""
    along = np.linspace(-1.0, 1.0, 300)
    columns = np.stack([along**k for k in range(4)], axis=1)
    counts = []
    for seed in range(200):
        disturbed = noise(np.random.default_rng(seed), 300, 0.7)
        left = disturbed - columns @ np.linalg.lstsq(columns, disturbed, rcond=None)[0]
        counts.append((memory(left).effective_count, memory_of_fit(left, 1e9 * columns).effective_count))
    plain, mended = np.median(np.array(counts), axis=0)
    exact = 300 * 0.3 / 1.7
    assert plain > 1.05 * exact
    assert mended == pytest.approx(exact, rel=0.03)


def test_residuals_that_are_no_noise_still_give_a_process():
    """A drift that a model misses: correlations of a possible process, whatever is given back."""
    left = np.sin(np.linspace(0.0, 9.0, 400))
    columns = np.stack([np.ones(400), np.linspace(0.0, 1.0, 400)], axis=1)
    found = memory_of_fit(left - columns @ np.linalg.lstsq(columns, left, rcond=None)[0], columns)
    table = found.correlations[np.abs(np.subtract.outer(np.arange(400), np.arange(400)))]
    assert np.linalg.eigvalsh(table).min() > -1e-10 * 400
    assert found.effective_count < 20.0
