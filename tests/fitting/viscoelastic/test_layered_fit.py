"""Fits of films that relax on a base: elastic limits, hereditary integrals, half-spaces, coverage of intervals."""

from __future__ import annotations

import functools

import numpy as np
import pytest
from scipy.stats import binom

import winkler as wk
from winkler.fitting.layered.response import along_path, stack_waves
from winkler.fitting.viscoelastic.drive import UNKNOWN, driven_task, examined_stroke

BALL, THICK = 10e-6, 5e-6
FILM = "bed.medium.layers[0].solid."
OWN = (f"{FILM}relaxed_shear", f"{FILM}shear", f"{FILM}relaxation_time")
FREE = (*OWN, "contact_point", "baseline")
TRUE = (1e3, 4e3, 0.8)
BASE = wk.Elastic(3e4, 0.49)


def bed(solid, *, thickness=THICK, on=BASE, radius=BALL):
    film = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(solid, thickness)], on=on)
    return wk.Foundation(wk.Paraboloid(radius), film)


def model(solid, load=wk.Depth, **more):
    return wk.ViscoelasticIndentation(bed(solid, **more), wk.Path([0.0], load(0.0)))


def elastic(shear, poisson, on):
    film = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(2.0 * (1.0 + poisson) * shear, poisson), THICK)], on=on)
    return wk.Foundation(wk.Paraboloid(BALL), film)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("on", "poisson"), [(BASE, 0.5), (wk.Elastic(500.0, 0.3), 0.4), (wk.Rigid(), 0.45)])
def test_sudden_steps_end_in_the_elastic_films_at_once_and_after_all_time(on, poisson):
    """A depth and a force that are put on at once, against the tables of elastic layers."""
    solid = wk.Prony(1e3, [1e3, 3e3], [0.3, 4.0], poisson=poisson)
    time = np.array([0.0, *np.geomspace(1e-4, 1e5, 120)])
    one = bed(solid, on=on)
    waves = stack_waves(one, 5.5e-6, 64)
    for shear, at in ((5e3, 0), (1e3, -1)):
        pressed = wk.Indentation(elastic(shear, poisson, on), wk.Depth(0.8e-6)).solve()
        held = along_path(waves, solid, time, np.full(time.size, 0.8e-6), (1.0, 0.0))
        assert held.force[at] == pytest.approx(float(pressed.force), rel=1e-3)
        assert held.radius[at] == pytest.approx(float(pressed.radius), rel=1e-2)
        load = float(wk.Indentation(elastic(shear, poisson, on), wk.Depth(0.8e-6)).solve().force)
        sunk = along_path(waves, solid, time, np.full(time.size, load), (0.0, 1.0)) if at == -1 else None
        assert sunk is None or sunk.depth[at] == pytest.approx(0.8e-6, rel=1e-3)


def held_on_glass(time, solid):
    """In for 1 s, then held; on a rigid base all relaxes as one: F = int G(t-s) dPhi(d(s)), Phi of the elastic film."""
    fine = np.linspace(0.0, float(time[-1]), 8001)
    depth = 1e-6 * np.minimum(fine, 1.0)
    phi = np.concatenate([[0.0], wk.Indentation(elastic(1.0, 0.45, wk.Rigid()), wk.Depth(depth[1:])).solve().force])
    middle, rise = 0.5 * (fine[1:] + fine[:-1]), np.diff(phi)
    relaxed, shear, tau = solid
    since = time[:, None] - middle
    modulus = np.where(since > 0.0, relaxed + shear * np.exp(-np.maximum(since, 0.0) / tau), 0.0)
    return modulus @ rise


def test_a_film_on_glass_follows_the_hereditary_integral_of_the_elastic_film():
    time = np.linspace(0.0, 4.0, 401)[1:]
    wanted = held_on_glass(time, TRUE)
    solid = wk.StandardSolid(*TRUE, poisson=0.45)
    found = along_path(
        stack_waves(bed(solid, on=wk.Rigid()), 5.5e-6, 64), solid, np.append(0.0, time),
        np.append(0.0, 1e-6 * np.minimum(time, 1.0)), (1.0, 0.0),
    )  # fmt: skip
    assert np.max(np.abs(found.force[1:] - wanted)) < 1e-3 * wanted.max()


