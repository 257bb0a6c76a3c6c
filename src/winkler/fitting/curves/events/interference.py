r"""Interference: light reflected by the sample adds a sinusoid over the position to the force.

.. math:: F = F_0 + \dots + A\cos(2\pi D/\Lambda + \varphi)

It is sought in the free points beside a parabola for each direction.  The squares that a sinusoid explains are
compared with the spectrum of the noise, a white and a slow part that are fitted to the other frequencies (Whittle), so
that 1/f noise is no interference; with two directions, both have to have the same phase over the position.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.values.value import value, words

FEWEST = 30
LEAST_PERIODS, POINTS_PER_PERIOD = 2.0, 4.0
"""Fewest periods over the free travel, and fewest points in a period of one direction."""
OVERSAMPLING = 3
MOST_POINTS, MOST_FREQUENCIES = 600, 600
"""Most points of a direction, means of neighbours beyond, and most trial frequencies."""
LEAST_SCORE = 18.0
"""Least squares explained over those that noise explains."""
LEAST_SHARED = 0.6
"""Least part of the squares of each direction that the common sinusoid explains."""
EXPONENTS, RATIOS = (0.5, 1.0, 1.5, 2.0, 3.0), tuple(0.1 * 2.0**k for k in range(16))
"""Exponents of slow noise, and its power relative to the white noise at the lowest frequency."""
ROUNDS = 12


@value
class Interference:
    """A sinusoid over the position.

    Parameters
    ----------
    amplitude, amplitude_error : float
        A with its standard error [N].
    period, period_error : float
        The period in position with its standard error [m].
    origin : float
        Position [m] that `cosine`, `sine` and `covariance` refer to.
    cosine, sine : float
        Coefficients of the cosine and the sine of the phase from `origin` on [N].
    covariance : ndarray, (3, 3)
        Of the cosine and sine coefficients and the wave number, in SI units.
    confidence : float
        Probability that noise alone contains no such sinusoid.
    """

    __words__ = words(
        amplitude=("A", "N", "amplitude of the sinusoid"),
        amplitude_error=("", "N", "standard error of the amplitude"),
        period=(r"\Lambda", "m", "period in the position"),
        period_error=("", "m", "standard error of the period"),
        origin=("D", "m", "position at which the phase begins"),
        cosine=("", "N", "coefficient of the cosine"),
        sine=("", "N", "coefficient of the sine"),
        covariance=("", None, "covariance of both coefficients and the wave number"),
        confidence=("", "", "probability that noise alone contains no such sinusoid"),
    )

    amplitude: float
    amplitude_error: float
    period: float
    period_error: float
    origin: float
    cosine: float
    sine: float
    covariance: Array
    confidence: float

    def at(self, position: Array) -> Array:
        """Return the force of the interference at positions [N]."""
        phase = 2.0 * math.pi / self.period * (position - self.origin)
        return np.asarray(self.cosine * np.cos(phase) + self.sine * np.sin(phase))

    def error_at(self, position: Array) -> Array:
        """Return the standard error of that force [N]."""
        along = position - self.origin
        phase = 2.0 * math.pi / self.period * along
        slope = along * (self.sine * np.cos(phase) - self.cosine * np.sin(phase))
        columns = np.stack([np.cos(phase), np.sin(phase), slope], axis=-1)
        return np.asarray(np.sqrt(np.einsum("...i,ij,...j->...", columns, self.covariance, columns)))


class _Found(NamedTuple):
    score: float
    frequency: float
    variance: float
    trials: int


def interference_of(parts: list[tuple[Array, Array]]) -> Interference | None:
    """Return the interference in free points; None if none stands out of the noise.

    Parameters
    ----------
    parts : list of (ndarray, ndarray)
        Positions [m] and forces [N] of each direction.
    """
    parts = [_averaged(*part) for part in parts if part[0].size >= FEWEST and float(np.ptp(part[0])) > 0.0]
    if not parts:
        return None
    position = np.concatenate([part[0] for part in parts])
    origin = float(position.mean())
    place = position - origin
    free = _free_columns(parts)
    left = np.concatenate([part[1] - part[1].mean() for part in parts])
    left = left - free @ (free.T @ left)
    if not float(left @ left) > 0.0:
        return None
    found = _strongest(parts, place, free, left)
    if found is None or found.score < LEAST_SCORE or not _is_shared(parts, origin, found.frequency):
        return None
    wave, numbers, design = _refined(2.0 * math.pi * found.frequency, place, free, left)
    sizes = np.linalg.norm(design, axis=0)
    unit = design / sizes
    covariance = found.variance * np.linalg.pinv(unit.T @ unit) / np.outer(sizes, sizes)
    cosine, sine = float(numbers[0]), float(numbers[1])
    amplitude = math.hypot(cosine, sine)
    along = np.array([cosine, sine]) / amplitude
    error = math.sqrt(float(along @ covariance[:2, :2] @ along))
    period = 2.0 * math.pi / wave
    return Interference(
        amplitude,
        error,
        period,
        period * math.sqrt(float(covariance[2, 2])) / wave,
        origin,
        cosine,
        sine,
        covariance,
        (1.0 - math.exp(-min(found.score, 700.0))) ** found.trials,
    )


def _averaged(position: Array, force: Array) -> tuple[Array, Array]:
    """Return means of neighbours, if there are many points."""
    size = position.size // MOST_POINTS + 1
    count = position.size // size
    place, load = (column[: count * size].reshape(count, size).mean(axis=1) for column in (position, force))
    return place, load


def _free_columns(parts: list[tuple[Array, Array]]) -> Array:
    """Return orthonormal columns ``(n, 3 d)``: a parabola for each direction."""
    rows, start = sum(part[0].size for part in parts), 0
    columns = np.zeros((rows, 3 * len(parts)))
    for number, (place, _) in enumerate(parts):
        along = (place - place.mean()) / float(np.ptp(place))
        columns[start : start + place.size, 3 * number : 3 * number + 3] = np.stack([along**0, along, along**2], axis=1)
        start += place.size
    return np.asarray(np.linalg.qr(columns)[0])


def _strongest(parts: list[tuple[Array, Array]], place: Array, free: Array, left: Array) -> _Found | None:
    """Return the frequency that stands out most of the noise."""
    travel = max(float(np.ptp(part[0])) for part in parts)
    spacing = min(float(np.ptp(part[0])) / part[0].size for part in parts)
    highest = min(1.0 / (POINTS_PER_PERIOD * spacing), MOST_FREQUENCIES / (OVERSAMPLING * travel))
    count = int((highest - LEAST_PERIODS / travel) * travel * OVERSAMPLING)
    if count < 4 * OVERSAMPLING:
        return None
    frequencies = LEAST_PERIODS / travel + np.arange(count) / (travel * OVERSAMPLING)
    power = _explained(frequencies, place, free, left)
    peak = int(np.argmax(power))
    apart = np.abs(np.arange(count) - peak) > 2 * OVERSAMPLING
    own = apart & (np.arange(count) % OVERSAMPLING == 0)
    spectrum = _spectrum(frequencies, power, own)
    scores = power / spectrum
    best = int(np.argmax(scores))
    if abs(best - peak) > 2 * OVERSAMPLING:  # the noise is greatest elsewhere
        apart = np.abs(np.arange(count) - best) > 2 * OVERSAMPLING
        spectrum = _spectrum(frequencies, power, apart & (np.arange(count) % OVERSAMPLING == 0))
        scores = power / spectrum
        best = int(np.argmax(scores))
    return _Found(float(scores[best]), float(frequencies[best]), 0.5 * float(spectrum[best]), count // OVERSAMPLING)


def _explained(frequencies: Array, place: Array, free: Array, left: Array) -> Array:
    """Return the squares that a sinusoid of each frequency explains."""
    phase = 2.0 * math.pi * np.outer(place, frequencies)
    cosines, sines = np.cos(phase), np.sin(phase)
    for columns in (cosines, sines):
        columns -= free @ (free.T @ columns)
    cc, ss, cs = (np.einsum("ij,ij->j", a, b) for a, b in ((cosines, cosines), (sines, sines), (cosines, sines)))
    cy, sy = left @ cosines, left @ sines
    determinant = np.maximum(cc * ss - cs**2, 1e-9 * cc * ss)
    return np.asarray((ss * cy**2 - 2.0 * cs * cy * sy + cc * sy**2) / determinant)


def _spectrum(frequencies: Array, power: Array, own: Array) -> Array:
    """Return the squares that noise explains: white noise with a slow part, by Whittle's likelihood."""
    relative = frequencies / frequencies[0]
    best, result = math.inf, np.full(frequencies.size, float(power[own].mean()))
    for shape in [relative**0.0, *(1.0 + r * relative**-e for e in EXPONENTS for r in RATIOS)]:
        scale = float(np.mean(power[own] / shape[own]))
        likelihood = np.count_nonzero(own) * math.log(scale) + float(np.sum(np.log(shape[own])))
        if likelihood < best - 1e-9:
            best, result = likelihood, scale * shape
    return result


