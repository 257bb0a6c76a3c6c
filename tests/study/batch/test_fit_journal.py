"""Fits in a journal: they come back to the last digit, and a curve or a fit that was changed is computed again."""

from __future__ import annotations

import dataclasses
import math
import re

import numpy as np
import pytest

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.io.curves import PlacedCurve, UnreadCurve
from winkler.study.batch import fit_run
from winkler.study.batch.fit_outcome import Fitted, Refused
from winkler.study.batch.fit_recording import fingerprint, recalled_fits
from winkler.study.batch.fit_run import fit_curves, fit_study
from winkler.study.batch.journal import Journal
from winkler.study.batch.lossless import packed, unpacked
from winkler.study.language.fit_reading import read_fit_study
from winkler.study.language.fit_study import FitStudy, Free
from winkler.values.errors import InvalidInput, NotConverged

BED = wk.Foundation(wk.Paraboloid(5e-6), wk.HalfSpace.between(wk.Elastic(1e3, 0.5)))
YOUNG = Free("problem.bed.medium.first.young")
STUDY = FitStudy("map", wk.Indentation(BED, wk.Depth(0.0)), ("map.jpk",), (YOUNG, Free("contact_point")))


def curve(number: int) -> PlacedCurve:
    """F = 4/3 E/(1-nu^2) sqrt(R) d^(3/2) with noise, E = 3 kPa + number kPa."""
    random = np.random.default_rng(number)
    depth = np.linspace(-1e-6, 1e-6, 80)
    force = 4.0 / 3.0 * (3e3 + 1e3 * number) / 0.75 * math.sqrt(5e-6) * np.maximum(depth, 0.0) ** 1.5
    measured = ForceCurve(depth, force + 5e-12 * random.standard_normal(80), name=f"map.jpk, curve {number}")
    return PlacedCurve(measured, 1e-6 * number, math.nan)


MAP = [curve(0), UnreadCurve("map.jpk, curve 1", "map.jpk: it is broken."), curve(2), curve(3)]


@pytest.fixture
def counted(monkeypatch):
    """Count the curves that are fitted."""
    calls = []
    plain = fit_run._fit_curve

    def watched(study, one, where, watch):
        calls.append(one)
        return plain(study, one, where, watch)

    monkeypatch.setattr(fit_run, "_fit_curve", watched)
    return calls


def fitted(path, study=STUDY, todo=MAP, count=None):
    """Fit the first curves with a journal; return what is known before, and all that came."""
    with Journal(path, study) as journal:
        known = recalled_fits(study, todo, journal)
        stream = fit_curves(study, todo, earlier=known, journal=journal)
        return known, dict(stream) if count is None else dict(next(stream) for _ in range(count))


def digits(results):
    """Return all that results hold, as text: nan is nan there."""
    return repr([(type(one), dataclasses.astuple(one)) for one in results])


@pytest.mark.slow
def test_fits_come_back_to_the_last_digit_and_are_not_done_twice(tmp_path, counted):
    whole = dict(fit_curves(STUDY, MAP))
    del counted[:]
    fitted(tmp_path / "x", count=3)
    known, found = fitted(tmp_path / "x")
    assert counted == MAP
    assert sorted(known) == [0, 1, 2]
    for place, results in whole.items():
        assert digits(found[place]) == digits(results)
        assert [getattr(one, "fit", 0) for one in found[place]] == [getattr(one, "fit", 0) for one in results]
    assert [type(found[place][0]) for place in range(4)] == [Fitted, Refused, Fitted, Fitted]


@pytest.mark.slow
def test_a_fit_with_adhesion_and_corrections_comes_back(root, tmp_path):
    """Fits of bodies that relax do, too: test_relaxing_fit_study.py."""
    study = read_fit_study(root / "examples" / "studies" / "fitting" / "fit_sticky.toml")
    todo = fit_run.pieces(study)
    _, fresh = fitted(tmp_path / "x", study, todo)
    known, _ = fitted(tmp_path / "x", study, todo)
    assert known[0][0].fit == fresh[0][0].fit
    assert known[0][0].notes == fresh[0][0].notes == known[0][0].fit.validity
    assert known[0][0].steps == fresh[0][0].steps


@pytest.mark.slow
def test_a_curve_that_was_changed_is_fitted_again(tmp_path, counted):
    fitted(tmp_path / "x")
    del counted[:]
    one = curve(2)
    force = one.curve.force.copy()
    force[7] = np.nextafter(force[7], 1.0)
    other = dataclasses.replace(one, curve=dataclasses.replace(one.curve, force=force))
    known, found = fitted(tmp_path / "x", todo=[MAP[0], MAP[1], other, MAP[3]])
    assert counted == [other]
    assert sorted(known) == [0, 1, 3]
    assert found[2] == fit_run._fit_piece(STUDY, other)
    assert sorted(fitted(tmp_path / "x", todo=[other, curve(5)])[0]) == [0]  # of the two lines of one curve, its own