def on_glass(seed, *, noise=0.01):
    time = np.linspace(-1.0, 5.0, 181)
    clean = held_on_glass(np.maximum(time, 0.0), TRUE)
    force = clean + 3e-11 + noise * clean.max() * np.random.default_rng(seed).standard_normal(time.size)
    return wk.ForceCurve(1e-6 * np.minimum(time, 1.0) + 4e-7, force, time=time + 1.0,
                         direction=np.where(time <= 1.0, 1.0, 0.0), name=f"seed {seed}")  # fmt: skip


@functools.cache
def clean_on_rubber():
    """Forces by the march of the problem: its own times of retardation, steps by their error, 250 cells."""
    time = np.linspace(-1.0, 5.0, 181)
    depth = 1e-6 * np.minimum(time, 1.0)
    path = wk.Path(time + 1.0, wk.Depth(depth))
    solid = wk.StandardSolid(*TRUE, poisson=0.5)
    return time, depth, wk.ViscoelasticIndentation(bed(solid), path, count=250, tolerance=1e-5).solve().force


def on_rubber(seed, *, noise=0.01):
    time, depth, clean = clean_on_rubber()
    force = clean + 3e-11 + noise * clean.max() * np.random.default_rng(seed).standard_normal(time.size)
    return wk.ForceCurve(depth + 4e-7, force, time=time + 1.0, direction=np.where(time <= 1.0, 1.0, 0.0),
                         name=f"seed {seed}")  # fmt: skip


def hits(make, start, seeds):
    inside = np.zeros(len(FREE), dtype=int)
    for seed in seeds:
        found = wk.fit(make(seed), start, free=FREE)
        ends = [found.interval(name) for name in FREE]
        inside += [low <= truth <= high for (low, high), truth in zip(ends, (*TRUE, 4e-7, 3e-11), strict=True)]
    return inside


FAR = (4e3, 4e3, 4.0)


@pytest.mark.slow
def test_a_gel_on_glass():
    """Three curves of the hereditary integral: fewer hits happen once in a thousand tests of an honest interval."""
    start = model(wk.StandardSolid(*FAR, poisson=0.45), on=wk.Rigid())
    assert np.min(hits(on_glass, start, range(3))) >= int(binom.ppf(1e-3, 3, 0.95))


@pytest.mark.long
def test_many_films_on_rubber():
    inside = hits(on_rubber, model(wk.StandardSolid(*FAR, poisson=0.5)), range(7000, 7020))
    assert np.min(inside) >= int(binom.ppf(1e-3, 20, 0.95)), inside


@pytest.mark.slow
def test_a_thick_film_is_a_half_space():
    """In, held and out on a spring of the machine: numbers and errors are those of the fit of a half-space (Ting)."""
    time = np.linspace(-0.5, 3.5, 161)
    depth = 1e-6 * np.where(time < 1.0, time, np.where(time < 2.0, 1.0, 3.0 - time))
    truth = wk.Foundation(wk.Paraboloid(BALL), wk.ViscoelasticHalfSpace(wk.StandardSolid(*TRUE)))
    force = wk.ViscoelasticIndentation(truth, wk.Path(time, wk.Depth(depth)), count=1000).solve().force
    measured = force + 5e-3 * force.max() * np.random.default_rng(5).standard_normal(time.size)
    curve = wk.ForceCurve(depth + force / 0.5, measured, 0.5, time=time,
                          direction=np.where(time <= 1.0, 1.0, np.where(time <= 2.0, 0.0, -1.0)))  # fmt: skip
    solid = wk.StandardSolid(*FAR)
    thick = model(solid, thickness=2e-3, on=wk.Elastic(15e3, 0.5))
    half = wk.Foundation(wk.Paraboloid(BALL), wk.ViscoelasticHalfSpace(solid))
    found = wk.fit(curve, thick, free=FREE)
    names = tuple(name.replace("layers[0].solid", "first") for name in FREE)
    wanted = wk.fit(curve, wk.ViscoelasticIndentation(half, wk.Path([0.0], wk.Depth(0.0))), free=names)
    assert np.all(np.abs(found.values - wanted.values) < 0.1 * wanted.standard_errors)
    assert found.standard_errors == pytest.approx(wanted.standard_errors, rel=0.03)


