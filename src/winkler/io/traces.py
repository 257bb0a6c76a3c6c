"""Reference traces: a solution over its steps, in a text that tells a discrete element code all it must agree on.

The file begins with the conventions in words, then says what was asked, with every number in SI units, then holds the
columns, to the last digit.  CSV has the first two as comments; YAML has them as entries.
"""

from __future__ import annotations

import dataclasses
import json
import math
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.io.whole_file import write_whole_text
from winkler.numerics.types import Array
from winkler.problems.answer import is_solution
from winkler.vocabulary import GLOSSARY, Word, own_word, word

__all__ = ["CONVENTIONS", "asked_of", "write_trace"]

CONVENTIONS = (
    "SI units throughout: m, s, kg, N, Pa, J, rad.",
    "Depth, approach and normal force are positive in compression; a negative force pulls.",
    "Depth counts from the first touch of the undeformed bodies; both bodies' displacements are added.",
    "Shift and shear force point the same way: the force is the one that moves the bodies by the shift.",
    "1/E* = sum of (1-nu^2)/E and 1/G* = sum of (2-nu)/(4G), over both bodies; Hertz is F = 4/3 E* sqrt(R) d^(3/2).",
    "Work of adhesion is the energy per area that parting takes, the sum of both surface energies less that of the "
    "interface; JKR pull-off is 3/2 pi w R.",
    "Energies are in J since the beginning; dissipation never falls.",
)
ENDINGS = (".csv", ".yaml", ".yml")
Stated = tuple[str, str | float, str]
"""A dotted name of what was given, its content, its unit."""


def write_trace(solution: Any, path: str | os.PathLike[str]) -> Path:
    """Write a solution as a reference trace.

    Parameters
    ----------
    solution
        An answer with a problem and with columns over its steps, such as those of Indentation, Tangential, Impact,
        AdhesiveCycle and ElasticPlasticParticle.
    path : str or path
        The file; its ending, ``.csv``, ``.yaml`` or ``.yml``, says which kind.

    Returns
    -------
    Path

    Raises
    ------
    InvalidInput
        If the ending is another one, the file cannot be written, or what is given has no columns.
    """
    path = Path(path)
    if path.suffix not in ENDINGS:
        raise InvalidInput(f"{path}: the ending is {path.suffix!r}; give .csv, .yaml or .yml.")
    if not is_solution(solution):
        raise InvalidInput(f"write_trace: a {type(solution).__name__} is no solution; give what solve() returns.")
    columns = _columns(solution)
    if not columns:
        raise InvalidInput(
            f"write_trace: the {type(solution).__name__} has no columns; solve for many loads, or along a path."
        )
    asked = tuple(_stated(solution.problem, "problem"))
    text = _csv(columns, asked) if path.suffix == ".csv" else _yaml(columns, asked)
    write_whole_text(path, text)
    return path


def asked_of(problem: Any) -> dict[str, str | float]:
    """Return what a problem holds, by dotted names; rows are left out."""
    return {name: content for name, content, _ in _stated(problem, "problem")}


def _columns(solution: Any) -> dict[str, tuple[Word, Array]]:
    """Return the columns over the steps, with what the glossary says; those in the plane as two."""
    found: dict[str, tuple[Word, Array]] = {}
    steps = 0
    for field in dataclasses.fields(solution):
        numbers = getattr(solution, field.name)
        if not isinstance(numbers, np.ndarray) or numbers.dtype.kind != "f":
            continue
        steps = steps or len(numbers)
        known = word(type(solution), field.name)
        if numbers.shape == (steps,):
            found[field.name] = (known, numbers)
        elif numbers.shape == (steps, 2):
            found[f"{field.name}_x"], found[f"{field.name}_y"] = (known, numbers[:, 0]), (known, numbers[:, 1])
    return found


def _stated(thing: Any, name: str, unit: str = "") -> Iterator[Stated]:
    """Yield what a value holds, by dotted names, with units; rows are columns or paths and are left out."""
    if dataclasses.is_dataclass(thing) and not isinstance(thing, type):
        yield name, type(thing).__name__, ""
        for field in dataclasses.fields(thing):
            entry = own_word(type(thing), field.name) or GLOSSARY.get(field.name)
            yield from _stated(getattr(thing, field.name), f"{name}.{field.name}", (entry and entry.unit) or "")
    elif isinstance(thing, bool | str):
        yield name, str(thing), ""
    elif isinstance(thing, int | float):
        yield name, float(thing), unit
    elif isinstance(thing, tuple):
        for index, part in enumerate(thing):
            yield from _stated(part, f"{name}.{index}")


def _number(number: float) -> str:
    """Return a number to the last digit, so that every reader takes it for one."""
    if math.isnan(number):
        return ".nan"
    if math.isinf(number):
        return ".inf" if number > 0.0 else "-.inf"
    mantissa, e, exponent = repr(float(number)).partition("e")
    return (mantissa if "." in mantissa else f"{mantissa}.0") + e + exponent


def _unit(known: Word) -> str:
    return known.unit or "-"


def _csv(columns: dict[str, tuple[Word, Array]], asked: tuple[Stated, ...]) -> str:
    lines = [f"# {sentence}" for sentence in CONVENTIONS]
    for name, thing, unit in asked:
        lines.append(f"# {name} = {f'{_number(thing)} {unit}' if isinstance(thing, float) else thing}".rstrip())
    lines += [f"# {name} [{_unit(known)}]: {known.meaning}" for name, (known, _) in columns.items()]
    lines.append(", ".join(f"{name} [{_unit(known)}]" for name, (known, _) in columns.items()))
    rows = zip(*(numbers.tolist() for _, numbers in columns.values()), strict=True)
    lines += [", ".join(map(repr, row)) for row in rows]
    return "\n".join(lines) + "\n"


def _yaml(columns: dict[str, tuple[Word, Array]], asked: tuple[Stated, ...]) -> str:
    lines = ["conventions:", *(f"  - {json.dumps(sentence)}" for sentence in CONVENTIONS), "asked:"]
    for name, thing, _ in asked:
        lines.append(f"  {json.dumps(name)}: {_number(thing) if isinstance(thing, float) else json.dumps(thing)}")
    lines.append("columns:")
    for name, (known, numbers) in columns.items():
        lines.append(f"  {name}:")
        lines.append(f"    unit: {json.dumps(_unit(known))}")
        lines.append(f"    meaning: {json.dumps(known.meaning)}")
        lines.append(f"    values: [{', '.join(map(_number, numbers.tolist()))}]")
    return "\n".join(lines) + "\n"
