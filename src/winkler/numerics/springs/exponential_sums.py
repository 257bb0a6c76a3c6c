r"""Relaxation and creep as sums of exponentials, and the conversion of one into the other.

.. math:: M(t) = M_\infty + \eta\,\delta(t) + \sum_i M_i\,e^{-t/\tau_i} , \qquad
          C(t) = C_0 + \varphi\,t + \sum_k C_k\,(1-e^{-t/\lambda_k}) .

Both describe the same solid when :math:`\tilde M(s)\tilde C(s)=1` with :math:`\tilde M(s)=s\int M e^{-st}\mathrm dt`.
The zeros of one are the poles of the other; they lie on the negative axis and alternate, so each is found in its own
interval, and the conversion there and back is exact to rounding.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np

from winkler.numerics.types import Array, ComplexArray
from winkler.values.value import value


@value
class RelaxationSeries:
    """M(t), the response to a step of strain.

    Parameters
    ----------
    relaxed : float
        What is left after all time [Pa], zero for a fluid.
    viscosity : float
        Of a dashpot alongside [Pa s].
    moduli : ndarray, (m,)
        [Pa], positive.
    times : ndarray, (m,)
        [s], positive and ascending, no two alike.
    """

    relaxed: float
    viscosity: float
    moduli: Array
    times: Array

    @property
    def glassy(self) -> float:
        """The immediate modulus [Pa]; infinite with a dashpot alongside."""
        return float(np.inf) if self.viscosity > 0.0 else float(self.relaxed + np.sum(self.moduli))

    def at(self, time: Array) -> Array:
        """Return M(t) [Pa] for t > 0."""
        t = np.asarray(time, dtype=float)
        return np.asarray(self.relaxed + np.exp(-t[..., None] / self.times) @ self.moduli)

    def dynamic(self, frequency: Array) -> ComplexArray:
        """Return the complex modulus [Pa] at angular frequencies [rad/s]."""
        return self.at_rate(1j * np.asarray(frequency, dtype=float))

    def at_rate(self, s: ComplexArray) -> ComplexArray:
        """Return s times Laplace's transform [Pa] at s [1/s], finite."""
        turns = s[..., None] * self.times
        return np.asarray(self.relaxed + s * self.viscosity + (turns / (1.0 + turns)) @ self.moduli)

    def scaled(self, modulus: float, time: float = 1.0) -> RelaxationSeries:
        """Return the series with all moduli and all times multiplied."""
        return RelaxationSeries(
            self.relaxed * modulus, self.viscosity * modulus * time, self.moduli * modulus, self.times * time
        )


@value
class CreepSeries:
    """C(t), the response to a step of stress.

    Parameters
    ----------
    glassy : float
        The immediate compliance [1/Pa].
    fluidity : float
        How fast it flows without end [1/(Pa s)].
    compliances : ndarray, (n,)
        [1/Pa], positive.
    times : ndarray, (n,)
        [s], positive and ascending, no two alike.
    """

    glassy: float
    fluidity: float
    compliances: Array
    times: Array

    def at(self, time: Array) -> Array:
        """Return C(t) [1/Pa] for t > 0."""
        t = np.asarray(time, dtype=float)
        return np.asarray(self.glassy + self.fluidity * t - np.expm1(-t[..., None] / self.times) @ self.compliances)

    def scaled(self, compliance: float) -> CreepSeries:
        """Return the series with all compliances multiplied."""
        return CreepSeries(
            self.glassy * compliance, self.fluidity * compliance, self.compliances * compliance, self.times
        )

    def plus(self, other: CreepSeries) -> CreepSeries:
        """Return the creep of two solids that bear the same load one behind the other."""
        strengths, times = merged(
            np.concatenate([self.compliances, other.compliances]), np.concatenate([self.times, other.times])
        )
        return CreepSeries(self.glassy + other.glassy, self.fluidity + other.fluidity, strengths, times)


def merged(strengths: Array, times: Array) -> tuple[Array, Array]:
    """Return strengths and ascending times; those of equal times added, those of no strength left out."""
    positive = np.asarray(strengths, dtype=float) > 0.0
    unique, index = np.unique(np.asarray(times, dtype=float)[positive], return_inverse=True)
    return np.bincount(index, weights=np.asarray(strengths, dtype=float)[positive], minlength=unique.size), unique


