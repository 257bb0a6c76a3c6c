r"""Solids that relax by a power of time: the springpot and the fractional Zener solid.

Their relaxation is an integral over exponentials of all rates, :math:`\int K(s)e^{-st}\mathrm ds`.  The trapezoidal
rule in :math:`\ln s` makes it a sum, whose error falls exponentially with the number of terms; rates too slow for the
requested span join the relaxed modulus, rates too fast for it are left out.  The error that remains within the
span is measured, refused above the tolerance, and stated.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Annotated, TypeAlias

import numpy as np

from winkler.materials.viscoelastic import FittedSolid
from winkler.numerics.springs.exponential_sums import RelaxationSeries
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import Advice, NonNegative, Number, PoissonRatio, Positive, between
from winkler.values.errors import InvalidInput, NotConverged
from winkler.values.limits import LEAST_STEP_RATIO
from winkler.values.value import value, words

TERM_SPACINGS = (1.6, 1.2, 0.9, 0.7, 0.5, 0.35, 0.25, 0.18, 0.12)
"""Distances of the terms in ln s, tried one after the other."""
SPAN_SAMPLES = 400
ROUNDING, NEARLY_GREATEST, ZOOMS, ZOOMED = 1e-14, 0.8, 5, 9
"""Of the sums, relative; part of the greatest sampled error from which a top is looked at closely, and how closely."""
REFERENCE_SPACING = 0.06
"""Distance in ln s of the sums that the series are measured by; their own error is of the order of 1e-13."""
SLOW_MARGIN, FAST_MARGIN = 46.0, 5.0
"""How far these sums go in ln s beyond the rates of the span."""


FractionalExponent: TypeAlias = Annotated[
    float,
    Number(f"give a number from {LEAST_STEP_RATIO:g} to below 1", LEAST_STEP_RATIO, 1.0, (1.0,)),
    Advice(f"below {LEAST_STEP_RATIO:g} the modulus falls by less than 0.03 % in a decade of time, use Elastic"),
]


class _FractionalSolid(FittedSolid):
    """What both solids share: a span of times, and the sum of exponentials that stands for the solid there."""

    exponent: float
    shortest: float
    longest: float
    tolerance: float

    def __post_init__(self) -> None:
        if not self.shortest < self.longest:
            raise InvalidInput(
                f"{type(self).__name__}: the span from {self.shortest:g} to {self.longest:g} s is empty; exchange them."
            )

    @property
    def span(self) -> tuple[float, float]:
        """Range of times [s] in which the series represents the solid."""
        return self.shortest, self.longest

    def _density(self, y: Array) -> Array:
        """Return the spectrum per ln s."""
        raise NotImplementedError

    def _itself(self, t: Array) -> Array:
        """Return G(t) [Pa] of the solid itself."""
        raise NotImplementedError

    @property
    def series_error(self) -> float:
        """Greatest relative error of the series within the span [-]."""
        series = self.series
        return _greatest(lambda t: np.abs(series.at(t) / self._itself(t) - 1.0), np.geomspace(*self.span, SPAN_SAMPLES))

    def _summed(self, relaxed: float = 0.0) -> tuple[RelaxationSeries, float]:
        """Return the shortest series within the tolerance, and its greatest sampled error."""
        shortest, longest = self.span
        t = np.geomspace(shortest, longest, SPAN_SAMPLES)
        goal = self._itself(t)
        little = math.log(1.0 / self.tolerance)
        for spacing in TERM_SPACINGS:
            # slower than this, a rate changes nothing within the span; faster, it is over when the span begins
            low = -math.log(longest) - little
            high = -math.log(shortest) + math.log(little + 3.0) + spacing
            y = np.arange(low, high + spacing, spacing)
            moduli = spacing * self._density(y)
            series = RelaxationSeries(relaxed + self._slower(low, spacing), 0.0, moduli[::-1], np.exp(-y)[::-1])
            error = float(np.max(np.abs(series.at(t) / goal - 1.0)))
            if error <= self.tolerance:
                return series, error
        raise NotConverged(
            f"{type(self).__name__}: no series comes closer than {error:.2g} to the solid within {shortest:g} to "
            f"{longest:g} s; allow a greater tolerance than {self.tolerance:g}."
        )

    def _slower(self, low: float, spacing: float) -> float:
        """Return the sum of all terms below a ln s; they fall with its exponent."""
        count = math.ceil(40.0 / (self.exponent * spacing))
        return float(spacing * np.sum(self._density(low - spacing * np.arange(count, 0, -1))))


def _greatest(error: Callable[[Array], Array], t: Array) -> float:
    """Return the greatest error, which lies between samples at these times: many tops are all but alike."""
    sampled = error(t)
    padded = np.pad(sampled, 1)
    tops = np.flatnonzero(
        (sampled >= padded[:-2]) & (sampled >= padded[2:]) & (sampled >= NEARLY_GREATEST * np.max(sampled))
    )
    y = np.log(t)
    low, high, every = y[np.maximum(tops - 1, 0)], y[np.minimum(tops + 1, t.size - 1)], np.arange(tops.size)
    for _ in range(ZOOMS):
        places = low + np.linspace(0.0, 1.0, ZOOMED)[:, None] * (high - low)
        values = error(np.exp(places.ravel())).reshape(places.shape)
        best = np.argmax(values, axis=0)
        low, high = places[np.maximum(best - 1, 0), every], places[np.minimum(best + 1, ZOOMED - 1), every]
    return float(np.max(values)) + ROUNDING


@value
class PowerLawSolid(_FractionalSolid):
    r"""A springpot: a solid whose modulus is a power of time within a given range of times.

    :math:`G(t)=G_0\,(t/t_0)^{-\alpha}`.

    Parameters
    ----------
    shear : float
        G_0 [Pa], positive: G at the time `time_scale`.
    time_scale : float
        t_0 [s], positive.
    exponent : float
        alpha [-], between 0 (elastic) and 1 (viscous), both excluded.
    shortest, longest : float
        Range of times in which the law holds [s].
    tolerance : float, optional
        Maximum relative error of the series there.
    poisson : float, optional
        nu [-].

    Raises
    ------
    InvalidInput
        If a number is outside its range.

    Examples
    --------
    >>> cell = PowerLawSolid(shear=500.0, time_scale=1.0, exponent=0.2, shortest=1e-4, longest=100.0)
    >>> bool(abs(cell.relaxation(0.01) / (500.0 * 0.01**-0.2) - 1.0) <= cell.series_error <= 1e-4)
    True
    """

    __words__ = words(exponent=(r"\alpha", "", "power of time by which a stress relaxes"))

    shear: Positive
    time_scale: Positive
    exponent: FractionalExponent
    shortest: Positive
    longest: Positive
    tolerance: Annotated[float, between(1e-10, 0.1)] = 1e-4
    poisson: PoissonRatio = 0.5

    def _density(self, y: Array) -> Array:
        alpha = self.exponent
        factor = self.shear * self.time_scale**alpha / math.gamma(alpha)
        return np.asarray(factor * np.exp(alpha * y))

    def _itself(self, t: Array) -> Array:
        return np.asarray(self.shear * (t / self.time_scale) ** -self.exponent)

    @property
    def _fitted(self) -> tuple[RelaxationSeries, float]:
        return self._summed()


@value
class FractionalZener(_FractionalSolid):
    r"""The fractional Zener solid: a spring in parallel with a spring and a springpot in series.

    :math:`G(t)=G_\infty+G_1\,E_\alpha\!\bigl(-(t/\tau)^\alpha\bigr)`.

    Parameters
    ----------
    relaxed_shear : float
        G_inf [Pa], zero or positive.
    shear : float
        G_1 [Pa], positive: the part of the modulus that relaxes.
    relaxation_time : float
        tau [s], positive.
    exponent : float
        alpha [-], between 0 and 1, both excluded; at 1 it would be `StandardSolid`.
    shortest, longest : float
        Range of times in which the law holds [s].
    tolerance : float, optional
        Maximum relative error of the series there.
    poisson : float, optional
        nu [-].

    Raises
    ------
    InvalidInput
        If a number is outside its range.

    Examples
    --------
    At alpha = 1/2 the relaxation is exp(x) erfc(sqrt(x)), x = t / tau.

    >>> solid = FractionalZener(0.0, 1.0, 1.0, 0.5, shortest=1e-3, longest=1e3, tolerance=1e-6)
    >>> round(float(solid.relaxation(1.0)), 5)  # e erfc(1)
    0.42758
    """

    __words__ = PowerLawSolid.__words__

    relaxed_shear: NonNegative
    shear: Positive
    relaxation_time: Positive
    exponent: FractionalExponent
    shortest: Positive
    longest: Positive
    tolerance: Annotated[float, between(1e-10, 0.1)] = 1e-4
    poisson: PoissonRatio = 0.5

    def _density(self, y: Array) -> Array:
        alpha = self.exponent
        power = alpha * np.abs(np.asarray(y) + math.log(self.relaxation_time))
        small = np.exp(-power)
        turn = math.pi * alpha
        return np.asarray(
            self.shear / math.pi * math.sin(turn) * small / (1.0 + 2.0 * math.cos(turn) * small + small**2)
        )

    def _itself(self, t: Array) -> Array:
        y = np.arange(-math.log(self.longest) - SLOW_MARGIN, -math.log(self.shortest) + FAST_MARGIN, REFERENCE_SPACING)
        slow = self._slower(y[0], REFERENCE_SPACING)
        terms = np.exp(-np.exp(y) * t[:, None])
        return np.asarray(self.relaxed_shear + slow + REFERENCE_SPACING * terms @ self._density(y))

    @property
    def _fitted(self) -> tuple[RelaxationSeries, float]:
        return self._summed(self.relaxed_shear)
