"""The form of a fit: the curve, what is known of its measurement, the numbers that it is to tell, and the model."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from winkler.plot.series import spoken
from winkler.study.language.correcting import CORRECTIONS
from winkler.study.language.explain import completed
from winkler.study.language.fit_reading import FITTED
from winkler.study.language.fit_study import OF_A_CURVE, OF_A_TIMED_CURVE
from winkler.study.language.grammar import SECTIONS
from winkler.vocabulary import Word
from winkler.web.form import form
from winkler.web.form.form import Entry, Many, Part, Slot
from winkler.web.form.typed import shown

__all__ = ["Choice", "Line", "begun", "bounds", "choices", "lines", "measurement", "model", "numbers_in", "spoken_key"]

RELAXES = FITTED[-1]
PLACEHOLDERS = ("problem.load", "problem.path")
"""What the curve replaces."""
OPEN: dict[str, dict[str, Any]] = {
    "indentation": {"problem.bed.medium.first.young": True},
    "adhesive_indentation": {"problem.bed.medium.first.young": True, "problem.law.work": True},
    RELAXES: {"problem.bed.medium.first.shear": True, "problem.bed.medium.first.exponent": [0.01, 0.9]},
}
"""What is fitted to begin with, beside the contact point and the baseline."""
SOFT = {"kind": "half_space", "first": {"kind": "elastic", "young": "1 kPa", "poisson": 0.5}}
LIVING = {
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
PARTS = {"approach": "the way in", "hold": "the way in and the hold", "retract": "the way out", "both": "both ways"}
DRIVEN = {"force": "forces, the motion drives", "position": "positions, the forces drive"}
NUMBERS = {"spring_constant": "N/m", "sensitivity": "m/V", "frame_stiffness": "N/m", "noise": ""}
"""What is known of the measurement, with units."""


class Line(NamedTuple):
    """One number that the curve is to tell.

    Parameters
    ----------
    key
        As in the study: ``problem.bed.medium.first.young`` or ``contact_point``.
    label
        In words.
    word
        Symbol, unit and meaning.
    low, high
        Bounds as typed; only the first is a start, none is neither.
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


def begun(kind: str) -> dict[str, Any]:
    """Return the table of a fit, to begin with: a bead on something soft."""
    problem = completed({"kind": kind})
    for path in PLACEHOLDERS:
        problem.pop(path.rpartition(".")[2], None)
    problem["bed"] = {
        "kind": "foundation",
        "profile": {"kind": "paraboloid", "curvature_radius": "5 um"},
        "medium": completed(LIVING if kind == RELAXES else SOFT),
    }
    free = {**OPEN[kind], "contact_point": True, "baseline": True}
    part = "both" if kind == RELAXES else "approach"
    return {"title": "fit of a curve", "problem": problem, "fit": {"curve": "", "part": part, "free": free}}


def model(table: dict[str, Any]) -> Part:
    """Return the form of the model, without the load, which the curve replaces."""
    whole = form.part_of(table)
    return whole._replace(children=tuple(one for one in whole.children if one.path not in PLACEHOLDERS))


def numbers_in(part: Part) -> Iterator[Entry]:
    """Yield the keys of a form at which a number stands, or a row of them."""
    for child in part.children:
        match child:
            case Entry() if child.text and child.takes.startswith(NUMERIC) and not child.path.endswith(".tolerance"):
                yield child
            case Slot(part=Part() as inside):
                yield from numbers_in(inside)
            case Many():
                for inside in child.parts:
                    yield from numbers_in(inside)


def spoken_key(key: str) -> str:
    """Return a key of a study in words.

    Examples
    --------
    >>> spoken_key("problem.bed.medium.layers.0.solid.young"), spoken_key("contact_point")
    ("medium › layer 1 › solid › Young's modulus", 'contact point')
    """
    words: list[str] = []
    for word in key.removeprefix("problem.").removeprefix("bed.").split("."):
        if word.isdecimal() and words:
            words[-1] = f"{words[-1].removesuffix('s')} {int(word) + 1}"
        else:
            words.append(spoken(word))
    return " › ".join(words)


def _open(table: dict[str, Any]) -> dict[str, Word]:
    """Return everything that may be free, with its word."""
    relaxes = form.at(table, "problem.kind") == RELAXES
    found = dict(OF_A_TIMED_CURVE if relaxes else OF_A_CURVE)
    return found | {one.path: Word(one.symbol, one.unit, one.hint) for one in numbers_in(model(table))}


def lines(table: dict[str, Any]) -> tuple[tuple[Line, ...], dict[str, str]]:
    """Return the numbers that are free, and all others that might be: key -> words."""
    known, free = _open(table), form.at(table, "fit.free")
    given = free if isinstance(free, dict) else {}
    found = []
    for key, content in given.items():
        texts = content if isinstance(content, list) else [] if content is True or content == {} else [content]
        low, high = (shown(texts[place]) if place < len(texts) else "" for place in (0, 1))
        word = known.get(key) or known.get(key.rpartition(".")[0]) or Word("", "", "")
        found.append(Line(key, spoken_key(key), word, low, high))
    return tuple(found), {key: spoken_key(key) for key in known if key not in given}


def bounds(low: str, high: str, unit: str) -> Any:
    """Return what stands in ``[fit.free]`` for two typed bounds; the study's checks find what is wrong with them."""
    from winkler.web.form.typed import typed

    takes = f"quantity [{unit}]" if unit else "number"
    given = [typed(text, takes) for text in (low, high) if text.strip()]
    if len(given) == 2:
        return given
    if high.strip():
        return [typed("", "text"), given[0]]  # an upper bound alone: the lower one is missed, beside its field
    return given[0] if given else True


def choices(table: dict[str, Any]) -> tuple[Choice, ...]:
    """Return which part of the curve is fitted, and what of it."""
    relaxes = form.at(table, "problem.kind") == RELAXES
    parts = {name: PARTS[name] for name in PARTS if name != ("retract" if relaxes else "hold")}
    told = SECTIONS["fit"]
    found = [Choice("fit.part", "part of the curve", told["part"], parts, str(form.at(table, "fit.part")))]
    if relaxes:
        driven = str(form.at(table, "fit.fitted") or "force")
        found.append(Choice("fit.fitted", "what is fitted", told["fitted"], DRIVEN, driven))
    return tuple(found)


def measurement(table: dict[str, Any]) -> tuple[Entry, ...]:
    """Return what may be told of the measurement."""
    told = SECTIONS["fit"]
    by_position = form.at(table, "fit.fitted") == "position"
    found = []
    for name, unit_ in NUMBERS.items():
        unit = unit_ or ("m" if by_position else "N")
        text = shown(form.at(table, f"fit.{name}"))
        found.append(
            Entry(f"fit.{name}", name.replace("_", " "), "", unit, told[name], f"quantity [{unit}]", text, False)
        )
    steps = shown(form.at(table, "fit.correct"))
    hint = f"in their order, any of {', '.join(CORRECTIONS)}; nothing is corrected that is not named"
    ways = shown(form.at(table, "fit.segments"))
    found.append(Entry("fit.segments", "segments", "", "", told["segments"], "list of text", ways, False))
    return (*found, Entry("fit.correct", "corrections", "", "", hint, "list of text", steps, False))
