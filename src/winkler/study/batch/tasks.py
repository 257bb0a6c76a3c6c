"""The points of a study that are to be solved: a sequence that creates each of them on request.

A sweep of a million points begins as fast as one of ten: no point is created before its turn, and none is stored.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, overload

import numpy as np

from winkler.numerics.types import Array
from winkler.study.language import keys
from winkler.study.language.study import Fields, Study
from winkler.values.errors import WinklerError
from winkler.values.value import value

MOST_CHECKED = 2048
"""Number of points, evenly spread, that are checked before the first is solved, so that mistakes appear at once."""


@value
class PointTask:
    """One point of a sweep.

    Parameters
    ----------
    index, settings
        Place in the sweep, and the values of its keys there.
    keys
        Paths of these keys in the problem.
    base
        The problem of the study, into which the values are put.
    fields
        The fields to restore.
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
            If it is invalid: the key, the value, and why.
        """
        problem = self.base
        for key, content in zip(self.keys, self.settings, strict=True):
            try:
                problem = keys.replaced(problem, key, content)
            except WinklerError as error:
                given = keys.label(content, keys.word_at(problem, key).unit)
                raise type(error)(f"sweep: at problem.{key} = {given}: {error}") from None
        return problem


class PointTasks(Sequence[PointTask]):
    """Points of a study, each created on request.

    Parameters
    ----------
    study
        The study.
    places : ndarray of int
        Numbers of its points, in the order of the sweep.
    """

    def __init__(self, study: Study, places: Array) -> None:
        self._study = study
        self._keys = tuple(axis.key.partition(".")[2] for axis in study.axes)
        self._places = places

    def __len__(self) -> int:
        return len(self._places)

    @overload
    def __getitem__(self, at: int) -> PointTask: ...
    @overload
    def __getitem__(self, at: slice) -> PointTasks: ...
    def __getitem__(self, at: int | slice) -> PointTask | PointTasks:
        if isinstance(at, slice):
            return PointTasks(self._study, self._places[at])
        index, settings = self._study.setting(int(self._places[at]))
        return PointTask(index, settings, self._keys, self._study.problem, self._study.fields)

    def without(self, done: Array) -> PointTasks:
        """Return the tasks at all places but those where `done` is true."""
        return PointTasks(self._study, self._places[~done])


def tasks(study: Study) -> PointTasks:
    """Return every point of a study, in the order of its sweep.

    Raises
    ------
    InvalidInput
        If a point is invalid: the key, the value, and why.  Of more than 2048 points so many are checked, evenly
        spread; another one that is invalid fails when its turn comes, and so does one that meets a mistake of
        winkler's own.
    """
    points = PointTasks(study, np.arange(study.size))
    for place in np.linspace(0, len(points) - 1, min(len(points), MOST_CHECKED)).round().astype(int):
        try:
            _ = points[place].problem
        except Exception as error:
            if isinstance(error, WinklerError):
                raise  # else it is a programming error: the point fails in its turn, and the others are solved
    return points
