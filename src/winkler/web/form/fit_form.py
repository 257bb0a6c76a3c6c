"""The form of a fit: the curve, calibration of the measurement, the free parameters, and the model."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from winkler.plot.series import name_in_words
from winkler.study.language.explain import completed
from winkler.study.language.fit_study import FITTED, OF_A_CURVE, OF_A_TIMED_CURVE
from winkler.values.vocabulary import Word
from winkler.web.form import form
from winkler.web.form.form import FormEntry, FormPart, Many, Slot
from winkler.web.form.sample_curve import METAL_SAMPLE as METAL_SAMPLE_CURVE
from winkler.web.form.sample_curve import RELAXING_SAMPLE
from winkler.web.form.typed import field_text

RELAXES = FITTED[-1]
YIELDS = "plastic_indentation"
CURVE = "fit.curve"
"""The key of the measured curve."""
RADIUS = ("problem.bed.profile.curvature_radius", "5 um")
"""The key of the radius of the tip, and what it is before anybody has entered one."""
PLACEHOLDERS = ("problem.load", "problem.path")
"""Keys of the model that the curve replaces."""
INITIALLY_FREE: dict[str, dict[str, Any]] = {
    "indentation": {"problem.bed.medium.first.young": True},
    "adhesive_indentation": {"problem.bed.medium.first.young": True, "problem.law.work": True},
    YIELDS: {"problem.bed.medium.first.strength": True},
    RELAXES: {"problem.bed.medium.first.shear": True, "problem.bed.medium.first.exponent": [0.01, 0.9]},
}
"""Initially free parameters, in addition to the contact point and the baseline."""
ELASTIC_SAMPLE = {"kind": "half_space", "first": {"kind": "elastic", "young": "1 kPa", "poisson": 0.5}}
METAL_SAMPLE = {
    "kind": "half_space",
    "first": {"kind": "elastic", "young": "210 GPa", "poisson": 0.3, "strength": "500 MPa"},
}
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
SAMPLES = {RELAXES: VISCOELASTIC_SAMPLE, YIELDS: METAL_SAMPLE}
"""What kinds of models are pressed into, unless it is elastic."""
OWN_SAMPLES = {RELAXES: RELAXING_SAMPLE, YIELDS: METAL_SAMPLE_CURVE}
"""The made curves to which these can be fitted."""
NUMERIC = ("quantity", "number", "list of quantity", "list of number")


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


def initial_table(kind: str) -> dict[str, Any]:
    """Return the initial table of a fit: a bead on a soft sample."""
    problem = completed({"kind": kind})
    for path in PLACEHOLDERS:
        problem.pop(path.rpartition(".")[2], None)
    problem["bed"] = {
        "kind": "foundation",
        "profile": {"kind": "paraboloid", "curvature_radius": RADIUS[1]},
        "medium": completed(SAMPLES.get(kind, ELASTIC_SAMPLE)),
    }
    free = {**INITIALLY_FREE[kind], "contact_point": True, "baseline": True}
    part = "both" if kind in SAMPLES else "approach"
    return {"title": "fit of a curve", "problem": problem, "fit": {"curve": "", "part": part, "free": free}}


def model_remark(table: dict[str, Any]) -> str:
    """Return what the numbers of the model mean, and which of them nobody has entered."""
    known = "Fixed parameters keep these values; free ones start from them."
    key, initial = RADIUS
    if form.at(table, key) == initial:
        known += f" The radius of the tip, {initial}, is a guess: enter that of your tip."
    return known


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
    from winkler.web.form.field_units import completed_text, shown_unit
    from winkler.web.form.typed import typed

    shown = shown_unit(low, shown_unit(high, "")) if unit else ""  # a bare number is one of the unit beside it
    low, high = (completed_text(text, "quantity" if unit else "number", shown) for text in (low, high))
    takes = f"quantity [{unit}]" if unit else "number"
    stated = [typed(text, takes) for text in (low, high) if text.strip()]
    if len(stated) == 2:
        return stated
    if high.strip():
        return [typed("", "text"), stated[0]]  # an upper bound alone: the check reports the missing lower one
    return stated[0] if stated else True
