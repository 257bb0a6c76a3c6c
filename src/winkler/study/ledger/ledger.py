"""The validation ledger: literature cases, run and compared.

A case is a study with ``[[expect]]``, a ``source`` and a ``grade``; those of the package lie in ``winkler/cases``.  A
case with ``[fit]`` fits a curve, and expects its fitted numbers; one with ``[function]`` evaluates a function of a
closed list.

Literature cases that fit a curve: a study with ``[fit]``, and ``[[expect]]`` for its fitted numbers.

The quantity of an expectation is the key of a free number, ``problem.bed.medium.first.young``.
"""

from __future__ import annotations

import dataclasses
import time
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from winkler.study.batch.fit_outcome import Fitted
from winkler.study.batch.fit_run import fit_study
from winkler.study.batch.outcome import Outcome
from winkler.study.batch.points import ComparedNumber
from winkler.study.batch.run import gather
from winkler.study.batch.sweep import solve_points
from winkler.study.batch.verdicts import deviation
from winkler.study.language import keys
from winkler.study.language.compared.expectations import expectations
from winkler.study.language.fit_reading import parse_fit_study
from winkler.study.language.fit_study import FitStudy
from winkler.study.language.reading import parsed, read_study, read_text
from winkler.study.language.study import GRADES, Expectation, Study
from winkler.study.language.varied import Axis
from winkler.study.ledger.function_case import FunctionCase, function_verdicts, read_function_case
from winkler.study.ledger.physics import FITS, physics_of
from winkler.study.nanoindentation.reading import NanoindentationStudy, read_nanoindentation_study
from winkler.study.nanoindentation.running import evaluated_files, gathered, read_references
from winkler.values.errors import InvalidInput, WinklerError, suggest
from winkler.values.value import value

CASES = Path(__file__).parents[2] / "cases"
"""The folder of the cases that come with the package."""


@value
class LedgerEntry:
    """One case of the ledger.

    Parameters
    ----------
    name
        Name of the case file without its ending.
    title, source, grade
        As the case states them.
    physics
        The chapter it belongs to.
    verdicts
        On every expectation, in the order of the file, point after point of a sweep.
    points
        For every verdict the point of the sweep it stands for, as text; empty texts without a sweep.
    failure
        The sentence of the error if the case could not be run; empty otherwise.
    """

    name: str
    title: str
    source: str
    grade: str
    physics: str
    verdicts: tuple[ComparedNumber, ...]
    points: tuple[str, ...]
    failure: str = ""

    @property
    def passed(self) -> bool:
        """Whether every number agrees."""
        return not self.failure and all(verdict.passed for verdict in self.verdicts)

    @property
    def digits(self) -> float:
        """The fewest digits that agree among its numbers."""
        return min((verdict.digits for verdict in self.verdicts), default=0.0)


def case_files(names: Iterable[str] = ()) -> list[Path]:
    """Return the case files of `names`: names of cases of the package, files, or folders; all without names.

    Raises
    ------
    InvalidInput
        If there is no such case.
    """
    cases = {path.stem: path for path in sorted(CASES.glob("*.toml"))}
    files: list[Path] = []
    for name in names:
        path = Path(name)
        if name in cases:
            files.append(cases[name])
        elif path.is_dir():
            inside = sorted(path.glob("*.toml"))
            if not inside:
                raise InvalidInput(f"validate: the folder '{name}' holds no case (*.toml).")
            files += inside
        elif path.is_file():
            files.append(path)
        else:
            raise InvalidInput(
                f"validate: '{name}' is no case{suggest(name, cases)}; give a case, a file or a folder of them."
            )
    return files or list(cases.values())


def run_case(path: Path) -> LedgerEntry:
    """Run one case.

    Raises
    ------
    InvalidInput
        If the file is no case: it cannot be read, or lacks source, grade or expectations.
    """
    sections = parsed(read_text(path), path.name)
    if "fit" in sections:
        fitted = read_fit_case(path)
        return _entry(path, fitted, FITS, lambda: _at_no_points(fit_verdicts(fitted)))
    if "function" in sections:
        evaluated = read_function_case(path)
        return _entry(path, evaluated, evaluated.function.physics, lambda: _at_no_points(function_verdicts(evaluated)))
    if "indentation" in sections or "calibration" in sections:
        indented = read_nanoindentation_study(path)
        return _entry(path, indented, FITS, lambda: _of_nanoindentation(indented))
    study = read_study(path)
    return _entry(path, study, physics_of(study), lambda: _of_study(study, path.name))


