r"""Sweeps at several temperatures shifted into one master curve, with the errors of the shifts.

Temperature multiplies all times of a thermorheologically simple solid by one factor :math:`a_T`, and its moduli by
another, :math:`b_T`, which is often taken as one.  Spectrum, shifts, and scatter are found together, by the likelihood
of all measurements (`winkler.numerics.springs.relaxation_spectrum`), and the laws of temperature are fitted to the
shifts with their covariance (`winkler.problems.master_curves.shifted_solid`).
"""

from __future__ import annotations

import functools
import math
from enum import StrEnum
from typing import Annotated, ClassVar

import numpy as np

from winkler.materials.sweeps import DynamicSweeps, RelaxationSweeps
from winkler.numerics.springs.pairwise_shifts import pairwise_shifts
from winkler.numerics.springs.relaxation_spectrum import SpectrumEstimate, estimate_spectrum
from winkler.numerics.springs.shifts_apart import shifts_apart
from winkler.numerics.springs.spectrum_response import Measurements, Response
from winkler.numerics.types import Array
from winkler.problems.master_curves.master_curve_notes import contradiction_notes, master_curve_notes, shifted_by_note
from winkler.problems.master_curves.shifted_solid import ShiftedSolid
from winkler.problems.master_curves.spectrum_solid import Covariances
from winkler.problems.master_curves.temperature_groups import grouped, in_own_units, spread_times
from winkler.values.checks.number_checks import Positive, Whole
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

MOST_TEMPERATURES = 200
ROUNDS = 5
"""Times that the grid of relaxation times is laid anew."""
NEW_GRID = 0.5
"""Greatest change of a shift that needs no new grid [-]."""


class ShiftedBy(StrEnum):
    """The moduli that determine the shifts of a master curve."""

    BOTH = "both"
    """All that were measured."""
    STORAGE = "storage"
    """Storage alone: the loss takes its shifts."""
    LOSS = "loss"
    """Loss alone: the storage takes its shifts."""


