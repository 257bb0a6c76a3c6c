"""The grammar of the sections of a study file: title, sweep, fields, output, expect."""

from __future__ import annotations

import functools
from typing import Any

from pydantic import BaseModel, StrictBool, StrictStr, create_model

from winkler.study.language import json_forms, quantities
from winkler.study.language.json_forms import checked
from winkler.study.language.quantities import WHERE, wrong
from winkler.study.language.schema import FORBID, MISSING, choice
from winkler.study.language.study import Places

SECTIONS: dict[str, dict[str, str]] = {
    "the study": {
        "title": "one line for tables, figures and the report; the name of the file if left out",
        "problem": "what is solved: a table with a kind",
        "sweep": "keys of the problem that vary",
        "fit": "measured curves, and the numbers of the problem to be fitted; for `winkler fit`",
        "fields": "where pressures, displacements and stresses are restored",
        "output": "what is written",
        "expect": "numbers that must come out, one [[expect]] each",
        "source": "of a literature case: where the expected numbers come from",
        "grade": "of a literature case: how independent they are, such as analytical or cross-code",
    },
    "sweep": {
        '"problem.load.force"': "the values of a key in turn: a list or a range { from, to, count, spacing }; "
        "or the range { from, to, scale } that a design draws from",
        "design": "which points are solved, a table with a kind: crossed (the default), zipped, or with a count and a "
        "seed latin_hypercube, sobol, sensitivity",
    },
    "fields": {
        "r": 'distances from the axis: lengths, or multiples of the contact radius a, as "2 a"; a list or a range',
        "z": "depths below the surface, positive in the first body; leave it out for surface fields only",
    },
    "fit": {
        "curve": "a file, a folder or a pattern such as 'gel/*.csv', relative to the study",
        "part": "approach, hold (with the approach, of a body that relaxes), retract or both",
        "segments": 'where the curve is loaded, held and unloaded, if not as detected: a list such as "hold 12 s" or, '
        'by the number of the point, "hold 1200"; or "found", whatever the file states',
        "events": 'what happened, if not as found: a list such as "baseline 0 s to 2.5 s", "pop-in 3.1 s", also by the '
        'numbers of the points; or "none"',
        "fitted": "force, or of a body that relaxes position, which then follows from the measured forces",
        "free": "what is fitted: a table, one key of the problem or of the curve in each line",
        "spring_constant": "of the cantilever, where the file does not state it; replaces the file's",
        "sensitivity": "deflection per volt, where the file holds a voltage",
        "units": 'of columns that the file does not state: { position = "nm", force = "uN", time = "s" }',
        "columns": "numbers of columns of a text table without names, from 1: { position = 1, force = 2 }",
        "frame_stiffness": "of the frame of the machine, which deforms too",
        "correct": "corrections in their order: a list of baseline, drift, drag, saturation, interference, clock",
        "noise": "standard deviation of what is fitted; read from the points out of contact if left out",
        "noise_spectrum": "white, if the noise is known to be independent from point to point; unknown if left out",
        "time_limit": "the longest that the fit of one curve may take; without end if left out",
        "spring_constant_error": 'standard error of the spring constant as a part, 0.1 or "10 %"',
        "sensitivity_error": "standard error of the sensitivity, as a part",
        "spring_constant_by": "thermal, if the spring constant was found from thermal noise with this sensitivity",
        "over_depth": "a number of greatest depths, from 2 to 100; the fit is repeated up to each",
        "shared": "free numbers that are the same for all curves: a list of their keys",
        "model": "the name of the problem among the models",
        "models": "other models: a table by name, each with the keys of the problem that differ, and free",
    },
    "fit.free": {
        '"problem.bed.medium.first.young"': "a number of the problem: bounds as a list of two, a start, or true",
        "contact_point": "where the curve first touches: the same",
        "baseline": "force out of contact: the same",
        "tilt": "change of the baseline with the position: the same",
        "drift": "of the position, of a body that relaxes: the same",
        "drag": "of a liquid on the cantilever, over its velocity, of a body that relaxes: the same",
        "inertia": "mass that moves with the probe, of curves with even times: the same",
    },
    "output": {
        "folder": "folder of the results; results/NAME if left out",
        "figures": "formats of the figures: a list of svg, png, pdf",
        "report": "whether report.html is written: true or false",
        "workbook": "whether the tables are also written as tables.xlsx: true or false",
    },
    "expect": {
        "quantity": "an answer (depth), a restored field (pressure, von_mises), a function (line_load), or a path",
        "value": "a quantity, or a number with its unit in unit; a list where the load is one, or for each point",
        "unit": "unit of value and scale, where they are numbers",
        "tolerance": "largest allowed deviation, relative to the value or to scale",
        "scale": "what deviations are relative to; needed where the value is zero",
        "r": "of a field: distance from the axis",
        "x": "of a function along the springs: place; of a field in the axes of the bodies: along x",
        "y": "of a field in the axes of the bodies: along y, with x and z",
        "z": "of a field below the surface: depth",
    },
}
"""Section -> key -> meaning."""


