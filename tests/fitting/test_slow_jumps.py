"""A pull-off that takes time leaves the fit; the baseline is that of the free points; few points may be a misfit."""

from __future__ import annotations

import functools

import numpy as np
import pytest
from synthetic import jkr

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.elastic.contact import DirectionRun
from winkler.fitting.elastic.slow_jumps import beside_jumps
from winkler.fitting.fit import fit
from winkler.fitting.misfit import misfit_of

RADIUS, YOUNG, WORK, SPRING, NOISE = 7.5e-6, 1.0e6, 18e-3, 3.0, 0.5e-9
MODULUS = YOUNG / 0.75
NAMES = ("bed.medium.first.young", "law.work", "contact_point", "baseline")


def retraction(arch, peel, points=20.0, seed=1):
    """JKR's pull-off of a bead with an arch in contact, and a tension that fades over some points."""
    stage = np.linspace(1.4e-6, -1.6e-6, 1000)
    force = jkr(stage, np.zeros(1000, dtype=bool), MODULUS, RADIUS, WORK, SPRING)
    last = int(np.flatnonzero(np.abs(force) > 1e-12)[-1])
    clean = force.copy()
    if peel:
        clean[last + 1 :] += force[last] * np.exp(-np.arange(1, 1000 - last) / points)
    clean[: last + 1] += arch * np.sin(np.pi * np.arange(last + 1) / last)
    return ForceCurve(
        stage + 2e-6, clean + NOISE * np.random.default_rng(seed).standard_normal(1000), machine_stiffness=SPRING
    )


@functools.cache
def fitted(arch, peel, points=20.0):
    bed = wk.Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace.between(wk.Elastic(2e6, 0.5)))
    model = wk.AdhesiveIndentation(bed, wk.ShortRange(20e-3), wk.Depth(0.0))
    return fit(retraction(arch, peel, points), model, free=NAMES)


@pytest.mark.slow
def test_a_slow_pull_off_does_not_rule_the_fit():
    """Work 3.45 [2.26, 5.27] for 18 mJ/m^2, E 1.23 [1.09, 1.39] for 1 MPa, baseline -220 nN for 0, no misfit."""
    found = fitted(20e-9, True)
    for name, truth in zip(NAMES, (YOUNG, WORK, 2e-6, 0.0), strict=True):
        low, high = found.interval(name)
        assert low < truth < high, name
    assert found.value("law.work") == pytest.approx(WORK, rel=0.03)
    assert found.value(NAMES[0]) == pytest.approx(YOUNG, rel=0.03)
    assert abs(found.value("baseline")) < 2.0 * NOISE
    assert found.error("baseline") < 4.0 * NOISE
    names = [flag.name for flag in found.flags]
    assert "jump" in names
    assert "misfit" in names  # of the arch, 40 times the noise


@pytest.mark.slow
def test_a_slow_pull_off_alone_is_no_misfit():
    """Without the arch the rest of the curve is that of the model, to the noise."""
    found = fitted(0.0, True)
    assert [flag.name for flag in found.flags] == ["jump"]
    assert found.value("law.work") == pytest.approx(WORK, rel=2e-3)
    assert found.value(NAMES[0]) == pytest.approx(YOUNG, rel=2e-3)
    assert abs(found.value("baseline")) < 3.0 * found.error("baseline") < 3.0 * NOISE


@pytest.mark.slow
def test_a_sudden_pull_off_keeps_all_points():
    found = fitted(0.0, False)
    assert found.curve.count == 1000
    assert not found.flags


@pytest.mark.slow
def test_what_the_model_misses_in_contact_does_not_move_the_baseline():
    """An arch of 60 times the noise: the 420 free points know their zero to 0.02 nN."""
    found = fitted(30e-9, False)
    assert found.curve.count > 990
    assert abs(found.value("baseline")) < 0.3 * NOISE
    assert "misfit" in [flag.name for flag in found.flags]
    assert found.chi_square > 50.0  # by the noise, not by what is missed


@pytest.mark.parametrize("inward", [False, True])
def test_points_of_a_jump_are_found_on_both_ways(inward):
    """A tension of 400 times the noise fades as exp(-k/10): it is above four times the noise for 46 points."""
    random = np.random.default_rng(4)
    residuals, touched = random.standard_normal(600), np.arange(600) < 200
    tail = 400.0 * np.exp(-np.arange(1, 401) / 10.0)
    for size, least, most in ((0.0, 0, 1), (1.0, 46, 80)):
        moved = residuals.copy()
        moved[200:] -= size * tail
        order = slice(None, None, -1 if inward else 1)
        runs = (DirectionRun(0, 600, inward, np.inf),)
        kept = beside_jumps(moved[order], touched[order], runs)[order]
        out = np.flatnonzero(~kept)
        assert least <= out.size <= most
        assert out.size == 0 or (out[0] == 200 and out[-1] == 199 + out.size)
        assert out.size == 0 or size * tail[out.size] < 1.0  # what is left of it is less than the noise


def test_few_points_far_above_the_noise_are_a_misfit():
    """Twelve of 4,000 points at 12 times the noise: 0.4 of chi-square, both limits kept."""
    random = np.random.default_rng(3)
    touched, counted = np.arange(4000) >= 2000, np.ones(4000, dtype=bool)
    residuals = random.standard_normal(4000)
    right = misfit_of(residuals, touched, counted, (3996.0, 1997.0), 1.0)
    assert right.explained
    assert right.local < 4.0
    residuals[3000:3012] += 12.0
    wrong = misfit_of(residuals, touched, counted, (3996.0, 1997.0), 1.0)
    assert wrong.on_the_whole
    assert not wrong.explained
    assert 3000 <= wrong.place < 3012
    assert wrong.local == pytest.approx(1.4826 * 12.0, rel=0.1)
