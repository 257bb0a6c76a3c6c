"""The solid of a master curve at its reference temperature, and at others by the law of its shifts."""

from __future__ import annotations

import functools

import numpy as np

from winkler.materials.at_temperature import AtTemperature
from winkler.materials.temperature import Arrhenius, WilliamsLandelFerry
from winkler.numerics.types import Array
from winkler.problems.master_curves.shift_laws import FittedLaws, ShiftVerdict, fitted_laws
from winkler.problems.master_curves.spectrum_solid import SpectrumSolid
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import words

__all__ = ["ShiftedSolid"]


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
