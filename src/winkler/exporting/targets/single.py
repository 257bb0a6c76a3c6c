"""A law in C with numbers of single precision: the same text with another type, and how far it is off."""

from __future__ import annotations

import re
from typing import Any

import numpy as np

from winkler.exporting.step_law import StepLaw
from winkler.exporting.targets.c_law import c_law
from winkler.exporting.translation.plain import plain
from winkler.values.errors import InvalidInput

WORST, MARGIN = 1e-3, 10.0
"""A law that is further off has no use in single precision; compilers may be so many times as far off as Python."""
TOKENS = re.compile(
    r"""(?P<kept>/\*.*?\*/|"(?:[^"\\]|\\.)*"|^\#include[^\n]*)
    |(?P<number>(?<![\w.])(?:\d+\.\d*|\.\d+|\d+(?=[eE]))(?:[eE][+-]?\d+)?(?![\w.]))
    |(?P<word>[A-Za-z_]\w*)""",
    re.DOTALL | re.MULTILINE | re.VERBOSE,
)
NAMES = (
    "fabs pow sqrt cbrt exp expm1 log log1p sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh hypot "
    "copysign floor ceil erf erfc fmod"
)
FUNCTIONS = frozenset(NAMES.split())
SMALLEST, LARGEST = float(np.finfo(np.float32).tiny), float(np.finfo(np.float32).max)


def in_single(text: str) -> str:
    """Return a text in C with `float` for `double`, its literals and functions; comments stay as they are."""
    return TOKENS.sub(_single, text)


def _single(found: re.Match[str]) -> str:
    """Return one token in single precision."""
    if found["number"]:
        number = float(found["number"])
        if number > LARGEST:
            return "INFINITY"
        return f"{max(number, SMALLEST) if number else 0.0!r}f"
    word = found["word"]
    if word == "double":
        return "float"
    return f"{word}f" if word in FUNCTIONS else found[0]


def single_law(law: StepLaw, name: str) -> dict[str, str]:
    """Return the file in single precision; its heading states how far it is off.

    Raises
    ------
    InvalidInput
        If the law is too far off.
    """
    error = single_error(law)
    if not error <= WORST:
        raise InvalidInput(
            f"export: with single precision this law is off by {error:.2g} of its greatest answers, over {WORST:g}; "
            "give the precision double."
        )
    tolerance = MARGIN * max(error, float(np.finfo(np.float32).eps))
    note = (
        f"Numbers of single precision: along the test trace an answer is off by up to {error:.2g} of its greatest "
        f"number; the program below compares to {tolerance:.2g}."
    )
    return {f"{name}.h": in_single(c_law(law._replace(notes=(note, *law.notes)), name, tolerance))}


def single_error(law: StepLaw) -> float:
    """Return the greatest error of an answer over its greatest number, on the test trace with single numbers."""
    tables = [np.array(table.numbers, dtype=np.float32) for table in law.tables]
    state = [np.array(part.begin, dtype=_type(part.begin)) for part in law.state]
    answer, step = np.zeros(len(law.answer), dtype=np.float32), plain(law.kernel)
    found = []
    with np.errstate(all="ignore"):
        for row in law.trial.astype(np.float32):
            step(*tables, *state, row.copy(), answer)
            found.append(np.array(answer, dtype=float))
    true = law.trace()
    return float(np.max(np.abs(np.array(found) - true) / np.maximum(np.max(np.abs(true), axis=0), 1e-300)))


def _type(begin: np.ndarray[Any, Any]) -> Any:
    return np.float32 if begin.dtype.kind == "f" else begin.dtype.type
