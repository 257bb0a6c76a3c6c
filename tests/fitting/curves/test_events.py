"""Events of curves: what happened is found with its size, and where nothing happened nothing is found."""

from __future__ import annotations

import numpy as np
import pytest
from event_worlds import DEEP, FAR, LEVEL, RATE, AfmWorld, IndenterWorld

import winkler as wk
from winkler.fitting.curves import corrections
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.events.found import clock_offset_in, drag_in, free_points, interference_in
from winkler.fitting.curves.events.kinds import CurveEvents, EventKind
from winkler.fitting.curves.events.steps import found_steps
from winkler.io.curves import read_curve

SUDDEN = (EventKind.SNAP_IN, EventKind.POP_IN, EventKind.PULL_OFF, EventKind.INTERFERENCE, EventKind.CLOCK_OFFSET)
QUIET = {
    "even": AfmWorld(),
    "tilt and drift": AfmWorld(tilt=20.0, drift=-15.0),
    "relaxing hold": AfmWorld(hold=300, relaxing=True),
    "nanoindenter": IndenterWorld(),
}


def false_alarms(world, seeds):
    return [(seed, event.kind.value) for seed in seeds for event in world.curve(seed)[0].events if event.kind in SUDDEN]


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("name", QUIET)
def test_where_nothing_happened_nothing_is_found(name):
    assert false_alarms(QUIET[name], range(5)) == []


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("name", QUIET)
def test_false_alarms_are_at_most_one_in_fifty(name):
    assert len(false_alarms(QUIET[name], range(100, 150))) <= 1


def test_phases_of_an_approach_and_a_retraction():
    curve, _ = AfmWorld(hold=300).curve(1)
    kinds = [event.kind.value for event in curve.events]
    assert kinds == [
        "baseline before contact",
        "loading",
        "hold",
        "last unloading",
        "baseline after contact",
    ]
    before, after = curve.events.of("baseline before contact")[0], curve.events.of("baseline after contact")[0]
    assert before.size == pytest.approx(FAR, rel=0.06)
    assert after.size == pytest.approx(FAR, rel=0.06)
    (hold,) = curve.events.of(EventKind.HOLD)
    assert hold.unit == "s"
    assert hold.size == pytest.approx(300 / RATE, rel=0.02)


@pytest.mark.parametrize(
    ("tilt", "drift", "drag"), [(60.0, 0.0, 10.0), (-60.0, 30.0, 10.0), (-20.0, -30.0, 5.0), (0.0, 60.0, 10.0)]
)
def test_free_points_and_drag_beside_tilt_and_drift(tilt, drift, drag):
    """Three numbers of one line each: a drift is no drag, a tilt is no contact."""
    curve, _ = AfmWorld(count=400, tilt=tilt, drift=drift, drag=drag).curve(2)
    for points, out in zip(free_points(curve.record), (curve.direction > 0.0, curve.direction < 0.0), strict=True):
        truly = np.flatnonzero(out & (curve.position < 0.0))
        assert np.isin(points, truly).mean() > 0.97
        assert np.isin(truly, points).mean() > 0.9
    found = drag_in(curve.record)
    assert found.force == pytest.approx(drag * LEVEL, abs=4.0 * found.error)
    assert found.error < 1.5 * LEVEL
    assert corrections.drag_force(curve) == found.force


def test_free_points_where_directions_are_found_from_the_curve():
    """A stage that turns at one noisy point: the free points are those of all curves."""
    for seed in range(4):
        curve, _ = AfmWorld(count=1000, drag=10.0).curve(seed)
        assert corrections.drag_force(curve) == pytest.approx(10.0 * LEVEL, abs=1.5 * LEVEL)


def test_a_curve_without_a_baseline_has_none():
    depth = np.linspace(0.0, 1.0, 500)
    for force in (depth, depth**1.5, depth**2):
        curve = ForceCurve(1e-6 * depth, 1e-3 * force)
        assert curve.events.of("baseline before contact") == ()


@pytest.mark.few(1)
@pytest.mark.parametrize(("jump", "least"), [(12.0, 6), (30.0, 6)])
def test_drops_of_force_while_pressed_in(jump, least):
    """Twelve times the noise, 0.9 % of the greatest force."""
    found = 0
    for seed in range(6):
        curve, place = AfmWorld(jump=jump).curve(seed)
        for event in curve.events.of("pop-in"):
            assert abs(event.last - place) <= 4
            assert event.unit == "N"
            assert event.size == pytest.approx(jump * LEVEL, abs=4.0 * event.error)
            assert event.confidence > 0.99
            found += 1
    assert found >= least


