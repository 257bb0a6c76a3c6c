"""Ranges of one number: two ends and a count, in equal steps or ratios; or a list of values."""

from __future__ import annotations

from typing import Any

from winkler.web.form.field_units import completed_text, shown_unit
from winkler.web.form.form import FormEntry
from winkler.web.form.sliders import NUMBER, span_of
from winkler.web.form.typed import field_text, typed

EVEN, RATIO, LIST = "even", "ratio", "list"
SPACINGS = {EVEN: "in equal steps", RATIO: "in equal ratios", LIST: "these values"}
"""Spacings with their labels."""
VALUE_COUNT = 5
"""Initial number of values."""


def takes_range(entry: FormEntry) -> bool:
    """Return whether a key may hold a range."""
    return entry.takes.endswith("or range")


def is_range(content: Any) -> bool:
    """Return whether the content of a key is a range."""
    return isinstance(content, dict) and {"from", "to"} & set(content) != set()


def spacing_of(content: Any) -> str:
    """Return how the values of a range, or of a list, follow each other."""
    if isinstance(content, list):
        return LIST
    return RATIO if "log" in (content.get("spacing"), content.get("scale")) else EVEN


def range_texts(content: Any) -> dict[str, str]:
    """Return the contents of the fields of a range by name."""
    if isinstance(content, list):
        return {"values": field_text(content)}
    return {
        name: field_text(content.get(name)) for name in ("from", "to", "count") if name != "count" or name in content
    }


def first_range(entry: FormEntry) -> dict[str, str]:
    """Return the fields of a range between half and twice the number of a key."""
    result, span = NUMBER.fullmatch(entry.text), span_of(entry.path.rpartition(".")[2], entry.text)
    if result is None or span is None:
        low, high = entry.text, entry.text
    elif span[0].even:
        low, high = span[0].text(-100), span[0].text(100)
    else:
        low, high = (f"{factor * float(result[1]):.4g} {result[2]}".rstrip() for factor in (0.5, 2.0))
    return {"from": low, "to": high, "count": str(VALUE_COUNT)}


def range_content(entry: FormEntry, spacing: str, texts: dict[str, str], *, draws: bool = False) -> Any:
    """Return the content of a study for the fields of a range; empty ones are left out.

    Parameters
    ----------
    entry
        The key that varies; bare numbers are taken in the unit of one of its ends, or else in its own.
    spacing
        One of `SPACINGS`.
    texts
        Contents of the fields by name.
    draws
        Whether the design draws the values.
    """
    one = f"quantity [{entry.unit}]" if entry.unit else "number"
    ends = (texts.get(name, "") for name in ("from", "to", "values"))
    unit = next((found for found in (shown_unit(text, "") for text in (*ends, entry.text)) if found), entry.unit)
    unit = unit if entry.unit else ""

    def read(text: str, takes: str) -> Any:
        return typed(completed_text(text, takes, unit), takes)

    if spacing == LIST and not draws:
        text = texts.get("values") or ", ".join(texts[name] for name in ("from", "to") if texts.get(name))
        return read(text, f"list of {one}") if text.strip() else []
    if "values" in texts:  # a list before
        items = [part.strip() for part in texts["values"].split(",")]
        texts = {"from": items[0], "to": items[-1], "count": str(max(len(items), 2))}
    result = {name: read(texts[name], one) for name in ("from", "to") if texts.get(name, "").strip()}
    if not draws:
        count = texts.get("count", str(VALUE_COUNT))
        result |= {"count": typed(count, "whole number")} if count.strip() else {}
    if spacing == RATIO:
        result["scale" if draws else "spacing"] = "log"
    return result
