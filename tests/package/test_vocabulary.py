"""Every quantity that a user reads or gives has one name, one symbol and one unit: those of the glossary."""

from __future__ import annotations

import dataclasses
import inspect
import keyword
import re

import pint

from winkler.vocabulary import GLOSSARY, OWNED, word

USER_LAYERS = (
    "materials", "laws", "profiles", "loading", "path", "path_steps", "program", "media", "foundation", "problems",
    "fields", "peaks", "fitting",
)  # fmt: skip
"""The layers whose values reach users; the mathematics below and the interfaces above have words of their own."""

RESULT_LAYERS = ("problems", "fields", "peaks")
"""The layers whose properties are results."""


def classes(modules, layers):
    """Return the public classes that were written in `layers`."""
    found = {}
    for module in modules:
        parts = module.__name__.split(".")
        if len(parts) < 2 or parts[1] not in layers or any(part.startswith("_") for part in parts):
            continue
        for name, item in vars(module).items():
            if inspect.isclass(item) and item.__module__ == module.__name__ and not name.startswith("_"):
                found[f"{module.__name__}.{name}"] = item
    return found


def known(owner: str, field: str) -> bool:
    try:
        return bool(word(owner, field))
    except KeyError:
        return False


def test_every_public_field_is_a_word(modules):
    values = {path: cls for path, cls in classes(modules, USER_LAYERS).items() if dataclasses.is_dataclass(cls)}
    assert len(values) > 20
    strangers = [
        f"{path}.{field.name}"
        for path, cls in values.items()
        for field in dataclasses.fields(cls)
        if not field.name.startswith("_") and not known(cls.__name__, field.name)
    ]
    assert strangers == [], "put these fields into winkler/vocabulary.py"


def test_every_public_property_of_an_answer_is_a_word(modules):
    strangers = []
    for path, cls in classes(modules, RESULT_LAYERS).items():
        for name, _member in inspect.getmembers(cls, lambda item: isinstance(item, property)):
            if not name.startswith("_") and not known(cls.__name__, name):
                strangers.append(f"{path}.{name}")
    assert strangers == [], "put these properties into winkler/vocabulary.py"


def test_an_owned_word_has_an_owner(modules):
    """A word of one class alone belongs to a class that exists and has it."""
    owners = {cls.__name__: cls for cls in classes(modules, (*USER_LAYERS, "study", "plot", "io")).values()}
    for owner, field in OWNED:
        assert owner in owners, f"{owner} does not exist"
        names = (
            {item.name for item in dataclasses.fields(owners[owner])}
            if dataclasses.is_dataclass(owners[owner])
            else set()
        )
        assert field in names or hasattr(owners[owner], field), f"{owner} has no {field}"


ENTRIES = [*GLOSSARY.items(), *((".".join(key), entry) for key, entry in OWNED.items())]


def incomplete(name, entry):
    """Return whether a name is none of Python, or its description is not one line with a whole symbol."""
    named = all(part.isidentifier() and not keyword.iskeyword(part) for part in name.split("."))
    stated = entry.meaning and "\n" not in entry.meaning and not entry.meaning.endswith(".")
    return not (named and stated and "$" not in entry.symbol and entry.symbol.count("{") == entry.symbol.count("}"))


def test_every_entry_is_complete():
    assert [name for name, entry in ENTRIES if incomplete(name, entry)] == []


def test_every_unit_is_si_without_a_prefix():
    """Apart from what is no quantity, and from units whose exponent depends on the law."""
    registry = pint.UnitRegistry()
    units = {name: entry.unit or "dimensionless" for name, entry in ENTRIES if entry.unit is not None}
    fixed = {name: unit for name, unit in units.items() if "n" not in re.findall(r"\b[a-z]\b", unit.partition("^")[2])}
    assert len(fixed) > 0.5 * len(ENTRIES)
    assert [name for name, unit in fixed.items() if registry.Quantity(1.0, unit).to_base_units().magnitude != 1.0] == []
