"""The answers of today beside the golden numbers (see `golden`): a part of them by default, the others slow or long.

By default these are a third of one example in four, and of the first seed of one group of histories in three.  Slow
tests compare the other thirds, a quarter of what takes little and the first seed of each other group, long ones the
rest.
"""

from __future__ import annotations

import hashlib
import math

import numpy as np
import pytest

from golden import (
    KEPT,
    NUMBERS,
    REARRANGED,
    RESIDUAL,
    Entry,
    Found,
    answered,
    difference,
    files,
    packed,
    questions,
    row_of,
    stored,
    unpacked,
)

STORED = list(stored())
QUICK = {key: entry for file, key, entry in STORED if not file.endswith("lasting")}
LASTING = {key: entry for file, key, entry in STORED if file.endswith("lasting")}
EXAMPLES = [key for key in QUICK if key.startswith("example/")]
HISTORIES = [key for key in QUICK if key.startswith("history/")]
SINGLE = sorted({key.partition("/")[0] for key in QUICK} - {"history"})
DEFAULT = [*EXAMPLES[::4], *HISTORIES[::3]]


def moved(key: str, rows: slice) -> list[str]:
    """Return one line for each number of a question that moved."""
    entry, asked = (QUICK | LASTING)[key], questions()[key]
    return [f"{key}: {line}" for row in range(len(asked))[rows] for line in entry.moved(row, answered(asked[row]))]


@pytest.mark.few(1)
@pytest.mark.parametrize("place", range(3))
def test_a_part_of_the_golden_numbers(place):
    assert [line for key in DEFAULT[place::3] for line in moved(key, slice(1))] == []


ONE_IN_FOUR = [
    pytest.param(0, marks=pytest.mark.slow),
    *(pytest.param(place, marks=pytest.mark.long) for place in (1, 2, 3)),
]


@pytest.mark.parametrize("section", SINGLE)
@pytest.mark.parametrize("place", ONE_IN_FOUR)
def test_examples_studies_and_cases(section, place):
    keys = [key for key in QUICK if key.startswith(f"{section}/")]
    assert [line for key in keys[place::4] for line in moved(key, slice(1))] == []


@pytest.mark.parametrize("engine", sorted({key.split("/")[1] for key in HISTORIES}))
@pytest.mark.parametrize("place", ONE_IN_FOUR)
def test_histories(engine, place):
    keys = [key for key in HISTORIES if key.split("/")[1] == engine]
    assert [line for key in keys for line in moved(key, slice(place + 1, None, 4))] == []


@pytest.mark.slow
def test_the_first_seed_of_histories_that_take_longer():
    assert [line for key in LASTING if key.startswith("history/") for line in moved(key, slice(1))] == []


@pytest.mark.long
@pytest.mark.parametrize("key", LASTING)
def test_what_takes_longer(key):
    assert moved(key, slice(None)) == []


def test_nothing_is_edited_only_added():
    lines = (NUMBERS / "SHA256SUMS").read_text(encoding="ascii").splitlines()
    sums = dict(reversed(line.split("  ")) for line in lines)
    assert {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in files()} == sums


def test_each_entry_has_its_question_and_each_group_of_histories_twenty_seeds():
    asked = questions()
    assert [key for _, key, _ in STORED if key not in asked] == []
    assert {key: len(entry.rows) for _, key, entry in STORED} == {key: len(asked[key]) for _, key, _ in STORED}
    groups = [key for _, key, _ in STORED if key.startswith("history/")]
    assert len(groups) >= 100
    assert {len(asked[key]) for key in groups} == {20}


def test_what_is_allowed_is_stated_by_its_class():
    for _, key, entry in STORED:
        assert entry.kind in "RMW", key
        assert all(error == 0.0 for error in entry.error) == (entry.kind == "R"), key
        assert max(entry.error) <= 0.1, key
        assert (entry.kind == "W") == ("doi:" in entry.source or "derivation" in entry.source), key
        assert max(entry.rounding.values(), default=0.0) <= max(RESIDUAL, *entry.error), key
        counted = {name for one in entry.over.items() for name in (one[0], *one[1])}
        assert all(counted <= row.keys() for row in entry.rows if counted), key


PATH = {"force": np.linspace(1.0, 2.0, 9), "shift": np.array([0.0, 1e-9, -3e-9]), "end": np.array([math.inf, math.nan])}


def entry_of(kind: str, error: float) -> Entry:
    return unpacked(packed(Entry(kind, [row_of(PATH), "OutsideValidity"], [error])))


@pytest.mark.parametrize("name", ["force", "shift"])
def test_a_number_that_changed_is_found(name):
    entry = entry_of("R", 0.0)
    assert entry.moved(0, Found(PATH, 0.0)) == []
    changed = PATH[name].copy()
    changed[-1] *= 1.0 + 1e-9
    [line] = entry.moved(0, Found(PATH | {name: changed}, 0.0))
    assert name in line
    for kind in "MW":
        assert entry_of(kind, 1e-3).moved(0, Found(PATH | {name: changed}, 0.0)) == []
        assert len(entry_of(kind, 1e-12).moved(0, Found(PATH | {name: changed}, 0.0))) == 1


def test_a_difference_counts_over_other_quantities_where_they_are_named():
    content = {"force": np.array([0.0, 5.0]), "shift": np.array([0.0, 4.0]), "loss": np.array([0.0, 1.0])}
    entry = unpacked(packed(Entry("W", [row_of(content)], [1e-3], over={"loss": ["force", "shift"]})))
    assert entry.moved(0, Found(content | {"loss": np.array([0.0, 1.01])}, 0.0)) == []
    [line] = entry.moved(0, Found(content | {"loss": np.array([0.0, 1.04])}, 0.0))
    assert "loss moved by 2.00e-03" in line


def test_a_stored_number_that_was_perturbed_is_found():
    key = next(key for key in EXAMPLES if QUICK[key].kind == "R" and not QUICK[key].rounding)
    found = answered(questions()[key][0])
    for name, numbers in QUICK[key].rows[0].items():
        if not any(number != 0.0 for number in numbers):
            continue
        perturbed = QUICK[key].rows[0] | {name: [(1.0 + 1e-9) * number for number in numbers]}
        assert len(QUICK[key]._replace(rows=[perturbed]).moved(0, found)) == 1, name


def test_a_number_that_is_gone_another_count_and_an_answer_that_was_refused_are_found():
    entry = entry_of("R", 0.0)
    assert entry.moved(0, Found({name: PATH[name] for name in ("force", "shift")}, 0.0)) == ["row 0: end is gone"]
    assert difference(row_of(PATH)["force"], PATH["force"][:3]) == math.inf
    assert difference([1.0, math.nan], np.array([1.0, 2.0])) == math.inf
    assert difference([1.0, math.inf], np.array([1.0, -math.inf])) == math.inf
    assert len(entry.moved(0, "OutsideValidity")) == 1
    assert entry.moved(1, "OutsideValidity") == []
    assert len(entry.moved(1, Found(PATH, 0.0))) == 1


def test_rounding_of_a_cancellation_counts_over_the_greatest_of_its_path():
    stored_ = row_of(PATH)["shift"]
    near_zero = np.array([1e-22, 1e-9, -3e-9])
    assert difference(stored_, near_zero) < REARRANGED
    assert difference(stored_, near_zero + np.array([1e-20, 0.0, 0.0])) > REARRANGED
    assert len(row_of(PATH)["force"]) == KEPT
