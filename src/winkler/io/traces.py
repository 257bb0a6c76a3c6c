"""Reference traces: a solution over its steps as text, for comparison with a discrete element code.

The file states the conventions in words, then all inputs in SI units, then the columns, to the last
digit.  CSV has the first two as comments; YAML has them as entries.
"""

from __future__ import annotations

import dataclasses
import json
import math
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from winkler.io.whole_file import write_whole_text
from winkler.numerics.types import Array
from winkler.problems.answer import is_solution
from winkler.values.errors import InvalidInput
from winkler.values.vocabulary import GLOSSARY, Word, own_word, word

CONVENTIONS = (
    "SI units throughout: m, s, kg, N, Pa, J, rad.",
    "Depth, approach and normal force are positive in compression; a negative force pulls.",
    "Depth counts from the first touch of the undeformed bodies; both bodies' displacements are added.",
    "Shift and shear force point in the same direction: the force is the one that moves the bodies by the shift.",
    "1/E* = sum of (1-nu^2)/E and 1/G* = sum of (2-nu)/(4G), over both bodies; Hertz is F = 4/3 E* sqrt(R) d^(3/2).",
    "Work of adhesion is the energy per area of separation, the sum of both surface energies less that of the "
    "interface; JKR pull-off is 3/2 pi w R.",
    "Energies are in J since the beginning; dissipation never falls.",
)
TRACE_ENDINGS = (".csv", ".yaml", ".yml")


def write_trace(solution: Any, path: str | os.PathLike[str]) -> Path:
    """Write a solution as a reference trace.

    Parameters
    ----------
    solution
        A solution with its problem and with columns over its steps, such as that of Indentation, Tangential, Impact,
        AdhesiveCycle and ElasticPlasticParticle.
    path : str or path
        The file; its ending, ``.csv``, ``.yaml`` or ``.yml``, states its kind.

    Returns
    -------
    Path

    Raises
    ------
    InvalidInput
        If the ending is another one, the file cannot be written, or the solution has no columns.
    """
    path = Path(path)
    if path.suffix not in TRACE_ENDINGS:
        raise InvalidInput(f"{path}: the ending is {path.suffix!r}; give .csv, .yaml or .yml.")
    if not is_solution(solution):
        raise InvalidInput(f"write_trace: a {type(solution).__name__} is no solution; give what solve() returns.")
    columns = _columns(solution)
    if not columns:
        raise InvalidInput(
            f"write_trace: the {type(solution).__name__} has no columns; solve for many loads, or along a path."
        )
    inputs = inputs_of(solution.problem)
    text = _csv(columns, inputs) if path.suffix == ".csv" else _yaml(columns, inputs)
    write_whole_text(path, text)
    return path


class ProblemInput(NamedTuple):
    """A text or number that a problem holds, and its unit."""

    content: str | float
    unit: str


def inputs_of(problem: Any) -> dict[str, ProblemInput]:
    """Return the inputs of a problem by dotted names; arrays are left out."""
    return dict(_inputs(problem, "problem", ""))


def _columns(solution: Any) -> dict[str, tuple[Word, Array]]:
    """Return the columns over the steps with their glossary entries; a vector in the plane gives two columns."""
    rows: dict[str, tuple[Word, Array]] = {}
    steps = 0
    for field in dataclasses.fields(solution):
        numbers = getattr(solution, field.name)
        if not isinstance(numbers, np.ndarray) or numbers.dtype.kind != "f":
            continue
        steps = steps or len(numbers)
        entry = word(type(solution), field.name)
        if numbers.shape == (steps,):
            rows[field.name] = (entry, numbers)
        elif numbers.shape == (steps, 2):
            rows[f"{field.name}_x"], rows[f"{field.name}_y"] = (entry, numbers[:, 0]), (entry, numbers[:, 1])
    return rows


def _inputs(thing: Any, name: str, unit: str) -> Iterator[tuple[str, ProblemInput]]:
    """Yield the texts and numbers of a value by dotted names; arrays are left out."""
    if dataclasses.is_dataclass(thing) and not isinstance(thing, type):
        yield name, ProblemInput(type(thing).__name__, "")
        for field in dataclasses.fields(thing):
            entry = own_word(type(thing), field.name) or GLOSSARY.get(field.name)
            yield from _inputs(getattr(thing, field.name), f"{name}.{field.name}", (entry and entry.unit) or "")
    elif isinstance(thing, bool | str):
        yield name, ProblemInput(str(thing), "")
    elif isinstance(thing, int | float):
        yield name, ProblemInput(float(thing), unit)
    elif isinstance(thing, tuple):
        for index, part in enumerate(thing):
            yield from _inputs(part, f"{name}.{index}", unit)


def _number(number: float) -> str:
    """Return a number to the last digit, in a form that every YAML reader takes for a number."""
    if math.isnan(number):
        return ".nan"
    if math.isinf(number):
        return ".inf" if number > 0.0 else "-.inf"
    mantissa, e, exponent = repr(float(number)).partition("e")
    return (mantissa if "." in mantissa else f"{mantissa}.0") + e + exponent


def _unit(entry: Word) -> str:
    return entry.unit or "-"


def _csv(columns: dict[str, tuple[Word, Array]], inputs: dict[str, ProblemInput]) -> str:
    lines = [f"# {sentence}" for sentence in CONVENTIONS]
    for name, (content, unit) in inputs.items():
        text = f"{_number(content)} {unit}" if isinstance(content, float) else content
        lines.append(f"# {name} = {text}".rstrip())
    lines += [f"# {name} [{_unit(entry)}]: {entry.meaning}" for name, (entry, _) in columns.items()]
    lines.append(", ".join(f"{name} [{_unit(entry)}]" for name, (entry, _) in columns.items()))
    rows = zip(*(numbers.tolist() for _, numbers in columns.values()), strict=True)
    lines += [", ".join(map(repr, row)) for row in rows]
    return "\n".join(lines) + "\n"


def _yaml(columns: dict[str, tuple[Word, Array]], inputs: dict[str, ProblemInput]) -> str:
    lines = ["conventions:", *(f"  - {json.dumps(sentence)}" for sentence in CONVENTIONS), "asked:"]
    for name, (content, _) in inputs.items():
        text = _number(content) if isinstance(content, float) else json.dumps(content)
        lines.append(f"  {json.dumps(name)}: {text}")
    lines.append("columns:")
    for name, (entry, numbers) in columns.items():
        lines.append(f"  {name}:")
        lines.append(f"    unit: {json.dumps(_unit(entry))}")
        lines.append(f"    meaning: {json.dumps(entry.meaning)}")
        lines.append(f"    values: [{', '.join(map(_number, numbers.tolist()))}]")
    return "\n".join(lines) + "\n"
