"""The steps of a path stated in words: start, go there, wait, oscillate, run round a circle, follow a table.

Every step goes on from where the one before it ended, and leaves as it is what it does not mention.
"""

from __future__ import annotations

import math
from typing import Annotated, NamedTuple, TypeAlias

import numpy as np

from winkler.loading.loads import Lateral, Normal, ShearForce, Shift
from winkler.loading.path import POINTS_PER_CYCLE, OneNormal, OnePositiveSwing, Path, numbers_of
from winkler.numerics.equations.oscillation_times import oscillation_moments, sine
from winkler.numerics.types import Array
from winkler.values.checks.field_checks import Condition
from winkler.values.checks.number_checks import Count, Finite, NonNegative, Positive, Whole, affordable
from winkler.values.limits import PATH_POINTS
from winkler.values.value import value, words


class PathRows(NamedTuple):
    """Points after the present one: seconds since then, loads ``(points,)`` and ``(points, 2)``."""

    seconds: Array
    across: Array
    along: Array


def _one_or_pair(load: Lateral | Unchanged) -> bool:
    shape = () if isinstance(load, Unchanged) else numbers_of(load).shape
    return shape == () or (shape == (2,) and isinstance(load, Shift | ShearForce))


@value
class Unchanged:
    """A load that stays as it is."""


NextNormal: TypeAlias = Annotated[
    Normal | Unchanged,
    Condition(
        lambda load: isinstance(load, Unchanged) or numbers_of(load).ndim == 0,
        "give Depth(d) or Force(F) with one number, or leave it out",
    ),
]
NextLateral: TypeAlias = Annotated[
    Lateral | Unchanged,
    Condition(
        _one_or_pair,
        "give Shift, ShearForce, Angle or Torque with one number, or for a shift or a shear force in the plane two; or "
        "leave it out",
    ),
]


@value
class Start:
    """The first loads of a path.

    Parameters
    ----------
    normal : Depth or Force
        One number; it states what drives the normal motion in all steps.
    lateral : Shift, ShearForce, Angle, Torque or Unchanged, optional
        One number, in the plane two; it states what drives the lateral motion in all steps.  By default the lateral
        load at the start of the path is zero, of the kind of the first lateral step.

    Raises
    ------
    InvalidInput
        If a load is of another kind or an array.
    """

    normal: OneNormal
    lateral: NextLateral = Unchanged()

    def rows(self, across: float, along: Array) -> PathRows:
        """Return the one point."""
        far = along if isinstance(self.lateral, Unchanged) else _pair(self.lateral)
        return PathRows(np.zeros(1), np.array([_one(self.normal)]), far[None])


@value
class Ramp:
    """A linear change to a given load.

    Parameters
    ----------
    normal : Depth, Force or Unchanged, optional
        Final load: one number.
    lateral : Shift, ShearForce, Angle, Torque or Unchanged, optional
        Final load: one number, in planar motion two.
    duration : float, optional
        Duration [s], zero or more.
    count : int, optional
        Number of equal parts into which the step is divided; at least one.

    Raises
    ------
    InvalidInput
        If a load is of another kind or an array, or a number out of bounds.
    """

    __words__ = words(duration=("T", "s", "duration of the step"))

    normal: NextNormal = Unchanged()
    lateral: NextLateral = Unchanged()
    duration: NonNegative = 1.0
    count: Annotated[int, Whole(1, PATH_POINTS, "points")] = 1

    def rows(self, across: float, along: Array) -> PathRows:
        """Return `count` points on the path, the last of them at its end."""
        part = np.arange(1, self.count + 1) / self.count
        high = across if isinstance(self.normal, Unchanged) else _one(self.normal)
        far = along if isinstance(self.lateral, Unchanged) else _pair(self.lateral)
        return PathRows(
            part * self.duration,
            (1.0 - part) * across + part * high,
            (1.0 - part)[:, None] * along + part[:, None] * far,
        )


@value
class Hold:
    """A period in which all loads are constant.

    Parameters
    ----------
    duration : float, optional
        Duration [s], zero or more.
    count : int, optional
        Number of times at which states are returned, for viscoelastic bodies.

    Raises
    ------
    InvalidInput
        If a number is out of its range.
    """

    __words__ = words(duration=("T", "s", "how long"))

    duration: NonNegative = 1.0
    count: Annotated[int, Whole(1, PATH_POINTS, "points")] = 1

    def rows(self, across: float, along: Array) -> PathRows:
        """Return `count` points, the last of them at the end."""
        part = np.arange(1, self.count + 1) / self.count
        return PathRows(self.duration * part, np.full(self.count, across), np.tile(along, (self.count, 1)))


