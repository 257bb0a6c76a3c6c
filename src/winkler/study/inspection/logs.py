"""What logs of tests say by themselves, in lines: numbers with standard errors."""

from __future__ import annotations

import math

import numpy as np

from winkler.fitting.logs.contact_resistance import ResistanceLog
from winkler.fitting.logs.estimated import Estimate
from winkler.fitting.logs.friction_log import FrictionLog
from winkler.fitting.logs.runs import FEWEST_BOUNCES, BounceTimes, PinOnDisc
from winkler.values.readable import with_unit

UNEVEN = 0.1
"""Relative standard deviation of strokes from which on they are named."""
LEAST_ERRORS, SAME_RESTITUTION = 4.0, 1e-4
"""Least difference of two coefficients of restitution that is named, in standard errors and beyond that number."""
TREND = 0.1
"""Change of the amplitude of the force within the second half, over its mean, that is named."""


def log_lines(content: object) -> tuple[str, ...]:
    """Return what a log says, one line each; nothing of other contents."""
    if isinstance(content, BounceTimes):
        return (f"coefficient of restitution {_text(content.restitution)}, if it is the same in all bounces",)
    if isinstance(content, FrictionLog):
        return _of_loops(content)
    if isinstance(content, ResistanceLog):
        low, high = (with_unit(one, "ohm", 4) for one in (np.min(content.resistance), np.max(content.resistance)))
        return (
            f"resistance {low} to {high}, falling with the power {_text(content.exponent)} of the force (1/3: a clean "
            "elastic ball; 1/2: spots that yield; 2/3 to 1: a film)",
        )
    if not isinstance(content, PinOnDisc):
        return ()
    lines = []
    if content.friction.size:
        lines.append(f"coefficient of friction {_text(content.steady_friction)} over the second half")
    if content.height_loss.size:
        rate = content.wear_per_distance
        lines.append(f"height loss {_with_error(rate, 'm', 1e3)} per kilometre over the second half")
        lines.append(f"k = V / (F s) = {rate.value:.4g} A/F, of the area A of the pin and its force F")
    return tuple(lines)


def _of_loops(log: FrictionLog) -> tuple[str, ...]:
    stroke, force, loss, slope = (
        _with_error(log.late(numbers), unit)
        for numbers, unit in (
            (log.stroke, "m"),
            (log.shear_amplitude, "N"),
            (log.loss_per_cycle, "J"),
            (log.slope, "N/m"),
        )
    )
    lines = [
        f"{len(log.cycles)} whole cycles, by the turns of the displacement; numbers of the second half follow",
        f"stroke {stroke} from end to end, shear force to ± {force}",
        f"loss {loss} per cycle, the area of the loop",
        f"slope {slope} behind the turns: contact and frame in series",
    ]
    if log.reversed:
        lines.append("the force is that on the drive: its sign is turned, so that loops lose energy")
    pressed = log.normal_of_cycles
    if pressed.size:
        lines.append(
            f"shear over normal force {_text(log.late(log.shear_amplitude / pressed))}, at the ends of the loops"
        )
    return tuple(lines)


def log_doubts(content: object) -> tuple[str, ...]:
    """Return what is doubtful about a log, one sentence each."""
    if isinstance(content, BounceTimes):
        return _of_bounces(content)
    if not isinstance(content, FrictionLog):
        return ()
    doubts = []
    half = slice(len(content.cycles) // 2, None)
    stroke, force = content.stroke[half], content.shear_amplitude[half]
    if float(np.std(stroke)) > UNEVEN * float(np.mean(stroke)):
        doubts.append(
            f"Strokes of the second half are {with_unit(float(stroke.min()), 'm', 3)} to "
            f"{with_unit(float(stroke.max()), 'm', 3)}: give each amplitude a separate file."
        )
    if force.size > 2:
        change = float(np.polyfit(np.linspace(0.0, 1.0, force.size), force, 1)[0]) / float(np.mean(force))
        if abs(change) > TREND:
            doubts.append(
                f"The shear force continues to change, by {100 * change:+.0f} % within the second half: it is "
                "not steady."
            )
    negative = int(np.count_nonzero(content.loss_per_cycle <= 0.0))
    if negative:
        doubts.append(
            f"{negative} of {len(content.cycles)} loops dissipate no energy: their opening is below the noise."
        )
    return tuple(doubts)


def _of_bounces(log: BounceTimes) -> tuple[str, ...]:
    """Return that the restitution of early and late bounces differs, as it does over the speed."""
    middle = log.bounce.size // 2
    if middle < FEWEST_BOUNCES:
        return ()
    early, late = (BounceTimes(part).restitution for part in (log.bounce[:middle], log.bounce[middle:]))
    if abs(early.value - late.value) <= LEAST_ERRORS * math.hypot(early.error, late.error) + SAME_RESTITUTION:
        return ()
    return (
        f"The restitution is not the same in all bounces: {_text(early)} in the first half, {_text(late)} in the "
        "second.",
    )


def _with_error(number: Estimate, unit: str, factor: float = 1.0) -> str:
    error = f" ± {with_unit(factor * number.error, unit, 2)}" if math.isfinite(number.error) else ""
    return f"{with_unit(factor * number.value, unit, 4)}{error}"


def _text(number: Estimate) -> str:
    return f"{number.value:.4g}" + (f" ± {number.error:.2g}" if math.isfinite(number.error) else "")
