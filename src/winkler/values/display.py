"""The display of a value: one or a few lines for ``repr``, a table with units for notebooks.

A small value reads as the call that makes it, ``Sphere(curvature_radius=0.01)``.A solution, and a value that does not
fit a line, becomes a block: a line for each field, numbers with the unit of the glossary, arrays as shape and range::

    IndentationSolution
      problem  Indentation(bed=Foundation(...), load=Force(...))
      depth    (1000,) 1.617e-08 ... 1.617e-06 m

Only fields are shown, because these are computed already; the notes on validity, which notebooks show too, are
computed.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from winkler.values.errors import WinklerError
from winkler.values.readable import scale_of, with_unit
from winkler.values.vocabulary import word

CALL_WIDTH = 240
"""Most characters of a value that is written as the call that makes it."""
LINE_WIDTH = 96
FEW_NUMBERS = 6
"""Arrays and tuples up to this length are written in full."""
MOST_LINES = 9
"""Most lines of a block below its title; further fields are named in the last one."""


class FieldRow(NamedTuple):
    """One field: its name, its unit (None if it is no quantity), what it means, its content, the error of that."""

    name: str
    unit: str | None
    meaning: str
    content: Any
    error: float | None = None


def short(content: Any) -> str:
    """Return the ``repr`` of a value: a call if it is small, else a block of a few lines."""
    if not _is_solution(content):
        text = _call(content, CALL_WIDTH) or _outline(content, LINE_WIDTH)
        if "(...)" not in text:
            return text
    return block(content)


def block(content: Any) -> str:
    """Return the title of a value and a line for each of its fields."""
    rows = list(_rows(content))
    listed = rows if len(rows) <= MOST_LINES else rows[: MOST_LINES - 1]
    width = max((len(row.name) for row in listed), default=0)
    lines = [type(content).__name__, *(f"  {row.name:<{width}}  {_plain(row, LINE_WIDTH - width)}" for row in listed)]
    if rest := [row.name for row in rows[len(listed) :]]:
        lines.append(f"  and {_cut(', '.join(rest), LINE_WIDTH)}")
    return "\n".join(lines)


def html_table(content: Any) -> str:
    """Return a table of the fields of a value, with the prefixes that fit the numbers, and its notes on validity.

    It becomes the ``_repr_html_`` of values, which notebooks show.
    """
    import html  # which holds the names of all characters

    cells = "".join(
        f'<tr><th style="text-align:left" title="{html.escape(row.meaning)}">{html.escape(row.name)}</th>'
        f'<td style="text-align:left">{html.escape(_with_prefix(row))}</td></tr>'
        for row in _rows(content)
    )
    notes = "".join(f"<li>{html.escape(note)}</li>" for note in _notes(content))
    title = f'<caption style="text-align:left">{html.escape(type(content).__name__)}</caption>'
    return f"<table>{title}<tbody>{cells}</tbody></table>" + (f"<ul>{notes}</ul>" if notes else "")


def _is_solution(content: Any) -> bool:
    return "problem" in getattr(content, "__dataclass_fields__", ())


def _rows(content: Any) -> Iterator[FieldRow]:
    """Yield the fields of a value; of a fit first its result."""
    FIT_FIELDS = {"model", "names", "values", "standard_errors"}
    fields = [field.name for field in dataclasses.fields(content) if field.repr]
    if FIT_FIELDS.issubset(fields):
        for path, number, error in zip(content.names, content.values, content.standard_errors, strict=True):
            yield _row(_owner(content.model, path), path.rpartition(".")[2], number)._replace(name=path, error=error)
        fields = [name for name in fields if name not in {*FIT_FIELDS, "correlation"}]
    for name in sorted(fields, key=lambda name: name != "problem"):
        yield _row(type(content), name, getattr(content, name))


def _row(owner: type, name: str, content: Any) -> FieldRow:
    try:
        entry = word(owner, name)
    except KeyError:
        return FieldRow(name, None, "", content)
    return FieldRow(name, entry.unit, entry.meaning, content)


def _owner(model: Any, path: str) -> type:
    """Return the class that a path such as ``bed.medium.first.young`` ends in."""
    inside = model
    for step in path.split(".")[:-1]:
        inside = inside[int(step)] if step.isdecimal() and isinstance(inside, tuple) else getattr(inside, step, None)
    return type(inside)


def _notes(content: Any) -> list[str]:
    if not hasattr(type(content), "validity"):
        return []
    try:
        return [f"{note.standing.value}: {note.statement}" for note in content.validity]
    except WinklerError as error:
        return [str(error)]


def _call(content: Any, width_left: int) -> str:
    """Return the call that makes a value, or the number or text that it is; empty if it does not fit."""
    if dataclasses.is_dataclass(content) and not isinstance(content, type):
        parts: list[str] = []
        used = len(type(content).__name__) + 2
        for field in dataclasses.fields(content):
            if field.repr:
                part = _call(getattr(content, field.name), width_left - used - len(field.name) - 1)
                if not part:
                    return ""
                parts.append(f"{field.name}={part}")
                used += len(parts[-1]) + 2
        text = f"{type(content).__name__}({', '.join(parts)})"
    elif isinstance(content, np.ndarray):
        text = repr(content) if content.size <= FEW_NUMBERS else ""
    elif type(content) is tuple:
        inner = [_call(item, width_left) for item in content] if len(content) <= FEW_NUMBERS else [""]
        text = f"({', '.join(inner)}{',' * (len(inner) == 1)})" if all(inner) else ""
    else:
        text = repr(content)
    return text if len(text) <= width_left and "\n" not in text else ""


def _outline(content: Any, width_left: int) -> str:
    """Return a call in which arrays are shape and range, and parts that do not fit are left out."""
    name = type(content).__name__
    if isinstance(content, np.ndarray):
        return _range(content, 1.0, "")
    if isinstance(content, tuple):
        kinds = {type(item).__name__ for item in content}
        return _call(content, width_left) or f"{len(content)} x {kinds.pop() if len(kinds) == 1 else 'various'}"
    if not dataclasses.is_dataclass(content) or isinstance(content, type):
        return _cut(" ".join(repr(content).split()), width_left)
    rows = list(_rows(content)) if not _is_solution(content) else []
    for width in (width_left, width_left // 2, 0):  # the narrower a part, the more of it is left out
        text = f"{name}({', '.join(f'{row.name}={_plain(row, width)}' for row in rows)})"
        if rows and len(text) <= width_left:
            return text
    return f"{name}(...)"


def _plain(row: FieldRow, width_left: int) -> str:
    """Return the content of a row in SI units."""
    unit = f" {row.unit}" if row.unit else ""
    if isinstance(row.content, float):
        error = "" if row.error is None else f" +- {row.error:.2g}"
        return f"{row.content + 0.0:.5g}{error}{unit}"
    if isinstance(row.content, np.ndarray):
        return _range(row.content, 1.0, unit)
    return _call(row.content, width_left) or _outline(row.content, width_left)


def _with_prefix(row: FieldRow) -> str:
    """Return the content of a row in the unit that fits it."""
    if isinstance(row.content, float):
        text = with_unit(row.content, row.unit)
        return text if row.error is None else f"{text} ± {with_unit(row.error, row.unit, 2)}"
    if isinstance(row.content, np.ndarray) and row.content.dtype.kind == "f":
        scale = scale_of(row.unit, row.content)
        return _range(row.content, scale.factor, f" {scale.unit}".rstrip())
    return _plain(row, 2 * LINE_WIDTH)


def _range(numbers: np.ndarray, factor: float, unit: str) -> str:
    """Return the shape of an array, the least and the greatest of its finite numbers; or all, if these are few."""
    shape = f"({', '.join(map(str, numbers.shape))}{',' * (numbers.ndim == 1)})"
    if numbers.dtype.kind == "b":
        return f"{shape} {np.count_nonzero(numbers)} true"
    if numbers.dtype.kind != "f":
        return f"{shape} {numbers.dtype.name}"
    numbers = numbers + 0.0  # of -0.0 zero
    if numbers.ndim == 1 and numbers.size <= FEW_NUMBERS:
        return f"[{' '.join(f'{number / factor:.5g}' for number in numbers)}]{unit}"
    finite = numbers[np.isfinite(numbers)]
    if not finite.size:
        return f"{shape} {'no finite numbers' if numbers.size else 'empty'}"
    return f"{shape} {finite.min() / factor:.5g} ... {finite.max() / factor:.5g}{unit}"


def _cut(text: str, width_left: int) -> str:
    return text if len(text) <= max(width_left, 3) else f"{text[: max(width_left, 3) - 3]}..."
