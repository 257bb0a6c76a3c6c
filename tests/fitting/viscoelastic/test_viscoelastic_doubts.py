"""Warnings of fits of bodies that relax: they come where the curve lacks information, and nowhere else."""

from __future__ import annotations

import numpy as np
import pytest
from relaxing_curves import FIRST, FREE, bed, curve, loop, model, start

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.materials.fractional import PowerLawSolid
from winkler.materials.spring_and_dashpot import StandardSolid
from winkler.materials.viscoelastic import Prony

STANDARD = [f"{FIRST}{field}" for field in ("relaxed_shear", "shear", "relaxation_time")]
ROWS = [f"{FIRST}{field}" for field in ("relaxed_shear", "shears", "relaxation_times")]
UNSURE = {"too_slow", "too_fast", "collapsed", "vanished", "span", "drag", "undetermined", "correlated", "misfit"}


def held(solid, *, lasting=10.0, count=400, noise=1e-11, seed=1):
    """Pressed in at once by 1 um, and held: F = 4/3 sqrt(R) d^(3/2) E*(t), with E* = 4 G."""
    time = np.concatenate([[0.0], np.geomspace(0.01, lasting, count - 1)])
    force = 16.0 / 3.0 * np.sqrt(5e-6) * 1e-9 * solid.relaxation(np.maximum(time, 1e-12))
    force = force + noise * np.random.default_rng(seed).standard_normal(count)
    return ForceCurve(np.full(count, 1e-6), force, time=time, direction=np.zeros(count))


def names(found):
    return {flag.name for flag in found.flags}


def outcome(one, far, free):
    """The names of the flags, or the sentence of a refusal."""
    try:
        return names(fit(one, far, free=free))
    except wk.OutsideValidity as error:
        return {str(error)}


@pytest.mark.few(1)
@pytest.mark.parametrize("kind", FREE)
@pytest.mark.parametrize("seed", [1, 2])
def test_good_curves_are_not_doubted(kind, seed):
    assert not names(fit(curve(kind, seed), start(kind), free=FREE[kind])) & UNSURE


@pytest.mark.slow
def test_a_time_longer_than_the_curve():
    found = fit(held(StandardSolid(300.0, 700.0, 40.0)), model(StandardSolid(1e3, 1e3, 1.0)), free=STANDARD)
    assert "too_slow" in names(found)
    flag = next(flag for flag in found.flags if flag.name == "too_slow")
    assert "observed for 10 s only" in flag.statement
    well = fit(held(StandardSolid(300.0, 700.0, 2.0)), model(StandardSolid(1e3, 1e3, 1.0)), free=STANDARD)
    assert not names(well) & UNSURE


def test_a_time_shorter_than_the_sampling():
    """The force falls between the first two points; a tenth of a second lies between all others."""
    time = np.linspace(0.0, 10.0, 101)
    solid = StandardSolid(300.0, 700.0, 0.03)
    force = 16.0 / 3.0 * np.sqrt(5e-6) * 1e-9 * solid.relaxation(np.maximum(time, 1e-12))
    force = force + 3e-13 * np.random.default_rng(3).standard_normal(101)
    one = ForceCurve(np.full(101, 1e-6), force, time=time, direction=np.zeros(101))
    found = fit(one, model(StandardSolid(1e3, 1e3, 0.02)), free=STANDARD)
    assert "too_fast" in names(found)


def test_terms_that_are_one():
    """Two terms where there is one: they coincide, vanish, or cannot be distinguished."""
    one = held(StandardSolid(300.0, 700.0, 1.0), noise=3e-11)
    flags = outcome(one, model(Prony(1e3, [1e3, 1e3], [0.5, 2.0])), ROWS)
    assert flags & {"collapsed", "vanished", "undetermined"} or any(
        "One term fewer may suffice" in word for word in flags
    )
    two = held(Prony(300.0, [300.0, 400.0], [0.1, 3.0]), noise=3e-12)
    assert not names(fit(two, model(Prony(1e3, [1e3, 1e3], [0.5, 2.0])), free=ROWS)) & UNSURE


@pytest.mark.slow
def test_a_series_that_does_not_reach():
    short = model(PowerLawSolid(2e3, 1.0, 0.45, shortest=0.05, longest=0.5))
    found = fit(loop(1), short, free=FREE["loop"])
    assert "span" in names(found)
    assert "misfit" in names(fit(loop(1, noise=1e-12), short, free=FREE["loop"], noise=1e-12))


def test_a_wrong_solid_does_not_explain_the_curve():
    found = fit(loop(1), model(StandardSolid(1e3, 1e3, 1.0)), free=[*STANDARD, "contact_point", "baseline"])
    assert names(found) & {"misfit", "memory"}


@pytest.mark.slow
def test_modulus_and_time_of_a_hold_that_is_too_short():
    """Of an exponential that has hardly begun only its slope is determined."""
    one = held(StandardSolid(300.0, 700.0, 200.0), lasting=10.0)
    flags = outcome(one, model(StandardSolid(1e3, 1e3, 1.0)), STANDARD)
    assert "correlated" in flags or any("not identifiable" in word for word in flags)


def test_notes_say_what_is_assumed():
    found = fit(loop(1), start("loop"), free=FREE["loop"])
    flags = " ".join(note.statement for note in found.validity)
    for words in ("Linear viscoelastic", "Baseline", "no inertia of the cantilever"):
        assert words in flags
    assert bed(start("loop").bed.medium.first).medium.span == (1e-3, 20.0)


@pytest.mark.slow
def test_a_hold_far_too_short_does_not_settle():
    """Over a two-hundredth of the relaxation time the misfit is a valley without a bottom above the noise."""
    one = held(StandardSolid(300.0, 700.0, 2000.0), count=60)
    with pytest.raises(wk.NotConverged, match="have not converged after 1000 predictions"):
        fit(one, model(StandardSolid(1e3, 1e3, 1.0)), free=STANDARD)