@value
class MasterCurve:
    """Sweeps at several temperatures, for shifting them into one master curve.

    Parameters
    ----------
    sweeps : DynamicSweeps or RelaxationSweeps
        The measurements, isothermal or isochronal.
    reference_temperature : float
        T_0 [K] of the master curve; the nearest measured temperature, at most `temperature_step` away, is shifted by
        one.
    vertical : bool, optional
        Whether a factor b_T of the moduli is also fitted at each temperature.
    entropic : bool, optional
        Whether the moduli grow with the absolute temperature, b_T = T/T_0, as those of a rubber.
    fluid : bool, optional
        Whether the modulus tends to zero at long times.
    per_decade : int, optional
        Relaxation times in each decade, 2 to 12.
    temperature_step : float, optional
        Rows whose temperatures differ by less than this [K] belong to one temperature.
    by : ShiftedBy, optional
        Moduli that determine the shifts, for data in which storage and loss moduli contradict each other. The spectrum
        is fitted to both moduli with these shifts; its errors do not include those of the shifts.

    Raises
    ------
    InvalidInput
        If a number is outside its range, there is only one temperature, or none is the reference temperature. If both
        factors of the moduli are requested, or a relaxation is to be shifted by storage or loss.

    References
    ----------
    J. D. Ferry, Viscoelastic Properties of Polymers, 3rd edition, Wiley 1980
    M. L. Williams, R. F. Landel, J. D. Ferry, J. Am. Chem. Soc. 77 (1955) 3701-3707, doi:10.1021/ja01619a008
    J. Honerkamp, J. Weese, Rheol. Acta 32 (1993) 65-73, doi:10.1007/BF00396678

    Examples
    --------
    >>> omega, warmth = np.tile(np.geomspace(0.1, 10.0, 9), 3), np.repeat([290.0, 300.0, 310.0], 9)
    >>> turns = (1j * omega * 10.0 ** (-0.1 * (warmth - 300.0))) ** 0.5
    >>> modulus = 1e6 + 1e6 * turns / (1.0 + turns)
    >>> master = MasterCurve(DynamicSweeps(warmth, omega, modulus.real, modulus.imag), 300.0).solve()
    >>> bool(abs(np.log10(master.shift_factor[0]) - 1.0) < 0.01)
    True
    """

    __words__ = words(
        sweeps=("", None, "moduli over frequency or time at several temperatures"),
        vertical=("", None, "whether a factor of the moduli is sought at each temperature"),
        entropic=("", None, "whether the moduli grow with the absolute temperature"),
        fluid=("", None, "whether nothing remains of the modulus at last"),
        per_decade=("", "", "relaxation times in each decade"),
        measured=("", None, "measurements with the index of their temperature"),
        temperature_step=("", "K", "difference below which rows belong to one temperature"),
        by=("", None, "moduli from which the shifts follow: both, storage or loss"),
    )

    sweeps: DynamicSweeps | RelaxationSweeps
    reference_temperature: Positive
    vertical: bool = False
    entropic: bool = False
    fluid: bool = False
    per_decade: Annotated[int, Whole(2, 12)] = 4
    temperature_step: Positive = 1.0
    by: ShiftedBy = ShiftedBy.BOTH

    references: ClassVar[tuple[str, ...]] = (
        "williams_landel_ferry_1955", "honerkamp_weese_1993", "mackay_1992", "rao_1948",
    )  # fmt: skip
    assumptions: ClassVar[frozenset[Assumption]] = frozenset(
        (Assumption.RESPONSE, Assumption.KNOWN_TIMES, Assumption.CURVE)
    )

    def __post_init__(self) -> None:
        if self.vertical and self.entropic:
            raise InvalidInput("MasterCurve: vertical and entropic are both true; let one of them be false.")
        if self.by is not ShiftedBy.BOTH and isinstance(self.sweeps, RelaxationSweeps):
            raise InvalidInput(f"MasterCurve: by is '{self.by}', and the sweeps are relaxations; leave by out.")
        centres, _ = self._groups
        if centres.size < 2:
            raise InvalidInput(
                f"MasterCurve: all rows have temperatures within temperature_step = {self.temperature_step:g} "
                f"K; give two "
                "temperatures or more, or fit one sweep with DynamicData."
            )
        if centres.size > MOST_TEMPERATURES:
            raise InvalidInput(
                f"MasterCurve: the sweeps have {centres.size} temperatures, and at most {MOST_TEMPERATURES} are "
                f"shifted; "
                "give a greater temperature_step, so that neighbours count as one."
            )
        nearest = float(centres[self._reference])
        if abs(nearest - self.reference_temperature) > self.temperature_step:
            raise InvalidInput(
                f"MasterCurve: no row was measured at reference_temperature = {self.reference_temperature:g} K; "
                f"the nearest "
                f"temperature is {nearest:g} K, give that."
            )

    def solve(self) -> MasterCurveSolution:
        """Return shifts, spectrum, and laws.

        Returns
        -------
        MasterCurveSolution

        Raises
        ------
        NotConverged
            If the iteration does not converge.
        """
        centres, group = self._groups
        measured, abscissa, modulus = in_own_units(self.sweeps.measured(group))
        both = self.by is ShiftedBy.BOTH
        shifted = measured if both else tuple(one for one in measured if one.response.value == self.by)
        relaxes = not self.fluid and any(one.response is not Response.LOSS for one in shifted)
        shifts = pairwise_shifts(shifted, centres.size, self._reference)
        factors = np.log(centres / centres[self._reference]) if self.entropic else None
        for _ in range(ROUNDS):
            first = estimate_spectrum(
                shifted,
                spread_times(shifted, shifts, self.per_decade),
                shifts,
                reference=self._reference,
                free_factors=self.vertical,
                fixed_factors=factors,
                relaxes=relaxes,
            )
            moved = float(np.max(np.abs(first.shifts - shifts)))
            shifts = first.shifts
            if moved < NEW_GRID:
                break
        found = (
            first
            if both
            else estimate_spectrum(
                measured,
                spread_times(measured, shifts, self.per_decade),
                shifts,
                reference=self._reference,
                free_shifts=False,
                fixed_factors=first.factors,
                relaxes=not self.fluid,
            )
        )
        time = abscissa if isinstance(self.sweeps, RelaxationSweeps) else 1.0 / abscissa
        return self._solution(centres, first, found, measured, time, modulus)

    def _solution(
        self,
        centres: Array,
        first: SpectrumEstimate,
        found: SpectrumEstimate,
        measured: tuple[Measurements, ...],
        time: float,
        modulus: float,
    ) -> MasterCurveSolution:
        """Return the solution with the shifts of the first estimate and the spectrum of the other."""
        end, start, m = found.times.size + 1, first.times.size + 1, centres.size
        error = np.sqrt(np.maximum(np.diag(first.covariance), 0.0))
        compared = first is found and isinstance(self.sweeps, DynamicSweeps)
        none = np.zeros(0)
        apart, apart_error = shifts_apart(measured, found, self._reference) if compared else (none, none)
        return MasterCurveSolution(
            problem=self,
            temperature=centres,
            shift_factor=np.exp(first.shifts),
            shift_error=error[start : start + m],
            vertical_factor=np.exp(first.factors),
            vertical_error=error[start + m :],
            relaxation_times=time * found.times,
            shears=modulus * np.exp(found.strengths),
            relaxed_shear=modulus * math.exp(found.level) if not self.fluid else 0.0,
            covariances=Covariances(
                found.covariance[:end, :end], first.covariance[start : start + m, start : start + m]
            ),
            scatter=found.scatter,
            freedom=first.freedom,
            residuals=np.concatenate(found.residuals),
            loss_over_storage=np.exp(apart),
            loss_over_storage_error=apart_error,
        )

    @functools.cached_property
    def _groups(self) -> tuple[Array, Array]:
        """Mean of each temperature [K] ``(m,)``, and its index for each row ``(n,)``."""
        return grouped(np.asarray(self.sweeps.temperature), self.temperature_step)

    @property
    def measured(self) -> tuple[Measurements, ...]:
        """The measurements with the index of their temperature."""
        return self.sweeps.measured(self._groups[1])

    @property
    def poisson(self) -> float:
        """Poisson's ratio nu [-], the same at all times and temperatures."""
        return self.sweeps.poisson

    @property
    def _reference(self) -> int:
        return int(np.argmin(np.abs(self._groups[0] - self.reference_temperature)))


