"""The answers of the example studies, solved once in each worker for all tests that look at them."""

from __future__ import annotations

import functools
from typing import Any

from winkler.study.language.build import build
from winkler.study.language.explain import example_study


@functools.cache
def example_problem(kind: str) -> Any:
    """The problem of the example study of a kind."""
    return build(example_study(kind)["problem"])


@functools.cache
def solved(problem: Any) -> Any:
    """The solution of a problem; problems of equal content share it."""
    return problem.solve()
