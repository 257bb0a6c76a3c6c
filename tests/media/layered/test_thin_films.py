"""Films on a rigid base, from much narrower to much wider contacts than they are thick, by another route.

The reference takes M in closed form, its transform by plain quadrature, and solves the equation of the flat punch on
equal panels of half a thickness: no graded panels, no turned path, no tables.
"""

from __future__ import annotations

import functools
import math

import numpy as np
import pytest
import scipy.linalg

import winkler as wk
from winkler.media.layered import flat_punch
from winkler.numerics.transforms import fredholm, punch_tables

NODES, WEIGHTS = (part / 2.0 for part in np.polynomial.legendre.leggauss(16))
NODES = NODES + 0.5


def film(poisson: float, thickness: float = 1.0, young: float = 1.0) -> wk.CoatedHalfSpace:
    return wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, poisson), thickness)], on=wk.Rigid())


def relative(medium: wk.CoatedHalfSpace, a: float) -> float:
    """k / (2 E* a)."""
    return float(medium.punch_stiffness(np.array(a)) / (2.0 * medium.modulus * a))


# ------------------------------------------------------------------------------------------------------ the reference


def excess(x: np.ndarray, poisson: float) -> np.ndarray:
    """M of a bonded film of thickness one; the numerator of 1 + M by its series where it cancels."""
    kappa = 3.0 - 4.0 * poisson
    fall = np.exp(-2.0 * x)
    odd = kappa * (1.0 - fall**2) - 4.0 * x * fall
    series = sum((2.0 * x) ** n / math.factorial(n) for n in range(3, 28, 2))
    odd = np.where(x < 1.0, (2.0 * kappa * series + 4.0 * x * (kappa - 1.0)) * fall, odd)
    return odd / (kappa * (1.0 + fall**2) + (4.0 * x**2 + 1.0 + kappa**2) * fall) - 1.0