@functools.cache
def creeping():
    """Under a load that grows for 1 s and stays: Phi(d) = int C(t-s) dF(s), Phi of the elastic film."""
    relaxed, shear, tau = TRUE
    slow, time, load = tau * (relaxed + shear) / relaxed, np.linspace(-1.0, 6.0, 211), 2e-8

    def ramp(t):
        t = np.maximum(t, 0.0)
        return load / relaxed * (t - shear / (relaxed + shear) * slow * (1.0 - np.exp(-t / slow)))

    deep = np.linspace(0.0, 1.5e-6, 3001)
    phi = np.append(0.0, wk.Indentation(elastic(1.0, 0.45, wk.Rigid()), wk.Depth(deep[1:])).solve().force)
    depth = np.interp(ramp(time) - ramp(time - 1.0), phi, deep)
    random = np.random.default_rng(8)
    along = np.where(time < 0.0, 1e-6 * time, depth) + 2e-9 * random.standard_normal(time.size)
    force = load * np.clip(time, 0.0, 1.0) + 5e-11 + 3e-11 * random.standard_normal(time.size)
    return wk.ForceCurve(along + 4e-7, force, time=time + 1.0, direction=np.where(time <= 1.0, 1.0, 0.0))


def creeping_task(cells_up_to):
    """At the truth; the cells reach up to a power before the first prediction."""
    free = dict.fromkeys(FREE, ())
    start = model(wk.StandardSolid(*TRUE, poisson=0.45), wk.Force, on=wk.Rigid())
    task = driven_task(creeping(), start, free, np.zeros(()), examined_stroke(creeping())[0])
    task.grid.power = cells_up_to
    return task, np.array([p.inward(n) for p, n in zip(task.parameters, (*TRUE, 4e-7, 5e-11), strict=True)])


def test_cells_that_are_widened_on_the_way_change_no_prediction():
    """One of two grids moved positions by 3 % of their noise, which was taken for a curvature of the model."""
    task, at = creeping_task(UNKNOWN)
    task.predicted(at)
    enough = task.grid.power
    for narrower in range(1, 4):
        task, at = creeping_task(enough - narrower)
        first, slopes = task.predicted(at).fitted, task.slopes(at)
        assert task.grid.power == enough
        assert np.array_equal(first, task.prediction(at).fitted)
        again, at = creeping_task(enough)
        np.testing.assert_array_equal(first, again.predicted(at).fitted)
        np.testing.assert_array_equal(slopes, again.slopes(at))


@pytest.mark.slow
def test_a_film_creeps_on_glass():
    found = wk.fit(creeping(), model(wk.StandardSolid(*FAR, poisson=0.45), wk.Force, on=wk.Rigid()), free=FREE)
    assert np.all(found.stretches == 1.0)
    for name, truth in zip(OWN, TRUE, strict=True):
        low, high = found.interval(name, 0.997)
        assert low < truth < high
        assert high < 1.6 * low  # creep lasts 4 s of the 6 that are seen
    assert not found.flags


def test_other_numbers_of_the_stack_are_not_fitted():
    start = model(wk.StandardSolid(*FAR, poisson=0.45), on=wk.Rigid())
    with pytest.raises(wk.InvalidInput, match="thickness.* is free, but on viscoelastic layers"):
        wk.fit(on_glass(0), start, free=["bed.medium.layers[0].thickness"])