def test_steps_of_depth_under_force():
    """Three pop-ins of ten to twenty times the noise: every one, with its size and its force."""
    steps = ((0.15, 0.005), (0.3, 0.01), (0.6, 0.006))
    for seed in range(4):
        curve, places = IndenterWorld(steps=steps).curve(seed)
        events = curve.events.of("pop-in")
        assert [event.last for event in events] == pytest.approx(places, abs=2)
        for event, (_, size) in zip(events, steps, strict=True):
            assert event.unit == "m"
            assert event.size == pytest.approx(1e-6 * size, abs=4.0 * event.error)


def test_a_jump_of_the_machine_is_no_pop_in():
    """The stage leaves points out: position and force jump together."""
    curve, _ = AfmWorld(slow=0.0).curve(3)
    kept = np.ones(curve.count, dtype=bool)
    kept[480:520] = False
    assert curve.chosen(kept).events.of("pop-in") == ()


@pytest.mark.parametrize("law", [lambda x: np.maximum(x, 0.0) ** 1.5, np.abs, lambda x: np.maximum(x, 0.0) ** 0.6])
@pytest.mark.parametrize("count", [150, 700])
def test_kinks_and_powers_are_no_steps(law, count):
    signal = law(np.linspace(-1.0, 1.0, count))
    assert found_steps(signal) == ()
    assert found_steps(signal, -1.0) == ()


@pytest.mark.few(1)
@pytest.mark.parametrize(("kind", "key"), [("snap-in", "snap"), ("pull-off", "pull")])
def test_tension_before_and_after_contact(kind, key):
    for seed in range(3):
        curve, _ = AfmWorld(count=1500, **{key: 40.0}).curve(seed)
        (event,) = curve.events.of(kind)
        middle = curve.position[event.first : event.last + 1]
        assert np.all(np.abs(middle) < 2.2e-7)
        # the mean of eight neighbours at the sharp end of a pull is less than its tip
        assert 0.85 * 40.0 * LEVEL < event.size < 1.05 * 40.0 * LEVEL
        other = {"snap-in": "pull-off", "pull-off": "snap-in"}[kind]
        assert curve.events.of(other) == ()


@pytest.mark.parametrize("ripple", [1.0, 3.0])
def test_interference(ripple):
    for seed in range(3):
        curve, _ = AfmWorld(ripple=ripple, tilt=20.0, drift=10.0).curve(seed)
        found = interference_in(curve.record)
        assert found.amplitude == pytest.approx(ripple * LEVEL, abs=4.0 * found.amplitude_error)
        assert found.period == pytest.approx(3e-7, abs=4.0 * found.period_error)
        assert found.amplitude_error < 0.2 * LEVEL
        mended = corrections.without_interference(curve, found)
        plain, _ = AfmWorld(ripple=0.0, tilt=20.0, drift=10.0).curve(seed)
        left = mended.force - plain.force
        assert np.abs(left).max() < 0.5 * LEVEL
        assert np.all(np.abs(left) < 4.0 * found.error_at(curve.position))


def test_a_sinusoid_over_the_time_is_no_interference():
    """Mains hum, which is as strong, but not at the same phase over the position in both directions."""
    found = []
    for seed in range(6):
        curve, _ = AfmWorld().curve(seed)
        hum = 2.0 * LEVEL * np.cos(2.0 * np.pi * np.arange(curve.count) / 57.3 + seed)
        found.append(interference_in(ForceCurve(curve.position, curve.force + hum, 0.05).record))
    assert sum(one is not None for one in found) <= 3  # a chance of half that the phases agree


@pytest.mark.few(3)
@pytest.mark.parametrize("late", [-4.0, 1.5, 20.0])
@pytest.mark.parametrize("relaxing", [False, True])
def test_the_clock(late, relaxing):
    for seed in range(2):
        curve, _ = AfmWorld(late=late, hold=300, relaxing=relaxing).curve(seed)
        (event,) = curve.events.of("clock offset")
        assert event.size == pytest.approx(late / RATE, abs=max(4.0 * event.error, 0.1 / RATE))
        mended = corrections.without_clock_offset(curve, event.size)
        left = clock_offset_in(mended.record)
        assert abs(left.offset) < 0.4 / RATE
        assert curve.count - mended.count == pytest.approx(abs(late), abs=1)


