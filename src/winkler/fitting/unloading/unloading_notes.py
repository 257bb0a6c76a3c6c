r"""Validity of Oliver and Pharr's evaluation of an unloading.

Each note compares one number with its limit: residual over greatest depth (pile-up), the creep at the end
of the hold with the unloading, the exponent with that of effective indenter shapes, the fitted law with the measured
peak, the contact depth with the calibration of the tip, and the number of points.

Creep adds to the apparent compliance: with its rate :math:`\dot h_c` at the end of the hold, and the unloading rate
:math:`\dot F` there,

.. math:: \frac1S = \frac1{S_\mathrm{fitted}} + \frac{\dot h_c}{|\dot F|} .
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from winkler.fitting.unloading.contact_reading import CalibratedArea, polynomial
from winkler.fitting.unloading.unloading_law import EXPONENT_BOUNDS
from winkler.fitting.unloading.unloading_peak import FEWEST
from winkler.numerics.types import Array
from winkler.profiles.area import AreaFunction
from winkler.profiles.calibrated_tip import CalibratedTip, TabulatedTip
from winkler.values.readable import with_unit
from winkler.values.validity import Assumption, Note, Standing

READING = "W. C. Oliver, G. M. Pharr, J. Mater. Res. 7 (1992) 1564-1583, doi:10.1557/JMR.1992.1564"
REVIEW = "W. C. Oliver, G. M. Pharr, J. Mater. Res. 19 (2004) 3-20, doi:10.1557/jmr.2004.19.1.3"
PILE_UP = "A. Bolshakov, G. M. Pharr, J. Mater. Res. 13 (1998) 1049-1058, doi:10.1557/JMR.1998.0146"
CREEP = "G. Feng, A. H. W. Ngan, J. Mater. Res. 17 (2002) 660-668, doi:10.1557/JMR.2002.0094"
SHAPES = "G. M. Pharr, A. Bolshakov, J. Mater. Res. 17 (2002) 2660-2671, doi:10.1557/JMR.2002.0386"

PILE_UP_LIMIT = 0.7
"""Residual over greatest depth above which pile-up may affect the area."""
LEAST_CREEP, MOST_CREEP = 0.01, 0.1
USUAL_EXPONENTS = (1.2, 1.6)
POSSIBLE_EXPONENTS = (1.0 + 1e-3, 2.2)
"""Range of exponents of indenters: a flat punch has 1, a cone 2."""
PEAK_TOLERANCE = 0.02
"""Greatest relative deviation of the fitted law from the measured peak."""
FEW_POINTS = 50
AREA_DEPTHS = np.geomspace(1e-6, 1.0, 2000)
"""Relative depths at which the area function is checked."""


NoteParts = tuple[Assumption, Standing, str, str]
"""Assumption, standing, statement and source of a `Note`."""


def unloading_notes(solution: Any) -> tuple[Note, ...]:
    """Return the notes of an evaluation.

    Parameters
    ----------
    solution : OliverPharrSolution
    """
    return tuple(Note(*parts) for check in CHECKS for parts in check(solution))


def _pile_up(solution: Any) -> Iterator[NoteParts]:
    share = solution.final_depth / solution.depth
    statement = f"Pile-up: {share:.2f} of the maximum depth remains after unloading"
    if share < PILE_UP_LIMIT:
        standing = Standing.ASYMPTOTIC
        conclusion = f"below {PILE_UP_LIMIT:g} there is little pile-up for any hardening"
    else:
        standing = Standing.OUTSIDE
        conclusion = (
            f"above {PILE_UP_LIMIT:g} material with little hardening piles up at the edge: the area may be up to "
            "60 % too small, and hardness and modulus too large. Measure the area of the impression"
        )
    yield Assumption.RESPONSE, standing, f"{statement}; {conclusion}.", PILE_UP


def _creep(solution: Any) -> Iterator[NoteParts]:
    share, standing = _creep_share(solution), Standing.APPROXIMATE
    if math.isnan(share):
        statement = (
            "there is no hold before the unloading, or no times, so creep and drift are not known; they add the "
            "ratio of their rate to that of the unloading to the compliance"
        )
    else:
        size = abs(share)
        if size < LEAST_CREEP or size >= MOST_CREEP:
            standing = Standing.OUTSIDE if size >= MOST_CREEP else Standing.ASYMPTOTIC
        advice = "hold longer, or unload faster" if size >= LEAST_CREEP else "small enough"
        statement = f"at the rate at the end of the hold creep and drift change the stiffness by {share:+.1%}: {advice}"
    yield Assumption.CURVE, standing, f"Creep: {statement}.", CREEP


def _creep_share(solution: Any) -> float:
    """Return the creep rate at the end of the hold, over that of the unloading, in parts of the compliance [-]."""
    curve, hold = solution.problem.curve, solution.problem.peak_hold
    points = solution.fitted_points.astype(int)
    end, start = hold[-max(FEWEST, hold.size // 4) :], points[: max(2, points.size // 2)]
    if not curve.timed or end.size < FEWEST:
        return math.nan
    creep = _rate(curve.time[end], curve.depth(solution.problem.contact_point)[end])
    unloading = _rate(curve.time[start], curve.force[start])
    return creep * solution.stiffness / abs(unloading) if unloading else math.nan


def _rate(time: Array, column: Array) -> float:
    """Return the slope of a straight line through a column over time."""
    centred = time - time.mean()
    spread = float(centred @ centred)
    return float(centred @ column) / spread if spread else 0.0


def _exponent(solution: Any) -> Iterator[NoteParts]:
    (low, high), (least, most) = USUAL_EXPONENTS, POSSIBLE_EXPONENTS
    usual = f"{low:g} to {high:g}"
    if low <= solution.exponent <= high:
        standing, conclusion = Standing.ASYMPTOTIC, f"within {usual} as impressions of sharp tips give."
    elif least < solution.exponent < most:
        standing = Standing.APPROXIMATE
        conclusion = (
            f"where impressions of sharp tips give {usual}: a wholly elastic contact may, otherwise check drift, "
            "adhesion, contact point and frame."
        )
    else:
        standing = Standing.OUTSIDE
        conclusion = (
            f"where impressions of sharp tips give {usual}: no shape of a tip has such an unloading; check drift, "
            "creep, contact point and segments."
        )
        if math.log(solution.exponent - 1.0) > EXPONENT_BOUNDS[1] - 1e-3:
            conclusion = f"the greatest that is tried, and has no meaning on this bound, {conclusion}"
    statement = f"Exponent: the unloading has m = {solution.exponent:.3g}, {conclusion}"
    yield Assumption.CURVE, standing, statement, SHAPES


def _peak(solution: Any) -> Iterator[NoteParts]:
    miss = solution.fitted_force / solution.force - 1.0
    if abs(miss) > PEAK_TOLERANCE:
        statement = (
            f"Peak: the fitted law differs from the force measured at the peak by {miss:+.1%}. Creep, drift or a "
            "wrong segment distorts the unloading: check the segments, or fit another part (upper, lower)."
        )
        yield Assumption.CURVE, Standing.OUTSIDE, statement, READING


def _area(solution: Any) -> Iterator[NoteParts]:
    tip, depth = solution.problem.profile, solution.contact_depth
    if isinstance(tip, CalibratedTip | TabulatedTip):
        yield Assumption.SHAPE, Standing.ASYMPTOTIC, "Area: the contact depth is within the calibration.", READING
        return
    if not isinstance(tip, CalibratedArea | AreaFunction):
        statement = (
            f"Area: that of an ideal {type(tip).__name__}. A real tip is blunt, which is more important at "
            "smaller depths."
        )
        yield Assumption.SHAPE, Standing.APPROXIMATE, statement, REVIEW
        return
    heights = depth * np.append(AREA_DEPTHS, 1.0 + 1e-6)
    areas = np.array([polynomial(tip.coefficients, float(height)) for height in heights])
    falling = heights[1:][np.diff(areas) <= 0.0]
    if falling.size and falling[-1] >= depth:
        place = with_unit(depth, "m", 3)
        statement = f"Area: the area function decreases at the contact depth {place}, which is impossible for a tip."
        yield Assumption.SHAPE, Standing.OUTSIDE, statement, READING
    elif falling.size:
        first, last = (with_unit(float(end), "m", 2) for end in falling[[0, -1]])
        statement = (
            f"Area: the area function decreases at depths of {first} to {last} and is invalid there; only the "
            "contact depth is used."
        )
        yield Assumption.SHAPE, Standing.ASYMPTOTIC, statement, READING
    low, high = (tip.shallowest, tip.deepest) if isinstance(tip, CalibratedArea) else (0.0, math.inf)
    calibrated = f"the area function was calibrated from {with_unit(low, 'm', 3)} to {with_unit(high, 'm', 3)}"
    if low == 0.0 and high == math.inf:
        standing, calibrated = Standing.APPROXIMATE, "the depths of its calibration are not stated"
    elif low <= depth <= high:
        standing = Standing.ASYMPTOTIC
    else:
        standing, calibrated = Standing.OUTSIDE, f"{calibrated} only, and is extrapolated"
    yield Assumption.SHAPE, standing, f"Area: at the contact depth, {with_unit(depth, 'm', 3)}: {calibrated}.", READING


def _shape(solution: Any) -> Iterator[NoteParts]:
    statement = (
        f"Shape factor: beta = {solution.problem.shape_factor:g} was used. Pyramids have about 1.02 to 1.08; the "
        "modulus is proportional to 1/beta."
    )
    yield Assumption.RESPONSE, Standing.APPROXIMATE, statement, REVIEW


def _points(solution: Any) -> Iterator[NoteParts]:
    count, share = solution.fitted_points.size, float(solution.standard_errors[5]) / solution.modulus
    statement = f"{count} were fitted, and scatter alone gives the modulus an uncertainty of {share:.2%}"
    standing, end = Standing.ASYMPTOTIC, "."
    if count < FEW_POINTS:
        standing, end = (
            Standing.APPROXIMATE,
            f"; with fewer than {FEW_POINTS} points this uncertainty itself is inaccurate.",
        )
    source = "covariance of the fit, under white and slow noise"
    yield Assumption.CURVE, standing, f"Points: {statement}{end}", source


CHECKS = (_pile_up, _creep, _exponent, _peak, _area, _shape, _points)
