"""The result of a fit of several curves with shared numbers."""

from __future__ import annotations

import math

import numpy as np

from winkler.fitting.curves.checks import Flag
from winkler.fitting.outcome import AnyFit
from winkler.fitting.several.population import quantile
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, suggest
from winkler.values.value import value, words


@value
class JointFit:
    """A fit of several curves with common parameters.

    Parameters
    ----------
    names : tuple of str, (q,)
        Shared numbers.
    values : ndarray, (q,)
        In SI units.
    standard_errors : ndarray, (q,)
    correlation : ndarray, (q, q)
        Of their errors.
    logarithmic : tuple of bool, (q,)
        Whether the logarithm of the parameter was varied.
    fits : tuple of Fit or ViscoelasticFit, (k,)
        The fit of each curve with the shared and its own parameters, and the errors of the joint fit.
    freedom : float
        Number of independent points of all curves minus the number of parameters.
    shares : ndarray, (k, q)
        Fraction of the information on each shared parameter that comes from each curve; the sum over the curves is 1.
    single_values, single_errors : ndarray, (k, q)
        Values from each curve alone, from the same linear equations; nan if the curve does not determine them.
    chances : ndarray, (k,)
        Probability that a curve with the same shared parameters would differ more from the others by chance.
    flags : tuple of Flag
        Doubts about the shared numbers.
    """

    __words__ = words(
        names=("", None, "shared numbers"),
        values=("", None, "the shared numbers, in SI units"),
        standard_errors=("", None, "their standard errors"),
        correlation=("", "", "correlation of their errors"),
        logarithmic=("", None, "of which numbers the logarithm was varied"),
        fits=("", None, "each curve with the shared and its own numbers"),
        freedom=("", "", "degrees of freedom of the errors"),
        shares=("", "", "part of the information that comes from each curve"),
        single_values=("", None, "what each curve alone says"),
        single_errors=("", None, "the errors of these"),
        chances=("", "", "how often a curve would differ more from the others"),
        flags=("", None, "what speaks against the shared numbers"),
    )

    names: tuple[str, ...]
    values: Array
    standard_errors: Array
    correlation: Array
    logarithmic: tuple[bool, ...]
    fits: tuple[AnyFit, ...]
    freedom: float
    shares: Array
    single_values: Array
    single_errors: Array
    chances: Array
    flags: tuple[Flag, ...]

    def index(self, name: str) -> int:
        """Return the index of a shared number.

        Raises
        ------
        InvalidInput
            If the parameter is not shared.
        """
        if name not in self.names:
            raise InvalidInput(f"fit: '{name}' is not shared{suggest(name, self.names)}; {', '.join(self.names)} are.")
        return self.names.index(name)

    def value(self, name: str) -> float:
        """Return a shared number."""
        return float(self.values[self.index(name)])

    def error(self, name: str) -> float:
        """Return the standard error of a shared number."""
        return float(self.standard_errors[self.index(name)])

    def interval(self, name: str, confidence: float = 0.95) -> tuple[float, float]:
        """Return the interval of a shared number, of positive quantities on the logarithm.

        Parameters
        ----------
        name : str
        confidence : float
            Between 0 and 1.
        """
        index = self.index(name)
        number, width = self.value(name), quantile(self.freedom, confidence) * self.error(name)
        if not self.logarithmic[index]:
            return number - width, number + width
        part = width / number
        high = number * math.exp(part) if part + math.log(number) < math.log(np.finfo(float).max) else math.inf
        return number * math.exp(-part), high
