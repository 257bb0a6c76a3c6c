"""Means over curves: published numbers, coverage in seeded worlds, outliers, and groups."""

import numpy as np
import pytest

from winkler.fitting.several.groups import ratio_of
from winkler.fitting.several.population import population
from winkler.values.errors import InvalidInput

# Thirteen trials of the BCG vaccine: log risk ratios and variances, from G. A. Colditz et al., JAMA 271, 698 (1994),
# https://doi.org/10.1001/jama.1994.03510330076038, as computed in W. Viechtbauer, J. Stat. Softw. 36 (2010),
# https://doi.org/10.18637/jss.v036.i03, whose restricted maximum likelihood gives 0.3132 and -0.7145.
BCG = np.array([-0.8893, -1.5854, -1.3481, -1.4416, -0.2175, -0.7861, -1.6209, 0.0120, -0.4694, -1.3713, -0.3394,
                0.4459, -0.0173])  # fmt: skip
BCG_VARIANCE = np.array([0.3256, 0.1946, 0.4154, 0.0200, 0.0512, 0.0069, 0.2230, 0.0040, 0.0564, 0.0730, 0.0124,
                         0.5325, 0.0714])  # fmt: skip


def test_published_meta_analysis():
    found = population(BCG, np.sqrt(BCG_VARIANCE), logarithmic=False)
    assert found.between**2 == pytest.approx(0.3132, abs=2e-4)
    assert found.mean == pytest.approx(-0.7145, abs=2e-4)
    low, high = found.interval()  # Hartung and Knapp, from the weights of the published variance
    weights = 1.0 / (0.3132 + BCG_VARIANCE)
    error = np.sqrt(weights @ (BCG + 0.7145) ** 2 / 12.0 / weights.sum())
    assert (low, high) == pytest.approx((-0.7145 - 2.178813 * error, -0.7145 + 2.178813 * error), abs=4e-4)


@pytest.mark.few(3)
@pytest.mark.parametrize("between", [0.0, 0.05, 0.3], ids=["none", "like the errors", "much"])
@pytest.mark.parametrize("count", [5, 12, 50])
def test_intervals_hold_the_mean(count, between):
    """Lognormal moduli, errors that differ up to tenfold between the curves and are known by 30 points each."""
    random, held, worlds = np.random.default_rng([count, round(100 * between)]), 0, 1500 if count == 5 else 600
    for _ in range(worlds):
        errors = 0.05 * np.exp(random.uniform(-1.15, 1.15, count))
        stated = errors * np.sqrt(random.chisquare(30, count) / 30)
        moduli = 2e3 * np.exp(between * random.standard_normal(count) + errors * random.standard_normal(count))
        low, high = population(moduli, stated * moduli).interval()
        held += low < 2e3 < high
    assert 0.92 <= held / worlds <= 0.98


def test_an_absurd_error_does_not_rule_the_mean():
    """14 curves +- 0.5 to 1.1 kPa and one +- 1 Pa: 2.693 [2.691, 2.694] kPa, where the plain mean is 2.56 +- 0.04."""
    scatter = np.linspace(-1.0, 1.0, 14) * 0.25
    values = 2560.0 + 1e3 * np.array([0.133, *(scatter - 0.133 / 14.0)])
    errors = np.array([1.0, *np.linspace(500.0, 1100.0, 14)])
    found = population(values, errors, logarithmic=False)
    plain = values.std(ddof=1) / np.sqrt(15.0)
    assert plain == pytest.approx(40.0, rel=0.1)
    assert found.mean == pytest.approx(2560.0, abs=1e-9)
    assert found.standard_error == pytest.approx(plain, rel=1e-12)
    assert found.interval() == pytest.approx((2560.0 - 2.144787 * plain, 2560.0 + 2.144787 * plain), rel=1e-6)
    assert (found.doubted, found.overstated, found.decisive) == ((0,), True, ())


def test_an_unknown_error_is_not_zero():
    """Without an error the curve counts like a usual one, and in no other way than one whose error is absurd."""
    values, errors = [1000.0, 1100.0, 950.0, 1050.0], [20.0, 30.0, 25.0]
    zero, absurd, unknown = (population(values, [first, *errors]) for first in (0.0, 1e-3, np.nan))
    for other in (absurd, unknown):  # the same numbers, whose sums differ in the last digit where arrays lie otherwise
        assert other.mean == pytest.approx(zero.mean, rel=1e-14)
        assert other.interval() == pytest.approx(zero.interval(), rel=1e-14)
    assert zero.doubted == (0,)
    assert zero.weights.sum() == pytest.approx(1.0, rel=1e-15)
    assert zero.weights.max() < 0.3


