"""Restitution on viscoelastic bodies: tables, the damped flat punch, limits, and the balance of energy."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.materials.viscoelastic import Prony
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.viscoelastic.impact import ViscoelasticImpact
from winkler.values.errors import InvalidInput


def strike(solid, profile=None, mass=1.0, velocity=1.0, **more):
    bed = wk.Foundation(wk.Paraboloid(1.0) if profile is None else profile, ViscoelasticHalfSpace(solid))
    return ViscoelasticImpact(bed, mass, velocity, **more).solve()


@pytest.mark.parametrize(("tau", "restitution"), [(0.01, 0.980892), (0.2, 0.706731), (1.0, 0.280820), (2.0, 0.138904)])
def test_kelvin_voigt_balls(tau, restitution):
    """In units of T0 = (m^2 / (E*^2 R v))^(1/5)."""
    assert strike(KelvinVoigt(0.25, 0.25 * tau)).restitution == pytest.approx(restitution, abs=3e-6)


@pytest.mark.parametrize(
    ("solid", "restitution"),
    [
        (Maxwell(0.25, 1.0), 0.28014),
        (Maxwell(0.25, 10.0), 0.88115),
        (StandardSolid(0.125, 0.125, 0.1), 0.87705),
        (StandardSolid(0.125, 0.125, 1.0), 0.70318),
    ],
    ids=["Maxwell 1", "Maxwell 10", "standard .1", "standard 1"],
)
def test_relaxing_balls(solid, restitution):
    assert strike(solid).restitution == pytest.approx(restitution, abs=8e-6)


@pytest.mark.parametrize("damping", [0.2, 0.5, 0.9, 1.5])
def test_damped_flat_punch(damping):
    """A spring and a dashpot that do not pull; the bound is the time at which the force would turn."""
    result = strike(KelvinVoigt(0.25, 0.5 * damping), wk.FlatPunch(0.5)).restitution
    if damping < 1.0:
        s = math.sqrt(1.0 - damping**2)
        exact = math.exp(-damping / s * math.atan2(2.0 * damping * s, 2.0 * damping**2 - 1.0))
    else:
        s = math.sqrt(damping**2 - 1.0)
        exact = ((damping + s) / (damping - s)) ** (-damping / s)
    assert result == pytest.approx(exact, abs=3e-6)


def test_only_the_ratio_of_times_counts():
    """The same solid struck by another mass at another speed, with the time scaled alike."""
    mass, velocity, radius, modulus = 0.02, 3.0, 0.01, 2e6
    unit = (mass**2 / (modulus**2 * radius * velocity)) ** 0.2
    solid = Maxwell(0.25 * modulus, 3.0 * unit)
    result = strike(solid, wk.Paraboloid(radius), mass, velocity, count=300)
    assert result.restitution == pytest.approx(0.65884, abs=8e-6)


def test_hardly_damped_is_hertz():
    result = strike(StandardSolid(0.25, 1e-9, 1.0), count=400)
    assert result.restitution == pytest.approx(1.0, abs=1e-6)
    assert result.duration == pytest.approx(2.868265699, rel=1e-5)
    assert np.max(result.depth) == pytest.approx((15.0 / 16.0) ** 0.4, rel=1e-5)
    assert abs(result.dissipation) < 1e-6


def test_a_dashpot_gives_nothing_back():
    result = strike(Prony(0.0, [], [], 0.25), count=100)
    assert result.restitution == 0.0
    assert result.dissipation == 0.5
    # all momentum goes into the dashpots: m v = 2 eta* Int a dd
    assert 4.0 / 3.0 * np.max(result.depth) ** 1.5 == pytest.approx(1.0, rel=1e-4)


def test_what_is_refused():
    bed = wk.Foundation(wk.Paraboloid(1.0), ViscoelasticHalfSpace(Maxwell(1.0, 1.0)))
    for more, message in (
        ({"mass": -1.0, "velocity": 1.0}, "mass is -1.0"),
        ({"mass": 1.0, "velocity": 0.0}, "velocity is 0.0"),
        ({"mass": 1.0, "velocity": 1.0, "count": 1}, "count is 1"),
        ({"mass": 1.0, "velocity": 1.0, "tolerance": 1.0}, "tolerance is 1.0"),
    ):
        with pytest.raises(InvalidInput, match=message):
            ViscoelasticImpact(bed, **more)
