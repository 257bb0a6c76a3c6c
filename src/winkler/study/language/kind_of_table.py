"""Tables of a study that are refused: of no allowed kind, or with a key whose content the file beside it gives."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NoReturn

from winkler.study.language.catalogue import REFUSED, kinds, slot_of
from winkler.study.language.quantities import WHERE, wrong
from winkler.values.errors import listed, suggest


def refuse_kind(raw: Any, allowed: tuple[str, ...]) -> NoReturn:
    """Raise why `raw` is not a table of one of the `allowed` kinds."""
    if not isinstance(raw, Mapping):
        named = next((kind for kind in allowed if kind.startswith("named_")), None) if isinstance(raw, str) else None
        table = f'kind = "{named}", name = "{raw}"' if named else f'kind = "{allowed[0]}", ...'
        wrong(f"{WHERE} is {value_text(raw)}, not a table; write it as {{ {table} }}.")
    if "kind" not in raw:
        add = f"one of {listed('', allowed)}" if len(allowed) > 1 else f'as kind = "{allowed[0]}"'
        wrong(f"{WHERE} has no kind; add kind, {add}.")
    tag = raw["kind"]
    if not isinstance(tag, str):
        wrong(f"{WHERE}.kind is {value_text(tag)}, not text; allowed are {listed(str(tag), allowed)}.")
    if tag in REFUSED:
        try:
            REFUSED[tag].cls(1.0)
        except ValueError as refusal:
            wrong(f"{WHERE}.kind is '{tag}': {refusal}")
    if tag in kinds():
        here = f"allowed here are {listed(tag, allowed)}" if len(allowed) > 1 else f"only {allowed[0]} may stand here"
        wrong(f"{WHERE}.kind is '{tag}', which is a {slot_of(tag)}; {here}.")
    wrong(f"{WHERE}.kind is '{tag}'{suggest(tag, allowed)}; allowed are {listed(tag, allowed)}.")


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


def either_file_or(
    raw: Any, *, required: list[str], others: list[str], options: tuple[str, ...], alone: tuple[str, ...]
) -> Any:
    """Refuse a table with a file and with keys that the file replaces, or with neither.

    Parameters
    ----------
    raw
        The table.
    required, others
        Keys of the class that must be given, and those that may.
    options
        Options of the reader of the file.
    alone
        Those of them that are no keys of the class.
    """
    if not isinstance(raw, dict):
        return raw
    given = [key for key in required if key in raw and not ("file" in raw and key in options)]
    listed = ", ".join(required[:-1]) + f" and {required[-1]}"
    if "file" in raw:
        if given:
            wrong(f"{WHERE} has both file and {given[0]}; give the file, or {listed}.")
        for key in others:
            if key in raw and key not in options:
                wrong(f"{WHERE} has both file and {key}, which the file states; leave one of them out.")
        return raw
    for key in alone:
        if key in raw:
            wrong(f"{WHERE}.{key} states how a file is read, but there is no file; leave it out.")
    if len(given) < len(required):
        missing = next(key for key in required if key not in raw)
        wrong(f"{WHERE} has no '{missing}'; give {listed}, or a file.")
    return raw