@value
class Oscillate:
    """Oscillation about the present loads.

    Along the surface A sin(2 pi f t + phase), across it A sin(2 pi ratio f t). With a phase the path first steps to the
    start of the oscillation.

    Parameters
    ----------
    normal : Depth, Force or Unchanged, optional
        Amplitude of the normal load.
    lateral : Shift, ShearForce, Angle, Torque or Unchanged, optional
        Amplitude along the surface; in planar motion two numbers, which give the direction of the oscillation.
    cycles : float, optional
        Number of cycles along the surface.
    frequency : float, optional
        f [Hz], along the surface.
    ratio : float, optional
        Frequency of the normal load over that along the surface.
    phase : float, optional
        Phase by which the lateral load is ahead [rad].
    count : int, optional
        Points per cycle of the faster of both oscillations, in addition to the reversals.

    Raises
    ------
    InvalidInput
        If a load is of another kind or an array, or a number out of bounds.
    """

    __words__ = words(phase=(r"\varphi", "rad", "by which the lateral load is ahead"))

    normal: NextNormal = Unchanged()
    lateral: NextLateral = Unchanged()
    cycles: Finite = 1.0
    frequency: Positive = 1.0
    ratio: Finite = 1.0
    phase: Finite = 0.0
    count: Annotated[int, Whole(1, PATH_POINTS, "points")] = POINTS_PER_CYCLE

    def __post_init__(self) -> None:
        oscillation_moments(self.cycles, self.count, ((1.0, 0.0), (self.ratio, 0.0)))

    def rows(self, across: float, along: Array) -> PathRows:
        """Return the points of all cycles."""
        lead = self.phase / (2.0 * math.pi)
        waves = () if isinstance(self.lateral, Unchanged) else ((1.0, lead),)
        waves = (*waves, *(() if isinstance(self.normal, Unchanged) else ((self.ratio, 0.0),)))
        turns = oscillation_moments(self.cycles, self.count, waves or ((1.0, 0.0),))
        high = 0.0 if isinstance(self.normal, Unchanged) else _one(self.normal)
        far = np.zeros(2) if isinstance(self.lateral, Unchanged) else _pair(self.lateral)
        return PathRows(
            turns / self.frequency,
            across + high * sine(self.ratio * turns),
            along + far * sine(turns + lead)[:, None],
        )


@value
class Circle:
    """Circular motion about the present position: a step along x, then rotation from x towards y.

    Parameters
    ----------
    lateral : Shift or ShearForce
        Radius of the circle, one positive number.
    cycles : float, optional
        How many times.
    frequency : float, optional
        Revolutions per second [Hz].
    count : int, optional
        Points of one round.

    Raises
    ------
    InvalidInput
        If the radius is of another kind, or a number out of bounds.
    """

    lateral: OnePositiveSwing
    cycles: Finite = 1.0
    frequency: Positive = 1.0
    count: Annotated[int, Whole(1, PATH_POINTS, "points")] = POINTS_PER_CYCLE

    def __post_init__(self) -> None:
        oscillation_moments(self.cycles, self.count)

    def rows(self, across: float, along: Array) -> PathRows:
        """Return the points of all rounds."""
        turns = oscillation_moments(self.cycles, self.count)
        round_ = np.stack([sine(turns + 0.25), sine(turns)], axis=1)
        return PathRows(turns / self.frequency, np.full(turns.size, across), along + _one(self.lateral) * round_)


@value
class Follow:
    """Follow another path, such as a measured one, with its own loads. Its time begins at the end of the previous step.

    Parameters
    ----------
    path : Path
        With loads of the same kinds, and the same number of directions along the surface.
    cycles : int, optional
        Number of repetitions.

    Raises
    ------
    InvalidInput
        If there is no path, or the number is not a whole one, at least one.
    """

    __words__ = words(cycles=("n", None, "how many times"), path=("", None, "a path with its own loads"))

    path: Path
    cycles: Count = 1

    def __post_init__(self) -> None:
        affordable("Follow", "points", self.cycles * self.path.time.size, PATH_POINTS)

    def rows(self, across: float, along: Array) -> PathRows:
        """Return its points, without the first one if it equals the present point."""
        path = self.path
        plane = path.along if path.in_plane else np.stack([path.along, np.zeros(path.time.size)], axis=1)
        times = path.time - path.time[0]
        seconds = np.concatenate([times + number * times[-1] for number in range(self.cycles)])
        rows = PathRows(seconds, np.tile(path.across, self.cycles), np.tile(plane, (self.cycles, 1)))
        repeated = (seconds[0] == 0.0) and rows.across[0] == across and bool(np.all(rows.along[0] == along))
        return PathRows(*(part[int(repeated) :] for part in rows)) if len(seconds) > 1 else rows


Step = Start | Ramp | Hold | Oscillate | Circle | Follow
"""What a `winkler.loading.program.Program` is made of."""


def _one(load: Normal | Lateral) -> float:
    return float(numbers_of(load))


def _pair(load: Lateral) -> Array:
    numbers = numbers_of(load)
    return numbers if numbers.ndim else np.array([float(numbers), 0.0])
