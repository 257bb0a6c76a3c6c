"""Segments are found from the curve itself: programs that are known, played by a closed-form indentation."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.directions import found_directions
from winkler.io.curves import read_curve
from winkler.io.segments import directions

LEG = 200


def ramp(start, end, count=LEG):
    return np.linspace(start, end, count + 1)[1:]


def driven_by_force(steps, creep=0.02):
    """Return depth, force and kinds of steps: h is the root of the peak so far, times 0.85 + 0.15 (F/F_peak)^(2/3)."""
    force, kinds, depth, extra, peak = [0.0], ["loading"], [0.0], 0.0, 1e-12
    for kind, content in steps:
        if kind == "hold":
            crept = creep * np.log1p(np.arange(1, content + 1) / content) / math.log(2.0)
            depth += [depth[-1] + each for each in crept]
            force += [force[-1]] * content
            extra += creep
        else:
            path = ramp(force[-1], content)
            peaks = np.maximum(np.maximum.accumulate(path), peak)
            peak = float(peaks[-1])
            depth += list(np.sqrt(peaks) * (0.85 + 0.15 * (path / peaks) ** (2.0 / 3.0)) + extra)
            force += list(path)
        kinds += [kind] * (len(force) - len(kinds))
    return np.array(depth), np.array(force), kinds


def segments(curve):
    return [(segment.kind.value, segment.count) for segment in curve.segments]


def runs(kinds):
    edges = [0, *(k for k in range(1, len(kinds)) if kinds[k] != kinds[k - 1]), len(kinds)]
    return [(kinds[a], b - a) for a, b in zip(edges[:-1], edges[1:], strict=True)]


PROGRAMS = {
    "in and out": [("loading", 1.0), ("last unloading", 0.0)],
    "hold": [("loading", 1.0), ("hold", 100), ("last unloading", 0.0)],
    "short hold": [("loading", 1.0), ("hold", 5), ("last unloading", 0.0)],
    "drift": [("loading", 1.0), ("hold", 100), ("last unloading", 0.1), ("hold", 600), ("last unloading", 0.0)],
    "progressive": [
        *(
            step
            for peak in (0.25, 0.5, 0.75)
            for step in (("loading", peak), ("hold", 60), ("partial unloading", 0.1 * peak))
        ),
        ("loading", 1.0),
        ("hold", 60),
        ("last unloading", 0.0),
    ],
    "cycles": [
        *(step for _ in range(3) for step in (("loading", 1.0), ("partial unloading", 0.2))),
        ("loading", 1.0),
        ("last unloading", 0.0),
    ],
    "a smaller indent after it": [
        ("loading", 1.0),
        ("last unloading", 0.0),
        ("loading", 0.4),
        ("partial unloading", 0.0),
    ],
}


@pytest.mark.parametrize(
    ("name", "noise"),
    [*((name, 0.0) for name in PROGRAMS), *((name, 1e-3) for name in PROGRAMS if name != "short hold")],
)
def test_a_program_is_found_again(name, noise):
    depth, force, kinds = driven_by_force(PROGRAMS[name])
    rng = np.random.default_rng(1)
    depth, force = (column + noise * rng.standard_normal(column.size) for column in (depth, force))
    found, stated = segments(ForceCurve(depth, force)), runs(kinds)
    assert [kind for kind, _ in found] == [kind for kind, _ in stated]
    counts = np.array([[a for _, a in found], [b for _, b in stated]])
    assert np.abs(np.diff(counts, axis=0)).max() <= (16 if noise else 4)


@pytest.mark.parametrize("name", PROGRAMS)
def test_thermal_drift_changes_nothing(name):
    depth, force, _ = driven_by_force(PROGRAMS[name])
    drifting = depth + 0.05 * np.arange(depth.size) / depth.size
    assert np.array_equal(found_directions(depth, force), found_directions(drifting, force))


@pytest.mark.parametrize(("length", "load"), [(1e-9, 1e-9), (1e3, 1e-12), (1e-12, 1e6)])
def test_no_scale_is_absolute(length, load):
    depth, force, _ = driven_by_force(PROGRAMS["progressive"])
    assert np.array_equal(found_directions(depth, force), found_directions(length * depth, load * force))


@pytest.mark.parametrize("count", [12, 30, 300])
def test_few_points_a_leg(count):
    up = np.linspace(0.0, 1.0, count)
    depth = np.concatenate([up, up[-2::-1]])
    assert segments(ForceCurve(depth, depth**1.5)) == [("loading", count), ("last unloading", count - 1)]


def test_a_smooth_turn_is_no_hold():
    swing = 0.5 - 0.5 * np.cos(np.linspace(0.0, 2.0 * np.pi, 1001))
    assert segments(ForceCurve(swing, swing**1.5)) == [("loading", 501), ("last unloading", 500)]


def relaxing(position, held):
    """Return the forces of a stage that comes from afar, is held, and goes back."""
    elastic = np.maximum(position, 0.0) ** 1.5
    return np.concatenate([elastic[:1000], 0.7 + 0.3 * np.exp(-np.arange(held) / 300.0), 0.7 * elastic[1000 + held :]])


STAGE = np.concatenate([np.linspace(-3.0, 1.0, 1000), np.full(1500, 1.0), np.linspace(1.0, -3.0, 1001)[1:]])


def test_a_stage_that_is_held_while_the_force_relaxes():
    found = segments(ForceCurve(STAGE, relaxing(STAGE, 1500)))
    assert [kind for kind, _ in found] == ["loading", "hold", "last unloading"]
    assert abs(found[1][1] - 1500) <= 6


def test_a_stage_that_creeps_under_a_held_force():
    position = STAGE.copy()
    position[1000:2500] += 0.3 * (1.0 - np.exp(-np.arange(1500) / 400.0))
    position[2500:] += 0.3
    force = np.concatenate([np.maximum(STAGE[:1000], 0.0) ** 1.5, np.ones(1500), np.maximum(STAGE[2500:], 0.0) ** 1.5])
    found = segments(ForceCurve(position, force + 0.005 * np.random.default_rng(3).standard_normal(force.size)))
    assert [kind for kind, _ in found] == ["loading", "hold", "last unloading"]
    assert abs(found[1][1] - 1500) <= 40


def test_adhesion_and_a_free_branch_are_no_segments():
    stage = np.concatenate([np.linspace(-3.0, 1.0, 1500), np.linspace(1.0, -3.0, 1501)[1:]])
    force = np.maximum(stage, 0.0) ** 1.5
    sticking = (np.arange(3000) > 1500) & (stage < 0.0) & (stage > -0.8)
    force[sticking] = 1.5 * stage[sticking]
    noisy = force + 0.02 * np.random.default_rng(2).standard_normal(3000)
    assert segments(ForceCurve(stage, noisy)) == [("loading", 1500), ("last unloading", 1500)]


def test_stated_segments_overrule_what_was_found():
    depth, force, _ = driven_by_force(PROGRAMS["hold"])
    curve = ForceCurve(depth, force).with_segments([("loading", 0), ("unloading", 301)])
    assert segments(curve) == [("loading", 301), ("last unloading", depth.size - 301)]
    assert curve.retract.count == depth.size - 301


@pytest.mark.parametrize(
    ("stated", "sentence"),
    [
        ([], "none are given; state them"),
        ([("holding", 0)], r"line 0 is a 'holding' \(did you mean 'hold'\?\); give loading, hold or unloading"),
        ([("loading", 3)], "line 0 begins at the point 3; begin at 0"),
        ([("loading", 0), ("hold", 0)], "line 1 begins at the point 0; begin at 0, and give growing indices"),
        ([("loading", 0), ("hold", 1.5)], r"line 1 begins at the point 1\.5"),
        ([("loading", 0), ("hold", 999)], "line 1 begins at the point 999; .* below 3"),
        (["loading"], "line 0 is 'loading'; give a kind and its first point"),
    ],
)
def test_segments_that_cannot_be_stated(stated, sentence):
    curve = ForceCurve([0.0, 1.0, 0.0], [0.0, 1.0, 0.0])
    with pytest.raises(wk.InvalidInput, match=sentence):
        curve.with_segments(stated)


def test_the_unloading_of_a_metal_in_a_column_of_segments_is_one():
    """It takes 5 % of the depth back: what its points do counts, not how far they go."""
    up = np.linspace(0.0, 1.0, 100)
    depth = np.concatenate([np.sqrt(up), np.full(50, 1.0), 1.0 - 0.05 * up])
    force = np.concatenate([up, np.ones(50), 1.0 - up])
    segment = np.repeat([1.0, 2.0, 3.0], [100, 50, 100])
    assert directions(depth, force, segment).tolist() == [1.0] * 100 + [0.0] * 50 + [-1.0] * 100


def test_the_segments_of_a_real_curve(shared_data):
    """Steel by a Hysitron, 10 s in, 5 s held at 3 mN, 10 s out, after 2 s of waiting: the file does not say so."""
    curve = read_curve(shared_data / "nanoindentation" / "RobinSteel0000LC.txt")
    assert [kind for kind, _ in segments(curve)] == ["hold", "loading", "hold", "last unloading"]
    starts = [curve.time[segment.first] for segment in curve.segments]
    np.testing.assert_allclose(starts, [0.0, 2.03, 12.03, 17.06], atol=0.05)


@pytest.mark.parametrize("points", [6, 8, 60])
@pytest.mark.parametrize("recovered", [0.03, 0.08])
def test_a_stiff_unloading_that_a_file_numbers_is_no_hold(points, recovered):
    """Steel: the tip comes back by a few hundredths of its depth while all of the force goes."""
    random = np.random.default_rng(5)
    into, creep = np.linspace(0.0, 1.0, 100), np.linspace(1.0, 1.0 + 0.1 * recovered, 50)
    out = creep[-1] - recovered * np.linspace(0.0, 1.0, points)
    depth = np.concatenate([into, creep, out]) + 1e-3 * random.standard_normal(150 + points)
    force = np.concatenate([into**2, np.ones(50), np.linspace(1.0, 0.0, points) ** 1.5])
    segment = np.repeat([0, 1, 2], [100, 50, points])
    expected = [1.0] * 100 + [0.0] * 50 + [-1.0] * points
    assert directions(1e-6 * depth, 1e-2 * force, segment).tolist() == expected


def test_a_relaxing_hold_stays_one():
    """The force falls by half while the position is kept."""
    into, time = np.linspace(0.0, 1.0, 100), np.linspace(0.0, 1.0, 60)
    force = np.concatenate([into**2, 1.0 - 0.5 * time, 0.5 * np.linspace(1.0, 0.0, 60)])
    segment = np.repeat([0, 1, 2], [100, 60, 60])
    depth = np.concatenate([into, np.ones(60), np.linspace(1.0, 0.0, 60)])
    assert directions(depth, force, segment).tolist() == [1.0] * 100 + [0.0] * 60 + [-1.0] * 60


@pytest.mark.few(2, slow=2)
@pytest.mark.parametrize("recovered", [0.02, 0.1])
@pytest.mark.parametrize(("noise", "seed"), [(0.0, 0), (5e-4, 1), (1e-3, 2)])
def test_twenty_partial_unloadings_of_a_stiff_contact(recovered, noise, seed):
    """Each takes back 2 % of the depth, by nine tenths of the force; the first peaks are a twentieth of the last."""
    force, depth, kinds, peak = [0.0], [0.0], ["loading"], 0.0
    for number in range(1, 22):
        lowest, before, peak, end = force[-1], peak, number / 21.0, 0.1 * number / 21.0 if number < 21 else 0.0
        up, down = ramp(lowest, peak), ramp(peak, end)
        slope = recovered / 0.9  # of the depth at a peak, over its force
        again = np.sqrt(before) - slope * np.sqrt(before) * (1.0 - up / before) if before else up
        depth += [*np.where(up > before, np.sqrt(up), again), *np.full(50, np.sqrt(peak))]
        depth += list(np.sqrt(peak) - slope * np.sqrt(peak) * (1.0 - down / peak))
        force += [*up, *np.full(50, peak), *down]
        last = "partial unloading" if number < 21 else "last unloading"
        kinds += ["loading"] * LEG + ["hold"] * 50 + [last] * LEG
    random = np.random.default_rng(seed)
    columns = (np.array(column) + noise * random.standard_normal(len(column)) for column in (depth, force))
    found, stated = segments(ForceCurve(*columns)), runs(kinds)
    assert [kind for kind, _ in found] == [kind for kind, _ in stated]
    assert np.abs(np.array([a for _, a in found]) - np.array([b for _, b in stated])).max() <= 12


@pytest.mark.parametrize("curve", ["sine", "parabola"])
def test_a_smooth_noisy_turn_is_no_hold(curve):
    along = np.linspace(-1.0, 1.0, 1001)
    swing = np.cos(0.4 * np.pi * along) if curve == "sine" else 1.0 - along**2
    for seed in range(5):
        random = np.random.default_rng(seed)
        position, force = (column + 5e-4 * random.standard_normal(1001) for column in (swing, swing**1.5))
        assert [kind for kind, _ in segments(ForceCurve(position, force))] == ["loading", "last unloading"]
