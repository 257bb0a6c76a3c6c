"""Pushes, twists and cycles on layers that relax each by a law of its own: limits, one law, inverted waves."""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from problems.layer_waves import Stack, shear_stiffness, twist_stiffness
from winkler.values.errors import InvalidInput, OutsideValidity

LAW, BALL = wk.Coulomb(0.3), wk.Paraboloid(1.0)
PART = np.array([0.0, 0.5, 1.0, -0.3])
THIN = 1.2e-2
"""Error of what is lost where annuli slip that are as thin as some twenty cells."""
CASES = {
    "push": (wk.Tangential, wk.Shift(8e-4 * PART), ("shift", "shear_force")),
    "force": (wk.Tangential, wk.ShearForce(6e-5 * PART), ("shift", "shear_force")),
    "twist": (wk.Torsion, wk.Angle(1e-2 * PART), ("angle", "torque")),
}


def solid(tau=1.0):
    return wk.StandardSolid(0.1, 0.15, tau, poisson=0.3)


def film(tau, young=1.0, thickness=0.05):
    return wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(solid(tau), thickness)], wk.Elastic(young, 0.3))


def gel(diffusivity):
    return wk.PoroelasticFilm(shear=0.1, poisson=0.3, diffusivity=diffusivity, thickness=0.05)


def solved(kind, medium, path, lateral, **more):
    return kind(wk.Foundation(BALL, medium), LAW, wk.Path(path[0], path[1], lateral), **more).solve()


def same(ours, true, names, error, places=slice(None)):
    for name in names:
        mine, its = (np.atleast_1d(getattr(one, name))[places] for one in (ours, true))
        assert mine == pytest.approx(its, abs=error * np.max(np.abs(its))), name


@pytest.mark.parametrize("case", list(CASES))
@pytest.mark.parametrize(("tau", "limit"), [(1e9, "glassy"), (1e-7, "relaxed")])
@pytest.mark.parametrize("young", [1.0, pytest.param(0.05, marks=pytest.mark.slow)])
def test_fast_and_slow_they_are_the_rings_of_elastic_layers(case, tau, limit, young):
    """Rings know no cells: bounds of all rings farther out, kernels of punches, straight pieces of the path."""
    kind, lateral, names = CASES[case]
    if case == "force" and young < 1.0:  # what less of a normal force bears
        lateral = wk.ShearForce(2.4e-5 * PART)
    medium = film(tau, young)
    path = np.arange(4.0), wk.Depth(0.01 * np.ones(4))
    ours = solved(kind, medium, path, lateral, count=200)
    true = solved(kind, getattr(medium, limit), path, lateral)
    same(ours, true, ("force", "radius", *names), 1.5e-3, slice(1, None))
    assert ours.friction_loss[1:] == pytest.approx(true.dissipation[1:], abs=THIN * true.dissipation[-1])


@pytest.mark.parametrize("case", list(CASES))
@pytest.mark.parametrize("load", [wk.Depth(0.01 * (1.0 + 0.2 * PART)), wk.Force(1e-3 * (1.0 + 0.2 * PART))])
def test_where_all_solids_are_one_springs_relax_as_cells_do(case, load):
    """The half-space is followed by springs with halved steps, which relax in stress, not in strain."""
    kind, lateral, names = CASES[case]
    layers = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(solid(), 0.05)], solid())
    path = np.arange(4.0), load
    ours = solved(kind, layers, path, lateral)
    true = solved(kind, wk.ViscoelasticHalfSpace(solid()), path, lateral)
    same(ours, true, ("depth", "force", "radius", "work", "stored_energy", "bulk_loss", *names), 1e-3)
    same(ours, true, ("friction_loss", "stick_radius"), THIN)
    left = ours.work - ours.stored_energy - ours.dissipation
    assert np.max(np.abs(left)) < 2e-4 * ours.work[-1]


def inverted(answer, age, terms=16):
    """Talbot's sum for what is answered after an age, from what is over s at rates."""
    angle = np.pi * (np.arange(1, terms) / terms)
    cot = 1.0 / np.tan(angle)
    s = 0.4 * terms / age * np.append(1.0 + 0j, angle * (cot + 1j))
    weights = np.append(0.5 + 0j, 1.0 + 1j * (angle + (angle * cot - 1.0) * cot)) * np.exp(s * age)
    return 0.4 / age * float(np.real(sum(w / one * answer(one) for w, one in zip(weights, s, strict=True))))


