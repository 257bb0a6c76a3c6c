"""The field below a traction: the theory sheet, Hamilton's closed forms, and Cerruti's point force added up."""

from __future__ import annotations

from dataclasses import dataclass

import mpmath as mp
import numpy as np
import pytest

from winkler.media.interior.shear_field import angular_shift, field

POISSON, YOUNG = 0.3, 2.0
SHEAR = 0.5 * YOUNG / (1.0 + POISSON)
MODULUS = 0.8
PLACES = np.array(
    [(0.5, 0.2, 0.4), (0.0, 0.0, 0.3), (-0.9, 0.0, 0.25), (0.3, -0.8, 0.5), (1.7, 0.6, 0.35), (-0.2, 2.5, 3.0)]
)


@dataclass(frozen=True)
class Ball:
    """u = 1 - x^2/a^2: the traction of Hertz."""

    radius: float = 1.0
    kinks: tuple = ()
    edge: float = 0.0

    def value(self, x):
        return 1.0 - (x / self.radius) ** 2

    def slope(self, x):
        return -2.0 * x / self.radius**2

    def traction(self, r):
        return 2.0 * MODULUS / np.pi / self.radius * np.sqrt(np.maximum(1.0 - (r / self.radius) ** 2, 0.0))


@dataclass(frozen=True)
class Cone:
    """u = 1 - x."""

    radius: float = 1.0
    kinks: tuple = ()
    edge: float = 0.0

    def value(self, x):
        return 1.0 - x

    def slope(self, x):
        return np.full(np.shape(x), -1.0)

    def traction(self, r):
        return MODULUS / np.pi * np.arccosh(1.0 / np.minimum(r, 1.0))


@dataclass(frozen=True)
class Stuck:
    """A flat punch: u = 1."""

    radius: float = 1.0
    kinks: tuple = ()
    edge: float = 1.0

    def value(self, x):
        return np.ones(np.shape(x))

    def slope(self, x):
        return np.zeros(np.shape(x))

    def ring(self, angle):
        """Traction times cos(angle) at r = sin(angle): rounding of r near the edge would spoil the traction itself."""
        return np.full(np.shape(angle), MODULUS / np.pi)


@dataclass(frozen=True)
class PartlyStuck:
    """u = c^2 - x^2 added to a corner at c: Mindlin's traction, the difference of two of Hertz'."""

    radius: float = 1.0
    stick: float = 0.6
    edge: float = 0.0

    @property
    def kinks(self):
        return ((self.stick, 0.0),)

    def value(self, x):
        return np.minimum(1.0 - x**2, 1.0 - self.stick**2)

    def slope(self, x):
        return np.where(x > self.stick, -2.0 * x, 0.0)

    def traction(self, r):
        inner = np.sqrt(np.maximum(self.stick**2 - r**2, 0.0))
        return 2.0 * MODULUS / np.pi * (np.sqrt(np.maximum(1.0 - r**2, 0.0)) - inner)


def cerruti(x, y, z):
    """Stress and 4 pi G times displacement of a unit force along +x: Johnson (1985), eqs. 3.75 and 3.76."""
    rho = np.sqrt(x * x + y * y + z * z)
    s, soft = rho + z, 1.0 - 2.0 * POISSON
    stresses = (
        -3.0 * x**3 / rho**5
        + soft * (x / rho**3 - 3.0 * x / (rho * s**2) + x**3 / (rho**3 * s**2) + 2.0 * x**3 / (rho**2 * s**3)),
        -3.0 * x * y**2 / rho**5
        + soft * (x / rho**3 - x / (rho * s**2) + x * y**2 / (rho**3 * s**2) + 2.0 * x * y**2 / (rho**2 * s**3)),
        -3.0 * x * z**2 / rho**5,
        -3.0 * x**2 * y / rho**5
        + soft * (-y / (rho * s**2) + x**2 * y / (rho**3 * s**2) + 2.0 * x**2 * y / (rho**2 * s**3)),
        -3.0 * x**2 * z / rho**5,
        -3.0 * x * y * z / rho**5,
    )
    moves = (
        1.0 / rho + x**2 / rho**3 + soft * (1.0 / s - x**2 / (rho * s**2)),
        x * y / rho**3 - soft * x * y / (rho * s**2),
        x * z / rho**3 + soft * x / (rho * s),
    )
    return np.array([*(part / (2.0 * np.pi) for part in stresses), *(part / (4.0 * np.pi * SHEAR) for part in moves)])


