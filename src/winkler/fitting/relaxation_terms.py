"""Number of relaxation times that a curve determines: fits of one, two and more terms, compared."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from winkler.fitting.compare import Comparison, compare
from winkler.fitting.curves.curve import ForceCurve
from winkler.materials.viscoelastic import Prony
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.types import Quantity
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.values.checks.number_checks import Whole, checked
from winkler.values.errors import InvalidInput

MOST_TERMS = 8


def compare_terms(
    curve: ForceCurve,
    model: ViscoelasticIndentation,
    *,
    free: Mapping[str, Any] | Iterable[str],
    most: int = 5,
    noise: Quantity = 0.0,
    time_limit: float = math.inf,
) -> Comparison:
    """Fit Prony solids with one to `most` relaxation times to a curve, and rank them.

    The initial times are evenly spaced on a logarithmic scale, from the shortest time step of the curve to its
    duration. They are constant unless they are free parameters.

    Parameters
    ----------
    curve : ForceCurve
    model : ViscoelasticIndentation
        A model with a `Prony` solid as the first body, whose moduli and times are replaced.
    free : mapping or iterable of str
        As for `winkler.fitting.fit.fit`; whole rows, such as "bed.medium.first.shears".
    most : int, optional
        The maximum number of terms, up to 8.
    noise : float or ndarray, optional
        As for `fit`.
    time_limit : float, optional
        Time limit of one fit [s].

    Returns
    -------
    Comparison
        Models named "1 term", "2 terms", ...

    Raises
    ------
    InvalidInput
        If the first body is no `Prony`, the curve has no times, or `most` is out of range.
    OutsideValidity
        If no number of terms can be fitted.
    """
    medium = model.bed.medium
    if not isinstance(medium, ViscoelasticHalfSpace) or not isinstance(medium.first, Prony):
        raise InvalidInput("compare_terms: the first body is no Prony; give Prony(...), whose terms are counted.")
    checked(Whole(1, MOST_TERMS), "compare_terms", "most", most)
    if not curve.timed or not np.ptp(curve.time) > 0.0:
        raise InvalidInput(f"compare_terms: curve '{curve.name}' has no times, and a solid that relaxes needs them.")
    free_names = free if isinstance(free, Mapping) else tuple(free)
    steps = np.diff(curve.time)
    shortest, longest = 3.0 * float(np.median(steps[steps > 0.0])), float(np.ptp(curve.time))
    solid = medium.first
    whole = float(np.sum(solid.shears)) or solid.relaxed_shear
    models = {}
    for count in range(1, most + 1):
        inner = np.geomspace(shortest, longest, count + 2)[1:-1]
        one = dataclasses.replace(solid, shears=np.full(count, whole / count), relaxation_times=inner)
        bed: Any = dataclasses.replace(model.bed, medium=dataclasses.replace(medium, first=one))  # type: ignore[type-var]
        models[f"{count} term{'s' * (count > 1)}"] = (dataclasses.replace(model, bed=bed), free_names)
    return compare(curve, models, noise=noise, time_limit=time_limit)
