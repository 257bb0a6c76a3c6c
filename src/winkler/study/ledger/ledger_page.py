"""The ledger as a page of the manual: a table of all physics, then the numbers of each case."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from winkler.study.batch.points import ComparedNumber
from winkler.study.language.study import GRADES, Expectation
from winkler.study.ledger.ledger import LedgerEntry
from winkler.study.ledger.physics import CHAPTERS
from winkler.values.value import value

GRADE_MEANINGS = {
    "analytical": "a closed form, or an integral done at 30 digits",
    "cross-code": "a program of others",
    "independent implementation": "the same equations by a second program or formula of this project: it "
    "verifies the code, not the physics",
    "published table": "a number as it was printed",
    "measured": "an experiment",
}
"""Grade -> where its numbers come from."""


@value
class LedgerChapter:
    """The cases of one physics.

    Parameters
    ----------
    physics
        Its name.
    entries
        Its cases, in their order.
    """

    physics: str
    entries: tuple[LedgerEntry, ...]

    @property
    def numbers(self) -> int:
        """Number of expected numbers."""
        return sum(len(entry.verdicts) for entry in self.entries)

    @property
    def missed(self) -> int:
        """Number of those that do not agree, and of cases that failed."""
        wrong = sum(not verdict.passed for entry in self.entries for verdict in entry.verdicts)
        return wrong + sum(bool(entry.failure) for entry in self.entries)

    @property
    def worst(self) -> LedgerEntry:
        """The case whose digits agree least."""
        return min(self.entries, key=lambda entry: entry.digits)

    def count(self, grade: str) -> int:
        """Return the number of cases of a grade."""
        return sum(entry.grade == grade for entry in self.entries)

    def digits(self, grade: str) -> str:
        """Return the fewest digits that agree among the cases of a grade, as text; empty without one."""
        fewest = [entry.digits for entry in self.entries if entry.grade == grade]
        return f"{math.floor(10.0 * min(fewest)) / 10.0:.1f}" if fewest else ""


def chapters(entries: Iterable[LedgerEntry]) -> tuple[LedgerChapter, ...]:
    """Return the entries sorted by physics."""
    ordered = list(entries)
    every = ((physics, tuple(entry for entry in ordered if entry.physics == physics)) for physics in CHAPTERS)
    return tuple(LedgerChapter(physics, inside) for physics, inside in every if inside)


def where(expectation: Expectation, point: str = "") -> str:
    """Return the quantity, its place and the point of the sweep as text: ``pressure at r = 0 m``."""
    place = ", ".join(f"{name} = {number:.6g} m" for name, number in expectation.place)
    setting = ", ".join(part for part in (place, point) if part)
    return f"{expectation.quantity} at {setting}" if setting else expectation.quantity


def number_text(number: object, expectation: Expectation) -> str:
    """Return a number with its unit, or the first of several."""
    numbers = np.ravel(np.asarray(number, dtype=float))
    more = f" ... ({numbers.size})" if numbers.size > 1 else ""
    return f"{numbers[0]:.12g} {expectation.unit}".strip() + more


def digits(verdict: ComparedNumber) -> str:
    """Return the digits that agree as text; ``exact`` if all do."""
    if verdict.deviation == 0.0:
        return "exact"
    return f"{math.floor(10.0 * verdict.digits) / 10.0:.1f}" + ("" if verdict.passed else " (missed)")


def markdown(entries: Iterable[LedgerEntry], remarks: str = "") -> str:
    """Return the page of the manual that shows the ledger, with `remarks` at its end."""
    parts = chapters(entries)
    used = [grade for grade in GRADES if any(part.count(grade) for part in parts)]
    cases, numbers = sum(len(part.entries) for part in parts), sum(part.numbers for part in parts)
    missed = sum(part.missed for part in parts)
    lines = [
        "# Validation",
        "",
        "Every number below was taken from a source that does not depend on winkler, and is computed anew by",
        "`winkler validate`. This page is made by `winkler validate --markdown`.",
        "",
        f"{cases} cases, {numbers} numbers, {f'{missed} missed' if missed else 'none missed'}.",
        "*Digits* is how many decimal digits agree; the table shows the fewest of all cases of its kind. A published",
        "number has as many as were printed.",
        "",
        *_summary(parts, used),
        "",
        *(f"- *{grade.capitalize()}*: {GRADE_MEANINGS[grade]}." for grade in used),
    ]
    for part in parts:
        lines += ["", f"## {part.physics.capitalize()}"]
        for entry in part.entries:
            lines += _entry(entry)
    return "\n".join(lines) + "\n" + remarks


def _summary(parts: tuple[LedgerChapter, ...], used: list[str]) -> list[str]:
    heads = ["physics", "cases", "numbers", *(f"{grade}: cases, digits" for grade in used)]
    lines = [f"| {' | '.join(heads)} |", f"|{'---|' * len(heads)}"]
    for part in parts:
        by_grade = [f"{part.count(grade)}, {part.digits(grade)}" if part.count(grade) else "" for grade in used]
        cells = [part.physics, str(len(part.entries)), str(part.numbers), *by_grade]
        lines.append(f"| {' | '.join(cells)} |")
    return lines


def _entry(entry: LedgerEntry) -> list[str]:
    lines = ["", f"### {entry.title}", "", f"`{entry.name}`, {entry.grade}. Source: {entry.source}", ""]
    if entry.failure:
        lines += [f"Not solved: {entry.failure}", ""]
    if entry.verdicts:
        lines += ["| quantity | expected | got | digits | tolerance |", "|---|---|---|---|---|"]
    for verdict, point in zip(entry.verdicts, entry.points, strict=True):
        item = verdict.expectation
        cells = (where(item, point), number_text(item.expected, item), number_text(verdict.got, item), digits(verdict))
        lines.append(f"| {' | '.join(cells)} | {item.tolerance:.0e} |")
    return lines
