"""Functions of values whose last results are kept: values of equal content are one key."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import ParamSpec, TypeVar, cast

P = ParamSpec("P")
R = TypeVar("R")


def cached_by_value(maxsize: int) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Keep so many results of a function of hashable values; it keeps its signature, unlike under `lru_cache`."""

    def kept(function: Callable[P, R]) -> Callable[P, R]:
        return cast(Callable[P, R], functools.lru_cache(maxsize=maxsize)(function))

    return kept


def rounded(ratio: float) -> float:
    """Return a ratio to 14 digits, so that the same body in other units is the same value."""
    return float(f"{ratio:.13e}")
