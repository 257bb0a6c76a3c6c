"""Refusal of beds that do not fit a problem: an outline that is not known to be a disc, bodies that relax."""

from __future__ import annotations

import dataclasses
import functools
from typing import Any

from winkler.values.assumption import Assumption
from winkler.values.errors import OutsideValidity


def refuse_unless_round(holder: Any, owner: str, needed: str) -> None:
    """Refuse a question about the outline of a contact that is not known to be a disc.

    Parameters
    ----------
    holder
        A bed, or what holds one; what has no footprint passes.
    owner : str
        The name of the requesting function.
    needed : str
        What of the question needs a disc.

    Raises
    ------
    OutsideValidity
        With what the bed stands for, and what to use instead.
    """
    outline = getattr(holder, "footprint", None) or getattr(getattr(holder, "bed", None), "footprint", None)
    if why := getattr(outline, "unlike_disc", ""):
        raise OutsideValidity(f"{owner}: {needed} needs a round contact, and {why}.")


def refuse_outline(content: Any) -> None:
    """Refuse the beds in the fields of a value whose class names, in `needs_round`, the results that need a disc.

    Raises
    ------
    OutsideValidity
        As `refuse_unless_round`.
    """
    needed = getattr(type(content), "needs_round", "")
    for field in dataclasses.fields(content) if needed else ():
        refuse_unless_round(getattr(content, field.name), type(content).__name__, needed)


def refuse_relaxing(content: Any) -> None:
    """Refuse bodies that relax in a problem without time: one that does not assume `Assumption.KNOWN_TIMES`.

    Raises
    ------
    OutsideValidity
        That of the medium, with what to use instead.
    """
    assumed = getattr(type(content), "assumptions", None)
    if assumed is None or Assumption.KNOWN_TIMES in assumed:
        return
    for field in dataclasses.fields(content):
        part = getattr(content, field.name)
        for body in (part, _attribute(part, "medium")):
            if (refusal := _attribute(body, "timeless")) is not None:
                raise refusal()


def _attribute(holder: Any, name: str) -> Any:
    """Return an attribute, or None; of a class that lacks it no value is read, since its refusal takes longer."""
    return None if _lacks(holder.__class__, name) else getattr(holder, name, None)


@functools.cache
def _lacks(cls: type, name: str) -> bool:
    if cls is type:
        return True
    return dataclasses.is_dataclass(cls) and not hasattr(cls, name) and name not in cls.__dataclass_fields__
