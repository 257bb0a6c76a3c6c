"""Reference of every closed form: T1 by mpmath's quadrature at 30 digits, from a slope written in the test itself."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import mpmath as mp
import numpy as np

DIGITS = 30
NODE_SPLITS = (0.5, 0.8, 0.95)
Slope = Callable[[mp.mpf], mp.mpf]


def _split(x: mp.mpf, edges: Sequence[float]) -> list[mp.mpf]:
    return [mp.mpf(0), *[mp.asin(mp.mpf(b) / x) for b in sorted(edges) if 0.0 < b < x], mp.pi / 2]


def _unit(slope: Slope, x: mp.mpf) -> mp.mpf:
    """What to divide by, because mpmath measures convergence by the size of one."""
    return slope(x) or mp.mpf(1)


def gap(slope: Slope, x: float | mp.mpf, edges: Sequence[float] = ()) -> mp.mpf:
    """g(x) = x Int f'(x sin t) dt."""
    with mp.workdps(DIGITS):
        x = mp.mpf(x)
        unit = _unit(slope, x)
        return x * unit * mp.quad(lambda t: slope(x * mp.sin(t)) / unit, _split(x, edges))


def gap_integral(slope: Slope, x: float, edges: Sequence[float] = ()) -> mp.mpf:
    """The integral of g, T7 integrated by parts: x^2 Int f'(x sin t) cos(t)^2 dt."""
    with mp.workdps(DIGITS):
        x = mp.mpf(x)
        unit = _unit(slope, x)
        return x**2 * unit * mp.quad(lambda t: slope(x * mp.sin(t)) / unit * mp.cos(t) ** 2, _split(x, edges))


def gap_slope(slope: Slope, x: float, edges: Sequence[float] = ()) -> mp.mpf:
    """g'(x) by a central difference of fourth order; its step is small against the distance from every edge."""
    with mp.workdps(DIGITS + 5):
        h = mp.mpf(min([x, *[abs(x - b) for b in edges if b != x]])) * mp.mpf("2e-6")
        points = [gap(slope, mp.mpf(x) + k * h, edges) for k in (-2, -1, 1, 2)]
        return (points[0] - 8 * points[1] + 8 * points[2] - points[3]) / (12 * h)


def height(slope: Slope, r: float, edges: Sequence[float] = ()) -> mp.mpf:
    """f(r), the integral of the slope."""
    with mp.workdps(DIGITS):
        r = mp.mpf(r)
        unit = _unit(slope, r)
        inner = {*[mp.root(mp.mpf(b) / r, 3) for b in edges if 0.0 < b < r], *map(mp.mpf, NODE_SPLITS)}
        # r t^3 takes the steepness of a cusp from the axis
        return 3 * r * unit * mp.quad(lambda t: t**2 * slope(r * t**3) / unit, [0, *sorted(inner), 1])


def assert_transforms(profile, slope: Slope, x: Sequence[float], edges: Sequence[float] = (), rtol: float = 1e-12):
    """The profile's height, slope, g, g' and integral of g agree with the reference.

    Close to an edge or wall b the rounding of x or x/b alone moves a function of x - b; that much is granted, no more.
    """
    x = np.asarray(x, dtype=float)
    near = np.array([min((abs(v - b) for b in edges if b != v), default=math.inf) for v in x])
    granted = rtol + 16.0 * np.spacing(x) / near
    smooth = ~np.isin(x, edges)  # a difference across an edge is no measure of the slope there
    for word, compared in (
        ("height", [height(slope, v, edges) for v in x]),
        ("slope", [slope(mp.mpf(v)) for v in x]),
        ("gap", [gap(slope, v, edges) for v in x]),
        ("gap_integral", [gap_integral(slope, v, edges) for v in x]),
        ("gap_slope", [gap_slope(slope, v, edges) if good else mp.nan for v, good in zip(x, smooth, strict=True)]),
    ):
        expected = np.array([float(v) for v in compared])
        got = getattr(profile, word)(x)
        assert got.shape == x.shape, word
        error = np.abs(got - expected)
        bad = ~(error <= granted * np.abs(expected)) & (smooth | (word != "gap_slope"))
        assert not bad.any(), (word, x[bad], got[bad], expected[bad], error[bad])
        # as a column and as a number
        np.testing.assert_allclose(getattr(profile, word)(x[:, None])[:, 0], got, rtol=1e-12, err_msg=word)
        single = getattr(profile, word)(np.array(x[0]))
        assert np.shape(single) == (), word
        np.testing.assert_allclose(single, got[0], rtol=1e-12, err_msg=word)


def assert_curvature(profile, slope: Slope, x: Sequence[float], rtol: float = 1e-12):
    """f'' agrees with a difference of the reference slope, away from edges."""
    x = np.asarray(x, dtype=float)
    with mp.workdps(DIGITS + 15):
        expected = [float(mp.diff(slope, mp.mpf(v), h=mp.mpf(v) * mp.mpf("1e-15"))) for v in x]
    np.testing.assert_allclose(profile.curvature(x), expected, rtol=rtol, atol=1e-18)


def assert_starts_at_zero(profile):
    """f(0) = g(0) = 0 and the integral too, exactly, in every shape of argument."""
    zero = np.zeros(1)
    for word in ("height", "gap", "gap_integral"):
        assert getattr(profile, word)(zero)[0] == 0.0, word
        assert float(getattr(profile, word)(np.array(0.0))) == 0.0, word
