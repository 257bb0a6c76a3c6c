"""The free points give the baseline of creep and relaxation alike, in the same fit; intervals hold the truth."""

from __future__ import annotations

import dataclasses
import re

import numpy as np
import pytest
from relaxing_curves import FIRST, FREE, TRUE, loop, ramp_and_hold, start
from scipy.stats import binom

from winkler.fitting.fit import fit

LINE = ("contact_point", "baseline", "tilt")
NAMES = (*FREE["creep"], *LINE)
TRUTH = (*TRUE["creep"], 4e-7, 5e-11, 2e-5)
SHEAR = f"{FIRST}relaxed_shear"


def held_on_a_slope(seed):
    one = loop(seed, held=True)
    return dataclasses.replace(one, force=one.force + 2e-5 * (one.position - 4e-7))


def deviations(curves, begin, names, truth):
    found = [fit(one, begin, free=names) for one in curves]
    errors = np.array([[one.error(name) for name in names] for one in found])
    inside = [[a <= t <= b for (a, b), t in zip(map(one.interval, names), truth, strict=True)] for one in found]
    return found, (np.array([one.values for one in found]) - truth) / errors, np.sum(inside, axis=0)


@pytest.mark.slow
def test_creep_with_a_baseline_on_a_slope():
    """Offset and tilt of 5 % and 2 % of the load; fewer hits than this happen once in a thousand honest tests."""
    found, off, inside = deviations(map(ramp_and_hold, range(8)), start("creep"), NAMES, TRUTH)
    assert np.min(inside) >= int(binom.ppf(1e-3, 8, 0.95)), inside
    assert np.all(np.abs(off.mean(axis=0)) < 3.3 / np.sqrt(8.0)), off.mean(axis=0)
    free = (
        134  # points of 10 pN before first touch: if it were known to be white, they tell a line's end to 2 / sqrt(n)
    )
    errors = np.array([one.error("baseline") for one in found])
    assert np.all(errors > 0.8 * 2.0 * 1e-11 / np.sqrt(free))
    assert np.max(errors) < 2.0 * 2.0 * 1e-11 / np.sqrt(free)
    assert not any(flag.name in ("misfit", "memory", "at_bound") for one in found for flag in one.flags)


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("scatter", [2e-10, 1e-8])
def test_creep_whatever_the_noise_of_the_position(scatter):
    """Noise of a force that drives is in the derivatives too; least squares alone are off by three errors at 0.2 nm."""
    curves = (ramp_and_hold(seed, scatter=scatter) for seed in range(100, 108))
    _, off, _ = deviations(curves, start("creep"), NAMES, TRUTH)
    assert np.all(np.abs(off.mean(axis=0)) < 3.3 * 1.35 / np.sqrt(8.0)), off.mean(axis=0)


@pytest.mark.slow
def test_a_line_that_is_subtracted_first_changes_nothing():
    one = ramp_and_hold(3)
    flat = dataclasses.replace(one, force=one.force - 5e-11 - 2e-5 * (one.position - 4e-7))
    free, known = fit(one, start("creep"), free=NAMES), fit(flat, start("creep"), free=NAMES[:4])
    assert abs(free.value(SHEAR) - known.value(SHEAR)) < 2.0 * free.error(SHEAR)


@pytest.mark.slow
def test_a_fixed_baseline_is_noted():
    """Before, the points that say so had no weight, and the modulus was 2 % and seven errors off without a word."""
    found = fit(ramp_and_hold(0, tilt=0.0), start("creep"), free=NAMES[:4])
    assert "misfit" in {flag.name for flag in found.flags}


def test_what_is_stated_about_creep_holds_along_the_whole_curve():
    """Depths are below zero before first touch, residuals those of the noise, and no point is left out."""
    one = ramp_and_hold(5, tilt=0.0)
    found = fit(one, start("creep"), free=NAMES[:5])
    before = one.time < 0.98
    assert found.count == one.count
    assert np.all(found.depth[before] < 0.0)
    assert not found.radius[before].any()
    statements = [note.statement for note in found.validity if note.statement.startswith("Baseline")]
    assert len(statements) == 1
    assert re.search(r"on approach; the scatter is 0\.0(08|09|1)\d* of the force range. This is enough", statements[0])
    assert np.std(found.residuals[before]) == pytest.approx(found.noise, rel=0.3)


@pytest.mark.slow
def test_relaxation_with_a_baseline_on_a_slope():
    truth = (*TRUE["relaxation"], 2e-5)
    names = (*FREE["relaxation"], "tilt")
    _, off, inside = deviations(map(held_on_a_slope, range(6)), start("relaxation"), names, truth)
    assert np.min(inside) >= int(binom.ppf(1e-3, 6, 0.95)), off
