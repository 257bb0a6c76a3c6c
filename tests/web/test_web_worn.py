"""Pictures of wear in the app: the profile and the pressure of the moment that is looked at."""

from __future__ import annotations

import json

import numpy as np
import pytest
import tomli_w

from winkler.web.form import form
from winkler.web.pictures.replies import MomentComplete
from winkler.web.session.worker import Look, Solve, _WorkerState


@pytest.fixture(scope="module")
def history():
    """A worn contact of the catalogue, and who answers for it."""
    bench = _WorkerState()
    text = tomli_w.dumps(form.initial_table("fretting_wear"))
    replies = bench.replies(Solve(1, text, "", True))
    answer = next(replies)
    return bench, answer, charts(replies)


def charts(replies):
    """Return the interactive pictures up to the end of their frame."""
    found = {}
    for reply in replies:
        if isinstance(reply, MomentComplete):
            break
        found[reply.name] = json.loads(reply.chart)
    return found


def numbers(line, name):
    return np.array(line[name], dtype=float)


def test_the_profile_is_that_of_the_moment(history):
    bench, answer, _ = history
    states = bench.moments.states
    assert answer.moments == len(states) > 2
    chart = charts(bench.replies(Look(2, 2)))["worn_profile"]
    curves = [one for one in chart["data"] if "name" in one]  # beside them stands the shaded area
    end, before, now = curves
    assert [one["name"] for one in curves] == ["in the end", "before wear", "now"]
    highest = np.max(states[-1].height[states[-1].radii <= end["x"][-1] * 1e-6])
    scale = 10.0 ** round(float(np.log10(np.max(end["y"]) / highest)))
    for line, state in ((now, states[2]), (end, states[-1])):
        inside = state.radii <= float(end["x"][-1]) * 1e-6
        height = np.interp(state.radii[inside] * 1e6, numbers(line, "x"), numbers(line, "y"))
        assert height == pytest.approx(state.height[inside] * scale, rel=2e-3, abs=1e-3 * float(np.max(line["y"])))
    assert np.all(numbers(now, "y") >= numbers(before, "y") - 1e-6)
    # what is filled has the volume that was worn off: 2 pi int r (now - before) dr
    r, worn = numbers(now, "x") * 1e-6, (numbers(now, "y") - numbers(before, "y")) / scale
    volume = 2.0 * np.pi * np.trapezoid(r * worn, r)
    assert volume == pytest.approx(states[2].worn_volume, rel=0.02)


def test_the_frame_stays_while_the_film_plays(history):
    bench, _, first = history
    for moment in (0, 3):
        looked = charts(bench.replies(Look(2, moment)))
        for name in ("worn_profile", "worn_pressure"):
            for axis in ("xaxis", "yaxis"):
                assert looked[name]["layout"][axis]["range"] == first[name]["layout"][axis]["range"]


def test_the_pressure_bears_the_load(history):
    bench, _, _ = history
    now = charts(bench.replies(Look(2, 1)))["worn_pressure"]["data"][-1]
    state = bench.moments.states[1]
    assert now["name"] == "now"
    ceiling = 3.0 * max(one.force / (np.pi * one.radius**2) for one in bench.moments.states)
    scale = 10.0 ** round(float(np.log10(np.max(now["y"]) / min(np.max(state.pressure), ceiling))))
    r, p = numbers(now, "x") * 1e-6, numbers(now, "y") / scale
    assert 2.0 * np.pi * np.trapezoid(r * p, r) == pytest.approx(state.force, rel=0.02)


def test_the_last_state_is_shown_first_and_what_was_lost_is_stated(history):
    bench, answer, first = history
    states = bench.moments.states
    assert answer.moment == len(states) - 1
    end, now = first["worn_depth"]["data"]
    assert now["y"] == end["y"]
    early = charts(bench.replies(Look(2, 2)))["worn_depth"]["data"][1]
    scale = 10.0 ** round(float(np.log10(max(end["y"]) / np.max(states[-1].worn))))
    assert np.interp(states[2].radii * 1e6, numbers(early, "x"), numbers(early, "y")) == pytest.approx(
        states[2].worn * scale, rel=1e-4, abs=1e-6 * max(end["y"])
    )
