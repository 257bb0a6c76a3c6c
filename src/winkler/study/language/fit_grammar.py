"""The grammar of the section ``[fit]`` of a study file, except for the free numbers."""

from __future__ import annotations

import functools
import math
from typing import Any, Literal

from pydantic import BaseModel, StrictStr, create_model

from winkler.io.tables.given_units import checked_columns, checked_units
from winkler.study.language import json_forms, quantities
from winkler.study.language.correcting import CORRECTIONS
from winkler.study.language.json_forms import checked
from winkler.study.language.quantities import WHERE, wrong
from winkler.study.language.schema import FORBID, MISSING
from winkler.study.language.segmenting import stated_events, stated_segments
from winkler.values.errors import InvalidInput, suggest

PARTS: Any = Literal["approach", "hold", "retract", "both"]
FITTED_QUANTITIES: Any = Literal["force", "position"]
NOISE_SPECTRA: Any = Literal["unknown", "white"]
CALIBRATIONS: Any = Literal["thermal", "other"]
MOST_DEPTHS = 100


def corrections(raw: Any) -> tuple[str, ...]:
    """Refuse what is not a list of corrections."""
    if not isinstance(raw, list) or not raw or not all(isinstance(item, str) for item in raw):
        wrong(f'{WHERE} is {raw!r}; give a list of corrections in their order, such as ["drag", "baseline"].')
    for item in raw:
        if item not in CORRECTIONS:
            wrong(f"{WHERE} asks for '{item}'{suggest(item, CORRECTIONS)}; there are {', '.join(CORRECTIONS)}.")
    return tuple(raw)


def stated_units(raw: Any) -> tuple[tuple[str, str], ...]:
    """Refuse what is not a table of quantities and their units; return pairs in the order of their names."""
    try:
        return tuple(sorted(checked_units(raw, WHERE).items()))
    except InvalidInput as error:
        wrong(str(error))


def stated_columns(raw: Any) -> tuple[tuple[str, int], ...]:
    """Refuse what is not a table of quantities and the numbers of their columns; return pairs in their order."""
    try:
        return tuple(sorted(checked_columns(raw, WHERE).items()))
    except InvalidInput as error:
        wrong(str(error))


def _positive(unit: str) -> Any:
    def check(raw: Any) -> float:
        positive = float(quantities.number(raw, unit))
        if not positive > 0.0:
            wrong(f"{WHERE} is {raw!r}; it must be positive.")
        return positive

    return checked(check, lambda: json_forms.quantity(unit))


def relative_error(raw: Any) -> float:
    """Refuse what is not a part between 0 and 1, as 0.1 or "10 %"."""
    text = raw.strip().removesuffix("%") if isinstance(raw, str) else raw
    try:
        number = float(text) if not isinstance(text, bool) else math.nan
    except (TypeError, ValueError):
        number = math.nan
    number = 0.01 * number if isinstance(raw, str) and raw.strip().endswith("%") else number
    if not 0.0 < number < 1.0:
        wrong(f'{WHERE} is {raw!r}; give the standard error as a part, such as 0.1 or "10 %".')
    return number


def depth_count(raw: Any) -> int:
    """Refuse what is not a number of depths."""
    if isinstance(raw, bool) or not isinstance(raw, int) or not 2 <= raw <= MOST_DEPTHS:
        wrong(f"{WHERE} is {raw!r}; give a whole number of depths from 2 to {MOST_DEPTHS}.")
    return int(raw)


def shared_keys(raw: Any) -> tuple[str, ...]:
    """Refuse what is not a list of keys."""
    if not isinstance(raw, list) or not raw or not all(isinstance(item, str) for item in raw):
        wrong(f'{WHERE} is {raw!r}; give a list of free numbers, such as ["problem.bed.medium.first.young"].')
    return tuple(dict.fromkeys(raw))


def _texts_or_text() -> json_forms.Form:
    return {"anyOf": [json_forms.texts(), {"type": "string"}]}


@functools.cache
def fit_form() -> type[BaseModel]:
    """Return the input model of the section."""
    return create_model(
        "fit",
        __config__=FORBID,
        curve=(StrictStr, ...),
        part=(PARTS, ...),
        segments=(checked(stated_segments, _texts_or_text), MISSING),
        events=(checked(stated_events, _texts_or_text), MISSING),
        fitted=(FITTED_QUANTITIES, MISSING),
        free=(dict[str, Any], ...),
        spring_constant=(_positive("N/m"), MISSING),
        sensitivity=(_positive("m/V"), MISSING),
        units=(checked(stated_units, lambda: {"type": "object"}), MISSING),
        columns=(checked(stated_columns, lambda: {"type": "object"}), MISSING),
        frame_stiffness=(_positive("N/m"), MISSING),
        correct=(
            checked(corrections, lambda: {"type": "array", "minItems": 1, "items": {"enum": list(CORRECTIONS)}}),
            MISSING,
        ),
        noise=(Any, MISSING),
        noise_spectrum=(NOISE_SPECTRA, MISSING),
        time_limit=(_positive("s"), MISSING),
        spring_constant_error=(checked(relative_error, lambda: json_forms.quantity("")), MISSING),
        sensitivity_error=(checked(relative_error, lambda: json_forms.quantity("")), MISSING),
        spring_constant_by=(CALIBRATIONS, MISSING),
        over_depth=(checked(depth_count, lambda: {"type": "integer", "minimum": 2, "maximum": MOST_DEPTHS}), MISSING),
        shared=(checked(shared_keys, json_forms.texts), MISSING),
        model=(StrictStr, MISSING),
        models=(dict[str, dict[str, Any]], MISSING),
    )
