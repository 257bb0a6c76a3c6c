"""A study or a fit as Python that gives the same numbers, and as the commands that solve it."""

from __future__ import annotations

import dataclasses
import enum
import math
from collections.abc import Mapping
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.study.chapters.contents import answer_of
from winkler.study.finding.finding import public_names
from winkler.study.language.designs import Crossed
from winkler.study.language.study import Study
from winkler.values.checks.contract import is_a

if TYPE_CHECKING:
    from winkler.study.language.fit_study import FitStudy

MOST_NUMBERS = 400
"""Numbers of an array that are written out; a study with larger ones is read from its file."""
WIDTH = 100
"""Characters of a line up to which a call stays on it."""
SHOWN = 3
"""Answers that the script prints."""


class _Unwritten(Exception):
    """What has no short form as Python."""


SOLVED = ("winkler.study.batch.run", "run", "winkler.study.language.reading", "read_study")
FITTED = ("winkler.study.batch.fit_run", "fit_study", "winkler.study.language.fit_reading", "read_fit_study")
"""Module and function that solve a study or fit its curves, and module and function that read its file."""


def command_text(name: str = "study.toml", *, fits: bool = False) -> str:
    """Return the commands that solve a study from its file, and write its report.

    Parameters
    ----------
    name
        Name of the study file.
    fits
        Whether it is one with ``[fit]``.
    """
    quoted = f"'{name}'" if any(letter in name for letter in " '\"$&()") else name
    if fits:
        return f"winkler fit {quoted}\nwinkler fit {quoted} --pages 1\nwinkler fit {quoted} --json\n"
    return f"winkler run {quoted}\nwinkler report {quoted} --interactive\nwinkler report {quoted} --page\n"


def python_text(study: Study | FitStudy, name: str = "study.toml") -> str:
    """Return a script that builds the problem of a study, solves it, over its sweep too, and prints its answers.

    Numbers are those of the study to the last digit.  A study that holds large arrays, a sweep whose values are drawn,
    or a fit with its curves, is read from its file.

    Parameters
    ----------
    study
        The study.
    name
        Name of its file.
    """
    if not isinstance(study, Study):
        return _from_file(name, *FITTED)
    try:
        writer = _ProblemText(study)
        depth = len(writer.variables)
        problem = writer.expression(study.problem, "problem", depth)
        loops = [
            f"{'    ' * place}for {variable} in {writer.values(key, place)}:"
            for place, (key, variable) in enumerate(writer.variables.items())
        ]
    except _Unwritten:
        return _from_file(name, *SOLVED)
    headline = answer_of(study.problem).headline[:SHOWN]
    printed = ", ".join([*writer.variables.values(), *(f"solution.{answer}" for answer in headline)]) or "solution"
    lines = [f"problem = {problem}", "solution = problem.solve()", f"print({printed})"]
    indent = "    " * depth
    body = "\n".join([*loops, *(f"{indent}{line}" for line in lines)])
    imports = ["import numpy as np\n"] if "np." in body else []
    imports += ["import winkler as wk\n", *sorted(writer.imports)]
    return f"{''.join(imports)}\n{body}\n"


def _from_file(name: str, solver: str, solve: str, reader: str, read: str) -> str:
    """Return a script that reads a study from its file, solves it, and prints its table."""
    return (
        f"from pathlib import Path\n\nfrom {solver} import {solve}\nfrom {reader} import {read}\n\n"
        f"outcome = {solve}({read}(Path({name!r})))\n"
        "for column in outcome.table():\n    print(column.name, column.word.unit, column.content)\n"
    )


