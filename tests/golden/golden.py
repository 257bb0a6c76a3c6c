"""Golden numbers: what winkler answered before its engines were rearranged, and how an answer of today is compared.

The numbers are no reference of correctness.  They come from the code under test and say only that nothing moved;
closed forms, cases and laws test whether an answer is right.

An entry has a class, which was fixed when its numbers were gathered:

- **R**, rearranged: closed forms, transforms, springs by gap.  The same to `REARRANGED` = 1e-12.
- **M**, march: stepped, iterated or fitted within an error that the problem allows (its `tolerance`), or that a
  constant of its module names.  The same to twice that error, by which both may err.
- **W**, wrong before: an independent number, its tolerance and its source, in place of what was answered.

A difference counts over the greatest magnitude of its quantity along the path, over loads or points: a number that
passes through zero is rounded as its neighbours are.  The last digits depend on processor and number of threads.  So
numbers are gathered twice, with all instructions of the processor and with the fewest (`gather.py`).  Where a quantity
differs between both by more than a tenth of what is allowed (a cancellation, an inverse, the place of an extremum), the
difference is stored as its `rounding`, and ten times that is allowed.  What differs by more than `RESIDUAL`, or by more
than the error of a march, is the residual of an equation or a sum that vanishes, and is not stored.  Nor are numbers
that state the error of others.
"""

from __future__ import annotations

import dataclasses
import functools
import json
import math
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import winkler as wk
from winkler.fitting.generalised import SETTLED_ERRORS
from winkler.study.batch.fit_run import fit_study
from winkler.study.batch.outcome import answers_of
from winkler.study.batch.points import Solved
from winkler.study.batch.run import run
from winkler.study.language.build import build
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.explain import example_study
from winkler.study.language.fit_reading import read_fit_study
from winkler.study.language.fit_study import FitStudy
from winkler.study.language.reading import parsed, read_study, read_text
from winkler.study.ledger.ledger import case_files, read_fit_case, run_case

NUMBERS = Path(__file__).parent / "numbers"
FORMER = Path(__file__).parent / "former"
"""The examples of kinds of version 0.2, which other kinds answer today."""
STUDIES = Path(__file__).parents[2] / "examples" / "studies"
REARRANGED, MARGIN, RESIDUAL = 1e-12, 10.0, 1e-5
KEPT = 4
"""Numbers of a longer array that are stored, evenly spaced, the last among them."""

Answers = dict[str, np.ndarray]
Row = dict[str, list[float]] | str
"""The numbers that are stored of one solution, or the class of the error with which it is refused."""

ONCE_SAID = {"damping_ratio": ("loss_factor", 0.5)}
"""Numbers that said in other words what another one says: that one, and which part of it they were."""


class Found(NamedTuple):
    """The numbers of today, and the error that they state: zero of what is neither stepped nor iterated."""

    answers: Answers
    error: float


def allowed_error(problem: Any) -> float:
    """Return the error that a problem allows, itself or a problem that it rests on; zero where none does."""
    parts = [getattr(problem, field.name) for field in dataclasses.fields(problem)] if is_value(problem) else []
    own = getattr(problem, "tolerance", 0.0)
    return max([float(own) if isinstance(own, float) else 0.0, *map(allowed_error, filter(is_value, parts))])


def is_value(item: Any) -> bool:
    """Return whether an object is a problem, a bed, a medium or a part of them."""
    return dataclasses.is_dataclass(item) and not isinstance(item, type)


def states_an_error(name: str) -> bool:
    """Return whether a number states the error of others: `tests/laws/test_stated_errors.py` judges those."""
    return name.endswith("_error") or name == "uncertainty"


def found_in(solved: Iterable[tuple[Any, Any]]) -> Found:
    """Return the numbers of solutions, those of one after those of the other; pairs of problem and solution."""
    pairs = list(solved)
    columns = [answers_of(solution) for _, solution in pairs]
    names = dict.fromkeys(name for one in columns for name in one if not states_an_error(name))
    answers = {name: np.concatenate([np.ravel(one[name]) for one in columns if name in one]) for name in names}
    return Found(answers, max(allowed_error(problem) for problem, _ in pairs))


