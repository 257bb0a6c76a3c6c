"""Conversion between the text of a field and the value in a study file."""

from __future__ import annotations

import re
import tomllib
from typing import Any

from winkler.study.language.template import inline
from winkler.values.units import comma_readings

TEXT, SWITCH, CHOICE = "text", "true or false", "one of "
"""Types of keys as named by `winkler.study.language.explain`."""
GROUPED = re.compile(r"\d,0\d\d(?!\d)")
"""Digit groups; no item of a list begins with such zeros."""


def field_text(content: Any) -> str:
    """Return the text of a field for a value of a study file.

    Examples
    --------
    >>> field_text("10 mm"), field_text(0.3), field_text(["1 N", "2 N"])
    ('10 mm', '0.3', '1 N, 2 N')
    >>> field_text({"from": "0 N", "to": "1 N", "count": 3})
    '{ from = "0 N", to = "1 N", count = 3 }'
    """
    if content is None:
        return ""
    if isinstance(content, str):
        return content
    if isinstance(content, list) and all(isinstance(item, str | int | float) for item in content):
        return ", ".join(field_text(item) for item in content)
    return inline(content)


def typed(text: str, takes: str) -> Any:
    """Return the value of a study file for the text of a field, which the checks of the study validate.

    Parameters
    ----------
    text
        The typed text.
    takes
        Type of the key as named by `winkler.study.language.explain`.

    Examples
    --------
    >>> typed(" 10 mm ", "quantity [m]"), typed("0.3", "number"), typed("1 N, 2 N", "list of quantity [N]")
    ('10 mm', 0.3, ['1 N', '2 N'])
    >>> typed('{ from = "0 N", to = "1 N", count = 3 }', "quantity [N], list or range")
    {'from': '0 N', 'to': '1 N', 'count': 3}
    """
    text = text.strip()
    if takes == TEXT or takes.startswith(CHOICE):
        return text
    if takes == SWITCH:
        return text == "true"
    if text[:1] in "[{" and text:
        try:
            return tomllib.loads(f"it = {text}")["it"]
        except tomllib.TOMLDecodeError:
            return text
    if ("list" in takes or takes.startswith("two ")) and "," in text and not _one_number(text, takes):
        return [_single(item.strip(), takes) for item in text.split(",")]
    one = _single(text, takes)
    return [one] if takes.startswith("list") else one


def _one_number(text: str, takes: str) -> bool:
    """Return whether commas belong to one number, which the checks of the study refuse as ambiguous."""
    one = "quantit" in takes or takes.startswith("number")
    return bool(comma_readings(text)) if one else GROUPED.search(text) is not None


def _single(text: str, takes: str) -> Any:
    """Return a number if the text is one, otherwise the text."""
    if "quantit" in takes and "named" not in takes:
        return text
    for convert in (int, float):
        try:
            return convert(text)
        except ValueError:
            continue
    return text
