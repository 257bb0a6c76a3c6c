r"""The solid of a master curve at its reference temperature, and at others by the law of its shifts.

Laws of temperature fitted to measured shifts, and which of them the shifts determine.

Arrhenius' law is the law of Williams, Landel and Ferry with the second constant :math:`c_2=T_0`,

.. math:: \ln a_T = \frac{Q}{R}\Bigl(\frac1T-\frac1{T_0}\Bigr) = -\frac{Q}{R\,T_0}\,\frac{T-T_0}{T_0+(T-T_0)} ,

so that the interval of :math:`c_2` tells one from the other.
"""

from __future__ import annotations

import enum
import functools
import math
from typing import NamedTuple

import numpy as np

from winkler.materials.at_temperature import AtTemperature
from winkler.materials.temperature import GAS_CONSTANT, Arrhenius, WilliamsLandelFerry
from winkler.numerics.types import Array
from winkler.problems.master_curves.spectrum_solid import SpectrumSolid
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import words


class ShiftedSolid(SpectrumSolid):
    """What follows from a spectrum and shifts; its fields are those of `MasterCurveSolution`."""

    __words__ = words(
        laws=("", None, "both laws of temperature, fitted to the shifts"),
        law=("", None, "the law of temperature that is used"),
        verdict=("", None, "law that the shifts determine"),
        first_constant=("c_1", "", "first constant of Williams, Landel and Ferry"),
        second_constant=("c_2", "K", "second constant of Williams, Landel and Ferry"),
        activation_energy=("Q", "J/mol", "activation energy of Arrhenius' law"),
    )

    temperature: Array
    shift_factor: Array
    shift_error: Array
    freedom: float

    @functools.cached_property
    def laws(self) -> FittedLaws:
        """Both laws of temperature with their intervals, and which of them the shifts determine."""
        others = self.shift_error > 0.0
        reference = float(self.temperature[~others][0])
        return fitted_laws(
            self.temperature[others],
            np.log(self.shift_factor[others]),
            self.covariances.shift[np.ix_(others, others)],
            reference,
            freedom=self.freedom,
        )

    @property
    def first_constant(self) -> float:
        """c_1 [-] of Williams, Landel and Ferry."""
        return self.laws.ferry.first_constant

    @property
    def second_constant(self) -> float:
        """c_2 [K] of Williams, Landel and Ferry."""
        return self.laws.ferry.second_constant

    @property
    def activation_energy(self) -> float:
        """Q [J/mol] of Arrhenius' law."""
        return self.laws.arrhenius.activation_energy

    @property
    def verdict(self) -> str:
        """The law that the shifts determine: "Williams, Landel and Ferry", "Arrhenius", "cannot tell" or "neither"."""
        return self.laws.verdict.value

    @property
    def law(self) -> WilliamsLandelFerry | Arrhenius:
        """The law of the verdict; that of Williams, Landel and Ferry, which contains the other, where neither "
        "is excluded.

        Raises
        ------
        OutsideValidity
            If neither law describes the shifts.
        """
        laws = self.laws
        if laws.verdict is ShiftVerdict.NEITHER:
            raise OutsideValidity(
                "MasterCurve: neither law describes the shifts within their errors; use solid.slowed(factor) with a "
                "measured shift_factor."
            )
        return laws.arrhenius if laws.verdict is ShiftVerdict.ARRHENIUS else laws.ferry

    def solid_at(self, temperature: float) -> AtTemperature:
        """Return the solid at any temperature by the law of the verdict, for `ViscoelasticHalfSpace`.

        Parameters
        ----------
        temperature : float
            T [K], positive.

        Raises
        ------
        OutsideValidity
            If neither law describes the shifts, or the law has no value at this temperature.
        """
        return AtTemperature(self.solid, self.law, temperature)

    @property
    def _law_note(self) -> Note:
        """Which law the shifts determine, with the intervals of its constants."""
        laws = self.laws
        first, second, energy = laws.first_interval, laws.second_interval, laws.energy_interval
        constants = (
            f"c1 = {laws.ferry.first_constant:.4g} ({first[0]:.4g} to {first[1]:.4g}), c2 = "
            f"{laws.ferry.second_constant:.4g} K ({second[0]:.4g} to {second[1]:.4g} K), or an activation energy of "
            f"{laws.arrhenius.activation_energy / 1e3:.4g} kJ/mol "
            f"({energy[0] / 1e3:.4g} to {energy[1] / 1e3:.4g} kJ/mol)"
        )
        count = self.temperature.size - 1
        misfit = f"squares {laws.ferry_misfit:.3g} and {laws.arrhenius_misfit:.3g} of {count} shifts"
        says = {
            ShiftVerdict.FERRY: "The shifts are those of Williams, Landel and Ferry, and exclude Arrhenius' law",
            ShiftVerdict.ARRHENIUS: "The shifts are those of Arrhenius, and exclude the constants of polymers",
            ShiftVerdict.UNDECIDED: "The shifts cannot tell Williams, Landel and Ferry from Arrhenius",
            ShiftVerdict.NEITHER: "Neither law describes the shifts within their errors",
        }[laws.verdict]
        standing = Standing.APPROXIMATE if laws.verdict is ShiftVerdict.NEITHER else Standing.ASYMPTOTIC
        return Note(Assumption.RESPONSE, standing, f"{says}: {constants}; {misfit}.", "95 % profile likelihood")


