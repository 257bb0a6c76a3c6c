"""Height maps that roll on layers: half-spaces of the same solid, springs of thin films, rest to steady, refusals."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.materials.depth_grading import ExponentialGrading

MU = 0.3
STEEL = wk.Elastic(210e9, 0.28)
BALL = wk.SampledProfile([0.6e-3, 0.5e-3], wk.CurvedBodies(20e-3, 10e-3), (27, 25))
CREEPS = wk.Creepage(longitudinal=[2e-4, 1e-3], lateral=[0.0, 5e-4], spin=[0.0, 1.0])


def rolled(medium, drive=CREEPS, topography=BALL, load=100.0):
    return wk.SurfaceRolling(topography, medium, wk.Force(load), wk.Coulomb(MU), drive).solve()


@pytest.mark.slow
def test_layers_of_the_same_solid_roll_as_a_half_space():
    """They too have no coupling of pressures with tractions: the other body is alike."""
    want = rolled(wk.HalfSpace.between(STEEL, STEEL))
    alike = wk.CoatedHalfSpace([wk.Layer(STEEL, 2e-5), wk.Layer(STEEL, 5e-5)], on=STEEL, second=STEEL)
    flat = wk.DepthGradedHalfSpace(ExponentialGrading(210e9, 210e9 * (1.0 + 1e-9), 1e-4, 0.28), second=STEEL)
    for medium, rel in ((alike, 1e-6), (flat, 1e-5)):
        found = rolled(medium)
        for name in ("longitudinal_force", "lateral_force", "moment", "stick_share", "depth"):
            assert getattr(found, name) == pytest.approx(getattr(want, name), rel=rel, abs=1e-6), name
    assert any("Tangential tractions on layers also displace the surface" in note.statement for note in found.validity)
    with pytest.raises(wk.OutsideValidity, match="the stress below the surface of a height map"):
        found.stresses(0.0, 0.0, 1e-4)


@pytest.mark.parametrize("creep", [1e-3, 4e-3])
def test_a_thin_film_on_a_rigid_base_rolls_as_springs(creep):
    """Springs M/h across and G/h along the surface, row by row: tractions grow by (G/h) xi dx up to mu p.

    Under an even load its displacements come in over a length of the order of its thickness, here 1/75 of a pixel.
    """
    solid, h, radius, n, a = wk.Elastic(1e9, 0.2), 5e-8, 10e-3, 61, 0.1e-3
    across, along = 1e9 * 0.8 / (1.2 * 0.6) / h, solid.shear / h
    film = wk.CoatedHalfSpace([wk.Layer(solid, h)], on=wk.Rigid())
    ball = wk.SampledProfile([2.0 * a * n / (n - 7)] * 2, wk.Paraboloid(radius), (n, n))
    x = (np.arange(n) - 0.5 * (n - 1)) * ball.pixel[0]
    pressure = np.maximum(across * (a**2 - x[:, None] ** 2 - x**2) / (2.0 * radius), 0.0)
    load = float(np.sum(pressure)) * ball.pixel[0] ** 2
    found = rolled(film, wk.Creepage(longitudinal=creep), ball, load)
    traction, one = np.zeros((n, n)), np.zeros(n)
    for row in range(n - 1, -1, -1):
        one = np.minimum(one + along * creep * ball.pixel[0], MU * pressure[row])
        traction[row] = one
    want = float(np.sum(traction)) * ball.pixel[0] ** 2
    assert found.longitudinal_force == pytest.approx(want, rel=1e-6)
    assert 0.02 < want / (MU * load) < 0.98
    assert np.max(np.abs(found.last.traction[0] - traction)) < 1e-5 * np.max(traction)


@pytest.mark.slow
def test_from_rest_to_steady_rolling_on_a_coating():
    """After two lengths of the contact the creepage that a force needs is that of steady rolling."""
    hard = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(600e9, 0.2), 2e-5)], on=STEEL, second=STEEL)
    steady = rolled(hard, wk.ShearForce(15.0))
    start = wk.SurfaceRollingStart(BALL, hard, wk.Force(100.0), wk.Coulomb(MU), wk.ShearForce(15.0), 1.2e-3).solve()
    assert start.longitudinal_creepage[-1] == pytest.approx(float(steady.longitudinal_creepage), rel=2e-2)
    plain = rolled(wk.HalfSpace.between(STEEL, STEEL), wk.ShearForce(15.0))
    assert steady.longitudinal_creepage < 0.97 * plain.longitudinal_creepage


def test_what_is_refused():
    slides = wk.SlidingFilm([wk.Layer(STEEL, 1e-6)], on=STEEL)
    gibson = wk.GradedHalfSpace.between(wk.PowerLawGraded(210e9, 1e-3, 1.0, 0.5))
    for medium, why in (
        (slides, "of a SlidingFilm that slides carries no tangential tractions"),
        (gibson, "no tangential stiffness"),
    ):
        with pytest.raises(wk.OutsideValidity, match=why):
            wk.SurfaceRolling(BALL, medium, wk.Force(100.0), wk.Coulomb(MU), CREEPS)
        with pytest.raises(wk.OutsideValidity, match=why):
            wk.SurfaceRollingStart(BALL, medium, wk.Force(100.0), wk.Coulomb(MU), wk.ShearForce(1.0), 1e-4)
