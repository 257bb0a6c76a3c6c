"""Doubts about an evaluated indentation: two parts of the program that disagree, and numbers that end on a bound."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from winkler.fitting.curves.corrections import on_frame
from winkler.fitting.curves.events.kinds import EventKind
from winkler.fitting.nanoindentation.touch import white_noise
from winkler.fitting.unloading.unloading_law import EXPONENT_BOUNDS, LEAST_FINAL_DEPTH
from winkler.values.readable import with_unit

__all__ = ["doubts_of"]

LEAST_ERRORS, LEAST_FORCE_TO_NOISE = 4.0, 20.0
"""Least distance of touch and baseline in standard errors, and least force between them over its noise, of a doubt."""
ON_BOUND = 1e-3
"""Relative distance from a bound of a number that ends on it."""


def doubts_of(solution: Any) -> tuple[str, ...]:
    """Return sentences on what makes the readings of an indentation doubtful; empty if nothing does.

    Parameters
    ----------
    solution : NanoindentationSolution
    """
    return (*_two_touches(solution), *_on_bounds(solution))


def _two_touches(solution: Any) -> Iterator[str]:
    """Yield whether the list of events ends the baseline elsewhere than at the point of first touch."""
    problem, zero = solution.problem, solution.zero_point
    curve = on_frame(problem.curve, problem.indenter.frame_compliance)
    baselines = [one for one in curve.events if one.kind is EventKind.BASELINE_BEFORE]
    if not baselines:
        return
    depth, force = curve.depth(zero.position), curve.force - zero.baseline
    begin, end = baselines[0].first, baselines[0].last
    noise = white_noise(force[begin : end + 1])
    ahead, rise = float(depth[end]), float(np.median(force[max(begin, end - 4) : end + 1]))
    if ahead > LEAST_ERRORS * zero.error and rise > LEAST_FORCE_TO_NOISE * noise:
        yield (
            f"Touch: two touches are seen. The first is taken, but {with_unit(rise, 'N', 2)} over "
            f"{with_unit(ahead, 'm', 2)} follow before the point where the list of events ends the baseline: dust, or "
            "a soft layer, may come before the sample; clean it, or give contact_point."
        )


def _on_bounds(solution: Any) -> Iterator[str]:
    """Yield which numbers of the fitted unloadings end on a bound."""
    least, most = (math.exp(end) for end in EXPONENT_BOUNDS)
    over = solution.exponent - 1.0
    for name, bound, reached in (
        (f"exponent of {1.0 + most:.4g}", "greatest", over >= most * (1.0 - ON_BOUND)),
        ("exponent of 1", "least", over <= least * (1.0 + ON_BOUND)),
        (
            f"final depth of {LEAST_FINAL_DEPTH:g} times that of the peak", "least",
            solution.final_depth <= LEAST_FINAL_DEPTH * solution.depth * (1.0 - ON_BOUND),
        ),
    ):  # fmt: skip
        if np.any(reached):
            which = ", ".join(str(place + 1) for place in np.flatnonzero(reached)[:5].tolist())
            yield (
                f"Bound: unloading {which} ends on the {bound} {name} that is tried, and its numbers have no meaning; "
                "check segments, drift and contact point, or fit another part of it (upper, lower)."
            )
