"""What is no loop, condition or arithmetic is refused with its file and line; what looks alike means the same."""

from __future__ import annotations

import re

import numpy as np
import pytest
from compiled_c import interpreted, library

from winkler.exporting.translation.translate import translate
from winkler.exporting.translation.tree import REAL, array_of
from winkler.numerics.jit import compiled
from winkler.values.errors import InvalidInput

STEPS = 3
WEIGHTS = (0.25, 0.5, 0.25)


@compiled
def listed(x: float) -> float:
    return sum([x, x])


@compiled
def named(x: float) -> float:
    return max(x, default=x)


@compiled
def changed(x: float) -> float:
    y = x
    y = (x, x)
    return y[0]


@compiled
def strided(x: float) -> float:
    row = np.zeros(4)
    return np.sum(row[::2])


@compiled
def guarded(x: float) -> float:
    try:
        return 1.0 / x
    except ZeroDivisionError:
        return 0.0


@compiled
def worded(x: float) -> float:
    return x if "word" else 0.0


@pytest.mark.parametrize(
    ("kernel", "line", "what"),
    [
        (listed, 2, "List is not translated"),
        (named, 2, "arguments by name are not translated"),
        (changed, 3, "y is real here and (real, real) there"),
        (strided, 3, "a slice with a step is not translated"),
        (guarded, 2, "Try is not translated"),
        (worded, 2, "'word' is no number"),
    ],
    ids=lambda part: getattr(part, "__name__", str(part))[:12],
)
def test_a_line_that_leaves_the_subset_is_named(kernel, line, what):
    first = kernel.function.__code__.co_firstlineno + line
    with pytest.raises(InvalidInput, match=rf"^test_subset\.py:{first}: {re.escape(what)}; a kernel that"):
        translate(kernel)


def test_an_argument_without_a_kind_is_asked_for():
    @compiled
    def bare(x):
        return x

    with pytest.raises(InvalidInput, match=r"bare does not state whether x is a number or an array"):
        translate(bare)
    assert translate(bare, [REAL]).entries[0].result == REAL
    with pytest.raises(InvalidInput, match=r"an array is returned"):
        translate(bare, [array_of(1)])


@compiled
def meanings(a: float, b: float, n: int, row: np.ndarray, out: np.ndarray) -> None:
    """Do what Python does otherwise than C."""
    out[0] = n // 4 + (-n) // 4 + n % 4 + (-n) % 4
    out[1] = a // b + a % b
    out[2] = n / 4
    out[3] = min(a, b, np.nan) + max(np.nan, a)
    x, y = a, b
    x, y = y, x
    out[4] = x - 2.0 * y
    out[5], out[6] = out[4], out[5]
    out[7] = row[-1] - row[:-1].min() + row[1:].max() + np.sum(row)
    out[8] = 1.0 if a < b < 3.0 or n in (7, 9) else -1.0
    total, k = 0, 0
    for k in range(n, 0, -STEPS):
        total += k
        k = 0
    out[9] = total + k
    for k in range(len(WEIGHTS)):
        out[10] += WEIGHTS[k] * -(a**k)
    for free in (a, -b, 2):
        if free < 0.0:
            continue
        out[11] += free * free**2
    room = np.zeros((2, 3))
    room[1, 1:] = a
    room[0] = b if n > 3 else a
    out[12] = room[1, 0] + room[1, 2] + room[0, 1]
    out[13] = np.searchsorted(row, row[2]) + abs(-n) + int(-2.7)
    out[14] = -(a**2) - (b - (a - b)) / (a / b)


def test_what_python_means_otherwise_than_c(tmp_path):
    def arguments(n, a):
        return a, 0.7, n, np.array([0.0, 0.4, 0.5, 0.9]), np.ones(15)

    call = library(tmp_path, {"meanings": (meanings, arguments(7, 0.3))})["meanings"]
    for n in (-9, -1, 3, 7):
        for a in (-2.3, 0.3, 4.0):
            found, expected = arguments(n, a), arguments(n, a)
            call(*found)
            interpreted(meanings)(*expected)
            np.testing.assert_array_equal(found[-1], expected[-1])
