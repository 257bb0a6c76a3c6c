"""What the judges of the ledger have in common."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

import mpmath as mp


class Judges(dict[str, Callable[[], Any]]):
    """Case -> who tells its numbers without winkler."""

    def judged(self, function: Callable[[], Any]) -> Callable[[], Any]:
        """Take a function for the judge of the case of its name; it works with 20 digits, and only once."""

        @functools.cache
        def judge() -> Any:
            with mp.workdps(20):
                return function()

        self[function.__name__] = judge
        return judge


def frac(text: str) -> mp.mpf:
    return mp.mpf(text)
