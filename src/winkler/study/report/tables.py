"""The tables of the report: the inputs, the answers, the failures, the expected numbers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import numpy as np

from winkler.plot.series import middle_scale, name_in_words
from winkler.study.batch.events import EVENTS, Event
from winkler.study.batch.outcome import Outcome, ResultColumn
from winkler.study.batch.points import ComparedNumber
from winkler.study.language import keys
from winkler.study.report.archive import CSV, rows_of
from winkler.study.report.describe import Input, content_label, in_words, inputs, settings_text
from winkler.study.report.headline.loops import LOOP_HEADS, loop_rows, loops_title
from winkler.study.report.headline.section import headline_section
from winkler.study.report.headline.summary import contact_summary
from winkler.study.report.markup import number, safe, section, table, with_fixed_units
from winkler.study.report.mathml import symbol
from winkler.values.readable import with_unit

MOST_ROWS = 24
"""Longer tables are cut in the middle; the CSV file holds all rows."""


def question_section(outcome: Outcome) -> str:
    """Return the study in words."""
    return section("The problem", f'<p class="lead">{with_fixed_units(in_words(outcome.study))}</p>')


def input_section(outcome: Outcome) -> str:
    """Return the table of what was given."""
    return section("Inputs", table(["what", "", "given", "meaning"], given_rows(inputs(outcome.study))))


def given_rows(given_inputs: Iterable[Input]) -> list[str]:
    """Return the rows of a table of inputs, under the names of its groups."""
    rows, group = [], None
    for given in given_inputs:
        if given.group != group:
            group = given.group
            rows.append(f'<tr class="group"><td colspan="4">{safe(group)}</td></tr>')
        rows.append(
            f"<tr><td>{safe(given.name)}</td><td>{symbol(given.symbol) if given.name else ''}</td>"
            f'<td class="{"value" if len(given.text) < 30 else "wrap"}">{safe(given.text)}</td>'
            f'<td class="text small">{safe(given.meaning if given.meaning != given.name else "")}</td></tr>'
        )
    return rows


def answer_section(outcome: Outcome) -> str:
    """Return the answers: large numbers and a list for one load, a table for many."""
    columns = outcome.readable_table()
    rows = len(columns[0].content)
    if rows == 1:
        return section("Results", headline_section(outcome), _single(columns), _events(outcome))
    cut = ""
    if rows > MOST_ROWS:
        half = MOST_ROWS // 2
        cut = f"<p class='small'>{rows} rows, of which the first and last {half} are shown; {CSV} holds all.</p>"
    parts = (headline_section(outcome), _many(columns, outcome), cut, _events(outcome), _indices(outcome))
    return section("Results", *parts)


def contact_section(outcome: Outcome) -> str:
    """Return the summary of an answer: what was asked, and the contact in the numbers that are compared in design."""
    rows = [
        f'<tr><td>{safe(one.name)}</td>{number(safe(one.text))}<td class="text small">{safe(one.remark)}</td></tr>'
        for one in contact_summary(outcome)
    ]
    return section("Summary", table(["what", "#value", "where, and compared with what"], rows)) if rows else ""


def loops_section(outcome: Outcome) -> str:
    """Return the loops of a path with their losses, stiffnesses and loss factors; empty with fewer than two."""
    rows = ["<tr>" + "".join(number(safe(text)) for text in row) + "</tr>" for row in loop_rows(outcome)]
    return section(safe(loops_title(outcome)), table([f"#{head}" for head in LOOP_HEADS], rows)) if rows else ""


def _indices(outcome: Outcome) -> str:
    """Return the table of the indices of Sobol; empty if there are none."""
    rows = []
    for one in outcome.indices:
        for place, axis in enumerate(outcome.study.axes):
            cells = [
                number(f"{level[place] + 0.0:.3f}".replace("-", "−"))
                + number(f"{low[place] + 0.0:.3f} … {high[place] + 0.0:.3f}".replace("-", "−"))
                for level, low, high in (
                    (one.first_order, one.first_order_low, one.first_order_high),
                    (one.total_order, one.total_order_low, one.total_order_high),
                )
            ]
            head = f"<td>{safe(name_in_words(one.answer))}</td><td>{safe(axis.key.removeprefix('problem.'))}</td>"
            rows.append(f"<tr>{head}{''.join(cells)}</tr>")
    if not rows:
        return ""
    heads = ["answer", "varied", f"#alone {symbol('S_i')}", "#95 %", f"#with the others {symbol('S_{Ti}')}", "#95 %"]
    return f"<h3>How much of the scatter each key makes</h3>{table(heads, rows)}"


def _events(outcome: Outcome) -> str:
    """Return the tables of jumps, branches and limits; nothing if there are none."""
    parts = []
    for name, title in EVENTS.items():
        point_rows = rows_of(outcome, name)
        rows = [[*event] for _, events in point_rows for event in events]
        where = [settings_text(outcome.study, point.settings) for point, events in point_rows for _ in events]
        if not rows:
            continue
        swept = ["point"] if outcome.study.sweep else []
        heads, cells = zip(*_event_columns(rows), strict=True)
        lines = [
            "<tr>" + (f"<td>{safe(point)}</td>" if swept else "") + "".join(row) + "</tr>"
            for row, point in zip(list(zip(*cells, strict=True))[:MOST_ROWS], where, strict=False)
        ]
        more = (
            f"<p class='small'>… and {len(rows) - MOST_ROWS} more; {name}.csv holds all.</p>"
            if len(rows) > MOST_ROWS
            else ""
        )
        parts.append(f"<h3>{safe(title)}</h3>{table([*swept, *heads], lines)}{more}")
    return "".join(parts)


def _event_columns(rows: list[list[Event]]) -> Iterator[tuple[str, list[str]]]:
    """Yield the head and the cells of each column of a table of events; texts that are all empty are left out."""
    for column in zip(*rows, strict=True):
        name, entry = safe(name_in_words(column[0].name)), column[0].word
        if isinstance(column[0].content, str):
            if any(one.content for one in column):
                yield name, [f"<td>{safe(str(one.content))}</td>" for one in column]
            continue
        numbers = [float(one.content) for one in column]
        scale = middle_scale(entry.unit, numbers)
        unit = f"<br>[{safe(scale.unit)}]" if scale.unit else ""
        yield f"#{name}{unit}", [_cell(one, scale.factor) for one in numbers]


def _single(columns: tuple[ResultColumn, ...]) -> str:
    rows = []
    for column in columns:
        content = column.content[0]
        text = with_unit(float(content), column.word.unit, 7) if column.word.unit is not None else str(content)
        rows.append(
            f"<tr><td>{safe(name_in_words(column.name))}</td><td>{symbol(column.word.symbol)}</td>"
            f'{number(safe(text))}<td class="text small">{safe(column.word.meaning)}</td></tr>'
        )
    return table(["answer", "", "#value", "meaning"], rows)


def _many(columns: tuple[ResultColumn, ...], outcome: Outcome) -> str:
    swept = [axis.key for axis in outcome.study.sweep]
    given = [column.content for column in columns if column.name in swept]
    shown_columns = [
        column
        for column in columns
        if column.name != "failure"
        and (column.name in swept or not any(_same(column.content, content) for content in given))
    ]
    heads, bodies = [], []
    for column in shown_columns:
        name = name_in_words(column.name.rpartition(".")[2])
        if column.word.unit is None:
            heads.append(safe(name))
            named = _labels(outcome, column.name)
            bodies.append([f"<td>{safe(named.get(str(item), item))}</td>" for item in column.content])
            continue
        scale = middle_scale(column.word.unit, column.content)
        unit = f"<br>[{safe(scale.unit)}]" if scale.unit else ""
        heads.append(f"#{safe(name)} {symbol(column.word.symbol)}{unit}")
        bodies.append([_cell(float(item), scale.factor) for item in column.content])
    rows = ["<tr>" + "".join(cells) + "</tr>" for cells in zip(*bodies, strict=True)]
    if len(rows) > MOST_ROWS:
        half = MOST_ROWS // 2
        rows = [*rows[:half], f'<tr class="cut"><td colspan="{len(heads)}">…</td></tr>', *rows[-half:]]
    return table(heads, rows)


def _labels(outcome: Outcome, key: str) -> dict[str, str]:
    """Return label in the table -> label in the report, of a varied key without numbers."""
    unit = outcome.word(key).unit
    return {
        keys.label(item, unit): content_label(item, unit)
        for axis in outcome.study.axes
        if axis.key == key
        for item in axis.values
    }


def _same(content: np.ndarray, given: np.ndarray) -> bool:
    """Return whether an answer repeats a varied key, wherever there is an answer."""
    if content.dtype != given.dtype or content.dtype.kind != "f":
        return False
    finite = np.isfinite(content)
    return bool(np.array_equal(content[finite], given[finite]))


def _cell(content: float, factor: float) -> str:
    # adding zero turns minus zero into zero
    return number("—" if np.isnan(content) else with_unit(content / factor + 0.0, "", 6))


def failures(outcome: Outcome) -> str:
    """Return the points without an answer or with a part of it, and why; nothing if there are none."""
    stopped = [point for point in outcome.solved if point.stopped]
    if not stopped:
        return _without(outcome)
    reasons = [(settings_text(outcome.study, point.settings), point.stopped) for point in stopped[:MOST_ROWS]]
    return section("Where the calculation ended early", reason_list(reasons, MOST_ROWS, CSV)[0]) + _without(outcome)


def _without(outcome: Outcome) -> str:
    if not outcome.failed:
        return ""
    lead = f"<p>{len(outcome.failed)} of {len(outcome.points)} points have no answer:</p>"
    reasons = [(settings_text(outcome.study, point.settings), point.reason) for point in outcome.failed]
    return section("Points without an answer", lead, *reason_list(reasons, MOST_ROWS, CSV))


def reason_list(reasons: Sequence[tuple[str, str]], most_shown: int, file: str) -> tuple[str, str]:
    """Return a list of places and reasons, cut after `most_shown`, and a line that names the `file` with all."""
    items = "".join(
        f"<li>{safe(f'{where}: ' if where else '')}{safe(reason)}</li>" for where, reason in reasons[:most_shown]
    )
    more = len(reasons) - most_shown
    return f"<ul>{items}</ul>", f"<p class='small'>… and {more} more; {file} holds all.</p>" if more > 0 else ""


def expected(outcome: Outcome) -> str:
    """Return expected and computed numbers, missed ones first; empty if there are none."""
    settings = {point.index: point.settings for point in outcome.points} if outcome.study.sweep else {}
    where = [settings_text(outcome.study, settings[verdict.index]) if settings else "" for verdict in outcome.verdicts]
    return expected_section(zip(outcome.verdicts, where, strict=True))


def expected_section(verdicts: Iterable[tuple[ComparedNumber, str]]) -> str:
    """Return expected and computed numbers with the point or curve of each, missed ones first; empty without any."""
    ranked = sorted(verdicts, key=lambda pair: pair[0].passed)
    if not ranked:
        return ""
    missed = sum(not verdict.passed for verdict, _ in ranked)
    lead = f"{len(ranked) - missed} of {len(ranked)} expectations were met."
    if len(ranked) > MOST_ROWS:
        lead += f" The first {MOST_ROWS} are shown, those that were missed first."
    heads = ["what", "", "#expected", "#came out", "#deviation", "#allowed"]
    rows = [_verdict(*pair) for pair in ranked[:MOST_ROWS]]
    return section("Expected values", f"<p>{lead}</p>", table(heads, rows))


def _verdict(verdict: ComparedNumber, point: str) -> str:
    item = verdict.expectation
    unit = item.unit
    where = ", ".join(f"{name} = {with_unit(place, 'm')}" for name, place in item.place)
    what = _quantity_text(item.quantity) + (f" at {where}" if where else "")
    what += f", {point}" if point else ""
    cells = [
        f"<td>{safe(what)}</td>",
        f"<td>{'as expected' if verdict.passed else '<strong>missed</strong>'}</td>",
        number(safe(_some(item.expected, unit))),
        number(safe(_some(verdict.got, unit))),
        number(f"{verdict.deviation:.2g}"),
        number(f"{item.tolerance:.2g}"),
    ]
    return f"<tr>{''.join(cells)}</tr>"


def _quantity_text(quantity: str) -> str:
    """Return the name of a quantity in words, with its index among many answers."""
    base, _, number = quantity.rpartition(".")
    if not number.removeprefix("-").isdecimal():
        return name_in_words(quantity)
    return f"{name_in_words(base)} ({'last' if number == '-1' else f'number {number}'})"


def _some(content: Any, unit: str | None) -> str:
    numbers = np.ravel(np.asarray(content, dtype=float))
    return with_unit(float(numbers[0]), unit, 7) + (
        f" … {with_unit(float(numbers[-1]), unit, 7)}" if numbers.size > 1 else ""
    )
