"""What fuzz tests found, tried again in every run; and that a fault of each sort would be found."""

from __future__ import annotations

import json
import time
import warnings
from random import Random

import fuzz_cases
import fuzz_laws
import fuzz_studies
import numpy as np
import pytest
from fuzz_cases import FOUND, Case, check, fault
from fuzz_trials import tried, written

import winkler as wk
from winkler.study.language.build import build
from winkler.study.language.explain import completed
from winkler.values.errors import InvalidInput

FILES = sorted(FOUND.glob("*.json"))


@pytest.mark.parametrize("file", FILES, ids=[file.stem for file in FILES])
def test_a_case_that_was_found(file):
    content = json.loads(file.read_text(encoding="utf-8"))
    assert content.pop("why")
    assert fault(tried, Case(**content)) == ""


@pytest.mark.few(1)
@pytest.mark.parametrize("problem", ["indentation", "pull_off", "tangential", "thermal_constriction", "rolling"])
def test_a_few_studies_are_solved(problem, tmp_path, monkeypatch):
    monkeypatch.setenv("WINKLER_FUZZ_SEED", "of every run")
    check(problem, 4, lambda rng: Case("solve", written(fuzz_studies.solvable(rng, problem))), tried, tmp_path)


def test_most_variations_are_solved():
    """What is refused as input shows nothing of the laws."""
    solved = 0
    for place in range(60):
        try:
            build(fuzz_studies.solvable(Random(place), "indentation")["problem"])
            solved += 1
        except wk.WinklerError:
            pass
    assert solved > 30


def spin(case: Case) -> None:
    begun = time.process_time()
    while time.process_time() - begun < 10.0:
        pass


def raising(error: Exception):
    def trial(case: Case) -> None:
        raise error

    return trial


@pytest.mark.parametrize(
    ("trial", "reason"),
    [
        (raising(ZeroDivisionError("x")), "ZeroDivisionError: x"),
        (raising(InvalidInput("no full stop")), "unclear: no full stop"),
        (lambda case: warnings.warn("escaped", stacklevel=1), "UserWarning: escaped"),
        (lambda case: np.array([1e308]) * 10.0, "RuntimeWarning: overflow"),
        (lambda case: np.ones(2**29), "MemoryError"),
        (spin, "hangs: "),
    ],
    ids=["raw exception", "unclear sentence", "warning", "numpy", "memory", "hang"],
)
def test_a_fault_is_found(trial, reason, monkeypatch, tmp_path):
    monkeypatch.setattr(fuzz_cases, "LIMIT", 0.05)
    with fuzz_cases.within_memory():
        assert reason in fault(trial, Case("text", ""))
    monkeypatch.setenv("WINKLER_FUZZ_SEED", "of a day")
    with pytest.raises(AssertionError, match=r"(?s)1 of 1 cases of 'some'; WINKLER_FUZZ_SEED='of a day' repeats them"):
        check("some", 1, lambda rng: Case("text", str(rng.random())), trial, tmp_path)
    (file,) = tmp_path.glob("*.json")
    assert reason in json.loads(file.read_text(encoding="utf-8"))["why"]


SPOILT = {
    "no number is undefined": ("indentation", {"radius": np.nan}),
    "what is pressed, moved and stored is finite": ("indentation", {"force": np.inf}),
    "lengths, losses and resistances are not negative": ("thermal_constriction", {"resistance": -1.0}),
    "time, distances, losses and wear never fall": ("tangential", {"dissipation": lambda row: row[::-1]}),
    "shares and restitution lie between nothing and all": ("impact", {"restitution": 1.001}),
    "the contact is not wider than the profile is known": ("indentation", {"radius": 0.0101}),
    "what sticks is part of the contact": ("tangential", {"stick_radius": 1e-3}),
    "bodies that do not stick only push": ("indentation", {"force": -1.0}),
    "friction carries at most its coefficient times the force": ("tangential", {"shear_force": 60.1}),
    "a contact that widens stores at most half of force times depth": ("indentation", {"energy": 1.2e-4}),
    "a contact that widens is at least as stiff as its chord": ("indentation", {"stiffness": 4e7}),
    "what is stored is not negative": ("tangential", {"stored_energy": lambda row: -row}),
    "nothing is lost or stored that nobody put in": ("tangential", {"dissipation": lambda row: 1e4 * row}),
    "an impact keeps its energy": ("adhesive_impact", {"balance": lambda row: 1.001 * row}),
    "the hottest place is not colder than the mean": (
        "indentation",
        {"first_max_temperature": 1.0, "first_mean_temperature": 2.0},
    ),
    "conductance is one over resistance": ("constriction", {"conductance": 1.0}),
    "bounds stand on both sides": ("conductance_bounds", {"least_stiffness": 4e7}),
    "a rough contact covers at most its square": ("rough_contact", {"area": np.array([1.0])}),
    "sliding and rolling cost work": ("elastomer_friction", {"coefficient": np.array([-1e-3])}),
    "every remark is a sentence of one line": ("indentation", {"validity": ("one\ntwo",)}),
}


def test_every_law_is_shown_to_fail():
    assert set(SPOILT) == set(fuzz_laws.LAWS)


@pytest.mark.parametrize("sentence", SPOILT)
def test_a_broken_law_is_stated(sentence):
    name, wrong = SPOILT[sentence]
    answer = build(completed({"kind": name})).solve()
    numbers = fuzz_laws.numbers_of(answer)
    assert fuzz_laws.broken_by(numbers, answer.problem) == []
    spoilt = {key: new(numbers[key]) if callable(new) else new for key, new in wrong.items()}
    assert sentence in fuzz_laws.broken_by(numbers | spoilt, answer.problem)
