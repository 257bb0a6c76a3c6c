"""A model that cannot start is refused by its name, and the others are compared; a ball deeper than floats can tell."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from synthetic import hertz

import winkler as wk
from winkler.fitting.compare import compare
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.values.errors import OutsideValidity

YOUNG = "bed.medium.first.young"
FREE = [YOUNG, "contact_point"]
RADIUS, MODULUS = 1e-6, 1e5 / 0.75
POSITION = np.linspace(-10e-6, 20e-6, 300)
NOISE = np.random.default_rng(0).standard_normal(POSITION.size)


def pressed(profile):
    bed = wk.Foundation(profile, wk.HalfSpace.between(wk.Elastic(2e5, 0.5)))
    return wk.Indentation(bed, wk.Depth(0.0))


def ball_force(depth):
    """Sneddon's ball, d = a/2 ln((R+a)/(R-a)); from where a is R in floats, F = E* R (2 d - R)."""
    a = RADIUS * np.tanh(np.linspace(1e-6, 18.0, 200_001))
    d = 0.5 * a * np.log((RADIUS + a) / (RADIUS - a))
    force = MODULUS * (0.5 * (a**2 + RADIUS**2) * np.log((RADIUS + a) / (RADIUS - a)) - a * RADIUS)
    deep = MODULUS * RADIUS * (2.0 * depth - RADIUS)
    return np.where(depth > 17.0 * RADIUS, deep, np.interp(depth, d, force, left=0.0))


def test_a_ball_deeper_than_eighteen_radii_is_fitted():
    """No float below R has artanh(a/R) > 18.71: the end of the table was infinite, and residuals no numbers."""
    force = ball_force(POSITION)
    found = fit(ForceCurve(POSITION, force + 1e-4 * force.max() * NOISE), pressed(wk.Sphere(RADIUS)), free=FREE)
    assert found.value(YOUNG) == pytest.approx(1e5, rel=1e-3)
    assert not [flag for flag in found.flags if flag.name == "misfit"]


def test_a_blunt_tip_taken_for_a_ball_of_the_same_size_is_compared():
    tip = wk.SpheroConical(half_angle=0.3, curvature_radius=RADIUS)
    force = wk.Indentation(wk.Foundation(tip, wk.HalfSpace.between(wk.Elastic(1e5, 0.5))), wk.Depth(POSITION)).solve()
    curve = ForceCurve(POSITION, force.force + 1e-4 * force.force.max() * NOISE)
    models = {"ball": (pressed(wk.Sphere(RADIUS)), FREE), "blunt": (pressed(tip), FREE)}
    assert compare(curve, models).verdict == "This curve distinguishes blunt from ball."


@dataclasses.dataclass(frozen=True)
class Holed(wk.Paraboloid):
    """A shape with a hole in its table: nothing is known of it from half a radius on."""

    def gap(self, x):
        return np.where(x > 0.5 * self.curvature_radius, np.nan, super().gap(x))


def test_a_model_without_finite_forces_is_refused_by_name():
    curve = ForceCurve(POSITION, hertz(POSITION, MODULUS, RADIUS) * (1.0 + 1e-4 * NOISE) + 1e-8 * NOISE)
    models = {"holed": (pressed(Holed(RADIUS)), FREE), "whole": (pressed(wk.Paraboloid(RADIUS)), FREE)}
    found = compare(curve, models)
    assert found.models == ("whole",)
    assert found.unfitted == ("holed",)
    assert "holed: fit: the model predicts no finite number at the position " in found.refused[0]
    assert found.verdict.endswith("Not fitted, and therefore not excluded: holed.")
    with pytest.raises(
        OutsideValidity, match=r"no finite number at the position .* give a profile that reaches so far"
    ):
        fit(curve, pressed(Holed(RADIUS)), free=FREE)
