"""Error sentences about a study: file, key, its value, what is allowed, the nearest allowed word."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError

from winkler.study.language.catalogue import kinds
from winkler.study.language.grammar import SECTIONS, section_keys
from winkler.study.language.kind_of_table import value_text
from winkler.study.language.quantities import WHERE, sample, unit_of
from winkler.study.language.schema import form
from winkler.values.errors import InvalidInput, nearest, suggest
from winkler.values.vocabulary import word

MOST_SENTENCES = 10
"""Most sentences that are shown."""


def worded(file: str, reasons: list[str]) -> InvalidInput:
    """Return the error with the sentences `reasons` about `file`."""
    lines = [f"{file}: {sentence}" if file else sentence for sentence in reasons[:MOST_SENTENCES]]
    if len(reasons) > MOST_SENTENCES:
        lines.append(f"{len(reasons) - MOST_SENTENCES} more mistakes are not shown.")
    return InvalidInput(*lines)


def sentences(error: ValidationError, raw: Any, root: str = "") -> list[str]:
    """Return one sentence for every mistake that pydantic found in `raw`.

    With a `root`, `raw` is ``{"content": ...}``, and its content is named by that key.
    """
    by_key: dict[str, str] = {}
    misspelt: set[str] = set()
    for mistake in sorted(error.errors(include_url=False), key=lambda mistake: mistake["type"] == "missing"):
        path, table = _place(mistake["loc"], raw)
        key = _joined([root, *path[1:]] if root else path) or "the study"
        if len(by_key) >= MOST_SENTENCES:  # counted only, since each sentence costs a search for the nearest word
            by_key.setdefault(key, "")
            continue
        if mistake["type"] == "extra_forbidden":
            misspelt.add(f"{_parent(key)}.{nearest(str(path[-1]), _allowed(key, table))}")
        if mistake["type"] != "missing" or f"{_parent(key)}.{path[-1]}" not in misspelt:
            by_key.setdefault(key, _sentence(mistake, key, path, table))
    return list(by_key.values())


def _joined(path: list[Any]) -> str:
    text = ""
    for part in path:
        text += f"[{part}]" if isinstance(part, int) else f".{part}" if text else str(part)
    return text


def _place(loc: tuple[Any, ...], raw: Any) -> tuple[list[Any], Any]:
    """Return the path in the file, and the innermost table or list on it."""
    table = content = raw
    for part in loc:
        table = content
        inside = part in content if isinstance(content, Mapping) else isinstance(content, list) and part < len(content)
        content = content[part] if inside else None
    return list(loc), table


def _parent(key: str) -> str:
    return key.rpartition(".")[0] or "the study"


def _sentence(mistake: Any, key: str, path: list[Any], table: Any) -> str:
    given, context = mistake["input"], mistake.get("ctx", {})
    name = str(path[-1]) if path else ""
    if _kindless(key) and isinstance(table, Mapping):  # a kind is not allowed there, and does not describe the table
        table = {word: content for word, content in table.items() if word != "kind"}
    owner = kinds().get(str(table.get("kind"))) if isinstance(table, Mapping) else None
    match mistake["type"]:
        case "winkler":
            return str(context["sentence"]).replace(WHERE, _joined([key, *context.get("key", ())]))
        case "extra_forbidden":
            return _unknown(key, name, table, owner)
        case "missing":
            return _missing(key, name, owner)
        case "literal_error":
            allowed = str(context["expected"]).replace("'", "").replace(" or ", ", ").split(", ")
            return f"{key} is {value_text(given)}{suggest(str(given), allowed)}; give {' or '.join(allowed)}."
        case "model_attributes_type" | "model_type" | "dict_type" | "dataclass_type":
            return f"{key} is {value_text(given)}, not a table; write it as {{ key = value, ... }} or as [{key}]."
        case "list_type":
            right = f"with two brackets, as [[{key}]]" if isinstance(given, Mapping) else "as [ ..., ... ]"
            return f"{key} is {value_text(given)}, not a list; write it {right}."
        case "string_type":
            return f'{key} is {value_text(given)}, not text; write it in quotes, as {name} = "...".'
        case "bool_type":
            return f"{key} is {value_text(given)}; give true or false."
        case "int_type":
            return f"{key} is {value_text(given)}; give a whole number."
        case _:
            return f"{key} is {value_text(given)}: {mistake['msg']}."


def _kindless(key: str) -> bool:
    """Return whether the table around a key is a section without a kind, such as [[expect]]."""
    section = _parent(key).partition("[")[0]
    return section in SECTIONS and "kind" not in SECTIONS[section] and section != "problem"


def _unknown(key: str, name: str, table: Any, owner: Any) -> str:
    allowed = _allowed(key, table)
    where = f"{table['kind']}" if owner is not None else _parent(key)
    if name in ("material", "name") and (by_name := f"named_{where}") in kinds():
        content = value_text(table[name]).strip("'")
        return f'{key} is not known; a material by its name is {{ kind = "{by_name}", name = "{content}" }}.'
    return f"{key} is not known{suggest(name, allowed)}; {where} takes {', '.join(allowed)}."


def _allowed(key: str, table: Any) -> tuple[str, ...]:
    """Return the keys that may stand beside `key`."""
    name = str(table.get("kind")) if isinstance(table, Mapping) else ""
    return tuple(form(name).model_fields) if name in kinds() else section_keys(_parent(key))


def _missing(key: str, name: str, owner: Any) -> str:
    where = _parent(key)
    if owner is None:
        meaning = SECTIONS.get(where.partition("[")[0], {}).get(name, "")
        return f"{where} has no '{name}'{f' ({meaning.partition(chr(59))[0]})' if meaning else ''}; add it."
    entry = word(owner.cls, name)
    unit = unit_of(owner.cls, name)
    such = owner.example.get(name)
    example = f', such as {name} = "{such if isinstance(such, str) else sample(unit)}"' if unit else ""
    return f"{where} has no '{name}' ({entry.meaning}); add it{example}."
