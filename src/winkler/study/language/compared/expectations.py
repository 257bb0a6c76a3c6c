"""The ``[[expect]]`` of a case that is no plain study: of a fit, or of a function."""

from __future__ import annotations

from typing import Any

from winkler.errors import InvalidInput
from winkler.study.language import grammar
from winkler.study.language.schema import MISSING
from winkler.study.language.study import Expectation

__all__ = ["expectations"]

OPTIONAL_KEYS = ("unit", "scale", *grammar.PLACE_KEYS)
"""Keys of ``[[expect]]`` that may be left out."""


def expectations(items: Any, file: str) -> tuple[Expectation, ...]:
    """Return the entries of ``[[expect]]`` of a case.

    Raises
    ------
    InvalidInput
        If one lacks a key or has a wrong number.
    """
    if not isinstance(items, list) or not all(isinstance(item, dict) for item in items):
        raise InvalidInput(f"{file}: expect is no list of tables; write it with two brackets, as [[expect]].")
    return tuple(_expectation(item, file) for item in items)


def _expectation(item: dict[str, Any], file: str) -> Expectation:
    try:
        return grammar.expectation(dict.fromkeys(OPTIONAL_KEYS, MISSING) | item)
    except KeyError as error:
        raise InvalidInput(f"{file}: expect needs {error.args[0]}; add it.") from None
    except InvalidInput as error:
        sentence = str(error).removeprefix("expect: ")
        raise InvalidInput(f"{file}: expect: {sentence}") from None
