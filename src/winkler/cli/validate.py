"""``winkler validate``: run the literature cases and print the ledger."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Annotated, Any

import typer

from winkler.cli.results import verdict_json
from winkler.cli.streams import until_closed, write_json, write_line

if TYPE_CHECKING:
    from rich.table import Table

    from winkler.study.batch.points import ComparedNumber
    from winkler.study.ledger.ledger import LedgerEntry
    from winkler.study.ledger.ledger_page import LedgerChapter

NUMBER_MISSED = 1


def validate(
    cases: Annotated[
        list[str] | None, typer.Argument(help="Names of cases, case files or folders; all cases if left out.")
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Show the ledger as JSON.")] = False,
    as_markdown: Annotated[bool, typer.Option("--markdown", help="Show it as a page of the manual.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Show what was missed, and nothing else.")] = False,
) -> int:
    """Repeat published and independently computed numbers.

    Each case states how independent it is: analytical, cross-code, independent implementation, published table or
    measured. Exit code 1 if a number is missed.

    Example: winkler validate --json
    """
    from winkler.cli import terminal
    from winkler.study.ledger.ledger import case_files, ledger, remarks
    from winkler.study.ledger.ledger_page import markdown
    from winkler.values.errors import InvalidInput

    files = case_files(cases or ())
    if not files:
        raise InvalidInput("validate: there are no cases; give files or folders of them.")
    hidden = quiet or as_json or as_markdown
    entries = list(terminal.tracked(ledger(files), len(files), hidden=hidden))
    if as_json:
        write_json({"cases": [_json(entry) for entry in entries]})
    elif as_markdown:
        write_line(markdown(entries, "" if cases else remarks()), end="")
    else:
        _print([entry for entry in entries if not (quiet and entry.passed)], entries, quiet)
    return 0 if all(entry.passed for entry in entries) else NUMBER_MISSED


@until_closed()
def _print(selected: list[LedgerEntry], entries: list[LedgerEntry], quiet: bool) -> None:
    from winkler.cli import terminal
    from winkler.study.ledger.ledger_page import chapters

    out = terminal.console()
    parts = chapters(entries)
    for entry in selected:
        out.print(f"{entry.name} ({entry.grade}): {entry.title}", soft_wrap=True)
        out.print(f"  {entry.source}", soft_wrap=True)
        if entry.failure:
            out.print(f"  not solved: {entry.failure}", soft_wrap=True)
        if entry.verdicts:
            out.print(verdict_table(entry.verdicts, entry.points))
    if not quiet:
        out.print(_summary(parts))
        missed = sum(part.missed for part in parts)
        missed_text = f"{missed} missed" if missed else "none missed"
        out.print(f"{len(entries)} cases, {sum(part.numbers for part in parts)} numbers, {missed_text}.")


def _summary(parts: tuple[LedgerChapter, ...]) -> Table:
    """Return a table of all physics: cases, numbers, and which case agrees least."""
    from winkler.cli import terminal

    table = terminal.table("physics", "cases", "numbers", "missed", "fewest digits", "in")
    for part in parts:
        worst = part.worst
        counts = (str(len(part.entries)), str(part.numbers), str(part.missed))
        table.add_row(part.physics, *counts, f"{worst.digits:.1f}", f"{worst.name} ({worst.grade})")
    return table


def verdict_table(verdicts: Iterable[ComparedNumber], points: Iterable[str] = ()) -> Table:
    """Return a table of expected and computed numbers, with the points of a sweep as text."""
    from winkler.cli import terminal
    from winkler.study.ledger.ledger_page import digits, number_text, where

    table = terminal.table("quantity", "expected", "got", "digits", "tolerance", "")
    point_texts = iter(points)
    for verdict in verdicts:
        point = next(point_texts, "")
        item = verdict.expectation
        got, passed = number_text(verdict.got, item), "passed" if verdict.passed else "missed"
        digits_ = digits(verdict).removesuffix(" (missed)")
        table.add_row(
            where(item, point), number_text(item.expected, item), got, digits_, f"{item.tolerance:.0e}", passed
        )
    return table


def _json(entry: LedgerEntry) -> dict[str, Any]:
    return {
        "case": entry.name,
        "title": entry.title,
        "source": entry.source,
        "grade": entry.grade,
        "physics": entry.physics,
        "passed": entry.passed,
        "failure": entry.failure,
        "numbers": [
            verdict_json(verdict) | ({"point": point} if point else {})
            for verdict, point in zip(entry.verdicts, entry.points, strict=True)
        ],
    }
