r"""The last cycle of a path, and what a linear spring with a damper would have in its place.

A path that comes back to loads that it had, in the direction in which it had them, or to its beginning, has run
through a cycle.  With
the energy W that the cycle loses and the amplitudes U and F of motion and load, half of their ranges,

.. math:: k_s = \frac FU ,\qquad \eta = \frac W{\pi FU}

are the stiffness of the equivalent spring and its loss factor, twice the damping ratio.  A cycle of bodies that are
moved for the first time begins without slip and does not end so: its loop is open, and a note names it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from winkler.numerics.types import Array, N, Quantity, shaped
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import words

SAME = 1e-9
"""Part of the range of a load within which two of its values are the same."""
CLOSED = 1e-3
"""Part of its range by which motion or load may miss its beginning at the end of a closed loop; boundary elements err
by as much."""


class PathLoop(NamedTuple):
    """What a path prescribes, and what it has cost.

    Parameters
    ----------
    prescribed : sequence of ndarray, (points,) or (points, 2)
        The loads that are prescribed, also at points that were not reached.
    motion, load : ndarray, (steps,), in the plane (steps, 2), with a turn beside (steps, 3)
        What moves [m or rad], and what it takes [N or N m].
    lost : ndarray, (steps,)
        Energy lost since the beginning [J], of lines per length [J/m].
    """

    prescribed: Sequence[Array]
    motion: Array
    load: Array
    lost: Array


class LastCycle(NamedTuple):
    """The last cycle of a path.

    Parameters
    ----------
    first, last
        The points of the path between which it runs.
    loss
        Energy that it loses [J], of lines per length [J/m].
    motion, load
        Amplitudes: half of the ranges, zero of what has none; not a number of what leaves a line.
    gap
        By how much motion or load misses its beginning, over its range [-].
    """

    first: int
    last: int
    loss: float
    motion: float
    load: float
    gap: float


def cycle_ends(prescribed: Sequence[Array]) -> tuple[int, int] | None:
    """Return the points between which the last cycle of a path runs; None if it has none.

    Parameters
    ----------
    prescribed : sequence of ndarray, (points,) or (points, 2)
        The loads that are prescribed.

    Examples
    --------
    >>> cycle_ends([np.array([0.0, 1.0, 0.0, -1.0, 0.0])])  # the second zero is met on the way back
    (0, 4)
    >>> cycle_ends([np.array([0.0, 1.0, -1.0, 1.0])])
    (1, 3)
    """
    columns = np.column_stack([np.reshape(load, (len(load), -1)) for load in prescribed])
    ranges = np.ptp(columns, axis=0)
    columns = (columns / np.where(ranges > 0.0, ranges, 1.0))[:, ranges > 0.0]
    changes = np.diff(columns, axis=0)
    moving = np.flatnonzero(np.any(np.abs(changes) > SAME, axis=1))
    if not moving.size:
        return None
    end, arrived = len(columns) - 1, changes[moving[-1]]
    alike = np.flatnonzero(np.all(np.abs(columns - columns[end]) <= SAME, axis=1))
    for first in alike[alike <= moving[-1]][::-1].tolist():
        before = moving[moving < first]
        if not before.size or np.all(changes[before[-1]] * arrived >= -SAME):  # none is met on its way back
            return first, end
    return None


def cycle_of(who: str, loop: PathLoop) -> LastCycle:
    """Return the last cycle of a path.

    Parameters
    ----------
    who : str
        Name of the problem, for messages.
    loop : PathLoop

    Raises
    ------
    OutsideValidity
        If the path closes no cycle.
    """
    lost = loop.lost
    ends = cycle_ends([column[: lost.size] for column in loop.prescribed]) if lost.size else None
    if ends is None:
        raise OutsideValidity(
            f"{who}: the path of {lost.size} points has no closed cycle, because it does not return to the loads "
            "of an earlier point in the same direction; let it end where a cycle began, as Path.oscillation(...) "
            "does."
        )
    first, last = ends
    rows = [np.reshape(column[first : last + 1], (last + 1 - first, -1)) for column in (loop.motion, loop.load)]
    missed = [
        float(np.max(np.abs(row[-1] - row[0]))) / reach for row in rows if (reach := float(np.max(np.ptp(row, axis=0))))
    ]
    motion, load = map(_amplitude, rows)
    return LastCycle(first, last, float(lost[last] - lost[first]), motion, load, max(missed, default=0.0))


def cycles_of(who: str, loop: PathLoop, most: int) -> tuple[LastCycle, ...]:
    """Return the last cycles of a path that follow each other, in their order; none if the path closes none.

    Parameters
    ----------
    who : str
        Name of the problem, for messages.
    loop : PathLoop
    most : int
        How many at most.
    """
    found: list[LastCycle] = []
    end = loop.lost.size
    while len(found) < most:
        begun = PathLoop([one[:end] for one in loop.prescribed], loop.motion[:end], loop.load[:end], loop.lost[:end])
        try:
            found.append(cycle_of(who, begun))
        except OutsideValidity:
            break
        end = found[-1].first + 1
    return tuple(found[::-1])


def _amplitude(row: Array) -> float:
    """Return half of the range along a line, not a number of what leaves a line or turns while it is pushed."""
    if row.shape[1] > 2:
        return np.nan
    away = row - np.mean(row, axis=0)
    along = away[:, 0]
    if row.shape[1] > 1:
        _, sizes, axes = np.linalg.svd(away, full_matrices=False)
        if sizes[1] > CLOSED * sizes[0]:
            return np.nan
        along = away @ axes[0]
    return 0.5 * float(np.ptp(along))


def cycle_notes(cycle: LastCycle) -> tuple[Note, ...]:
    """Return the note that names a loop that does not close; nothing where it closes."""
    if cycle.gap <= CLOSED:
        return ()
    statement = (
        f"The last cycle of the path, from point {cycle.first} to point {cycle.last}, is not closed. Motion or "
        f"load ends {100.0 * cycle.gap:.2g} per cent of its range from its start. Its dissipated energy applies "
        "to this cycle only. Append cycles until the last one closes."
    )
    return (Note(Assumption.ENERGY, Standing.APPROXIMATE, statement, "ends of the last cycle compared"),)


def per_unit(loss: N, whole: Quantity) -> N:
    """Return losses over what is positive where the bodies move, and zero where they do not."""
    moving = np.asarray(whole) > 0.0
    return shaped(np.where(moving, loss / np.where(moving, whole, 1.0), 0.0))


def loss_factor(loss: N, motion: Quantity, load: Quantity) -> N:
    """Return W / (pi F U) of closed cycles [-], twice the damping ratio; zero where nothing moves."""
    return per_unit(loss, np.pi * np.asarray(motion) * np.asarray(load))


class Cycled:
    """The part of a solution that knows the last cycle of its path."""

    problem: Any

    @property
    def _loop(self) -> PathLoop:
        """What the path prescribes, and what it has cost."""
        raise NotImplementedError

    @property
    def last_cycle(self) -> LastCycle:
        """Where the last cycle of the path runs, its loss, its amplitudes, and by how much it is open."""
        return cycle_of(type(self.problem).__name__, self._loop)

    def cycles(self, most: int = 100) -> tuple[LastCycle, ...]:
        """Return the last cycles of the path that follow each other, in their order; none if it closes none.

        Parameters
        ----------
        most : int, optional
            How many at most.
        """
        return cycles_of(type(self.problem).__name__, self._loop, most)

    @property
    def _cycle_notes(self) -> tuple[Note, ...]:
        """Whether the last cycle is open; nothing where it is closed, or there is none."""
        try:
            return cycle_notes(self.last_cycle)
        except OutsideValidity:
            return ()


class Looped(Cycled):
    """The part of a solution that has the numbers of the last cycle of its path."""

    __words__ = words(
        loss_per_cycle=("W", "J", "energy lost in the last cycle of the path"),
        secant_stiffness=("k_s", "N/m", "amplitude of the load over that of the motion, in the last cycle of the path"),
        loss_factor=(r"\eta", "", "loss per cycle over pi times the amplitudes of motion and load"),
    )

    @property
    def loss_per_cycle(self) -> float:
        """Energy lost in the last cycle of the path [J].

        Raises
        ------
        OutsideValidity
            If the path closes no cycle.
        """
        return self.last_cycle.loss

    @property
    def secant_stiffness(self) -> float:
        """Amplitude of the load over that of the motion in the last cycle of the path [N/m], of a twist [N m/rad].

        Raises
        ------
        OutsideValidity
            If the path closes no cycle, nothing moves in it, or it leaves a line.
        """
        cycle = self._swing
        return cycle.load / cycle.motion

    @property
    def loss_factor(self) -> float:
        """W / (pi F U) of the last cycle of the path [-], 4/pi if all slides throughout; twice the damping ratio.

        Raises
        ------
        OutsideValidity
            As `secant_stiffness`.
        """
        cycle = self._swing
        return float(loss_factor(cycle.loss, cycle.motion, cycle.load))

    @property
    def _swing(self) -> LastCycle:
        """The last cycle, if it has amplitudes."""
        cycle, who = self.last_cycle, type(self.problem).__name__
        if cycle.motion == 0.0 or cycle.load == 0.0:
            raise OutsideValidity(
                f"{who}: between the points {cycle.first} and {cycle.last} there is no motion against a load, so "
                "the cycle has no stiffness and no damping; let the motion oscillate."
            )
        if np.isnan(cycle.motion * cycle.load):
            raise OutsideValidity(
                f"{who}: the cycle changes its direction, or rotates the bodies in addition to a displacement, "
                "and has no single amplitude; read its loss_per_cycle."
            )
        return cycle
