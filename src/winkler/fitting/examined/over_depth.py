r"""A fitted number over the greatest depth that is fitted: the fit repeated with more and more of a curve.

A model that describes the sample gives the same number at any depth.  A film on a substrate, a tip of another shape or
a soft surface layer does not.  The fits share their points: of fits by maximum likelihood, the one with fewer points
has the variance of that with more and of an independent change (Hausman),

.. math:: \mathrm{var}(\theta_i - \theta_n) = \sigma_i^2 - \sigma_n^2 .

A number counts as constant if no change from the deepest fit exceeds its limit, which in one of 20 constant series one
of all changes exceeds.

References
----------
J. A. Hausman, Econometrica 46, 1251 (1978), https://doi.org/10.2307/1913827
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.fitting.outcome import Fit
from winkler.fitting.several.population import quantile
from winkler.fitting.validity import Model
from winkler.numerics.types import Array, Quantity
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.readable import with_unit
from winkler.values.value import value, words

LEAST_SHARE = 0.1
"""Smallest depth, in parts of the greatest."""
FEWEST_IN_CONTACT = 12
"""Fewest points in contact for a fit."""
CONFIDENCE = 0.95
LEAST_VARIANCE = 0.05
"""Least variance of a change, in parts of that of the smaller depth: the noise of each fit is estimated anew."""


@value
class DepthSeries:
    """A fitted parameter over the maximum fitted depth; the last value is that of the whole curve.

    Parameters
    ----------
    name : str
        The number.
    depths : ndarray, (m,)
        Maximum fitted depths [m], rising.
    forces : ndarray, (m,)
        Maximum fitted forces of the contact [N].
    values : ndarray, (m,)
        The number, in SI units.
    standard_errors : ndarray, (m,)
    lows, highs : ndarray, (m,)
        Intervals of 95 %.
    logarithmic : bool
        Whether the number is positive, and changes are those of its logarithm.
    freedom : float
        Degrees of freedom of the errors of the whole curve.
    refused : tuple of str
        Depths without a fit, with reasons.
    """

    __words__ = words(
        name=("", None, "the number over depth"),
        depths=("d", "m", "greatest fitted depths"),
        forces=("F", "N", "greatest fitted forces"),
        values=("", None, "the number at each greatest depth"),
        standard_errors=("", None, "their standard errors"),
        lows=("", None, "lower ends of the intervals"),
        highs=("", None, "upper ends of the intervals"),
        logarithmic=("", None, "whether changes are those of the logarithm"),
        freedom=("", "", "degrees of freedom of the errors"),
        refused=("", None, "depths without a fit, with the reason"),
    )

    name: str
    depths: Array
    forces: Array
    values: Array
    standard_errors: Array
    lows: Array
    highs: Array
    logarithmic: bool
    freedom: float
    refused: tuple[str, ...]

    @property
    def changes(self) -> Array:
        """Changes from the whole curve ``(m - 1,)``: relative ones (of the logarithm) of positive numbers."""
        return np.asarray(self._varied[:-1] - self._varied[-1])

    @property
    def limits(self) -> Array:
        """Maximum changes within which the parameter counts as constant, ``(m - 1,)``."""
        errors = self.standard_errors / self.values if self.logarithmic else self.standard_errors
        variances = np.maximum(errors[:-1] ** 2 - errors[-1] ** 2, LEAST_VARIANCE * errors[:-1] ** 2)
        confidence = 1.0 - (1.0 - CONFIDENCE) / max(variances.size, 1)
        return np.asarray(quantile(self.freedom, confidence) * np.sqrt(variances))

    @property
    def constant(self) -> bool:
        """Whether the number is constant within its errors."""
        return bool(np.all(np.abs(self.changes) <= self.limits))

    @property
    def verdict(self) -> str:
        """Whether the number is constant, as a sentence with depths."""
        if not self.changes.size:
            return "one depth alone says nothing about a change with depth"
        worst = int(np.argmax(np.abs(self.changes) / self.limits))
        shallow, deep = (with_unit(float(self.depths[place]), "m", 3) for place in (worst, -1))
        if self.constant:
            middle = int(np.argmin(np.abs(self.depths[:-1] - 0.5 * self.depths[-1])))
            least = float(self.limits[middle])
            size = f"{math.expm1(least):.1%}" if self.logarithmic else f"{least:.3g}"
            first, half = (with_unit(float(self.depths[place]), "m", 3) for place in (0, middle))
            return f"constant within its errors from {first} to {deep}; a change of {size} from {half} on would be seen"
        change = self.changes[worst]
        size = f"{abs(math.expm1(-change)):.0%}" if self.logarithmic else f"{abs(change):.3g}"
        how = "falls" if change > 0.0 else "rises"
        return f"not constant: it {how} by {size} from {shallow} to {deep}"

    @property
    def _varied(self) -> Array:
        return np.log(self.values) if self.logarithmic else self.values


def over_depth(
    curve: ForceCurve,
    model: Model,
    *,
    free: Mapping[str, Any] | Iterable[str],
    of: str = "",
    count: int = 12,
    noise: Quantity = 0.0,
    found: Fit | None = None,
) -> DepthSeries:
    """Fit a curve repeatedly, up to increasing depths.

    Parameters
    ----------
    curve : ForceCurve
    model : Indentation or AdhesiveIndentation
        As for `fit`. Viscoelastic bodies are not supported, because their load history cannot be cut.
    free : mapping or iterable of str
        As for `fit`; contact point and baseline are fitted anew at every depth.
    of : str, optional
        The number; the first free one of the model, by default.
    count : int, optional
        Number of depths, evenly spaced from a tenth of the maximum; 12 by default.
    noise : float or ndarray, optional
        As for `fit`.
    found : Fit, optional
        The fit of the whole curve, if it was made already.

    Returns
    -------
    DepthSeries

    Raises
    ------
    InvalidInput
        If the model relaxes, no number of the model is free, or `count` is less than two.
    OutsideValidity, NotConverged
        If the whole curve cannot be fitted.
    """
    if isinstance(model, ViscoelasticIndentation):
        raise InvalidInput("over_depth: the model relaxes, and its response depends on the whole history; fit it once.")
    if isinstance(count, bool) or not isinstance(count, int) or count < 2:
        raise InvalidInput(f"over_depth: count is {count!r}; give a whole number of depths, at least 2.")
    whole = fit(curve, model, free=free, noise=noise) if found is None else found
    name = of or next((one for one in whole.names if "." in one), "")
    if not name:
        raise InvalidInput("over_depth: no number of the model is free; name one, as 'bed.medium.first.young'.")
    whole.index(name)
    depth, refused, fits = whole.depth, [], []
    greatest = float(depth.max())
    for share in np.linspace(LEAST_SHARE, 1.0, count)[:-1].tolist():
        chosen = depth <= share * greatest
        try:
            if np.count_nonzero(chosen & whole.contact) < FEWEST_IN_CONTACT:
                raise OutsideValidity(f"fewer than {FEWEST_IN_CONTACT} points are in contact.")
            fits.append(_fit_of(whole, model, free, noise, chosen))
        except (InvalidInput, OutsideValidity, NotConverged) as error:
            refused.append(f"{with_unit(share * greatest, 'm', 3)}: {error}")
    fits.append(whole)
    return _series(name, fits, refused)


def _fit_of(whole: Fit, model: Model, free: Any, noise: Quantity, chosen: Array) -> Fit:
    """Return the fit of some points of a curve."""
    of_points = np.asarray(noise, dtype=float)
    if of_points.ndim:
        of_points = of_points[chosen] if of_points.size == chosen.size else np.asarray(whole.noise)
    return fit(whole.curve.chosen(chosen), model, free=free, noise=of_points if of_points.ndim else float(of_points))


def _series(name: str, fits: list[Fit], refused: list[str]) -> DepthSeries:
    intervals = np.array([one.interval(name, CONFIDENCE) for one in fits])
    last = fits[-1]
    return DepthSeries(
        name=name,
        depths=np.array([float(one.depth.max()) for one in fits]),
        forces=np.array([_greatest_force(one) for one in fits]),
        values=np.array([one.value(name) for one in fits]),
        standard_errors=np.array([one.error(name) for one in fits]),
        lows=intervals[:, 0],
        highs=intervals[:, 1],
        logarithmic=last.logarithmic[last.index(name)],
        freedom=max(last.effective_count - len(last.names), 1.0),
        refused=tuple(refused),
    )


def _greatest_force(found: Fit) -> float:
    baseline = found.value("baseline") if "baseline" in found.names else 0.0
    return float(np.max(found.predicted[found.contact])) - baseline
