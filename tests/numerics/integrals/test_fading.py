"""Integrals over a step of what fades, at ratios of the step to the relaxation time from 1e-20 to 1e20."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from winkler.numerics.integrals.exponential_integrals import bends, fading, first, losses, second

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


@pytest.mark.parametrize("x", [1e-9, 1e-3, 0.3, 0.49999, 0.5, 0.9, 3.0, 40.0, 1e5])
def test_a_bend_adds_its_integrals(x):
    """R by its definition at fifty digits, the means by quadrature."""
    phi, out = np.empty(4), np.empty(8)
    fading(x, phi)
    bends(x, phi, out)
    with mpmath.workdps(50):
        rate, half = mpmath.mpf(x), mpmath.mpf(0.5)

        def fade(s):
            return mpmath.exp(-rate * s)

        def grown(s):
            return (1 - fade(s)) / rate

        def bowed(s):
            return (s - grown(s)) / rate - half * grown(s)

        def mean(of):
            return mpmath.quad(of, [0, *(k / rate for k in (1, 5, 20, 60) if k < rate), 1])

        expected = [
            bowed(mpmath.mpf(1)),
            mean(bowed),
            mean(lambda s: (s - half) * fade(s)),
            mean(lambda s: (s - half) * grown(s)),
            mean(lambda s: (s - half) * bowed(s)),
            2 * rate * mean(lambda s: fade(s) * bowed(s)),
            2 * rate * mean(lambda s: grown(s) * bowed(s)),
            rate * mean(lambda s: bowed(s) ** 2),
        ]
    np.testing.assert_allclose(out, [float(each) for each in expected], rtol=1e-10, atol=1e-16)