def added_up(shape, place):
    """Integrate point forces over the disc: Gauss along the radius sin(angle), the trapezoid rule around."""
    cuts = [0.0, *(np.arcsin(b) for b, _ in shape.kinks), 0.5 * np.pi]
    nodes, weights = np.polynomial.legendre.leggauss(120)
    total = np.zeros(9)
    turn = 2.0 * np.pi * np.arange(400) / 400
    for low, high in zip(cuts, cuts[1:], strict=False):
        # squares at both ends: the logarithm of a cone's tip is gone
        share = 0.5 * (1.0 + nodes)
        angle = low + (high - low) * share**2 * (3.0 - 2.0 * share)
        weight = 0.5 * weights * (high - low) * 6.0 * share * (1.0 - share)
        s = np.sin(angle)
        push = shape.ring(angle) if isinstance(shape, Stuck) else shape.traction(s) * np.cos(angle)
        ring = push * s * weight * (2.0 * np.pi / turn.size)
        x, y = np.outer(s, np.cos(turn)), np.outer(s, np.sin(turn))
        total += np.einsum("kij,i->k", cerruti(place[0] - x, place[1] - y, place[2]), ring)
    return total


def at(shape, places):
    x, y, z = np.asarray(places, dtype=float).T
    return np.array(field(shape, x, y, z, modulus=MODULUS, poisson=POISSON, shear=SHEAR)).T


def test_theory_numbers():
    """Section 2: tau = sqrt(1 - r^2), nu = 0.3 at (.5, .2, .4)."""
    got = field(Ball(), *np.array([[0.5], [0.2], [0.4]]), modulus=0.5 * np.pi, poisson=0.3, shear=1.0)
    expected = [-0.298712946, -0.0480135136, -0.148415945, -0.0511753634, -0.295624458, -0.0128999547]
    np.testing.assert_allclose(np.ravel(got)[:6], expected, rtol=0, atol=6e-10)


@pytest.mark.few(2)
@pytest.mark.parametrize("shape", [Ball(), Cone(), Stuck(), PartlyStuck()], ids=lambda shape: type(shape).__name__)
def test_point_forces_added_up(shape):
    """All nine components at six places, to 1e-10."""
    expected = np.array([added_up(shape, place) for place in PLACES])
    np.testing.assert_allclose(at(shape, PLACES), expected, rtol=1e-10, atol=1e-11)


