r"""Errors of spring constant and sensitivity, carried through to the fitted numbers.

A deflection :math:`\delta = sV` gives the force and the travel of the tip,

.. math:: F = k\,s\,V, \qquad d = D - D_0 - s\,V = D - D_0 - \frac Fk .

A relative error of k changes all forces and leaves the depths; one of s changes both.  If k was found from thermal
noise with the same sensitivity, :math:`k \propto s^{-2}`, and the force changes by the opposite of the error of s.  The
change of the numbers follows from one step of generalised least squares under a small change of the calibration.

All curves of one cantilever share these errors: a mean over curves does not reduce them.
"""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.estimate import FitEstimate
from winkler.fitting.noise.whitening import whitening_of
from winkler.fitting.outcome import AnyFit
from winkler.fitting.several.population import quantile
from winkler.fitting.several.same_task import same_task
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import NON_NEGATIVE, checked
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

SMALL_CHANGE = 1e-3
"""Relative change of a calibration by which its effect is found."""


@value
class CalibrationShares:
    """Contributions of the calibration to the errors of fitted parameters.

    Parameters
    ----------
    names : tuple of str, (p,)
        Names of the numbers.
    spring_constant : ndarray, (p,)
        Change of each number by one standard error of the spring constant, in its unit.
    sensitivity : ndarray, (p,)
        Change of each number by one standard error of the sensitivity, in its unit.
    """

    __words__ = words(
        names=("", None, "what was fitted"),
        spring_constant=("", None, "change of the numbers by one standard error of the spring constant"),
        sensitivity=("", None, "change of the numbers by one standard error of the sensitivity"),
    )

    names: tuple[str, ...]
    spring_constant: Array
    sensitivity: Array

    def error(self, name: str) -> float:
        """Return the standard error of a number by the calibration alone."""
        index = self.names.index(name)
        return math.hypot(float(self.spring_constant[index]), float(self.sensitivity[index]))

    def interval(self, found: FitEstimate, name: str, confidence: float = 0.95) -> tuple[float, float]:
        """Return the interval of a number by noise and calibration together.

        Parameters
        ----------
        found : FitEstimate
            The fit, with the interval due to noise.
        name : str
        confidence : float
            Between 0 and 1.
        """
        number, ends = found.value(name), found.interval(name, confidence)
        width = quantile(math.inf, confidence) * self.error(name)
        if not found.logarithmic[found.index(name)] or not number > 0.0:
            below, above = (math.hypot(end - number, width) for end in ends)
            return number - below, number + above
        logs = [math.inf if end in (0.0, math.inf) else abs(math.log(end / number)) for end in ends]
        below, above = (math.hypot(log, width / number) for log in logs)
        most = math.log(np.finfo(float).max) - math.log(number)
        return number * math.exp(-below), number * math.exp(above) if above < most else math.inf


