"""The result of a calibration: the indenter, and the readings from which it was made."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.fitting.nanoindentation.indenter import CalibratedIndenter
from winkler.fitting.nanoindentation.notes import calibration_notes
from winkler.fitting.nanoindentation.readings import area_of
from winkler.numerics.types import Array
from winkler.values.validity import Note
from winkler.values.value import value, words


@value
class IndenterCalibration:
    """A calibrated indenter with the evaluated reference indentations.

    Parameters
    ----------
    indenter : CalibratedIndenter
        Area function, frame compliance and their covariance.
    force, contact_depth, measured_area : ndarray, (n,)
        Force [N], contact depth [m] and area computed from the stiffness [m^2] of every unloading.
    residuals : ndarray, (n,)
        ln of the measured compliance of the contact over that of the fit.
    curve_names : tuple of str
        Name of the curve of every unloading.
    factor : float
        Variance of the residuals over that expected from noise, zero point and drift. If it exceeds 1, errors are
        increased accordingly.
    references : tuple
        The reference samples.
    skipped : tuple of str
        Curves that were not evaluated, with the reason.
    left_out : tuple of str
        Curves that were evaluated but not used, with the reason: copies and outliers.
    """

    __words__ = words(
        indenter=("", None, "area function, frame compliance and their covariance"),
        measured_area=("A", "m^2", "area that the stiffness demands"),
        residuals=("r", "", "ln of the measured compliance of the contact over the fitted one"),
        curve_names=("", None, "curve of every unloading"),
        factor=(r"\chi^2", "", "squared scatter over that of noise, zero point and drift"),
        references=("", None, "reference samples"),
        skipped=("", None, "curves that were not evaluated"),
        left_out=("", None, "curves that were evaluated and do not count"),
    )

    indenter: CalibratedIndenter
    force: Array
    contact_depth: Array
    measured_area: Array
    residuals: Array
    curve_names: tuple[str, ...]
    factor: float
    references: tuple[Any, ...]
    skipped: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()

    @property
    def frame_compliance(self) -> float:
        """C_f [m/N]."""
        return self.indenter.frame_compliance

    @property
    def frame_compliance_error(self) -> float:
        """Standard uncertainty of the frame compliance [m/N]."""
        return float(np.sqrt(self.indenter.covariance[0, 0]))

    @property
    def correlation(self) -> float:
        """Correlation of the errors of the frame compliance and of the area at the maximum contact depth [-].

        It is nan where the frame compliance was given.
        """
        powers = self._powers(np.array([self.contact_depth.max()]))[0]
        covariance = self.indenter.covariance
        area, frame = float(powers @ covariance[1:, 1:] @ powers), float(covariance[0, 0])
        if not (area > 0.0 and frame > 0.0):
            return math.nan
        return float(covariance[0, 1:] @ powers) / math.sqrt(area * frame)

    @property
    def validity(self) -> tuple[Note, ...]:
        """Whether the reference samples determine frame compliance and area function, and how well the latter fits."""
        return calibration_notes(self)

    def area_error(self, contact_depth: Array) -> Array:
        """Return the standard uncertainty of A [m^2] at contact depths [m]."""
        rows = self._powers(np.asarray(contact_depth, dtype=float))
        own = self.indenter.covariance[1:, 1:]
        return np.asarray(np.sqrt(np.maximum(np.einsum("...i,ij,...j->...", rows, own, rows), 0.0)))

    def _powers(self, height: Array) -> Array:
        """Return the areas of coefficients of one, (..., coefficients)."""
        count = len(self.indenter.area.coefficients)
        return np.stack([area_of(np.eye(count)[place], height) for place in range(count)], axis=-1)