class _ProblemText:
    """Expressions of the values of one study.

    Parameters
    ----------
    study
        Whose varied keys become variables.
    """

    def __init__(self, study: Study) -> None:
        if not isinstance(study.design, Crossed):
            raise _Unwritten
        self.study = study
        self.imports: set[str] = set()
        self.variables: dict[str, str] = {}
        for axis in study.axes:
            variable = axis.key.rpartition(".")[2]
            taken = variable in self.variables.values() or not variable.isidentifier()
            self.variables[axis.key] = axis.key.replace(".", "_").removeprefix("problem_") if taken else variable

    def values(self, key: str, level: int) -> str:
        """Return a list of the values of a varied key."""
        axis = next(axis for axis in self.study.axes if axis.key == key)
        return self.expression(tuple(axis.values), "", level)

    def expression(self, content: Any, path: str, level: int) -> str:
        """Return an expression for a value at a path of the study, whose lines after the first have an indent."""
        if path in self.variables:
            return self.variables[path]
        if isinstance(content, enum.Enum):
            return f"{self._name(type(content))}.{content.name}"
        if content is None or isinstance(content, bool | int | str):
            return repr(content)
        if isinstance(content, float | np.floating):
            return self._number(float(content))
        if isinstance(content, np.ndarray):
            return self._array(content)
        if isinstance(content, PurePath):
            return repr(str(content))
        if isinstance(content, Mapping):
            parts = [(f"{key!r}: ", f"{path}.{key}", inside) for key, inside in content.items()]
            return self._joined("{", parts, "}", level)
        if isinstance(content, tuple | list) and not hasattr(content, "_fields"):
            parts = [("", f"{path}.{place}", inside) for place, inside in enumerate(content)]
            return self._joined("[", parts, "]", level)
        if dataclasses.is_dataclass(content) and not isinstance(content, type):
            return self._call(content, path, level)
        raise _Unwritten

    def _call(self, content: Any, path: str, level: int) -> str:
        parts = []
        for field in dataclasses.fields(content):
            inside = getattr(content, field.name)
            if not field.init or is_a(inside, "winkler.loading.path_steps:Unchanged"):
                continue
            varied = any(
                key == f"{path}.{field.name}" or key.startswith(f"{path}.{field.name}.") for key in self.variables
            )
            if not varied and _is_default(field, inside):
                continue
            parts.append((f"{field.name}=", f"{path}.{field.name}", inside))
        return self._joined(f"{self._name(type(content))}(", parts, ")", level)

    def _joined(self, head: str, parts: list[tuple[str, str, Any]], tail: str, level: int) -> str:
        texts = [f"{label}{self.expression(inside, path, level + 1)}" for label, path, inside in parts]
        line = f"{head}{', '.join(texts)}{tail}"
        if "\n" not in line and len(line) + 4 * level <= WIDTH:
            return line
        indent = "    " * (level + 1)
        rows = "".join(f"\n{indent}{text}," for text in texts)
        return f"{head}{rows}\n{'    ' * level}{tail}"

    def _array(self, content: np.ndarray) -> str:
        if content.size > MOST_NUMBERS or content.dtype.kind not in "bfiu":
            raise _Unwritten
        if content.ndim == 0:
            return self._number(float(content))
        return f"np.array({self.expression(content.tolist(), '', 0)})"

    @staticmethod
    def _number(number: float) -> str:
        """Return a number to its last digit, in the shorter of two forms."""
        if math.isnan(number):
            return "np.nan"
        if math.isinf(number):
            return "np.inf" if number > 0.0 else "-np.inf"
        mantissa, exponent = f"{number:.12e}".split("e")
        short = f"{mantissa.rstrip('0').rstrip('.')}e{int(exponent)}"
        return short if float(short) == number and len(short) + 2 < len(repr(number)) else repr(number)

    def _name(self, cls: type) -> str:
        if public_names().get(cls.__name__) == cls.__module__:
            return f"wk.{cls.__name__}"
        self.imports.add(f"from {cls.__module__} import {cls.__name__}\n")
        return cls.__name__


def _is_default(field: Any, inside: Any) -> bool:
    if field.default is not dataclasses.MISSING:
        default = field.default
    elif field.default_factory is not dataclasses.MISSING:
        default = field.default_factory()
    else:
        return False
    if isinstance(default, np.ndarray) or isinstance(inside, np.ndarray):
        return np.array_equal(np.asarray(default, dtype=object), np.asarray(inside, dtype=object))
    return type(default) is type(inside) and bool(default == inside)
