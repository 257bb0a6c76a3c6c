"""The approach of finite bodies against series of a loaded disc, and Fourier integrals and modes of a layer."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import j1

import winkler as wk

YOUNG, POISSON = 210e9, 0.3
ROLLER = wk.Elastic(YOUNG, POISSON)
RADIUS = 10e-3


def pressed(share, radius=RADIUS, poisson=POISSON):
    """A roller pressed by a rigid body of its own profile to a half-width of `share` of its radius."""
    body = wk.HalfSpace.between(wk.Elastic(YOUNG, poisson))
    return wk.LineIndentation(wk.LineFoundation(wk.Paraboloid(radius), body), wk.HalfWidth(share * radius)).solve()


def disc(share, terms, poisson):
    """What a disc of unit radius and E = 1 sinks by, to its centre, under sqrt(1 - (t/share)^2) along the axis on two
    arcs |t| < share: radial and shear tractions p_n cos(n t), t_n sin(n t), by Airy's function; over the load."""
    kappa, shear = 3.0 - 4.0 * poisson, 0.5 / (1.0 + poisson)

    def arc(m):
        return np.pi * j1(m * share) / m

    n = 2.0 * np.arange(1, terms)
    p, t = (arc(n - 1.0) + arc(n + 1.0)) / np.pi, (arc(n - 1.0) - arc(n + 1.0)) / np.pi
    b = 0.5 * (t - p) / (n + 1.0)
    a = (t / n - 0.5 * (t - p)) / (n - 1.0)
    others = (-n * a + b * (kappa - 1.0 - n)) / (2.0 * shear)
    first = -arc(1.0) / np.pi * (kappa - 1.0) / (4.0 * shear)
    return -(first + np.sum(others)) / (0.5 * np.pi * share)


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.5])
def test_a_roller_between_plates_is_a_disc_under_two_loads(poisson):
    for share, error in ((0.05, 2e-4), (0.01, 6e-6)):
        contact = pressed(share, poisson=poisson)
        exact = contact.force_per_length / YOUNG * disc(share, 400_000, poisson)
        assert contact.approach(wk.RollerCentre(RADIUS)) == pytest.approx(exact, rel=error)


def test_a_roller_has_the_closed_form_of_johnson():
    contact = pressed(1e-4)
    a, force = contact.half_width, contact.force_per_length
    closed = force * (1.0 - POISSON**2) / (np.pi * YOUNG) * (2.0 * np.log(4.0 * RADIUS / a) - 1.0)
    assert contact.approach(wk.RollerCentre(RADIUS)) == pytest.approx(closed, rel=1e-8)


def mode(s, bonded, poisson):
    """K(s) of a layer 0 < z < 1 by its four modes: u_z(0) = 2 (1 - nu^2) p/(E s) K, E = 1.

    u_x = A sin, u_z = B cos of s x, each (c + d z) exp(+-s z), after Navier; the 8 constants by least squares.
    """
    lam = poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
    mu = 0.5 / (1.0 + poisson)
    kappa = 3.0 - 4.0 * poisson

    def fields(z):
        rows = []
        for sign in (-1.0, 1.0):
            e = np.exp(sign * s * z - (s if sign > 0.0 else 0.0))
            # (u_x, u_z, du_x/dz, du_z/dz) of the two modes with this sign; divergence-free, and that with z
            rows.append(np.array([e, -sign * e, sign * s * e, -s * e]))
            ux, uz = z * e, (-sign * z + kappa / s) * e
            rows.append(np.array([ux, uz, e + sign * s * ux, -sign * e + sign * s * uz]))
        return np.array(rows).T

    def stress(z):
        ux, uz, dux, duz = fields(z)
        return (lam + 2.0 * mu) * duz + lam * s * ux, mu * (dux - s * uz)

    normal, shear = stress(0.0)
    base = fields(1.0)
    below = base[0] if bonded else stress(1.0)[1]
    constants = np.linalg.solve(np.array([normal, shear, base[1], below]), [-1.0, 0.0, 0.0, 0.0])
    return fields(0.0)[1] @ constants * s / (2.0 * (1.0 - poisson**2))


@pytest.mark.parametrize("bonded", [False, True])
@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.49])
def test_a_plate_sinks_as_the_modes_of_a_layer_say(bonded, poisson):
    share, thickness = 2e-3, 20e-3
    a = share * thickness
    contact = pressed(a / RADIUS, poisson=poisson)

    def integrand(s):
        kernel = mode(s, bonded, poisson) if s < 30.0 else 1.0
        return kernel * 2.0 * j1(s * share) / (s * share) / s

    near = quad(integrand, 1e-4, 30.0, limit=200, epsrel=1e-9)[0] + 1e-4 * integrand(1e-4)
    # beyond, K is one: the integral of 2 J1(t)/t^2 from t0 on is -ln(t0/2) - gamma + 1/2 + t0^2/16
    start = 30.0 * share
    far = -np.log(0.5 * start) - np.euler_gamma + 0.5 + start**2 / 16.0 - start**4 / 1536.0
    exact = 2.0 * contact.force_per_length * (1.0 - poisson**2) / (np.pi * YOUNG) * (near + far)
    assert contact.approach(wk.PlateBase(thickness, bonded)) == pytest.approx(exact, rel=2e-5)


def test_other_profiles_and_sticking_strips_take_finite_bodies():
    bed = wk.LineFoundation(wk.RoundedPunch(0.5e-3, 5e-3), wk.HalfSpace.between(ROLLER, ROLLER))
    contact = wk.LineIndentation(bed, wk.LineForce(1e5)).solve()
    centre = wk.RollerCentre(50e-3)
    added = contact.force_per_length * (1.0 - POISSON**2) / (np.pi * YOUNG) * centre.added(POISSON)
    both = contact.approach(50e-3, 30e-3) + added
    assert contact.approach(centre, 30e-3) == pytest.approx(both, rel=1e-13)
    stuck = wk.LineAdhesion(bed, wk.ShortRange(0.05), wk.LineForce(1e5)).solve()
    assert stuck.approach(centre, 30e-3) == pytest.approx(both, rel=1e-3)


def test_a_strip_that_is_wide_against_the_body_is_refused():
    with pytest.raises(wk.OutsideValidity, match=r"more than 0.2 of the first body's radius"):
        pressed(0.3).approach(wk.RollerCentre(RADIUS))
    with pytest.raises(wk.InvalidInput, match=r"RollerCentre\(radius\) or PlateBase"):
        pressed(0.1).approach()
    for place in ("1 mm", np.array([0.1, 0.2]), np.nan):
        with pytest.raises(wk.InvalidInput, match="no depth of its own"):
            pressed(0.1).approach(place)
    with pytest.raises(wk.InvalidInput, match="thickness"):
        wk.PlateBase(-1.0)
