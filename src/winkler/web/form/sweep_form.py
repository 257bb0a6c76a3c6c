"""The form of a sweep: which numbers vary, over what, and which of their combinations are solved."""

from __future__ import annotations

from typing import Any, NamedTuple

from winkler.study.language.designs import DESIGNS
from winkler.web.form import form
from winkler.web.form.fit_form import numbers_in, spoken_key
from winkler.web.form.form import Entry
from winkler.web.form.sliders import NUMBER, span_of
from winkler.web.form.typed import shown, typed

__all__ = ["WAYS", "Row", "add", "design_entries", "plan", "put_row", "redesigned", "rows", "take_out"]

EVEN, RATIO, LIST = "even", "ratio", "list"
WAYS = {EVEN: "in equal steps", RATIO: "in equal ratios", LIST: "these values"}
"""How a number varies, in words."""
PLANS = {
    "crossed": "every combination",
    "zipped": "together, one after the other",
    "latin_hypercube": "drawn: Latin hypercube",
    "sobol": "drawn: Sobol sequence",
    "sensitivity": "which matters: Sobol indices",
}
"""Which points are solved, in words."""
COUNT, DRAWN = 5, 64
"""So many values, or drawn points, to begin with."""
SECTION, DESIGN = "sweep", "design"


class Row(NamedTuple):
    """One number that varies.

    Parameters
    ----------
    key
        As in the study.
    entry
        Its field in the form.
    label
        In words.
    way
        One of `WAYS`.
    ways
        Those that the design allows.
    texts
        What stands in its boxes: name -> text.
    """

    key: str
    entry: Entry
    label: str
    way: str
    ways: tuple[str, ...]
    texts: dict[str, str]


def _open(table: dict[str, Any]) -> dict[str, Entry]:
    """Return the numbers of the problem that may vary."""
    return {one.path: one for one in numbers_in(form.part_of(table)) if not one.takes.startswith("list of")}


def _lines(table: dict[str, Any]) -> dict[str, Any]:
    found = table.get(SECTION)
    return {key: content for key, content in found.items() if key != DESIGN} if isinstance(found, dict) else {}


def plan(table: dict[str, Any]) -> str:
    """Return the kind of the design."""
    return str(form.at(table, "sweep.design.kind") or "crossed")


def _draws(table: dict[str, Any]) -> bool:
    kind = plan(table)
    return kind in DESIGNS and DESIGNS[kind].draws


def rows(table: dict[str, Any]) -> tuple[tuple[Row, ...], dict[str, str]]:
    """Return the numbers that vary, and all others that might: key -> words."""
    known = _open(table)
    lines = _lines(table)
    found = []
    for key, content in lines.items():
        if key in known and isinstance(content, dict | list):
            ways = (EVEN, RATIO) if _draws(table) else tuple(WAYS)
            found.append(Row(key, known[key], spoken_key(key), _way(content), ways, _texts(content)))
    return tuple(found), {key: spoken_key(key) for key in known if key not in lines}


def _way(content: Any) -> str:
    if isinstance(content, list):
        return LIST
    return RATIO if "log" in (content.get("spacing"), content.get("scale")) else EVEN


def _texts(content: Any) -> dict[str, str]:
    if isinstance(content, list):
        return {"values": shown(content)}
    return {name: shown(content.get(name)) for name in ("from", "to", "count") if name != "count" or name in content}


def add(table: dict[str, Any], key: str) -> None:
    """Let a number vary: between a half and twice of what stands there."""
    entry = _open(table)[key]
    lines = table.setdefault(SECTION, {})
    found, span = NUMBER.fullmatch(entry.text), span_of(key.rpartition(".")[2], entry.text)
    if found is None or span is None:
        low, high = entry.text, entry.text
    elif span[0].even:
        low, high = span[0].text(-100), span[0].text(100)
    else:
        low, high = (f"{factor * float(found[1]):.4g} {found[2]}".rstrip() for factor in (0.5, 2.0))
    texts = {"from": low, "to": high, "count": str(COUNT)}
    lines[key] = _content(entry, EVEN, texts, draws=_draws(table))


def take_out(table: dict[str, Any], key: str) -> None:
    """Let a number vary no longer; without any, there is no sweep."""
    table[SECTION].pop(key, None)
    if not _lines(table):
        del table[SECTION]


def put_row(table: dict[str, Any], key: str, way: str, texts: dict[str, str]) -> None:
    """Say over what a number varies."""
    table[SECTION][key] = _content(_open(table)[key], way, texts, draws=_draws(table))


def _content(entry: Entry, way: str, texts: dict[str, str], *, draws: bool) -> Any:
    """Return what stands in ``[sweep]`` for the boxes of a row; those that are empty are left out."""
    one = f"quantity [{entry.unit}]" if entry.unit else "number"
    if way == LIST and not draws:
        text = texts.get("values") or ", ".join(texts[name] for name in ("from", "to") if texts.get(name))
        return typed(text, f"list of {one}") if text.strip() else []
    if "values" in texts:  # a list before
        items = [part.strip() for part in texts["values"].split(",")]
        texts = {"from": items[0], "to": items[-1], "count": str(max(len(items), 2))}
    found = {name: typed(texts[name], one) for name in ("from", "to") if texts.get(name, "").strip()}
    if not draws:
        count = texts.get("count", str(COUNT))
        found |= {"count": typed(count, "whole number")} if count.strip() else {}
    if way == RATIO:
        found["scale" if draws else "spacing"] = "log"
    return found


def redesigned(table: dict[str, Any], kind: str) -> None:
    """Take another design; ranges stay what they are."""
    before = [(row.key, row.way, row.texts) for row in rows(table)[0]]
    counted = "count" in getattr(DESIGNS[kind], "__dataclass_fields__", {})
    old = form.at(table, "sweep.design") or {}
    count = {"count": old.get("count", DRAWN), "seed": old.get("seed", 0)} if counted else {}
    table[SECTION].pop(DESIGN, None)
    if kind != "crossed":
        table[SECTION] = {DESIGN: {"kind": kind, **count}, **table[SECTION]}
    for key, way, texts in before:
        put_row(table, key, way, texts)


def design_entries(table: dict[str, Any]) -> tuple[Entry, ...]:
    """Return the numbers of a design that draws its points."""
    if not _draws(table):
        return ()
    pairs = " of pairs, a power of two" if plan(table) == "sensitivity" else ""
    hints = {"count": f"how many points are drawn{pairs}", "seed": "equal seeds draw equal points"}
    return tuple(
        Entry(
            f"sweep.design.{name}",
            name,
            "",
            "",
            hint,
            "whole number",
            shown(form.at(table, f"sweep.design.{name}")),
            True,
        )
        for name, hint in hints.items()
    )
