"""Modulus and hardness over depth from the continuously measured stiffness of one curve of a study."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.errors import WinklerError
from winkler.fitting.nanoindentation.continuous import ContinuousIndentation, ContinuousIndentationSolution
from winkler.fitting.nanoindentation.solution import NanoindentationSolution
from winkler.fitting.unloading.continuous_stiffness import ContinuousStiffness
from winkler.study.nanoindentation.reading import NanoindentationStudy
from winkler.values import value

__all__ = ["EvaluatedContinuously", "evaluated_continuously"]


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
        Whether depth and drift are those of the evaluated unloadings; else depth is as the instrument states it.
    """

    name: str
    solution: ContinuousIndentationSolution
    own_touch: bool


def evaluated_continuously(
    study: NanoindentationStudy, data: ContinuousStiffness, name: str, unloadings: NanoindentationSolution | None
) -> EvaluatedContinuously | str:
    """Return E and H over depth, or the reason why there are none.

    Touch and drift of the unloadings of the same curve correct the depth; without them it stays as the file states it.
    """
    error = study.given.get("contact_point_error", 0.0)
    if unloadings is not None:
        zero, drift = unloadings.zero_point, unloadings.drift
        steady = drift.rate * (data.time - unloadings.problem.curve.time[0]) if data.time.size else 0.0
        data = dataclasses.replace(
            data, depth=data.depth - zero.position - np.asarray(steady), force=data.force - zero.baseline
        )
        error = zero.error
    try:
        found = ContinuousIndentation(
            data,
            study.indenter,
            study.given["poisson"],
            depth_offset_error=error,
            stiffness_error=study.given.get("stiffness_error", 0.0),
        ).solve()
    except WinklerError as failure:
        return f"continuous stiffness: {failure}"
    return EvaluatedContinuously(name, found, unloadings is not None)
