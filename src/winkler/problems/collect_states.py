"""Rows over the states of a march: what every one of them says of the quantities that its answer consists of."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np

from winkler.numerics.types import Array

__all__ = ["rows"]


def rows(answer: Any, states: Sequence[object], *others: str) -> dict[str, Array]:
    """Return word -> what all states say of it, ``(steps,)``, for the arrays that a class of answers has.

    Parameters
    ----------
    answer : type
        The class; its states have attributes of the same names.
    states : sequence
        In the order of the march.
    *others : str
        Arrays that are found in another way.
    """
    words = [field.name for field in dataclasses.fields(answer) if field.type == "Array" and field.name not in others]
    return {word: np.array([getattr(state, word) for state in states]) for word in words}