def _is_shared(parts: list[tuple[Array, Array]], origin: float, frequency: float) -> bool:
    """Return whether one sinusoid over the position describes both directions."""
    if len(parts) < 2:
        return True
    own = 0.0
    for part in parts:
        free = _free_columns([part])
        left = part[1] - part[1].mean()
        own += float(_explained(np.array([frequency]), part[0] - origin, free, left - free @ (free.T @ left))[0])
    free = _free_columns(parts)
    left = np.concatenate([part[1] - part[1].mean() for part in parts])
    place = np.concatenate([part[0] for part in parts]) - origin
    common = float(_explained(np.array([frequency]), place, free, left - free @ (free.T @ left))[0])
    return common > LEAST_SHARED * own


def _refined(wave: float, place: Array, free: Array, left: Array) -> tuple[float, Array, Array]:
    """Return the wave number, both coefficients, and the columns of all three, by Gauss-Newton steps."""
    numbers = np.zeros(2)
    design = np.zeros((place.size, 3))
    for _ in range(ROUNDS):
        pair = np.stack([np.cos(wave * place), np.sin(wave * place)], axis=1)
        pair_free = pair - free @ (free.T @ pair)
        numbers = np.linalg.lstsq(pair_free, left, rcond=None)[0]
        slope = place * (numbers[1] * pair[:, 0] - numbers[0] * pair[:, 1])
        slope = slope - free @ (free.T @ slope)
        design = np.column_stack([pair_free, slope])
        sizes = np.linalg.norm(design, axis=0)
        step = float(np.linalg.lstsq(design / sizes, left - pair_free @ numbers, rcond=None)[0][2]) / float(sizes[2])
        wave += step
        if abs(step) < 1e-10 * wave:
            break
    return wave, numbers, design
