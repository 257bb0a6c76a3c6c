"""Numbers over depth: constant where the law is that of the model, named where it is not."""

import numpy as np
import pytest
from noisy_worlds import coloured
from synthetic import hertz

import winkler as wk
from winkler.fitting.examined.over_depth import over_depth
from winkler.values.errors import InvalidInput

E = "bed.medium.first.young"
FREE = [E, "contact_point", "baseline"]
MODEL = wk.Indentation(wk.Foundation(wk.Paraboloid(5e-6), wk.HalfSpace.between(wk.Elastic(3e4, 0.5))), wk.Depth(0.0))
POSITION = np.linspace(-1e-6, 1e-6, 400)


def measured(seed, rise=0.0):
    """Hertz' law with a modulus of 10 kPa that rises by a part over the depth, white and 1/f noise."""
    random = np.random.default_rng(seed)
    level = 3e-11 * (random.standard_normal(POSITION.size) + coloured(random, POSITION.size, 1.0) / 3.0)
    force = hertz(POSITION, 1e4 / 0.75, 5e-6) * (1.0 + rise * np.maximum(POSITION, 0.0) / 1e-6)
    return wk.ForceCurve(POSITION + 2e-6, force + level)


def test_constant_modulus():
    series = over_depth(measured(1), MODEL, free=FREE, count=6)
    assert series.constant
    assert "constant within its errors" in series.verdict
    assert np.all(np.diff(series.depths) > 0.0)
    assert np.all(np.diff(series.standard_errors) < 0.0)
    assert series.forces == pytest.approx(hertz(series.depths, 1e4 / 0.75, 5e-6), rel=0.05)
    whole = wk.fit(measured(1), MODEL, free=FREE)
    assert series.values[-1] == whole.value(E)
    assert (series.lows[-1], series.highs[-1]) == whole.interval(E)


def test_rising_modulus():
    series = over_depth(measured(2, rise=0.3), MODEL, free=FREE, count=6)
    assert not series.constant
    assert "not constant: it rises by" in series.verdict
    assert np.all(np.diff(series.values[1:]) > 0.0)


@pytest.mark.long
def test_constant_moduli_are_rarely_called_changing():
    """One in twenty would be; slow noise, estimated anew in each fit, must not make it many."""
    called = sum(not over_depth(measured(seed), MODEL, free=FREE, count=5).constant for seed in range(100, 160))
    assert called <= 7


def test_refused():
    with pytest.raises(InvalidInput, match="at least 2"):
        over_depth(measured(1), MODEL, free=FREE, count=1)
    with pytest.raises(InvalidInput, match="was not free"):
        over_depth(measured(1), MODEL, free=FREE, of="bed.profile.curvature_radius", count=3)
    with pytest.raises(InvalidInput, match="no number of the model"):
        over_depth(measured(1), MODEL, free=["contact_point"], count=3)
