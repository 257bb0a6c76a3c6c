"""The pile of punches: panels that carry u' between kinks to rounding, and clusters that stand for many of them."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pytest

from winkler.media.punch_superposition import FEWEST_MEMBERS, punch_superposition


@dataclass(frozen=True)
class Root:
    """u' = -x / sqrt(x^2 - b^2) above b, with a wave below it."""

    flat: float = 0.3
    radius: float = 1.0
    edge: float = 0.0

    @property
    def kinks(self):
        return ((self.flat, self.flat),)

    def value(self, x):
        raise NotImplementedError

    def slope(self, x):
        root = np.sqrt(np.maximum(x - self.flat, 0.0) * (x + self.flat))
        return np.where(x > self.flat, -x / np.where(x > self.flat, root, 1.0), -np.cos(40.0 * x))


def test_panels_cover_the_contact_without_gaps():
    panels = punch_superposition(Root()).panels
    starts = [math.hypot(panel.base, panel.lower) for panel in panels]
    ends = [math.hypot(panel.base, panel.upper) for panel in panels]
    assert starts[0] == 0.0
    assert np.allclose(starts[1:], ends[:-1], rtol=1e-15)
    assert np.isclose(ends[-1], 1.0, rtol=1e-15)


def test_the_inverse_square_root_is_gone():
    """Above the kink H = -u' y/t = sqrt(t^2 - base^2) / sqrt(t^2 - b^2): one on panels that start at the kink."""
    for panel in punch_superposition(Root()).panels:
        y = panel.lower + (panel.upper - panel.lower) * np.linspace(0.0, 1.0, 50)
        t = np.hypot(panel.base, y)
        if panel.base == 0.3:
            want = np.ones(50)
        elif panel.lower >= 0.3:
            want = t / np.sqrt(t * t - 0.09)
        else:
            want = np.cos(40.0 * t)
        assert np.allclose(panel.weight(y), want, rtol=0.0, atol=1e-12)


def test_clusters_carry_the_moments_of_their_panels():
    root = punch_superposition(Root()).root
    assert len(root.panels) >= FEWEST_MEMBERS
    a, b = 1.0, 0.3
    for power, above in (
        (0, math.sqrt(a * a - b * b)),
        (2, (a * a - b * b) ** 1.5 / 3.0 + b * b * math.sqrt(a * a - b * b)),
    ):
        below = math.sin(12.0) / 40.0
        if power == 2:
            below = (0.09 / 40.0 - 2.0 / 40.0**3) * math.sin(12.0) + 2.0 * 0.3 / 1600.0 * math.cos(12.0)
        assert np.isclose(root.weights @ root.radii**power, above + below, rtol=1e-12)
    assert sum(len(child.panels) for child in root.children) == len(root.panels)


def test_a_pile_is_made_once():
    assert punch_superposition(Root()) is punch_superposition(Root())


@pytest.mark.parametrize("exponent", [0.1, 0.5, 1.7])
def test_a_tip_that_is_no_power_series_gets_ever_smaller_panels(exponent):
    @dataclass(frozen=True)
    class Tip(Root):
        kinks = ()

        def slope(self, x):
            return -(x**exponent)

    panels = punch_superposition(Tip()).panels
    for x in 10.0 ** np.arange(-9.0, 0.0):
        (panel,) = (panel for panel in panels if panel.lower <= x < panel.upper)
        assert np.isclose(panel.weight(np.array([x]))[0], x**exponent, rtol=0.0, atol=1e-11)