PLACE_KEYS = ("r", "x", "y", "z")
"""Keys of ``[[expect]]`` that give the place in a field."""


def places(raw: Any) -> Places:
    """Return places as lengths, or as multiples of the contact radius, written with the unit ``a``."""
    if isinstance(raw, str):
        raw = [raw]
    if isinstance(raw, dict) and "values" in raw and raw.get("unit") == "a":
        return Places(quantities.numbers({"values": raw["values"]}, ""), relative=True)
    texts = raw if isinstance(raw, list) else [raw.get("from"), raw.get("to")] if isinstance(raw, dict) else []
    relative = [isinstance(text, str) and text.split()[1:] == ["a"] for text in texts]
    if any(relative):
        if not all(relative):
            wrong(f"{WHERE} mixes lengths and multiples of the contact radius a; use one of both.")
        plain = [str(text).split()[0] for text in texts]
        raw = {**raw, "from": plain[0], "to": plain[1]} if isinstance(raw, dict) else plain
        return Places(quantities.numbers(raw, ""), relative=True)
    return Places(quantities.numbers(raw, "m"))


def picture_formats(raw: Any) -> Any:
    """Refuse what is not a list of texts."""
    if not isinstance(raw, list) or not all(isinstance(item, str) for item in raw):
        wrong(f'{WHERE} is {raw!r}; give a list of formats, such as ["svg", "png"].')
    return tuple(raw)


def _text(raw: Any) -> Any:
    if not isinstance(raw, str):
        wrong(f'{WHERE} is {raw!r}, not text; give the name of an answer or a field, such as "depth".')
    return raw


def _either_value(raw: Any) -> Any:
    if isinstance(raw, bool) or not isinstance(raw, str | int | float | list):
        wrong(f"{WHERE} is {raw!r}; give a quantity or a number, or a list of them.")
    return raw


def _fit(raw: Any) -> BaseModel:
    from winkler.study.language.fit_grammar import fit_form  # with what corrects curves, which studies have no use for

    return fit_form().model_validate(raw)


@functools.cache
def study_form() -> type[BaseModel]:
    """Return the input model of a whole study."""
    where = checked(places, json_forms.places)
    fields = create_model("fields", __config__=FORBID, r=(where, ...), z=(where, MISSING))
    output = create_model(
        "output",
        __config__=FORBID,
        folder=(StrictStr, MISSING),
        figures=(checked(picture_formats, json_forms.texts), MISSING),
        report=(StrictBool, MISSING),
        workbook=(StrictBool, MISSING),
    )
    expect = create_model(
        "expect",
        __config__=FORBID,
        quantity=(checked(_text, lambda: {"type": "string"}), ...),
        value=(checked(_either_value, lambda: {"type": ["string", "number", "array"]}), ...),
        unit=(StrictStr, MISSING),
        tolerance=(Any, ...),
        scale=(Any, MISSING),
        r=(Any, MISSING),
        z=(Any, MISSING),
        x=(Any, MISSING),
        y=(Any, MISSING),
    )
    return create_model(
        "study",
        __config__=FORBID,
        title=(StrictStr, ""),
        source=(StrictStr, ""),
        grade=(StrictStr, ""),
        problem=(choice("problem"), ...),
        sweep=(dict[str, Any], {}),  # pydantic copies it
        fields=(fields, MISSING),
        fit=(checked(_fit, dict), MISSING),
        output=(output, MISSING),
        expect=(list[expect], []),  # type: ignore[valid-type]
    )


def section_keys(section: str) -> tuple[str, ...]:
    """Return the keys that a section of a study takes; none if it is no section."""
    return tuple(SECTIONS.get(section.partition("[")[0], {}))
