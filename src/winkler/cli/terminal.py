"""Output of the commands: tables with fitting prefixes, notes, and a progress bar with the time left."""

from __future__ import annotations

import contextlib
import logging
import math
import sys
from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from winkler.cli.streams import safe
from winkler.values.readable import scale_of, with_readable_numbers
from winkler.values.validity import Standing, in_words

if TYPE_CHECKING:
    from rich.console import Console
    from rich.status import Status
    from rich.table import Table
    from rich.text import Text

    from winkler.study.batch.fit_outcome import FitOutcome
    from winkler.study.batch.outcome import Outcome, ResultColumn
    from winkler.study.nanoindentation.running import NanoindentationOutcome

T = TypeVar("T")
WrittenColumn = tuple[str, str, list[str]]
"""Name, unit and texts of a column."""

MOST_ROWS = 24
"""Longer tables are cut in the middle."""
MOST_NAMES = 6
"""Names of what has no answer for one reason; longer lists are cut."""
WIDE_COLUMNS = 160
"""Columns of text where the output is no terminal."""
UNLIMITED = 10_000
"""Columns of text in which a table is measured."""


def console(*, stderr: bool = False) -> Console:
    """Return a console that writes texts as they are, except for control characters."""
    from rich.console import Console

    class Safe(Console):
        """Every text passes here, those in cells of tables too."""

        def render_str(self, text: str, **how: Any) -> Text:
            return super().render_str(safe(text), **how)

        def on_broken_pipe(self) -> None:
            """Leave to `read_or_not` what happens when the reader has gone; rich would end the process with code 1."""
            raise BrokenPipeError

    stream = sys.stderr if stderr else sys.stdout
    return Safe(stderr=stderr, markup=False, highlight=False, width=None if stream.isatty() else WIDE_COLUMNS)


def table(*headings: str) -> Table:
    """Return an empty table with a rule below its headings."""
    from rich import box
    from rich.table import Table

    return Table(*headings, box=box.SIMPLE_HEAD)


def _column_texts(column: ResultColumn, empty: np.ndarray) -> tuple[str, list[str]]:
    """Return the unit and the texts of a column; `empty` are rows without any answer."""
    if column.content.dtype.kind not in "fiu":
        return "", [str(item) for item in column.content]
    scale = scale_of(column.word.unit, column.content)
    numbers = (float(number / scale.factor) + 0.0 for number in column.content)
    return scale.unit, [
        _number(number, "-" if bare else "undefined") for number, bare in zip(numbers, empty, strict=True)
    ]


def _number(number: float, undefined: str) -> str:
    if math.isfinite(number):
        return f"{number:.6g}"
    return undefined if math.isnan(number) else f"{'-' * (number < 0.0)}infinite"


def answers(outcome: Outcome, out: Console) -> None:
    """Show the answers: a list for one load, a table for many."""
    from winkler.study.chapters.contents import answer_of
    from winkler.study.language.explain import plain_symbol

    swept = [axis.key for axis in outcome.study.sweep]
    answered = [column for column in outcome.readable_table() if column.name != "failure"]  # the reasons stand below
    swept_contents = [column.content for column in answered if column.name in swept]
    columns = [
        column
        for column in answered
        if column.name in swept or not any(np.array_equal(column.content, content) for content in swept_contents)
    ]
    numbers = [column.content for column in answered if column.content.dtype.kind == "f" and column.name not in swept]
    empty = np.all(np.isnan(numbers), axis=0) if numbers else np.zeros(len(answered[0].content), dtype=bool)
    formatted = [_column_texts(column, empty) for column in columns]
    rows = len(columns[0].content)
    if rows == 1:
        shown = table("quantity", "symbol", "value", "unit", "meaning")
        for column, (unit, texts) in zip(columns, formatted, strict=True):
            word = column.word
            shown.add_row(column.name, plain_symbol(word.symbol), texts[0], unit, word.meaning)
        out.print(shown)
        return
    written = [(column.name, unit, texts) for column, (unit, texts) in zip(columns, formatted, strict=True)]
    leads, later = [each for each in written if each[0] in swept], [each for each in written if each[0] not in swept]
    if not swept and rows > 2:  # a history: its greatest numbers stand below it
        ends = [_greatest(column.content, texts) for column, (_, texts) in zip(columns, formatted, strict=True)]
        later = [(name, unit, [*texts, end]) for (name, unit, texts), end in zip(written, ends, strict=True)]
        leads = [("", "", [""] * rows + ["greatest"]), later.pop(0)]
    if _width(_many([*leads, *later]), out) > out.width:
        sought = answer_of(outcome.study.problem).headline
        later.sort(key=lambda each: each[0] not in sought)
    for block in _blocks(leads, later, out):
        out.print(_many(block))


