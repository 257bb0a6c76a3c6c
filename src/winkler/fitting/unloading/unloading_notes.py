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
from typing import NamedTuple

import numpy as np

from winkler.fitting.unloading.contact_reading import CalibratedArea, Tip, polynomial
from winkler.profiles.area import AreaFunction
from winkler.validity import Assumption, Note, Standing

__all__ = ["UnloadingFacts", "unloading_notes"]

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


class UnloadingFacts(NamedTuple):
    """Numbers compared in the notes.

    Parameters
    ----------
    final_share : float
        h_f/h of the peak [-].
    exponent : float
        m [-].
    creep_share : float
        Relative error of the stiffness by creep [-]; nan without hold or times.
    force, fitted_force : float
        At the peak, as reported and by the fitted law [N].
    points : int
        Fitted points.
    error_share : float
        Standard error of the modulus, in parts of it.
    contact_depth : float
        h_c [m].
    tip : Profile or CalibratedArea
    shape_factor : float
        beta [-].
    """

    final_share: float
    exponent: float
    creep_share: float
    force: float
    fitted_force: float
    points: int
    error_share: float
    contact_depth: float
    tip: Tip
    shape_factor: float


def unloading_notes(facts: UnloadingFacts) -> tuple[Note, ...]:
    """Return the notes of an evaluation."""
    return (
        _pile_up(facts),
        _creep(facts),
        _exponent(facts),
        *_peak(facts),
        *_area(facts),
        _shape(facts),
        _points(facts),
    )


def _pile_up(facts: UnloadingFacts) -> Note:
    share = facts.final_share
    statement = f"Pile-up: {share:.2f} of the greatest depth remains after unloading"
    if share < PILE_UP_LIMIT:
        return Note(
            Assumption.RESPONSE,
            Standing.ASYMPTOTIC,
            f"{statement}; below {PILE_UP_LIMIT:g} little piles up, however the material hardens.",
            PILE_UP,
        )
    return Note(
        Assumption.RESPONSE,
        Standing.OUTSIDE,
        f"{statement}; above {PILE_UP_LIMIT:g} material that hardens little piles up at the edge, the area may be up "
        "to 60 % too small, and hardness and modulus too large: measure the area of the impression.",
        PILE_UP,
    )


def _creep(facts: UnloadingFacts) -> Note:
    share = facts.creep_share
    if math.isnan(share):
        return Note(
            Assumption.CURVE,
            Standing.APPROXIMATE,
            "Creep: there is no hold before the unloading, or no times, so creep and drift cannot be assessed; they "
            "add the ratio of their rate to that of the unloading to the compliance.",
            CREEP,
        )
    size = abs(share)
    standing = (
        Standing.OUTSIDE if size >= MOST_CREEP else Standing.APPROXIMATE if size >= LEAST_CREEP else Standing.ASYMPTOTIC
    )
    advice = "hold longer, or unload faster" if size >= LEAST_CREEP else "small enough"
    return Note(
        Assumption.CURVE,
        standing,
        f"Creep: at the rate with which the hold ended, creep and drift make the stiffness {share:+.1%} wrong: "
        f"{advice}.",
        CREEP,
    )


def _exponent(facts: UnloadingFacts) -> Note:
    low, high = USUAL_EXPONENTS
    statement = f"Exponent: the unloading has m = {facts.exponent:.3g}"
    if low <= facts.exponent <= high:
        return Note(
            Assumption.CURVE,
            Standing.ASYMPTOTIC,
            f"{statement}, within {low:g} to {high:g} as impressions of sharp tips give.",
            SHAPES,
        )
    possible = POSSIBLE_EXPONENTS[0] < facts.exponent < POSSIBLE_EXPONENTS[1]
    return Note(
        Assumption.CURVE,
        Standing.APPROXIMATE if possible else Standing.OUTSIDE,
        f"{statement}, where impressions of sharp tips give {low:g} to {high:g}: "
        + (
            "a wholly elastic contact may, otherwise check drift, adhesion, contact point and frame."
            if possible
            else "no shape of a tip has such an unloading; check drift, creep, contact point and segments."
        ),
        SHAPES,
    )


def _peak(facts: UnloadingFacts) -> tuple[Note, ...]:
    miss = facts.fitted_force / facts.force - 1.0
    if abs(miss) <= PEAK_TOLERANCE:
        return ()
    return (
        Note(
            Assumption.CURVE,
            Standing.OUTSIDE,
            f"Peak: the fitted law misses the force measured at the peak by {miss:+.1%}; creep, drift or a wrong "
            "segment distorts the unloading: check the segments, or fit another part (upper, lower).",
            READING,
        ),
    )


def _area(facts: UnloadingFacts) -> tuple[Note, ...]:
    tip, depth = facts.tip, facts.contact_depth
    if not isinstance(tip, CalibratedArea | AreaFunction):
        return (
            Note(
                Assumption.SHAPE,
                Standing.APPROXIMATE,
                f"Area: that of an ideal {type(tip).__name__}; a real tip is blunt, which counts the more, the smaller "
                "the depth.",
                REVIEW,
            ),
        )
    heights = depth * np.append(AREA_DEPTHS, 1.0 + 1e-6)
    areas = np.array([polynomial(tip.coefficients, float(height)) for height in heights])
    falling = heights[1:][np.diff(areas) <= 0.0]
    notes = []
    if falling.size and falling[-1] >= depth:
        notes.append(
            Note(
                Assumption.SHAPE,
                Standing.OUTSIDE,
                f"Area: the area function shrinks at the contact depth {depth:.3g} m, which no tip does.",
                READING,
            )
        )
    elif falling.size:
        notes.append(
            Note(
                Assumption.SHAPE,
                Standing.ASYMPTOTIC,
                f"Area: the area function shrinks at depths of {falling[0]:.2g} to {falling[-1]:.2g} m and is no tip "
                "there; only the contact depth counts.",
                READING,
            )
        )
    low, high = (tip.shallowest, tip.deepest) if isinstance(tip, CalibratedArea) else (0.0, math.inf)
    if low == 0.0 and high == math.inf:
        statement, standing = "the depths of its calibration are not stated", Standing.APPROXIMATE
    elif low <= depth <= high:
        statement, standing = f"the area function was calibrated from {low:.3g} to {high:.3g} m", Standing.ASYMPTOTIC
    else:
        statement = f"the area function was calibrated from {low:.3g} to {high:.3g} m only, and is extrapolated"
        standing = Standing.OUTSIDE
    notes.append(Note(Assumption.SHAPE, standing, f"Area: at the contact depth, {depth:.3g} m: {statement}.", READING))
    return tuple(notes)


def _shape(facts: UnloadingFacts) -> Note:
    return Note(
        Assumption.RESPONSE,
        Standing.APPROXIMATE,
        f"Shape factor: beta = {facts.shape_factor:g} was taken; pyramids have about 1.02 to 1.08, and the modulus "
        "goes with 1/beta.",
        REVIEW,
    )


def _points(facts: UnloadingFacts) -> Note:
    return Note(
        Assumption.CURVE,
        Standing.ASYMPTOTIC if facts.points >= FEW_POINTS else Standing.APPROXIMATE,
        f"Points: {facts.points} were fitted, and scatter alone makes the modulus uncertain by {facts.error_share:.2%}"
        + ("." if facts.points >= FEW_POINTS else f"; below {FEW_POINTS} that error itself is rough."),
        "covariance of the fit, with the autocorrelation of the noise",
    )
