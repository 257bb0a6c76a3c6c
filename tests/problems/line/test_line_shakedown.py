"""Melan's limit: residual stresses by another minimisation, closed forms at the surface, layers by Airy's function."""

from __future__ import annotations

import math

import numpy as np
import pytest
from layer_waves import excesses
from scipy.optimize import minimize
from strips_of_layers import Kernel

import winkler as wk
from winkler.problems.line.shakedown import least_stress
from winkler.problems.line.stress import LineFields

STRENGTH = 1e-3
K = STRENGTH / math.sqrt(3.0)
CYLINDER = wk.Paraboloid(1.0)


def solid(share=1.0, strength=STRENGTH, poisson=0.3):
    return wk.Elastic(share * (1.0 - poisson**2), poisson, strength=strength)


def half_plane(poisson=0.3, profile=CYLINDER):
    return wk.LineFoundation(profile, wk.HalfSpace(solid(poisson=poisson)))


def coated(layers, base):
    return wk.LayeredLineFoundation(CYLINDER, wk.CoatedHalfSpace(layers, base))


def limit(bed, mu):
    return wk.LineShakedown(bed, wk.Coulomb(mu)).solve()


def left(stresses, residual):
    """The greatest von Mises stress beside residual stresses along x and y, of x, y, z and shear."""
    x, y, z = stresses[0] + residual[0], stresses[1] + residual[1], stresses[2]
    square = 0.5 * ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) + 3.0 * stresses[3] ** 2
    return math.sqrt(max(float(np.max(square)), residual[0] ** 2 - residual[0] * residual[1] + residual[1] ** 2))


def minimised(stresses):
    """The least of that, by simplices."""
    best = min(
        (minimize(lambda r: left(stresses, r), start, method="Nelder-Mead", options={"xatol": 1e-10, "fatol": 1e-12})
         for start in ((0.0, 0.0), (1.0, 1.0), (-1.0, 0.0))),
        key=lambda one: one.fun,
    )  # fmt: skip
    return float(best.fun)


@pytest.mark.few(1)
@pytest.mark.parametrize("seed", range(6))
def test_residual_stresses_leave_the_least_that_simplices_find(seed):
    rng = np.random.default_rng(seed)
    rows = rng.normal(size=(4, 40, 2)) * np.array([1.0, 1.0, 1.0, [0.2, 0.7, 1.5, 0.0, 1.0, 0.5][seed]])[:, None, None]
    least = least_stress(LineFields(np.zeros((40, 2)), np.zeros((40, 2)), *rows))
    for depth in range(2):
        assert least.level[depth] == pytest.approx(minimised(rows[:, :, depth]), rel=1e-6)
        touched = [i for i in least.touched[:, depth] if i >= 0]
        assert 1 <= len(touched) <= 3
        assert least.square[touched, depth] == pytest.approx(1.0, rel=1e-9)
        assert np.max(least.square[:, depth]) < 1.0 + 1e-9


def surface(mu, poisson):
    """sigma_x, sigma_y, sigma_z, tau_xz over p0 between the edges of a rubbed cylinder: closed forms."""
    s = np.cos(np.linspace(0.0, np.pi, 1001))
    pressure = np.sqrt(1.0 - s**2)
    along = -pressure - 2.0 * mu * s
    return along, poisson * (along - pressure), -pressure, mu * pressure


@pytest.mark.few(1)
@pytest.mark.parametrize(("mu", "poisson"), [(0.33, 0.3), (0.5, 0.3), (0.4, 0.1)])
def test_the_surface_of_a_rubbed_half_plane_limits_the_load(mu, poisson):
    found = limit(half_plane(poisson), mu)
    p0 = 4.0 / math.pi * found.mean_pressure
    assert p0 * minimised(surface(mu, poisson)) == pytest.approx(STRENGTH, rel=5e-6)
    assert p0 < 0.985 * K / mu
    assert (found.z, found.validity[-1].standing) == (0.0, wk.Standing.EXACT)


def test_rubbed_incompressible_bodies_reach_the_limit_of_the_shear():
    """sigma_x = -+2 mu p0 and sigma_y half of it leave sqrt(3) mu p0, as tau_xz = mu p0 in the middle does."""
    for mu in (0.4, 1.0):
        assert 4.0 / math.pi * limit(half_plane(0.5), mu).mean_pressure == pytest.approx(K / mu, rel=1e-9)


@pytest.mark.slow
def test_other_profiles_are_limited_by_their_surface_too():
    """As von Mises' stress of the package's surface stresses, which test_line_stress holds."""
    profile = wk.PowerLaw(1e6, 4.0)
    found = limit(half_plane(profile=profile), 0.6)
    contact = wk.LineIndentation(half_plane(profile=profile), wk.HalfWidth(found.half_width)).solve()
    x = found.half_width * np.cos(np.linspace(0.0, np.pi, 801))
    fields = contact.stresses(x, np.zeros(x.size), 0.6)
    stresses = np.array([fields.xx_stress, fields.yy_stress, fields.zz_stress, fields.xz_stress])
    assert minimised(1e3 * stresses) == pytest.approx(1e3 * STRENGTH, rel=1e-4)
    assert found.z == 0.0


