"""Holds of poroelastic and viscoelastic bodies, made by formulas of the literature: which of them a pair of "
"holds tells."""

from __future__ import annotations

import numpy as np
import pytest
from biot_solution import Body, lai_hu

import winkler as wk

SHEAR, DIFFUSIVITY, DEPTH = 5e3, 1e-9, 1e-4
FEW = 12


def punches(seed, share, *, radii=(0.5e-3, 1e-3), span=(1.0, 2e4), noise=5e-3, depth_error=0.0, rows=120):
    """Holds with flat punches, F0 = 8 G a d; `share(t, a)` is the force over the first one."""
    rng = np.random.default_rng(seed)
    time = np.geomspace(*span, rows)
    holds = []
    for place, radius in enumerate(radii):
        force = 8.0 * SHEAR * radius * DEPTH * share(time, radius) * (1.0 + noise * rng.standard_normal(rows))
        holds.append(wk.HeldForce(wk.FlatPunch(radius), DEPTH * (1.0 + depth_error * (place % 2)), time, force))
    return holds


def liquid(time, radius):
    return 0.5 + 0.5 * lai_hu(DIFFUSIVITY * time / radius**2)


def solid(time, radius):
    return 0.5 + 0.5 / (1.0 + time / 300.0) ** 0.6


@pytest.mark.slow
@pytest.mark.parametrize(("share", "name", "truth"), [(liquid, "poroelastic", 2.0), (solid, "viscoelastic", 0.0)])
def test_two_holds_tell_the_kind_of_body(share, name, truth):
    scores = []
    for seed in range(FEW):
        found = wk.depth_scaling(punches(seed, share))
        assert found.verdict == name
        scores.append((found.exponent - truth) / found.error)
    assert np.mean(np.abs(scores) < 1.96) >= 0.75
    assert abs(np.mean(scores)) < 1.1  # 3.5 standard errors


def test_an_error_of_the_depth_does_not_change_the_verdict():
    assert wk.depth_scaling(punches(1, liquid, depth_error=0.05)).verdict == "poroelastic"
    assert wk.depth_scaling(punches(1, solid, depth_error=0.05)).verdict == "viscoelastic"


def test_noisy_holds_of_nearly_the_same_radius_cannot_tell():
    found = wk.depth_scaling(punches(2, liquid, radii=(1e-3, 1.08e-3), noise=0.05, span=(30.0, 300.0)))
    assert found.verdict == "cannot tell"
    low, high = found.interval(0.99)
    assert low < 0.0 < 2.0 < high


def test_times_that_grow_with_the_radius_are_of_neither():
    found = wk.depth_scaling(punches(3, lambda t, a: solid(t * (1e-3 / a), a)))
    assert found.verdict == "neither"
    assert found.exponent == pytest.approx(1.0, abs=4.0 * found.error)


def test_a_poroelastic_body_is_found_from_holds():
    found = wk.fit_poroelastic(punches(4, liquid, noise=0.0))
    assert found.shear == pytest.approx(SHEAR, rel=5e-3)
    assert found.diffusivity == pytest.approx(DIFFUSIVITY, rel=0.02)
    assert found.at_bound  # the formula is that of nu = 0
    assert found.poisson == pytest.approx(0.0, abs=0.01)


@pytest.mark.long
def test_intervals_hold_the_numbers_of_balls():
    """Forces of a ball by the dual integral equations, at nu = 0.3, with 1 % of scatter."""
    body, tau = Body(0.3, 120.0), np.geomspace(0.01, 100.0, 25)
    shares = np.array([body.shares(t, 120)["ball"] for t in tau.tolist()])
    poisson, ball = 0.3, 1e-3
    held = []
    for seed in range(80):
        rng = np.random.default_rng(seed)
        holds = []
        for depth in (2e-5, 6e-5):
            time = np.geomspace(1.0, 5e3, 100)
            share = np.interp(np.log(DIFFUSIVITY * time / (ball * depth)), np.log(tau), shares)
            first = 16.0 / 3.0 * SHEAR * depth * np.sqrt(ball * depth)
            last = first / (2.0 * (1.0 - poisson))
            force = (last + (first - last) * share) * (1.0 + 0.01 * rng.standard_normal(time.size))
            holds.append(wk.HeldForce(wk.Paraboloid(ball), depth, time, force))
        found = wk.fit_poroelastic(holds)
        truth = {"shear": SHEAR, "poisson": poisson, "diffusivity": DIFFUSIVITY}
        held.append([found.interval(name)[0] <= number <= found.interval(name)[1] for name, number in truth.items()])
        if seed < 20:
            assert wk.depth_scaling(holds).verdict == "poroelastic"
    assert np.all(np.mean(held, axis=0) >= 0.88)


@pytest.mark.parametrize(
    ("holds", "sentence"),
    [
        (lambda: punches(0, liquid)[:1], "1 hold; give at least 2"),
        (lambda: punches(0, liquid, radii=(1e-3, 1.01e-3)), "nearly the same"),
        (
            lambda: [*punches(0, liquid), wk.HeldForce(wk.Paraboloid(1e-3), 1e-5, np.arange(1.0, 9.0), np.ones(8))],
            "ball and flat",
        ),
    ],
)
def test_holds_that_tell_nothing_are_refused(holds, sentence):
    with pytest.raises(wk.InvalidInput, match=sentence):
        wk.depth_scaling(holds())


def test_rows_of_a_hold_have_one_length():
    with pytest.raises(wk.InvalidInput, match="time has 9 numbers and force 8"):
        wk.HeldForce(wk.FlatPunch(1e-3), 1e-5, np.arange(1.0, 10.0), np.ones(8))
