"""The points of a study that are to be solved: a list that makes each of them when it is asked for.

A sweep of a million points begins as fast as one of ten: nothing is made before its turn, and nothing is kept.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, overload

import numpy as np

from winkler.errors import WinklerError
from winkler.numerics.types import Array
from winkler.study.language import keys
from winkler.study.language.study import Fields, Study
from winkler.values import value

__all__ = ["Task", "Tasks", "tasks"]

ASKED = 2048
"""So many points, evenly spread, are made before the first is solved, to tell of mistakes before hours have passed."""


@value
class Task:
    """One point of a sweep.

    Parameters
    ----------
    index, settings
        Place in the sweep, and the values of its keys there.
    keys
        Paths of these keys in the problem.
    base
        The problem of the study, in which the values are put.
    fields
        What is to be restored.
    """

    index: tuple[int, ...]
    settings: tuple[Any, ...]
    keys: tuple[str, ...]
    base: Any
    fields: Fields

    @property
    def problem(self) -> Any:
        """The problem with the values of this point.

        Raises
        ------
        WinklerError
            If it cannot be asked: the key, the value, and why.
        """
        problem = self.base
        for key, content in zip(self.keys, self.settings, strict=True):
            try:
                problem = keys.replaced(problem, key, content)
            except WinklerError as error:
                raise type(error)(f"sweep: at problem.{key} = {keys.label(content)}: {error}") from None
        return problem


class Tasks(Sequence[Task]):
    """Points of a study, each made when it is asked for.

    Parameters
    ----------
    study
        What is asked.
    places : ndarray of int
        Which of its points, counted in the order of the sweep.
    """

    def __init__(self, study: Study, places: Array) -> None:
        self._study = study
        self._keys = tuple(axis.key.partition(".")[2] for axis in study.axes)
        self._places = places

    def __len__(self) -> int:
        return len(self._places)

    @overload
    def __getitem__(self, at: int) -> Task: ...
    @overload
    def __getitem__(self, at: slice) -> Tasks: ...
    def __getitem__(self, at: int | slice) -> Task | Tasks:
        if isinstance(at, slice):
            return Tasks(self._study, self._places[at])
        index, settings = self._study.setting(int(self._places[at]))
        return Task(index, settings, self._keys, self._study.problem, self._study.fields)

    def without(self, done: Array) -> Tasks:
        """Return the tasks at all places but those where `done` is true."""
        return Tasks(self._study, self._places[~done])


def tasks(study: Study) -> Tasks:
    """Return every point of a study, in the order of its sweep.

    Raises
    ------
    InvalidInput
        If a point cannot be asked: the key, the value, and why.  Of more than 2048 points so many are looked at,
        evenly spread; another one that cannot be asked fails when its turn comes, and so does one that meets a mistake
        of winkler's own.
    """
    found = Tasks(study, np.arange(study.size))
    for place in np.unique(np.linspace(0, len(found) - 1, min(len(found), ASKED)).round().astype(int)):
        try:
            _ = found[place].problem
        except Exception as error:
            if isinstance(error, WinklerError):
                raise  # else it is a mistake of ours: the point fails in its turn, and the others are solved
    return found
