r"""Corrections of a force curve: baseline, drift, drag, interference, clock.  Each is an explicit step.

`free_line`, `drift_rate` and `drag_force` estimate a correction; functions `without_...` return a corrected curve.
"""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.events.found import drag_in, kept_points
from winkler.fitting.curves.events.interference import Interference
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import NON_NEGATIVE, checked
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

FEWEST = 10


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
    """Return the points out of contact, less the tenth of them nearest to contact, because of attraction.

    Points that are stated as baseline (`ForceCurve.with_events`) are taken as they are.

    Raises
    ------
    InvalidInput
        If there are fewer than ten.
    """
    free = np.zeros(curve.count, dtype=bool)
    for points in kept_points(curve.record):
        free[points] = True
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


def drag_force(curve: ForceCurve) -> float:
    """Return the force of the liquid on the moving tip [N]: half the difference between approach and retraction.

    Both must have the same speed.  They are compared at the same positions, so that a tilt is no drag; a drift of the
    force in the order of measurement is taken into account where it is certain.  Positive: against the motion.

    Raises
    ------
    InvalidInput
        If one direction is missing, or has too few free points, or the drift between them is too large.
    """
    free = free_part(curve)
    for word, inward in (("approach", 1.0), ("retract", -1.0)):
        selected = free.direction == inward
        if np.count_nonzero(selected) < FEWEST:
            raise InvalidInput(
                f"drag: curve '{curve.name}' has {int(np.count_nonzero(selected))} free points on {word}; at least "
                f"{FEWEST} are needed in either direction."
            )
    drag = drag_in(curve.record)
    if drag is None:
        raise InvalidInput(
            f"drag: the force of curve '{curve.name}' drifts by more than its own range between approach and "
            "retraction, so that drag is not determined; correct nothing, or state the baseline."
        )
    return drag.force


def without_drag(curve: ForceCurve, drag: float) -> ForceCurve:
    """Return a curve without the drag of a liquid, which changes its sign with the direction.

    Parameters
    ----------
    curve : ForceCurve
    drag : float
        [N], as from `drag_force`.
    """
    return _with(curve, curve.position, curve.force - drag * curve.direction)


def without_interference(curve: ForceCurve, found: Interference) -> ForceCurve:
    """Return a curve without the sinusoid over the position, in contact as well.

    Parameters
    ----------
    curve : ForceCurve
    found : Interference
        As from `winkler.fitting.curves.events.found.interference_in`.
    """
    return _with(curve, curve.position, curve.force - found.at(curve.position))


def without_clock_offset(curve: ForceCurve, offset: float) -> ForceCurve:
    """Return a curve whose forces are those of the times of its positions, interpolated between the points.

    Points whose force lies outside the measurement are left out.

    Parameters
    ----------
    curve : ForceCurve
    offset : float
        Time by which the force is recorded late [s]; negative: early.

    Raises
    ------
    InvalidInput
        If the times are unknown, or the offset is as long as the curve.
    """
    if not curve.timed:
        raise InvalidInput(f"clock: curve '{curve.name}' has no times; give them, or correct nothing.")
    wanted = curve.time + offset
    inside = (wanted >= curve.time[0]) & (wanted <= curve.time[-1])
    if np.count_nonzero(inside) < FEWEST:
        raise InvalidInput(f"clock: an offset of {offset:.3g} s leaves no points of curve '{curve.name}'; give less.")
    return _with(curve, curve.position, np.interp(wanted, curve.time, curve.force)).chosen(inside)


def _with(curve: ForceCurve, position: Array, force: Array) -> ForceCurve:
    return dataclasses.replace(curve, position=position, force=force)


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


def on_frame(curve: ForceCurve, frame_compliance: float) -> ForceCurve:
    """Return the curve with the compliance of the frame added to its compliance.

    Parameters
    ----------
    curve : ForceCurve
    frame_compliance : float
        [m/N], not negative.
    """
    checked(NON_NEGATIVE, "on_frame", "frame_compliance", frame_compliance, "m/N")
    compliance = curve.compliance + frame_compliance
    return dataclasses.replace(curve, machine_stiffness=1.0 / compliance if compliance > 0.0 else math.inf)