def test_surface_in_closed_form():
    """Hamilton (1983): within the circle the stresses of tau = q0 sqrt(1 - r^2/a^2) are linear in x and y."""
    q0 = 2.0 * MODULUS / np.pi
    x, y = np.array([[0.5, 0.0, -1.0, 0.2, -0.6], [0.2, 0.0, 0.0, 0.9, 0.8]])
    got = field(Ball(), x, y, np.zeros(5), modulus=MODULUS, poisson=POISSON, shear=SHEAR)
    np.testing.assert_allclose(got.xx_stress, -q0 * np.pi / 8.0 * (4.0 + POISSON) * x, rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(got.yy_stress, -q0 * np.pi / 8.0 * 3.0 * POISSON * x, rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(got.xy_stress, -q0 * np.pi / 8.0 * (2.0 - POISSON) * y, rtol=1e-12, atol=1e-14)
    np.testing.assert_allclose(got.xz_stress, -Ball().traction(np.hypot(x, y)), rtol=1e-12, atol=1e-8)
    np.testing.assert_array_equal(got.zz_stress, 0.0)
    np.testing.assert_array_equal(got.yz_stress, 0.0)
    # Johnson (1985), eq. 3.91
    length = np.pi * q0 / (32.0 * SHEAR)
    expected = length * (4.0 * (2.0 - POISSON) - (4.0 - 3.0 * POISSON) * x**2 - (4.0 - POISSON) * y**2)
    np.testing.assert_allclose(got.x_displacement, expected, rtol=1e-12)
    np.testing.assert_allclose(got.y_displacement, length * 2.0 * POISSON * x * y, rtol=1e-11, atol=1e-14)


@pytest.mark.parametrize("shape", [Ball(), Cone(), Stuck(), PartlyStuck()], ids=lambda shape: type(shape).__name__)
def test_the_field_passes_into_that_of_the_surface(shape):
    places = np.array([(0.3, 0.2, 0.0), (-0.5, 0.7, 0.0), (0.1, -0.05, 0.0), (1.4, 0.3, 0.0), (-5.0, 2.0, 0.0)])
    below = places + np.array([0.0, 0.0, 1e-8])
    np.testing.assert_allclose(at(shape, below), at(shape, places), rtol=1e-6, atol=1e-7)


def test_on_the_axis():
    """Continuous towards it, and without a direction."""
    near = np.array([(1e-9, 0.0, 0.4), (0.0, 1e-9, 0.4), (-1e-9, 1e-9, 0.4)])
    axis = at(Ball(), [(0.0, 0.0, 0.4)])[0]
    np.testing.assert_allclose(at(Ball(), near), np.tile(axis, (3, 1)), atol=1e-8)
    np.testing.assert_allclose(axis[[0, 1, 2, 3, 5, 7, 8]], 0.0, atol=1e-15)


def test_equilibrium_and_hooke():
    """Finite differences of the stresses vanish, and the displacement gives the stresses."""
    h, place = 1e-4, np.array([0.4, -0.3, 0.45])
    rise = np.array([(at(PartlyStuck(), [place + h * e]) - at(PartlyStuck(), [place - h * e]))[0] for e in np.eye(3)])
    rise /= 2.0 * h
    index = np.array([[0, 3, 4], [3, 1, 5], [4, 5, 2]])
    stress = at(PartlyStuck(), [place])[0]
    scale = np.max(np.abs(rise[:, :6]))
    for row in index:
        assert abs(sum(rise[k, row[k]] for k in range(3))) < 1e-6 * scale
    strain = 0.5 * (rise[:, 6:] + rise[:, 6:].T)
    hooke = 2.0 * SHEAR * (strain + POISSON / (1.0 - 2.0 * POISSON) * np.trace(strain) * np.eye(3))
    np.testing.assert_allclose(hooke, stress[index], atol=1e-6 * np.max(np.abs(stress)))


def test_swerve():
    """B(r) = nu/(2 pi G) Int_0^min(r,a) q (1 - 2t^2/r^2)/sqrt(r^2 - t^2) dt: zero where the load is constant."""
    shape = PartlyStuck()
    r = np.array([0.0, 0.3, 0.59, 0.7, 0.95, 1.0, 1.2, 3.0])
    got = angular_shift(shape, r, modulus=MODULUS, poisson=POISSON, shear=SHEAR)
    np.testing.assert_array_equal(got[:3], 0.0)
    for value, place in zip(got[3:], r[3:], strict=True):
        c, a, end = mp.mpf("0.6"), mp.mpf(1), mp.asin(min(1, 1 / mp.mpf(place)))

        def load(t):
            return 1 - max(t, mp.mpf("0.6")) ** 2

        def integrand(v, load=load, place=place):
            return load(place * mp.sin(v)) * mp.cos(2 * v)

        expected = mp.quad(integrand, [0, mp.asin(c / mp.mpf(place)), end]) * MODULUS * POISSON / (2 * mp.pi * SHEAR)
        assert value == pytest.approx(float(expected), rel=1e-11), (place, a)


def test_dimensions():
    """Lengths times s: stresses of the same shape, displacements times s."""
    small = Ball(radius=1e-9)
    got = np.array(field(small, *(1e-9 * PLACES.T), modulus=MODULUS, poisson=POISSON, shear=SHEAR))
    whole = at(Ball(), PLACES).T
    np.testing.assert_allclose(got[:6] * 1e-9, whole[:6], rtol=1e-12, atol=1e-15)
    np.testing.assert_allclose(got[6:], whole[6:], rtol=1e-12, atol=1e-15)