def panels(edges: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    width = np.diff(edges)[:, None]
    return (edges[:-1, None] + width * NODES).ravel(), (width * WEIGHTS).ravel()


def kernel(x: np.ndarray, poisson: float, end: float) -> np.ndarray:
    """C(x), by quadrature at Chebyshev points of panels as long as the film is thick."""
    xi, w = panels(np.arange(0.0, 22.0, min(0.5, 6.0 / end)))
    w = w * excess(xi, poisson) * 2.0 / np.pi
    cheb = np.polynomial.chebyshev
    s = cheb.chebpts1(20)
    invert = np.linalg.inv(cheb.chebvander(s, 19))
    starts = np.arange(math.ceil(end) + 1.0)
    series = np.array([invert @ (np.cos(np.outer(low + 0.5 * (s + 1.0), xi)) @ w) for low in starts])
    which = np.minimum(x.astype(int), len(starts) - 1)
    t = 2.0 * (x - which) - 1.0
    last, current = np.zeros_like(t), np.zeros_like(t)
    for k in range(19, 0, -1):
        last, current = current, series[which, k] + 2.0 * t * current - last
    return series[which, 0] + t * current - last


@functools.cache
def operator(poisson: float, a: float, step: float):
    """Nodes, weights and the factors of the equation on equal panels, which serve all bodies on this disc."""
    x, w = panels(np.linspace(0.0, a, max(2, math.ceil(a / step)) + 1))
    both = 0.5 * (kernel(np.abs(x[:, None] - x), poisson, 2.0 * a) + kernel(x[:, None] + x, poisson, 2.0 * a))
    return x, w, scipy.linalg.lu_factor(np.eye(x.size) + both * w)


def compared(poisson: float, a: float, h: np.ndarray | None = None, step: float = 0.5):
    """Nodes, weights and the line load of a flat punch, or of a body with the transform h."""
    x, w, factors = operator(poisson, a, step)
    return x, w, scipy.linalg.lu_solve(factors, np.ones(x.size) if h is None else h)


WIDTHS = [0.3, 3.0, 10.0, 30.0, pytest.param(60.0, marks=pytest.mark.slow)]


@pytest.mark.few(1)
@pytest.mark.parametrize("poisson", [0.5, 0.3])
@pytest.mark.parametrize("a", WIDTHS)
def test_punches_on_films_by_equal_panels(poisson, a):
    x, w, phi = compared(poisson, a)
    medium = film(poisson)
    assert relative(medium, a) == pytest.approx(float(w @ phi) / a, rel=2e-10)
    found = fredholm.punches(medium.response, x, np.full(x.shape, a))
    np.testing.assert_allclose(found, phi, rtol=0.0, atol=1e-9 * np.max(phi))


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("a", [3.0, 30.0])
def test_the_reference_solution_does_not_move_with_half_its_panels(a):
    _, w, phi = compared(0.5, a)
    _, finer, twice = compared(0.5, a, step=0.25)
    assert float(finer @ twice) == pytest.approx(float(w @ phi), rel=1e-10)


@pytest.mark.few(6, slow=4)
@pytest.mark.parametrize("poisson", [0.5, 0.3])
@pytest.mark.parametrize("a", [0.3, 10.0, 30.0])
@pytest.mark.parametrize("n", [1.0, 2.0, 3.5])
def test_depth_and_force_of_powers_by_equal_panels(poisson, a, n):
    """g(a) makes the line load at the edge vanish, and F is its integral."""
    shape = wk.PowerLaw(1.0, n)
    x, w, phi = compared(poisson, a)
    _, _, pressed = compared(poisson, a, shape.gap(x))
    places = np.linspace(0.5 * a, a, 6)[:-1]
    bed = wk.Foundation(shape, film(poisson))
    solution = wk.Indentation(bed, wk.Radius(a)).solve()
    force = 2.0 * bed.medium.modulus * float(w @ (solution.depth * phi - pressed))
    assert solution.force == pytest.approx(force, rel=1e-9)
    # the last of the panels, continued to the edge
    last = slice(x.size - 16, x.size)
    edge = [np.polyval(np.polyfit(x[last] - a, part[last], 13), 0.0) for part in (pressed, phi)]
    assert solution.depth == pytest.approx(edge[0] / edge[1], rel=1e-7)
    assert np.all(np.diff(bed.gap(places)) > 0.0)


# ------------------------------------------------------------------------------------------------------- both limits


@pytest.mark.parametrize("poisson", [0.5, 0.3, 0.0])
def test_narrow_punches_feel_the_film_by_its_mean(poisson):
    """phi is constant to second order: k / (2 E* a) = 1 / (1 + a C(0))."""
    import mpmath

    kappa = mpmath.mpf(3) - 4 * mpmath.mpf(poisson)

    def m(x):
        odd = 2 * kappa * mpmath.sinh(2 * x) - 4 * x
        return odd / (2 * kappa * mpmath.cosh(2 * x) + 4 * x**2 + 1 + kappa**2) - 1

    at_zero = float(2 / mpmath.pi * mpmath.quad(m, [0, 0.5, 1, 2, 4, 8, 16, 30]))
    for a in (1e-5, 1e-4):
        assert relative(film(poisson), a) == pytest.approx(1.0 / (1.0 + a * at_zero), abs=2.0 * a**3)


def test_wide_punches_squeeze_an_incompressible_film_like_a_liquid():
    """k = 3 pi G a^4 / (8 h^3), and less by parts of h / a."""

    def share(a: float) -> float:
        return float(film(0.5).punch_stiffness(np.array(a))) / (3.0 * np.pi / 8.0 * (1.0 / 3.0) * a**4)

    first = [share(a) - 1.0 for a in (25.0, 50.0, 100.0)]
    second = [2.0 * fine - coarse for coarse, fine in zip(first[:-1], first[1:], strict=True)]
    assert abs((4.0 * second[1] - second[0]) / 3.0) < 1e-4
    assert first[2] == pytest.approx(0.5 * first[1], rel=0.05)
    wide = [share(a) - 1.0 for a in (750.0, 1500.0)]  # where rounding leaves six digits
    assert abs(2.0 * wide[1] - wide[0]) < 2e-5


@pytest.mark.parametrize("poisson", [0.0, 0.3, pytest.param(0.45, marks=pytest.mark.slow)])
def test_wide_punches_compress_a_film_like_a_bed(poisson):
    """k = pi a^2 E (1 - nu) / ((1 + nu)(1 - 2 nu) h), Johnson section 5.8; more by parts of h / a."""
    modulus = (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson))

    def share(a: float) -> float:
        return float(film(poisson).punch_stiffness(np.array(a))) / (np.pi * a**2 * modulus)

    first = [share(a) - 1.0 for a in (50.0, 100.0, 200.0)]
    second = [2.0 * fine - coarse for coarse, fine in zip(first[:-1], first[1:], strict=True)]
    assert abs((4.0 * second[1] - second[0]) / 3.0) < 2e-5


