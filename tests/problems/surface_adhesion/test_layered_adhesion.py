"""Adhesion of maps on layers: layers that are none, rings of a coated body, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.values.errors import OutsideValidity

BODY, OTHER = wk.Elastic(1.0, 0.3), wk.Elastic(2.0, 0.2)


def ball(count, side=0.16, *, periodic=False):
    x = (np.arange(count) - (count - 1) / 2) * side / count
    return wk.Topography(-0.5 * (x[:, None] ** 2 + x**2), [side, side], periodic=periodic)


@pytest.mark.parametrize("periodic", [False, True])
def test_layers_of_the_same_solid_change_nothing(periodic):
    rough, path = ball(24, periodic=periodic), wk.Depth(np.array([-1e-4, 2e-4, -3e-4]))
    same = wk.CoatedHalfSpace([wk.Layer(BODY, 0.01)], on=BODY, second=OTHER)
    plain, layered = (
        wk.SurfaceAdhesion(rough, medium, wk.ShortRange(1e-5), path).solve()
        for medium in (wk.HalfSpace(BODY, OTHER), same)
    )
    assert layered.force == pytest.approx(plain.force, rel=1e-5, abs=1e-10)
    assert layered.energy == pytest.approx(plain.energy, rel=1e-5, abs=1e-13)
    assert "layers or of a body graded in depth" in " ".join(str(note) for note in layered.validity)


def test_an_attracted_periodic_map_on_a_rigid_base_is_refused():
    film = wk.CoatedHalfSpace([wk.Layer(BODY, 0.03)], on=wk.Rigid())
    with pytest.raises(OutsideValidity, match="an even pressure compresses layers on a rigid base"):
        wk.SurfaceAdhesion(ball(24, periodic=True), film, wk.ShortRange(1e-5), wk.Depth(np.array([0.0]))).solve()


@pytest.mark.slow
def test_a_coating_weakens_the_pull_off_as_by_rings():
    """Over that of the bare body, which the range of the law on the grid raises alike; 64 pixels."""
    path = wk.Depth(np.linspace(0.0, -0.0012, 13))
    found, rings = [], []
    for young in (1.0, 4.0):
        medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, 0.3), 0.02)], on=BODY)
        found.append(wk.SurfaceAdhesion(ball(64), medium, wk.ShortRange(1e-5), path).solve().pull_off_force)
        rings.append(float(wk.PullOff(wk.Foundation(wk.Paraboloid(1.0), medium), wk.ShortRange(1e-5)).solve().force))
    assert found[1] / found[0] == pytest.approx(rings[1] / rings[0], rel=4e-2)
    assert rings[1] / rings[0] < 0.9
