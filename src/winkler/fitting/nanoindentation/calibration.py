r"""Area function and frame compliance from indentations in reference samples, in one fit.

Every unloading of a reference of known modulus :math:`E_r` gives the measured compliance :math:`c = 1/S_m` and a depth,

.. math:: c = C_f + \frac{\sqrt\pi}{2\beta E_r}\frac1{\sqrt{A(h_c)}}, \qquad
          h_c = h_m - C_f F - \epsilon F\,(c - C_f), \qquad A = \sum_k C_k\,h_c^{\,2^{1-k}}, \quad C_k \ge 0 .

Compliance and depth are corrected with the same :math:`C_f`, which the fit and the power laws of the unloadings share:
the power laws, and the touch of each curve by the area found so far, are fitted again until the compliance stays.
Residuals in the logarithm of the contact's compliance have the covariance of noise, zero point and drift, those of one
curve being correlated, times a factor by which the scatter exceeds it.  The covariance belongs to each frame: the
noise of c is larger in parts of a smaller c - C_f, and one covariance for all frames prefers stiff ones.  Frame
compliance and coefficients are middles of central intervals of 95 % over all frames and numbers of coefficients, each
by the probability of the readings, averaged over all coefficients that are not negative; their covariance has the
widths of these intervals, and contains how coefficients differ.

Of identical data one curve counts.  A curve whose mean residual stands out of those of the others
(`winkler.fitting.several.standing_out`) is left out, the farthest first, and the fit is repeated; at most a fifth of
the curves.

References
----------
W. C. Oliver, G. M. Pharr, J. Mater. Res. 19 (2004) 3-20, doi:10.1557/jmr.2004.19.1.3
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Sequence

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.nanoindentation.area_fit import (
    COMMON_ZERO,
    AreaFit,
    ReferenceReadings,
    covariance_of,
    fitted_area,
    slope_of,
)
from winkler.fitting.nanoindentation.calibration_solution import IndenterCalibration
from winkler.fitting.nanoindentation.indenter import DIAMOND, CalibratedIndenter
from winkler.fitting.nanoindentation.measurement import Prepared, prepared
from winkler.fitting.nanoindentation.reference_samples import ReferenceSample
from winkler.fitting.several.standing_out import copies, outlying
from winkler.fitting.unloading.contact_reading import CalibratedArea
from winkler.materials.elastic import Elastic
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, NotConverged, WinklerError

ROUNDS = 8
AREA_ROUNDS = 2
"""Rounds after which the area function, by which the touches are found, is taken anew."""
CONVERGED = 0.03
"""Change of the frame compliance between two rounds, in parts of its error, that ends the iteration."""
MOST_TERMS = 4
MOST_LEFT_OUT = 0.2
"""Greatest part of the curves that is left out because they stand out."""


def calibrate_indenter(
    curves: Sequence[tuple[ForceCurve, ReferenceSample]],
    *,
    terms: int = 0,
    solid: Elastic = DIAMOND,
    shape_factor: float = 1.0,
    frame_compliance: float | None = None,
) -> IndenterCalibration:
    """Return area function and frame compliance of an indenter.

    Parameters
    ----------
    curves : sequence of (ForceCurve, ReferenceSample)
        Indentations, each with its reference sample; preferably with partial unloadings over the whole depth range.
        The compliance of the frame is found in addition to that of the curves.
    terms : int, optional
        Number of coefficients. By default one to four coefficients are compared, with equal prior probability.
    solid : Elastic, optional
        Of the tip; diamond by default.
    shape_factor : float, optional
        beta [-].
    frame_compliance : float, optional
        C_f [m/N] if it is known, and not fitted.

    Raises
    ------
    InvalidInput
        If there are fewer than four unloadings, or fewer unloadings than parameters.
    NotConverged
        If frame compliance and power laws do not agree after eight rounds.
    """
    if not 0 <= terms <= 8:
        raise InvalidInput(f"calibrate_indenter: terms is {terms!r}; give 1 to 8, or 0 for the mean over 1 to 4.")
    first = copies(curve for curve, _ in curves)
    left_out = [
        f"{curves[place][0].name}: the data of {curves[origin][0].name}, counted once."
        for place, origin in enumerate(first)
        if origin < place
    ]
    kept = [curves[place] for place in dict.fromkeys(first)]
    most = int(MOST_LEFT_OUT * len(kept))
    while True:
        found, farthest, far = _calibrated(kept, terms, solid, shape_factor, frame_compliance)
        if not most or far <= 1.0:
            return dataclasses.replace(found, left_out=tuple(left_out))
        left_out.append(
            f"{kept[farthest][0].name}: the compliance of its contacts stands out of the others, {far:.2g} times as "
            "far as the limit."
        )
        del kept[farthest]
        most -= 1


def _calibrated(
    curves: Sequence[tuple[ForceCurve, ReferenceSample]],
    terms: int,
    solid: Elastic,
    shape_factor: float,
    frame_compliance: float | None,
) -> tuple[IndenterCalibration, int, float]:
    """Return the calibration by all curves, the place of the one that is farthest from the others, and how far."""
    fixed = frame_compliance is not None
    compliance, before = frame_compliance or 0.0, math.inf
    area: tuple[float, ...] = ()
    for number in range(ROUNDS):
        ready, references, skipped = prepared_references(curves, compliance, area)
        readings = reference_readings(ready, references, solid)
        fit = _best_fit(readings, references, solid, shape_factor, terms, compliance if fixed else None)
        found = float(fit.numbers[0])
        error = math.sqrt(max(float(fit.covariance[0, 0]), 0.0))
        known = bool(area)
        if number < AREA_ROUNDS:  # then the touches keep the law, so that compliance and power laws can settle
            area = tuple(fit.numbers[1:].tolist())
        if known and (fixed or abs(found - compliance) <= max(CONVERGED * error, 1e-6 * abs(found))):
            break
        before, compliance = compliance, max(found, 0.0)
    else:
        if not abs(before - compliance) <= 0.1 * error:
            raise NotConverged(
                f"calibrate_indenter: the frame compliance still changes from {before:.4g} to {compliance:.4g} m/N; "
                "give frame_compliance, or curves over a wider range of depths."
            )
    solution = _calibration(fit, readings, references, solid, shape_factor, ready, list(skipped.values()))
    far = _distances(fit, readings, shape_factor)
    evaluated = [place for place in range(len(curves)) if place not in skipped]
    return solution, evaluated[int(np.argmax(far))], float(far.max())


def _distances(fit: AreaFit, readings: ReferenceReadings, shape_factor: float) -> Array:
    """Return how far the mean residual of each curve lies from those of the others, over the limit ``(curves,)``."""
    covariance = covariance_of(fit.numbers, readings, shape_factor)
    means = [float(np.mean(fit.residuals[which])) for which, _ in readings.blocks]
    errors = [float(np.sqrt(np.mean(covariance[np.ix_(which, which)]))) for which, _ in readings.blocks]
    return outlying(means, errors)


def _best_fit(
    readings: ReferenceReadings,
    references: list[ReferenceSample],
    solid: Elastic,
    shape_factor: float,
    terms: int,
    known: float | None,
) -> AreaFit:
    most = min(MOST_TERMS, readings.force.size - 2)
    if terms > readings.force.size - 1:
        raise InvalidInput(
            f"calibrate_indenter: {terms} coefficients and the frame from {readings.force.size} unloadings; use fewer."
        )
    fit = fitted_area(readings, [terms] if terms else range(1, most + 1), shape_factor, known)
    return _with_references(fit, readings, references, solid, shape_factor)


def _with_references(
    fit: AreaFit, readings: ReferenceReadings, references: list[ReferenceSample], solid: Elastic, shape_factor: float
) -> AreaFit:
    """Return the fit with the uncertainty of the references' moduli in its covariance."""
    covariance = fit.covariance.copy()
    whole = covariance_of(fit.numbers, readings, shape_factor)
    inverse = np.linalg.inv(whole)
    active = np.flatnonzero(np.diag(fit.covariance) > 0.0)
    scale = np.maximum(np.abs(fit.numbers), np.sqrt(np.diag(fit.covariance)))
    rows = np.stack(
        [
            slope_of(fit.numbers, place, scale[place], readings, shape_factor) / scale[place]
            for place in active.tolist()
        ],
        axis=1,
    )
    weigh = np.linalg.pinv((rows * scale[active]).T @ inverse @ (rows * scale[active])) * scale[active][:, None]
    project = weigh @ (rows * scale[active]).T @ inverse
    for reference in set(references):
        modulus = reference.modulus(solid)
        relative = (1.0 - reference.poisson**2) / reference.young * modulus * reference.young_error / reference.young
        change = project @ np.where(readings.reference == modulus, relative, 0.0)
        covariance[np.ix_(active, active)] += np.outer(change, change)
    return fit._replace(covariance=covariance)


