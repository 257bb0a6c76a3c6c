"""Flash temperatures of elliptic contacts on layers, gradings and power laws, under the pressure of pixels."""

import math

import numpy as np
import pytest

import winkler as wk
from winkler.numerics.fields.elliptic_source import EllipticSource
from winkler.problems.heating.pressed_source import PressedSource

STEEL, BRASS = wk.ThermalConductor(45.0, 12e-6), wk.ThermalConductor(110.0, 34e-6)
ELASTIC = wk.Elastic(210e9, 0.3)
LAW, LOAD = wk.Coulomb(0.1), wk.Force(200.0)
TEMPERATURES = ("first_max_temperature", "second_max_temperature", "stationary_temperature", "fast_temperature")
MEANS = ("first_mean_temperature", "second_mean_temperature")


def coated(young):
    return wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, 0.3), 5e-5)], on=ELASTIC, second=ELASTIC)


def slid(contact, first, second, **more):
    return wk.FrictionHeating(contact, LAW, wk.HeatConductors(STEEL, BRASS), first, second, **more).solve()


@pytest.mark.few(2)
@pytest.mark.parametrize("radii", [(5e-3, 15e-3), (8e-3, 200e-3)])
@pytest.mark.parametrize("angle", [0.0, 0.6, 0.5 * math.pi])
@pytest.mark.parametrize("peclet", [0.0, 0.5, 20.0, 5e6])
def test_on_equal_layers_as_under_hertz_pressure(radii, angle, peclet):
    """The closed form of `EllipticSource`: the pixels are those of a coating that is as stiff as what is below it."""
    bodies = wk.CurvedBodies(*radii)
    hertz = wk.EllipticIndentation(bodies, wk.HalfSpace.between(ELASTIC, ELASTIC), LOAD).solve()
    axes = hertz.longitudinal_semi_axis, hertz.lateral_semi_axis
    exact, pixels = EllipticSource(*axes), PressedSource(bodies, coated(210e9), LOAD)
    wave = 2.0 * peclet / axes[0]
    peak, top = exact.peak(wave, angle), pixels.peak(wave, angle)
    assert top.height == pytest.approx(peak.height, rel=5e-4)
    assert (top.x / axes[0], top.y / axes[1]) == pytest.approx((peak.x / axes[0], peak.y / axes[1]), abs=0.015)
    assert pixels.mean(wave, angle) == pytest.approx(exact.mean(wave, angle), rel=2e-3)
    assert pixels.fast(angle) == pytest.approx(exact.fast(angle), rel=5e-4)
    turn = np.linspace(0.0, 2.0 * np.pi, 13)
    for part, error in ((0.5, 3e-3), (1.5, 2e-3), (2.9, 1e-3)):
        places = np.array([part * axes[0] * np.cos(turn), part * axes[1] * np.sin(turn)])
        places[0, :2] = 0.3 * part * axes[1] * np.array([1.0, -1.0])  # beside the longer side
        found, wanted = (source.surface(wave, *places, angle) for source in (pixels, exact))
        assert found == pytest.approx(wanted, abs=error * peak.height)


@pytest.mark.few(2)
@pytest.mark.parametrize(
    "medium",
    [coated(2100e9), coated(21e9), wk.GradedHalfSpace(wk.PowerLawGraded(200e9, 1e-3, 0.2, 0.3))],
    ids=["hard", "soft", "power law"],
)
@pytest.mark.parametrize("speeds", [(1e-3, 3e-4), (2.0, 0.6), (50.0, -15.0)])
def test_equal_curvatures_as_a_ball_on_springs(medium, speeds):
    """`FrictionHeating`: pressure by the kernel along a radius, temperature by line loads, no pixels."""
    one = slid(wk.EllipticIndentation(wk.CurvedBodies(8e-3, 8e-3), medium, LOAD), *speeds)
    ball = slid(wk.Indentation(wk.Foundation(wk.Paraboloid(8e-3), medium), LOAD), *speeds)
    assert one.heat_rate == pytest.approx(ball.heat_rate, rel=1e-12)
    assert one.first_share == pytest.approx(ball.first_share, rel=2e-4)
    assert one.first_peclet == pytest.approx(ball.first_peclet, rel=2e-3)
    for name in TEMPERATURES:
        assert getattr(one, name) == pytest.approx(getattr(ball, name), rel=5e-4), name
    for name in MEANS:
        assert getattr(one, name) == pytest.approx(getattr(ball, name), rel=2e-3), name


def test_a_turned_contact_is_as_warm():
    """Bodies, velocities and places turned by a quarter of a turn."""
    speeds, quarter = (2.0, 1.0), 0.5 * math.pi
    one, turned = (
        slid(
            wk.EllipticIndentation(wk.CurvedBodies(*radii), coated(2100e9), LOAD), *speeds,
            first_direction=0.4 + turn, second_direction=-1.0 + turn,
        )
        for radii, turn in (((5e-3, 15e-3), 0.0), ((15e-3, 5e-3), quarter))
    )  # fmt: skip
    for name in (*TEMPERATURES, *MEANS):
        assert getattr(turned, name) == pytest.approx(getattr(one, name), rel=1e-3), name
    x, y = np.array([0.0, 1e-4, 2e-4]), np.array([1e-4, 0.0, -3e-4])
    assert turned.first.temperature(-y, x) == pytest.approx(one.first.temperature(x, y), rel=5e-3)


def test_many_loads_and_speeds_one_by_one_and_none():
    loads, speeds = np.array([[0.0], [200.0]]), np.array([0.0, 2.0, 5.0])
    pair = wk.HeatConductors(STEEL, BRASS)
    bodies, medium = wk.CurvedBodies(5e-3, 15e-3), coated(21e9)
    many = wk.FrictionHeating(wk.EllipticIndentation(bodies, medium, wk.Force(loads)), LAW, pair, speeds, 1.0).solve()
    assert not np.any(many.flash_temperature[0])
    assert not np.any(many.stationary_temperature[0])
    one = many.at((1, 2))
    assert one.flash_temperature == many.flash_temperature[1, 2]
    again = slid(wk.EllipticIndentation(bodies, medium, LOAD), 5.0, 1.0)
    for name in (*TEMPERATURES, *MEANS, "overestimate"):
        assert getattr(again, name) == pytest.approx(getattr(many, name)[1, 2], rel=1e-12), name
    assert many.at((0, 1)).first.warmest.height == 0.0
    with pytest.raises(wk.OutsideValidity, match=r"times as far away as the contact reaches"):
        one.first.temperature(1.0)
