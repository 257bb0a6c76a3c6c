"""Validity of the evaluation of an indentation: pile-up, zero point, drift, calibration, unloadings left out."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from winkler.fitting.nanoindentation.indenter import CalibratedIndenter
from winkler.fitting.unloading.unloading_notes import PILE_UP, PILE_UP_LIMIT, READING, REVIEW, USUAL_EXPONENTS
from winkler.numerics.types import Array
from winkler.values.readable import with_unit
from winkler.values.validity import Assumption, Note, Standing

DETERMINED_SHARE = 0.02
"""Greatest uncertainty of the frame of a good calibration, relative to the least compliance of a contact."""
MOST_SCATTER = 2.0
"""Greatest scatter of the readings over that of noise, zero point and drift."""
OUTLIERS = "B. Iglewicz, D. C. Hoaglin, How to Detect and Handle Outliers, ASQC Quality Press (1993)"
ISO = "ISO 14577-1:2015, Metallic materials - Instrumented indentation test - Part 1"


def nanoindentation_notes(solution: Any) -> tuple[Note, ...]:
    """Return the notes of an evaluation.

    Parameters
    ----------
    solution : NanoindentationSolution
    """
    return tuple(_notes(solution))


def _notes(solution: Any) -> Iterator[Note]:
    place = solution.deepest
    share = float(solution.final_depth[place] / solution.depth[place])
    if share < PILE_UP_LIMIT:
        standing, end = Standing.ASYMPTOTIC, f"below {PILE_UP_LIMIT:g} there is little pile-up for any hardening"
    else:
        standing, end = (
            Standing.OUTSIDE,
            f"above {PILE_UP_LIMIT:g} material with little hardening piles up at the edge: the area may be up "
            "to 60 % too small, and hardness and modulus too large. Measure the area of the impression",
        )
    statement = f"Pile-up: {share:.2f} of the maximum depth remains after unloading; {end}."
    yield Note(Assumption.RESPONSE, standing, statement, PILE_UP)
    low, high = USUAL_EXPONENTS
    exponent = float(solution.exponent[place])
    usual = low <= exponent <= high
    statement = f"Exponent: the unloading has m = {exponent:.3g}; impressions of sharp tips give {low:g} to {high:g}"
    end = "." if usual else ": check drift, contact point and frame."
    yield Note(Assumption.CURVE, Standing.ASYMPTOTIC if usual else Standing.APPROXIMATE, statement + end, REVIEW)
    for doubt in solution.doubts:
        yield Note(Assumption.CURVE, Standing.OUTSIDE, doubt, "the evaluation")
    yield _zero(solution)
    yield _drift(solution)
    yield calibration_note(solution.problem.indenter, solution.contact_depth)
    if solution.skipped:
        statement = f"Unloadings: {len(solution.skipped)} were not evaluated, the first: {solution.skipped[0]}"
        yield Note(Assumption.CURVE, Standing.APPROXIMATE, statement, "the evaluation")


def _zero(solution: Any) -> Note:
    zero, depth = solution.zero_point, float(solution.depth[solution.deepest])
    share = zero.error / depth
    statement = f"Zero point: its uncertainty is {with_unit(zero.error, 'm', 2)}, {share:.2%} of the maximum depth"
    if zero.extrapolated:
        return Note(
            Assumption.CURVE, Standing.APPROXIMATE, f"{statement}, and extrapolated: no point lies before contact.", ISO
        )
    return Note(Assumption.CURVE, Standing.ASYMPTOTIC if share < 0.01 else Standing.APPROXIMATE, f"{statement}.", ISO)


def _drift(solution: Any) -> Note:
    if solution.drift.measured or solution.drift.error:
        statement = (
            f"Drift: {solution.drift.rate:.2g} m/s, uncertain by {solution.drift.error:.1g} m/s, was subtracted."
        )
        return Note(Assumption.CURVE, Standing.ASYMPTOTIC, statement, ISO)
    reason = solution.drift.doubt or "no hold under a small force after an unloading measures it"
    statement = f"Drift: {reason}, and none was subtracted; its contribution to the uncertainty is missing."
    return Note(Assumption.CURVE, Standing.APPROXIMATE, statement, ISO)


def calibration_note(indenter: CalibratedIndenter, contact_depth: Array) -> Note:
    """Return whether contact depths ``(n,)`` [m] lie within those of the calibration."""
    area = indenter.area
    low, high = float(contact_depth.min()), float(contact_depth.max())
    if not indenter.calibrated:
        statement = (
            "Calibration: the covariance of area and frame is not known; its contribution to the uncertainty "
            "is missing."
        )
        return Note(Assumption.SHAPE, Standing.APPROXIMATE, statement, READING)
    if low < area.shallowest or high > area.deepest:
        ends = [with_unit(end, "m", 3) for end in (low, high, area.shallowest, area.deepest)]
        statement = (
            f"Calibration: contact depths of {ends[0]} to {ends[1]} are outside the calibrated range, {ends[2]} "
            f"to {ends[3]}: the area function is extrapolated."
        )
        return Note(Assumption.SHAPE, Standing.OUTSIDE, statement, READING)
    statement = "Calibration: all contact depths are within those of the calibration."
    return Note(Assumption.SHAPE, Standing.ASYMPTOTIC, statement, READING)


def calibration_notes(calibration: Any) -> tuple[Note, ...]:
    """Return the notes of a calibration: whether frame and area are determined, and whether the area function fits.

    Parameters
    ----------
    calibration : IndenterCalibration
    """
    return tuple(_calibrated(calibration))


def _calibrated(calibration: Any) -> Iterator[Note]:
    yield _determined(calibration)
    yield _described(calibration)
    for reason in calibration.left_out:
        yield Note(Assumption.CURVE, Standing.APPROXIMATE, f"Left out: {reason}", OUTLIERS)


def _determined(calibration: Any) -> Note:
    correlation, error = calibration.correlation, calibration.frame_compliance_error
    if math.isnan(correlation):
        statement = "Frame: its compliance was given, and its uncertainty is not part of the calibration."
        return Note(Assumption.RESPONSE, Standing.ASYMPTOTIC, statement, READING)
    area = calibration.measured_area
    modulus = max(reference.modulus(calibration.indenter.solid) for reference in calibration.references)
    least = 0.5 * math.sqrt(math.pi / float(area.max())) / (calibration.indenter.shape_factor * modulus)
    share = error / least
    statement = (
        f"Frame and area: the uncertainty of the frame compliance is {with_unit(error, 'm/N', 2)}, {share:.1%} of "
        f"the smallest contact compliance; the errors of frame and area have a correlation of {correlation:.2f}"
    )
    if share <= DETERMINED_SHARE:
        return Note(Assumption.RESPONSE, Standing.ASYMPTOTIC, f"{statement}.", READING)
    advice = "give frame_compliance, more depths, or a second reference of another modulus"
    return Note(
        Assumption.RESPONSE, Standing.APPROXIMATE, f"{statement}, and can hardly be separated: {advice}.", READING
    )


def _described(calibration: Any) -> Note:
    scatter = math.sqrt(calibration.factor)
    statement = (
        f"Area function: the scatter of the readings is {scatter:.2g} times that explained by noise, zero point "
        "and drift"
    )
    if scatter <= MOST_SCATTER:
        return Note(Assumption.SHAPE, Standing.ASYMPTOTIC, f"{statement}.", READING)
    return Note(
        Assumption.SHAPE, Standing.APPROXIMATE, f"{statement}: check tip, drift and references; errors are widened.",
        READING,
    )  # fmt: skip