def test_the_clock_of_a_smooth_turn_is_unknown():
    swing = DEEP * (0.5 - 0.5 * np.cos(np.linspace(0.0, 2.0 * np.pi, 1001)))
    random = np.random.default_rng(1)
    force = 1e-3 * swing + LEVEL * random.standard_normal(1001)
    position = swing + 1e-10 * random.standard_normal(1001)
    assert clock_offset_in(ForceCurve(position, force, time=np.linspace(0.0, 1.0, 1001)).record) is None


@pytest.mark.parametrize("scale", [(1e-9, 1e-12, 1e-6), (1e5, 1e3, 1e4)])
def test_no_scale_is_absolute(scale):
    length, load, clock = scale
    curve, _ = AfmWorld(ripple=2.0, pull=40.0, jump=30.0, late=3.0, hold=200).curve(4)
    scaled = ForceCurve(length * curve.position, load * curve.force, 0.05 * load / length, time=clock * curve.time)
    factors = {"m": length, "N": load, "s": clock, "": 1.0}
    pairs = list(zip(curve.events, scaled.events, strict=True))
    assert [a.kind for a, _ in pairs] == [b.kind for _, b in pairs]
    for one, other in pairs:
        assert (one.first, one.last) == (other.first, other.last)
        factor = factors[one.unit]
        assert other.size == pytest.approx(factor * one.size, rel=1e-6, abs=0.1 * factor * one.error)
        assert other.error == pytest.approx(factor * one.error, rel=0.02)


def test_stated_events_replace_what_is_found():
    curve, _ = AfmWorld(jump=30.0).curve(5)
    nothing = curve.with_events([])
    assert {event.kind for event in nothing.events} == {EventKind.LOADING, EventKind.LAST_UNLOADING}
    stated = curve.with_events([("baseline", 0, 99), ("pop-in", 400, 400)])
    assert [event.first for event in stated.events.of("pop-in")] == [400]
    assert stated.events.of("baseline before contact")[0].last == 99
    np.testing.assert_array_equal(corrections.free_part(stated).position, curve.position[:100])
    kept = stated.chosen(np.arange(50, curve.count))
    assert kept.events.of("baseline before contact")[0].last == 49


@pytest.mark.parametrize(
    ("stated", "sentence"),
    [
        ([("pop-inn", 1, 1)], r"line 0 is a 'pop-inn' \(did you mean 'pop-in'\?\); give baseline, pop-in"),
        ([("pop-in", 3)], "line 0 is .*; give a kind, its first and its last point"),
        ([("pop-in", 2, 1)], "line 0 spans the points 2 to 1; give indices from 0 to 3"),
        ([("pop-in", 2, 4)], "line 0 spans the points 2 to 4"),
        ([("pop-in", 1.5, 2)], r"line 0 spans the points 1\.5 to 2"),
    ],
)
def test_events_that_cannot_be_stated(stated, sentence):
    with pytest.raises(wk.InvalidInput, match=sentence):
        ForceCurve([0.0, 1.0, 2.0, 3.0], [0.0, 1.0, 2.0, 3.0]).with_events(stated)


def test_a_notebook():
    curve, _ = AfmWorld(pull=40.0, drag=6.0, jump=30.0).curve(6)
    lines = str(curve).splitlines()
    assert lines[0] == "force curve 'seed 6': 1200 points in 1.199 s, machine 50 mN/m"
    assert any("pop-in, step 9" in line and "pN" in line for line in lines)
    assert any("drag, against the motion 1" in line for line in lines)
    assert str(CurveEvents()) == ""
    assert len(str(curve.events).splitlines()) == len(lines) - 1


@pytest.mark.slow
def test_what_was_done_in_real_curves(shared_data):
    """JPK curves in liquid and on a gel, steel by a Hysitron: as seen in their pictures."""
    folder = shared_data / "force_curves"
    pytest.importorskip("afmformats")
    gel = read_curve(folder / "fmt-jpk-cc_pr14-polymergel-2021.06.30.jpk-force").events
    assert gel.of("pull-off")[0].size == pytest.approx(11.1e-9, rel=0.02)
    assert gel.of("drag")[0].size == pytest.approx(44.5e-12, rel=0.05)
    assert gel.of("pop-in") == ()
    cell = read_curve(folder / "fmt-jpk-fd_spot3-0192.jpk-force").events
    assert cell.of("pull-off")[0].size == pytest.approx(370e-12, rel=0.1)
    assert cell.of("baseline before contact")[0].size == pytest.approx(4.56e-6, rel=0.05)


def test_what_was_done_to_steel(shared_data):
    steel = read_curve(shared_data / "nanoindentation" / "RobinSteel0000LC.txt").events
    assert [event.kind.value for event in steel] == ["hold", "loading", "hold", "last unloading"]
