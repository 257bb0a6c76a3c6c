"""The least-squares problem of a fit that was made, at its fitted coordinates, so that it can be examined further."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.elastic.task import elastic_task
from winkler.fitting.outcome import AnyFit, Fit
from winkler.fitting.task import FitTask
from winkler.fitting.viscoelastic.drive import driven_task, examined_stroke
from winkler.numerics.types import Array


class SameTask(NamedTuple):
    """A task, coordinates of it ``(p,)``, and the fit of its curve."""

    task: FitTask
    coordinates: Array
    found: AnyFit


def same_task(found: AnyFit, curve: ForceCurve | None = None) -> SameTask:
    """Return the task of a fit and its fitted coordinates.

    Parameters
    ----------
    found : Fit, ViscoelasticFit or CreepFit
    curve : ForceCurve, optional
        In place of the fitted curve: as many points, of slightly different positions or forces.
    """
    curve = found.curve if curve is None else curve
    free = {name: (low, high) for name, low, high in zip(found.names, found.lows, found.highs, strict=True)}
    task: FitTask
    if isinstance(found, Fit):
        task = elastic_task(curve, found.model, free, np.zeros(()))
    else:
        task = driven_task(curve, found.model, free, np.array(found.noise), examined_stroke(curve)[0])
    task = task._replace(weights=found.weights)
    values = zip(task.parameters, found.values.tolist(), strict=True)
    return SameTask(task, np.array([parameter.inward(number) for parameter, number in values]), found)