# -------------------------------------------------------------------------------------------------- without lengths


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("shape", ["cone", "paraboloid", "rounded"])
@pytest.mark.parametrize("poisson", [0.5, 0.3])
def test_thickness_and_modulus_are_units(shape, poisson):
    """Twelve decades of lengths and of moduli; the cone on films of three micrometres was not solved at first.

    A unit of length and one of modulus are changed together: neither hides the other.
    """
    shares = np.array([1e-3, 0.05, 0.5, 1.0])

    def solutions(h: float, young: float):
        made = {
            "cone": wk.Cone(1.2),
            "paraboloid": wk.Paraboloid(5.0 * h),
            "rounded": wk.RoundedCone(curvature_radius=0.5 * h, half_angle=1.2),
        }[shape]
        bed = wk.Foundation(made, film(poisson, h, young))
        deep = wk.Indentation(bed, wk.Depth(shares * h)).solve()
        pressed = wk.Indentation(bed, wk.Force(deep.force)).solve()
        return np.array([deep.radius / h, deep.force / (young * h**2), pressed.depth / h, pressed.radius / h])

    one = solutions(1.0, 1.0)
    for h, young in ((1e-9, 1e-6), (1e-9, 1e6), (3e-6, 1e6), (5e-6, 1e-6), (1e-3, 1e6), (1e3, 1e-6)):
        np.testing.assert_allclose(solutions(h, young), one, rtol=1e-11)


def test_films_share_what_depends_on_contrasts_and_poisson_ratios():
    """Another thickness, another modulus, another body of the same contrast: nothing is computed again."""
    first = wk.CoatedHalfSpace(
        [wk.Layer(wk.Elastic(3.0, 0.4), 0.7)], on=wk.Elastic(30.0, 0.2), second=wk.Elastic(9.0, 0)
    )
    alike = wk.CoatedHalfSpace(
        [wk.Layer(wk.Elastic(3.3e9, 0.4), 7e-9)], on=wk.Elastic(3.3e10, 0.2), second=wk.Elastic(9.9e9, 0.0)
    )
    wanted = relative(first, 0.7)
    known = punch_tables._tables.cache_info().misses
    assert relative(alike, 7e-9) == pytest.approx(wanted, rel=1e-14)
    assert punch_tables._tables.cache_info().misses == known
    assert relative(wk.CoatedHalfSpace(first.layers, on=first.on), 0.7) != pytest.approx(wanted, rel=1e-3)
    assert punch_tables._tables.cache_info().misses > known


@pytest.mark.parametrize("shape", [wk.Sphere(40.0), wk.Hyperboloid(0.5, 1.3), wk.Formula("r**2/2 + r**4/50")])
def test_samples_give_the_moments_of_smooth_shapes(shape):
    """Against Gauss' rule on many panels, with the kernel of the film as the tables give it."""
    response = film(0.5).response
    nodes, weights = np.polynomial.legendre.leggauss(60)
    for a in (0.02, 0.7, 3.0, 17.0):
        edges = a * (1.0 - np.concatenate([0.5 ** np.arange(12), [0.0]]))
        x = (0.5 * (edges[1:] + edges[:-1])[:, None] + 0.5 * np.diff(edges)[:, None] * nodes).ravel()
        w = (0.5 * np.diff(edges)[:, None] * weights).ravel()
        radius = np.full(x.shape, a)
        load = float(w @ (fredholm.punches(response, x, radius) * shape.gap(x)))
        lost = float(w @ (fredholm.resolvent(response, x, radius).value * shape.gap(x)))
        g = (float(shape.gap(np.array([a]))[0]) - lost) / float(fredholm.edge(response, np.array(a)))
        assert float(flat_punch.gap_load(response, shape, np.array([a]))[0]) == pytest.approx(load, rel=1e-12)
        assert float(flat_punch.gap(response, shape, np.array([a]))[0]) == pytest.approx(g, rel=1e-10)
