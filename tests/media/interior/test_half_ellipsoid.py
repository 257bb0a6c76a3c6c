"""Stresses under a half-ellipsoid: point forces added up, the round contact, the cylinder, the surface."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.media.interior.half_ellipsoid import half_ellipsoid_stresses
from winkler.media.interior.half_ellipsoid_displacement import half_ellipsoid_displacements

NODES, WEIGHTS = np.polynomial.legendre.leggauss(100)


def around(place, a, b):
    """Distances to the places of the ellipse, and their loads: Gauss along the radius, trapezia around."""
    rim = np.pi * (np.arange(240) + 0.5) / 120.0
    polar = 0.25 * np.pi * (NODES[:, None] + 1.0)
    dx, dy = place[0] - a * np.sin(polar) * np.cos(rim), place[1] - b * np.sin(polar) * np.sin(rim)
    share = 0.25 * np.pi * WEIGHTS[:, None] * np.cos(polar) ** 2 * np.sin(polar) * np.pi / 120.0 * a * b
    return dx, dy, share


def line_by_line(place, a, b):
    """The same on lines along a slender ellipse, in panels."""
    eta, across = panels(np.arcsin(np.clip(place[1] / b + np.array([-1.0, -0.2, 0.0, 0.2, 1.0]), -1.0, 1.0)), 110)
    xi, along = panels(np.linspace(-0.5 * np.pi, 0.5 * np.pi, 51), 14)
    dx = place[0] - a * np.cos(eta)[:, None] * np.sin(xi)
    dy = place[1] - b * np.sin(eta)[:, None] + 0.0 * dx
    return dx, dy, a * b * (np.cos(eta) ** 3 * across)[:, None] * np.cos(xi) ** 2 * along


def panels(breaks, count):
    """Nodes and weights of Gauss between breaks, and from and to a right angle."""
    ends = np.unique(np.concatenate([[-0.5 * np.pi], breaks, [0.5 * np.pi]]))
    nodes, weights = np.polynomial.legendre.leggauss(count)
    half = 0.5 * np.diff(ends)[:, None]
    return (ends[:-1, None] + half * (nodes + 1.0)).ravel(), (half * weights).ravel()


def point_forces(place, semi_axes, poisson, traction, spread=around):
    """Boussinesq's and Cerruti's stresses added up over the ellipse."""
    dx, dy, share = spread(place, *semi_axes)
    f = 1.0 - 2.0 * poisson
    z = place[2]
    r2 = dx * dx + dy * dy
    rho = np.sqrt(r2 + z * z)

    def pressed(x, y):
        """Johnson (3.19): along x, and in the planes of x and y, and of x and z."""
        along = f / r2 * ((1.0 - z / rho) * (x * x - y * y) / r2 + z * y * y / rho**3) - 3.0 * z * x * x / rho**5
        sheared = f / r2 * ((1.0 - z / rho) * 2.0 / r2 - z / rho**3) * x * y - 3.0 * z * x * y / rho**5
        return along, sheared, -3.0 * x * z * z / rho**5

    def dragged(x, y):
        """Johnson (3.75): a force along x."""
        far = rho + z
        return (
            -3.0 * x**3 / rho**5
            + f
            * x
            * (1.0 / rho**3 - 3.0 / (rho * far**2) + x * x / (rho**3 * far**2) + 2.0 * x * x / (rho**2 * far**3)),
            -3.0 * x * y * y / rho**5
            + f
            * x
            * (1.0 / rho**3 - 1.0 / (rho * far**2) + y * y / (rho**3 * far**2) + 2.0 * y * y / (rho**2 * far**3)),
            -3.0 * x * z * z / rho**5,
            -3.0 * x * x * y / rho**5
            + f * y * (-1.0 / (rho * far**2) + x * x / (rho**3 * far**2) + 2.0 * x * x / (rho**2 * far**3)),
            -3.0 * x * x * z / rho**5,
            -3.0 * x * y * z / rho**5,
        )

    (xx, xy, xz), (yy, _, yz) = pressed(dx, dy), pressed(dy, dx)
    plain = xx, yy, -3.0 * z**3 / rho**5, xy, xz, yz
    along, across = dragged(dx, dy), dragged(dy, dx)
    turned = across[1], across[0], across[2], across[3], across[5], across[4]
    parts = (p + traction[0] * q + traction[1] * t for p, q, t in zip(plain, along, turned, strict=True))
    return [float(np.sum(part * share)) / (2.0 * np.pi) for part in parts]


@pytest.mark.parametrize("semi_axes", [(1.0, 1.0), (1.0, 0.999), (2.0, 1.0), (1.0, 4.0)])
@pytest.mark.parametrize("traction", [(0.0, 0.0), (0.3, -0.4)])
def test_point_forces_add_up(semi_axes, traction):
    a, b = semi_axes
    poisson = 0.3 if a == b else 0.1
    places = [(0.3 * a, 0.4 * b, 0.5), (-0.7 * a, -0.9 * b, 0.6), (1.3 * a, 0.1 * b, 0.7), (0.0, -2.0 * b, 1.1)]
    found = np.array(half_ellipsoid_stresses(*np.array(places).T, semi_axes, poisson, traction)).T
    expected = [point_forces(place, semi_axes, poisson, traction) for place in places]
    assert found == pytest.approx(np.array(expected), abs=1e-9)


@pytest.mark.parametrize("semi_axes", [(1.0, 1.0), (1.0, 0.999), (2.0, 1.0), (1.0, 4.0)])
def test_displacements_of_point_forces_add_up(semi_axes):
    (a, b), f, mu = semi_axes, 0.4, (0.3, -0.4)
    for place in [(0.3 * a, 0.4 * b, 0.5), (-0.7 * a, -0.9 * b, 0.6), (1.3 * a, 0.1 * b, 0.7)]:
        x, y, share = around(place, a, b)
        z, r = place[2], np.sqrt(x * x + y * y + place[2] ** 2)
        straight, mixed, down = f / (r + z), 1.0 / r**3 - f / (r * (r + z) ** 2), z / r**3 + f / (r * (r + z))
        parts = (  # Johnson (3.18) and (3.75)
            x * (z / r**3 - f / (r * (r + z))) + mu[0] * (1.0 / r + straight + x * x * mixed) + mu[1] * x * y * mixed,
            y * (z / r**3 - f / (r * (r + z))) + mu[1] * (1.0 / r + straight + y * y * mixed) + mu[0] * x * y * mixed,
            z * z / r**3 + (1.0 + f) / r + (mu[0] * x + mu[1] * y) * down,
        )
        expected = [float(np.sum(part * share)) / (2.0 * np.pi) for part in parts]
        found = half_ellipsoid_displacements(*np.array(place)[:, None], semi_axes, 0.3, mu)
        assert np.array(found)[:, 0] == pytest.approx(expected, abs=1e-10)


@pytest.mark.parametrize("place", [(0.4, 0.02, 0.02), (0.4, -0.05, 0.03), (0.0, 0.0, 0.05)])
def test_slender_ellipse(place):
    """1 : 30, close to the surface."""
    expected = point_forces(place, (1.0, 1.0 / 30.0), 0.3, (0.2, 0.3), line_by_line)
    found = half_ellipsoid_stresses(*np.array(place)[:, None], (1.0, 1.0 / 30.0), 0.3, (0.2, 0.3))
    assert np.array(found)[:, 0] == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("friction", [0.0, 0.35])
def test_round_contact(friction):
    """Of equal semi-axes the stresses are those restored from the springs of a ball, pressed and dragged along x."""
    steel = wk.Elastic(210e9, 0.3)
    bed = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace.between(steel, wk.Rigid()))
    ball = wk.Indentation(bed, wk.Radius(1e-4)).solve()
    x, y, z = 1e-4 * np.array([[0.3, -0.8, 1.2, 0.0], [0.2, 0.5, -0.4, 0.6], [0.1, 0.0, 0.5, 1.5]])
    path = wk.Path([0.0, 1.0], wk.Force(ball.force), wk.Shift([0.0, 1e-3]))
    slid = wk.Tangential(bed, wk.Coulomb(friction or 0.1), path).solve()
    peak = 1.5 * ball.force / (np.pi * ball.radius**2)
    found = half_ellipsoid_stresses(x, y, z, (1e-4, 1e-4), 0.3, (friction, 0.0))
    fields = wk.restore_body(slid.at(-1) if friction else ball, x, y, z)
    for name, ours in found._asdict().items():
        assert peak * ours == pytest.approx(getattr(fields, f"{name}_stress"), abs=1e-8 * peak)


def test_cylinder():
    """Long ellipses tend to McEwen's cylinder, dragged across: the difference in the plane falls as (b/a)^2."""
    bed = wk.LineFoundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.3)))
    roller = wk.LineIndentation(bed, wk.HalfWidth(1.0)).solve()
    x, z = (part.ravel() for part in np.meshgrid(np.linspace(-2.0, 2.0, 9), [0.0, 0.1, 0.8, 2.0]))
    expected = roller.stresses(x, z, 0.3)
    away = []
    for length in (1e3, 1e5):
        found = half_ellipsoid_stresses(x, 0.0 * x, z, (1.0, length), 0.3, (0.3, 0.0))
        pairs = ((found.zz, expected.zz_stress), (found.xz, expected.xz_stress))
        away.append(max(float(np.max(np.abs(roller.peak_pressure * p - q))) for p, q in pairs) / roller.peak_pressure)
        assert found.xx * roller.peak_pressure == pytest.approx(expected.xx_stress, abs=0.5 / length)
        assert found.yy * roller.peak_pressure == pytest.approx(expected.yy_stress, abs=0.5 / length)
    assert away[0] < 2e-6
    assert away[1] < 1e-9


