"""A path stated in steps: start, go there, wait, oscillate, run round a circle, follow a table."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from winkler.loading.loads import Depth, Lateral, Normal, Shift
from winkler.loading.path import Path, numbers_of
from winkler.loading.path_steps import Circle, Follow, PathRows, Start, Step, Unchanged
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import affordable
from winkler.values.errors import InvalidInput
from winkler.values.limits import PATH_POINTS
from winkler.values.value import value


@value
class Program(Path):
    """A path of loads that is defined as a sequence of steps.

    Parameters
    ----------
    steps : tuple of Start, Ramp, Hold, Oscillate, Circle, Follow
        A Start first, the others in any order.

    Raises
    ------
    InvalidInput
        If there is no Start at the beginning, one later on, or two steps are driven by different kinds of loads.

    Examples
    --------
    Pressed on in one second, then rubbed to and fro.

    >>> from winkler.loading.loads import Force, Shift
    >>> from winkler.loading.path_steps import Oscillate, Ramp, Start
    >>> path = Program([Start(Force(0.0)), Ramp(Force(10.0)), Oscillate(lateral=Shift(1e-6), count=4)])
    >>> path.time, path.across
    (array([0.  , 1.  , 1.25, 1.5 , 1.75, 2.  ]), array([ 0., 10., 10., 10., 10., 10.]))
    >>> path.along * 1e6
    array([ 0.,  0.,  1.,  0., -1.,  0.])
    """

    time: Array = dataclasses.field(init=False, repr=False, default_factory=lambda: np.zeros(1))
    normal: Normal = dataclasses.field(init=False, repr=False, default=Depth(0.0))
    lateral: Lateral = dataclasses.field(init=False, repr=False, default=Shift(0.0))
    steps: tuple[Step, ...]

    def __post_init__(self) -> None:
        begun, lateral = self._begun()
        time, across, along = 0.0, 0.0, np.zeros(2)
        parts: list[PathRows] = []
        for step in self.steps:
            rows = step.rows(across, along)
            if parts and rows.seconds[0] == 0.0 and rows.across[0] == across and np.all(rows.along[0] == along):
                rows = PathRows(*(part[1:] for part in rows))  # where an oscillation begins, one is already
            affordable("Program", "points", rows.seconds.size + sum(part.seconds.size for part in parts), PATH_POINTS)
            if rows.seconds.size:
                parts.append(rows._replace(seconds=time + rows.seconds))
                time, across, along = float(parts[-1].seconds[-1]), float(rows.across[-1]), rows.along[-1]
        kind: type[Any] = type(begun.normal)
        plane = np.concatenate([part.along for part in parts])
        content = {
            "time": np.concatenate([part.seconds for part in parts]),
            "normal": kind(np.concatenate([part.across for part in parts])),
            "lateral": lateral(plane if any(map(_in_plane, self.steps)) else plane[:, 0]),
        }
        for word, row in content.items():
            object.__setattr__(self, word, row)
        Path.__post_init__(self)

    def _begun(self) -> tuple[Start, type[Lateral]]:
        """Return the start and what drives the lateral motion, after checking that all steps go on from the start."""
        steps = self.steps
        if not steps or not isinstance(steps[0], Start):
            raise InvalidInput("Program: the first step must be a Start, which states where the path begins.")
        driven: dict[str, tuple[int, type]] = {}
        for number, step in enumerate(steps, start=1):
            where = f"Program: step {number} ({type(step).__name__})"
            if number > 1 and isinstance(step, Start):
                raise InvalidInput(f"{where} begins anew; one path has one Start, use a Ramp to go somewhere.")
            source = step.path if isinstance(step, Follow) else step
            for word in ("normal", "lateral"):
                load = getattr(source, word, Unchanged())
                if isinstance(load, Unchanged):
                    continue
                stated, kind = driven.setdefault(word, (number, type(load)))
                if type(load) is not kind:
                    raise InvalidInput(
                        f"{where} is driven by {type(load).__name__}, step {stated} by {kind.__name__}; one path is "
                        f"driven by one kind of {word} load throughout."
                    )
        return steps[0], driven.get("lateral", (0, Shift))[1]


def _in_plane(step: Step) -> bool:
    if isinstance(step, Circle):
        return True
    if isinstance(step, Follow):
        return step.path.in_plane
    load = getattr(step, "lateral", Unchanged())
    return not isinstance(load, Unchanged) and numbers_of(load).shape == (2,)
