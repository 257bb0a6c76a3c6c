"""What is wrong with a curve, by name, before anything is fitted to it.

no_contact
    At its largest position the force does not stand out of the noise.
reversed
    There the force is tensile: its sign, or that of the position, is the wrong way round.
saturated
    The force stays at its largest or least value while the machine moves on: the detector has come to its end.
few_points
    Too few to tell anything.
units
    Positions or forces of a size that no such machine reaches, or a force that would bend it farther than it moved.
no_baseline
    On the way in, on the way out or on both hardly a point out of contact tells where zero force is.

The first five make a fit meaningless (`refuse`), the last one makes it less certain.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.errors import InvalidInput
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.outline import BASELINE_POINTS, FEWEST, STANDS_OUT, Outline, far_force, one_way, outline
from winkler.numerics.types import Array
from winkler.values import value, words

__all__ = ["Flag", "Outline", "examined", "outline", "refuse", "unsaturated"]

LONGEST_TRAVEL, GREATEST_FORCE = 0.1, 1e5
FARTHEST_BENT = 1.5
"""Deflection of a machine over its travel, at most; in contact it is less than the travel, but for its zero."""
MANY_ALIKE = 5
PART_ALIKE = 0.01
DEEP = 0.05
"""Pull over the range of forces from which on a detector may have come to its lower end."""
STEEPER = 5.0
"""Slope in contact over that of a baseline, at least, where a curve seems to be backwards."""
TAIL = 0.1
"""Part of the points, the farthest from the sample, along which a free force hardly changes."""


@value
class Flag:
    """Something that is wrong with a curve or a fit.

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


def _alike(curve: ForceCurve) -> Array:
    """Return the points of the longest rows at the largest and the least force, while the machine moves on."""
    level = far_force(one_way(curve)[1])
    least = float(curve.force.min())
    tense = level - least > DEEP * float(np.ptp(curve.force))  # a coarse baseline may be even, a pull is not
    ends = [float(curve.force.max()), *([least] if tense else [])]
    return np.concatenate([_longest_row(curve, end) for end in ends])


def _longest_row(curve: ForceCurve, force: float) -> Array:
    same = np.flatnonzero(curve.force == force)
    rows = np.split(same, np.flatnonzero(np.diff(same) != 1) + 1)
    longest = max(rows, key=len)
    moved = float(np.ptp(curve.position[longest])) if longest.size else 0.0
    enough = longest.size >= MANY_ALIKE and moved > PART_ALIKE * float(np.ptp(curve.position))
    return longest if enough else longest[:0]


def unsaturated(curve: ForceCurve) -> ForceCurve:
    """Return a curve without the points at which the detector had come to its end."""
    alike = _alike(curve)
    if not alike.size:
        return curve
    return curve.chosen(~np.isin(curve.force, curve.force[alike]))


def _without_baseline(curve: ForceCurve) -> list[str]:
    """Return in words the ways that hardly have a point out of contact."""
    poor = []
    ways = {}
    for word, direction in (("approach", 1.0), ("retract", -1.0)):
        mine = curve.direction == direction
        if np.count_nonzero(mine) < FEWEST:
            continue
        way = curve.chosen(mine)
        strokes = outline(way)
        position, force = one_way(way)
        pulled = np.flatnonzero((force < strokes.baseline - 0.5 * strokes.pull) & (strokes.pull > 0.0))
        count = min([strokes.before, *pulled[:1].tolist()])
        if count < BASELINE_POINTS:
            poor.append(f"on {word} {count} points lie out of contact")
        else:
            ways[word] = position, force, strokes.noise
    if len(ways) == 2 and _ends_in_tension(*ways["approach"], *ways["retract"][:2]):
        poor.append("on retract the curve ends before the tip has come off")
    return poor


