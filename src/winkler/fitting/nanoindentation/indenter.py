"""A calibrated indenter on its frame: area function, frame compliance, their covariance, and the solid of the tip."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.fitting.unloading.contact_reading import CalibratedArea
from winkler.materials.elastic import Elastic
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import NonNegative, Positive
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

DIAMOND = Elastic(young=1141e9, poisson=0.07)
"""Diamond as in ISO 14577-1 (1140 GPa) and in the instruments' programs (1141 GPa)."""


@value
class CalibratedIndenter:
    """Area function and frame compliance with their covariance.

    Parameters
    ----------
    area : CalibratedArea
        A(h_c), with the contact depths of its calibration.
    frame_compliance : float, optional
        C_f [m/N] of the frame, added to that of the curve; zero by default.
    covariance : ndarray, (1 + n, 1 + n), optional
        Covariance of the frame compliance and the n coefficients of the area, in products of their units. If it is
        empty (default), the calibration does not contribute to the uncertainty.
    solid : Elastic, optional
        Of the tip; diamond, 1141 GPa and 0.07, by default.
    shape_factor : float, optional
        beta [-]; 1 by default.  Calibration and measurement must use the same factor.

    Raises
    ------
    InvalidInput
        If the covariance has another shape, is not symmetric, or has a negative variance.

    Examples
    --------
    >>> CalibratedIndenter(CalibratedArea([24.5, 1e-6])).solid.young
    1141000000000.0
    """

    __words__ = words(
        area=("A", None, "area function"),
        covariance=("V", None, "of frame compliance and area coefficients"),
        solid=("", None, "solid of the tip"),
        shape_factor=(r"\beta", "", "factor of the stiffness of a tip that is not round"),
    )

    area: CalibratedArea
    frame_compliance: NonNegative = 0.0
    covariance: Array = dataclasses.field(default_factory=lambda: np.zeros((0, 0)))
    solid: Elastic = DIAMOND
    shape_factor: Positive = 1.0

    def __post_init__(self) -> None:
        size = 1 + len(self.area.coefficients)
        matrix = np.asarray(self.covariance, dtype=float)
        if matrix.size and matrix.shape != (size, size):
            raise InvalidInput(
                f"CalibratedIndenter: the covariance has the shape {matrix.shape}; give {(size, size)}: of the frame "
                "compliance and each coefficient of the area."
            )
        spread = np.sqrt(np.maximum(np.diag(matrix), 0.0)) if matrix.size else np.zeros(0)
        scale = np.outer(spread, spread)
        if matrix.size and (
            not np.all(np.isfinite(matrix))
            or np.any(np.diag(matrix) < 0.0)
            or np.any(np.abs(matrix - matrix.T) > 1e-6 * scale)
        ):
            raise InvalidInput("CalibratedIndenter: the covariance is not symmetric with finite, positive variances.")

    @property
    def calibrated(self) -> bool:
        """Whether the covariance of the calibration is known."""
        return bool(np.asarray(self.covariance).size)

    @property
    def numbers(self) -> Array:
        """Frame compliance and coefficients of the area ``(1 + n,)``."""
        return np.array([self.frame_compliance, *self.area.coefficients])
