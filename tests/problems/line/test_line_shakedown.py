"""Melan's limit: residual stresses by another minimisation, and where the bound of the shear is not reached."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import minimize

import winkler as wk
from winkler.problems.line.shakedown import least_stress
from winkler.problems.line.stress import LineFields

STRENGTH = 1e-3
K = STRENGTH / math.sqrt(3.0)


def solid(share=1.0, strength=STRENGTH, poisson=0.3):
    return wk.Elastic(share * (1.0 - poisson**2), poisson, strength=strength)


def left(fields, residual):
    """The greatest von Mises stress beside residual stresses along x and y."""
    x, y, z = fields.xx_stress + residual[0], fields.yy_stress + residual[1], fields.zz_stress
    square = 0.5 * ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) + 3.0 * fields.xz_stress**2
    return math.sqrt(max(float(np.max(square)), residual[0] ** 2 - residual[0] * residual[1] + residual[1] ** 2))


def minimised(fields):
    """The least of that, by simplices."""
    best = min(
        (minimize(lambda r: left(fields, r), start, method="Nelder-Mead", options={"xatol": 1e-10, "fatol": 1e-12})
         for start in ((0.0, 0.0), (1.0, 1.0), (-1.0, 0.0))),
        key=lambda one: one.fun,
    )  # fmt: skip
    return float(best.fun)


@pytest.mark.parametrize("seed", range(4))
def test_residual_stresses_leave_the_least_that_simplices_find(seed):
    rng = np.random.default_rng(seed)
    rows = rng.normal(size=(4, 40)) * np.array([1.0, 1.0, 1.0, [0.2, 0.7, 1.5, 0.0][seed]])[:, None]
    fields = LineFields(np.zeros(40), np.zeros(40), *rows)
    level, touched = least_stress(fields)
    assert level == pytest.approx(minimised(fields), rel=1e-6)
    assert 1 <= len(touched) <= 3


def test_a_rubbed_half_plane_does_not_reach_the_bound_of_its_shear():
    """At both edges sigma_x = -+2 mu p0 and sigma_y = nu sigma_x: whatever residual stress, one of them has as much."""
    plane = wk.LineFoundation(wk.Paraboloid(1.0), wk.HalfSpace(solid()))
    found = wk.LineShakedown(plane, wk.Coulomb(0.5)).solve()
    p0 = 4.0 / math.pi * found.mean_pressure
    assert p0 == pytest.approx(2.0 * K, rel=1e-6)
    assert 2.0 * 0.5 * p0 * math.sqrt(1.0 - 0.3 + 0.09) > STRENGTH
    note = found.validity[-1]
    assert note.standing is wk.Standing.APPROXIMATE
    assert "bounds the limit from above" in str(note)
    free = wk.LineShakedown(plane).solve().validity[-1]
    assert free.standing is wk.Standing.EXACT