@pytest.mark.parametrize("ratio", [1.0, 0.3, 1e-3, 1e-8])
def test_surface(ratio):
    """Pressure and traction are what was prescribed; the edge, the foci and far places are finite, and continuous."""
    focus = np.sqrt(1.0 - ratio**2)
    x = np.array([0.0, 1.0, 0.0, focus, 0.5 * focus, 0.6, 2.0, 0.0, 0.5, 1e5])
    y = ratio * np.array([0.0, 0.0, 1.0, 0.0, 0.0, 0.8, 0.0, 3.0, 0.6, 2.0])
    pressure = np.sqrt(np.maximum(1.0 - x * x - (y / ratio) ** 2, 0.0))
    on = half_ellipsoid_stresses(x, y, 0.0 * x, (1.0, ratio), 0.3, (0.2, -0.1))
    assert np.isfinite(np.array(on)).all()
    for part, share in ((on.zz, -1.0), (on.xz, -0.2), (on.yz, 0.1)):
        assert part == pytest.approx(share * pressure, abs=2e-8)
    below = half_ellipsoid_stresses(x, y, np.full(x.shape, 1e-12 * ratio), (1.0, ratio), 0.3, (0.2, -0.1))
    assert np.array(below) == pytest.approx(np.array(on), abs=3e-6)


def test_continuous_in_the_ratio_of_axes():
    """From the circle to 1 : 1000 no number of nodes shows."""
    ratio = np.geomspace(1e-3, 1.0, 25)
    for one in ratio:
        pair = [
            np.array(half_ellipsoid_stresses(*np.array([[0.4], [0.3 * r], [0.5 * r]]), (1.0, r), 0.3, (0.2, 0.3)))
            for r in (one, one * (1.0 - 1e-7))
        ]
        assert pair[0] == pytest.approx(pair[1], abs=3e-7)
