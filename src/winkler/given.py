"""What a number that is given may be: what is no such number is refused, in one sentence and everywhere in the same."""

from __future__ import annotations

import math

from winkler.errors import InvalidInput

__all__ = ["affordable", "not_negative", "poisson_ratio", "positive", "positive_fields", "whole_number"]


def _within(given: object, least: float) -> bool:
    """Return whether a number, and no truth value, is finite and at least so large."""
    return isinstance(given, int | float) and not isinstance(given, bool) and least <= given < math.inf


def positive(owner: str, word: str, given: object, unit: str) -> None:
    """Refuse what is no positive, finite number.

    Parameters
    ----------
    owner : str
        Who asks, as the sentence of an error begins.
    word : str
        What the number is.
    given : object
        What stands there.
    unit : str
        Its SI unit; empty for a plain number.

    Raises
    ------
    InvalidInput
    """
    if not _within(given, 0.0) or given == 0.0:
        told = f" in {unit}" if unit else ""
        raise InvalidInput(f"{owner}: {word} is {given!r}; it must be a positive, finite number{told}.")


def positive_fields(owner: object, **units: str) -> None:
    """Refuse fields that are no positive, finite numbers, in the order in which they are named with their units.

    Raises
    ------
    InvalidInput
    """
    for word, unit in units.items():
        positive(type(owner).__name__, word, getattr(owner, word), unit)


def affordable(owner: str, what: str, count: int, most: int) -> None:
    """Refuse more of something than are computed with.

    Raises
    ------
    InvalidInput
    """
    if count > most:
        raise InvalidInput(f"{owner}: {count} {what} are too many; give at most {most}.")


def not_negative(owner: str, word: str, given: object, unit: str) -> None:
    """Refuse what is neither zero nor a positive, finite number.

    Raises
    ------
    InvalidInput
    """
    if not _within(given, 0.0):
        raise InvalidInput(f"{owner}: {word} is {given!r}; give zero or a positive, finite number in {unit}.")


def poisson_ratio(owner: str, given: object) -> None:
    """Refuse what no isotropic solid has for a Poisson's ratio.

    Raises
    ------
    InvalidInput
    """
    if not _within(given, -1.0) or not -1.0 < given <= 0.5:  # type: ignore[operator]
        raise InvalidInput(f"{owner}: poisson is {given!r}; a Poisson ratio is above -1 and at most 0.5.")


def whole_number(owner: str, word: str, given: object, least: int, most: float = math.inf) -> None:
    """Refuse what is no whole number between two, both included.

    Raises
    ------
    InvalidInput
    """
    if isinstance(given, bool) or not isinstance(given, int) or not least <= given <= most:
        allowed = f", at least {least}" if most == math.inf else f" from {least} to {most}"
        raise InvalidInput(f"{owner}: {word} is {given!r}; give a whole number{allowed}.")
