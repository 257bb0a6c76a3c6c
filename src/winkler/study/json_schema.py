"""A JSON schema of study files, by which editors complete keys and mark mistakes while they are typed.

It follows from the models that check a study (`winkler.study.language.schema`), and is looser: what holds between
keys, ranges of numbers and products of units are left to the reader of studies, whose sentences say more.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

from pydantic.json_schema import GenerateJsonSchema

from winkler.study.language import json_forms
from winkler.study.language.catalogue import FORMER, kinds, slot_of
from winkler.study.language.designs import DESIGNS
from winkler.study.language.explain import keys_of, plain_symbol, summary
from winkler.study.language.fit_grammar import fit_form
from winkler.study.language.fit_study import FITTED
from winkler.study.language.grammar import SECTIONS, study_form
from winkler.study.language.json_forms import KINDS, SHARED, Form
from winkler.study.language.schema import GROOVE, OSCULATION, diameters, form, required_fields
from winkler.study.language.study import GRADES, PICTURES
from winkler.study.nanoindentation.keys import MEANINGS, UNITS

DIALECT = "http://json-schema.org/draft-07/schema#"
"""The dialect that editors of TOML know."""

DEFINED = "#/definitions/"
OF_A_FIT = ("load", "path")
"""Keys of a problem that a study with ``[fit]`` leaves out."""


class _Silent(GenerateJsonSchema):
    """Writes no defaults: a key that is left out has that of its class."""

    def default_schema(self, schema: Any) -> Form:
        return self.generate_inner(schema["schema"])


def json_schema(kind: str = "") -> Form:
    """Return the schema of a study file, or of the table of one kind.

    Parameters
    ----------
    kind
        A kind of the catalogue; empty for whole studies.

    Returns
    -------
    dict
        A JSON schema of draft 7, with the kinds that it refers to.
    """
    root = _kind(kind) if kind else _study()
    definitions: dict[str, Form] = {}
    found = _linked(root, definitions)
    return {"$schema": DIALECT, **found, "definitions": dict(sorted(definitions.items()))}


def _linked(content: Any, definitions: dict[str, Form]) -> Any:
    """Return a form with references to kinds, which are put among the definitions."""
    if isinstance(content, list):
        return [_linked(item, definitions) for item in content]
    if not isinstance(content, dict):
        return content
    said = {key: content[key] for key in ("description",) if key in content}
    rest = {key: item for key, item in content.items() if key not in said}
    if isinstance(names := rest.get(KINDS), list):
        for name in names:
            _defined(name, functools.partial(_kind, name), definitions)
        return {**said, "anyOf": [{"$ref": DEFINED + name} for name in names]}
    if isinstance(name := rest.pop(SHARED, None), str):
        _defined(name, lambda: rest, definitions)
        return {**said, "anyOf": [{"$ref": DEFINED + name}]} if said else {"$ref": DEFINED + name}
    return {key: _linked(item, definitions) for key, item in content.items()}


def _defined(name: str, form_of: Callable[[], Form], definitions: dict[str, Form]) -> None:
    """Put a form among the definitions, unless it stands there; kinds may hold each other."""
    if name not in definitions:
        definitions[name] = {}
        definitions[name] = _linked(form_of(), definitions)


def _plain(content: Any) -> Any:
    """Return a form of pydantic without the titles that repeat the names of the keys."""
    if isinstance(content, list):
        return [_plain(item) for item in content]
    if not isinstance(content, dict):
        return content
    return {
        key: {name: _plain(item) for name, item in inside.items()} if key == "properties" else _plain(inside)
        for key, inside in content.items()
        if not (key == "title" and isinstance(inside, str))
    }


def _inlined(content: Any, parts: dict[str, Form]) -> Any:
    """Return a form with the parts that pydantic refers to in their places."""
    if isinstance(content, list):
        return [_inlined(item, parts) for item in content]
    if not isinstance(content, dict):
        return content
    if "$ref" in content:
        return _inlined(parts[content["$ref"].rpartition("/")[2]], parts)
    return {key: _inlined(item, parts) for key, item in content.items()}


def _model(model: Any) -> Form:
    """Return the form of a model."""
    found = model.model_json_schema(schema_generator=_Silent)
    parts = found.pop("$defs", {})
    return _plain(_inlined(found, parts))  # type: ignore[no-any-return]


@functools.cache
def _kind(name: str) -> Form:
    """Return the form of the table of a kind."""
    found = _model(form(name))
    for key in keys_of(name):
        symbol, unit = plain_symbol(key.word.symbol), key.word.unit
        head = " ".join(part for part in (symbol, f"[{unit or '-'}]" if unit is not None else "") if part)
        said = ". ".join(part for part in (key.word.meaning, key.range) if part)
        found["properties"][key.name]["description"] = f"{head}: {said}" if head and said else head or said
    if former := [before for before, now in FORMER.items() if now == name]:
        found["properties"]["kind"] = {"enum": [name, *former]}
    halved = diameters(kinds()[name].cls)
    for diameter, radius in halved.items():
        found["properties"][diameter] = found["properties"][radius] | {"description": f"twice the {radius}"}
    if GROOVE in halved.values():
        found["properties"][OSCULATION] = {
            "type": "number",
            "description": "radius of a groove over the diameter of the ball in it, for the second lateral radius",
        }
    others = {radius: [key for key in halved if halved[key] == radius] for radius in halved.values()}
    if GROOVE in others:
        others[GROOVE].append(OSCULATION)
    needed = [key for key in found["required"] if not (name in FITTED and key in OF_A_FIT)]
    if either := [[radius, *others[radius]] for radius in needed if radius in others]:
        found["allOf"] = [{"anyOf": [{"required": [key]} for key in keys]} for keys in either]
    needed = [key for key in needed if key not in others]
    if kinds()[name].reader is not None:
        found["anyOf"] = [{"required": ["file"]}, {"required": required_fields(kinds()[name].cls)}]
    return found | {"description": summary(kinds()[name].cls), "required": needed, "title": f"{name} ({slot_of(name)})"}


def _table(meanings: dict[str, str], units: dict[str, str | None]) -> Form:
    """Return the form of a section of a nanoindentation."""
    keys = {
        key: ({} if units[key] is None else json_forms.quantity(units[key])) | {"description": meaning}
        for key, meaning in meanings.items()
    }
    return {"type": "object", "properties": keys, "additionalProperties": False}


def _study() -> Form:
    """Return the form of a whole study."""
    found = _model(study_form())
    keys = found["properties"]
    keys["sweep"]["properties"] = {
        "design": {"type": "object", "properties": {"kind": {"enum": list(DESIGNS)}}, "required": ["kind"]}
    }
    keys["fit"] = _model(fit_form())
    keys["grade"]["enum"] = ["", *GRADES]
    keys["output"]["properties"]["figures"]["items"] = {"enum": list(PICTURES)}
    for section in ("indentation", "calibration", "indenter"):
        keys[section] = _table(MEANINGS[section], UNITS[section])
    reference = _table(MEANINGS["calibration.reference"], UNITS["calibration.reference"])
    keys["calibration"]["properties"]["reference"] = {"type": "array", "items": reference}
    for section, meanings in SECTIONS.items():
        owner = found
        for part in section.split(".") if section != "the study" else ():
            owner = owner["properties"][part]
        owner = owner.get("items", owner)
        for key, meaning in meanings.items():
            owner.setdefault("properties", {}).setdefault(key.strip('"'), {})["description"] = meaning
    one_of = [{"required": [name]} for name in ("problem", "indentation", "calibration")]
    del found["required"]
    return found | {"title": "study of winkler", "anyOf": one_of}
