"""Every quantity that a user reads or gives has one name, one symbol and one unit: those of the glossary."""

from __future__ import annotations

import dataclasses
import inspect
import keyword
import re

import pint
import pytest

from winkler.profiles.flat import FlatPunch
from winkler.values.value import words
from winkler.values.vocabulary import CHAPTERS, GLOSSARY, word

USER_LAYERS = (
    "materials", "laws", "profiles", "loading", "media", "foundation", "problems", "fields", "fitting",
)  # fmt: skip
"""The layers whose values reach users; the mathematics below and the interfaces above have words of their own."""

RESULT_LAYERS = ("problems", "fields")
"""The layers whose properties are results."""
PLACE = "put these names into __words__ of their classes, or into winkler/vocabulary if others have them too"


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


def known(owner: type, field: str) -> bool:
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
        if not field.name.startswith("_") and not known(cls, field.name)
    ]
    assert strangers == [], PLACE


def test_every_public_property_of_an_answer_is_a_word(modules):
    strangers = []
    for path, cls in classes(modules, RESULT_LAYERS).items():
        for name, _member in inspect.getmembers(cls, lambda item: isinstance(item, property)):
            if not name.startswith("_") and not known(cls, name):
                strangers.append(f"{path}.{name}")
    assert strangers == [], PLACE


def test_the_words_of_a_class_are_of_its_fields_and_properties(owners):
    strangers = [
        f"{cls.__qualname__}.{name}"
        for cls in owners
        for name in vars(cls)["__words__"]
        if name not in getattr(cls, "__dataclass_fields__", {}) and not hasattr(cls, name)
    ]
    assert strangers == []


def test_a_word_of_a_class_comes_before_that_of_its_base_and_the_shared_one():
    class Base:
        __words__ = words(radius=("b", "m", "of the base"), depth=("e", "m", "of the base"))

    class Derived(Base):
        __words__ = words(radius=("c", "m", "its own"))

    assert [word(Derived, name).meaning for name in ("radius", "depth")] == ["its own", "of the base"]
    assert word(Derived, "force") == GLOSSARY["force"]
    with pytest.raises(KeyError):
        word(Derived, "nonsense")


def test_words_are_no_part_of_a_value():
    """No field, and nothing that is pickled, shown or compared."""
    punch = FlatPunch(1e-3)
    assert word(FlatPunch, "radius").symbol == "b"
    assert [field.name for field in dataclasses.fields(punch)] == list(dataclasses.asdict(punch)) == ["radius"]
    assert repr(punch) == "FlatPunch(radius=0.001)"
    assert list(punch.__getstate__()) == ["radius"]


def test_no_name_stands_in_two_chapters_of_the_glossary():
    assert sum(map(len, CHAPTERS)) == len(GLOSSARY)


def incomplete(name, entry):
    """Return whether a name is none of Python, or its description is not one line with a whole symbol."""
    named = all(part.isidentifier() and not keyword.iskeyword(part) for part in name.split("."))
    stated = entry.meaning and "\n" not in entry.meaning and not entry.meaning.endswith(".")
    return not (named and stated and "$" not in entry.symbol and entry.symbol.count("{") == entry.symbol.count("}"))


def test_every_entry_is_complete(entries):
    assert [name for name, entry in entries.items() if incomplete(name, entry)] == []


def test_every_unit_is_si_without_a_prefix(entries):
    """Apart from what is no quantity, and from units whose exponent depends on the law."""
    registry = pint.UnitRegistry()
    units = {name: entry.unit or "dimensionless" for name, entry in entries.items() if entry.unit is not None}
    fixed = {name: unit for name, unit in units.items() if "n" not in re.findall(r"\b[a-z]\b", unit.partition("^")[2])}
    assert len(fixed) > 0.5 * len(entries)
    assert [name for name, unit in fixed.items() if registry.Quantity(1.0, unit).to_base_units().magnitude != 1.0] == []
