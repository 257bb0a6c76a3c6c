r"""Corrections of a force curve: baseline, drift, drag.  Each is an explicit step.

`free_line`, `drift_rate` and `drag_force` estimate a correction; functions `without_...` return a corrected curve.
"""

from __future__ import annotations

import numpy as np

from winkler.errors import InvalidInput
from winkler.fitting.curves.checks import outline
from winkler.fitting.curves.curve import ForceCurve
from winkler.numerics.types import Array
from winkler.values import value, words

__all__ = [
    "FreeLine",
    "drag_force",
    "drift_rate",
    "free_line",
    "free_part",
    "without_baseline",
    "without_drag",
    "without_drift",
    "without_force_drift",
]

FEWEST = 10
EXCLUDED_SHARE = 0.1
"""Part of the approach before contact that is not counted as free, because of attraction."""


@value
class FreeLine:
    """A straight line through the free part of a curve.

    Parameters
    ----------
    origin : float
        Position [m] at which `baseline` holds.
    baseline : float
        Force there [N].
    tilt : float
        Change of force with position [N/m].
    noise : float
        Standard deviation of the force about the line [N].
    """

    __words__ = words(
        origin=("D", "m", "position at which the baseline holds"),
        noise=(r"\sigma", "N", "standard deviation of the force about the line"),
    )

    origin: float
    baseline: float
    tilt: float
    noise: float

    def at(self, position: Array) -> Array:
        """Return the line's force at positions [N]."""
        return np.asarray(self.baseline + self.tilt * (position - self.origin))


def free_part(curve: ForceCurve) -> ForceCurve:
    """Return the points out of contact: before first touch, less a tenth of that distance.

    Raises
    ------
    InvalidInput
        If there are fewer than ten.
    """
    free = np.zeros(curve.count, dtype=bool)
    for direction in (1.0, -1.0):
        selected = curve.direction == direction
        if np.count_nonzero(selected) < FEWEST:
            continue
        part = curve.chosen(selected)
        rough_outline = outline(part)
        end = rough_outline.contact_point
        if rough_outline.pull > 0.0:  # an adhesive contact extends beyond first touch
            line = rough_outline.baseline + rough_outline.slope * (part.position - end)
            in_tension = part.force < line - 0.5 * rough_outline.pull
            end = float(part.position[in_tension].min(initial=end))
        start = float(part.position.min())
        if rough_outline.before >= FEWEST:
            free |= selected & (curve.position < start + (1.0 - EXCLUDED_SHARE) * (end - start))
    if np.count_nonzero(free) < FEWEST:
        raise InvalidInput(
            f"no_baseline: curve '{curve.name}' has {int(np.count_nonzero(free))} points out of contact; at least "
            f"{FEWEST} are needed to find its baseline."
        )
    return curve.chosen(free)


def free_line(curve: ForceCurve) -> FreeLine:
    """Return the straight line through the points out of contact.

    Raises
    ------
    InvalidInput
        If there are too few.
    """
    free = free_part(curve)
    origin = float(free.position.mean())
    along = free.position - origin
    spread = float(along @ along)
    tilt = float(along @ free.force) / spread if spread > 0.0 else 0.0
    baseline = float(free.force.mean())
    residuals = free.force - baseline - tilt * along
    return FreeLine(origin, baseline, tilt, float(np.sqrt(residuals @ residuals / (free.count - 2))))


def without_baseline(curve: ForceCurve, line: FreeLine) -> ForceCurve:
    """Return a curve whose free part lies at zero force."""
    return _with(curve, curve.position, curve.force - line.at(curve.position))


def drift_rate(hold: ForceCurve) -> float:
    """Return how fast the position drifts while the force is held [m/s].

    Raises
    ------
    InvalidInput
        If the times are unknown, or the same.
    """
    return _rate(hold, hold.position)


def without_drift(curve: ForceCurve, rate: float) -> ForceCurve:
    """Return a curve whose positions do not drift, counted from its first time.

    Parameters
    ----------
    curve : ForceCurve
    rate : float
        [m/s], as from `drift_rate`.

    Raises
    ------
    InvalidInput
        If the times are unknown.
    """
    return _with(curve, curve.position - rate * _elapsed(curve), curve.force)


def without_force_drift(curve: ForceCurve, rate: float) -> ForceCurve:
    """Return a curve whose forces do not drift, counted from its first time.

    Parameters
    ----------
    curve : ForceCurve
    rate : float
        [N/s].

    Raises
    ------
    InvalidInput
        If the times are unknown.
    """
    return _with(curve, curve.position, curve.force - rate * _elapsed(curve))


def drag_force(curve: ForceCurve) -> float:
    """Return the force of the liquid on the moving tip [N]: half the difference between approach and retraction.

    Both must have the same speed, and are compared at the same positions: a tilt is no drag.  Positive: against the
    motion.

    Raises
    ------
    InvalidInput
        If one direction is missing, or has too few free points.
    """
    free = free_part(curve)
    for word, inward in (("approach", 1.0), ("retract", -1.0)):
        selected = free.direction == inward
        if np.count_nonzero(selected) < FEWEST:
            raise InvalidInput(
                f"drag: curve '{curve.name}' has {int(np.count_nonzero(selected))} free points on {word}; at least "
                f"{FEWEST} are needed in either direction."
            )
    middle = free.position.mean()
    half = float(np.ptp(free.position)) or 1.0
    columns = np.stack([np.ones(free.count), (free.position - middle) / half, free.direction], axis=1)
    level = float(free.force.mean())
    return float(np.linalg.lstsq(columns, free.force - level, rcond=None)[0][2])


def without_drag(curve: ForceCurve, drag: float) -> ForceCurve:
    """Return a curve without the drag of a liquid, which changes its sign with the direction.

    Parameters
    ----------
    curve : ForceCurve
    drag : float
        [N], as from `drag_force`.
    """
    return _with(curve, curve.position, curve.force - drag * curve.direction)


def _with(curve: ForceCurve, position: Array, force: Array) -> ForceCurve:
    return ForceCurve(position, force, curve.machine_stiffness, curve.time, curve.direction, curve.name, curve.reading)


def _elapsed(curve: ForceCurve) -> Array:
    if not curve.timed:
        raise InvalidInput(f"drift: curve '{curve.name}' has no times; give them, or correct nothing.")
    return np.asarray(curve.time - curve.time[0])


def _rate(curve: ForceCurve, column: Array) -> float:
    elapsed = _elapsed(curve)
    centred = elapsed - elapsed.mean()
    spread = float(centred @ centred)
    if spread == 0.0:
        raise InvalidInput(f"drift: all times of curve '{curve.name}' are the same; a rate needs a range of times.")
    return float(centred @ column) / spread