def example(kind: str) -> Found:
    """Return the numbers of the example of a kind of problem."""
    problem = build(example_study(kind)["problem"])
    return found_in([(problem, problem.solve())])


def study(path: Path) -> Found:
    """Return the numbers of a study, a fit or a case."""
    sections = parsed(read_text(path), path.name)
    if {"indentation", "calibration"} & set(sections):
        return _nanoindentation(path)
    if "fit" in sections:
        return _fitted(read_fit_study(path) if path.is_relative_to(STUDIES) else read_fit_case(path).study)
    if "function" in sections:
        return Found({f"{place}": np.ravel(one.got) for place, one in enumerate(run_case(path).verdicts)}, 0.0)
    points = [point for point in run(read_study(path)).points if isinstance(point, Solved)]
    return found_in((point.problem, point.solution) for point in points)


def _fitted(fits: FitStudy) -> Found:
    columns = {one.name: one.content for one in fit_study(fits).table() if one.content.dtype.kind == "f"}
    shares = [np.abs(columns[f"{free.key}_error"] / columns[free.key]) for free in fits.free]
    columns = {name: content for name, content in columns.items() if not states_an_error(name)}
    return Found(columns, SETTLED_ERRORS * float(np.nanmax(shares)))


def _nanoindentation(path: Path) -> Found:
    from winkler.study.nanoindentation.reading import read_nanoindentation_study
    from winkler.study.nanoindentation.running import evaluated_files, gathered, read_references

    given = read_nanoindentation_study(path)
    outcome = gathered(given, read_references(given) if given.calibrates else evaluated_files(given), started=0.0)
    solutions = [*(one.solution for one in outcome.evaluated), *outcome.calibration]
    return found_in((given, solution) for solution in solutions)


def row_of(answers: Answers, kept: int = KEPT) -> dict[str, list[float]]:
    """Return the numbers that are stored."""
    return {
        name: [float(number) for number in content[_places(content.size, kept)]] for name, content in answers.items()
    }


def _places(size: int, kept: int) -> np.ndarray:
    """Return where numbers are kept: all, or so many evenly spaced ones."""
    return np.arange(size) if size <= kept else np.round(np.arange(1, kept + 1) * (size - 1) / kept).astype(int)


def greatest(numbers: np.ndarray) -> float:
    """Return the greatest magnitude of those that are finite."""
    return float(np.max(np.abs(numbers[np.isfinite(numbers)]), initial=0.0))


def difference(stored: list[float], found: np.ndarray, whole: float | None = None) -> float:
    """Return the greatest difference over the greatest of the found numbers, or what else it counts over; infinite
    where there is another count.
    """
    now, before = found[_places(found.size, max(len(stored), 1))], np.array(stored, dtype=float)
    if now.shape != before.shape or np.any(np.isfinite(now) != np.isfinite(before)):
        return float("inf")
    finite = np.isfinite(before)
    if not np.array_equal(now[~finite], before[~finite], equal_nan=True):
        return float("inf")
    apart = float(np.max(np.abs(now[finite] - before[finite]), initial=0.0))
    whole = greatest(found) if whole is None else whole
    return apart / whole if whole > 0.0 else float("inf") if apart > 0.0 else 0.0


