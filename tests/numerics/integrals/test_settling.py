"""Rules that are refined until the result settles: what they reach, and that they refuse what does not."""

from __future__ import annotations

import math

import numpy as np
import pytest

from winkler.numerics.integrals.adaptive_quadrature import settled
from winkler.values.errors import NotConverged

INTEGRANDS = {
    "a polynomial": (lambda t: 5.0 * t**4, 1.0),
    "an exponential": (np.exp, math.e - 1.0),
    "a pole nearby": (lambda t: 1.0 / (t + 0.01), math.log(101.0)),
    "a root at the left": (np.sqrt, 2.0 / 3.0),
    "a root at the right": (lambda t: np.sqrt(1.0 - t), 2.0 / 3.0),
    "a logarithm": (np.log, -1.0),
    "an inverse root": (lambda t: t**-0.5, 2.0),
    "all that cancels": (lambda t: np.cos(math.pi * t), 0.0),
    "zero": (np.zeros_like, 0.0),
    "a hundred waves": (
        lambda t: np.sin(200.5 * math.pi * t) ** 2,
        0.5 - math.sin(401.0 * math.pi) / (802.0 * math.pi),
    ),
}


@pytest.mark.parametrize("name", INTEGRANDS)
def test_reaches_thirteen_digits(name):
    function, expected = INTEGRANDS[name]
    got = settled(lambda node, index: np.tile(function(node), (index.size, 1)), 3, name)
    np.testing.assert_allclose(got, expected, rtol=1e-12, atol=1e-13)


def test_each_integral_gets_its_own_rule():
    powers = np.array([0.0, -0.5, 30.0, 0.3, 1.0])
    counts = []

    def integrand(node, index):
        counts.append(index.size)
        return node ** powers[index, None]

    np.testing.assert_allclose(settled(integrand, 5, "powers"), 1.0 / (powers + 1.0), rtol=1e-12)
    assert counts[0] == 5
    assert counts[-1] < counts[0]


def test_many_integrals_at_once():
    """More points than fit into one evaluation."""
    count = 100_000
    shift = np.linspace(0.0, 1.0, count)
    got = settled(lambda node, index: np.cos(node + shift[index, None]), count, "cosines")
    np.testing.assert_allclose(got, np.sin(1.0 + shift) - np.sin(shift), rtol=1e-13, atol=1e-15)


def test_none_at_all():
    assert settled(lambda node, index: np.ones((index.size, node.size)), 0, "nothing").shape == (0,)


@pytest.mark.parametrize(
    "function",
    [
        lambda t: np.where(t < 1.0 / math.pi, 1.0, 0.0),
        lambda t: np.sin(1e5 * t),
        lambda t: 1.0 / np.abs(t - 1.0 / math.pi),
        lambda t: np.full_like(t, math.nan),
    ],
)
def test_what_does_not_settle_is_refused(function):
    with pytest.raises(NotConverged, match=r"The integral for the test still moves by .* at 3072 points"):
        settled(lambda node, index: np.tile(function(node), (index.size, 1)), 2, "test")


def test_noise_that_is_announced_is_accepted():
    generator = np.random.default_rng(1)

    def noisy(node, index):
        return 1.0 + 1e-6 * generator.normal(size=(index.size, node.size))

    with pytest.raises(NotConverged):
        settled(noisy, 2, "test")
    np.testing.assert_allclose(settled(noisy, 2, "test", np.array([1e-6, 1e-6])), 1.0, atol=1e-5)
    with pytest.raises(NotConverged):
        settled(noisy, 2, "test", np.array([1e-6, 1e-12]))


def test_what_is_added_to_something_large_may_be_less_exact():
    """An integral that will be added to another one is measured against that."""

    def rough(node, index):
        return np.tile(1e-12 * np.where(node < 1.0 / math.pi, 1.0, 0.0), (index.size, 1))

    with pytest.raises(NotConverged):
        settled(rough, 2, "test")
    np.testing.assert_allclose(settled(rough, 2, "test", against=1.0), 1e-12 / math.pi, atol=1e-12)
    with pytest.raises(NotConverged):
        settled(rough, 2, "test", against=np.array([1.0, 1e-12]))
