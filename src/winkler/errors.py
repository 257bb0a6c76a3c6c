"""The errors of the house.

::

    WinklerError
    |-- InvalidInput      (also a ValueError)   what was given cannot be used
    |-- OutsideValidity   (also a ValueError)   the input is sound, the theory does not reach it
    |-- NotConverged      (also an ArithmeticError)   a solver gave up; it never returns half an answer
    `-- Interrupted       the reader stopped a batch; what was done is kept

Each message says what was given, what is allowed, and what to do.  `suggest` finds the nearest known word.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable

__all__ = ["Interrupted", "InvalidInput", "NotConverged", "OutsideValidity", "WinklerError", "suggest"]


class WinklerError(Exception):
    """Root of every error that winkler raises on purpose; `exit_code` is what the command line returns."""

    exit_code = 1


class InvalidInput(WinklerError, ValueError):
    """What was given cannot be used: a wrong sign, unit, file, name or number."""

    exit_code = 2


class NotConverged(WinklerError, ArithmeticError):
    """A numerical method did not reach its tolerance."""

    exit_code = 3


class OutsideValidity(WinklerError, ValueError):
    """The input is sound, but the theory that would answer it does not hold there."""

    exit_code = 4


class Interrupted(WinklerError):
    """A batch was stopped by its reader; what had been done is kept."""

    exit_code = 130


def suggest(word: str, known: Iterable[str]) -> str:
    """Return `` (did you mean 'x'?)`` for the known word nearest to `word`, or an empty string."""
    near = difflib.get_close_matches(word, list(known), n=1, cutoff=0.6)
    return f" (did you mean '{near[0]}'?)" if near else ""
