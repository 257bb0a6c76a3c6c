"""Several curves fitted at once: some numbers are shared, such as a modulus, others are each curve's own.

Contact point and baseline differ from curve to curve; the modulus of one sample, or the thickness of one film, does
not.  Curves of different depths, speeds or tips determine together what one alone leaves open.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.outcome import AnyFit, CreepFit
from winkler.fitting.search import Search
from winkler.fitting.several.assembling import joint_fit
from winkler.fitting.several.beginning import begun_alone, errors_of, same_start
from winkler.fitting.several.joining import joined
from winkler.fitting.several.joint import JointFit
from winkler.fitting.several.same_task import SameTask, same_task
from winkler.fitting.validity import Model
from winkler.numerics.types import Array
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.values.errors import InvalidInput, suggest

__all__ = ["fit_together", "joint_of"]

FEWEST = 2


def fit_together(
    curves: Sequence[ForceCurve],
    models: Model | ViscoelasticIndentation | Sequence[Model | ViscoelasticIndentation],
    *,
    free: Mapping[str, Any] | Iterable[str],
    shared: Iterable[str],
    noise: float | Sequence[float] = 0.0,
    time_limit: float = math.inf,
) -> JointFit:
    """Fit several curves at once, with numbers that they share.

    Parameters
    ----------
    curves : sequence of ForceCurve, (k,)
        At least two.
    models : model, or sequence of models, (k,)
        One for all curves, or one for each, such as tips of different radii.
    free : mapping or iterable of str
        As for `fit`, for every curve.
    shared : iterable of str
        Which of them are the same for all curves; the others are each curve's own.
    noise : float or sequence of float, optional
        As for `fit`, one for all or one for each curve.
    time_limit : float, optional
        Of the fit of one curve, and of the joint fit [s].

    Returns
    -------
    JointFit

    Raises
    ------
    InvalidInput
        If there are fewer than two curves, their numbers do not fit, or a shared number is not free.
    OutsideValidity
        If the curves together do not determine the numbers.
    NotConverged
        If least squares do not converge, or not within the time limit.

    Examples
    --------
    Two shallow curves with different balls on one gel.

    >>> import numpy as np
    >>> from winkler import Depth, Elastic, ForceCurve, Foundation, HalfSpace, Indentation, Paraboloid
    >>> curves, models, random = [], [], np.random.default_rng(1)
    >>> for radius, origin in ((2e-6, 3e-6), (10e-6, 1e-6)):
    ...     depth = np.linspace(-1e-6, 0.5e-6, 300)
    ...     force = 4.0 / 3.0 * 5e3 / 0.75 * np.sqrt(radius) * np.maximum(depth, 0.0) ** 1.5
    ...     curves.append(ForceCurve(depth + origin, force + 1e-11 * random.standard_normal(300)))
    ...     bed = Foundation(Paraboloid(radius), HalfSpace.between(Elastic(1e4, 0.5)))
    ...     models.append(Indentation(bed, Depth(0.0)))
    >>> young = "bed.medium.first.young"
    >>> found = fit_together(curves, models, free=[young, "contact_point"], shared=[young])
    >>> low, high = found.interval(young)
    >>> low < 5e3 < high, [round(fit.value("contact_point"), 8) for fit in found.fits]
    (True, [3e-06, 1e-06])
    """
    curves = tuple(curves)
    each = (models,) * len(curves) if isinstance(models, Model | ViscoelasticIndentation) else tuple(models)
    noises = tuple(noise) if isinstance(noise, Sequence) else (noise,) * len(curves)
    for word, many in (("models", each), ("noise", noises)):
        if len(many) != len(curves):
            raise InvalidInput(f"fit_together: there are {len(curves)} curves and {len(many)} {word}; give one each.")
    stated = dict(free) if isinstance(free, Mapping) else dict.fromkeys(free, ())
    names = _shared(shared, tuple(stated), len(curves))
    begun = [
        begun_alone(curve, model, stated, names, level, time_limit)
        for curve, model, level in zip(curves, each, noises, strict=True)
    ]
    return _joint([one[0] for one in begun], [one[1] for one in begun], names, noises, time_limit)


def joint_of(fits: Sequence[AnyFit], shared: Iterable[str], *, time_limit: float = math.inf) -> JointFit:
    """Return the joint fit of curves that were fitted one by one, with some of their numbers shared.

    Parameters
    ----------
    fits : sequence of Fit or ViscoelasticFit, (k,)
        At least two, with the same free numbers.
    shared : iterable of str
    time_limit : float, optional
        [s].

    Raises
    ------
    InvalidInput, OutsideValidity, NotConverged
        As for `fit_together`.
    """
    names = _shared(shared, fits[0].names if fits else (), len(fits))
    if any(set(one.names) != set(fits[0].names) for one in fits):
        raise InvalidInput("joint_of: the fits have different free numbers; free the same for all curves.")
    if any(isinstance(one, CreepFit) for one in fits):
        raise InvalidInput("joint_of: positions were fitted; curves are fitted together by their forces.")
    noises = tuple(one.noise for one in fits)
    return _joint([same_task(one) for one in fits], [errors_of(one, names) for one in fits], names, noises, time_limit)


def _shared(shared: Iterable[str], free: tuple[str, ...], count: int) -> tuple[str, ...]:
    names = tuple(dict.fromkeys([shared] if isinstance(shared, str) else shared))
    if count < FEWEST:
        raise InvalidInput(f"fit_together: {count} curve{'s' * (count != 1)} cannot share numbers; give at least 2.")
    if not names:
        raise InvalidInput("fit_together: nothing is shared; name at least one free number.")
    for name in names:
        if name not in free:
            raise InvalidInput(
                f"fit_together: '{name}' is shared, but not free{suggest(name, free)}; {', '.join(free)} are free."
            )
    return names


def _joint(
    begun: list[SameTask], errors: list[Array], names: tuple[str, ...], noises: Sequence[float], time_limit: float
) -> JointFit:
    started = same_start(begun, np.array(errors), names)
    return joint_fit(joined(started, names, Search(time_limit)), started, names, noises)
