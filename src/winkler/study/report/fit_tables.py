"""The tables in the report of fits: the numbers, their flags, and the curves that could not be fitted."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from winkler.fitting.several.standing_out import LEAST_STATED, BatchQuantity
from winkler.plot.series import middle_scale
from winkler.study.batch.fit_outcome import FitOutcome, Fitted, interval_of
from winkler.study.language.fit_study import Free
from winkler.study.report.fit_writing import CSV
from winkler.study.report.markup import number, safe, section, table
from winkler.study.report.mathml import symbol
from winkler.study.report.tables import MOST_ROWS as LISTED
from winkler.study.report.tables import reason_list
from winkler.values.readable import with_unit
from winkler.values.vocabulary import Word

MOST_ROWS = 40
"""Longer tables are cut; the CSV file holds all rows."""


def batch_section(
    title: str, quantities: Sequence[BatchQuantity], doubts: Sequence[tuple[str, tuple[str, ...]]], file: str
) -> str:
    """Return median and scatter of the curves of a batch, and which are doubtful; empty if there is nothing to say.

    Parameters
    ----------
    title
    quantities
        Of the curves that count.
    doubts
        Names of curves with sentences.
    file
        Name of the table that holds all curves.
    """
    parts = []
    if quantities and len(quantities[0].numbers) >= LEAST_STATED:
        rows = [
            f"<tr><td>{safe(one.name)}</td>{number(safe(one.text(one.median, 4)))}"
            f"{number(safe(one.text(one.deviation, 2)))}</tr>"
            for one in quantities
        ]
        parts.append(table([f"of {len(quantities[0].numbers)} curves", "#median", "#median absolute deviation"], rows))
    if doubts:
        lines = [(name, " ".join(each)) for name, each in doubts]
        parts += ["<p>Doubtful are:</p>", *reason_list(lines, LISTED, file)]
    return section(title, *parts) if parts else ""


def counts(outcome: FitOutcome) -> str:
    """Return one line: how many curves were fitted."""
    made = outcome.provenance
    one = len(outcome.results) == 1
    summary = "One curve was fitted" if one else f"{len(outcome.fitted)} of {len(outcome.results)} curves were fitted"
    if outcome.left:
        summary += f"; the run was stopped before {outcome.left} more files or curves"
    return f'<p class="small">{summary}, with winkler {safe(made.version)}, {safe(made.created[:10])}.</p>'


def answers(outcome: FitOutcome) -> str:
    """Return the numbers: of one curve with errors and correlations, of many in one table."""
    if len(outcome.fitted) == 1:
        return section("Fitted parameters", _single(outcome, outcome.fitted[0]))
    cut = ""
    if len(outcome.results) > MOST_ROWS:
        cut = f"<p class='small'>The first {MOST_ROWS} of {len(outcome.results)} curves are shown; {CSV} holds all.</p>"
    return section("Fitted parameters", _together(outcome), _many(outcome), cut)


def _single(outcome: FitOutcome, result: Fitted) -> str:
    fit = result.fit
    rows = [
        f"<tr><td>{safe(free.key)}</td><td>{symbol(word.symbol)}</td>{number(safe(fitted))}{number(safe(error))}"
        f'{number(safe(f"{low} … {high}"))}<td class="text small">{safe(word.meaning)}</td></tr>'
        for free, word, fitted, error, low, high in number_texts(outcome, result)
    ]
    heads = ["what", "", "#fitted", "#standard error", "#95 % interval", "meaning"]
    correlations = [
        f"{outcome.study.free[i].key} and {outcome.study.free[j].key}: {fit.correlation[i, j]:.3f}"
        for i in range(len(fit.names))
        for j in range(i)
    ]
    facts = [
        f"{fit.count} points were fitted, worth {fit.effective_count:.0f} independent ones; {fit.slow_share:.0%} of "
        "the variance of the noise is slow.",
        f"The noise is {with_unit(fit.noise, outcome.study.spread.unit)}; χ² per degree of freedom is "
        f"{fit.chi_square:.3g}, in contact {fit.chi_square_in_contact:.3g}.",
        f"The largest depth is {with_unit(float(fit.depth.max()), 'm')}, with a contact radius of "
        f"{with_unit(float(fit.radius.max()), 'm')}.",
    ]
    if correlations:
        facts.append(f"Correlations of the errors: {'; '.join(correlations)}.")
    return table(heads, rows) + f"<ul>{''.join(f'<li>{safe(fact)}</li>' for fact in facts)}</ul>"


def _together(outcome: FitOutcome) -> str:
    """Return median and scatter over the curves."""
    rows = []
    for free in outcome.study.free:
        word = outcome.study.word(free.key)
        content = outcome.numbers(free)
        content = content[np.isfinite(content)]
        low, middle, high = np.quantile(content, (0.25, 0.5, 0.75))
        typical = float(np.nanmedian(outcome.errors(free)))
        rows.append(
            f"<tr><td>{safe(free.key)}</td><td>{symbol(word.symbol)}</td>"
            f"{number(safe(with_unit(middle, word.unit, 5)))}"
            f"{number(safe(f'{with_unit(low, word.unit)} … {with_unit(high, word.unit)}'))}"
            f"{number(safe(with_unit(typical, word.unit, 3)))}<td class='text small'>{safe(word.meaning)}</td></tr>"
        )
    heads = ["what", "", "#median of the curves", "#middle half", "#standard error of one", "meaning"]
    return table(heads, rows)


def number_texts(outcome: FitOutcome, result: Fitted) -> Iterator[tuple[Free, Word, str, str, str, str]]:
    """Yield every free number of a curve as text: itself, its standard error, and the ends of its interval."""
    for free in outcome.study.free:
        word = outcome.study.word(free.key)
        fit = result.fit
        low, high = (with_unit(end, word.unit, 5) for end in interval_of(result, free))
        yield (
            free,
            word,
            with_unit(fit.value(free.path), word.unit, 5),
            with_unit(fit.error(free.path), word.unit, 3),
            low,
            high,
        )


def curve_texts(outcome: FitOutcome, free: Free, nothing: str) -> tuple[str, list[str]]:
    """Return a unit, and a free number of every curve with its error in it; `nothing` where there is no fit."""
    numbers, errors = outcome.numbers(free), outcome.errors(free)
    scale = middle_scale(outcome.study.word(free.key).unit, np.fmax(np.abs(numbers), errors))
    texts = [
        f"{one / scale.factor:.5g} ± {error / scale.factor:.2g}" if np.isfinite(one) else nothing
        for one, error in zip(numbers.tolist(), errors.tolist(), strict=True)
    ]
    return scale.unit, texts


def _many(outcome: FitOutcome) -> str:
    heads, bodies = ["curve"], [[f"<td>{safe(result.name)}</td>" for result in outcome.results]]
    for free in outcome.study.free:
        unit, texts = curve_texts(outcome, free, "—")
        named = f"#{safe(free.label)} {symbol(outcome.study.word(free.key).symbol)}"
        heads.append(named + (f"<br>[{safe(unit)}]" if unit else ""))
        bodies.append([number(text) for text in texts])
    heads += ["#χ²", "#χ² in contact", "flags"]
    for name in ("chi_square", "chi_square_in_contact"):
        texts = [f"{getattr(one.fit, name):.3g}" if isinstance(one, Fitted) else "—" for one in outcome.results]
        bodies.append([number(text) for text in texts])
    bodies.append([f"<td>{safe(one)}</td>" for one in outcome.flags(", ", "no answer")])
    rows = ["<tr>" + "".join(cells) + "</tr>" for cells in zip(*bodies, strict=True)]
    return table(heads, rows[:MOST_ROWS])


def doubts(outcome: FitOutcome) -> str:
    """Return the flags: of one curve every sentence, of many how often each occurs with one sentence."""
    by_name: dict[str, list[str]] = {}
    for result in outcome.fitted:
        for flag in result.fit.flags:
            by_name.setdefault(flag.name, []).append(f"{result.name}: {flag.statement}")
    if not by_name:
        return ""
    single = len(outcome.results) == 1
    items = []
    for name, sentences in by_name.items():
        if single:
            items += [f"<li><strong>{safe(name)}</strong>: {safe(one.partition(': ')[2])}</li>" for one in sentences]
        else:
            items.append(
                f"<li><strong>{safe(name)}</strong>, {len(sentences)} times; the first: {safe(sentences[0])}</li>"
            )
    return section("Doubts about the parameters", f"<ul>{''.join(items)}</ul>")


def failures(outcome: FitOutcome) -> str:
    """Return the curves without an answer, each with its reason; nothing if there are none."""
    if not outcome.refused:
        return ""
    reasons = [(one.name, one.reason) for one in outcome.refused]
    return section("Curves without an answer", *reason_list(reasons, MOST_ROWS, CSV))
