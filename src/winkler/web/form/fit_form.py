"""The form of a fit: the curve, calibration of the measurement, the free parameters, and the model."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from winkler.plot.series import name_in_words
from winkler.study.language.correcting import CORRECTIONS
from winkler.study.language.explain import completed
from winkler.study.language.fit_reading import FITTED
from winkler.study.language.fit_study import OF_A_CURVE, OF_A_TIMED_CURVE
from winkler.study.language.grammar import SECTIONS
from winkler.vocabulary import Word
from winkler.web.form import form
from winkler.web.form.form import FormEntry, FormPart, Many, Slot
from winkler.web.form.typed import field_text

__all__ = [
    "Choice",
    "FreeNumber",
    "bounds",
    "choices",
    "free_numbers",
    "initial_table",
    "key_in_words",
    "measurement",
    "model",
    "numbers_in",
]

RELAXES = FITTED[-1]
PLACEHOLDERS = ("problem.load", "problem.path")
"""Keys of the model that the curve replaces."""
INITIALLY_FREE: dict[str, dict[str, Any]] = {
    "indentation": {"problem.bed.medium.first.young": True},
    "adhesive_indentation": {"problem.bed.medium.first.young": True, "problem.law.work": True},
    RELAXES: {"problem.bed.medium.first.shear": True, "problem.bed.medium.first.exponent": [0.01, 0.9]},
}
"""Initially free parameters, in addition to the contact point and the baseline."""
ELASTIC_SAMPLE = {"kind": "half_space", "first": {"kind": "elastic", "young": "1 kPa", "poisson": 0.5}}
VISCOELASTIC_SAMPLE = {
    "kind": "viscoelastic_half_space",
    "first": {
        "kind": "power_law_solid",
        "shear": "1 kPa",
        "time_scale": "1 s",
        "exponent": 0.3,
        "shortest": "1 ms",
        "longest": "100 s",
    },
}
NUMERIC = ("quantity", "number", "list of quantity", "list of number")
CURVE_PARTS = {
    "approach": "the approach",
    "hold": "the approach and the hold",
    "retract": "the retraction",
    "both": "approach and retraction",
}
DRIVEN = {"force": "forces along the measured motion", "position": "positions under the measured forces"}
NUMBERS = {"spring_constant": "N/m", "sensitivity": "m/V", "frame_stiffness": "N/m"}
"""Keys of the measurement, with units; that of the noise depends on what is fitted."""


class FreeNumber(NamedTuple):
    """One free parameter.

    Parameters
    ----------
    key
        As in the study: ``problem.bed.medium.first.young`` or ``contact_point``.
    label
        In words.
    word
        Symbol, unit and meaning.
    low, high
        Bounds as typed; the first alone is a start value.
    """

    key: str
    label: str
    word: Word
    low: str
    high: str


class Choice(NamedTuple):
    """A key of the measurement that takes one of a few words."""

    path: str
    label: str
    hint: str
    names: dict[str, str]
    chosen: str


def initial_table(kind: str) -> dict[str, Any]:
    """Return the initial table of a fit: a bead on a soft sample."""
    problem = completed({"kind": kind})
    for path in PLACEHOLDERS:
        problem.pop(path.rpartition(".")[2], None)
    problem["bed"] = {
        "kind": "foundation",
        "profile": {"kind": "paraboloid", "curvature_radius": "5 um"},
        "medium": completed(VISCOELASTIC_SAMPLE if kind == RELAXES else ELASTIC_SAMPLE),
    }
    free = {**INITIALLY_FREE[kind], "contact_point": True, "baseline": True}
    part = "both" if kind == RELAXES else "approach"
    return {"title": "fit of a curve", "problem": problem, "fit": {"curve": "", "part": part, "free": free}}


def model(table: dict[str, Any]) -> FormPart:
    """Return the form of the model, without the load, which the curve replaces."""
    whole = form.part_of(table)
    return whole._replace(children=tuple(one for one in whole.children if one.path not in PLACEHOLDERS))


def numbers_in(part: FormPart) -> Iterator[FormEntry]:
    """Yield the entries of a form that hold a number, or a list of numbers."""
    for child in part.children:
        match child:
            case FormEntry() if (
                child.text and child.takes.startswith(NUMERIC) and not child.path.endswith(".tolerance")
            ):
                yield child
            case Slot(part=FormPart() as inside):
                yield from numbers_in(inside)
            case Many():
                for inside in child.parts:
                    yield from numbers_in(inside)


def key_in_words(key: str) -> str:
    """Return a key of a study in words.

    Examples
    --------
    >>> key_in_words("problem.bed.medium.layers.0.solid.young"), key_in_words("contact_point")
    ("medium › layer 1 › solid › Young's modulus", 'contact point')
    """
    words: list[str] = []
    for word in key.removeprefix("problem.").removeprefix("bed.").split("."):
        if word.isdecimal() and words:
            words[-1] = f"{words[-1].removesuffix('s')} {int(word) + 1}"
        else:
            words.append(name_in_words(word))
    return " › ".join(words)


def _candidates(table: dict[str, Any]) -> dict[str, Word]:
    """Return all parameters that may be free, with their glossary entries."""
    relaxes = form.at(table, "problem.kind") == RELAXES
    result = dict(OF_A_TIMED_CURVE if relaxes else OF_A_CURVE)
    return result | {one.path: one.word for one in numbers_in(model(table))}


def free_numbers(table: dict[str, Any]) -> tuple[tuple[FreeNumber, ...], dict[str, str]]:
    """Return the free parameters, and the labels of all others by key."""
    candidates, free = _candidates(table), form.at(table, "fit.free")
    stated = free if isinstance(free, dict) else {}
    result = []
    for key, content in stated.items():
        texts = content if isinstance(content, list) else [] if content is True or content == {} else [content]
        low, high = (field_text(texts[place]) if place < len(texts) else "" for place in (0, 1))
        word = candidates.get(key) or candidates.get(key.rpartition(".")[0]) or Word("", "", "")
        result.append(FreeNumber(key, key_in_words(key), word, low, high))
    return tuple(result), {key: key_in_words(key) for key in candidates if key not in stated}


def bounds(low: str, high: str, unit: str) -> Any:
    """Return the entry of ``[fit.free]`` for two typed bounds, which the checks of the study validate."""
    from winkler.web.form.typed import typed

    takes = f"quantity [{unit}]" if unit else "number"
    stated = [typed(text, takes) for text in (low, high) if text.strip()]
    if len(stated) == 2:
        return stated
    if high.strip():
        return [typed("", "text"), stated[0]]  # an upper bound alone: the check reports the missing lower one
    return stated[0] if stated else True


def choices(table: dict[str, Any]) -> tuple[Choice, ...]:
    """Return the choices of the fitted part and quantity of the curve."""
    relaxes = form.at(table, "problem.kind") == RELAXES
    parts = {name: CURVE_PARTS[name] for name in CURVE_PARTS if name != ("retract" if relaxes else "hold")}
    section_keys = SECTIONS["fit"]
    result = [Choice("fit.part", "part of the curve", section_keys["part"], parts, str(form.at(table, "fit.part")))]
    if relaxes:
        driven = str(form.at(table, "fit.fitted") or "force")
        result.append(Choice("fit.fitted", "what is fitted", section_keys["fitted"], DRIVEN, driven))
    return tuple(result)


def measurement(table: dict[str, Any]) -> tuple[FormEntry, ...]:
    """Return the entries of the measurement."""
    hints = SECTIONS["fit"]
    units = NUMBERS | {"noise": "m" if form.at(table, "fit.fitted") == "position" else "N"}
    numbers = (
        form.entry_at(table, f"fit.{name}", name.replace("_", " "), hints[name], f"quantity [{unit}]", unit=unit)
        for name, unit in units.items()
    )
    steps = f"in their order, any of {', '.join(CORRECTIONS)}; no other correction is applied"
    return (
        *numbers,
        form.entry_at(table, "fit.segments", "segments", hints["segments"], "list of text"),
        form.entry_at(table, "fit.events", "events", hints["events"], "list of text"),
        form.entry_at(table, "fit.correct", "corrections", steps, "list of text"),
    )