# ---------------------------------------------------------------------------------------------------- layers


def airy(t, k, kind, plane=1.0, shear=1.0):
    """F, F', F'', U and W of one function of t = k z: exp(-t), t exp(-t), and those that grow towards z = 1."""
    sign, e = (-1.0, np.exp(-t)) if kind < 2 else (1.0, np.exp(t - k))
    if kind % 2 == 0:
        f = [e, sign * e, e, sign * e]
    else:
        f = [t * e, (1.0 + sign * t) * e, (2.0 * sign + t) * e, (3.0 + sign * t) * e]
    ratio = POISSON / (1.0 - POISSON)
    return [*f[:3], (f[2] + ratio * f[0]) / plane, (f[3] + ratio * f[1]) / plane - f[1] / shear]


POISSON = 0.3
SHEAR = 0.5 * (1.0 - POISSON)
"""E* = 1 of the layer, whose thickness is one."""


def of_waves(depth, k, contrast, dragged):
    """F, F' and F'' at a depth for a wave of pressure or traction of one; in the layer beside its half-plane's."""
    layer = [[airy(z * k, k, kind, 1.0, SHEAR) for kind in range(4)] for z in (0.0, 1.0)]
    base = [airy(k, k, kind, contrast, contrast * SHEAR) for kind in range(2)]
    matrix, side = np.zeros((k.size, 6, 6)), np.zeros((k.size, 6, 1))
    side[:, 1 if dragged else 0] = 1.0
    for kind in range(4):
        matrix[:, 0, kind], matrix[:, 1, kind] = layer[0][kind][:2]
        for row, name in enumerate((0, 1, 3, 4), 2):
            matrix[:, row, kind] = layer[1][kind][name]
            if kind < 2:
                matrix[:, row, 4 + kind] = -base[kind][name]
    shares = np.linalg.solve(matrix, side)[:, :, 0]
    if depth <= 1.0:
        shares[:, 0] -= 0.0 if dragged else 1.0
        shares[:, 1] -= 1.0
        kinds = {kind: kind for kind in range(4)}
    else:
        kinds = {0: 4, 1: 5}
    return [sum(shares[:, at] * airy(depth * k, k, kind)[name] for kind, at in kinds.items()) for name in range(3)]


class Passage:
    """Pressures of a strip by Erdogan and Gupta's collocation, its stresses by Flamant's loads and Airy's function."""

    def __init__(self, contrast, half_width, thickness):
        self.contrast, self.half = contrast, half_width / thickness
        count = max(120, int(60.0 * self.half))  # as close to the surface as a tenth of the layer
        angle = np.pi * np.arange(1, count + 1) / (count + 1)
        self.s, shares = self.half * np.cos(angle), self.half * np.pi * np.sin(angle) ** 2 / (count + 1)
        self.nodes = np.pi * (np.arange(1, count + 2) - 0.5) / (count + 1)
        x = self.half * np.cos(self.nodes)
        kernel = Kernel(lambda k: excesses([(SHEAR, POISSON, 1.0)], (contrast * SHEAR, POISSON), k)[0], 2.0 * self.half)
        g = np.linalg.lstsq(kernel(x, self.s) * shares, 0.5 * np.pi * thickness * x, rcond=None)[0]
        order = np.arange(1, count + 1)
        series = 2.0 / (count + 1) * np.sin(np.outer(order, angle)) @ (np.sin(angle) * g)
        self.loads, self.pressure = shares * g, np.sin(np.outer(self.nodes, order)) @ series
        edges = np.linspace(0.0, 22.0, 45 + int(8 * self.half))
        node, weight = np.polynomial.legendre.leggauss(12)
        self.k = (edges[:-1, None] + np.diff(edges)[:, None] * 0.5 * (node + 1.0)).ravel()
        self.weight = (0.5 * np.diff(edges)[:, None] * weight).ravel() / np.pi
        self.wave = self.weight * (np.cos(np.outer(self.k, self.s)) @ self.loads)

    def stresses(self, z, mu):
        """sigma_x, sigma_y, sigma_z, tau_xz of a passage at a depth over the thickness."""
        beside = self.half + (self.half + z + 2.0) * np.linspace(0.02, 2.0, 61) ** 2
        x = np.concatenate([self.half * np.cos(self.nodes), beside, -beside])
        phase = np.outer(x, self.k)
        cosine, sine = np.cos(phase), np.sin(phase)
        f, df, ddf = (self.wave * part for part in of_waves(z, self.k, self.contrast, False))
        along, across, shear = cosine @ ddf, -cosine @ f, sine @ df
        f, df, ddf = (mu * self.wave * part for part in of_waves(z, self.k, self.contrast, True))
        along, across, shear = along + sine @ ddf, across - sine @ f, shear - cosine @ df
        if z <= 1.0:
            apart = x[:, None] - self.s
            if z == 0.0:
                pulled = 2.0 / np.pi * mu * (1.0 / apart) @ self.loads
                pressure = np.append(self.pressure, np.zeros(2 * beside.size))
                along, across, shear = along - pressure - pulled, across - pressure, shear - mu * pressure
            else:
                radial = -2.0 / np.pi * (z + mu * apart) / (apart**2 + z**2) ** 2 * self.loads
                along, across = along + np.sum(radial * apart**2, axis=1), across + np.sum(radial * z**2, axis=1)
                shear = shear + np.sum(radial * apart * z, axis=1)
        return np.array([along, POISSON * (along + across), across, shear])


