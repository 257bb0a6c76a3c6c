r"""Oliver and Pharr's evaluation of an unloading curve: stiffness, contact depth, area, modulus, hardness.

The upper part of the unloading is fitted by :math:`F = B(h-h_f)^m`; its slope at the greatest depth is the stiffness S.
The contact depth and the modulus are

.. math:: h_c = h_{max} - \epsilon\,\frac{F_{max}}S, \qquad E_r = \frac{\sqrt\pi}{2\beta}\,\frac S{\sqrt{A(h_c)}},
          \qquad H = \frac{F_{max}}{A(h_c)} ,

with the area A of the tip's cross-section at the height :math:`h_c`, and for a body of revolution that unloads with the
exponent m

.. math:: \epsilon = m\left(1 - \frac{2(m-1)\,\Gamma\bigl(\frac m{2(m-1)}\bigr)}
          {\sqrt\pi\,\Gamma\bigl(\frac1{2(m-1)}\bigr)}\right) :

3/4 for a paraboloid, 0.727 for a cone.  For an elastic contact of either shape the reading is exact.

The unloading is the last one of the curve's `segments`, from (nearly) the greatest force; holds do not enter the fit.
The peak is where it begins: after a hold, force and depth are those measured at the end of the hold; after a turn, the
depth is that of the turn, and the force that of the fitted law there.
"""

from __future__ import annotations

import math
from typing import Any, ClassVar

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.segments import SegmentKind
from winkler.fitting.unloading.contact_reading import Tip, area_at, contact_reading, intercept_factor
from winkler.fitting.unloading.unloading_law import fitted_power_law
from winkler.fitting.unloading.unloading_notes import unloading_notes
from winkler.fitting.unloading.unloading_peak import FEWEST, UnloadingFromPeak, unloading_from_peak
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import Finite, Fraction, Positive
from winkler.values.errors import InvalidInput
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

DIFFERENCE_STEP = 1e-6


@value
class OliverPharr:
    """An unloading curve and its tip.

    Parameters
    ----------
    curve : ForceCurve
        The measured curve; the last unloading of its `segments` is evaluated.  Wrong segments can be stated:
        ``curve.with_segments([("loading", 0), ("hold", 120), ("unloading", 180)])``.
    profile : Profile or CalibratedArea
        The tip: CalibratedArea(coefficients) or AreaFunction(coefficients), which give the required A(h_c), or any
        profile.
    contact_point : float, optional
        Position of first touch [m]; zero by default.
    upper, lower : float, optional
        Fractions of the maximum force between which the unloading is fitted [-].
    shape_factor : float, optional
        beta [-], 1 for bodies of revolution; often about 1.034 for a Berkovich pyramid.

    References
    ----------
    W. C. Oliver, G. M. Pharr, J. Mater. Res. 7 (1992) 1564-1583, doi:10.1557/JMR.1992.1564
    G. M. Pharr, A. Bolshakov, J. Mater. Res. 17 (2002) 2660-2671, doi:10.1557/JMR.2002.0386
    """

    __words__ = words(
        upper=("", "", "part of the greatest force where the fitted part begins"),
        lower=("", "", "part of the greatest force where the fitted part ends"),
        shape_factor=(r"\beta", "", "factor of the stiffness of a tip that is not round"),
    )

    curve: ForceCurve
    profile: Tip
    contact_point: Finite = 0.0
    upper: Fraction = 0.98
    lower: Fraction = 0.4
    shape_factor: Positive = 1.0

    assumptions: ClassVar[frozenset[Assumption]] = frozenset((Assumption.CURVE, Assumption.SHAPE, Assumption.RESPONSE))

    def __post_init__(self) -> None:
        if not 0.0 <= self.lower < self.upper <= 1.0:
            raise InvalidInput(
                f"OliverPharr: the limits of the fitted part are {self.upper!r} and {self.lower!r}; give 1 >= "
                "upper > lower >= 0, parts of the maximum force."
            )

    def solve(self) -> OliverPharrSolution:
        """Return stiffness, depth, area, modulus and hardness, with their standard errors.

        Raises
        ------
        InvalidInput
            If there is no unloading, or too few points lie between the limits.
        OutsideValidity
            If the contact depth is not positive, or beyond the profile.
        NotConverged
            If no power law fits the unloading.
        """
        path = unloading_from_peak(self.curve, self.unloading, self.peak_hold, self.contact_point)
        law = fitted_power_law(path.depth, path.force, self._between(path.force))
        chosen = self._between(law.fitted / math.exp(law.numbers[0]))
        law = fitted_power_law(path.depth, path.force, chosen)
        numbers = self._evaluate(law.numbers, path)
        jacobian = np.empty((numbers.size, law.numbers.size))
        for i in range(law.numbers.size):
            step = np.zeros(law.numbers.size)
            step[i] = DIFFERENCE_STEP
            ahead, behind = (self._evaluate(law.numbers + sign * step, path) for sign in (1.0, -1.0))
            jacobian[:, i] = (ahead - behind) / (2.0 * DIFFERENCE_STEP)
        variances = np.einsum("ij,jk,ik->i", jacobian, law.covariance, jacobian)
        errors = np.sqrt(np.where(variances >= 0.0, variances, np.nan))  # no variance is negative: it is unknown
        fitted = math.exp(law.numbers[0]) * path.highest
        errors = np.hypot(errors, self._moved_by_depth(numbers, path))
        force = path.highest if path.held else fitted
        about: list[Any] = [errors, law.scatter * path.highest, fitted, path.points[chosen]]
        return OliverPharrSolution(self, force, path.deepest, *numbers.tolist(), *about)

    @property
    def unloading(self) -> Array:
        """Indices of the points of the last unloading in the curve, without hold periods."""
        parts = [part for part in self.curve.segments if part.kind is SegmentKind.LAST_UNLOADING]
        return np.concatenate([np.arange(part.first, part.last + 1) for part in parts]) if parts else np.arange(0)

    @property
    def peak_hold(self) -> Array:
        """Indices of the points of the hold just before the last unloading; empty without a hold."""
        path = self.unloading
        held = [part for part in self.curve.segments if path.size and part.last == path[0] - 1]
        hold = [part for part in held if part.kind is SegmentKind.HOLD]
        return np.arange(hold[0].first, hold[0].last + 1) if hold else np.arange(0)

    def _between(self, share: Array) -> Array:
        """Return the points between the limits."""
        chosen = (share <= self.upper) & (share >= self.lower)
        if np.count_nonzero(chosen) < FEWEST:
            raise InvalidInput(
                f"OliverPharr: {int(np.count_nonzero(chosen))} points lie between {self.lower:g} and "
                f"{self.upper:g} of the maximum force; at least {FEWEST} are needed."
            )
        return np.asarray(chosen)

    def _moved_by_depth(self, numbers: Array, path: UnloadingFromPeak) -> Array:
        """Return what the standard error of the depth at the peak changes in contact depth, area, modulus, hardness."""
        step = DIFFERENCE_STEP * float(numbers[3])
        ahead, behind = (area_at(self.profile, float(numbers[3]) + sign * step) for sign in (1.0, -1.0))
        share = path.depth_error * (ahead - behind) / (2.0 * step) / float(numbers[4])
        area, modulus, hardness = share * numbers[4:7] * np.array([1.0, 0.5, 1.0])
        return np.array([0.0, 0.0, 0.0, path.depth_error, area, modulus, hardness])

    def _evaluate(self, law: Array, path: UnloadingFromPeak) -> Array:
        """Return m, h_f, S, h_c, A, E_r and H from the numbers of the power law."""
        top, final, exponent = math.exp(law[0]) * path.highest, float(law[1]), 1.0 + math.exp(law[2])
        slope = exponent * top / ((1.0 - final) * path.deepest)
        force = path.highest if path.held else top
        intercept, factor = intercept_factor(exponent), self.shape_factor
        reading = contact_reading(slope, force, path.deepest, self.profile, intercept=intercept, shape_factor=factor)
        read = (reading.contact_depth, reading.area, reading.modulus, reading.hardness)
        return np.array([exponent, final * path.deepest, slope, *read])


