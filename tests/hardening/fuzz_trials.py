"""What a case is tried by: a study is read, or solved and checked; a file, a formula, a quantity is read."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Callable
from pathlib import Path

import fuzz_laws
import tomli_w
from fuzz_cases import Case
from fuzz_readers import READERS

from winkler.numerics.equations.expression import Expression
from winkler.profiles.formula import Formula
from winkler.study.language.reading import parse_study, read_study
from winkler.study.language.writing import study_text
from winkler.values.units import quantity

TRIALS: dict[str, Callable[[Case], object]] = {}


def trial(name: str):
    """Enter a trial under the first word of its cases' names."""

    def enter(made):
        TRIALS[name] = made
        return made

    return enter


def tried(case: Case) -> object:
    """Try a case by the trial that its name begins with."""
    return TRIALS[case.trial.partition(" ")[0]](case)


def written(table) -> str:
    """Return a study as TOML; an empty text for what TOML cannot say."""
    try:
        return tomli_w.dumps(table)
    except (TypeError, ValueError, AttributeError, RecursionError):
        return ""


@trial("text")
def _text(case: Case) -> None:
    """A study is read, and comes back from its text."""
    study = parse_study(case.content, file="study.toml")
    again = parse_study(study_text(study), file="study.toml")
    assert again == study, "the study does not come back from its text"


@trial("bytes")
def _bytes(case: Case) -> None:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "study.toml"
        path.write_bytes(case.bytes)
        read_study(path)


@trial("solve")
def _solve(case: Case) -> None:
    """A study is solved, its numbers are computed, and the laws hold for them."""
    study = parse_study(case.content)
    assert parse_study(study_text(study)) == study, "the study does not come back from its text"
    answer = study.problem.solve()
    assert (wrong := fuzz_laws.broken(answer)) == [], f"broken: {'; '.join(wrong)}"


@trial("file")
def _file(case: Case) -> None:
    """A file with a suffix is read: the name is that of the trial, the suffix, and that of the reader."""
    _, suffix, name = case.trial.split(" ", 2)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"any{'' if suffix == '-' else suffix}"
        path.write_bytes(case.bytes)
        READERS[name][0](path)


@trial("formula")
def _formula(case: Case) -> None:
    constants = {name: value for name, value in (("R", 0.01), ("c", 2.5)) if name in case.content}
    try:
        law = Expression(case.content, constants)
        assert all(part.shape == (3,) for part in law.taylor([0.0, 1e-3, 1.0]))
    finally:
        shape = Formula(case.content, **constants)
        assert all(row.shape == (2,) for row in (shape.height([0.0, 1e-3]), shape.gap([0.0, 1e-3])))


@trial("quantity")
def _quantity(case: Case) -> None:
    unit, _, text = case.content.partition("\n")
    assert math.isfinite(quantity(text, unit, what="x")), "a quantity is not finite"
