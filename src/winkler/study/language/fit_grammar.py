"""The grammar of the section ``[fit]`` of a study file, except for the free numbers."""

from __future__ import annotations

import functools
from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, StrictStr, create_model

from winkler.errors import InvalidInput, suggest
from winkler.io.tables.given_units import checked_units
from winkler.study.language import quantities
from winkler.study.language.correcting import CORRECTIONS
from winkler.study.language.quantities import WHERE, wrong
from winkler.study.language.schema import FORBID, MISSING
from winkler.study.language.segmenting import stated_events, stated_segments

__all__ = ["fit_form"]

PARTS: Any = Literal["approach", "hold", "retract", "both"]
FITTED_QUANTITIES: Any = Literal["force", "position"]


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


def _positive(unit: str) -> Any:
    def check(raw: Any) -> float:
        positive = float(quantities.number(raw, unit))
        if not positive > 0.0:
            wrong(f"{WHERE} is {raw!r}; it must be positive.")
        return positive

    return Annotated[Any, BeforeValidator(check)]


@functools.cache
def fit_form() -> type[BaseModel]:
    """Return the input model of the section."""
    return create_model(
        "fit",
        __config__=FORBID,
        curve=(StrictStr, ...),
        part=(PARTS, ...),
        segments=(Annotated[Any, BeforeValidator(stated_segments)], MISSING),
        events=(Annotated[Any, BeforeValidator(stated_events)], MISSING),
        fitted=(FITTED_QUANTITIES, MISSING),
        free=(dict[str, Any], ...),
        spring_constant=(_positive("N/m"), MISSING),
        sensitivity=(_positive("m/V"), MISSING),
        units=(Annotated[Any, BeforeValidator(stated_units)], MISSING),
        frame_stiffness=(_positive("N/m"), MISSING),
        correct=(Annotated[Any, BeforeValidator(corrections)], MISSING),
        noise=(Any, MISSING),
        time_limit=(_positive("s"), MISSING),
    )