@pytest.mark.few(4)
@pytest.mark.parametrize("ratio", [0.3, 3.0, pytest.param(10.0, marks=pytest.mark.slow)])
@pytest.mark.parametrize("young", [2.6, 0.026])
@pytest.mark.parametrize("twisted", [False, True])
def test_a_disc_that_sticks_relaxes_as_its_inverted_stiffness(ratio, young, twisted):
    """By least energy, matrix exponentials and Talbot's sum: 10 and 1/10 of the film, which relaxes by its own law."""
    a = 0.05 * ratio
    medium = film(1.0, young)
    bed = wk.Foundation(wk.FlatPunch(a), medium)
    time = np.array([0.0, 0.3, 1.0, 5.0])
    kind, lateral = (wk.Torsion, wk.Angle(1e-6)) if twisted else (wk.Tangential, wk.Shift(1e-6))
    held = kind(bed, wk.Coulomb(1e6), wk.Path(time, wk.Depth(1e-3), lateral)).solve()
    found = held.torque / 1e-6 if twisted else held.shear_force / 1e-6
    stiffness = twist_stiffness if twisted else shear_stiffness

    def answered(s):
        shear = 0.1 + 0.15 * s / (1.0 + s)
        return stiffness(Stack([(shear, 0.3, 0.05)], (young / 2.6, 0.3), 2.0 * a), a)

    expected = [np.real(answered(1e9 + 0j)), *(inverted(answered, age) for age in time[1:])]
    assert found == pytest.approx(np.array(expected), rel=4e-3)


def test_twists_of_a_gel_do_not_move_its_liquid_but_their_bound_does():
    path, kept = np.array([0.0, 1.0, 2.0, 3.0]), wk.Depth(0.01 * np.ones(4))
    lateral = CASES["twist"][1]
    for diffusivity, limit, error in ((1e4, "relaxed", 3e-3), (1e-12, "glassy", 6e-3)):
        medium = gel(diffusivity)
        ours = solved(wk.Torsion, medium, (path, kept), lateral)
        true = solved(wk.Torsion, getattr(medium, limit), (path, kept), lateral)
        same(ours, true, ("force", "torque", "torque_limit"), error, slice(1, None))
    with pytest.raises(OutsideValidity, match="pressure and to a twist"):
        solved(wk.Tangential, gel(1.0), (path, kept), CASES["push"][1])


@pytest.mark.slow
@pytest.mark.parametrize("frequency", [0.2, 2.0])
def test_cycles_that_repeat_lose_what_those_of_springs_lose(frequency):
    layers = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(solid(), 0.05)], solid())
    beds = [wk.Foundation(BALL, medium) for medium in (layers, wk.ViscoelasticHalfSpace(solid()))]
    ours, true = (
        wk.FrictionDamping(bed, LAW, wk.Force(1e-3), wk.Shift(6e-4), frequency=frequency).solve() for bed in beds
    )
    same(ours, true, ("friction_loss", "bulk_loss", "shear_force"), 5e-3)
    ours, true = (wk.BimodalDamping(bed, LAW, 0.01, 0.003, 6e-4, 1.0, frequency=frequency).solve() for bed in beds)
    same(ours, true, ("friction_loss", "bulk_loss"), 2e-3)


@pytest.mark.slow
def test_slow_cycles_are_those_of_the_relaxed_layers_and_feel_their_base():
    bed, stiff = (wk.Foundation(BALL, film(1e-5, young)) for young in (1.0, 0.2))
    relaxed = wk.Foundation(BALL, bed.medium.relaxed)
    ours = wk.FrictionDamping(bed, LAW, wk.Depth(0.01), wk.Shift(8e-4), frequency=1.0).solve()
    true = wk.FrictionDamping(relaxed, LAW, wk.Depth(0.01), wk.Shift(8e-4)).solve()
    assert ours.friction_loss == pytest.approx(true.loss_per_cycle, rel=3e-3)
    other = wk.FrictionDamping(stiff, LAW, wk.Depth(0.01), wk.Shift(8e-4), frequency=1.0).solve()
    assert abs(other.friction_loss / ours.friction_loss - 1.0) > 0.1
    ours = wk.BimodalDamping(bed, LAW, 0.01, 0.002, 8e-4, 0.5 * np.pi, frequency=1.0).solve()
    true = wk.BimodalDamping(relaxed, LAW, 0.01, 0.002, 8e-4, 0.5 * np.pi).solve()
    assert ours.friction_loss == pytest.approx(true.loss_per_cycle, rel=3e-3)


@pytest.mark.slow
def test_twice_as_many_cells_change_less_than_half():
    path = np.arange(4.0), wk.Force(1e-3 * np.ones(4))
    rows = [
        solved(wk.Tangential, film(1.0), path, CASES["push"][1], count=count).friction_loss[-1]
        for count in (50, 100, 200)
    ]
    assert abs(rows[2] - rows[1]) < 0.6 * abs(rows[1] - rows[0])


def test_what_slides_away_is_refused_with_the_greatest_force():
    path = np.arange(2.0), wk.Force(1e-3 * np.ones(2))
    with pytest.raises(OutsideValidity, match="would slide away"):
        solved(wk.Tangential, film(1.0), path, wk.ShearForce([0.0, 4e-4]))
    with pytest.raises(InvalidInput, match="frequency"):
        wk.FrictionDamping(wk.Foundation(BALL, film(1.0)), LAW, wk.Depth(0.01), wk.Shift(1e-4))
