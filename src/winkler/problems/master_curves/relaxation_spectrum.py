r"""Relaxation spectrum of one measurement: moduli at many times, with errors, by regularised least squares.

The moduli are positive, and their logarithms change smoothly from one relaxation time to the next; the weight of
smoothness and the scatter are those of the greatest evidence (`winkler.numerics.springs.relaxation_spectrum`), not
those of the eye.
"""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.materials.relaxation_data import DynamicData, RelaxationData
from winkler.numerics.springs.relaxation_spectrum import estimate_spectrum
from winkler.numerics.springs.spectrum_response import Measurements, Response
from winkler.numerics.types import Array
from winkler.problems.master_curves.master_curve_notes import determined_note
from winkler.problems.master_curves.spectrum_solid import Covariances, SpectrumSolid
from winkler.problems.master_curves.temperature_groups import spread_times
from winkler.values.checks.number_checks import Whole
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words


@value
class RelaxationSpectrum:
    """A measured relaxation modulus, or storage and loss moduli, for computing the spectrum of relaxation times.

    Parameters
    ----------
    data : RelaxationData or DynamicData
        The measurement.
    fluid : bool, optional
        Whether the modulus tends to zero at long times.
    per_decade : int, optional
        Relaxation times in each decade, 2 to 12.

    Raises
    ------
    InvalidInput
        If a number is outside its range.

    References
    ----------
    J. Honerkamp, J. Weese, Rheol. Acta 32 (1993) 65-73, doi:10.1007/BF00396678
    D. J. C. MacKay, Neural Comput. 4 (1992) 415-447, doi:10.1162/neco.1992.4.3.415

    Examples
    --------
    >>> omega = np.geomspace(0.01, 100.0, 31)
    >>> turns = (1j * omega) ** 0.5
    >>> modulus = 1e6 + 1e7 * turns / (1.0 + turns)
    >>> found = RelaxationSpectrum(DynamicData(omega, modulus.real, modulus.imag)).solve()
    >>> bool(abs(found.solid.storage(1.0) / modulus[15].real - 1.0) < 1e-3)
    True
    """

    __words__ = words(
        data=("", None, "a measured relaxation, or storage and loss"),
        fluid=("", None, "whether nothing remains of the modulus at last"),
        measured=("", None, "measured moduli with their kind"),
        per_decade=("", "", "relaxation times in each decade"),
    )

    data: RelaxationData | DynamicData
    fluid: bool = False
    per_decade: Annotated[int, Whole(2, 12)] = 4

    references: ClassVar[tuple[str, ...]] = ("honerkamp_weese_1993", "mackay_1992")
    assumptions: ClassVar[frozenset[Assumption]] = frozenset((Assumption.KNOWN_TIMES,))

    @property
    def poisson(self) -> float:
        """Poisson's ratio nu [-], the same at all times."""
        return self.data.poisson

    @property
    def measured(self) -> tuple[Measurements, ...]:
        """The measurements."""
        data = self.data
        if isinstance(data, RelaxationData):
            return (Measurements(Response.RELAXATION, data.time, np.zeros(data.time.size, int), data.shear),)
        one = np.zeros(data.angular_frequency.size, int)
        return (
            Measurements(Response.STORAGE, data.angular_frequency, one, data.storage_shear),
            Measurements(Response.LOSS, data.angular_frequency, one, data.loss_shear),
        )

    def solve(self) -> SpectrumSolution:
        """Return the spectrum.

        Returns
        -------
        SpectrumSolution

        Raises
        ------
        NotConverged
            If the iteration does not converge.
        """
        measured, unshifted = self.measured, np.zeros(1)
        times = spread_times(measured, unshifted, self.per_decade)
        found = estimate_spectrum(measured, times, unshifted, reference=0, relaxes=not self.fluid)
        ends = times.size + 1
        return SpectrumSolution(
            self,
            times,
            np.exp(found.strengths),
            0.0 if self.fluid else math.exp(found.level),
            Covariances(found.covariance[:ends, :ends], np.zeros((1, 1))),
            found.scatter,
            found.freedom,
            np.concatenate(found.residuals),
        )


@value
class SpectrumSolution(SpectrumSolid):
    """The solution of a `RelaxationSpectrum`.

    Parameters
    ----------
    problem : RelaxationSpectrum
        The problem that was solved.
    relaxation_times, shears : ndarray, (k,)
        tau_i [s] and G_i [Pa].
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
    """

    __words__ = words(
        scatter=("", "", "relative scatter of each kind of modulus"),
        covariances=("", None, "covariances of the logarithms of moduli and shifts"),
        freedom=("", "", "number of measurements less that of the numbers they determine"),
        residuals=("", "", "logarithms of measured over fitted moduli"),
    )

    problem: RelaxationSpectrum
    relaxation_times: Array
    shears: Array
    relaxed_shear: float
    covariances: Covariances
    scatter: Array
    freedom: float
    residuals: Array

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        return (determined_note(self.determined),)