def _calibration(
    fit: AreaFit,
    readings: ReferenceReadings,
    references: list[ReferenceSample],
    solid: Elastic,
    shape_factor: float,
    ready: list[Prepared],
    skipped: list[str],
) -> IndenterCalibration:
    own = readings.compliance - fit.numbers[0]
    contact = readings.depth - fit.numbers[0] * readings.force - readings.intercept * readings.force * own
    area = CalibratedArea(tuple(fit.numbers[1:].tolist()), float(contact.min()), float(contact.max()))
    indenter = CalibratedIndenter(area, float(fit.numbers[0]), fit.covariance, solid, shape_factor)
    names = tuple(ready[place].curve.name for place, (which, _) in enumerate(readings.blocks) for _ in which)
    measured = np.pi * (1.0 / (2.0 * shape_factor * readings.reference * own)) ** 2
    return IndenterCalibration(
        indenter=indenter,
        force=readings.force,
        contact_depth=contact,
        measured_area=measured,
        residuals=fit.residuals,
        curve_names=names,
        factor=fit.factor,
        references=tuple(dict.fromkeys(references)),
        skipped=tuple(skipped),
    )


FEWEST_READINGS = 4


def prepared_references(
    curves: Sequence[tuple[ForceCurve, ReferenceSample]], compliance: float, area: Sequence[float] | Array
) -> tuple[list[Prepared], list[ReferenceSample], dict[int, str]]:
    """Return the curves that can be evaluated, their references, and the places of others with the reasons."""
    ready, references, skipped = [], [], dict[int, str]()
    for place, (curve, reference) in enumerate(curves):
        try:
            ready.append(prepared(curve, compliance, area=area))
            references.append(reference)
        except WinklerError as error:
            skipped[place] = f"{curve.name}: {error}"
    if not ready:
        reason = f": {next(iter(skipped.values()))}" if skipped else ""
        raise InvalidInput(f"calibrate_indenter: no curve can be evaluated{reason}.")
    return ready, references, skipped


