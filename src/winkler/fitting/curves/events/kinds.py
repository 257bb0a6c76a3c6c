"""Events of a force curve: what was done, and what happened, with points, size, error and confidence."""

from __future__ import annotations

import math
from collections.abc import Iterable
from enum import Enum

from winkler.values.readable import scale_of, with_unit
from winkler.values.value import value, words


class EventKind(Enum):
    """Kinds of events."""

    BASELINE_BEFORE = "baseline before contact"
    LOADING = "loading"
    HOLD = "hold"
    PARTIAL_UNLOADING = "partial unloading"
    LAST_UNLOADING = "last unloading"
    BASELINE_AFTER = "baseline after contact"
    SNAP_IN = "snap-in"
    POP_IN = "pop-in"
    PULL_OFF = "pull-off"
    SATURATION = "saturation"
    INTERFERENCE = "interference"
    CLOCK_OFFSET = "clock offset"
    DRAG = "drag"


SIZES = {
    EventKind.BASELINE_BEFORE: "over",
    EventKind.LOADING: "force by",
    EventKind.HOLD: "for",
    EventKind.PARTIAL_UNLOADING: "force by",
    EventKind.LAST_UNLOADING: "force by",
    EventKind.BASELINE_AFTER: "over",
    EventKind.SNAP_IN: "tension",
    EventKind.POP_IN: "step",
    EventKind.PULL_OFF: "tension",
    EventKind.SATURATION: "force stays at",
    EventKind.INTERFERENCE: "amplitude",
    EventKind.CLOCK_OFFSET: "force is late by",
    EventKind.DRAG: "against the motion",
}
"""What the size of an event is, in words."""


MOST_DIGITS = 6
"""Most decimal places of a number with its error."""


@value
class CurveEvent:
    """One event of a force curve.

    Parameters
    ----------
    kind : EventKind
    first, last : int
        Indices of its first and last point.
    size : float
        In `unit`: of a baseline the travel; of a loading or an unloading the change of force; of a hold its duration
        [s], without times the number of points; of a pop-in the step of position [m] or the drop of force [N]; of
        snap-in and pull-off the maximum tension below the baseline; of saturation the force; of interference the
        amplitude; of a clock offset the delay of the force; of drag the force against the motion.
    error : float
        Standard error of the size from the noise; zero where the size is read directly, or without noise.
    unit : str
        m, N, s, or empty for a number of points.
    confidence : float
        Probability that Gaussian noise alone does not cause such an event; 1 for events that are not detected in
        noise.
    remark : str
        Further numbers as text; may be empty.
    """

    __words__ = words(
        kind=("", None, "kind of the event"),
        first=("", None, "index of the first point"),
        last=("", None, "index of the last point"),
        size=("", "", "size of the event in its own unit"),
        error=("", "", "standard error of the size in the same unit"),
        unit=("", None, "unit of size and error"),
        confidence=("", "", "probability that noise alone makes no such event"),
        remark=("", None, "further numbers in words"),
    )

    kind: EventKind
    first: int
    last: int
    size: float
    error: float = 0.0
    unit: str = ""
    confidence: float = 1.0
    remark: str = ""

    def __str__(self) -> str:
        """Return one line of a notebook."""
        at = f"point {self.first}" if self.first == self.last else f"points {self.first} to {self.last}"
        return f"{at}: {self.sentence}"

    @property
    def sentence(self) -> str:
        """Kind, size with error, and remark."""
        size = f"{self.size:.0f} points" if not self.unit else with_error(self.size, self.error, self.unit)
        remark = f", {self.remark}" if self.remark else ""
        return f"{self.kind.value}, {SIZES[self.kind]} {size}{remark}"


class CurveEvents(tuple[CurveEvent, ...]):
    """The events of a curve, in the order of their first points; as text one line each.

    Examples
    --------
    >>> from winkler.fitting.curves.curve import ForceCurve
    >>> curve = ForceCurve([0.0, 1e-9, 2e-9, 1e-9, 0.0], [0.0, 1e-9, 2e-9, 1e-9, 0.0])
    >>> print(curve.events)
    points 0 to 2: loading, force by 2 nN, position by 2 nm
    points 3 to 4: last unloading, force by −2 nN, position by −2 nm
    """

    __slots__ = ()

    def of(self, kind: EventKind | str) -> CurveEvents:
        """Return the events of one kind, which may be given as text."""
        kind = EventKind(kind)
        return CurveEvents(event for event in self if event.kind is kind)

    def __str__(self) -> str:
        return "\n".join(map(str, self))

    def lines(self, times: Iterable[float] = ()) -> tuple[str, ...]:
        """Return one line of text for each event, with the times of the points [s] instead of their numbers."""
        clock = list(times)
        if not clock:
            return tuple(map(str, self))
        rows = []
        for event in self:
            begin, end = (with_unit(clock[place] - clock[0], "s") for place in (event.first, event.last))
            rows.append(f"{begin if begin == end else f'{begin} to {end}'}: {event.sentence}")
        return tuple(rows)


def with_error(number: float, error: float, unit: str) -> str:
    """Return a number with its standard error in one unit; without the error where it is zero.

    Examples
    --------
    >>> with_error(4.451e-11, 7.5e-13, "N"), with_error(2e-9, 0.0, "m")
    ('44.51 ± 0.75 pN', '2 nm')
    """
    if not error > 0.0:
        return with_unit(number, unit)
    scale = scale_of(unit, number)
    digits = max(1 - math.floor(math.log10(error / scale.factor)), 0)
    if digits > MOST_DIGITS:
        return f"{with_unit(number, unit)} ± {with_unit(error, unit, 2)}"
    return f"{number / scale.factor:.{digits}f} ± {error / scale.factor:.{digits}f} {scale.unit}".replace("-", "−")


def confidence_of(ratio: float, places: int) -> float:
    """Return the probability that Gaussian noise nowhere exceeds `ratio` standard deviations, at so many places."""
    return (1.0 - math.erfc(min(ratio, 40.0) / math.sqrt(2.0))) ** max(places, 1)
