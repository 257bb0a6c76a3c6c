"""The tables of the report: what was asked, what came out, what has no answer, what was expected."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from winkler.plot.series import middle_scale, spoken, told
from winkler.study.batch.events import EVENTS
from winkler.study.batch.outcome import Column, Outcome, Verdict
from winkler.study.language import keys
from winkler.study.report.archive import CSV
from winkler.study.report.describe import Input, content_label, in_words, inputs, setting_told
from winkler.study.report.event_rows import found_in
from winkler.study.report.markup import kept, number, safe, section, table
from winkler.study.report.mathml import symbol

__all__ = ["answered", "asked", "expected", "failures", "given_rows", "reason_list", "settings_told"]

ROWS = 24
"""Longer tables are cut in the middle; the CSV file holds all rows."""
CARDS = ("force", "depth", "radius", "stiffness", "shift", "shear_force")
"""What stands in large letters at the top, if it was answered."""


def asked(outcome: Outcome) -> str:
    """Return the study in words, and the table of what was given."""
    given_table = table(["what", "", "given", "meaning"], given_rows(inputs(outcome.study)))
    return section("What was asked", f'<p class="lead">{kept(in_words(outcome.study))}</p>', given_table)


def given_rows(given_inputs: Iterable[Input]) -> list[str]:
    """Return the rows of a table of what was given, under the names of its groups."""
    rows, group = [], None
    for given in given_inputs:
        if given.group != group:
            group = given.group
            rows.append(f'<tr class="group"><td colspan="4">{safe(group)}</td></tr>')
        rows.append(
            f"<tr><td>{safe(given.name)}</td><td>{symbol(given.symbol) if given.name else ''}</td>"
            f'<td class="{"value" if len(given.told) < 30 else "wrap"}">{safe(given.told)}</td>'
            f'<td class="text small">{safe(given.meaning if given.meaning != given.name else "")}</td></tr>'
        )
    return rows


def answered(outcome: Outcome) -> str:
    """Return what came out: large numbers and a list for one load, a table for many."""
    columns = outcome.table()
    rows = len(columns[0].content)
    if rows == 1:
        return section("What came out", _cards(outcome), _single(columns), _events(outcome))
    cut = ""
    if rows > ROWS:
        cut = f"<p class='small'>{rows} rows, of which the first and last {ROWS // 2} are shown; {CSV} holds all.</p>"
    return section("What came out", _many(columns, outcome), cut, _events(outcome), _indices(outcome))


def _indices(outcome: Outcome) -> str:
    """Return the table of how much of the scatter of each answer every key makes; nothing if it was not asked."""
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
            head = f"<td>{safe(spoken(one.answer))}</td><td>{safe(axis.key.removeprefix('problem.'))}</td>"
            rows.append(f"<tr>{head}{''.join(cells)}</tr>")
    if not rows:
        return ""
    heads = ["answer", "varied", f"#alone {symbol('S_i')}", "#95 %", f"#with the others {symbol('S_{Ti}')}", "#95 %"]
    return f"<h3>How much of the scatter each key makes</h3>{table(heads, rows)}"


def _events(outcome: Outcome) -> str:
    """Return the tables of jumps, branches and limits; nothing if there are none."""
    parts = []
    for name, title in EVENTS.items():
        found = found_in(outcome, name)
        rows = [[*event] for _, events in found for event in events]
        where = [settings_told(outcome, point.settings) for point, events in found for _ in events]
        if not rows:
            continue
        scales = [
            middle_scale(column[0].word.unit, [one.content for one in column]) for column in zip(*rows, strict=True)
        ]
        swept = ["point"] if outcome.study.sweep else []
        heads = [
            f"#{safe(one.name.replace('_', ' '))}" + (f"<br>[{safe(scale.unit)}]" if scale.unit else "")
            for one, scale in zip(rows[0], scales, strict=True)
        ]
        lines = [
            "<tr>"
            + (f"<td>{safe(told_by)}</td>" if swept else "")
            + "".join(_cell(one.content, scale.factor) for one, scale in zip(row, scales, strict=True))
            + "</tr>"
            for row, told_by in zip(rows[:ROWS], where, strict=False)
        ]
        more = f"<p class='small'>… and {len(rows) - ROWS} more; {name}.csv holds all.</p>" if len(rows) > ROWS else ""
        parts.append(f"<h3>{safe(title)}</h3>{table([*swept, *heads], lines)}{more}")
    return "".join(parts)


def _cards(outcome: Outcome) -> str:
    cards = []
    for name in CARDS:
        if name in outcome.answers:
            entry, number = outcome.word(name), float(outcome.answer(name).ravel()[0])
            cards.append(
                f'<div class="card"><div class="value">{safe(told(number, entry.unit))}</div>'
                f'<div class="name">{safe(spoken(name))} {symbol(entry.symbol)}</div></div>'
            )
    return f'<div class="cards">{"".join(cards)}</div>'


def _single(columns: tuple[Column, ...]) -> str:
    rows = []
    for column in columns:
        content = column.content[0]
        text = told(float(content), column.word.unit, 7) if column.word.unit is not None else str(content)
        rows.append(
            f"<tr><td>{safe(spoken(column.name))}</td><td>{symbol(column.word.symbol)}</td>"
            f'{number(safe(text))}<td class="text small">{safe(column.word.meaning)}</td></tr>'
        )
    return table(["answer", "", "#value", "meaning"], rows)


def _many(columns: tuple[Column, ...], outcome: Outcome) -> str:
    swept = [axis.key for axis in outcome.study.sweep]
    given = [column.content for column in columns if column.name in swept]
    shown = [
        column
        for column in columns
        if column.name != "failure"
        and (column.name in swept or not any(_same(column.content, content) for content in given))
    ]
    heads, bodies = [], []
    for column in shown:
        name = spoken(column.name.rpartition(".")[2])
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
    if len(rows) > ROWS:
        half = ROWS // 2
        rows = [*rows[:half], f'<tr class="cut"><td colspan="{len(heads)}">…</td></tr>', *rows[-half:]]
    return table(heads, rows)


def _labels(outcome: Outcome, key: str) -> dict[str, str]:
    """Return what the table says -> what the report says, of a varied key that takes no numbers."""
    return {
        keys.label(item): content_label(item) for axis in outcome.study.axes if axis.key == key for item in axis.values
    }


def _same(content: np.ndarray, given: np.ndarray) -> bool:
    """Return whether an answer repeats what was given, wherever there is an answer."""
    if content.dtype != given.dtype or content.dtype.kind != "f":
        return False
    known = np.isfinite(content)
    return bool(np.array_equal(content[known], given[known]))


def _cell(content: float, factor: float) -> str:
    # adding zero turns minus zero into zero
    text = "—" if np.isnan(content) else f"{content / factor + 0.0:.6g}".replace("-", "−").replace("inf", "infinite")
    return number(text)


def settings_told(outcome: Outcome, settings: Iterable[Any]) -> str:
    """Return the values of the varied keys at one point."""
    pairs = zip(outcome.study.sweep, settings, strict=True)
    return ", ".join(setting_told(outcome.study, axis, content) for axis, content in pairs)


def failures(outcome: Outcome) -> str:
    """Return the points without an answer or with a part of it, and why; nothing if there are none."""
    stopped = [point for point in outcome.solved if point.stopped]
    if not stopped:
        return _without(outcome)
    reasons = [(settings_told(outcome, point.settings), point.stopped) for point in stopped[:ROWS]]
    return section("Where a march ended early", reason_list(reasons, ROWS, CSV)[0]) + _without(outcome)


def _without(outcome: Outcome) -> str:
    if not outcome.failed:
        return ""
    lead = f"<p>{len(outcome.failed)} of {len(outcome.points)} points have no answer:</p>"
    reasons = [(settings_told(outcome, point.settings), point.reason) for point in outcome.failed]
    return section("Points without an answer", lead, *reason_list(reasons, ROWS, CSV))


def reason_list(reasons: Sequence[tuple[str, str]], most: int, file: str) -> tuple[str, str]:
    """Return a list of places and reasons, cut after `most`, and a line that tells which `file` holds all."""
    items = "".join(f"<li>{safe(f'{where}: ' if where else '')}{safe(reason)}</li>" for where, reason in reasons[:most])
    more = len(reasons) - most
    return f"<ul>{items}</ul>", f"<p class='small'>… and {more} more; {file} holds all.</p>" if more > 0 else ""


def expected(outcome: Outcome) -> str:
    """Return what was expected and what came out, what was missed first; nothing if nothing was expected."""
    if not outcome.verdicts:
        return ""
    ranked = sorted(outcome.verdicts, key=lambda verdict: verdict.passed)
    missed = sum(not verdict.passed for verdict in ranked)
    lead = f"{len(ranked) - missed} of {len(ranked)} expectations were met."
    if len(ranked) > ROWS:
        lead += f" The first {ROWS} are shown, those that were missed first."
    heads = ["what", "", "#expected", "#came out", "#deviation", "#allowed"]
    rows = [_verdict(outcome, verdict) for verdict in ranked[:ROWS]]
    return section("What was expected", f"<p>{lead}</p>", table(heads, rows))


def _verdict(outcome: Outcome, verdict: Verdict) -> str:
    asked = verdict.expectation
    unit = asked.unit
    where = ", ".join(f"{name} = {told(place, 'm')}" for name, place in asked.place)
    what = _spoken(asked.quantity) + (f" at {where}" if where else "")
    if outcome.study.sweep:
        settings = next(point.settings for point in outcome.points if point.index == verdict.index)
        what += f", {settings_told(outcome, settings)}"
    cells = [
        f"<td>{safe(what)}</td>",
        f"<td>{'as expected' if verdict.passed else '<strong>missed</strong>'}</td>",
        number(safe(_some(asked.expected, unit))),
        number(safe(_some(verdict.got, unit))),
        number(f"{verdict.deviation:.2g}"),
        number(f"{asked.tolerance:.2g}"),
    ]
    return f"<tr>{''.join(cells)}</tr>"


def _spoken(quantity: str) -> str:
    """Return a quantity as it is read; with the place among many answers that was asked for."""
    base, _, number = quantity.rpartition(".")
    if not number.removeprefix("-").isdecimal():
        return spoken(quantity)
    return f"{spoken(base)} ({'last' if number == '-1' else f'number {number}'})"


def _some(content: Any, unit: str | None) -> str:
    numbers = np.ravel(np.asarray(content, dtype=float))
    return told(float(numbers[0]), unit, 7) + (f" … {told(float(numbers[-1]), unit, 7)}" if numbers.size > 1 else "")