def _ends_in_tension(position: Array, force: Array, noise: float, back: Array, pull: Array) -> bool:
    """Return whether the way back ends in a pull that still changes; one that does not is drag."""
    level = far_force(force)
    least = float(pull.min())
    if not level - far_force(pull) > max(STANDS_OUT * noise, 0.5 * (level - least)):
        return False
    tail = max(FEWEST, int(TAIL * back.size))
    rise = float(np.polyfit(back[:tail] - back[0], pull[:tail], 1)[0])
    free = max(FEWEST, int(TAIL * position.size))
    tilt = float(np.polyfit(position[:free] - position[0], force[:free], 1)[0])
    change = abs(rise - tilt) * float(np.ptp(back[:tail]))
    return change > max(STANDS_OUT * noise * math.sqrt(12.0 / tail), 0.02 * (level - least))


def _backwards(position: Array, force: Array, limit: float) -> bool:
    """Return whether the force falls from a steep beginning to a flat end: contact is where the position is least."""
    many = max(FEWEST, int(TAIL * force.size))
    if not far_force(force) - float(np.median(force[-many:])) > limit or not np.ptp(position[-many:]) > 0.0:
        return False
    if not np.ptp(position[:many]) > 0.0:
        return False
    begin = float(np.polyfit(position[:many] - position[0], force[:many], 1)[0])
    end = float(np.polyfit(position[-many:] - position[-1], force[-many:], 1)[0])
    return begin < -STEEPER * abs(end)


def examined(curve: ForceCurve) -> tuple[Flag, ...]:
    """Return what is wrong with a curve; nothing, if it can be fitted.

    Parameters
    ----------
    curve : ForceCurve
    """
    flags = []
    if curve.count < FEWEST:
        flags.append(Flag("few_points", f"The curve has {curve.count} points; at least {FEWEST} are needed."))
        return tuple(flags)
    travel, strength = float(np.ptp(curve.position)), float(np.abs(curve.force).max())
    if travel > LONGEST_TRAVEL or strength > GREATEST_FORCE:
        flags.append(
            Flag(
                "units",
                f"The curve spans {travel:.3g} m and {strength:.3g} N, more than any indenter; give positions in m and "
                "forces in N.",
            )
        )
    strokes = outline(curve)
    bent = curve.compliance * strokes.top
    if not flags and bent > FARTHEST_BENT * travel:
        flags.append(
            Flag(
                "units",
                f"A machine of {curve.machine_stiffness:.3g} N/m bends by {bent:.3g} m under the largest force, "
                f"{strokes.top:.3g} N, but has moved by {travel:.3g} m only; give forces in N, the stiffness in N/m, "
                "and positions in m of the stage (with those of the tip, no stiffness).",
            )
        )
    limit = max(STANDS_OUT * strokes.noise, 1e-12 * strength)
    alike = _alike(curve)
    if _backwards(*one_way(curve), limit):
        flags.append(
            Flag(
                "reversed",
                "The force is compressive where the position is smallest and hardly changes where it is largest; "
                "positions count towards the sample: change their sign.",
            )
        )
    elif strokes.top < -limit:
        flags.append(
            Flag(
                "reversed",
                f"At the largest position the force is {strokes.top:.3g} N, tension; compression counts positive and "
                "so does motion towards the sample: change the sign of force or position.",
            )
        )
    elif strokes.top <= limit and strokes.pull == 0.0:
        flags.append(
            Flag(
                "no_contact",
                f"At the largest position the force is {strokes.top:.3g} N, within the noise of {strokes.noise:.3g} N; "
                "the tip has not touched.",
            )
        )
    elif alike.size:
        flags.append(
            Flag(
                "saturated",
                f"{alike.size} points in rows have the largest force, {curve.force.max():.6g} N, or the least, "
                f"{curve.force.min():.6g} N, while the machine moves on; leave them out (checks.unsaturated).",
            )
        )
    if not any(flag.name in ("reversed", "no_contact") for flag in flags):
        poor = _without_baseline(curve)
        if poor:
            flags.append(
                Flag(
                    "no_baseline",
                    f"{' and '.join(poor).capitalize()}; the zero of force and the contact point are uncertain.",
                )
            )
    return tuple(flags)


def refuse(curve: ForceCurve, but: tuple[str, ...] = ()) -> tuple[Flag, ...]:
    """Return the flags of a curve that can be fitted; those named in `but` do not count.

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
