"""Studies of wear: stored while they run, continued, and shown in tables, figures and formulas."""

import numpy as np
import pytest

from winkler.io.software import software
from winkler.problems.wear import march as wear_march
from winkler.problems.wear.fretting import FrettingSolution
from winkler.study.batch.checkpoint import CheckpointStore
from winkler.study.batch.marching import solve_march
from winkler.study.batch.run import run
from winkler.study.language.reading import parse_study
from winkler.values.errors import InvalidInput, NotConverged

FRETTING = """
title = "Fretting"
[problem]
kind = "fretting_wear"
normal = { kind = "depth", depth = "1 um" }
amplitude = { kind = "shift", shift = "0.45 um" }
cycles = [0, 1e4, 1e5, 2e5]
count = 30
wear = { kind = "archard", rate = "1e-5 mm^3/(N m)" }
law = { kind = "coulomb", coefficient = 0.5 }
[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }
[problem.bed.medium]
kind = "half_space"
first = { kind = "elastic", young = "210 GPa", poisson = 0.3 }
second = { kind = "elastic", young = "210 GPa", poisson = 0.3 }
"""


def study():
    return parse_study(FRETTING)


class Stopped(BaseException):
    """As a kill from outside: nothing in the package catches it."""


def stopping(after):
    def watch(states, total):
        assert total == 4
        for count, state in enumerate(states):
            if count == after:
                raise Stopped
            yield state

    return watch


def test_rates_are_read_as_they_are_stated():
    assert study().problem.wear.rate == pytest.approx(1e-14)


def test_a_run_that_was_killed_goes_on_with_the_same_numbers(tmp_path, monkeypatch):
    problem = study().problem
    keep = CheckpointStore.beside(tmp_path / "results")
    with pytest.raises(Stopped):
        solve_march(problem, stopping(3), keep)
    assert len(keep.stored_states(problem)) == 3
    whole = problem.solve()
    assert keep.stored_states(problem) == list(whole.states[:3])
    taken = []
    advance = wear_march._advance

    def counted(*arguments):
        taken.append(arguments)
        return advance(*arguments)

    monkeypatch.setattr(wear_march, "_advance", counted)
    again = solve_march(problem, keep=keep)
    assert len(taken) == 1
    assert again.solution == whole
    assert keep.path(problem).exists()
    keep.remove()
    assert list(tmp_path.iterdir()) == []


def test_a_spoilt_file_is_no_reason_to_stop(tmp_path):
    problem, keep = study().problem, CheckpointStore.beside(tmp_path / "results")
    keep.path(problem).write_bytes(b"half")
    assert keep.stored_states(problem) == []


@pytest.mark.parametrize(("made", "text"), [("99.0", "winkler 99.0"), (None, "winkler unknown")])
def test_states_of_other_software_are_refused(made, text, tmp_path):
    problem, keep = study().problem, CheckpointStore.beside(tmp_path / "results")
    with pytest.raises(Stopped):
        solve_march(problem, stopping(3), keep)
    path = keep.path(problem)
    with np.load(path) as stored:
        arrays = {name: stored[name] for name in stored.files if name != "software"}
    assert len(arrays) < len(np.load(path).files)
    rows = [*(software() | {"winkler": made}).items()]
    np.savez(path, **arrays, **({} if made is None else {"software": np.array(rows)}))
    with pytest.raises(InvalidInput, match=rf"^states: .* was begun with {text} \(here .*\), .*; add --anew"):
        solve_march(problem, keep=keep)
    keep.remove()
    assert keep.stored_states(problem) == []


def test_a_march_that_ends_early_keeps_its_states(monkeypatch):
    advance = wear_march._advance

    def ends(problem, moment, goal, everywhere):
        if goal > 1e5:
            raise NotConverged("Wear: enough.")
        return advance(problem, moment, goal, everywhere)

    monkeypatch.setattr(wear_march, "_advance", ends)
    march = solve_march(study().problem)
    assert march.code == 3
    assert "After 3 of 4 points" in march.stopped
    assert isinstance(march.solution, FrettingSolution)
    np.testing.assert_array_equal(march.solution.cycles, [0.0, 1e4, 1e5])


def test_the_table_lists_every_state():
    outcome = run(study())
    names = [column.name for column in outcome.table()]
    assert {"cycles", "worn_volume", "first_volume", "stick_radius", "loss_per_cycle"} <= set(names)
    assert outcome.answer("worn_volume").shape == (4,)