class Entry(NamedTuple):
    """What is stored of one question, row by row where seeds stand for rows.

    Parameters
    ----------
    kind
        R, M or W.
    rows
        The stored numbers of each row.
    error
        Of each row the stated error, one number where all have the same; of class W the tolerance of its number.
    rounding
        By which quantities differ between two kinds of arithmetic, where it is more than a tenth of the allowed.
    source
        Of class W: where the independent number comes from.
    over
        Quantities whose error a march states over others, an energy over force and shift: those, whose greatest are
        multiplied.
    """

    kind: str
    rows: list[Row]
    error: list[float]
    rounding: dict[str, float] = {}  # noqa: RUF012
    source: str = ""
    over: dict[str, list[str]] = {}  # noqa: RUF012

    def allowed(self, row: int, name: str) -> float:
        """Return the difference that is allowed."""
        stated = self.error[row % len(self.error)] * (2.0 if self.kind == "M" else 1.0)  # both answers err by it
        return max(REARRANGED, stated, MARGIN * self.rounding.get(name, 0.0))

    def moved(self, row: int, found: Found | str) -> list[str]:
        """Return one line for each quantity that is not what it was."""
        stored = self.rows[row]
        if isinstance(found, str) or isinstance(stored, str):
            return [] if found == stored else [f"row {row}: it was {stored!s:.40}, and is {found!s:.40}"]
        answers = found.answers | {
            name: part * found.answers[other]
            for name, (other, part) in ONCE_SAID.items()
            if other in found.answers and name not in found.answers
        }
        gone = [f"row {row}: {name} is gone" for name in stored if name not in answers]
        each = {
            name: difference(stored[name], answers[name], math.prod(greatest(answers[one]) for one in counted))
            for name in stored
            if answers.keys() >= {name, *(counted := self.over.get(name, [name]))}
        }
        return gone + [
            f"row {row}: {name} moved by {apart:.2e}, class {self.kind} allows {self.allowed(row, name):.1e}"
            for name, apart in each.items()
            if apart > self.allowed(row, name)
        ]


def answered(question: Callable[[], Found]) -> Found | str:
    """Return the numbers of today, or the class of the error with which the question is refused."""
    try:
        return question()
    except wk.WinklerError as error:
        return type(error).__name__


def files() -> list[Path]:
    """The files of numbers, the oldest first."""
    return sorted(NUMBERS.glob("*.json"), key=lambda path: int(path.name.partition("-")[0]))


@functools.cache
def entries(path: Path) -> dict[str, Entry]:
    """Return the entries of a file."""
    raw = json.loads(path.read_text(encoding="utf-8"))
    return {key: unpacked(content) for key, content in raw.items()}


def stored() -> Iterator[tuple[str, str, Entry]]:
    """Yield file, question and entry; of a question that was asked again, as class W or anew, the last one."""
    latest = {key: (path, entry) for path in files() for key, entry in entries(path).items()}
    for key, (path, entry) in latest.items():
        yield path.stem, key, entry


def unpacked(content: dict[str, Any]) -> Entry:
    """Return an entry from what is stored of it."""
    names = content.pop("names")
    rows = [one if isinstance(one, str) else dict(zip(names, one, strict=True)) for one in content.pop("rows")]
    return Entry(rows=rows, **content)


def packed(entry: Entry) -> dict[str, Any]:
    """Return an entry as it is stored, its names once for all rows."""
    first = next((row for row in entry.rows if not isinstance(row, str)), {})
    rows = [row if isinstance(row, str) else [row[name] for name in first] for row in entry.rows]
    more = {name: part for name in ("rounding", "source", "over") if (part := getattr(entry, name))}
    return {"kind": entry.kind, "error": entry.error, "names": list(first), "rows": rows, **more}


@functools.cache
def questions() -> dict[str, list[Callable[[], Found]]]:
    """Return what can be asked: name -> its rows."""
    from histories import GROUPS, SEEDS, history

    asked: dict[str, list[Callable[[], Found]]] = {
        f"example/{kind}": [functools.partial(example, kind)] for kind in CATALOGUE["problem"]
    }
    asked |= {f"example/{path.stem}": [functools.partial(study, path)] for path in sorted(FORMER.glob("*.toml"))}
    for path in sorted(STUDIES.rglob("*.toml")):
        asked[f"study/{path.relative_to(STUDIES).as_posix()}"] = [functools.partial(study, path)]
    asked |= {f"case/{path.stem}": [functools.partial(study, path)] for path in case_files()}
    for name in GROUPS:
        asked[f"history/{name}"] = [functools.partial(history, name, seed) for seed in range(SEEDS)]
    return asked
