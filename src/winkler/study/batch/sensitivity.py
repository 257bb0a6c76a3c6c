"""The indices of Sobol of a sweep: the part of the variance of each answer that is due to each varied key.

They follow from the points of a `winkler.study.language.designs.Sensitivity`; keys vary independently over their
ranges.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from winkler.numerics.equations.sobol_indices import sobol_indices
from winkler.numerics.types import Array
from winkler.study.language.designs import Sensitivity
from winkler.study.language.study import Study
from winkler.values.errors import InvalidInput
from winkler.values.value import value

SENSITIVITY = "sensitivity.csv"

INDEX_MEANINGS = {
    "first_order": ("S_i", "part of the variance of the answer that is gone once this key is known"),
    "first_order_low": ("S_i", "lower end of the 95 % interval of the first-order index"),
    "first_order_high": ("S_i", "upper end of the 95 % interval of the first-order index"),
    "total_order": ("S_{Ti}", "part of the variance of the answer that is left when all other keys are known"),
    "total_order_low": ("S_{Ti}", "lower end of the 95 % interval of the total index"),
    "total_order_high": ("S_{Ti}", "upper end of the 95 % interval of the total index"),
}
"""Index -> its symbol and meaning."""


@value
class Indices:
    """The indices of one answer; arrays ``(keys,)`` in the order of the sweep.

    Parameters
    ----------
    answer
        Name of the answer.
    pairs
        Number of pairs of points that were used: all whose points have the answer.
    first_order : ndarray
        Part of the variance that is gone once the key is known.
    first_order_low, first_order_high : ndarray
        Ends of its 95 % interval.
    total_order : ndarray
        Part of the variance that is left when all other keys are known.
    total_order_low, total_order_high : ndarray
        Ends of its 95 % interval.
    """

    answer: str
    pairs: int
    first_order: Array
    first_order_low: Array
    first_order_high: Array
    total_order: Array
    total_order_low: Array
    total_order_high: Array


def sensitivity(study: Study, answers: Mapping[str, Array]) -> tuple[Indices, ...]:
    """Return the indices of every answer that is one number at each point, varies, and was not itself varied.

    Parameters
    ----------
    study
        Its design is a `Sensitivity`.
    answers
        Name -> numbers of all points, NaN where a point failed.

    Raises
    ------
    InvalidInput
        If the design is another one.
    """
    if not isinstance(study.design, Sensitivity):
        raise InvalidInput(
            f"sensitivity: the design of the study is {study.design.kind}; its indices need the design sensitivity."
        )
    axes = study.axes
    varied_contents = [np.array(axis.values, dtype=float) for axis in axes if axis.numeric]
    indices = []
    for name, content in answers.items():
        if content.shape[-1] > 1 or any(np.array_equal(content[:, 0], one, equal_nan=True) for one in varied_contents):
            continue
        rows = content[:, 0].reshape(study.design.count, len(axes) + 2)
        rows = rows[np.all(np.isfinite(rows), axis=1)]
        if len(rows) < 2 or np.ptp(rows[:, :2]) <= 1e-12 * np.max(np.abs(rows[:, :2])):
            continue
        estimate = sobol_indices(rows[:, 0], rows[:, 1], rows[:, 2:].T, study.design.seed)
        indices.append(Indices(name, len(rows), *estimate))
    return tuple(indices)


def variables(indices: tuple[Indices, ...], keys: list[str]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the indices as variables of a dataset over the dimensions ``answer`` and ``key``, and both coordinates."""
    content = {
        name: (
            ("answer", "key"),
            np.stack([getattr(one, name) for one in indices]),
            {"units": "1", "long_name": meaning, "symbol": symbol},
        )
        for name, (symbol, meaning) in INDEX_MEANINGS.items()
    }
    names = {"answer": [one.answer for one in indices], "key": keys}
    return content, {name: ((name,), np.array(places), {}) for name, places in names.items()}


def rows(indices: tuple[Indices, ...], keys: list[str]) -> Iterator[list[Any]]:
    """Yield the rows of a table, one for each answer and key: both, the number of pairs, and the indices."""
    for one in indices:
        for place, key in enumerate(keys):
            yield [one.answer, key, one.pairs, *(float(getattr(one, name)[place]) for name in INDEX_MEANINGS)]