def _greatest(content: np.ndarray, texts: list[str]) -> str:
    """Return the text of the number that is farthest from zero; empty where there is none."""
    if content.dtype.kind not in "fiu" or not np.any(np.isfinite(content)):
        return ""
    return texts[int(np.argmax(np.where(np.isfinite(content), np.abs(content), -1.0)))]


def _blocks(leads: list[WrittenColumn], columns: list[WrittenColumn], out: Console) -> Iterator[list[WrittenColumn]]:
    """Yield columns in blocks as wide as the terminal, one below the other; each begins with `leads`."""
    block: list[WrittenColumn] = []
    for each in columns:
        if block and _width(_many([*leads, *block, each]), out) > out.width:
            yield [*leads, *block]
            block = []
        block.append(each)
    yield [*leads, *block]


def _many(columns: list[WrittenColumn]) -> Table:
    """Return a table of many loads."""
    shown = table()
    for key, unit, _ in columns:
        name = key.removeprefix("problem.")
        shown.add_column(f"{name}\n[{unit}]" if unit else name, justify="left" if not unit else "right")
    add_rows(shown, [texts for _, _, texts in columns])
    return shown


def _width(shown: Table, out: Console) -> int:
    from rich.measure import Measurement

    return Measurement.get(out, out.options.update(max_width=UNLIMITED), shown).maximum


def add_rows(shown: Table, columns: list[list[str]]) -> None:
    """Fill a table; a long one is cut in the middle."""
    rows = len(columns[0])
    for row, texts in enumerate(zip(*columns, strict=True)):
        if rows > MOST_ROWS and row == MOST_ROWS // 2:
            shown.add_row("...")
        if rows <= MOST_ROWS or row < MOST_ROWS // 2 or row >= rows - MOST_ROWS // 2:
            shown.add_row(*texts)


def indices(outcome: Outcome, out: Console) -> None:
    """Show the indices of Sobol of each answer for every key, if the study requests them."""
    if not outcome.indices:
        return
    out.print("How much of the scatter each key makes, alone and with the others (indices of Sobol, 95 % intervals):")
    shown = table("answer", "varied", "alone", "with the others")
    for one in outcome.indices:
        for place, axis in enumerate(outcome.study.axes):
            first = one.first_order[place], one.first_order_low[place], one.first_order_high[place]
            total = one.total_order[place], one.total_order_low[place], one.total_order_high[place]
            levels = (f"{level:.3f} ({low:.3f} to {high:.3f})" for level, low, high in (first, total))
            shown.add_row(one.answer, axis.key.removeprefix("problem."), *levels)
    out.print(shown)


def notes(
    outcome: Outcome | FitOutcome | NanoindentationOutcome, out: Console, questions: tuple[str, ...] = ()
) -> None:
    """Show questions about unlikely numbers, what may be done with the answer, and the notes, the worst first."""
    for question in questions:
        out.print(question, soft_wrap=True)
    if outcome.validity:
        out.print(f"How far this can be trusted: {in_words(outcome.validity)}.")
    order = list(Standing)
    for note in sorted(outcome.validity, key=lambda one: -order.index(one.standing)):
        out.print(f"  {in_words((note,))}: {with_readable_numbers(note.statement)}", soft_wrap=True)


