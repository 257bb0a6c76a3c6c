"""Two answers beside each other: what differs in their studies, and by how much their numbers do."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.plot.series import name_in_words
from winkler.study.report.markup import number, safe, table
from winkler.study.report.mathml import symbol
from winkler.values.readable import with_unit
from winkler.web.form.fit_form import key_in_words
from winkler.web.form.typed import field_text
from winkler.web.pictures.replies import NamedNumber

if TYPE_CHECKING:
    from winkler.study.batch.outcome import Outcome

MOST_DIFFERENCES = 12
"""Most differences of two studies that are listed."""
NO_INPUTS = ("title", "source")
"""Sections of a study that change no number."""


def numbers_of(outcome: Outcome) -> tuple[NamedNumber, ...]:
    """Return the last row of the table of answers."""
    swept = {axis.key for axis in outcome.study.sweep}
    return tuple(
        NamedNumber(name_in_words(column.name), column.word.symbol, column.word.unit, float(column.content[-1]))
        for column in outcome.readable_table()
        if column.word.unit is not None and column.name not in swept and column.content.dtype.kind == "f"
    )


def comparison(first: tuple[str, tuple[NamedNumber, ...]], second: tuple[str, tuple[NamedNumber, ...]]) -> str:
    """Return the table of two answers as HTML.

    Parameters
    ----------
    first, second
        Text of the study, and its numbers.
    """
    differences = list(_differences(tomllib.loads(first[0]), tomllib.loads(second[0])))
    more = f" and {len(differences) - MOST_DIFFERENCES} more" if len(differences) > MOST_DIFFERENCES else ""
    said = "; ".join(safe(one) for one in differences[:MOST_DIFFERENCES])
    lead = f"From A to B: {said}{more}." if differences else "Both studies are the same."
    after = {one.name: one for one in second[1]}
    rows = [_row(one, after[one.name]) for one in first[1] if one.name in after and one.unit == after[one.name].unit]
    heads = ["answer", "", "#A", "#B", "#B − A", "#B / A"]
    return f"<p>{lead}</p>" + (table(heads, rows) if rows else "<p>They have no number in common.</p>")


def _row(a: NamedNumber, b: NamedNumber) -> str:
    ratio = b.number / a.number if a.number != 0.0 else float("nan")
    texts = [with_unit(one, a.unit, 5) for one in (a.number, b.number, b.number - a.number)]
    texts.append(with_unit(ratio, "", 5) if np.isfinite(ratio) else "—")
    cells = "".join(number(safe(text)) for text in texts)
    return f"<tr><td>{safe(a.name)}</td><td>{symbol(a.symbol)}</td>{cells}</tr>"


def _differences(a: dict[str, Any], b: dict[str, Any]) -> Iterator[str]:
    """Yield what differs in two studies, in words."""
    before, after = (dict(_leaves(study, "")) for study in (a, b))
    for key in dict.fromkeys((*before, *after)):
        if before.get(key) != after.get(key) and key.partition(".")[0] not in NO_INPUTS:
            old, new = (field_text(one[key]) if key in one else "not given" for one in (before, after))
            if key.endswith(".kind"):
                key, old, new = key.removesuffix(".kind"), old.replace("_", " "), new.replace("_", " ")
            yield f"{key_in_words(key)} {old} → {new}"


def _leaves(content: Any, path: str) -> Iterator[tuple[str, Any]]:
    """Yield path and content of what is no table; lists of tables are followed, too."""
    if isinstance(content, dict) and not (path and {"from", "to"} & set(content)):
        for key, inside in content.items():
            yield from _leaves(inside, f"{path}.{key}".lstrip("."))
    elif isinstance(content, list) and content and all(isinstance(item, dict) for item in content):
        for place, item in enumerate(content):
            yield from _leaves(item, f"{path}.{place}")
    else:
        yield path, content
