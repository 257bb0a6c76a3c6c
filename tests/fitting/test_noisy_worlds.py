"""Intervals hold in worlds with slow noise, drift, tilt and drag that the model does not contain."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from harder_worlds import film_curve, harder_worlds
from noisy_worlds import LINE, PATH, worlds
from scipy.stats import binom

import winkler as wk
from winkler.fitting.compare import compare
from winkler.fitting.fit import fit

QUICK, FULL = worlds(240), worlds(600)
HARD = harder_worlds(600)
SLOW_CURVES = {"bonded film": 12, "creep with drift": 40}
"""Fewer curves where a fit takes long."""


def outcomes(world, seeds):
    """Hits ``(p,)``, and estimates less the truth in parts of the interval ``(seeds, p)``."""
    hits, off, names = [], [], list(world.truth)
    for seed in seeds:
        found = fit(world.curve(seed), world.model(), free=names)
        ends = np.array([found.interval(name) for name in names])
        truth = np.array(list(world.truth.values()))
        hits.append((ends[:, 0] <= truth) & (truth <= ends[:, 1]))
        off.append((found.values - truth) / (ends[:, 1] - ends[:, 0]))
    return np.sum(hits, axis=0), np.array(off)


@pytest.mark.slow
def test_a_few_curves_of_each_world():
    """Fewer hits than this happen once in a thousand tests of honest intervals; white ones would have two thirds."""
    seeds = range(2)
    counted = 0
    for name, world in QUICK.items():
        hits, off = outcomes(world, seeds)
        assert np.all(hits >= int(binom.ppf(1e-3, len(seeds), 0.95))), name
        assert np.all(np.abs(off) < 2.0), name
        counted += int(hits[0])
    least = int(binom.ppf(1e-3, len(QUICK) * len(seeds), 0.95))
    assert least > 0.75 * len(QUICK) * len(seeds)
    assert counted >= least


@pytest.mark.long
@pytest.mark.parametrize("name", [*FULL, *HARD])
def test_many_curves_of_a_world(name):
    """All numbers: no fewer hits than a coverage of 0.92 has once in a thousand tests, and a bias below a fifth."""
    world, count = (FULL | HARD)[name], SLOW_CURVES.get(name, 60)
    hits, off = outcomes(world, range(10_000, 10_000 + count))
    assert np.all(hits >= int(binom.ppf(1e-3, count, 0.92))), hits
    assert np.all(np.abs(np.median(off, axis=0)) < 0.2)


def test_two_triggered_curves():
    """A short baseline, a tilt that contact point and modulus nearly stand for, and points unevenly in time."""
    hits, off = outcomes(HARD["triggered, uneven"], range(2))
    assert np.all(hits >= 1)
    assert np.all(np.abs(off) < 2.0)


def test_the_film_of_the_tests():
    """Thick it is stiffer than a half-space by the series of Dimitriadis and others in chi = sqrt(R d)/h; thin, more.

    Biophys. J. 82 (2002) 2798, doi:10.1016/S0006-3495(02)75620-8
    """
    depth, force = film_curve(2.0)
    stiffening = force[1:] / (4.0 / 3.0 * depth[1:] ** 1.5)
    chi = np.sqrt(depth[1])
    assert stiffening[0] == pytest.approx(1.0 + 1.133 * chi + 1.283 * chi**2 + 0.769 * chi**3, rel=1e-3)
    assert np.all(np.diff(stiffening) > 0.0)
    assert stiffening[-1] > 2.0


def test_a_drag_and_a_drift_do_not_move_the_modulus():
    """Ten times the noise: least squares would be off by tens of its errors, and so wide that they say nothing."""
    quiet = QUICK["ball, drag"]
    found = fit(dataclasses.replace(quiet, drag=10.0, drift=10.0).curve(1), quiet.model(), free=list(quiet.truth))
    plain = fit(QUICK["ball, white"].curve(1), quiet.model(), free=list(quiet.truth))
    assert abs(found.value(PATH) - quiet.truth[PATH]) < 3.0 * found.error(PATH)
    assert found.error(PATH) < 4.0 * plain.error(PATH)
    assert not any(flag.name == "misfit" for flag in found.flags)


@pytest.mark.slow
def test_slow_noise_does_not_speak_for_another_model():
    """A ball in a world of 1/f noise, drift and tilt: the ball is likelier, or the curve cannot tell."""
    world = QUICK["everything"]
    free = [PATH, *LINE]
    cone = wk.Indentation(
        wk.Foundation(wk.Cone(half_angle=1.2), wk.HalfSpace.between(wk.Elastic(3e4, 0.5))), wk.Depth(0.0)
    )
    for seed in range(4):
        found = compare(world.curve(seed), {"ball": (world.model(), free), "cone": (cone, free)})
        assert found.models[0] == "ball" or found.evidence[1] < 20.0


def test_the_share_of_slow_noise_is_stated():
    white, slow = (fit(QUICK[name].curve(2), QUICK[name].model(), free=list(QUICK[name].truth)) for name in
                   ("ball, white", "ball, memory"))  # fmt: skip
    assert white.slow_share < 0.1 < 0.8 < slow.slow_share
    assert slow.effective_count < 60.0 < white.effective_count