def failures(failed: Iterable[tuple[str, str]], what: str, out: Console) -> None:
    """Show why there is no answer, each reason once, behind the names of those that it holds for.

    Parameters
    ----------
    failed
        Name and reason.
    what
        How many there are, such as "of 12 curves".
    out
        The terminal.
    """
    named: dict[str, list[str]] = {}
    for name, reason in failed:
        named.setdefault(reason, []).append(name)
    if not named:
        return
    out.print(f"{sum(map(len, named.values()))} {what} have no answer:")
    for reason, names in named.items():
        more = f" and {len(names) - MOST_NAMES} more" if len(names) > MOST_NAMES else ""
        out.print(f"  {', '.join(names[:MOST_NAMES])}{more}: {reason}", soft_wrap=True)


def marching(*, hidden: bool) -> Callable[[Iterable[T], int | None], Iterator[T]]:
    """Return a function that shows a bar over the points of a path; of a single one, what its solver says."""

    def watch(points: Iterable[T], total: int | None) -> Iterator[T]:
        if hidden or total != 1 or not sys.stderr.isatty():
            yield from tracked(points, total, hidden=hidden, doing="marching")
            return
        with one_line(console(stderr=True)) as show, heard(show):
            yield from points

    return watch


class _LiveText:
    """A text that is computed whenever it is drawn."""

    def __init__(self, text: Callable[[], str]) -> None:
        self.text = text

    def __rich__(self) -> str:
        return self.text()


def tracked(
    points: Iterable[T],
    total: int | None,
    *,
    hidden: bool,
    doing: str | Callable[[], str] = "solving",
    before: int = 0,
) -> Iterator[T]:
    """Yield `points` under a bar with the time left, on stderr; no bar if `hidden` or if stderr is no terminal.

    Parameters
    ----------
    points
        The items that arrive one by one.
    total
        Their number; None if unknown: then the bar counts.
    hidden
        Whether nothing is shown.
    doing
        Text beside the bar; of a single point only if it is a function, whose text may change.
    before
        Number of those that are already known: they do not count in the time left.
    """
    alone = total is not None and total < 2
    if hidden or (alone and not callable(doing)) or not sys.stderr.isatty():
        yield from points
        return
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        RenderableColumn,
        SpinnerColumn,
        TextColumn,
        TimeElapsedColumn,
        TimeRemainingColumn,
    )

    text = RenderableColumn(_LiveText(doing)) if callable(doing) else TextColumn("{task.description}")
    bar = (text, BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    one = (SpinnerColumn(), text, TimeElapsedColumn())
    with Progress(*(one if alone else bar), console=console(stderr=True), transient=True) as progress:
        task = progress.add_task("" if callable(doing) else doing, total=total, completed=before)
        for number, point in enumerate(points):
            yield point
            if number >= before:
                progress.advance(task)


SOLVERS = "winkler"
"""Name of the logger."""


class _Listener(logging.Handler):
    """Hands messages on."""

    def __init__(self, show: Callable[[str], None]) -> None:
        super().__init__(logging.INFO)
        self.show = show

    def emit(self, record: logging.LogRecord) -> None:
        self.show(record.getMessage())


@contextlib.contextmanager
def heard(show: Callable[[str], None]) -> Iterator[None]:
    """Show what solvers of this process say."""
    logger, listener = logging.getLogger(SOLVERS), _Listener(show)
    level = logger.level
    logger.addHandler(listener)
    logger.setLevel(logging.INFO)
    try:
        yield
    finally:
        logger.removeHandler(listener)
        logger.setLevel(level)


@contextlib.contextmanager
def one_line(out: Console) -> Iterator[Callable[[str], None]]:
    """Give a function that shows the last message in one line, which vanishes at the end; sentences stay."""
    status: Status | None = None

    def show(text: str) -> None:
        nonlocal status
        if text.endswith("."):
            out.print(text, soft_wrap=True)
        elif status is None:
            status = out.status(text)
            status.start()
        else:
            status.update(text)

    try:
        yield show
    finally:
        if status is not None:
            status.stop()
