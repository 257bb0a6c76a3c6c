"""The sentence that states why a table of a study is of no allowed kind."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NoReturn

from winkler.errors import suggest
from winkler.study.language.catalogue import REFUSED, kinds, slot_of
from winkler.study.language.quantities import WHERE, wrong

__all__ = ["refuse_kind", "value_text"]


def refuse_kind(raw: Any, allowed: tuple[str, ...]) -> NoReturn:
    """Raise why `raw` is not a table of one of the `allowed` kinds."""
    if not isinstance(raw, Mapping):
        wrong(f'{WHERE} is {value_text(raw)}, not a table; write it as {{ kind = "{allowed[0]}", ... }}.')
    if "kind" not in raw:
        add = f"one of {', '.join(allowed)}" if len(allowed) > 1 else f'as kind = "{allowed[0]}"'
        wrong(f"{WHERE} has no kind; add kind, {add}.")
    tag = raw["kind"]
    if not isinstance(tag, str):
        wrong(f"{WHERE}.kind is {value_text(tag)}, not text; allowed are {', '.join(allowed)}.")
    if tag in REFUSED:
        try:
            REFUSED[tag].cls(1.0)
        except ValueError as refusal:
            wrong(f"{WHERE}.kind is '{tag}': {refusal}")
    if tag in kinds():
        here = f"allowed here are {', '.join(allowed)}" if len(allowed) > 1 else f"only {allowed[0]} may stand here"
        wrong(f"{WHERE}.kind is '{tag}', which is a {slot_of(tag)}; {here}.")
    wrong(f"{WHERE}.kind is '{tag}'{suggest(tag, allowed)}; allowed are {', '.join(allowed)}.")


def value_text(given: Any) -> str:
    """Return a value, short enough for a sentence."""
    if isinstance(given, Mapping):
        return "a table"
    if isinstance(given, list):
        return "a list"
    if isinstance(given, bool):
        return str(given).lower()
    if not isinstance(given, str | int | float):
        return str(given)
    return repr(given) if len(repr(given)) <= 60 else repr(given)[:57] + "..."