TRIALS = 401
WIDER = 4.0
"""Part of the profile that is computed finely, in units of the limit of the interval."""
NEAREST, FARTHEST = 1e-3, 30.0
"""Distances of the temperature of divergence from the lowest one, relative to the reference temperature."""
SURE = 6.635
"""Misfit by which a law is excluded: 99 % of chi-square with one degree of freedom."""
UNLIKELY = 1e-3
"""Probability of the misfit below which neither law holds."""
POLYMER_SHARE = 0.5
"""Second constants of polymers are below this part of the reference temperature: 30 to 150 K."""


class ShiftVerdict(enum.Enum):
    """Which law the shifts determine."""

    FERRY = "Williams, Landel and Ferry"
    ARRHENIUS = "Arrhenius"
    UNDECIDED = "cannot tell"
    NEITHER = "neither"


class FittedLaws(NamedTuple):
    """Both laws, with the ends of the intervals of their constants.

    Parameters
    ----------
    ferry, arrhenius
        The laws of greatest likelihood.
    first_interval, second_interval, energy_interval : tuple of float
        Of c_1 [-], c_2 [K] (profile likelihood; infinite where the shifts do not bound them) and Q [J/mol].
    ferry_misfit, arrhenius_misfit : float
        Weighted squares of what they leave of the shifts [-].
    verdict : ShiftVerdict
    """

    ferry: WilliamsLandelFerry
    arrhenius: Arrhenius
    first_interval: tuple[float, float]
    second_interval: tuple[float, float]
    energy_interval: tuple[float, float]
    ferry_misfit: float
    arrhenius_misfit: float
    verdict: ShiftVerdict