@pytest.mark.slow
@pytest.mark.parametrize(
    ("contrast", "thickness", "mu", "share"),
    [
        (0.1, 1.7e-2, 0.0, 0.3),
        (0.1, 2.0e-3, 0.3, 3.0),
        (0.1, 8.0e-4, 0.3, 10.0),
        (10.0, 1.3e-2, 0.2, 0.3),
        (10.0, 7.7e-4, 0.0, 3.0),
        (10.0, 8.0e-5, 0.3, 10.0),
    ],
)
def test_layers_by_another_derivation(contrast, thickness, mu, share):
    """At the limit one depth is at its strength and none beyond; the base's strength is 1.5 times the layer's."""
    layered = coated([wk.Layer(solid(), thickness)], solid(contrast, 1.5 * STRENGTH))
    found = limit(layered, mu)
    assert found.half_width / thickness == pytest.approx(share, rel=0.3)
    passage = Passage(contrast, found.half_width, thickness)
    assert np.sum(passage.loads) * thickness == pytest.approx(found.force_per_length, rel=1e-7)

    def over_strength(z):
        return minimised(passage.stresses(z, mu) / STRENGTH) / (1.0 if z <= 1.0 else 1.5)

    assert over_strength(found.z / thickness) == pytest.approx(1.0, abs=1e-3)
    within = min(1.0, 2.0 * share) * np.array([0.15, 0.4, 0.7, 1.0])
    below = 1.0 + 1e-9 + (1.0 + share) * np.array([0.0, 0.2, 0.5])
    assert max(over_strength(z) for z in (0.0, *within, *below)) < 1.0 + 1e-3


@pytest.mark.slow
@pytest.mark.parametrize("mu", [0.0, 0.2, 0.5])
def test_layers_of_one_solid_shake_down_as_a_half_plane(mu):
    """Also a ghost: the route over layers finds the limit that closed forms have, below and at the surface."""
    found = limit(coated([wk.Layer(solid(), 2e-3)], solid()), mu)
    plain = limit(half_plane(), mu)
    assert found.half_width == pytest.approx(plain.half_width, rel=3e-8)
    assert found.z == pytest.approx(plain.z, rel=1e-3)


@pytest.mark.slow
def test_the_base_is_felt_and_thin_layers_vanish():
    soft, hard = (limit(coated([wk.Layer(solid(), 1e-3)], solid(share, math.inf)), 0.0) for share in (0.1, 10.0))
    assert soft.half_width > 3.0e-3 > 2.0e-3 > hard.half_width * 0.5
    assert abs(soft.force_per_length / hard.force_per_length - 1.0) > 0.2
    plain = limit(half_plane(), 0.0).half_width
    missed = [
        limit(coated([wk.Layer(solid(2.0, math.inf), h)], solid()), 0.0).half_width / plain - 1.0 for h in (4e-4, 2e-4)
    ]
    assert abs(missed[1]) < 0.1
    assert 1.4 < missed[0] / missed[1] < 2.4


def test_what_slides_or_has_no_strength_is_refused():
    film = wk.StackedHalfSpace([wk.StackLayer(solid(), 1e-3, bonded=False)], solid())
    with pytest.raises(wk.OutsideValidity, match="slide"):
        limit(wk.LayeredLineFoundation(CYLINDER, film), 0.1)
    with pytest.raises(wk.InvalidInput, match="strength"):
        limit(coated([wk.Layer(wk.Elastic(1.0, 0.3), 1e-3)], wk.Elastic(1.0, 0.3)), 0.0)
    with pytest.raises(wk.OutsideValidity, match="sharp"):
        limit(wk.LayeredLineFoundation(wk.Cone(1.5), wk.CoatedHalfSpace([wk.Layer(solid(), 1e-3)], solid())), 0.0)
