"""What a person types into a field, and what a study file says: the one made of the other, and back."""

from __future__ import annotations

import re
import tomllib
from typing import Any

from winkler.study.language.template import inline
from winkler.units import comma_readings

__all__ = ["SWITCH", "shown", "typed"]

TEXT, SWITCH = "text", "true or false"
"""What a key takes, in the words of `winkler.study.language.explain`."""
GROUPED = re.compile(r"\d,0\d\d(?!\d)")
"""No item of a list begins with a zero like that."""


def shown(content: Any) -> str:
    """Return what stands in a field for a value of a study file.

    Examples
    --------
    >>> shown("10 mm"), shown(0.3), shown(["1 N", "2 N"]), shown({"from": "0 N", "to": "1 N", "count": 3})
    ('10 mm', '0.3', '1 N, 2 N', '{ from = "0 N", to = "1 N", count = 3 }')
    """
    if content is None:
        return ""
    if isinstance(content, str):
        return content
    if isinstance(content, list) and all(isinstance(item, str | int | float) for item in content):
        return ", ".join(shown(item) for item in content)
    return inline(content)


def typed(text: str, takes: str) -> Any:
    """Return the value of a study file for what stands in a field; its mistakes are found by the study's own checks.

    Parameters
    ----------
    text
        What was typed.
    takes
        What the key takes, in the words of `winkler.study.language.explain`.

    Examples
    --------
    >>> typed(" 10 mm ", "quantity [m]"), typed("0.3", "number"), typed("1 N, 2 N", "list of quantity [N]")
    ('10 mm', 0.3, ['1 N', '2 N'])
    >>> typed('{ from = "0 N", to = "1 N", count = 3 }', "quantity [N], list or range")
    {'from': '0 N', 'to': '1 N', 'count': 3}
    """
    text = text.strip()
    if takes == TEXT:
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
    """Return whether commas stand within one number, which the study's checks then refuse with its readings."""
    return bool(comma_readings(text)) if "quantit" in takes else GROUPED.search(text) is not None


def _single(text: str, takes: str) -> Any:
    """Return a number where one is meant, otherwise the text."""
    if "quantit" in takes and "named" not in takes:
        return text
    for make in (int, float):
        try:
            return make(text)
        except ValueError:
            continue
    return text
