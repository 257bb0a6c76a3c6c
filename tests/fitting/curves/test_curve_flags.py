"""Flags of fits that the curve alone does not show: nothing out of contact, and pop-ins in the fitted loading."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest
from event_worlds import AfmWorld
from synthetic import hertz, there_and_back

import winkler as wk
from winkler.fitting.curves.checks import examined
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.fitting.flag_meanings import FLAG_MEANINGS

PATH = "bed.medium.first.young"
FREE = [PATH, "contact_point", "baseline"]


def elastic() -> wk.Indentation:
    bed = wk.Foundation(wk.Paraboloid(5e-6), wk.HalfSpace.between(wk.Elastic(3e4, 0.5)))
    return wk.Indentation(bed, wk.Depth(0.0))


def names(curve: ForceCurve) -> list[str]:
    return [flag.name for flag in fit(curve, elastic(), free=FREE).flags]


@pytest.mark.parametrize("begin", [0.0, 0.2e-6])
@pytest.mark.parametrize("both", [False, True])
def test_a_curve_wholly_in_contact_has_no_baseline(begin, both):
    """Under noise of 1 % its beginning looks like a tilted baseline, which only the fit tells from a contact."""
    depth = np.linspace(begin, begin + 1e-6, 300)
    depth = np.concatenate([depth, depth[::-1]]) if both else depth
    force = hertz(depth, 1.33e4, 5e-6)
    force += 0.01 * force.max() * np.random.default_rng(1).standard_normal(depth.size)
    curve = ForceCurve(depth, force)
    assert "no_baseline" not in [flag.name for flag in examined(curve)]
    assert names(curve).count("no_baseline") == 1


@pytest.mark.parametrize(("begin", "level"), [(0.05e-6, 0.01), (0.2e-6, 0.03), (0.5e-6, 0.01)])
def test_a_free_tilt_does_not_hide_that_a_curve_is_wholly_in_contact(begin, level):
    """The foot of the contact is taken for a tilted baseline: the modulus is a third to a half too low."""
    depth = np.linspace(begin, begin + 1e-6, 300)
    force = hertz(depth, 1.33e4, 5e-6)
    force += level * force.max() * np.random.default_rng(0).standard_normal(depth.size)
    found = fit(ForceCurve(depth, force), elastic(), free=[*FREE, "tilt"])
    assert np.count_nonzero(~found.touched) > 30
    assert found.value(PATH) < 0.8e4
    assert [flag.name for flag in found.flags].count("no_baseline") == 1


@pytest.mark.parametrize(("begin", "level"), [(-1e-6, 0.03), (-0.4e-6, 0.02), (-0.2e-6, 5e-3)])
def test_a_seen_baseline_is_no_doubt(begin, level):
    depth = np.linspace(begin, 1e-6, 300)
    force = hertz(depth, 1.33e4, 5e-6)
    force += force.max() * (level * np.random.default_rng(1).standard_normal(depth.size) + 0.05 * depth / 1e-6)
    found = fit(ForceCurve(depth, force), elastic(), free=[*FREE, "tilt"])
    assert "no_baseline" not in [flag.name for flag in found.flags]


def test_a_retraction_that_stays_in_contact_has_no_baseline():
    position, _ = there_and_back(-1e-6, 1e-6, 300)
    force = hertz(position, 1.33e4, 5e-6) + 1e-11 * np.random.default_rng(2).standard_normal(position.size)
    curve = ForceCurve(position, force)
    assert names(curve) == []
    assert names(curve.chosen((curve.direction > 0.0) | (curve.position > 0.2e-6))) == ["no_baseline"]


def world(**changes) -> AfmWorld:
    return AfmWorld(count=300, slow=0.0, **changes)


def rigid(made: tuple[ForceCurve, int]) -> tuple[ForceCurve, int]:
    """Return the curve of a stiff machine: its positions are depths."""
    return dataclasses.replace(made[0], machine_stiffness=math.inf), made[1]


@pytest.mark.few(3)
@pytest.mark.parametrize("hold", [0, 40])
@pytest.mark.parametrize("seed", range(3))
def test_a_pop_in_is_a_flag(hold, seed):
    curve, place = rigid(world(jump=15.0, hold=hold).curve(seed))
    (flag,) = [one for one in fit(curve, elastic(), free=FREE).flags if one.name == "pop_in"]
    force = 1e9 * curve.force[place - 1]
    stated = float(flag.statement.split("force of ")[1].split(" nN")[0])
    assert stated == pytest.approx(force, rel=0.02)
    assert "the part before the first one" in flag.statement
    assert "pop_in" in FLAG_MEANINGS


@pytest.mark.few(1)
@pytest.mark.parametrize("changes", [{}, {"hold": 40}, {"snap": 15.0, "pull": 30.0}, {"tilt": 5.0}])
def test_curves_without_pop_ins_have_no_such_flag(changes):
    for seed in range(4):
        assert "pop_in" not in names(rigid(world(**changes).curve(seed))[0])


def test_a_staircase_of_loads_is_no_row_of_pop_ins():
    """Where holds are left out of a fit, the depth jumps from stair to stair."""
    stair = np.concatenate([np.linspace(-0.5, 0.3, 150), np.full(60, 0.3), np.linspace(0.3, 1.0, 150)])
    force = hertz(1e-6 * stair, 1.33e4, 5e-6)
    force[150:210] *= np.linspace(1.0, 0.8, 60)
    force[210:] -= 0.2 * force[149] * np.exp(-np.arange(150) / 20.0)
    force += 1e-11 * np.random.default_rng(5).standard_normal(force.size)
    direction = np.repeat([1.0, 0.0, 1.0], [150, 60, 150])
    assert "pop_in" not in names(ForceCurve(1e-6 * stair, force, direction=direction))


def test_stated_events_overrule_found_pop_ins():
    curve, place = rigid(world(jump=15.0).curve(0))
    assert "pop_in" not in names(curve.with_events([]))
    plain, _ = rigid(world().curve(0))
    assert "pop_in" in names(plain.with_events([("pop-in", place, place)]))


def test_a_fit_across_a_pop_in_is_biased():
    """What the flag states: the modulus is too low across it, and right before it."""
    curve, place = rigid(world(jump=60.0).curve(1))
    whole, before = (fit(one.approach, elastic(), free=FREE) for one in (curve, curve.chosen(np.arange(place))))
    true = 1.33e4 * 0.75
    assert abs(before.value(PATH) - true) < 4.0 * before.error(PATH)
    assert true - whole.value(PATH) > 4.0 * before.error(PATH)
    assert "pop_in" not in [flag.name for flag in before.flags]
