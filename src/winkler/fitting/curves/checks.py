"""Checks of a measured curve before a fit, by name.

no_contact
    At its largest position the force does not stand out of the noise.
reversed
    There the force is tensile: its sign, or that of the position, is reversed.
saturated
    The force stays at its largest or least value while the machine moves on: the detector is at the end of its range.
few_points
    Too few for a fit.
units
    Positions or forces beyond the range of such machines, or a deflection greater than the travel.
no_baseline
    On approach, on retraction or on both hardly any points lie out of contact, so that zero force is uncertain.

The first five make a fit meaningless (`refuse`), the last one makes it less certain.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.events.saturation import saturated_rows
from winkler.fitting.curves.medians import median
from winkler.fitting.curves.outline import (
    BASELINE_POINTS,
    FEWEST,
    SIGNAL_TO_NOISE,
    CurveOutline,
    far_force,
    outline,
    single_direction,
)
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

__all__ = ["CurveOutline", "Flag", "examined", "outline", "refuse", "unsaturated", "without_baseline"]

LONGEST_TRAVEL, GREATEST_FORCE = 0.1, 1e5
MOST_DEFLECTION_RATIO = 1.5
"""Greatest deflection of a machine over its travel, up to the zero of force."""
LEAST_SLOPE_RATIO = 5.0
"""Least slope at the beginning over that at the end of a reversed curve."""
TAIL_SHARE = 0.1
"""Part of the points, farthest from the sample, along which a free force hardly changes."""


@value
class Flag:
    """A mistake of a curve, or a doubt about a fit.

    Parameters
    ----------
    name : str
        One word, to sort by.
    statement : str
        One sentence.
    """

    __words__ = words(name=("", None, "one word"), statement=("", None, "one sentence"))

    name: str
    statement: str

    def __str__(self) -> str:
        return f"{self.name}: {self.statement}"


def _saturated_points(curve: ForceCurve) -> Array:
    """Return the points of the longest plateaus at the largest and the least force during motion."""
    rows = saturated_rows(curve.position, curve.force, far_force(single_direction(curve)[1]))
    return np.concatenate([np.zeros(0, dtype=int), *rows])


def unsaturated(curve: ForceCurve) -> ForceCurve:
    """Return a curve without the points at which the detector is saturated."""
    saturated = _saturated_points(curve)
    if not saturated.size:
        return curve
    return curve.chosen(~np.isin(curve.force, curve.force[saturated]))


def _missing_baselines(curve: ForceCurve) -> list[str]:
    """Return the directions with too few points out of contact, as text."""
    missing = []
    directions = {}
    for word, direction in (("approach", 1.0), ("retract", -1.0)):
        selected = curve.direction == direction
        if np.count_nonzero(selected) < FEWEST:
            continue
        part = curve if selected.all() else curve.chosen(selected)
        rough_outline = outline(part)
        position, force = single_direction(part)
        pull = rough_outline.pull
        line = rough_outline.baseline + rough_outline.slope * (position - rough_outline.contact_point)
        in_tension = np.flatnonzero((force < line - 0.5 * pull) & (pull > 0.0))
        count = min([rough_outline.before, *in_tension[:1].tolist()])
        if count < BASELINE_POINTS:
            missing.append(f"on {word} {count} points lie out of contact")
        else:
            directions[word] = position, force, rough_outline.noise
    if len(directions) == 2 and _ends_in_tension(*directions["approach"], *directions["retract"][:2]):
        missing.append("on retract the curve ends before pull-off")
    return missing


def _ends_in_tension(position: Array, force: Array, noise: float, back: Array, pull: Array) -> bool:
    """Return whether the retraction ends under a tension that still changes; a constant one is drag."""
    level = far_force(force)
    least = float(pull.min())
    if not level - far_force(pull) > max(SIGNAL_TO_NOISE * noise, 0.5 * (level - least)):
        return False
    tail = max(FEWEST, int(TAIL_SHARE * back.size))
    rise = float(np.polyfit(back[:tail] - back[0], pull[:tail], 1)[0])
    free = max(FEWEST, int(TAIL_SHARE * position.size))
    tilt = float(np.polyfit(position[:free] - position[0], force[:free], 1)[0])
    change = abs(rise - tilt) * float(np.ptp(back[:tail]))
    return change > max(SIGNAL_TO_NOISE * noise * math.sqrt(12.0 / tail), 0.02 * (level - least))


def _backwards(position: Array, force: Array, limit: float) -> bool:
    """Return whether the force falls from a steep beginning to a flat end, with contact at the least position."""
    count = max(FEWEST, int(TAIL_SHARE * force.size))
    if not far_force(force) - median(force[-count:]) > limit or not np.ptp(position[-count:]) > 0.0:
        return False
    if not np.ptp(position[:count]) > 0.0:
        return False
    begin = float(np.polyfit(position[:count] - position[0], force[:count], 1)[0])
    end = float(np.polyfit(position[-count:] - position[-1], force[-count:], 1)[0])
    return begin < -LEAST_SLOPE_RATIO * abs(end)


def examined(curve: ForceCurve) -> tuple[Flag, ...]:
    """Return the mistakes of a curve; empty, if it can be fitted.

    Parameters
    ----------
    curve : ForceCurve
    """
    if curve.count < FEWEST:
        return (Flag("few_points", f"The curve has {curve.count} points; at least {FEWEST} are needed."),)
    rough_outline = outline(curve)
    flags = [*_wrong_units(curve, rough_outline), *_wrong_forces(curve, rough_outline)]
    if not any(flag.name in ("reversed", "no_contact") for flag in flags):
        flags += _no_baseline(_missing_baselines(curve))
    return tuple(flags)


def without_baseline(curve: ForceCurve, touched: Array, directions: tuple[str, ...]) -> Iterator[Flag]:
    """Yield `no_baseline` for a fitted curve that hardly has points out of contact.

    Without a model, a curve wholly in contact may look like a tilted baseline with a contact behind it (`examined`).

    Parameters
    ----------
    curve : ForceCurve
    touched : ndarray of bool, (n,)
        Points in contact, as fitted.
    directions : tuple of str
        Of "approach" and "retract" those that need a baseline; none is asked of a direction of few points.
    """
    missing = []
    for word in directions:
        selected = curve.direction == (1.0 if word == "approach" else -1.0)
        count = int(np.count_nonzero(selected & ~touched))
        if np.count_nonzero(selected) >= FEWEST and count < BASELINE_POINTS:
            missing.append(f"on {word} {count} points lie out of contact")
    yield from _no_baseline(missing)


def _no_baseline(missing: list[str]) -> Iterator[Flag]:
    if missing:
        statement = f"{' and '.join(missing).capitalize()}; the zero of force and the contact point are uncertain."
        yield Flag("no_baseline", statement)


def _wrong_units(curve: ForceCurve, rough_outline: CurveOutline) -> Iterator[Flag]:
    travel, strength = float(np.ptp(curve.position)), float(np.abs(curve.force).max())
    deflection = curve.compliance * rough_outline.top
    if travel > LONGEST_TRAVEL or strength > GREATEST_FORCE:
        yield Flag(
            "units",
            f"The curve spans {travel:.3g} m and {strength:.3g} N, more than any indenter; give positions in m and "
            "forces in N.",
        )
    elif deflection > MOST_DEFLECTION_RATIO * travel:
        yield Flag(
            "units",
            f"A machine of {curve.machine_stiffness:.3g} N/m bends by {deflection:.3g} m under the largest force, "
            f"{rough_outline.top:.3g} N, but has moved by {travel:.3g} m only; give forces in N, the stiffness in "
            "N/m, and positions in m of the stage (with those of the tip, no stiffness).",
        )


def _wrong_forces(curve: ForceCurve, rough_outline: CurveOutline) -> Iterator[Flag]:
    top, noise = rough_outline.top, rough_outline.noise
    limit = max(SIGNAL_TO_NOISE * noise, 1e-12 * float(np.abs(curve.force).max()))
    if _backwards(*single_direction(curve), limit):
        yield Flag(
            "reversed",
            "The force is compressive where the position is smallest and hardly changes where it is largest; "
            "positions count towards the sample: change their sign.",
        )
    elif top < -limit:
        yield Flag(
            "reversed",
            f"At the largest position the force is {top:.3g} N, tension; compression counts positive "
            "and so does motion towards the sample: change the sign of force or position.",
        )
    elif top <= limit and rough_outline.pull == 0.0:
        yield Flag(
            "no_contact",
            f"At the largest position the force is {top:.3g} N, not above {SIGNAL_TO_NOISE:g} times the noise of "
            f"{noise:.3g} N; no contact can be distinguished from the noise.",
        )
    elif (count := _saturated_points(curve).size) > 0:
        yield Flag(
            "saturated",
            f"{count} points in rows have the largest force, {curve.force.max():.6g} N, or the least, "
            f"{curve.force.min():.6g} N, while the machine moves on; leave them out (checks.unsaturated).",
        )


def refuse(curve: ForceCurve, but: tuple[str, ...] = ()) -> tuple[Flag, ...]:
    """Return the flags of a curve that can be fitted; those named in `but` are ignored.

    Raises
    ------
    InvalidInput
        If it cannot, by the name of the flag.
    """
    flags = tuple(flag for flag in examined(curve) if flag.name not in but)
    for flag in flags:
        if flag.name != "no_baseline":
            raise InvalidInput(f"curve '{curve.name}': {flag}")
    return flags
