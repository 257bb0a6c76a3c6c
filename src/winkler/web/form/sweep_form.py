"""The form of a sweep: varied numbers, their ranges, and the design."""

from __future__ import annotations

from typing import Any, NamedTuple

from winkler.study.language.designs import DESIGNS
from winkler.web.form import form
from winkler.web.form.fit_form import key_in_words, numbers_in
from winkler.web.form.form import FormEntry
from winkler.web.form.ranges import EVEN, RATIO, SPACINGS, first_range, range_content, range_texts, spacing_of

DESIGN_LABELS = {
    "crossed": "every combination",
    "zipped": "together, one after the other",
    "latin_hypercube": "drawn: Latin hypercube",
    "sobol": "drawn: Sobol sequence",
    "sensitivity": "which matters: Sobol indices",
}
"""Designs with their labels."""
POINT_COUNT = 64
"""Initial number of drawn points."""
SECTION, DESIGN = "sweep", "design"


class VariedNumber(NamedTuple):
    """One number that varies.

    Parameters
    ----------
    key
        As in the study.
    entry
        Its field in the form.
    label
        In words.
    spacing
        One of `SPACINGS`.
    spacings
        Those that the design allows.
    texts
        Contents of its fields by name.
    """

    key: str
    entry: FormEntry
    label: str
    spacing: str
    spacings: tuple[str, ...]
    texts: dict[str, str]


def _candidates(table: dict[str, Any]) -> dict[str, FormEntry]:
    """Return the numbers of the problem that may vary."""
    return {one.path: one for one in numbers_in(form.part_of(table)) if not one.takes.startswith("list of")}


def _lines(table: dict[str, Any]) -> dict[str, Any]:
    result = table.get(SECTION)
    return {key: content for key, content in result.items() if key != DESIGN} if isinstance(result, dict) else {}


def design_kind(table: dict[str, Any]) -> str:
    """Return the kind of the design."""
    return str(form.at(table, "sweep.design.kind") or "crossed")


def _draws(table: dict[str, Any]) -> bool:
    kind = design_kind(table)
    return kind in DESIGNS and DESIGNS[kind].draws


def rows(table: dict[str, Any]) -> tuple[tuple[VariedNumber, ...], dict[str, str]]:
    """Return the varied numbers, and the labels of all others by key."""
    candidates = _candidates(table)
    lines = _lines(table)
    result = []
    for key, content in lines.items():
        if key in candidates and isinstance(content, dict | list):
            spacings = (EVEN, RATIO) if _draws(table) else tuple(SPACINGS)
            result.append(
                VariedNumber(
                    key, candidates[key], key_in_words(key), spacing_of(content), spacings, range_texts(content)
                )
            )
    return tuple(result), {key: key_in_words(key) for key in candidates if key not in lines}


def add(table: dict[str, Any], key: str) -> None:
    """Vary a number between half and twice its value."""
    entry = _candidates(table)[key]
    lines = table.setdefault(SECTION, {})
    lines[key] = range_content(entry, EVEN, first_range(entry), draws=_draws(table))


def remove_key(table: dict[str, Any], key: str) -> None:
    """Stop varying a number; without varied numbers, remove the sweep."""
    table[SECTION].pop(key, None)
    if not _lines(table):
        del table[SECTION]


def set_range(table: dict[str, Any], key: str, spacing: str, texts: dict[str, str]) -> None:
    """Set the range of a varied number."""
    table[SECTION][key] = range_content(_candidates(table)[key], spacing, texts, draws=_draws(table))


def change_design(table: dict[str, Any], kind: str) -> None:
    """Change the design, and keep the ranges."""
    before = [(row.key, row.spacing, row.texts) for row in rows(table)[0]]
    counted = "count" in getattr(DESIGNS[kind], "__dataclass_fields__", {})
    old = form.at(table, "sweep.design") or {}
    count = {"count": old.get("count", POINT_COUNT), "seed": old.get("seed", 0)} if counted else {}
    table[SECTION].pop(DESIGN, None)
    if kind != "crossed":
        table[SECTION] = {DESIGN: {"kind": kind, **count}, **table[SECTION]}
    for key, spacing, texts in before:
        set_range(table, key, spacing, texts)


def design_entries(table: dict[str, Any]) -> tuple[FormEntry, ...]:
    """Return the numbers of a design that draws its points."""
    if not _draws(table):
        return ()
    pairs = " of pairs, a power of two" if design_kind(table) == "sensitivity" else ""
    hints = {"count": f"how many points are drawn{pairs}", "seed": "equal seeds draw equal points"}
    return tuple(
        form.entry_at(table, f"sweep.design.{name}", name, hint, "whole number", required=True)
        for name, hint in hints.items()
    )