@value
class OliverPharrSolution:
    """Evaluation of an unloading curve.

    Parameters
    ----------
    problem : OliverPharr
        The problem that was solved.
    force : float
        Force at the peak [N], where the unloading begins: measured at the end of a hold, or that of the fitted law.
    depth : float
        Depth at the peak [m].
    exponent : float
        m of the unloading [-].
    final_depth : float
        h_f [m], where the fitted unloading ends.
    stiffness : float
        S [N/m] at the peak.
    contact_depth : float
        h_c [m].
    area : float
        Projected area of contact [m^2].
    modulus : float
        Reduced modulus E_r [Pa], that of the pair.
    hardness : float
        [Pa].
    standard_errors : ndarray, (7,)
        Standard errors of exponent, final_depth, stiffness, contact_depth, area, modulus and hardness, in their units.
        They follow from the scatter of the unloading and the depth noise at its peak; `Nanoindentation` adds zero
        point, drift and calibration.
    scatter : float
        Standard deviation of the forces about the power law [N].
    fitted_force : float
        Force of the fitted law at the peak's depth [N].
    fitted_points : ndarray
        Indices of the fitted points of the curve.
    """

    __words__ = words(
        exponent=("m", "", "exponent of the unloading"),
        modulus=("E_r", "Pa", "reduced modulus, that of the pair"),
        scatter=("s", "N", "standard deviation of the forces about the power law"),
        fitted_force=("F", "N", "force of the fitted law at the depth of the peak"),
        fitted_points=("", None, "indices of the points that were fitted"),
    )

    problem: OliverPharr
    force: float
    depth: float
    exponent: float
    final_depth: float
    stiffness: float
    contact_depth: float
    area: float
    modulus: float
    hardness: float
    standard_errors: Array
    scatter: float
    fitted_force: float
    fitted_points: Array

    @property
    def validity(self) -> tuple[Note, ...]:
        """Validity of the evaluation: pile-up, creep, exponent, area, number of points."""
        return unloading_notes(self)
