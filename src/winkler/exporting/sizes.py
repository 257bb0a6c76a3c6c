"""A law of balls of one radius as that of balls of all radii, which are alike."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.exporting.laws.particle import ball_of
from winkler.exporting.step_law import RADIUS, StepLaw
from winkler.media.offers import offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.problems.viscoelastic.march import elastic_like
from winkler.values.errors import InvalidInput

__all__ = ["of_every_radius"]

TRIAL_SIZE = 0.4
"""Of the pair in the test trace, over that of the study."""


def of_every_radius(law: StepLaw, problem: Any) -> StepLaw:
    """Return the law with R of the pair as the last number that goes in.

    Raises
    ------
    InvalidInput
        If the problem is not one of balls on homogeneous bodies, whose contacts of all radii are alike.
    """
    if math.isnan(law.curvature_radius):
        raise InvalidInput(
            "export: every-radius needs a paraboloid as profile, whose contacts of all radii are alike; leave it out, "
            "or give another profile."
        )
    bed = getattr(getattr(problem, "problem", problem), "bed", None)
    if bed is not None:
        ball_of(elastic_like(bed) if offers(bed.medium, RelaxingMedium) else bed)
    given = law.curvature_radius
    note = (
        f"R of the pair goes in. The numbers below are those of R = {given:.4g} m; lengths that they state are in "
        "proportion to R."
    )
    powers = np.array([TRIAL_SIZE if one.unit == "m" else 1.0 for one in law.motion])
    trial = np.column_stack([law.trial * powers, np.full(len(law.trial), TRIAL_SIZE * given)])
    return law._replace(motion=(*law.motion, RADIUS), trial=trial, notes=(note, *law.notes), every_radius=True)
