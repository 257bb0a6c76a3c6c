"""Fits are streams: the same numbers whether observed or not, states that get better, and an end at the time limit."""

from __future__ import annotations

import itertools
from types import SimpleNamespace

import numpy as np
import pytest
from relaxing_curves import FREE, curve, start
from synthetic import hertz, jkr, there_and_back

import winkler as wk
from winkler.fitting import search
from winkler.fitting.compare import compare
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit, fit_steps
from winkler.fitting.search import FitState
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.values.errors import InvalidInput, NotConverged

YOUNG = "bed.medium.first.young"


def bed():
    return wk.Foundation(wk.Paraboloid(5e-6), wk.HalfSpace.between(wk.Elastic(1e6, 0.5)))


def noisy(force, position):
    return ForceCurve(position, force + 1e-11 * np.random.default_rng(4).standard_normal(position.size))


def elastic():
    position, _ = there_and_back(-1e-6, 1e-6, 300)
    return noisy(hertz(position, 1e4, 5e-6), position), wk.Indentation(bed(), wk.Depth(0.0)), [YOUNG, "contact_point"]


def sticky():
    position, inward = there_and_back(-1e-6, 1e-6, 300)
    model = AdhesiveIndentation(bed(), wk.ShortRange(0.01), wk.Depth(0.0))
    return noisy(jkr(position, inward, 1e4, 5e-6, 1e-4, 1e12), position), model, [YOUNG, "law.work", "contact_point"]


def relaxing(kind):
    return curve(kind, 1), start(kind), FREE[kind]


KINDS = {
    "elastic": elastic,
    "adhesive": sticky,
    "loop": lambda: relaxing("loop"),
    "creep": lambda: relaxing("creep"),
}


@pytest.mark.few(1)
@pytest.mark.parametrize("kind", KINDS)
def test_a_stream_ends_with_what_fit_finds(kind):
    one, model, free = KINDS[kind]()
    *states, found = fit_steps(one, model, free=free)
    plain = fit(one, model, free=free)
    assert np.array_equal(found.values, plain.values)
    assert np.array_equal(found.standard_errors, plain.standard_errors)
    assert [state.evaluations for state in states] == list(range(1, len(states) + 1))
    assert all(state.names == found.names for state in states)
    # the last step, to the noise of the residuals, is a part of the errors
    apart = np.abs(states[-1].values - found.values)
    assert np.all(apart <= np.maximum(1e-3 * np.abs(found.values), 0.5 * found.standard_errors))
    assert states[-1].scatter == pytest.approx(found.scatter, rel=0.05)


def test_the_last_stage_only_gets_better():
    one, model, free = elastic()
    *states, _ = fit_steps(one, model, free=free)
    scatter = [state.scatter for state in states]
    last = max(i for i in range(1, len(scatter)) if scatter[i] > scatter[i - 1])
    assert last < len(scatter) - 1
    assert all(b <= a for a, b in itertools.pairwise(scatter[last:]))


def clocked(monkeypatch, seconds=1.0):
    """A clock that goes on by so much whenever it is read."""
    clock = itertools.count()
    monkeypatch.setattr(search, "time", SimpleNamespace(monotonic=lambda: seconds * next(clock)))


@pytest.mark.parametrize("kind", KINDS)
def test_the_time_limit(kind, monkeypatch):
    one, model, free = KINDS[kind]()
    clocked(monkeypatch)
    message = r"^fit: .* within the time limit of 6 s, after [1-7] evaluations; give more"
    with pytest.raises(NotConverged, match=message):
        fit(one, model, free=free, time_limit=6.0)
    with pytest.raises(NotConverged, match="time limit"):
        list(fit_steps(one, model, free=free, time_limit=6.0))


def test_a_limit_that_is_far_changes_nothing():
    one, model, free = elastic()
    assert np.array_equal(fit(one, model, free=free, time_limit=1e6).values, fit(one, model, free=free).values)


@pytest.mark.parametrize("limit", [0.0, -1.0, float("nan"), "10 s"])
def test_limits_that_are_no_time(limit):
    one, model, free = elastic()
    with pytest.raises(InvalidInput, match="time_limit is .*; give a positive time in s"):
        fit(one, model, free=free, time_limit=limit)


def test_a_model_that_takes_too_long_is_refused_in_a_comparison(monkeypatch):
    one, model, free = elastic()
    clocked(monkeypatch)
    with pytest.raises(wk.OutsideValidity, match="no model can be fitted; slow: fit: .* time limit"):
        compare(one, {"slow": (model, free)}, time_limit=3.0)


def test_a_stream_that_is_left_is_over():
    one, model, free = elastic()
    stream = fit_steps(one, model, free=free)
    first = next(stream)
    assert isinstance(first, FitState)
    stream.close()
    with pytest.raises(StopIteration):
        next(stream)