def calibration_shares(
    found: AnyFit,
    *,
    spring_constant_error: float = 0.0,
    sensitivity_error: float = 0.0,
    thermal: bool = False,
    spring_constant: float = 0.0,
    frame_compliance: float = 0.0,
) -> CalibrationShares:
    """Return the contributions of a calibration to the errors of the fitted parameters.

    Parameters
    ----------
    found : Fit, ViscoelasticFit or CreepFit
    spring_constant_error, sensitivity_error : float, optional
        Relative standard errors; 0.1 is 10 %.
    thermal : bool, optional
        Whether the spring constant was determined from thermal noise with this sensitivity.
    spring_constant : float, optional
        Spring constant [N/m], required if the position is already the travel of the tip; otherwise that of the curve
        is used.
    frame_compliance : float, optional
        Part of the compliance of the curve [m/N] that belongs to the frame, not to the cantilever.

    Raises
    ------
    InvalidInput
        If an error is negative, or the position is the travel of the tip and no spring constant is given.

    Examples
    --------
    The modulus of a half-space is proportional to the spring constant, whatever the tip.

    >>> import numpy as np
    >>> from winkler import Depth, Elastic, ForceCurve, Foundation, HalfSpace, Indentation, Paraboloid, fit
    >>> depth = np.linspace(-1e-6, 1e-6, 200)
    >>> model = Indentation(Foundation(Paraboloid(5e-6), HalfSpace.between(Elastic(1e4, 0.5))), Depth(0.0))
    >>> force = 4.0 / 3.0 * 1e4 / 0.75 * np.sqrt(5e-6) * np.maximum(depth, 0.0) ** 1.5
    >>> curve = ForceCurve(depth + force / 0.1, force + 1e-13 * np.sin(1e3 * np.arange(200)), machine_stiffness=0.1)
    >>> found = fit(curve, model, free=["bed.medium.first.young", "contact_point"])
    >>> shares = calibration_shares(found, spring_constant_error=0.1)
    >>> round(shares.error("bed.medium.first.young"))
    1000
    """
    for name, error in (("spring_constant_error", spring_constant_error), ("sensitivity_error", sensitivity_error)):
        checked(NON_NEGATIVE, "calibration_shares", name, error, "")
    task, coordinates, _ = same_task(found)
    prediction = task.predicted(coordinates)
    residuals = (task.measured - prediction.fitted) * task.weights
    jacobian = task.instrument(coordinates, prediction)
    whitening = whitening_of(task.noise_of(residuals, jacobian))
    columns = whitening.of(jacobian)
    size = np.linalg.norm(columns, axis=0)
    rates = []
    for which, error in (("spring_constant", spring_constant_error), ("sensitivity", sensitivity_error)):
        if error == 0.0:
            rates.append(np.zeros(coordinates.size))
            continue
        ends = []
        for sign in (1.0, -1.0):
            other = recalibrated(
                found.curve,
                **{f"{which}_change": sign * SMALL_CHANGE},
                thermal=thermal,
                spring_constant=spring_constant,
                frame_compliance=frame_compliance,
            )
            task = same_task(found, other).task
            ends.append((task.measured - task.prediction(coordinates).fitted) * task.weights)
        moved = 0.5 * (ends[0] - ends[1])
        step = np.linalg.lstsq(columns / size, whitening.of(moved), rcond=None)[0] / size
        change = [p.change(n) for p, n in zip(task.parameters, found.values.tolist(), strict=True)]
        rates.append(step * np.abs(change) * error / SMALL_CHANGE)
    return CalibrationShares(found.names, rates[0], rates[1])


def recalibrated(
    curve: ForceCurve,
    *,
    spring_constant_change: float = 0.0,
    sensitivity_change: float = 0.0,
    thermal: bool = False,
    spring_constant: float = 0.0,
    frame_compliance: float = 0.0,
) -> ForceCurve:
    """Return a curve under another calibration.

    Parameters
    ----------
    curve : ForceCurve
    spring_constant_change, sensitivity_change : float, optional
        Relative changes, above -1.
    thermal, spring_constant, frame_compliance
        As for `calibration_shares`.

    Raises
    ------
    InvalidInput
        If the sensitivity changes, the position is the travel of the tip, and no spring constant is given.
    """
    of_sensitivity = 1.0 + sensitivity_change
    of_spring = (1.0 + spring_constant_change) * (of_sensitivity**-2 if thermal else 1.0)
    of_force = of_spring * of_sensitivity
    own = curve.compliance - frame_compliance
    position, compliance = curve.position, curve.compliance
    if own > 0.0:
        compliance = own / of_spring + frame_compliance
    elif sensitivity_change != 0.0:
        if not spring_constant > 0.0:
            raise InvalidInput(
                "sensitivity_error: the position is the travel of the tip, from which the deflection was subtracted; "
                "give spring_constant, so that the deflection is known."
            )
        position = position - sensitivity_change * curve.force / spring_constant
    stiffness = 1.0 / compliance if compliance > 0.0 else math.inf
    return dataclasses.replace(curve, position=position, force=of_force * curve.force, machine_stiffness=stiffness)