def reference_readings(ready: list[Prepared], references: list[ReferenceSample], solid: Elastic) -> ReferenceReadings:
    """Return the peaks of all unloadings with the covariances of each curve."""
    columns = [np.concatenate([getattr(one.peaks, name) for one in ready]) for name in ready[0].peaks._fields]
    force, depth, compliance, intercept = columns
    if force.size < FEWEST_READINGS:
        raise InvalidInput(
            f"calibrate_indenter: there are {force.size} unloadings; at least {FEWEST_READINGS}, at different depths, "
            "are needed."
        )
    moduli = np.concatenate(
        [
            np.full(one.peaks.force.size, reference.modulus(solid))
            for one, reference in zip(ready, references, strict=True)
        ]
    )
    blocks, first = [], 0
    for one in ready:
        size = one.peaks.force.size
        blocks.append((np.arange(first, first + size), _covariance_of(one)))
        first += size
    zero = np.concatenate([np.full(one.peaks.force.size, one.zero_point.error) for one in ready])
    return ReferenceReadings(force, depth, compliance, intercept, moduli, zero, blocks)


def _covariance_of(one: Prepared) -> Callable[[Array, Array], Array]:
    """Return what makes the covariance of the residuals of one curve from their derivatives by depth and compliance."""
    fits, zero, drift = one.unloadings, one.zero_point.error, one.drift.error
    waited = fits.time - one.touched

    def covariance(by_depth: Array, by_compliance: Array) -> Array:
        own = (
            by_depth**2 * fits.covariance[:, 0, 0]
            + by_compliance**2 * fits.covariance[:, 1, 1]
            + 2.0 * by_depth * by_compliance * fits.covariance[:, 0, 1]
        )
        moved = by_depth * zero
        drifted = drift * (waited * by_depth + fits.pace * by_compliance)
        alone = (1.0 - COMMON_ZERO) * np.outer(moved, moved)
        return np.asarray(np.diag(own) + alone + np.outer(drifted, drifted))

    return covariance
