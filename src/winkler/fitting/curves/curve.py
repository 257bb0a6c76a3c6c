r"""A measured force curve: position of the machine, and force.

The machine moves towards the sample by D; its cantilever or frame has the stiffness :math:`k_m`, so that
the depth is

.. math:: d = D - D_0 - F/k_m

with the contact point :math:`D_0`.  A curve is stored as measured; `winkler.fitting.curves.corrections` returns
corrected ones.
"""

from __future__ import annotations

import dataclasses
import functools
import math
import textwrap
from collections.abc import Sequence
from typing import Annotated

import numpy as np

from winkler.fitting.curves.directions import found_directions
from winkler.fitting.curves.events.found import events_of
from winkler.fitting.curves.events.kinds import CurveEvents
from winkler.fitting.curves.events.record import Record
from winkler.fitting.curves.events.stated import stated_marks
from winkler.fitting.curves.segments import Segment, segments_of, stated_directions
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import POSITIVE_OR_INFINITE, Advice, Numbers
from winkler.values.errors import InvalidInput
from winkler.values.readable import with_unit
from winkler.values.value import value, words

FEWEST = 2


def _empty() -> Array:
    return np.zeros(0)


NOISE_SPECTRA = ("unknown", "white")
POINTS_ADVICE = Advice("give the points as they were taken, and leave out those without numbers")


STIFFNESS_RANGE = POSITIVE_OR_INFINITE._replace(
    demand="it must be positive{unit}, or infinite where the position already is the travel of the tip"
)


