"""Flat punches from a Fredholm equation: Love's equation, whose kernel is known, and Krein's identities."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

from winkler.numerics.transforms import fredholm, punch_tables
from winkler.numerics.transforms.cosine_transform import transform


@dataclass(frozen=True)
class Love:
    """M = strength exp(-xi distance): C(x) = (2/pi) strength distance / (distance^2 + x^2)."""

    strength: float
    distance: float = 1.0

    @property
    def length(self) -> float:
        return 0.5 * self.distance

    @property
    def span(self) -> float:
        return self.distance

    @property
    def smooth(self) -> float:
        return self.length

    @property
    def precision(self) -> float:
        return 3e-14

    def excess(self, xi):
        return self.strength * np.exp(-xi * self.distance)


def love(strength: float, a: float, h: np.ndarray | None = None, count: int = 800):
    """Nodes, weights and the solution on [0, a], by plain Gauss-Legendre nodes and the closed kernel."""
    x, w = np.polynomial.legendre.leggauss(count)
    x, w = 0.5 * a * (x + 1.0), 0.5 * a * w
    kernel = strength / np.pi * (1.0 / (1.0 + (x[:, None] - x) ** 2) + 1.0 / (1.0 + (x[:, None] + x) ** 2))
    right = np.ones(count) if h is None else h(x)
    return x, w, np.linalg.solve(np.eye(count) + kernel * w, right)


@pytest.mark.parametrize("strength", [3.0, -0.9, 1e-3])
def test_the_cosine_transform(strength):
    x = np.concatenate([np.linspace(0.0, 4.0, 41), [17.3, 100.0, 999.0]])
    found = transform(Love(strength), 1000.0)(x)
    np.testing.assert_allclose(found, 2.0 / np.pi * strength / (1.0 + x * x), rtol=1e-11, atol=1e-13 * abs(strength))


@pytest.mark.few(3)
@pytest.mark.parametrize("strength", [3.0, -0.9])
@pytest.mark.parametrize(
    "a", [0.01, 1.3, pytest.param(0.4, marks=pytest.mark.slow), 11.0, pytest.param(60.0, marks=pytest.mark.slow)]
)
def test_punches(strength, a):
    x, w, phi = love(strength, a)
    response = Love(strength)
    assert float(fredholm.area(response, np.array(a))) == pytest.approx(w @ phi, rel=2e-12)
    found = fredholm.punches(response, x, np.full(x.shape, a))
    np.testing.assert_allclose(found, phi, rtol=0, atol=1e-11 * np.max(phi))


@pytest.mark.slow
def test_a_wide_punch_on_a_sharp_kernel():
    """150 times wider than the kernel is sharp: panels that are integrated piece by piece."""
    x, w, phi = love(-0.5, 150.0, count=1600)
    response = Love(-0.5)
    assert float(fredholm.area(response, np.array(150.0))) == pytest.approx(w @ phi, rel=1e-10)
    found = fredholm.punches(response, x[::7], np.full(x[::7].shape, 150.0))
    np.testing.assert_allclose(found, phi[::7], rtol=0, atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("strength", [3.0, -0.9])
def test_stiffness_by_two_formulas(strength):
    """d(area)/da = phi(a; a)^2, across the ends of octaves too."""
    response = Love(strength)
    a = np.geomspace(0.02, 40.0, 60)
    h = 1e-3 * a
    moved = [fredholm.area(response, a + k * h) - fredholm.area(response, a - k * h) for k in (1, 2, 3)]
    slope = (45.0 * moved[0] - 9.0 * moved[1] + moved[2]) / (60.0 * h)
    np.testing.assert_allclose(slope, fredholm.edge(response, a) ** 2, rtol=1e-10)


def test_the_triangles_give_every_right_hand_side():
    """w = (1 - R) h at the edge of every radius, then phi = (1 - R^T) w: theory of the module."""
    response, a = Love(3.0), 2.7
    x, _, phi = love(3.0, a, h=lambda x: np.cos(x) + x**2)
    nodes, weights = (
        0.5 * (part + shift) for part, shift in zip(np.polynomial.legendre.leggauss(60), (1, 0), strict=True)
    )

    def w(t):
        t = np.atleast_1d(t)[:, None]
        s = t * nodes
        rho = fredholm.resolvent(response, s, np.broadcast_to(t, s.shape)).value
        return np.cos(t[:, 0]) + t[:, 0] ** 2 - np.sum(rho * (np.cos(s) + s**2) * weights * t, axis=1)

    at = x[::40]
    t = at[:, None] + (a - at[:, None]) * nodes
    inside = fredholm.resolvent(response, np.broadcast_to(at[:, None], t.shape), t).value
    inside = np.sum(inside * w(t.ravel()).reshape(t.shape) * weights * (a - at[:, None]), axis=1)
    np.testing.assert_allclose(w(at) - inside, phi[::40], rtol=0, atol=1e-11 * np.max(np.abs(phi)))


def test_the_derivatives_of_the_resolvent():
    response = Love(-0.9)
    x, a, h = np.array([0.1, 0.9, 2.0, 6.9]), np.array([0.3, 1.1, 5.0, 7.0]), 1e-5
    pairs = fredholm.resolvent(response, x, a)

    def rho(x, a):
        return fredholm.resolvent(response, x, a).value

    np.testing.assert_allclose(pairs.across, (rho(x + h, a) - rho(x - h, a)) / (2 * h), rtol=1e-7)
    along = (rho(x * (1 + h), a * (1 + h)) - rho(x * (1 - h), a * (1 - h))) / (2 * h * a)
    np.testing.assert_allclose(pairs.along, along, rtol=1e-7)


@pytest.mark.slow
def test_results_do_not_depend_on_earlier_calls():
    response = Love(0.7)
    punch_tables._tables.cache_clear()
    before = float(fredholm.area(response, np.array(3.3)))
    punch_tables._tables.cache_clear()
    fredholm.area(response, np.geomspace(1e-4, 50.0, 30))
    assert float(fredholm.area(response, np.array(3.3))) == before
