"""Modulus and hardness over depth from the continuously measured stiffness of one curve of a study."""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from winkler.fitting.nanoindentation.continuous import (
    ContinuousIndentation,
    ContinuousIndentationSolution,
    WindowMean,
)
from winkler.fitting.nanoindentation.measurement import NanoindentationSolution
from winkler.io.placed_curves import PlacedCurve
from winkler.study.nanoindentation.reading import NanoindentationStudy
from winkler.values.errors import WinklerError
from winkler.values.readable import with_unit
from winkler.values.value import value

__all__ = ["EvaluatedContinuously", "evaluated_continuously"]


DEEPER = 0.5
"""Part of the greatest depth from which on a curve is averaged where no depths are stated."""
MOST_ERRORS = 2.0
"""Greatest difference to the instrument's own result, in standard uncertainties, that is not named."""


@value
class EvaluatedContinuously:
    """A curve with modulus and hardness at every depth.

    Parameters
    ----------
    name : str
        Origin of the curve.
    solution : ContinuousIndentationSolution
        Its readings.
    own_touch : bool
        Whether the touch was found or given; else depth is as the instrument states it.
    window : tuple of float
        Depths [m] between which means are taken: those of the study, else the deeper half.
    mean : WindowMean
        Means of E and H there.
    stated : tuple of float
        The instrument's own E and H [Pa] there; nan where the file has none.
    """

    name: str
    solution: ContinuousIndentationSolution
    own_touch: bool
    window: tuple[float, float]
    mean: WindowMean
    stated: tuple[float, float] = (math.nan, math.nan)

    @property
    def doubts(self) -> tuple[str, ...]:
        """Sentences on results of the instrument that differ by more than the uncertainty."""
        mean, found = self.mean, []
        ours = (
            ("E", mean.young, mean.young_error, mean.young_scatter),
            ("H", mean.hardness, mean.hardness_error, mean.hardness_scatter),
        )
        for (word, number, error, scatter), theirs in zip(ours, self.stated, strict=True):
            whole = math.hypot(error, scatter / math.sqrt(mean.points))
            if abs(number - theirs) > MOST_ERRORS * whole:
                texts = [with_unit(one, "Pa", 3) for one in (theirs, number, whole)]
                found.append(f"{word} {texts[0]}, here {texts[1]}, uncertain by {texts[2]}")
        if not found:
            return ()
        low, high = (with_unit(end, "m", 3) for end in self.window)
        return (
            f"Instrument: its own results at {low} to {high} differ ({'; '.join(found)}): compare area function, "
            "frame, touch and Poisson's ratio.",
        )


def evaluated_continuously(
    study: NanoindentationStudy, placed: PlacedCurve, name: str, unloadings: NanoindentationSolution | None
) -> EvaluatedContinuously | str:
    """Return E and H over depth, or the reason why there are none.

    Touch and drift of the unloadings of the same curve correct the depth, or a given touch; without them it stays as
    the file states it.
    """
    data, given = placed.continuous, study.given
    assert data is not None
    error = given.get("contact_point_error", 0.0)
    if unloadings is not None:
        zero, drift = unloadings.zero_point, unloadings.drift
        steady = drift.rate * (data.time - unloadings.problem.curve.time[0]) if data.time.size else 0.0
        data = dataclasses.replace(
            data, depth=data.depth - zero.position - np.asarray(steady), force=data.force - zero.baseline
        )
        error = zero.error
    elif "contact_point" in given:
        data = dataclasses.replace(data, depth=data.depth - given["contact_point"])
    try:
        found = ContinuousIndentation(
            data,
            study.indenter,
            given["poisson"],
            depth_offset_error=error,
            stiffness_error=given.get("stiffness_error", 0.0),
        ).solve()
        deepest = float(found.depth.max())
        low, high = study.window or (DEEPER * deepest, deepest)
        mean = found.mean(low, high)
    except WinklerError as failure:
        return f"continuous stiffness: {failure}"
    stated = placed.stated.mean(low, high) if placed.stated is not None else (math.nan, math.nan)
    own_touch = unloadings is not None or "contact_point" in given
    return EvaluatedContinuously(name, found, own_touch, (low, high), mean, stated)
