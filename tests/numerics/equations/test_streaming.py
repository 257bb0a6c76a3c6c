"""A routine becomes a stream: in turns, with its own errors, and it ends when the reader leaves."""

from __future__ import annotations

import threading

import numpy as np
import pytest

from winkler.numerics.equations.streaming import streamed


def test_only_one_of_the_two_is_at_work():
    course = []

    def routine(emit):
        for number in range(3):
            course.append(f"made {number}")
            emit(number)
        return "end"

    for item in streamed(routine):
        course.append(f"read {item}")
    assert course == ["made 0", "read 0", "made 1", "read 1", "made 2", "read 2", "read end"]


def test_an_error_comes_to_the_reader():
    def routine(emit):
        emit(1)
        raise ValueError("of the routine")

    stream = streamed(routine)
    assert next(stream) == 1
    with pytest.raises(ValueError, match="of the routine"):
        next(stream)


def test_a_reader_that_leaves_ends_the_routine():
    """It does not take that for an error of its own."""
    ended = threading.Event()

    def routine(emit):
        try:
            for number in range(100):
                try:
                    emit(number)
                except Exception:
                    pytest.fail("the routine received an error")
        finally:
            ended.set()

    stream = streamed(routine)
    assert next(stream) == 0
    stream.close()
    assert ended.is_set()


def test_the_context_of_the_reader_holds_in_the_routine():
    def routine(emit):
        return float(np.divide(1.0, 0.0))

    with np.errstate(divide="raise"), pytest.raises(FloatingPointError):
        list(streamed(routine))
