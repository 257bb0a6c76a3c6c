"""A study in sentences and as a table of inputs, from its values and the glossary."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

import numpy as np

from winkler.study.language import keys
from winkler.study.language.catalogue import kind_of
from winkler.study.language.study import Study
from winkler.study.language.varied import Axis, Range
from winkler.values.readable import name_in_words, scale_of, with_unit
from winkler.values.vocabulary import Word, own_word, word

ROLES = {
    "profile": "The shape is {a}.",
    "plane_profile": "The equivalent plane profile g(x) is given directly: {a}.",
    "first": "The body below is {adjective}.",
    "second": "The body above is {adjective}.",
    "layers": "The coating, from the surface down: {plain}.",
    "on": "What carries them is {adjective}.",
    "grading": "The body below is graded: {plain}.",
    "load": "Prescribed: {plain}.",
    "path": "The path: {plain}.",
    "law": "Law: {plain}.",
}
"""Sentence for a part of a problem; other parts are described by their name."""

GROUP_TITLES = {"first": "body below (z > 0)", "second": "body above (z < 0)", "on": "what carries the layers"}

SINGULARS = {"layers": "layer", "steps": "step"}
"""Singular of the names of lists."""

KIND_LABELS = {"measured": "measured profile"}
"""Words for kinds whose name does not fit a sentence."""

MOST_LISTED = 6
"""Numbers of an array that are listed; longer ones are described by their ends."""


class Input(NamedTuple):
    """One row of the table of inputs.

    Parameters
    ----------
    group
        The part of the problem that it belongs to, such as ``profile: sphere``.
    name, symbol
        Of the glossary; the symbol in LaTeX.
    text
        The given value, with its unit.
    meaning
        One line.
    """

    group: str
    name: str
    symbol: str
    text: str
    meaning: str


def inputs(study: Study) -> tuple[Input, ...]:
    """Return all inputs, part by part."""
    swept = {axis.key: axis for axis in study.sweep}
    return tuple(_rows(study.problem, "problem", _label(study.problem), swept))


def _label(content: Any) -> str:
    kind = kind_of(type(content)) or type(content).__name__
    return KIND_LABELS.get(kind, kind).replace("_", " ")


def _name(owner: type, field: str) -> str:
    """Return the name of a field in words; a name with another meaning for its owner stays as it is."""
    return field.replace("_", " ") if own_word(owner, field) else name_in_words(field)


def _left_out(inside: Any) -> bool:
    """Return whether a step leaves a load as it is; its class is not loaded for contacts without a path."""
    return type(inside).__name__ == "Unchanged"


def _rows(content: Any, path: str, group: str, swept: dict[str, Axis | Range]) -> Iterator[Input]:
    owner = type(content)
    below: list[tuple[Any, str, str]] = []
    for field in dataclasses.fields(content):
        inside = getattr(content, field.name)
        if not field.init or _left_out(inside):  # computed fields, and values that were not given
            continue
        entry = word(owner, field.name)
        key = f"{path}.{field.name}"
        name = _name(owner, field.name)
        if key in swept:
            yield Input(group, name, entry.symbol, f"varied: {_axis_text(swept[key], entry)}", entry.meaning)
        elif dataclasses.is_dataclass(inside):
            title = f"{GROUP_TITLES.get(field.name, name)}: {_label(inside)}"
            if field.name == "solid":  # of a layer, which is identified by its number
                title = f"{group}, {title}"
            below.append((inside, key, title))
            if not dataclasses.fields(inside):
                yield Input(title, "", "", "nothing to give", entry.meaning)
        elif isinstance(inside, tuple) and inside and all(dataclasses.is_dataclass(item) for item in inside):
            for number, item in enumerate(inside):
                single = SINGULARS.get(field.name, name)
                label = _label(item)
                title = f"{single} {number + 1}" + (f": {label}" if label != single else "")
                below.append((item, f"{key}.{number}", title))
        elif not _is_left_out(inside, field):
            yield Input(
                group, name, entry.symbol, _content_text(content, field.name, inside, path, swept), entry.meaning
            )
    for inside, key, title in below:
        yield from _rows(inside, key, title, swept)


def _is_left_out(content: Any, field: dataclasses.Field[Any]) -> bool:
    """Return whether a number is infinite by default, or a text or an array has nothing in it, and so is not given."""
    if isinstance(content, str | np.ndarray):
        return len(np.ravel(content)) == 0 or np.array_equal(content, "")
    return isinstance(content, float) and math.isinf(content) and field.default == content


def _content_text(owner: Any, field: str, content: Any, path: str, swept: dict[str, Axis | Range]) -> str:
    from winkler.study.language import quantities

    indexed = quantities.INDEXED.get((type(owner).__name__, field))
    if indexed is not None:
        return ", ".join(with_unit(float(number), indexed(place), 6) for place, number in enumerate(content))
    if isinstance(content, tuple) and all(isinstance(number, int) for number in content):
        return " × ".join(map(str, content))
    if isinstance(content, tuple):
        parts = [
            f"{name} = varied" if f"{path}.{field}.{name}" in swept else f"{name} = {with_unit(float(number), '', 6)}"
            for name, number in content
        ]
        return ", ".join(parts) or "none"
    if isinstance(content, bool | str):
        return {True: "yes", False: "no"}.get(content, str(content)) if isinstance(content, bool) else content
    return values_text(content, quantities.unit_in(owner, field))


def values_text(content: Any, unit: str | None) -> str:
    """Return a number or an array for reading, with its unit.

    Examples
    --------
    >>> values_text(0.01, "m"), values_text(np.linspace(0.0, 5e-9, 200), "m")
    ('10 mm', '200 values from 0 to 5 nm')
    """
    numbers = np.ravel(np.asarray(content, dtype=float))
    if numbers.size <= MOST_LISTED:
        return ", ".join(with_unit(float(number), unit, 6) for number in numbers)
    low, high = float(numbers.min()), float(numbers.max())
    scale = scale_of(unit, numbers)
    if low == 0.0 or abs(low) > 1e-3 * abs(high):
        return f"{numbers.size} values from {with_unit(low / scale.factor, '', 6)} to {with_unit(high, unit, 6)}"
    return f"{numbers.size} values from {with_unit(low, unit, 6)} to {with_unit(high, unit, 6)}"


def _axis_text(axis: Axis | Range, entry: Word) -> str:
    if isinstance(axis, Range):
        ends = f"{with_unit(axis.start, entry.unit, 6)} to {with_unit(axis.stop, entry.unit, 6)}"
        return ends if axis.scale == "linear" else f"{ends}, evenly in its logarithm"
    if axis.numeric:
        return values_text(np.array(axis.values, dtype=float), entry.unit)
    labels = [content_label(item, entry.unit) for item in axis.values]
    return "; ".join(labels) if any(isinstance(item, tuple) for item in axis.values) else ", ".join(labels)


def content_label(content: Any, unit: str | None = None) -> str:
    """Return a short name for a value of a varied key of a unit: ``sphere (curvature radius = 10 mm)``."""
    return _described(content, "", set()) if dataclasses.is_dataclass(content) else keys.label(content, unit)


def setting_text(study: Study, axis: Axis | Range, content: Any) -> str:
    """Return one value of a varied key for reading: ``force = 10 N``."""
    name, unit = axis.key.rpartition(".")[2].replace("_", " "), keys.word_at(study, axis.key).unit
    if isinstance(content, int | float):
        return f"{name} = {with_unit(float(content), unit, 6)}"
    return f"{name}: {content_label(content, unit)}"


def settings_text(study: Study, settings: Iterable[Any]) -> str:
    """Return the values of the varied keys at one point for reading."""
    pairs = zip(study.sweep, settings, strict=True)
    return ", ".join(setting_text(study, axis, content) for axis, content in pairs)


def in_words(study: Study) -> str:
    """Return the problem in sentences."""
    from winkler.study.language.explain import summary  # not loaded for numbers alone

    swept = {axis.key for axis in study.sweep}
    sentences = [summary(type(study.problem))]
    for path, role, content in _parts(study.problem, "problem"):
        known = ROLES.get(role, f"{role.replace('_', ' ').capitalize()}: {{plain}}.")
        describe_part = _listed if isinstance(content, tuple) else _described
        plain = "varied" if path in swept else describe_part(content, path, swept)
        article = "" if plain == "varied" else "an " if plain[:1] in "aeiou" else "a "
        sentences.append(known.format(a=f"{article}{plain}", adjective=plain, plain=plain))
    for axis in study.sweep:
        entry = keys.word_at(study, axis.key)
        sentences.append(f"Varied: {axis.key.removeprefix('problem.')} = {_axis_text(axis, entry)}.")
    if len(study.sweep) > 1 or study.design.draws:
        sentences.append(study.design.sentence)
    return " ".join(sentences)


def _parts(content: Any, path: str) -> Iterator[tuple[str, str, Any]]:
    """Yield ``(key, role, value)`` of every value inside that is described on its own, in the order of their fields."""
    for field in dataclasses.fields(content):
        inside = getattr(content, field.name)
        key = f"{path}.{field.name}"
        if isinstance(inside, tuple) and inside and all(dataclasses.is_dataclass(item) for item in inside):
            yield key, field.name, inside
        if not dataclasses.is_dataclass(inside):
            continue
        if field.name in ("bed", "medium"):
            yield from _parts(inside, key)
        else:
            yield key, field.name, inside


def _listed(content: tuple[Any, ...], path: str, swept: set[str]) -> str:
    return " + ".join(_described(item, f"{path}.{number}", swept) for number, item in enumerate(content))


def _described(content: Any, path: str, swept: set[str]) -> str:
    """Return the name of a value with its numbers in brackets."""
    parts = []
    for field in dataclasses.fields(content):
        inside = getattr(content, field.name)
        key = f"{path}.{field.name}"
        if not field.init or _left_out(inside):
            continue
        if key in swept:
            parts.append(f"{_name(type(content), field.name)} varied")
        elif dataclasses.is_dataclass(inside):
            parts.append(_described(inside, key, swept))
        elif isinstance(inside, tuple) and inside and all(dataclasses.is_dataclass(item) for item in inside):
            parts.append(_listed(inside, key, swept))
        elif isinstance(inside, float | np.ndarray) and not _is_left_out(inside, field):
            name = _name(type(content), field.name)
            parts.append(f"{name} = {_content_text(content, field.name, inside, path, {})}")
        elif isinstance(inside, str) and inside:
            parts.append(inside)
    label = _label(content)
    if len(parts) == 1 and label == parts[0].partition(" ")[0]:
        return parts[0]
    return f"{label} ({', '.join(parts)})" if parts else label
