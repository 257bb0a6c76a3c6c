"""Derivatives of the logarithms of moduli."""

import numpy as np
import pytest

from winkler.numerics.springs.spectrum_response import Measurements, Response, SpectrumLayout, bending, linearised


@pytest.mark.parametrize("response", list(Response))
def test_second_derivatives_are_those_of_the_first(response):
    times = np.geomspace(0.01, 100.0, 6)
    abscissa, group = np.geomspace(0.03, 20.0, 9), np.array([0, 0, 0, 1, 1, 1, 2, 2, 2])
    rng = np.random.default_rng(5)
    measured = (Measurements(response, abscissa, group, np.exp(rng.normal(size=9))),)
    layout = SpectrumLayout(6, 3, np.array([True] * 7 + [False, True, True] + [True, False, True]))
    numbers = np.concatenate([rng.normal(size=7), [0.0, 0.7, -0.4], [0.1, 0.0, 0.2]])
    weight = rng.normal(size=9)
    step = 1e-5
    slopes = []
    for index in np.flatnonzero(layout.free):
        ahead, behind = numbers.copy(), numbers.copy()
        ahead[index] += step
        behind[index] -= step
        up, down = (weight @ linearised(measured, times, layout, at)[0][0] for at in (ahead, behind))
        slopes.append((up - down) / (2.0 * step))
    np.testing.assert_allclose(bending(measured, times, layout, numbers, (weight,)), slopes, rtol=0.0, atol=1e-9)
