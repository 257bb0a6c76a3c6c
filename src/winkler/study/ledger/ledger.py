"""The validation ledger: literature cases, run and compared.

A case is a study with ``[[expect]]``, a ``source`` and a ``grade``; those of the package lie in ``winkler/cases``.  A
case with ``[fit]`` fits a curve, and expects its fitted numbers; one with ``[function]`` evaluates a function of a
closed list.
"""

from __future__ import annotations

import dataclasses
import time
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

from winkler.errors import InvalidInput, WinklerError, suggest
from winkler.study.batch.outcome import ComparedNumber, Outcome
from winkler.study.batch.run import gather
from winkler.study.batch.sweep import solve_points
from winkler.study.language import keys
from winkler.study.language.reading import read_study
from winkler.study.language.study import GRADES
from winkler.study.language.varied import Axis
from winkler.study.ledger.fit_case import FitCase, fit_verdicts, is_fit, read_fit_case
from winkler.study.ledger.function_case import FunctionCase, function_verdicts, is_function, read_function_case
from winkler.study.ledger.physics import FITS, physics_of
from winkler.values import value

__all__ = ["CASES", "LedgerEntry", "case_files", "ledger", "remarks", "run_case"]

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
    if is_fit(path):
        return _fit_entry(path)
    if is_function(path):
        return _function_entry(path)
    study = read_study(path)
    _complete(path, study.source, study.grade, study.expect)
    entry = LedgerEntry(path.stem, study.title, study.source, study.grade, physics_of(study), (), ())
    try:
        outcome = gather(study, solve_points(study), started=time.perf_counter(), source=path.name)
    except WinklerError as error:
        return dataclasses.replace(entry, failure=str(error))
    failure = outcome.failed[0].reason if outcome.failed else ""
    return dataclasses.replace(entry, verdicts=outcome.verdicts, points=_points(outcome), failure=failure)


def _fit_entry(path: Path) -> LedgerEntry:
    case = read_fit_case(path)
    return _entry_of(path, case.study.title, case, FITS, lambda: fit_verdicts(case))


def _function_entry(path: Path) -> LedgerEntry:
    case = read_function_case(path)
    return _entry_of(path, case.title, case, case.function.physics, lambda: function_verdicts(case))


def _entry_of(
    path: Path,
    title: str,
    case: FitCase | FunctionCase,
    physics: str,
    verdicts: Callable[[], tuple[ComparedNumber, ...]],
) -> LedgerEntry:
    """Return the entry of a case that is no study."""
    _complete(path, case.source, case.grade, case.expect)
    if case.grade not in GRADES:
        raise InvalidInput(f"{path.name}: grade: '{case.grade}' is not known; give one of {', '.join(GRADES)}.")
    entry = LedgerEntry(path.stem, title, case.source, case.grade, physics, (), ())
    try:
        compared = verdicts()
    except WinklerError as error:
        return dataclasses.replace(entry, failure=str(error))
    return dataclasses.replace(entry, verdicts=compared, points=("",) * len(compared))


def _complete(path: Path, source: str, grade: str, expect: tuple[object, ...]) -> None:
    for key, content in (("source", source), ("grade", grade), ("[[expect]]", expect)):
        if not content:
            raise InvalidInput(f"{path.name}: a case needs {key}; add it, see `winkler show study`.")


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
