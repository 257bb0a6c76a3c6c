r"""Force and travel of the tip from the readings of a machine.

A cantilever of the spring constant :math:`k_c` bends by the deflection :math:`\delta = sV`, with the sensitivity s of
its detector; the force is :math:`F = k_c\,\delta` and the tip travels :math:`D-\delta`.  On a rigid
sample :math:`\delta = D`, which calibrates s.  The frame of a nanoindenter is elastic, too.
"""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.numerics.types import Array, ArrayLike
from winkler.values.checks.number_checks import NON_NEGATIVE, POSITIVE, checked
from winkler.values.errors import InvalidInput

__all__ = ["deflection_sensitivity", "force_from_deflection", "on_frame", "tip_travel"]

FEWEST = 5


def force_from_deflection(deflection: ArrayLike, sensitivity: float, spring_constant: float) -> Array:
    """Return the force of a cantilever.

    Parameters
    ----------
    deflection : array_like
        Signal of the detector [V], rising when the tip is pushed away from the sample.
    sensitivity : float
        [m/V].
    spring_constant : float
        [N/m].

    Returns
    -------
    ndarray
        F_N [N].
    """
    checked(POSITIVE, "force_from_deflection", "sensitivity", sensitivity, "m/V")
    checked(POSITIVE, "force_from_deflection", "spring_constant", spring_constant, "N/m")
    return np.asarray(spring_constant * sensitivity * np.asarray(deflection, dtype=float))


def deflection_sensitivity(position: ArrayLike, deflection: ArrayLike) -> float:
    """Return the sensitivity of a detector from contact with a rigid sample.

    Parameters
    ----------
    position, deflection : array_like, (n,)
        Positions [m] and signals [V] in contact alone.

    Returns
    -------
    float
        [m/V], by least squares of the signal against the position.

    Raises
    ------
    InvalidInput
        If there are fewer than five points, or the signal does not rise with the position.
    """
    x, y = np.asarray(position, dtype=float), np.asarray(deflection, dtype=float)
    if x.shape != y.shape or x.ndim != 1 or x.size < FEWEST:
        raise InvalidInput(
            f"sensitivity: positions have the shape {x.shape}, signals {y.shape}; give at least {FEWEST} of each."
        )
    centred = x - x.mean()
    slope = float(centred @ y) / max(float(centred @ centred), 1e-300)
    if not slope > 0.0:
        raise InvalidInput(f"reversed: the signal changes by {slope:.3g} V/m; in contact it must rise: change a sign.")
    return 1.0 / slope


def tip_travel(curve: ForceCurve) -> ForceCurve:
    """Return the curve over the travel of the tip, the deflection of the machine subtracted.

    The noise of the force then enters the position, too: the curve as measured is better for fits.
    """
    position = curve.position - curve.compliance * curve.force
    return dataclasses.replace(curve, position=position, machine_stiffness=math.inf)


def on_frame(curve: ForceCurve, frame_compliance: float) -> ForceCurve:
    """Return the curve with the compliance of the frame added to its compliance.

    Parameters
    ----------
    curve : ForceCurve
    frame_compliance : float
        [m/N], not negative.
    """
    checked(NON_NEGATIVE, "on_frame", "frame_compliance", frame_compliance, "m/N")
    compliance = curve.compliance + frame_compliance
    return dataclasses.replace(curve, machine_stiffness=1.0 / compliance if compliance > 0.0 else math.inf)
