"""Lines on thin and thick layers, a million times softer or stiffer, incompressible: equations of another kind."""

from __future__ import annotations

import numpy as np
import pytest
from layer_waves import excesses
from strips_of_layers import Kernel, released

import winkler as wk

LAYER = 1.0
"""Shear modulus; the thickness and the radius of the body are one, too."""


def bed(poisson: float, contrast: float | None) -> wk.LayeredLineFoundation:
    solid = wk.Elastic(2.0 * (1.0 + poisson) * LAYER, poisson)
    on = wk.Rigid() if contrast is None else wk.Elastic(2.6 * contrast * LAYER, 0.3)
    return wk.LayeredLineFoundation(wk.Paraboloid(1.0), wk.CoatedHalfSpace([wk.Layer(solid, 1.0)], on=on))


def carried(poisson: float, contrast: float | None, a: float) -> float:
    return float(bed(poisson, contrast).load_profile(np.array([a]))[0])


@pytest.mark.few(3, slow=6)
@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.5])
@pytest.mark.parametrize("contrast", [1e6, 1e3, 1e-3, 1e-6])
@pytest.mark.parametrize("a", [1.0, 30.0])
def test_against_a_singular_integral_equation(poisson, contrast, a):
    """The load without tension at the edges, of an equation for the pressure at Gauss-Chebyshev points."""
    kernel = Kernel(lambda k: excesses([(LAYER, poisson, 1.0)], (contrast * LAYER, 0.3), k)[0], 2.0 * a)
    count = 240
    alone, pushed = (released(kernel, a, load, lambda x: x, count) for load in (0.0, a * a))
    wanted = a * a * alone / (alone - pushed)
    assert carried(poisson, contrast, a) == pytest.approx(wanted, rel=1e-6)


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.5])
@pytest.mark.parametrize("contrast", [1e6, 1e-6, None])
def test_narrow_lines_feel_the_layer_alone(poisson, contrast):
    """pi a^2 / (4 R), less what is felt of the base, (a / h)^2 times the contrast at the most."""
    assert carried(poisson, contrast, 1e-6) == pytest.approx(0.25 * np.pi * 1e-12, rel=1e-9)


@pytest.mark.few(0, slow=3)
@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.5])
def test_wide_lines_squeeze_a_film(poisson):
    """Bonded to a rigid base: each column by itself, or where it cannot change its volume, Reynolds' equation.

    What is left is of the edges, of the order h / a.
    """
    modulus = bed(poisson, None).medium.modulus
    misfits = []
    for a in (250.0, 500.0, 1000.0):
        if poisson == 0.5:
            wanted = 2.0 / 15.0 * LAYER * a**5
        else:
            wanted = 2.0 * LAYER * (1.0 - poisson) / (1.0 - 2.0 * poisson) * 2.0 / 3.0 * a**3
        misfits.append(modulus * carried(poisson, None, a) / wanted - 1.0)
    assert abs(misfits[-1]) < 0.01
    assert misfits[0] / misfits[1] == pytest.approx(2.0, rel=0.02)
    assert misfits[1] / misfits[2] == pytest.approx(2.0, rel=0.01)


def test_another_modulus_solves_no_equation(monkeypatch):
    """Loads over E* under strips of one width are those of all layers of the same ratios; a new ratio is solved."""
    from winkler.foundation import layered_line

    def load(unit: float, base: float) -> float:
        medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(unit, 0.3), 1.0)], on=wk.Elastic(base * unit, 0.2))
        return float(wk.LayeredLineFoundation(wk.Paraboloid(2.0), medium).load_profile(np.array([0.7]))[0])

    first = load(1.0, 3.0)

    def refused(*given):
        raise AssertionError("solved again")

    monkeypatch.setattr(layered_line, "strip_responses", refused)
    assert load(2.1e11, 3.0) == pytest.approx(first, rel=1e-12)
    with pytest.raises(AssertionError, match="solved again"):
        load(2.1e11, 3.5)


@pytest.mark.parametrize("power", [1.0, 2.0, 2.5, 4.0])
def test_another_thickness_and_radius_solve_no_equation(power, monkeypatch):
    """200 loads at the same ratios of half-width and thickness under c x^n; the loads over E* are as c h^n."""
    from winkler.foundation import layered_line

    def loads(thickness, coefficient):
        shape = wk.Paraboloid(0.5 / coefficient) if power == 2.0 else wk.PowerLaw(coefficient, power)
        medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1.0, 0.3), thickness)], on=wk.Elastic(5.3, 0.2))
        bed = wk.LayeredLineFoundation(shape, medium)
        return bed.load_profile(thickness * np.geomspace(0.1, 3.0, 200)) / (coefficient * thickness**power)

    first = loads(1.0, 0.25)
    monkeypatch.setattr(layered_line, "strip_responses", None)
    assert loads(0.37e-6, 170.0) == pytest.approx(first, rel=1e-12)
    if power == 1.0:
        cone = wk.LayeredLineFoundation(wk.Cone(np.arctan(4.0)), wk.CoatedHalfSpace(
            [wk.Layer(wk.Elastic(1.0, 0.3), 1.0)], on=wk.Elastic(5.3, 0.2)))  # fmt: skip
        assert cone.load_profile(np.geomspace(0.1, 3.0, 200)) == pytest.approx(0.25 * first, rel=1e-12)


@pytest.mark.parametrize("profile", [wk.Paraboloid(1.0), wk.PowerLaw(0.5, 3.5), wk.RoundedCone(0.2, 0.3)])
@pytest.mark.parametrize("contrast", [0.1, pytest.param(1e3, marks=pytest.mark.slow)])
def test_many_half_widths_are_those_one_by_one(profile, contrast):
    """Polynomials over octaves against the equation of each strip."""
    medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(contrast, 0.3), 1.0)], on=wk.Elastic(1.0, 0.3))
    bed = wk.LayeredLineFoundation(profile, medium)
    a = np.geomspace(0.01, 3.0, 300)
    for curve in (bed.load_profile, bed.load_profile_slope, bed.edge_share):
        one_by_one = np.concatenate([curve(part) for part in np.split(a, 30)])
        assert curve(a) == pytest.approx(one_by_one, rel=2e-10)
