"""Searches have no length of their own: from nanometres to kilometres, over twelve decades of moduli, the same digits.

Shapes without a length, cones above all: what the search begins with must come from the layers or from the load.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.laws.friction import Coulomb

SCALES = [(1e-9, 1e-6), (3e-6, 1e6), (1e3, 1e-6), (1e3, 1e6)]
CONE = wk.Cone(1.3)


def half_space(m: float) -> wk.HalfSpace:
    return wk.HalfSpace.between(wk.Elastic(m, 0.3))


def film(s: float, m: float) -> wk.CoatedHalfSpace:
    return wk.CoatedHalfSpace([wk.Layer(wk.Elastic(m, 0.5), s)], on=wk.Rigid())


def pulled_off(bed: wk.Foundation, law, s: float, m: float):
    found = wk.PullOff(bed, law).solve()
    return found.force / (m * s**2), found.radius / s, found.depth / s


def pressed_into(s: float, m: float):
    found = wk.Indentation(wk.Foundation(CONE, half_space(m)), wk.Force(m * s**2)).solve()
    return found.depth / s, found.radius / s


def short_range(s: float, m: float):
    return pulled_off(wk.Foundation(CONE, half_space(m)), wk.ShortRange(1e-3 * m * s), s, m)


def short_range_on_a_film(s: float, m: float):
    return pulled_off(wk.Foundation(CONE, film(s, m)), wk.ShortRange(1e-3 * m * s), s, m)


def short_range_on_a_ball(s: float, m: float):
    return pulled_off(wk.Foundation(wk.Paraboloid(3.0 * s), film(s, m)), wk.ShortRange(1e-4 * m * s), s, m)


def a_range(s: float, m: float):
    return pulled_off(wk.Foundation(wk.PowerLaw(0.1 / s, 2.0), half_space(m)), wk.Dugdale(1e-3 * m * s, 0.05 * m), s, m)


def far(s: float, m: float):
    law = wk.DerjaguinMullerToporov(1e-3 * m * s)
    found = wk.AdhesiveIndentation(wk.Foundation(wk.PowerLaw(0.1 / s, 2.0), half_space(m)), law, wk.Force(0.0)).solve()
    return found.depth / s, found.radius / s


def nearly_round(s: float, m: float):
    shapes = tuple(wk.PowerLaw((1.0 + 0.05 * math.cos(math.pi * k / 4.0)) / s, 2.0) for k in range(8))
    found = wk.NearlyRoundIndentation(shapes, half_space(m), wk.Force(1e-3 * m * s**2)).solve()
    return found.depth / s, found.stiffness / (m * s)


def struck(s: float, m: float):
    bed = wk.Foundation(wk.PowerLaw(0.1 / s, 2.0), half_space(m))
    found = wk.Impact(bed, Coulomb(0.0), m * s, 0.1 * s).solve()
    return found.duration, found.restitution


def struck_slowly(s: float, m: float):
    body = wk.Foundation(CONE, wk.ViscoelasticHalfSpace(wk.KelvinVoigt(m, 0.2 * m)))
    return (wk.ViscoelasticImpact(body, m * s, 0.1 * s, count=40, tolerance=0.05).solve().restitution,)


def turned(s: float, m: float):
    depth = np.linspace(0.0, 0.02 * s, 40)[1:]
    body = wk.design_profile(depth, m * depth**1.5 * s**0.5, half_space(m))
    return body.height(0.05 * s * np.array([0.3, 1.0])) / s


def fitted(s: float, m: float):
    position = np.linspace(-0.4, 0.5, 120)
    model = wk.Indentation(wk.Foundation(CONE, film(s, m)), wk.Depth(0.0))
    force = wk.Indentation(model.bed, wk.Depth(s * position)).solve().force
    noise = 1e-3 * force[-1] * np.sin(37.0 * np.arange(120.0) ** 1.3)
    name = "bed.medium.layers[0].solid.young"
    found = fit(ForceCurve(s * position, force + noise), model, free={name: 7.0 * m, "contact_point": ()})
    return found.value(name) / m, 1.0 + found.value("contact_point") / s  # a place along the curve


LAWS = [
    pressed_into,
    short_range,
    short_range_on_a_film,
    short_range_on_a_ball,
    a_range,
    far,
    nearly_round,
    struck,
    turned,
]


@pytest.mark.few(2)
@pytest.mark.parametrize("law", LAWS)
def test_same_digits_in_every_unit(law):
    wanted = law(1.0, 1.0)
    for s, m in SCALES:
        np.testing.assert_allclose(law(s, m), wanted, rtol=1e-8)


@pytest.mark.slow
@pytest.mark.parametrize(("s", "m"), [(2.0**-30, 2.0**-20), (2.0**10, 2.0**20)])
def test_an_impact_in_binary_units(s, m):
    """Its march turns roundings into 2e-8 of the restitution; units of powers of two have none."""
    np.testing.assert_allclose(struck_slowly(s, m), struck_slowly(1.0, 1.0), rtol=1e-12)


@pytest.mark.slow
def test_fits_in_every_unit():
    """Within what is taken for a measured curve; least squares stop at half the digits."""
    wanted = fitted(1e-6, 1e4)
    for s, m in ((2e-9, 1e9), (1e-7, 1.0), (1e-4, 1e-2)):
        np.testing.assert_allclose(fitted(s, m), wanted, rtol=1e-6)