def test_a_curve_that_decides_alone_is_named():
    """With 0.15 of the others' errors it has 1/0.15^2 = 44 of 48 parts of the weight, and that may be true."""
    values = 1e3 + np.array([0.0, 60.0, -110.0, 80.0, -40.0])
    found = population(values, [15.0, 100.0, 100.0, 100.0, 100.0], logarithmic=False)
    assert found.decisive == (0,)
    assert found.weights[0] == pytest.approx(1.0 / 0.15**2 / (1.0 / 0.15**2 + 4.0), rel=1e-12)
    assert (found.doubted, found.overstated) == ((), False)
    assert population(values, [50.0, 100.0, 100.0, 100.0, 100.0], logarithmic=False).decisive == ()


@pytest.mark.few(2)
@pytest.mark.parametrize("factor", [1.0, 5.0], ids=["errors as they are", "errors five times too large"])
@pytest.mark.parametrize("count", [15, 50])
def test_intervals_hold_the_mean_beside_an_absurd_error(count, factor):
    random, held, worlds = np.random.default_rng([count, 3]), 0, 1000
    for _ in range(worlds):
        errors = 0.05 * np.exp(random.uniform(-1.15, 1.15, count))
        moduli = 2e3 * np.exp(errors * random.standard_normal(count))
        stated = factor * errors * np.array([1e-3, *[1.0] * (count - 1)])
        low, high = population(moduli, stated * moduli).interval()
        held += low < 2e3 < high
    assert 0.92 <= held / worlds <= 0.98


def test_calibration_does_not_average_out():
    random = np.random.default_rng(5)
    moduli = 1e3 * np.exp(0.01 * random.standard_normal(400))
    alone, shared = (population(moduli, 0.01 * moduli, calibration=error) for error in (0.0, 0.1))
    assert alone.interval()[1] / alone.mean < 1.003
    low, high = np.log(np.array(shared.interval()) / shared.mean)
    assert (-low, high) == pytest.approx((0.196, 0.196), abs=1e-3)


def test_outliers_are_named():
    random = np.random.default_rng(6)
    values = 1e3 * np.exp(0.1 * random.standard_normal(20))
    values[[3, 11]] *= [4.0, 0.2]
    assert population(values, 0.02 * values).outliers == (3, 11)
    named = sum(bool(population(1e3 + 50 * random.standard_normal(20), np.full(20, 20.0)).outliers) for _ in range(400))
    assert named <= 16


def test_scatter_is_separated():
    random = np.random.default_rng(7)
    values = np.exp(0.2 * random.standard_normal(4000) + 0.1 * random.standard_normal(4000))
    found = population(values, 0.1 * values)
    assert (found.between, found.within) == pytest.approx((0.2, 0.1), rel=0.04)
    assert found.shared_variance == pytest.approx(0.8, abs=0.02)
    low, high = found.range_of_curves()
    assert np.mean((low < np.exp(0.2 * random.standard_normal(4000))) & (high > 0.0)) == pytest.approx(0.975, abs=0.01)


@pytest.mark.slow
def test_ratio_of_groups_holds():
    random, held, worlds = np.random.default_rng(8), 0, 600
    for _ in range(worlds):
        first, second = (
            middle * np.exp(scatter * random.standard_normal(count))
            for middle, scatter, count in ((700.0, 0.3, 8), (1000.0, 0.1, 15))
        )
        found = ratio_of(*(population(group, 0.02 * group, calibration=0.1) for group in (first, second)))
        held += found.low < 0.7 < found.high
    assert 0.92 <= held / worlds <= 0.98


@pytest.mark.parametrize(
    ("values", "errors", "says"),
    [([1.0], [0.1], "at least 2"), ([1.0, 2.0], [0.1], "shape"), ([1.0, -2.0], [0.1, 0.1], "not positive"),
     ([1.0, 2.0], [0.1, -0.1], "negative"), ([1.0, np.nan], [0.1, 0.1], "not finite")],
)  # fmt: skip
def test_refused(values, errors, says):
    with pytest.raises(InvalidInput, match=says):
        population(values, errors)
    positive = population([1.0, 2.0], [0.1, 0.1], logarithmic=False)
    with pytest.raises(InvalidInput, match="positive"):
        ratio_of(positive, positive)