def _root(function: Callable[[float], float], low: float, high: float) -> float:
    """Return the zero of a function that falls from plus to minus infinity, or finite bounds of these signs."""
    from scipy.optimize import brentq

    left, right = low, float(np.nextafter(high, low))
    if low == 0.0:
        left = 1e-3 * right
        while function(left) <= 0.0:
            left *= 1e-3
    else:
        left = float(np.nextafter(low, high))
    # with a pole of hardly any strength the zero is nearer to it than two numbers are
    if function(left) <= 0.0:
        return left
    if function(right) >= 0.0:
        return right
    if right > 4.0 * left:

        def within(y: float) -> float:
            return float(min(max(np.exp(y), left), right))

        ends = np.log(left), np.log(right)
        if not function(within(ends[0])) > 0.0 > function(within(ends[1])):  # nearer to a pole than logarithms resolve
            return float(brentq(function, left, right, xtol=1e-300, rtol=8.9e-16, maxiter=5000))
        guess = within(brentq(lambda y: function(within(y)), *ends, xtol=1e-15, rtol=8.9e-16))
        near = max(left, guess * (1.0 - 1e-12)), min(right, guess * (1.0 + 1e-12))
        if not function(near[0]) > 0.0 > function(near[1]):
            return guess
        left, right = near
    return float(brentq(function, left, right, xtol=1e-300, rtol=8.9e-16, maxiter=500))


def _roots(falling: Callable[[float], float], poles: Array, below: bool, reach: float) -> list[float]:
    """Return the zeros between poles, `below` the first one, and beyond the last if the function falls over a reach."""
    ends = [0.0] * below + poles.tolist()
    rates = [_root(falling, low, high) for low, high in pairwise(ends)]
    if reach > 0.0:
        last = float(poles[-1]) if poles.size else 0.0
        bound = last + 1.0001 * reach
        while falling(bound) >= 0.0:
            bound *= 2.0
        rates.append(_root(falling, last, bound))
    return rates


def zeros(series: RelaxationSeries) -> tuple[Array, Array]:
    """Return the rates at which a solid left alone recovers.

    Parameters
    ----------
    series : RelaxationSeries

    Returns
    -------
    rates : ndarray, (k,)
        1/lambda [1/s] ascending, the first one zero for a fluid; one for each relaxation time, one more with a
        dashpot.
    residues : ndarray, (k,)
        Of 1/M(s) there, C_k / lambda_k [1/(Pa s)].
    """
    poles = 1.0 / series.times[::-1]
    moduli = series.moduli[::-1]

    def falling(rate: float) -> float:
        with np.errstate(divide="ignore"):
            return float(series.relaxed - series.viscosity * rate + np.sum(moduli * (rate / (rate - poles))))

    beyond = series.viscosity > 0.0 and (poles.size or series.relaxed > 0.0)
    reach = (series.relaxed + float(np.sum(moduli))) / series.viscosity if beyond else 0.0
    at_rest = [0.0] * (series.relaxed == 0.0 and (poles.size > 0 or series.viscosity > 0.0))
    roots = np.array(at_rest + _roots(falling, poles, series.relaxed > 0.0, reach))
    slopes = series.viscosity + np.sum(moduli * poles / (roots[:, None] - poles) ** 2, axis=1)
    return roots, 1.0 / slopes


def of_relaxation(series: RelaxationSeries) -> CreepSeries:
    """Return the creep of a solid whose relaxation is known.

    Examples
    --------
    >>> maxwell = RelaxationSeries(0.0, 0.0, np.array([2.0]), np.array([3.0]))
    >>> of_relaxation(maxwell).at(np.array([0.0, 6.0]))  # (1 + t / tau) / M
    array([0.5, 1.5])
    """
    rates, residues = zeros(series)
    flowing = rates == 0.0
    rest = ~flowing
    compliances = (residues[rest] / rates[rest])[::-1]
    glassy = 0.0 if series.viscosity > 0.0 else 1.0 / series.glassy
    return CreepSeries(glassy, float(np.sum(residues[flowing])), compliances, (1.0 / rates[rest])[::-1])


def of_creep(series: CreepSeries) -> RelaxationSeries:
    """Return the relaxation of a solid whose creep is known.

    Examples
    --------
    >>> maxwell = CreepSeries(0.5, 1.0 / 6.0, np.empty(0), np.empty(0))
    >>> of_creep(maxwell).at(np.array([0.0]))
    array([2.])
    """
    poles = 1.0 / series.times[::-1]
    strengths = series.compliances[::-1] * poles

    def falling(rate: float) -> float:
        with np.errstate(divide="ignore"):
            flow = series.fluidity / rate if series.fluidity > 0.0 else 0.0
            return -float(series.glassy - flow + np.sum(strengths / (poles - rate)))

    beyond = series.glassy > 0.0 and (poles.size or series.fluidity > 0.0)
    reach = (series.fluidity + float(np.sum(strengths))) / series.glassy if beyond else 0.0
    roots = np.array(_roots(falling, poles, series.fluidity > 0.0, reach))
    slopes = np.sum(strengths / (poles - roots[:, None]) ** 2, axis=1) if roots.size else roots
    slopes = slopes + (series.fluidity / roots**2 if series.fluidity > 0.0 else 0.0)
    whole = series.glassy + float(np.sum(series.compliances))
    relaxed = 0.0 if series.fluidity > 0.0 else 1.0 / whole
    viscosity = 1.0 / (series.fluidity + float(np.sum(strengths))) if series.glassy == 0.0 else 0.0
    return RelaxationSeries(relaxed, viscosity, (1.0 / (roots * slopes))[::-1], (1.0 / roots)[::-1])
