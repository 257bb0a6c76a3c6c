"""Whatever has steps is watched and keeps what it has reached; whatever is solved has a picture."""

from __future__ import annotations

import numpy as np
import pytest
from answer_types import hints_of, names_of, public_problems
from example_answers import lasting_slow, solved

from winkler.io.processes.stopping import INTERRUPTED
from winkler.problems.answer import is_march
from winkler.problems.last_cycle import Cycled, Looped
from winkler.study.batch.marching import solve_march
from winkler.study.batch.outcome import answers_of
from winkler.study.language.build import build
from winkler.study.language.catalogue import CATALOGUE, kinds
from winkler.study.language.explain import example_study

PROBLEMS = CATALOGUE["problem"]
MARCHES = [name for name, line in PROBLEMS.items() if hasattr(line.cls, "steps")]
FEW = {
    "elastic_plastic_particle": 2,
    "fretting_wear": 3,
    "sliding_wear": 3,
    "surface_contact": 3,
    "surface_wear": 3,
    "reduction": 12,
    **dict.fromkeys(("line_fretting_wear", "line_sliding_wear"), 3),
}
"""States after which a march is interrupted, where it has hardly more, or its solution needs more than five."""

PER_LENGTH = {"LineTangential"}
"""Half-planes move without bound under a load per length, so that only their loss is known."""
PLACED = {"LineViscoelasticIndentation"}
"""What it loses depends on how much of the half-planes lies between two points, which are arguments."""


def stopping(count):
    """Return what watches a march and interrupts it, and what it received."""
    totals = []

    def watch(states, total):
        totals.append(total)
        for place, state in enumerate(states):
            if place == count:
                raise KeyboardInterrupt
            yield state

    return watch, totals


def rows(solution):
    """Return name -> column of the results along a path."""
    found = answers_of(solution)
    most = max(content.size for content in found.values() if isinstance(content, np.ndarray))
    return {name: content for name, content in found.items() if np.shape(content)[:1] == (most,)}


def test_there_are_marches():
    assert len(MARCHES) >= 15
    assert {name for name, line in kinds().items() if hasattr(line.cls, "steps")} == set(MARCHES)


@pytest.mark.few(10, slow=3)
@pytest.mark.parametrize("name", lasting_slow(MARCHES))
def test_every_march_states_how_far_it_is_and_keeps_what_it_has_reached(name):
    problem = build(example_study(name)["problem"])
    assert is_march(problem)
    count = FEW.get(name, 5)
    watch, totals = stopping(count)
    early, whole = solve_march(problem, watch), solve_march(problem)
    (total,) = totals
    assert whole.stopped == ""
    assert early.code == INTERRUPTED
    assert early.stopped.startswith(f"After {count} ")
    assert early.stopped.endswith("which are kept, the calculation ended: it was interrupted.")
    reached, columns = rows(early.solution), rows(whole.solution)
    assert reached
    assert total is None or all(len(column) == total for column in columns.values())
    for word, column in reached.items():
        assert len(column) == count
        if total is not None:  # of a reduction the deepest contact comes first
            assert np.array_equal(column, columns[word][:count], equal_nan=True), word
    assert early.solution.validity
    for word, content in answers_of(solved(problem)).items():
        assert np.array_equal(getattr(whole.solution, word), content, equal_nan=True), word


@pytest.mark.parametrize("name", MARCHES)
def test_a_march_that_is_interrupted_before_its_first_state_has_no_answer(name):
    with pytest.raises(KeyboardInterrupt):
        solve_march(build(example_study(name)["problem"]), stopping(0)[0])


@pytest.mark.parametrize("name", ["impact", "adhesive_impact"])
def test_half_an_impact_has_no_restitution(name):
    problem = build(example_study(name)["problem"])
    half, whole = solve_march(problem, stopping(20)[0]).solution, problem.solve()
    assert np.isnan(half.restitution)
    assert half.duration == whole.duration == whole.time[-1]
    assert whole.restitution > 0.0


@pytest.mark.slow
def test_stages_of_half_an_impact_end_where_it_was_stopped():
    problem = build(example_study("impact")["problem"])
    whole = problem.solve()
    assert len(whole.stages) > 1
    for count in (2, 60, 150, problem.count - 1):
        half = solve_march(problem, stopping(count)[0]).solution
        assert half.stages[0].start == 0.0
        assert half.stages[-1].end == half.time[-1]
        for part, full in zip(half.stages[:-1], whole.stages, strict=False):
            assert part == full


def test_each_path_that_loses_energy_has_the_numbers_of_its_cycle():
    """A walk over the public problems: those that take a path, and answer with what was lost along it."""
    moved = {name: each for name, each in public_problems().items() if "path" in each.__dataclass_fields__}
    moved.pop("LinePlasticIndentation")  # a line has no depth, of which a cycle could have an amplitude
    answers = {name: hints_of(problem.solve) for name, problem in moved.items()}
    losing = {name for name, answer in answers.items() if any("dissipation" in word for word in names_of(answer))}
    assert len(losing) >= 10
    assert answers.keys() - losing == PLACED
    assert {name for name in losing if not issubclass(answers[name], Looped)} == PER_LENGTH
    assert all(issubclass(answers[name], Cycled) for name in PER_LENGTH)
