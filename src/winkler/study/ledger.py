"""The validation ledger: literature cases, run and judged.

A case is a study with ``[[expect]]``, a ``source`` and a ``grade``; those of the package lie in ``winkler/cases``.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterable, Iterator
from pathlib import Path

import numpy as np

from winkler.errors import InvalidInput, WinklerError, suggest
from winkler.study.outcome import Verdict
from winkler.study.reading import read_study
from winkler.study.run import gather
from winkler.study.study import GRADES, Expectation
from winkler.study.sweep import solve_points
from winkler.values import value

__all__ = ["CASES", "Entry", "case_files", "examined", "ledger", "markdown", "shown", "where"]

CASES = Path(__file__).parent.parent / "cases"
"""The folder of the cases that come with the package."""


@value
class Entry:
    """One case of the ledger.

    Parameters
    ----------
    name
        Name of the case file without its ending.
    title, source, grade
        What the case says about itself.
    verdicts
        On every expectation, in the order of the file.
    failure
        The sentence of the error if the case could not be run; empty otherwise.
    """

    name: str
    title: str
    source: str
    grade: str
    verdicts: tuple[Verdict, ...]
    failure: str = ""

    @property
    def passed(self) -> bool:
        """Whether every number came out."""
        return not self.failure and all(verdict.passed for verdict in self.verdicts)

    @property
    def digits(self) -> float:
        """The fewest digits that agree among its numbers."""
        return min((verdict.digits for verdict in self.verdicts), default=0.0)


def case_files(names: Iterable[str] = ()) -> list[Path]:
    """Return the case files that `names` ask for: names of cases of the package, files, or folders; all without names.

    Raises
    ------
    InvalidInput
        If there is no such case.
    """
    known = {path.stem: path for path in sorted(CASES.glob("*.toml"))}
    found: list[Path] = []
    for name in names:
        path = Path(name)
        if name in known:
            found.append(known[name])
        elif path.is_dir():
            inside = sorted(path.glob("*.toml"))
            if not inside:
                raise InvalidInput(f"validate: the folder '{name}' holds no case (*.toml).")
            found += inside
        elif path.is_file():
            found.append(path)
        else:
            raise InvalidInput(
                f"validate: '{name}' is no case{suggest(name, known)}; give a case, a file or a folder of them."
            )
    return found or list(known.values())


def examined(path: Path) -> Entry:
    """Run one case.

    Raises
    ------
    InvalidInput
        If the file is no case: it cannot be read, or lacks source, grade or expectations.
    """
    study = read_study(path)
    for key, content in (("source", study.source), ("grade", study.grade), ("[[expect]]", study.expect)):
        if not content:
            raise InvalidInput(f"{path.name}: a case needs {key}; add it, `winkler show study` tells how.")
    try:
        outcome = gather(study, solve_points(study), started=time.perf_counter(), source=path.name)
    except WinklerError as error:
        return Entry(path.stem, study.title, study.source, study.grade, (), str(error))
    failure = outcome.failed[0].reason if outcome.failed else ""
    return Entry(path.stem, study.title, study.source, study.grade, outcome.verdicts, failure)


def ledger(paths: Iterable[Path]) -> Iterator[Entry]:
    """Yield the entries of the ledger as the cases are run."""
    yield from map(examined, paths)


def where(expectation: Expectation) -> str:
    """Return the quantity and its place as text: ``pressure at r = 0 m``."""
    place = ", ".join(f"{name} = {number:.6g} m" for name, number in expectation.place)
    return f"{expectation.quantity} at {place}" if place else expectation.quantity


def shown(number: object, expectation: Expectation) -> str:
    """Return a number with its unit, or the first of several."""
    numbers = np.ravel(np.asarray(number, dtype=float))
    more = f" ... ({numbers.size})" if numbers.size > 1 else ""
    return f"{numbers[0]:.12g} {expectation.unit}".strip() + more


def markdown(entries: Iterable[Entry]) -> str:
    """Return the page of the manual that shows the ledger."""
    found = list(entries)
    numbers = sum(len(entry.verdicts) for entry in found)
    lines = [
        "# Validation",
        "",
        "Every number below was taken from a source that does not depend on winkler, and is computed anew by",
        "`winkler validate`. This page is made by `winkler validate --markdown`.",
        "",
        f"{len(found)} cases, {numbers} numbers. *Digits* is how many decimal digits agree.",
    ]
    for grade in GRADES:
        chosen = [entry for entry in found if entry.grade == grade]
        if not chosen:
            continue
        lines += ["", f"## {grade.capitalize()}"]
        for entry in chosen:
            lines += ["", f"### {entry.title}", "", f"`{entry.name}`. Source: {entry.source}", ""]
            if entry.failure:
                lines += [f"Not answered: {entry.failure}", ""]
            if entry.verdicts:
                lines += ["| quantity | expected | got | digits | tolerance |", "|---|---|---|---|---|"]
            for verdict in entry.verdicts:
                asked = verdict.expectation
                cells = (where(asked), shown(asked.expected, asked), shown(verdict.got, asked), digits(verdict))
                lines.append(f"| {' | '.join(cells)} | {asked.tolerance:.0e} |")
    return "\n".join(lines) + "\n"


def digits(verdict: Verdict) -> str:
    """Return the digits that agree as text; ``exact`` if all do."""
    if verdict.deviation == 0.0:
        return "exact"
    return f"{math.floor(10.0 * verdict.digits) / 10.0:.1f}" + ("" if verdict.passed else " (missed)")
