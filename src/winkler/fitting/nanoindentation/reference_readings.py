"""The unloadings of reference samples as readings for the fit of area function and frame."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.nanoindentation.area_fit import COMMON_ZERO, ReferenceReadings
from winkler.fitting.nanoindentation.measurement import Prepared, prepared
from winkler.fitting.nanoindentation.reference_samples import ReferenceSample
from winkler.materials.elastic import Elastic
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, WinklerError

__all__ = ["prepared_references", "reference_readings"]

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
