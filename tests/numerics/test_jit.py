"""Kernels are compiled when they are called, and only then."""

from __future__ import annotations

import subprocess
import sys
import types

import numpy as np
import pytest

from winkler.numerics import jit
from winkler.numerics.jit import Instead, Kernel, compiled


@compiled
def square(x: float) -> float:
    return x * x


@compiled
def squares(numbers: np.ndarray) -> float:
    """Sum up squares."""
    total = 0.0
    for i in range(numbers.size):
        total += square(numbers[i])
    return total


@compiled
def quotient(x: float, y: float) -> float:
    return x / y


@compiled
def long(x: float, y: float) -> float:
    """Too long for a compiler to copy it of its own accord."""
    for i in range(3):
        x = np.sin(x) / y + i if x < y else np.cos(y) / (x + 2.0) - i
        y = np.exp(-y) / (x + 3.0) if y > x * x else np.sqrt(np.abs(x)) - np.arctan2(y, x)
        x = np.log1p(x * x) / (y * y + 1.0) if x > 0.5 else np.cosh(y) * np.tanh(x) / (1.0 + i)
        y = np.hypot(x, y) / (x * x + 2.0) if y < 0.3 else np.expm1(-x * x) / (np.abs(y) + 1.0)
    return x + y


@compiled
def twice(x: float) -> float:
    return long(x, 1.0) + long(1.0, x)


@pytest.mark.slow
def test_what_it_calls_stands_within_it():
    """A call could reach a copy within another kernel, of other last digits."""
    assert twice(0.3) == pytest.approx(long.function(0.3, 1.0) + long.function(1.0, 0.3), rel=1e-12)
    (code,) = twice.machine.inspect_llvm().values()
    assert not [line for line in code.splitlines() if "call " in line and "4long" in line]


@compiled
def cube(x: float) -> float:
    return x * x * x


@pytest.mark.parametrize("missing", [False, True])
def test_what_it_calls_may_be_another_function(missing, monkeypatch):
    if missing:
        monkeypatch.setattr(jit, "_numba", lambda: None)
    instead = Instead({"square": cube})
    cubes = instead.kernel(squares.function)
    assert cubes(np.array([1.0, 2.0])) == 9.0
    assert squares.function(np.array([1.0, 2.0])) == 5.0
    assert instead.kernel(squares.function) is cubes
    assert cubes.content != squares.content


@compiled
def given(numbers: np.ndarray) -> tuple[np.ndarray, float]:
    return numbers, 2.0


@compiled
def first_given(numbers: np.ndarray) -> float:
    row, factor = given(numbers)
    return factor * row[0]


def test_a_kernel_that_returns_an_array_is_named_or_refused():
    """Unnamed, nobody would count who refers to it: the process could end without a word."""
    pytest.importorskip("numba")
    numbers = np.array([3.0, 4.0])
    assert Instead({}, ("given",)).kernel(first_given.function)(numbers) == 6.0
    with pytest.raises(TypeError, match=r"the kernel given returns .*array.*`lists` of its `Instead`; name it there"):
        Instead({}).kernel(first_given.function)(numbers)


TABLE = np.array([1.0, 10.0])


@compiled
def add_row(row: np.ndarray, total: np.ndarray) -> None:
    for j in range(row.size):
        total[0] += TABLE[j] * row[j]


@compiled
def add_rows(rows: np.ndarray, total: np.ndarray) -> None:
    for i in range(rows.shape[0]):
        add_row(rows[i], total)


def test_views_are_handed_on_without_being_counted():
    rows, total = np.array([[1.0, 2.0], [3.0, 4.0]]), np.zeros(1)
    add_rows.uncounted(rows, total)
    assert total[0] == 64.0
    if not add_rows.uncounted.stats.cache_hits:  # the code of what is loaded cannot be looked at
        (code,) = add_rows.uncounted.inspect_llvm().values()
        assert "NRT_incref" not in code


def test_a_kernel_may_call_kernels_of_its_file():
    assert squares(np.array([1.0, 2.0, 3.0])) == 14.0
    assert squares.machine is not squares.function
    assert isinstance(square, Kernel)


def test_what_it_calls_belongs_to_its_cache():
    """numba goes by the file of a kernel alone: what other files give to it must stand in its closure."""
    for kernel in (square, squares):
        assert kernel.machine.py_func.__closure__[0].cell_contents == kernel.content

    def cubes(x):
        return x * x * x

    known = {**squares.function.__globals__, "square": Kernel(cubes)}
    other = Kernel(types.FunctionType(squares.function.__code__, known))
    assert other.content != squares.content
    assert other(np.array([1.0, 2.0])) == 9.0
    assert square.content == Kernel(square.function).content != Kernel(quotient.function).content


def test_what_the_compiler_may_do_belongs_to_its_cache(monkeypatch):
    monkeypatch.setattr(jit, "FAST_MATH_FLAGS", frozenset({"nsz"}))
    assert Kernel(square.function).content != square.content


def test_it_keeps_its_name():
    assert squares.__name__ == "squares"
    assert squares.__doc__ == "Sum up squares."


def test_division_by_zero_and_infinities_are_numbers():
    assert quotient(1.0, 0.0) == np.inf
    assert np.isnan(quotient(0.0, 0.0))
    assert np.isnan(quotient(np.inf, np.inf))


def test_in_a_browser_the_source_runs_as_it_is(monkeypatch):
    monkeypatch.setattr(jit, "_numba", lambda: None)
    plain = Kernel(squares.function)
    assert plain(np.array([1.0, 2.0, 3.0])) == 14.0
    divide = Kernel(quotient.function)
    assert divide(np.float64(1.0), np.float64(0.0)) == np.inf


def test_a_mistake_is_not_hidden():
    with pytest.raises(TypeError):
        squares()


@pytest.mark.slow
def test_nothing_is_compiled_on_import():
    code = (
        "import sys, numpy as np\n"
        "from winkler.numerics.springs.slip_kernels import march_line\n"
        "assert 'numba' not in sys.modules\n"
        "one, none = np.ones(1), np.zeros(1)\n"
        "march_line(one, none, one, one, np.ones(2), np.zeros(2), none.copy(), none.copy(), none.copy())\n"
        "assert 'numba' in sys.modules\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
