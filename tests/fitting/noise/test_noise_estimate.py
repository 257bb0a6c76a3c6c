"""The noise of residuals against dense matrices, known processes, and what is lost to it."""

from __future__ import annotations

import math

import numpy as np
import pytest
from noisy_worlds import coloured
from synthetic import noise

from winkler.fitting.noise.disturbances import disturbances_of
from winkler.fitting.noise.estimate import amplitudes_of, noise_of, orthonormal
from winkler.fitting.noise.mixture import SIGMAS, Mixture
from winkler.fitting.noise.spectra import EXPONENTS, candidates
from winkler.fitting.noise.whitening import whitening_of


def cosines(count):
    """The cosine transform as a matrix, row k for k half periods."""
    k, i = np.arange(count)[:, None], np.arange(count)
    return np.sqrt(np.where(k == 0, 1.0, 2.0) / count) * np.cos(np.pi * k * (i + 0.5) / count)


def columns(count, degree=2):
    along = np.linspace(-1.0, 1.0, count)
    return np.stack([along**k for k in range(degree)], axis=1)


def tilted(count):
    return np.sqrt(3.0) * np.linspace(-1.0, 1.0, count)[:, None]


def test_step_and_covariance_are_those_of_dense_matrices():
    """Every candidate with its n x n covariance: restricted likelihood, generalised least squares, and their means."""
    count, jacobian = 30, columns(30, 3)[:, ::2]
    disturbance = tilted(count)
    residuals = noise(np.random.default_rng(3), count, 0.5) + 0.4 * disturbance[:, 0]
    table, matrix = candidates(count), cosines(count)
    logs, steps, covariances, p = [], [], [], 2
    for spectrum, prior in zip(table.spectra, table.priors, strict=True):
        plain = matrix.T @ np.diag(np.repeat(spectrum, table.sizes)) @ matrix
        for (amplitude,), weight in zip(*amplitudes_of(1), strict=True):
            whole = plain + amplitude**2 * disturbance @ disturbance.T
            inverse = np.linalg.inv(whole)
            inner = jacobian.T @ inverse @ jacobian
            step = np.linalg.solve(inner, jacobian.T @ inverse @ residuals)
            left = residuals - jacobian @ step
            squares = left @ inverse @ left
            determinants = np.linalg.slogdet(whole)[1] + np.linalg.slogdet(inner)[1]
            logs.append(np.log(prior * weight) - 0.5 * determinants - 0.5 * (count - p) * np.log(squares))
            steps.append(step)
            covariances.append(np.linalg.inv(inner) * squares / (count - p - 2))
    weights = np.exp(np.array(logs) - max(logs))
    weights /= weights.sum()
    mean = weights @ np.array(steps)
    apart = np.array(steps) - mean
    covariance = np.einsum("m,mij->ij", weights, covariances) + (weights[:, None] * apart).T @ apart
    found = noise_of(1e-9 * residuals, jacobian, disturbance)
    np.testing.assert_allclose(found.step, 1e-9 * mean, rtol=1e-7)
    np.testing.assert_allclose(found.covariance, 1e-18 * covariance, rtol=1e-7)


def test_the_candidate_of_exponent_two_is_a_random_walk():
    """Its inverse covariance is that of independent steps: 2 on the diagonal, -1 beside it, and 1 at the two ends."""
    count = 50
    table = candidates(count)
    ratios = (table.priors.size - 1) // np.unique(np.flatnonzero(table.slow == table.slow[1])).size
    walk = ratios * EXPONENTS.index(2.0) + ratios  # white noise is the first, the ratios run within an exponent
    slow = table.spectra[walk, 1:] - (1.0 - table.slow[walk])
    matrix = cosines(count)[1:]
    precision = matrix.T @ np.diag(1.0 / slow) @ matrix
    steps = np.diff(np.eye(count), axis=0)
    np.testing.assert_allclose(precision / precision[0, 0], steps.T @ steps, atol=1e-9)


def test_whitening_makes_the_whole_covariance_one():
    count = 60
    residuals = coloured(np.random.default_rng(1), count, 2.0) + tilted(count)[:, 0]
    found = noise_of(residuals, columns(count, 3)[:, ::2], tilted(count))
    matrix = cosines(count)
    whole = matrix.T @ np.diag(found.spectrum) @ matrix + found.amplitudes[0] ** 2 * tilted(count) @ tilted(count).T
    white = whitening_of(found).of(np.eye(count))
    np.testing.assert_allclose(white @ whole @ white.T, np.eye(count), atol=1e-10)


@pytest.mark.parametrize("remembered", [0.3, 0.7, 0.9])
def test_neighbours_that_are_alike_are_fewer_points(remembered):
    exact = 4000 * (1.0 - remembered) / (1.0 + remembered)  # n / (1 + 2 sum rho^k)
    counts = [
        noise_of(
            noise(np.random.default_rng(seed), 4000, remembered), columns(4000), tilted(4000)[:, :0]
        ).effective_count
        for seed in range(8)
    ]
    assert np.median(counts) == pytest.approx(exact, rel=0.25)


def test_white_noise_is_worth_nearly_all_its_points_and_slow_noise_few():
    def found(exponent, share, seed):
        random = np.random.default_rng(seed)
        drawn = noise(random, 1000) + share * coloured(random, 1000, exponent)
        return noise_of(drawn, columns(1000), np.zeros((1000, 0)))

    white = [found(1.0, 0.0, seed) for seed in range(10)]
    assert np.median([one.effective_count for one in white]) > 400.0
    assert np.median([one.slow_share for one in white]) < 0.02
    walk = [found(2.0, 1.0, seed) for seed in range(10)]
    assert np.median([one.effective_count for one in walk]) < 20.0
    assert 0.1 < np.median([one.slow_share for one in walk]) < 0.8


