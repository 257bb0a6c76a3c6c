"""Thin and thick, soft and stiff to a factor of a million, incompressible: k against extended precision and limits."""

from __future__ import annotations

import numpy as np
import pytest
from extended_punch import punch

import winkler as wk

CORNERS = [(0.5, None), (0.5, 1e6), (0.499999, 1e3), (0.3, 1e-6), (0.0, 1e-6)]


def film(poisson: float, base: float | None) -> wk.CoatedHalfSpace:
    on = wk.Rigid() if base is None else wk.Elastic(base, 0.3)
    return wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1.0, poisson), 1.0)], on=on)


def differences(poisson: float, base: float | None, a: float, step: float) -> tuple[float, float, float]:
    """Relative differences of k, of the part of k_x along its waves, and of k_phi."""
    medium, radius = film(poisson, base), np.array(a)
    normal = float(medium.punch_stiffness(radius)) / (2.0 * medium.modulus * a)
    twist = float(medium.punch_torsional_stiffness(radius)) / (16.0 / 3.0 * medium.torsional_modulus * a**3)
    shear = float(medium.punch_shear_stiffness(radius))
    sides = [2.0 * each.modulus * a * punch(each, a, step=step)
             for each in (medium.along_response, medium.across_response)]  # fmt: skip
    return (
        normal / punch(medium.response, a, step=step) - 1.0,
        shear / (2.0 / (1.0 / sides[0] + 1.0 / sides[1])) - 1.0,
        twist / punch(medium.across_response, a, step=step, odd=True) - 1.0,
    )


@pytest.mark.parametrize(("poisson", "base"), CORNERS[:2])
def test_as_wide_as_thick(poisson, base):
    assert differences(poisson, base, 1.0, 0.5) == pytest.approx((0.0, 0.0, 0.0), abs=1e-12)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("poisson", "base"), CORNERS)
def test_ten_times_as_wide_as_thick(poisson, base):
    assert differences(poisson, base, 10.0, 1.0) == pytest.approx((0.0, 0.0, 0.0), abs=1e-11)


@pytest.mark.parametrize("contrast", [1e4, 7e7])
def test_stiff_layers_on_thin_soft_films(contrast):
    """They were refused from a contrast of 7e4 on.  Narrow punches: k = 2 E* a / (1 + a C(0)), C(0) by quadrature."""
    plate, gel = wk.Layer(wk.Elastic(contrast, 0.2), 0.5), wk.Layer(wk.Elastic(1.0, 0.5), 0.1)
    medium = wk.CoatedHalfSpace([plate, gel], on=wk.Rigid())
    nodes, weights = np.polynomial.legendre.leggauss(20)
    edges = np.concatenate([[0.0], np.geomspace(1e-8, 60.0, 120)])
    half = 0.5 * np.diff(edges)[:, None]
    xi, share = (edges[:-1, None] + half * (nodes + 1.0)).ravel(), (half * weights).ravel()
    at_zero = 2.0 / np.pi * float(share @ medium.response.excess(xi))
    a = 1e-4
    wanted = 2.0 * medium.modulus * a / (1.0 + a * at_zero)
    assert float(medium.punch_stiffness(np.array(a))) == pytest.approx(wanted, rel=1e-8)


def test_wide_contacts_solve_what_they_need(monkeypatch):
    """A soft incompressible layer a thousandth as thick as its contact: each octave once, and none beyond the contact.

    The digits that such layers squeeze out end the series; octaves were halved for them, and searched one too far.
    """
    from winkler.numerics.transforms import punch_tables

    solved, solve = [], punch_tables._solve

    def counted(response, low, high):
        solved.append((low, high))
        return solve(response, low, high)

    monkeypatch.setattr(punch_tables, "_solve", counted)
    medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1.03e-6, 0.5), 1.0)], on=wk.Elastic(1.0, 0.3))
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(1e6), medium), wk.Depth(1.0)).solve()
    assert 1000.0 < contact.radius < 1200.0
    widest = max(high for _, high in solved)
    assert widest < 2.0 * contact.radius
    wide = [pair for pair in solved if pair[1] > 250.0]
    assert len(wide) == len({high for _, high in wide}) <= 3
    assert all(low == 0.5 * high for low, high in wide)
