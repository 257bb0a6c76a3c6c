"""The picture of an answer that has no sheet of its own: its numbers over load, path or time, else its contact."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from winkler.plot.curves import curves_panel
from winkler.plot.dispatch import Answered, sheet_of, without_extent
from winkler.plot.panel import Sheet, titled
from winkler.plot.series import Series, name_in_words, row_of, with_unit
from winkler.values.errors import InvalidInput
from winkler.values.vocabulary import word

MOST_PANELS = 6
ALONG = ("time", "distance", "cycles", "cycle")


@without_extent(Answered)
def answer_sheet(item: Any) -> Sheet:
    """Return the numbers of an answer over its load, path or time; of one load the contact that it holds.

    Parameters
    ----------
    item
        A solution with fields of the glossary, or with ``__words__`` of its own.

    Raises
    ------
    InvalidInput
        If it holds neither several numbers of one quantity nor a contact that has a picture.
    """
    rows = _rows(item)
    numbers = {name: float(row.content[-1]) for name, row in rows.items()}
    title = "   ".join(f"{name_in_words(name)} {with_unit(numbers[name], rows[name].word.unit)}" for name in rows)
    longest = max((row.content.size for row in rows.values()), default=0)
    many = {name: row for name, row in rows.items() if row.content.size == longest > 1}
    if len(many) < 2:
        contact = getattr(item, "contact", None)
        if contact is None:
            raise InvalidInput(
                f"draw: a {type(item).__name__} has one number of each quantity and no contact, so there is nothing "
                "to show; solve it for several loads, or register a picture of it."
            )
        return dataclasses.replace(sheet_of(contact), title=title)
    along = _abscissa(item, many)
    over = {name: row for name, row in many.items() if name != along.name}
    drawn = list(over.items())[:MOST_PANELS]
    panels = [curves_panel(along, [(row, "")]) for _, row in drawn]
    names = [f"{name_in_words(name)} over {name_in_words(along.name)}" for name, _ in drawn]
    return Sheet(titled(panels, *names), min(len(panels), 3), width=4.2)


def _rows(item: Any) -> dict[str, Series]:
    """Return the numbers of an answer in rows, without those that are not finite."""
    rows = {}
    for field in dataclasses.fields(item):
        content = getattr(item, field.name)
        if not isinstance(content, float | np.ndarray) or np.ndim(content) > 1 or not np.size(content):
            continue
        if word(type(item), field.name).unit is not None and np.all(np.isfinite(content)):
            rows[field.name] = row_of(item, field.name)
    return rows


def _abscissa(item: Any, many: dict[str, Series]) -> Series:
    """Return time, distance or cycles; else the load that was prescribed; else the first number."""
    load = getattr(item.problem, "load", None)
    prescribed = dataclasses.fields(load)[0].name if dataclasses.is_dataclass(load) else ""
    size = next(iter(many.values())).content.size
    if prescribed and prescribed not in many and np.size(getattr(load, prescribed)) == size:
        return row_of(load, prescribed)
    return next((many[name] for name in (*ALONG, prescribed) if name in many), next(iter(many.values())))