def test_a_disturbance_is_found_and_its_noise_is_not_larger():
    random = np.random.default_rng(8)
    drawn = noise(random, 500)
    plain = noise_of(drawn, columns(500, 1), tilted(500))
    found = noise_of(drawn + 2.0 * tilted(500)[:, 0], columns(500, 1), tilted(500))
    assert np.abs(plain.disturbance).max() < 0.3
    np.testing.assert_allclose(found.disturbance, 2.0 * tilted(500)[:, 0], atol=0.5)
    assert found.scatter == pytest.approx(plain.scatter, rel=0.05)
    assert found.likelihood > noise_of(drawn + 2.0 * tilted(500)[:, 0], columns(500, 1), tilted(500)[:, :0]).likelihood


def test_a_tilt_that_is_fitted_is_no_disturbance():
    """Otherwise its error would be that of all tilts that a machine may have."""
    residuals = noise(np.random.default_rng(2), 200)
    free = noise_of(residuals, columns(200), tilted(200))
    assert free.courses.shape == (200, 0)
    assert np.array_equal(free.covariance, noise_of(residuals, columns(200), tilted(200)[:, :0]).covariance)
    assert noise_of(residuals, columns(200, 1), tilted(200)).courses.shape == (200, 1)


def test_units_do_not_matter():
    residuals = noise(np.random.default_rng(2), 200, 0.6)
    plain, small = (noise_of(unit * residuals, columns(200), tilted(200)) for unit in (1.0, 1e-12))
    np.testing.assert_allclose(small.step, 1e-12 * plain.step, rtol=1e-9)
    np.testing.assert_allclose(np.diag(small.covariance), 1e-24 * np.diag(plain.covariance), rtol=1e-9)
    assert small.effective_count == pytest.approx(plain.effective_count, rel=1e-9)
    assert small.likelihood - plain.likelihood == pytest.approx(200 * np.log(1e12))


def test_nothing_left_and_few_points():
    found = noise_of(np.zeros(100), columns(100), tilted(100))
    assert np.all(found.step == 0.0)
    assert found.scatter < 1e-9
    few = noise_of(np.array([1.0, -1.0, 1.0, 0.5, 0.0]), columns(5, 1), np.zeros((5, 0)))
    assert np.all(np.isfinite(few.covariance))
    assert 1.0 <= few.effective_count <= 5.0


def test_the_disturbances_of_a_curve():
    """One direction: a drift that is a tilt too; two: drift, tilt and drag, of unit size and independent."""
    from synthetic import there_and_back

    import winkler as wk

    once = np.linspace(0.0, 1.0, 50)
    assert disturbances_of(wk.ForceCurve(once, once**2)).shape == (50, 1)
    place, inward = there_and_back(0.0, 1.0, 25)
    found = disturbances_of(wk.ForceCurve(place, place**2, direction=np.where(inward, 1.0, -1.0)))
    np.testing.assert_allclose(found.T @ found / 50, np.eye(3), atol=1e-12)
    drag = np.where(inward, 1.0, -1.0)
    np.testing.assert_allclose(found @ np.linalg.lstsq(found, drag, rcond=None)[0], drag, atol=1e-9)


@pytest.mark.parametrize("narrow", [1.0, 0.3, 1e-3, 1e-9])
def test_half_widths_hold_their_part_of_a_mixture(narrow):
    """The part held is counted anew, by the error function of Python; one candidate alone has normal half-widths."""
    alone = Mixture(np.ones(1), np.zeros((1, 1)), np.full((1, 1, 1), 4.0))
    assert alone.reaches[0] == pytest.approx(SIGMAS, abs=1e-6)
    shares, steps, errors = np.array([0.5, 0.3, 0.2]), np.array([0.0, 0.4, -1.0]), np.array([narrow, 1.0, 3.0])
    found = Mixture(shares, steps[:, None], (errors**2)[:, None, None])
    deviation = float(np.sqrt(found.covariance[0, 0]))
    for sigma, reach in zip(SIGMAS, found.reaches[0].tolist(), strict=True):
        ends = (np.array([[-1.0], [1.0]]) * reach * deviation + found.mean[0] - steps) / errors
        low, high = (np.array([math.erf(end / math.sqrt(2.0)) for end in row.tolist()]) for row in ends)
        assert shares @ (0.5 * (high - low)) == pytest.approx(math.erf(sigma / math.sqrt(2.0)), abs=2e-5)


@pytest.mark.parametrize("apart", [1.0, 1e-4, 2e-5, 1e-7, 1e-12])
def test_a_basis_of_nearly_dependent_columns_isorthonormal(apart):
    """Where Cholesky's factors would lose digits, reflections are taken."""
    columns = np.random.default_rng(3).standard_normal((500, 3))
    columns[:, 2] = columns[:, 0] + apart * columns[:, 2]
    columns /= np.linalg.norm(columns, axis=0)
    basis, triangle = orthonormal(columns)
    np.testing.assert_allclose(basis.T @ basis, np.eye(3), atol=1e-14)
    np.testing.assert_allclose(basis @ triangle, columns, atol=1e-14)
    assert np.array_equal(triangle, np.triu(triangle))
