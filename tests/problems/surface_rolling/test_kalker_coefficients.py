"""Kalker's coefficients by boundary elements, of long and wide ellipses, beside the linear theory without a grid."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import fsolve

import winkler as wk

SMALL, STICKS = 1e-9, 1e3


def by_elements(ratio: float, nu: float, along: int, across: int) -> tuple[np.ndarray, float]:
    """Return c11, c22, c23, c33 of an ellipse with ab = 1 on so many pixels, and the area of its pixels over pi."""
    body = wk.Elastic(2.0 * (1.0 + nu), nu)
    medium, axes = wk.HalfSpace(body, body), np.array([ratio, 1.0 / ratio]) ** 0.5
    force = 1e-2 * medium.modulus

    def off(logarithms):
        return np.log(np.array(wk.CurvedBodies(*np.exp(logarithms)).semi_axes(medium.modulus, force)) / axes)

    curved = wk.CurvedBodies(*np.exp(fsolve(off, np.full(2, np.log(133.0 * max(axes))), xtol=1e-13)))
    count = np.array([along, across])
    wide = count + 8
    ellipse = wk.SampledProfile(2.0 * axes * wide / count, curved, tuple(wide.tolist()))
    creepage = wk.Creepage([SMALL, 0.0, 0.0], [0.0, SMALL, 0.0], [0.0, 0.0, SMALL])
    done = wk.SurfaceRolling(ellipse, medium, wk.Force(force), wk.Coulomb(STICKS), creepage).solve()
    found = [done.longitudinal_force[0], done.lateral_force[1], done.lateral_force[2], done.moment[2]]
    return np.array(found) / SMALL, float(np.count_nonzero(done.last.pressure > 0.0) * 4.0 / (np.pi * np.prod(count)))


def errors(ratio: float, nu: float, along: int, across: int) -> tuple[np.ndarray, np.ndarray]:
    """Return relative errors of c11, c22, c23 and c33: by the semi-axes, and by the area that the pixels have."""
    found, area = by_elements(ratio, nu, along, across)
    solved = wk.linear_creep_coefficients(ratio, nu)
    wanted = np.array([solved.longitudinal, solved.lateral, solved.spin, solved.turning])
    return found / wanted - 1.0, found / area ** np.array([1.0, 1.0, 1.5, 2.0]) / wanted - 1.0


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("ratio", "nu"), [(0.2, 0.5), (5.0, 0.0)])
def test_half_the_pixels(ratio, nu):
    """144 pixels along rolling, 72 across."""
    plain, sized = errors(ratio, nu, 144, 72)
    assert np.all(np.abs(plain) < [8e-3, 8e-3, 1.2e-2, 1.5e-2])
    assert np.all(np.abs(sized)[:3] < [2e-3, 2e-3, 4e-3])


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("nu", [0.0, 0.25, 0.5])
@pytest.mark.parametrize("ratio", [0.2, 0.5, 1.0, 2.0, 5.0])
def test_long_and_wide_ellipses(ratio, nu):
    """Pixels half as long as wide, 288 by 144: 0.2 % for the area of the pixels; and extrapolated from half as many."""
    plain, sized = errors(ratio, nu, 288, 144)
    assert np.all(np.abs(sized[:3]) < 2e-3)
    assert np.all(np.abs(plain[:3]) < [4e-3, 4e-3, 6.5e-3])
    before, _ = errors(ratio, nu, 144, 72)
    assert np.all(np.abs(2.0 * plain - before)[:3] < 1.5e-3)


@pytest.mark.slow
@pytest.mark.parametrize("ratio", [0.2, 1.0, 5.0])
@pytest.mark.parametrize(("count", "plain_error", "sized_error"), [
    (36, [2.1e-2, 2.1e-2, 3.4e-2], [8e-3, 1.1e-2, 1.9e-2]),
    (72, [1.3e-2, 1.4e-2, 2.2e-2], [5e-3, 6e-3, 1e-2]),
    (144, [5.5e-3, 6.5e-3, 1e-2], [3.5e-3, 4.5e-3, 7e-3]),
])  # fmt: skip
def test_as_many_pixels_along_as_across(ratio, count, plain_error, sized_error):
    """What the manual states of one grid, at Poisson's ratio 0.5, where it errs most."""
    plain, sized = errors(ratio, 0.5, count, count)
    assert np.all(np.abs(plain[:3]) < plain_error)
    assert np.all(np.abs(sized[:3]) < sized_error)
