"""Films that relax, far thinner than the contact: what their waves add to wide cells, and what is left of them."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.media.layered.wave_constants import Wave
from winkler.numerics.integrals.quadrature import gauss_legendre

BASE, THIN = wk.Elastic(1.0, 0.3), 1e-6
FILM = wk.StandardSolid(0.2, 0.6, 1.0, poisson=0.4)


def skin(thickness=THIN, on=BASE):
    return wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(FILM, thickness)], on=on)


@pytest.mark.parametrize(("stack", "ratio"), [(skin(1.0), 20.0), (skin(1.0, wk.Elastic(1e6, 0.2)), 200.0)])
def test_cells_far_wider_than_the_film_against_panels_that_resolve_all_waves(stack, ratio):
    """int c(xi) sinc^4(xi w / 2) cos(j xi w) w^2 / pi dxi, c at once, by Gauss on steps of a turn at the last distance.

    Beyond 25 over the thickness c is that of the film alone, whose integral is 2/3 w, w/6 and 0.
    """
    count, at_once = 6, 1j * np.inf
    local = stack.waves(Wave.NORMAL, np.inf, at_once).real
    turns = 2.0 * np.pi / (2 * count * ratio)
    nodes, weights = gauss_legendre(16)
    xi = (turns * (np.arange(int(25.0 / turns))[:, None] + nodes)).ravel()
    measure = np.tile(turns * weights, xi.size // nodes.size) * ratio**2 / np.pi
    measure *= np.sinc(0.5 * xi * ratio / np.pi) ** 4 * (stack.waves(Wave.NORMAL, xi, at_once).real - local)
    wanted = np.array([np.sum(measure * np.cos(j * xi * ratio)) for j in range(2 * count)])
    wanted[:2] += local * ratio * np.array([2.0 / 3.0, 1.0 / 6.0])
    found = stack.creep_of_waves(ratio, ratio * count).kernels(count, ratio)[0]
    assert found == pytest.approx(wanted, rel=1e-7, abs=1e-9 * wanted[0])


def test_a_skin_a_hundred_thousand_times_thinner_than_the_contact_is_none():
    """F = 4/3 E* sqrt(R) d^1.5 and a = sqrt(R d) of the base, also while the skin relaxes."""
    found = wk.RelaxationTest(wk.Foundation(wk.Paraboloid(1.0), skin()), 1e-2, [1e-6, 1.0, 100.0]).solve()
    assert found.force == pytest.approx(4.0 / 3.0 / (1.0 - 0.3**2) * 1e-3, rel=1e-4)
    assert found.radius == pytest.approx(0.1, rel=1e-3)


@pytest.mark.slow
def test_the_fit_of_a_film_a_thousand_times_thinner_than_the_contact():
    """A compressible film on glass, F = pi R M(t) d^2 / h with the uniaxial modulus M; the film relaxes once."""
    ball, thick, contact, poisson = 1e-3, 1e-7, 1e-4, 0.45
    time = np.linspace(-1.0, 5.0, 181)
    depth = 0.5 * contact**2 / ball * np.minimum(time, 1.0)
    fine = np.linspace(0.0, 5.0, 5001)
    rise, middle = np.diff(np.minimum(fine, 1.0) ** 2), 0.5 * (fine[1:] + fine[:-1])
    since = np.maximum(time, 0.0)[:, None] - middle
    shear = np.where(since > 0.0, 1e3 + 4e3 * np.exp(-np.maximum(since, 0.0) / 0.8), 0.0) @ rise
    uniaxial = 2.0 * (1.0 - poisson) / (1.0 - 2.0 * poisson)
    force = np.pi * ball * uniaxial * shear * (0.5 * contact**2 / ball) ** 2 / thick
    noise = 0.01 * force.max() * np.random.default_rng(2).standard_normal(time.size)
    curve = wk.ForceCurve(depth + 4e-8, force + noise, time=time + 1.0, direction=np.where(time <= 1.0, 1.0, 0.0))
    film = wk.ViscoelasticCoatedHalfSpace(
        [wk.ViscoelasticLayer(wk.StandardSolid(4e3, 4e3, 4.0, poisson=poisson), thick)], on=wk.Elastic(70e9, 0.2)
    )
    model = wk.ViscoelasticIndentation(wk.Foundation(wk.Paraboloid(ball), film), wk.Path([0.0], wk.Depth(0.0)))
    names = [f"bed.medium.layers[0].solid.{name}" for name in ("relaxed_shear", "shear", "relaxation_time")]
    found = wk.fit(curve, model, free=[*names, "contact_point", "baseline"])
    for name, truth in zip(names, (1e3, 4e3, 0.8), strict=True):
        low, high = found.interval(name, 0.997)
        assert low < truth < high
        assert high < 1.4 * low
    assert not found.flags