@value
class MasterCurveSolution(ShiftedSolid):
    """The solution of a `MasterCurve`; errors are standard errors of logarithms.

    Parameters
    ----------
    problem : MasterCurve
        The problem that was solved.
    temperature : ndarray, (m,)
        T [K], rising.
    shift_factor, shift_error : ndarray, (m,)
        a_T [-], and the standard error of its natural logarithm; zero at the reference temperature.
    vertical_factor, vertical_error : ndarray, (m,)
        b_T [-], and the standard error of its natural logarithm.
    relaxation_times, shears : ndarray, (k,)
        tau_i [s] and G_i [Pa] of the spectrum at the reference temperature.
    relaxed_shear : float
        G_inf [Pa].
    covariances : Covariances
        Covariances of the logarithms of moduli and shifts.
    scatter : ndarray, (kinds,)
        Relative scatter of G' and G'', or of G(t) [-].
    freedom : float
        Number of measurements minus number of fitted parameters.
    residuals : ndarray
        Logarithms of measured over fitted moduli, G' before G'' [-].
    loss_over_storage, loss_over_storage_error : ndarray, (m,) or (0,)
        Shift factor of the loss modulus over that of the storage modulus [-], and the standard error of its natural
        logarithm. It is computed by one Newton step from the common shifts; nan if a temperature does not determine it.
        Empty without common shifts of storage and loss.
    """

    __words__ = words(
        temperature=("T", "K", "temperature of each sweep"),
        shift_factor=("a_T", "", "by which temperature multiplies all times"),
        shift_error=("", "", "standard error of the natural logarithm of the shift factor"),
        vertical_factor=("b_T", "", "by which temperature multiplies all moduli"),
        vertical_error=("", "", "standard error of the natural logarithm of the vertical factor"),
        scatter=("", "", "relative scatter of each kind of modulus"),
        covariances=("", None, "covariances of the logarithms of moduli and shifts"),
        freedom=("", "", "number of measurements less that of the numbers they determine"),
        residuals=("", "", "logarithms of measured over fitted moduli"),
        loss_over_storage=("", "", "shift factor that the loss asks for over that of the storage"),
        loss_over_storage_error=("", "", "standard error of the natural logarithm of that ratio"),
    )

    problem: MasterCurve
    temperature: Array
    shift_factor: Array
    shift_error: Array
    vertical_factor: Array
    vertical_error: Array
    relaxation_times: Array
    shears: Array
    relaxed_shear: float
    covariances: Covariances
    scatter: Array
    freedom: float
    residuals: Array
    loss_over_storage: Array
    loss_over_storage_error: Array

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        shifts = np.log(self.shift_factor)
        notes = master_curve_notes(self.problem.measured, self.temperature, shifts, self.residuals, self.determined)
        if self.problem.by is not ShiftedBy.BOTH:
            return (self._law_note, shifted_by_note(str(self.problem.by), self.scatter), *notes)
        apart = contradiction_notes(self.temperature, np.log(self.loss_over_storage), self.loss_over_storage_error)
        return (self._law_note, *apart, *notes)