def _entry(
    path: Path,
    case: Study | FitCase | FunctionCase | NanoindentationStudy,
    physics: str,
    results: Callable[[], dict[str, Any]],
) -> LedgerEntry:
    """Return the entry of a case, with the fields that `results` computes."""
    for key, content in (("source", case.source), ("grade", case.grade), ("[[expect]]", case.expect)):
        if not content:
            raise InvalidInput(
                f"{path.name}: a case needs {key}; add it, see `winkler show study`. A study that is no case is "
                "checked by `winkler run` or `winkler fit`, before it is solved."
            )
    if case.grade not in GRADES:
        raise InvalidInput(f"{path.name}: grade: '{case.grade}' is not known; give one of {', '.join(GRADES)}.")
    entry = LedgerEntry(path.stem, case.title, case.source, case.grade, physics, (), ())
    try:
        return dataclasses.replace(entry, **results())
    except WinklerError as error:
        return dataclasses.replace(entry, failure=str(error))


def _of_study(study: Study, file: str) -> dict[str, Any]:
    outcome = gather(study, solve_points(study), started=time.perf_counter(), source=file)
    failure = outcome.failed[0].reason if outcome.failed else ""
    return {"verdicts": outcome.verdicts, "points": _points(outcome), "failure": failure}


def _of_nanoindentation(study: NanoindentationStudy) -> dict[str, Any]:
    found = read_references(study) if study.calibrates else evaluated_files(study)
    pairs = gathered(study, found, started=time.perf_counter()).verdicts
    return {"verdicts": tuple(one for one, _ in pairs), "points": tuple(name for _, name in pairs)}


def _at_no_points(verdicts: tuple[ComparedNumber, ...]) -> dict[str, Any]:
    return {"verdicts": verdicts, "points": ("",) * len(verdicts)}


def _points(outcome: Outcome) -> tuple[str, ...]:
    """Return the point of the sweep that each verdict stands for: ``poisson = 0.25``."""
    settings = {point.index: point.settings for point in outcome.points}
    texts = []
    for verdict in outcome.verdicts:
        pairs = zip(outcome.study.axes, settings[verdict.index], strict=True)
        texts.append(", ".join(_setting_text(outcome, axis, content) for axis, content in pairs))
    return tuple(texts)


def _setting_text(outcome: Outcome, axis: Axis, content: object) -> str:
    """Return the value of a key as text: a number with its unit, or the index of the value."""
    name = axis.key.rpartition(".")[2]
    if isinstance(content, int | float):
        unit = keys.word_at(outcome.study.problem, axis.key.removeprefix("problem.")).unit or ""
        return f"{name} = {content:.6g} {unit}".strip()
    return f"{name} {axis.values.index(content) + 1} of {len(axis.values)}"


def ledger(paths: Iterable[Path]) -> Iterator[LedgerEntry]:
    """Yield the entries of the ledger as the cases are run."""
    yield from map(run_case, paths)


def remarks() -> str:
    """Return the remarks on the ledger of the package as a whole, in Markdown."""
    return (CASES / "remarks.md").read_text(encoding="utf-8")


class FitCase(NamedTuple):
    """A study with ``[fit]``, its expected numbers, and their source."""

    study: FitStudy
    source: str
    grade: str
    expect: tuple[Expectation, ...]

    @property
    def title(self) -> str:
        """Title of the study."""
        return self.study.title


def read_fit_case(path: Path) -> FitCase:
    """Read a case with ``[fit]``.

    Raises
    ------
    InvalidInput
        With one sentence for every mistake.
    """
    import tomli_w

    raw = parsed(read_text(path), path.name)
    source, grade = str(raw.pop("source", "")), str(raw.pop("grade", ""))
    expected = expectations(raw.pop("expect", []), path.name)
    study = parse_fit_study(tomli_w.dumps(raw), file=path.name, folder=path.parent)
    free = [line.key for line in study.free]
    for item in expected:
        if item.quantity not in free:
            raise InvalidInput(
                f"{path.name}: expect asks for '{item.quantity}', which is not free; give one of {', '.join(free)}."
            )
    return FitCase(study, source, grade, expected)


def fit_verdicts(case: FitCase) -> tuple[ComparedNumber, ...]:
    """Return the verdicts on the fitted numbers of a case, curve by curve.

    Raises
    ------
    InvalidInput, NotConverged, OutsideValidity
        If no curve can be fitted.
    """
    paths = {line.key: line.path for line in case.study.free}
    verdicts = []
    for place, result in enumerate(fit_study(case.study).results):
        for item in case.expect:
            got = result.fit.value(paths[item.quantity]) if isinstance(result, Fitted) else np.nan
            verdicts.append(ComparedNumber((place,), item, got, deviation(got, item)))
    return tuple(verdicts)