@pytest.mark.parametrize(
    "change",
    [
        {"problem": wk.Indentation(dataclasses.replace(BED, profile=wk.Paraboloid(6e-6)), wk.Depth(0.0))},
        {"free": (YOUNG,)},
        {"free": (dataclasses.replace(YOUNG, given=(1e2, 1e5)), Free("contact_point"))},
        {"part": "both"},
        {"correct": ("baseline",)},
        {"segments": ("loading 0",)},
        {"spring_constant": 1.0},
        {"noise": 1e-12},
        {"time_limit": 5.0},
    ],
)
def test_another_fit_is_refused(change, tmp_path):
    fitted(tmp_path / "x", count=1)
    with (
        pytest.raises(InvalidInput, match="holds curves of another study, or of another version of this one; add --an"),
        Journal(tmp_path / "x", dataclasses.replace(STUDY, **change)),
    ):
        pass
    with Journal(tmp_path / "x", dataclasses.replace(STUDY, title="other", text="# more")) as journal:
        assert journal.count == 1


def test_the_mark_of_a_file_is_of_its_name_and_its_bytes(tmp_path):
    study = dataclasses.replace(STUDY, folder=str(tmp_path))
    one, other = tmp_path / "one.csv", tmp_path / "other.csv"
    one.write_bytes(b"1, 2\n")
    other.write_bytes(b"1, 2\n")
    marks = [fingerprint(study, str(path)) for path in (one, other)]
    one.write_bytes(b"1, 3\n")
    assert len({*marks, fingerprint(study, str(one))}) == 3
    assert fingerprint(study, str(tmp_path / "none.csv")) == ""


def test_in_python_the_same_call_goes_on(tmp_path, monkeypatch, counted):
    study = dataclasses.replace(STUDY, sources=("map.jpk",))
    monkeypatch.setattr(fit_run, "pieces", lambda _: MAP)
    monkeypatch.setattr(fit_run, "_hash", lambda _: "")
    fitted(tmp_path / "x", study, count=2)
    outcome = fit_study(study, journal=tmp_path / "x")
    assert len(counted) == len(MAP)
    assert digits(outcome.results) == digits(fit_study(study).results)
    assert list(tmp_path.iterdir()) == []


def test_a_batch_without_any_answer_leaves_no_journal(tmp_path):
    fitted(tmp_path / "x", todo=[MAP[1], dataclasses.replace(MAP[1], name="another")])
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("before", "sentence"), [(2, "2 of 4 curves are kept in '{}'"), (0, "No curve was fitted.")])
def test_when_workers_die_it_is_stated_what_is_stored(before, sentence, tmp_path, monkeypatch):
    def dead(*_):
        raise NotConverged("workers: a worker process ended before its time.")

    path = tmp_path / "x"
    if before:
        fitted(path, count=before)
    monkeypatch.setattr(fit_run, "fingerprint", dead)
    with pytest.raises(NotConverged, match=re.escape(f"ended before its time. {sentence.format(path)}")):
        fitted(path)


def test_a_mistake_of_ours_costs_one_curve_and_is_tried_again(monkeypatch, tmp_path):
    plain = fit_run._fit_of

    def broken(study, measured, watch):
        if "curve 2" in measured.name:
            raise ZeroDivisionError("float division by zero")
        return plain(study, measured, watch)

    with monkeypatch.context() as patch:
        patch.setattr(fit_run, "_fit_of", broken)
        _, found = fitted(tmp_path / "x")
    assert found[2][0].reason == "an unexpected error, ZeroDivisionError: float division by zero"
    assert found[2][0].code == 70
    assert isinstance(found[3][0], Fitted)
    known, found = fitted(tmp_path / "x")
    assert sorted(known) == [0, 1, 3]
    assert isinstance(found[2][0], Fitted)


def test_a_line_that_does_not_fit_is_refused(tmp_path):
    with Journal(tmp_path / "x", STUDY) as journal:
        journal.write(f'{{"of":"{fingerprint(STUDY, MAP[0])}","curves":[{{"name":"a"}}]}}')
    with (
        pytest.raises(InvalidInput, match=r"holds a line that does not fit the study .*; add --anew"),
        Journal(tmp_path / "x", STUDY) as journal,
    ):
        recalled_fits(STUDY, MAP, journal)


def test_only_known_classes_are_made_again():
    with pytest.raises(KeyError, match="Depth"):
        unpacked(packed(wk.Depth(1.0)), {})
    long = np.arange(2000.0)
    long[3] = -0.0
    again = unpacked(packed((long, math.nan, -math.inf, ((1, "a"),))), {})
    assert again[0].tobytes() == long.tobytes()
    assert math.isnan(again[1])
    assert again[2:] == (-math.inf, ((1, "a"),))
