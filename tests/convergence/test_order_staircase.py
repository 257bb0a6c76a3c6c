"""Jaeger's staircase of flat punches: its stated orders, and that it goes where `restore` is.

The staircase adds closed forms of flat punches; `restore` evaluates Abel transforms.  They share g(x) and nothing else.
"""

from __future__ import annotations

import numpy as np
import pytest
from slopes import order

import winkler as wk

MEDIUM = wk.HalfSpace.between(wk.Elastic(2.0, 0.3))
SHAPES = {
    "paraboloid": (wk.Paraboloid(1.0), 0.4),
    "sphere": (wk.Sphere(1.0), 0.7),
    "cone": (wk.Cone(1.2), 0.4),
    "truncated cone": (wk.TruncatedCone(1.2, 0.15), 0.4),
    "rounded punch": (wk.RoundedPunch(0.15, 1.0), 0.4),
    "capped cylinder": (wk.CappedCylinder(0.4, wk.Paraboloid(1.0)), None),
}
COUNTS = np.array([50, 100, 200, 400, 800])


def press(name: str) -> wk.IndentationSolution:
    shape, radius = SHAPES[name]
    load = wk.Depth(0.25) if radius is None else wk.Radius(radius)
    return wk.Indentation(wk.Foundation(shape, MEDIUM), load).solve()


def rms(reached, exact) -> float:
    return float(np.sqrt(np.mean((np.asarray(reached) - exact) ** 2)))


def test_under_a_cone_depth_and_force_are_exact():
    """Increments of equal size per width, at the middle of each step: the midpoint rule of a straight line."""
    contact = press("cone")
    for count in (1, 3, 50):
        punches = wk.staircase(contact, count)
        assert punches.depth == pytest.approx(contact.depth, rel=1e-14)
        assert punches.force == pytest.approx(contact.force, rel=1e-14)


@pytest.mark.parametrize("name", [name for name in SHAPES if name != "cone"])
def test_depth_is_exact_and_force_of_second_order(name):
    contact = press(name)
    punches = [wk.staircase(contact, int(count)) for count in COUNTS]
    for one in punches:
        assert one.depth == pytest.approx(contact.depth, rel=1e-13)
    assert 1.9 < order(COUNTS, [abs(one.force - contact.force) for one in punches]) < 2.1


@pytest.mark.few(3)
@pytest.mark.parametrize("name", SHAPES)
def test_displacement_is_of_second_order_outside_and_of_order_three_halves_inside(name):
    contact = press(name)
    punches = [wk.staircase(contact, int(count)) for count in COUNTS]
    outside = contact.radius * np.array([1.2, 1.7, 4.0])
    exact = wk.restore(contact, outside).displacement
    assert 1.9 < order(COUNTS, [rms(one.displacement(outside), exact) for one in punches]) < 2.1
    # anywhere between the edges of the punches, not in step with them
    inside = contact.radius * np.random.default_rng(7).uniform(0.45, 0.95, 4000)
    exact = wk.restore(contact, inside).displacement
    assert 1.4 < order(COUNTS, [rms(one.displacement(inside), exact) for one in punches]) < 1.6


@pytest.mark.few(3)
@pytest.mark.parametrize("name", SHAPES)
def test_force_within_a_circle_goes_to_that_of_the_restored_pressure(name):
    """The pressure of a staircase has poles; summed up over circles it has none."""
    contact = press(name)
    circles = contact.radius * np.array([0.3, 0.6, 0.9])
    t = 0.5 * np.pi * (np.arange(4000) + 0.5) / 4000
    exact = []
    for circle in circles:
        # what lies outside the circle, r^2 = c^2 + (a^2 - c^2) sin^2, so that an infinite edge is no matter
        span = contact.radius**2 - circle**2
        r = np.sqrt(circle**2 + span * np.sin(t) ** 2)
        beyond = np.mean(wk.restore(contact, r).pressure * np.sin(t) * np.cos(t)) * 0.5 * np.pi * 2.0 * np.pi * span
        exact.append(contact.force - beyond)
    errors = [rms(wk.staircase(contact, int(count)).force_within(circles), exact) for count in COUNTS]
    assert errors[-1] < 2e-4 * contact.force
    assert order(COUNTS, errors) > 0.9


@pytest.mark.parametrize("name", ["paraboloid", "sphere", "cone", "rounded punch"])
def test_pressure_between_the_edges_is_of_order_one_half_and_at_the_right_place_of_order_three_halves(name):
    contact = press(name)

    def error(count: int, part: float) -> float:
        punches = wk.staircase(contact, count)
        radii = punches.radii[(punches.radii > 0.6 * contact.radius) & (punches.radii < 0.9 * contact.radius)]
        # `part` of the step below an edge
        r = radii[1:] - part * np.diff(radii)
        return rms(punches.pressure(r), wk.restore(contact, r).pressure)

    assert 0.45 < order(COUNTS, [error(int(count), 0.5) for count in COUNTS]) < 0.55
    # zeta(1/2, 0.3027) = 0
    assert 1.35 < order(COUNTS, [error(int(count), 0.302721828598366) for count in COUNTS]) < 1.65
