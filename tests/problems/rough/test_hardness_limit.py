"""The plastic limit of a pressed height map: F = H A, whatever the surface and the moduli."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk

SPECTRUM = wk.SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=1e-4)


def rough(seed, *, periodic):
    return wk.RandomTopography([1e-3, 1e-3], SPECTRUM, (48, 48), seed=seed, periodic=periodic)


@pytest.mark.parametrize("periodic", [True, False])
@pytest.mark.parametrize("young", [210e9, 2e12])
def test_a_soft_surface_touches_on_force_over_hardness(periodic, young):
    hardness, forces = 3e7, np.array([0.3, 1.0, 3.0])
    contact = wk.SurfaceContact(
        rough(5, periodic=periodic), wk.HalfSpace(wk.Elastic(young, 0.3)), wk.Force(forces), hardness=hardness
    )
    found = contact.solve()
    pixel = 1e-6 / 48**2
    assert np.all(np.asarray(found.area) >= forces / hardness * (1.0 - 1e-12))
    assert np.all(np.asarray(found.area) - forces / hardness <= 3.0 * pixel + 0.06 * forces / hardness)
    assert found.mean_pressure[-1] == pytest.approx(hardness, rel=0.06)
    assert found.hardened_share[-1] > 0.85
    assert np.max(found.last.pressure) == pytest.approx(hardness, rel=1e-9)


def test_the_limit_is_stated():
    steel = wk.HalfSpace(wk.Elastic(210e9, 0.3))
    said = {
        hardness: " ".join(
            note.statement
            for note in wk.SurfaceContact(rough(1, periodic=True), steel, wk.Force(1.0), hardness=hardness)
            .solve()
            .validity
        )
        for hardness in (2e7, 5e8, 1e12)
    }
    assert "the plastic limit A = F / H" in said[2e7]
    assert "between the elastic contact and the plastic limit" in said[5e8]
    assert "elastic for the most part" in said[1e12]
    heavy = wk.SurfaceContact(rough(1, periodic=True), steel, wk.Force(10.0), hardness=2e7).solve()
    outside = [note for note in heavy.validity if note.standing is wk.Standing.OUTSIDE]
    assert any("Displaced metal reduces" in note.statement for note in outside)
    elastic = wk.SurfaceContact(rough(1, periodic=True), steel, wk.Force(1.0)).solve()
    assert elastic.hardened_share == 0.0
    assert "hardness" not in " ".join(note.statement for note in elastic.validity)


def test_a_hardness_that_is_not_reached_changes_nothing():
    contact = wk.SurfaceContact(rough(2, periodic=True), wk.HalfSpace(wk.Elastic(210e9, 0.3)), wk.Force(5.0))
    elastic = contact.solve()
    peak = float(np.max(elastic.last.pressure))
    hard = wk.SurfaceContact(contact.topography, contact.medium, contact.load, hardness=2.0 * peak).solve()
    assert hard.area == elastic.area
    assert hard.hardened_share == 0.0
    assert hard.depth == pytest.approx(elastic.depth, rel=1e-5)