@value
class ForceCurve:
    """Position and force of one measurement, in the order in which they were taken.

    Parameters
    ----------
    position : ndarray, (n,)
        D [m], how far the stage, piezo or indenter has moved towards the sample, from any zero.
    force : ndarray, (n,)
        F_N [N], compression positive.
    machine_stiffness : float, optional
        k_m [N/m] of the cantilever or frame; infinite (by default) where `position` already is the travel of the tip.
    time : ndarray, (n,) or (0,), optional
        [s], never falling; empty (by default) where it is unknown.
    direction : ndarray, (n,), optional
        +1 while the tip moves in, -1 while it moves out, 0 during a hold period.  Unless given, it follows from
        position and force: turns, holds and partial unloadings.  `segments` shows the result, `with_segments` replaces
        it.
    name : str, optional
        Origin of the curve.
    marks : ndarray, (n,) or (0,), optional
        Event at each point: 0 none, 1 out of contact, 2 pop-in, 3 snap-in, 4 pull-off. If it is empty (default), events
        are detected.  `events` shows the result, `with_events` replaces it.
    reading : str, optional
        How the file was read: instrument, columns, units, corrections by the instrument, and the source of spring
        constant and sensitivity.
    noise_spectrum : {"unknown", "white"}, optional
        The noise: "unknown" (default), for which the intervals of fits allow for slow noise; or "white", independent
        from point to point, with narrower intervals.

    Raises
    ------
    InvalidInput
        If lengths differ, a number is not finite, time runs backwards, or there are fewer than two points.

    Examples
    --------
    >>> position, force = [0.0, 1e-9, 2e-9, 1e-9, 0.0], [0.0, 0.0, 3e-9, 0.0, 0.0]
    >>> curve = ForceCurve(position, force, machine_stiffness=6.0)
    >>> curve.approach.count, curve.retract.count
    (3, 2)
    >>> round(float(curve.depth(contact_point=1e-9)[2]), 15)
    5e-10
    """

    __words__ = words(
        position=("D", "m", "how far the machine has moved towards the sample"),
        direction=("", "", "+1 going in, -1 coming out, 0 held"),
        name=("", None, "where the curve comes from"),
        marks=("", "", "what is stated of each point"),
        reading=("", None, "how the file was read"),
        noise_spectrum=("", None, "unknown, or white if the noise is known to be that"),
    )

    position: Annotated[Array, Numbers(fewest=FEWEST), POINTS_ADVICE]
    force: Annotated[Array, Numbers(fewest=FEWEST), POINTS_ADVICE]
    machine_stiffness: Annotated[float, STIFFNESS_RANGE] = math.inf
    time: Annotated[Array, Numbers(fewest=0, order="never falling"), POINTS_ADVICE] = dataclasses.field(
        default_factory=_empty
    )
    direction: Annotated[Array, Numbers(fewest=0), POINTS_ADVICE] = dataclasses.field(default_factory=_empty)
    name: str = ""
    marks: Annotated[Array, Numbers(fewest=0), POINTS_ADVICE] = dataclasses.field(default_factory=_empty)
    reading: str = ""
    noise_spectrum: str = "unknown"

    def __post_init__(self) -> None:
        if not self.direction.size:
            object.__setattr__(self, "direction", _directions(self.position, self.force))
        for word in ("force", "time", "direction", "marks"):
            count = getattr(self, word).size
            if count != self.position.size and not (word in ("time", "marks") and count == 0):
                raise InvalidInput(
                    f"ForceCurve: position has {self.position.size} points, {word} has {count}; give one for each."
                )
        if not np.array_equal(self.direction, np.sign(self.direction)):
            raise InvalidInput("ForceCurve: direction holds other numbers than +1 (in), 0 (held) and -1 (out).")
        if self.marks.size and not np.all(np.isin(self.marks, (0.0, 1.0, 2.0, 3.0, 4.0))):
            raise InvalidInput("ForceCurve: marks holds other numbers than 0 to 4; state events by with_events.")
        if self.noise_spectrum not in NOISE_SPECTRA:
            raise InvalidInput(f"ForceCurve: noise_spectrum is {self.noise_spectrum!r}; give 'unknown' or 'white'.")
        object.__setattr__(self, "machine_stiffness", float(self.machine_stiffness))

    @property
    def count(self) -> int:
        """Number of points."""
        return int(self.position.size)

    @property
    def timed(self) -> bool:
        """Whether the times are known."""
        return bool(self.time.size)

    @property
    def has_white_noise(self) -> bool:
        """Whether the noise is stated to be white."""
        return self.noise_spectrum == "white"

    @property
    def compliance(self) -> float:
        """1/k_m [m/N], zero where the position is the travel of the tip."""
        return 1.0 / self.machine_stiffness

    def depth(self, contact_point: float) -> Array:
        """Return d = D - D_0 - F/k_m [m] for the position D_0 [m] of first touch."""
        return np.asarray(self.position - contact_point - self.compliance * self.force)

    def chosen(self, which: Array) -> ForceCurve:
        """Return the curve of some of the points.

        Parameters
        ----------
        which : ndarray
            Truth values ``(n,)``, or indices.

        Raises
        ------
        InvalidInput
            If fewer than two points are chosen.
        """
        which = np.flatnonzero(which) if np.asarray(which).dtype == bool else np.asarray(which, dtype=int)
        if which.size < FEWEST:
            raise InvalidInput(f"curve '{self.name}': {which.size} points are chosen; at least {FEWEST} make a curve.")
        time = self.time[which] if self.timed else _empty()
        return dataclasses.replace(
            self,
            position=self.position[which],
            force=self.force[which],
            time=time,
            direction=self.direction[which],
            marks=self.marks[which] if self.marks.size else self.marks,
        )

    @property
    def segments(self) -> tuple[Segment, ...]:
        """Loading, holds, partial unloadings and the last unloading, in the order in which they were measured."""
        return segments_of(self.direction, self.force)

    def with_segments(self, stated: Sequence[tuple[str, int]]) -> ForceCurve:
        """Return the curve with stated segments in place of the detected ones.

        Parameters
        ----------
        stated : sequence of (str, int)
            "loading", "hold" or "unloading", and the index of its first point; each lasts until the next one begins.

        Raises
        ------
        InvalidInput
            If a kind is unknown, or the first points do not begin at 0 and grow.

        Examples
        --------
        >>> curve = ForceCurve([0.0, 1.0, 2.0, 2.0, 1.0, 0.0], [0.0, 1.0, 2.0, 1.9, 0.9, 0.0])
        >>> corrected = curve.with_segments([("loading", 0), ("hold", 2), ("unloading", 4)])
        >>> [(segment.kind.value, segment.first, segment.last) for segment in corrected.segments]
        [('loading', 0, 1), ('hold', 2, 3), ('last unloading', 4, 5)]
        """
        return dataclasses.replace(self, direction=stated_directions(stated, self.count))

    @property
    def record(self) -> Record:
        """The columns of the curve that are searched for events."""
        return Record(self.position, self.force, self.time, self.direction, self.marks, self.compliance)

    @functools.cached_property
    def events(self) -> CurveEvents:
        """All events in their order: segments, baselines, snap-in, pop-ins, pull-off and others."""
        return events_of(self.record)

    def with_events(self, stated: Sequence[tuple[str, int, int]]) -> ForceCurve:
        """Return the curve with stated events in place of those that are found.

        Parameters
        ----------
        stated : sequence of (str, int, int)
            "baseline", "pop-in", "snap-in" or "pull-off", and the indices of the first and the last point. An empty
            list states that there are no events.  Without a baseline among them, the points out of contact are still
            found.

        Raises
        ------
        InvalidInput
            If a kind is unknown, or a range leaves the curve.

        Examples
        --------
        >>> curve = ForceCurve([0.0, 1e-9, 3e-9, 4e-9], [0.0, 1e-9, 1e-9, 2e-9]).with_events([("pop-in", 2, 2)])
        >>> print(curve.events.of("pop-in"))
        point 2: pop-in, step 2 nm, stated
        """
        return dataclasses.replace(self, marks=stated_marks(stated, self.count))

    def __str__(self) -> str:
        """Return what was done, in its order, as a notebook says it, and how its file was read."""
        machine = "" if math.isinf(self.machine_stiffness) else f", machine {with_unit(self.machine_stiffness, 'N/m')}"
        clock = f" in {with_unit(float(self.time[-1] - self.time[0]), 's')}" if self.timed else ""
        title = f"force curve{f' {self.name!r}' if self.name else ''}: {self.count} points{clock}{machine}"
        done = [f"  {line}" for line in self.events.lines(self.time if self.timed else ())]
        read = textwrap.wrap(self.reading, 100, initial_indent="  ", subsequent_indent="    ")
        return "\n".join([title, *done, *read])

    @property
    def approach(self) -> ForceCurve:
        """The points at which the tip moves towards the sample."""
        return self._part(1.0, "approach")

    @property
    def hold(self) -> ForceCurve:
        """The points at constant tip position."""
        return self._part(0.0, "hold")

    @property
    def retract(self) -> ForceCurve:
        """The points at which the tip moves away from the sample."""
        return self._part(-1.0, "retract")

    @property
    def parts(self) -> tuple[ForceCurve, ...]:
        """The segments of one direction, in the order of measurement; single points are omitted."""
        turns = np.flatnonzero(np.diff(self.direction)) + 1
        stretches = np.split(np.arange(self.count), turns)
        return tuple(self.chosen(stretch) for stretch in stretches if stretch.size >= FEWEST)

    def _part(self, direction: float, word: str) -> ForceCurve:
        which = self.direction == direction
        if np.count_nonzero(which) < FEWEST:
            raise InvalidInput(
                f"curve '{self.name}' has no {word}; it holds {int(np.sum(self.direction > 0))} points going in, "
                f"{int(np.sum(self.direction == 0))} held and {int(np.sum(self.direction < 0))} coming out."
            )
        return self.chosen(which)


def _directions(position: Array, force: Array) -> Array:
    """Return the directions from position and force; zero if their lengths differ."""
    direction = found_directions(position, force) if position.size == force.size else np.zeros(position.size)
    direction.flags.writeable = False
    return direction
