r"""Every unloading of an indentation: force and depth at its peak, compliance and exponent, with the noise of each.

An unloading is partial or the last one.  The power law :math:`F = B(h-h_f)^m` is fitted to the part between the limits
that the unloading reaches.  After a hold, the depth at the peak is that of a straight line through the end of the hold.
The covariance of (depth, compliance, exponent) is that under white and slow noise, whose spectrum is estimated from all
unloadings and holds of the curve together.

One spectrum of noise for all parts of a curve, and what it does to least-squares fits of each part.

The residuals of a part have the variances :math:`\sigma_i^2\,(1 + (\omega_c/\omega)^\alpha)` in their cosine transform,
with a level :math:`\sigma_i` of their own, but the same exponent and the same frequency :math:`\omega_c` per point at
which
slow and white noise are equal.  The restricted likelihoods of all parts are multiplied; covariances are means over the
candidates by that weight.  A part of a hundred points alone hardly knows its slow noise; all parts together do.

References
----------
D. A. Harville, J. Am. Stat. Assoc. 72, 320 (1977), https://doi.org/10.1080/01621459.1977.10480998
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.segments import SegmentKind
from winkler.fitting.noise.spectra import transformed
from winkler.fitting.unloading.unloading_law import UnloadingLaw, fitted_power_law
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput, NotConverged

EXPONENTS = (1.0, 1.5, 2.0)
CROSSINGS = np.geomspace(1e-4, 2.0, 20)
"""Frequencies omega_c [rad per point] at which slow and white noise are equal."""


class NoiseRecord(NamedTuple):
    """Residuals ``(n,)`` of a fit in the order of measurement, and the derivatives of its prediction ``(n, p)``."""

    residuals: Array
    jacobian: Array


class PooledNoise(NamedTuple):
    """Covariances ``(p, p)`` of the fitted numbers of each part, and variances of white and slow noise of each."""

    covariances: list[Array]
    white_variances: list[float]
    slow_variances: list[float]


def pooled_noise(records: list[NoiseRecord], count: int) -> PooledNoise:
    """Return covariances of least-squares numbers under a common spectrum.

    Parameters
    ----------
    records : list of NoiseRecord
    count : int
        Number of points of the whole curve: the slow variance is that over its length.
    """
    candidates = [(crossing, exponent) for exponent in EXPONENTS for crossing in CROSSINGS]
    likelihoods = np.zeros(len(candidates))
    variances, covariances = np.zeros((len(records), len(candidates))), []
    for place, record in enumerate(records):
        likelihood, variances[place], each = _under(record, candidates)
        likelihoods += likelihood
        covariances.append(each)
    weights = np.exp(likelihoods - likelihoods.max())
    weights /= weights.sum()
    frequency = np.pi * np.arange(1, count) / count
    slow = np.array([np.mean((crossing / frequency) ** exponent) for crossing, exponent in candidates])
    return PooledNoise(
        [np.asarray(np.tensordot(weights, each, 1)) for each in covariances],
        [float(weights @ variance) for variance in variances],
        [float(weights @ (variance * slow)) for variance in variances],
    )


def _under(record: NoiseRecord, candidates: list[tuple[float, float]]) -> tuple[Array, Array, Array]:
    """Return restricted likelihoods, white variances, and covariances ``(m, p, p)`` of all candidates."""
    size = np.linalg.norm(record.jacobian, axis=0)
    unit = float(np.sqrt(np.mean(record.residuals**2))) or np.finfo(float).tiny
    columns = transformed(np.concatenate([(record.residuals / unit)[:, None], record.jacobian / size], axis=1))
    count, p = record.jacobian.shape
    frequency = np.pi * np.maximum(np.arange(count), 0.5) / count
    spectra = np.stack([1.0 + (crossing / frequency) ** exponent for crossing, exponent in candidates])
    pairs = columns[:, :, None] * columns[:, None, :]
    products = np.tensordot(1.0 / spectra, pairs, 1)
    inner = products[:, 1:, 1:]
    solved = np.linalg.solve(inner, products[:, 1:, :1])[:, :, 0]
    squares = np.maximum(products[:, 0, 0] - np.einsum("mi,mi->m", solved, products[:, 1:, 0]), 1e-12)
    logarithms = np.sum(np.log(spectra), axis=1) + np.linalg.slogdet(inner)[1] + (count - p) * np.log(squares)
    variances = squares / max(count - p - 2, 1)
    plain = np.linalg.inv(pairs[:, 1:, 1:].sum(axis=0))
    spread = np.tensordot(spectra, pairs[:, 1:, 1:], 1)
    covariances = plain @ spread @ plain * variances[:, None, None] * unit**2 / np.outer(size, size)
    return -0.5 * logarithms, variances * unit**2, covariances


FEWEST = 10
"""Points of an unloading below which it is not evaluated."""
LEAST_DROP = 0.2
"""Least part of its peak by which the force of an unloading falls."""
HOLD_END_SHARE = 0.3
"""Last part of a hold through which the line to the peak is laid."""


class FittedUnloadings(NamedTuple):
    """Peaks and power laws of n unloadings.

    Parameters
    ----------
    force, depth, compliance, exponent : ndarray, (n,)
        At the peak [N], [m], [m/N], [-]; depth and compliance still contain frame and zero point of the curve.
    covariance : ndarray, (n, 3, 3)
        Of depth, compliance and exponent, by noise.
    time : ndarray, (n,)
        Of the peak [s]; zero without times.
    pace : ndarray, (n,)
        Time over force at the beginning of the unloading, dt/dF [s/N], negative.
    final_depth : ndarray, (n,)
        h_f [m] of the power law.
    first, last : ndarray, (n,)
        Indices of the first and last point of each unloading.
    skipped : tuple of str
        Why unloadings were not evaluated.
    """

    force: Array
    depth: Array
    compliance: Array
    exponent: Array
    covariance: Array
    time: Array
    pace: Array
    final_depth: Array
    first: Array
    last: Array
    skipped: tuple[str, ...]


class _Peak(NamedTuple):
    """Depth [m] and force [N] at a peak, and residuals and derivatives of the line through the end of its hold."""

    depth: float
    force: float
    record: NoiseRecord | tuple[()]


class _FittedUnloading(NamedTuple):
    """A peak, the power law of the unloading in parts of the peak, and its first and last point."""

    peak: _Peak
    law: UnloadingLaw
    points: Array


def fitted_unloadings(curve: ForceCurve, *, upper: float = 0.98, lower: float = 0.4) -> FittedUnloadings:
    """Return the power laws of all unloadings of a curve, in the order of measurement.

    Parameters
    ----------
    curve : ForceCurve
        Corrected for drift, with the contact point at the position zero.
    upper, lower : float, optional
        Fractions of the peak force between which an unloading is fitted.

    Raises
    ------
    InvalidInput
        If no unloading can be evaluated.
    """
    depth = curve.depth(0.0)
    fits: list[_FittedUnloading] = []
    skipped: list[str] = []
    parts = curve.segments
    for place, part in enumerate(parts):
        if part.kind not in (SegmentKind.PARTIAL_UNLOADING, SegmentKind.LAST_UNLOADING):
            continue
        if place and parts[place - 1].kind is SegmentKind.HOLD and _goes_on(parts, place):
            continue
        kinds = [one.kind for one in parts]
        if SegmentKind.LOADING not in kinds[:place] and SegmentKind.LOADING in kinds[place:]:
            skipped.append(
                f"the unloading of the points {part.first} to {part.last}: it comes before the first loading, as a tip "
                "that leaves its preload."
            )
            continue
        hold = parts[place - 1] if place and parts[place - 1].kind is SegmentKind.HOLD else None
        held = np.arange(hold.first, hold.last + 1) if hold is not None else np.arange(0)
        chosen = np.arange(part.first, part.last + 1)
        try:
            fits.append(_fitted(curve, depth, chosen, held, upper, lower))
        except (InvalidInput, NotConverged) as error:
            skipped.append(f"the unloading of the points {part.first} to {part.last}: {error}")
    if not fits:
        reason = f" ({skipped[0]})" if skipped else ""
        raise InvalidInput(
            f"nanoindentation: curve '{curve.name}' has no unloading that can be evaluated{reason}; check its "
            "segments, and state them by with_segments if they are wrong."
        )
    records = [NoiseRecord(one.law.residuals, one.law.jacobian) for one in fits]
    records += [one.peak.record for one in fits if one.peak.record]
    noise = pooled_noise(records, curve.count)
    rows, covariances, of_hold = [], [], len(fits)
    for place, one in enumerate(fits):
        hold_place = of_hold if one.peak.record else -1
        of_hold += bool(one.peak.record)
        row, covariance = _numbers(curve, one, noise, place, hold_place)
        rows.append(row)
        covariances.append(covariance)
    force, deep, compliance, exponent, time, pace, final, first, last = np.array(rows).T
    whole = np.stack(covariances)
    return FittedUnloadings(force, deep, compliance, exponent, whole, time, pace, final, first, last, tuple(skipped))


def _goes_on(parts: tuple[object, ...], place: int) -> bool:
    """Return whether an unloading goes on after a hold within it."""
    unloadings = (SegmentKind.PARTIAL_UNLOADING, SegmentKind.LAST_UNLOADING)
    return place > 1 and getattr(parts[place - 2], "kind", None) in unloadings


def _fitted(
    curve: ForceCurve, depth: Array, chosen: Array, held: Array, upper: float, lower: float
) -> _FittedUnloading:
    """Return the peak and the power law of one unloading."""
    force = curve.force
    if chosen.size < FEWEST:
        raise InvalidInput(f"it has {chosen.size} points; at least {FEWEST} are needed.")
    peak = _peak(depth, force, chosen, held)
    if not peak.depth > 0.0 or not peak.force > 0.0:
        raise InvalidInput(f"at its peak, {peak.depth:.3g} m deep, the force is {peak.force:.3g} N; check signs.")
    if float(force[chosen].min()) > (1.0 - LEAST_DROP) * peak.force:
        raise InvalidInput(f"its force falls by less than {LEAST_DROP:.0%}.")
    x, y = depth[chosen] / peak.depth, force[chosen] / peak.force
    law = fitted_power_law(x, y, _between(y, lower, upper), with_noise=False)
    law = fitted_power_law(x, y, _between(law.fitted / math.exp(law.numbers[0]), lower, upper), with_noise=False)
    return _FittedUnloading(peak, law, chosen)


def _numbers(
    curve: ForceCurve, one: _FittedUnloading, noise: PooledNoise, place: int, hold_place: int
) -> tuple[tuple[float, ...], Array]:
    """Return force, depth, compliance, exponent, time, pace, final depth, first and last, and the covariance."""
    peak, law, chosen = one.peak, one.law, one.points
    top, final, exponent = math.exp(law.numbers[0]), float(law.numbers[1]), 1.0 + math.exp(law.numbers[2])
    slope = exponent * top / (1.0 - final) * peak.force / peak.depth
    gradient = np.array([[-1.0, -1.0 / (1.0 - final), -(exponent - 1.0) / exponent], [0.0, 0.0, exponent - 1.0]])
    gradient[0] /= slope
    covariance = np.zeros((3, 3))
    covariance[1:, 1:] = gradient @ noise.covariances[place] @ gradient.T
    in_depth = peak.force / slope
    slow, white = noise.slow_variances[place] * in_depth**2, noise.white_variances[place] * in_depth**2
    covariance[0, 0] = slow + (float(noise.covariances[hold_place][0, 0]) if hold_place >= 0 else white)
    start = chosen[: max(FEWEST // 2, chosen.size // 4)]
    time = float(curve.time[chosen[0]]) if curve.timed else 0.0
    pace = _slope(curve.force[start], curve.time[start]) if curve.timed else 0.0
    highest = peak.force if hold_place >= 0 else top * peak.force
    ends = float(chosen[0]), float(chosen[-1])
    return (highest, peak.depth, 1.0 / slope, exponent, time, min(pace, 0.0), final * peak.depth, *ends), covariance


def _between(share: Array, lower: float, upper: float) -> Array:
    chosen = (share <= upper) & (share >= lower)
    if np.count_nonzero(chosen) < FEWEST:
        raise InvalidInput(
            f"{int(np.count_nonzero(chosen))} points lie between {lower:g} and {upper:g} of its peak; at least "
            f"{FEWEST} are needed."
        )
    return np.asarray(chosen)


def _peak(depth: Array, force: Array, chosen: Array, held: Array) -> _Peak:
    """Return the end of the hold by a straight line, or the turn."""
    if held.size < FEWEST:
        before = max(int(chosen[0]) - 1, 0)
        return _Peak(float(depth[before]), float(force[before]), ())
    end = held[-max(FEWEST, int(HOLD_END_SHARE * held.size)) :]
    along = np.linspace(-1.0, 0.0, end.size)
    rows = np.stack([np.ones(end.size), along], axis=1)
    numbers, *_ = np.linalg.lstsq(rows, depth[end], rcond=None)
    record = NoiseRecord(depth[end] - rows @ numbers, rows)
    return _Peak(float(numbers[0]), float(np.mean(force[end])), record)


def _slope(x: Array, y: Array) -> float:
    """Return the slope of a straight line."""
    centred = x - x.mean()
    spread = float(centred @ centred)
    return float(centred @ y) / spread if spread else 0.0
