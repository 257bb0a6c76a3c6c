"""Integrals over a step of what fades, at ratios of the step to the relaxation time from 1e-20 to 1e20."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from winkler.numerics.integrals.exponential_integrals import fading, first, losses, second

RATIOS = [10.0**k for k in range(-20, 21, 2)] + [0.3, 0.999999, 1.0, 1.000001, 1.9, 5.0]


def closed(x):
    """phi_1 .. phi_4 and a, b, c from their closed forms; the digits that cancel are added."""
    with mpmath.workdps(130):
        x = mpmath.mpf(x)
        one = (1 - mpmath.exp(-x)) / x
        two = (1 - one) / x
        three = (mpmath.mpf(1) / 2 - two) / x
        four = (mpmath.mpf(1) / 6 - three) / x
        a = (1 - mpmath.exp(-2 * x)) / 2
        c = (2 * x - 3 + 4 * mpmath.exp(-x) - mpmath.exp(-2 * x)) / (2 * x * x)
        return [float(each) for each in (one, two, three, four, a, x * one * one, c)]


@pytest.mark.parametrize("x", RATIOS)
def test_nothing_is_lost_by_cancellation(x):
    phi = np.empty(4)
    fading(x, phi)
    found = [*phi, *losses(x, phi)]
    assert found == pytest.approx(closed(x), rel=2e-14)
    assert [first(x), second(x)] == pytest.approx(found[:2], rel=4e-15)


def test_a_step_of_no_time():
    phi = np.empty(4)
    fading(0.0, phi)
    assert phi == pytest.approx([1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0], rel=1e-15)
    assert losses(0.0, phi) == (0.0, 0.0, 0.0)
    assert (first(0.0), second(0.0)) == (1.0, 0.5)