def fitted_laws(
    temperature: Array, shift: Array, covariance: Array, reference: float, *, freedom: float, confidence: float = 0.95
) -> FittedLaws:
    """Return the laws fitted to logarithms of shifts by generalised least squares.

    Parameters
    ----------
    temperature : ndarray, (m,)
        T [K], without the reference temperature.
    shift : ndarray, (m,)
        ln a_T [-].
    covariance : ndarray, (m, m)
        Of the shifts.
    reference : float
        T_0 [K].
    freedom : float
        Degrees of freedom with which the covariance is known.
    confidence : float, optional
        Of the intervals.
    """
    from scipy.stats import chi2, t

    root = np.linalg.cholesky(covariance)
    target = np.linalg.solve(root, shift)
    above = temperature - reference
    limit = float(t.ppf(0.5 + 0.5 * confidence, freedom)) ** 2

    def line(column: Array) -> tuple[float, float, float]:
        """Return the factor of one column, its curvature, and the misfit."""
        white = np.linalg.solve(root, column)
        curvature = float(white @ white)
        factor = float(white @ target) / curvature
        return factor, curvature, float(np.sum((target - factor * white) ** 2))

    slope, energy_curvature, arrhenius_misfit = line(1.0 / temperature - 1.0 / reference)
    slope = max(slope, np.finfo(float).tiny)
    energy_width = math.sqrt(limit / energy_curvature)
    energies = tuple(GAS_CONSTANT * max(slope + sign * energy_width, 0.0) for sign in (-1.0, 1.0))

    def profile(seconds: Array) -> tuple[Array, Array, Array]:
        lines = [line(-math.log(10.0) * above / (second + above)) for second in seconds.tolist()]
        factors, curvatures, misfits = np.array(lines).T
        return factors, curvatures, misfits

    lowest = max(0.0, -float(above.min()))
    seconds = lowest + reference * np.geomspace(NEAREST, FARTHEST, TRIALS)
    firsts, curvatures, misfits = profile(seconds)
    near = np.flatnonzero(misfits - misfits.min() <= WIDER * limit)
    fine = np.geomspace(seconds[max(near[0] - 1, 0)] - lowest, seconds[min(near[-1] + 1, TRIALS - 1)] - lowest, TRIALS)
    polymers = misfits[seconds <= POLYMER_SHARE * reference]
    seconds = lowest + fine
    firsts, curvatures, misfits = profile(seconds)
    best = int(np.argmin(np.where(firsts > 0.0, misfits, math.inf)))
    first, second, least = float(firsts[best]), float(seconds[best]), float(misfits[best])
    widths = np.sqrt(np.maximum(limit - (misfits - least), 0.0) / curvatures)
    inside = misfits - least <= limit
    bounded = not (inside[0] or inside[-1]) and inside.any()
    second_interval = _ends(np.log(seconds), misfits - least - limit) if bounded else (0.0, math.inf)
    if bounded:
        first_interval = float(np.min((firsts - widths)[inside])), float(np.max((firsts + widths)[inside]))
    else:
        low = float(np.min((firsts - widths)[inside], initial=first)) if inside.any() else 0.0
        first_interval, second_interval = (max(low, 0.0), math.inf), (_lower_end(seconds, inside), math.inf)
    verdict = _verdict(polymers, least, second, arrhenius_misfit, reference)
    if float(chi2.sf(least, max(temperature.size - 2, 1))) < UNLIKELY:
        verdict = ShiftVerdict.NEITHER
    return FittedLaws(
        WilliamsLandelFerry(reference, max(first, np.finfo(float).tiny), second),
        Arrhenius(reference, GAS_CONSTANT * slope),
        first_interval,
        second_interval,
        (energies[0], energies[1]),
        least,
        arrhenius_misfit,
        verdict,
    )


def _verdict(polymers: Array, least: float, second: float, arrhenius: float, reference: float) -> ShiftVerdict:
    if arrhenius - least > SURE:
        return ShiftVerdict.FERRY if second < reference else ShiftVerdict.NEITHER
    excluded = polymers.size == 0 or float(polymers.min()) - arrhenius > SURE
    return ShiftVerdict.ARRHENIUS if excluded else ShiftVerdict.UNDECIDED


def _ends(x: Array, excess: Array) -> tuple[float, float]:
    """Return where the misfit exceeds the limit on either side of its least value, of logarithms."""
    inside = np.flatnonzero(excess <= 0.0)
    low, high = int(inside[0]), int(inside[-1])
    start = x[low - 1] + (x[low] - x[low - 1]) * excess[low - 1] / (excess[low - 1] - excess[low])
    end = x[high] + (x[high + 1] - x[high]) * excess[high] / (excess[high] - excess[high + 1])
    return float(np.exp(start)), float(np.exp(end))


def _lower_end(seconds: Array, inside: Array) -> float:
    places = np.flatnonzero(inside)
    return float(seconds[places[0]]) if places.size and places[0] > 0 else 0.0
