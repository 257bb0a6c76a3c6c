"""What the reference solutions of the ledger have in common."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

import mpmath as mp


class ReferenceSolutions(dict[str, Callable[[], Any]]):
    """Case -> the function that computes its numbers without winkler."""

    def of_case(self, function: Callable[[], Any]) -> Callable[[], Any]:
        """Register a function as the reference of the case of its name; it works with 20 digits, and only once."""

        @functools.cache
        def reference() -> Any:
            with mp.workdps(20):
                return function()

        self[function.__name__] = reference
        return reference


def frac(text: str) -> mp.mpf:
    return mp.mpf(text)
