"""What relaxing bodies answer to waves at Laplace's s, against matrix exponentials through the depth with G(s)."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import expm, null_space

import winkler as wk
from winkler.media.layered.wave_constants import Wave
from winkler.values.errors import OutsideValidity

FILM = wk.StandardSolid(relaxed_shear=0.2, shear=1.8, relaxation_time=0.7, poisson=0.4)
BASE = wk.Prony(1.0, [2.0, 0.5], [0.1, 3.0], poisson=0.25)
BALL = wk.StandardSolid(relaxed_shear=3.0, shear=1.0, relaxation_time=5.0, poisson=0.3)
STEEL = wk.Elastic(7.0, 0.3)


def modulus(solid, s):
    """Return G(s) of the sums of exponentials above, or of an elastic solid."""
    if isinstance(solid, wk.Elastic):
        return solid.young / (2.0 * (1.0 + solid.poisson))
    if isinstance(solid, wk.StandardSolid):
        return solid.relaxed_shear + solid.shear * s * solid.relaxation_time / (1.0 + s * solid.relaxation_time)
    turns = s * np.array(solid.relaxation_times)
    return solid.relaxed_shear + np.sum(np.array(solid.shears) * turns / (1.0 + turns))


def rates(shear, poisson, k):
    """Return d/dz of (U sin kx, W cos kx, tau sin kx, sigma cos kx), by Hooke and equilibrium."""
    lame = 2.0 * shear * poisson / (1.0 - 2.0 * poisson)
    stiff = lame + 2.0 * shear
    a = np.zeros((4, 4), dtype=complex)
    a[0] = 0.0, k, 1.0 / shear, 0.0
    a[1] = -lame * k / stiff, 0.0, 0.0, 1.0 / stiff
    a[2] = k * (stiff * np.array([k, 0.0, 0.0, 0.0]) + lame * a[1])
    a[3, 2] = -k
    return a


def known(layers, on, s, k):
    """Return the compliances times k / 2 of the surface z = 0: (normal, along, coupling, across)."""
    if on is None:
        states, twisted = np.eye(4)[:, 2:].astype(complex), np.array([0.0, 1.0])
    else:
        shear = modulus(on, s)
        deep = rates(shear, on.poisson, k) / k + np.eye(4)  # what dies out solves (A + k)^2 = 0
        scale = np.diag([1.0, 1.0, shear * k, shear * k])
        states, twisted = scale @ null_space(np.linalg.inv(scale) @ deep @ deep @ scale, rcond=1e-7), [1.0, -shear * k]
    for solid, thickness in reversed(layers):
        shear = modulus(solid, s)
        states = expm(-rates(shear, solid.poisson, k) * thickness) @ states
        across = np.array([[0.0, 1.0 / shear], [shear * k * k, 0.0]])
        twisted = expm(-across * thickness) @ twisted
    moved = states[:2] @ np.linalg.inv(states[2:])
    return -0.5 * k * np.array([moved[1, 1], moved[0, 0], -moved[1, 0], twisted[0] / twisted[1]])


MEDIA = {
    "film on a relaxing base": (
        wk.ViscoelasticCoatedHalfSpace(
            [wk.ViscoelasticLayer(FILM, 0.3), wk.Layer(STEEL, 0.1)], on=BASE, second=BALL
        ),
        [(FILM, 0.3), (STEEL, 0.1)], BASE, BALL,
    ),
    "film on a rigid base": (
        wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(FILM, 0.3)], on=wk.Rigid(), second=STEEL),
        [(FILM, 0.3)], None, STEEL,
    ),
    "half-spaces": (wk.ViscoelasticHalfSpace(BASE, BALL), [], BASE, BALL),
    "in proportion": (
        wk.RelaxingInProportion(
            wk.CoatedHalfSpace([wk.Layer(wk.Elastic(2.0 * 1.4 * 5.0, 0.4), 0.3)], on=wk.Rigid()), FILM, shear=5.0
        ),
        [(FILM, 0.3)], None, None,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", MEDIA)
def test_waves_are_those_of_elastic_layers_with_the_modulus_at_s(name):
    medium, layers, on, second = MEDIA[name]
    for s in (0.3, 2.0 + 1.0j, 4.0j):
        for k in (0.05, 1.0, 8.0):
            first = known(layers, on, s, k)
            other = known([], second, s, k) if second else np.zeros(4)
            for part, sign, one, two in zip(
                (Wave.NORMAL, Wave.ALONG, Wave.COUPLING, Wave.ACROSS), (1.0, 1.0, -1.0, 1.0), first, other, strict=True
            ):
                found = medium.waves(part, np.array([k]), np.array([s]))[0]
                assert found == pytest.approx(one + sign * two, rel=1e-7), (part, s, k)


def test_waves_and_rates_are_broadcast_and_the_shortest_waves_after_a_step_feel_the_glassy_surface():
    medium = MEDIA["film on a relaxing base"][0]
    k, s = np.array([0.1, 1.0, 3.0]), 1j * np.array([0.2, 5.0])
    whole = medium.waves(Wave.NORMAL, k, s[:, None])
    for i, rate in enumerate(s):
        assert whole[i] == pytest.approx(medium.waves(Wave.NORMAL, k, np.full(3, rate)), rel=1e-14)
    sudden = medium.waves(Wave.NORMAL, np.array([np.inf]), np.array([1j * np.inf]))[0]
    assert sudden == pytest.approx(0.5 * (1.0 - 0.4) / 2.0 + 0.5 * (1.0 - 0.3) / 4.0, rel=1e-14)


def test_what_waves_are_not_known_of():
    film = wk.PoroelasticFilm(shear=1.0, poisson=0.2, diffusivity=1.0, thickness=0.1)
    with pytest.raises(OutsideValidity, match="the response of its surface to tangential forces"):
        film.waves(Wave.ALONG, np.ones(1), np.ones(1))
    soil = wk.GradedHalfSpace.between(wk.PowerLawGraded(1e6, 1.0, 0.3, poisson=0.3))
    with pytest.raises(OutsideValidity, match="for a power law of depth no half-space represents the surface"):
        wk.RelaxingInProportion(soil, FILM, shear=1.0).waves(Wave.NORMAL, np.ones(1), np.ones(1))
