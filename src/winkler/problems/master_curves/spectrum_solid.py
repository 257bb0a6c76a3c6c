"""A fitted relaxation spectrum: the solid, the errors of its moduli, and the times at which it is determined."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from winkler.materials.viscoelastic import Prony
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.master_curves.temperature_groups import longest_run
from winkler.values.checks.number_checks import POSITIVE, Numbers, checked
from winkler.values.value import words

DETERMINED = math.log(2.0)
"""Standard error of the logarithm of a modulus up to which it is determined."""
NEGLIGIBLE = 1e-9
"""Part of all moduli below which a term is left out of the solid."""
TIMES = Numbers(POSITIVE, any_shape=True)


class Covariances(NamedTuple):
    """Covariances of logarithms: of the moduli G_i and G_inf ``(k + 1, k + 1)``, and of the shifts ``(m, m)``."""

    spectrum: Array
    shift: Array


class ModulusBand(NamedTuple):
    """A relaxation modulus, and the ends of its interval [Pa], each ``(m,)``."""

    modulus: Array
    low: Array
    high: Array


class SpectrumSolid:
    """What follows from a spectrum; its fields are those of the solutions."""

    __words__ = words(
        determined=("", "s", "shortest and longest relaxation time between which the spectrum is determined"),
        solid=("", None, "the solid with this spectrum"),
        shears_error=("", "", "standard error of the natural logarithm of each modulus"),
        relaxed_shear_error=("", "", "standard error of the natural logarithm of the relaxed modulus"),
    )

    problem: Any
    relaxation_times: Array
    shears: Array
    relaxed_shear: float
    covariances: Covariances
    freedom: float

    @property
    def shears_error(self) -> Array:
        """Standard errors of the logarithms of the moduli [-] ``(k,)``."""
        return np.asarray(np.sqrt(np.maximum(np.diag(self.covariances.spectrum)[:-1], 0.0)))

    @property
    def relaxed_shear_error(self) -> float:
        """Standard error of the logarithm of the relaxed modulus [-]; zero where it is none."""
        return math.sqrt(max(float(self.covariances.spectrum[-1, -1]), 0.0))

    @property
    def solid(self) -> Prony:
        """The solid at the reference temperature."""
        kept = self.shears > NEGLIGIBLE * (self.relaxed_shear + float(np.sum(self.shears)))
        return Prony(self.relaxed_shear, self.shears[kept], self.relaxation_times[kept], poisson=self.problem.poisson)

    @property
    def determined(self) -> tuple[float, float]:
        """Shortest and longest relaxation time [s] between which the spectrum is known to a factor of two."""
        return longest_run(self.relaxation_times, self.shears_error < DETERMINED)

    def relaxation_interval(self, time: ArrayLike, confidence: float = 0.95) -> ModulusBand:
        """Return G(t) with its interval: determined where single moduli are not, since neighbours share it.

        Parameters
        ----------
        time : array_like, (m,)
            Since a step of strain [s], positive.
        confidence : float, optional
            Between 0 and 1.

        Returns
        -------
        ModulusBand
            Modulus, low and high [Pa].

        Raises
        ------
        InvalidInput
            If a time is not positive.
        """
        from scipy.stats import t as student

        at = np.atleast_1d(checked(TIMES, "relaxation_interval", "time", time, "s"))
        parts = np.exp(-at[:, None] / self.relaxation_times) * self.shears
        modulus = parts.sum(axis=1) + self.relaxed_shear
        slopes = np.column_stack([parts, np.full(at.size, self.relaxed_shear)]) / modulus[:, None]
        variance = np.einsum("ti,ij,tj->t", slopes, self.covariances.spectrum, slopes)
        width = float(student.ppf(0.5 + 0.5 * confidence, self.freedom)) * np.sqrt(np.maximum(variance, 0.0))
        return ModulusBand(modulus, modulus * np.exp(-width), modulus * np.exp(width))
