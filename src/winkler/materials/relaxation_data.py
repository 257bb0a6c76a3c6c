r"""Solids described by measurements: relaxation or creep over time, or storage and loss over frequency.

Non-negative sums of exponentials, at times evenly spaced in their logarithm across the data, are fitted by least
squares of the relative misfits.  Being non-negative they are always those of a solid that makes no energy; measured
scatter is not followed.  The greatest relative misfit is stated.
"""

from __future__ import annotations

import functools
import math
from typing import Annotated

import numpy as np

from winkler.materials.sweeps import RowsOfOneLength
from winkler.materials.viscoelastic import FittedSolid
from winkler.numerics.springs.exponential_sums import CreepSeries, RelaxationSeries, merged, of_creep
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import POSITIVE, Advice, Numbers, PoissonRatio
from winkler.values.limits import MEASURED_TIMES
from winkler.values.value import value, words

FEWEST_ROWS = 4
ROUNDING_RATIO = 1e-13
"""Terms that carry less than this part of every number were left over by rounding."""
READING = ("", None, "how the file was read")
PER_DECADE = 8
"""Terms in each decade of time that may be taken; few of them are, since none may be negative."""


class _MeasuredSolid(RowsOfOneLength, FittedSolid):
    """What the solids here share: rows of one length, and the span of the data."""

    time: Array

    @property
    def _times(self) -> Array:
        return self.time

    @property
    def span(self) -> tuple[float, float]:
        """From which time on and up to which there are data [s]."""
        return float(self._times[0]), float(self._times[-1])


SORT_ADVICE = Advice("sort the rows, and average what is given twice")


@value
class RelaxationData(_MeasuredSolid):
    """A viscoelastic solid with a measured relaxation modulus.

    Parameters
    ----------
    time : ndarray, (n,)
        Since the step of strain [s], positive, rising.
    shear : ndarray, (n,)
        G(t) [Pa], positive.
    poisson : float, optional
        nu [-].
    reading : str, optional
        How the file was read: the columns used, and the rows that were averaged.

    Raises
    ------
    InvalidInput
        If the rows differ in length, are too short, or have values that are not positive.

    Examples
    --------
    >>> t = np.geomspace(0.01, 100.0, 41)
    >>> gel = RelaxationData(t, 1e3 + 2e3 * np.exp(-t))
    >>> bool(gel.series_error < 0.01), bool(abs(gel.relaxation(1.0) / (1e3 + 2e3 / np.e) - 1.0) < 0.01)
    (True, True)
    """

    __words__ = words(reading=READING)

    time: Annotated[Array, Numbers(POSITIVE, FEWEST_ROWS, MEASURED_TIMES, "rising"), SORT_ADVICE]
    shear: Annotated[Array, Numbers(POSITIVE, FEWEST_ROWS, MEASURED_TIMES)]
    poisson: PoissonRatio = 0.5
    reading: str = ""

    @property
    def _fitted(self) -> tuple[RelaxationSeries, float]:
        return _of_relaxation(self)


@value
class CreepData(_MeasuredSolid):
    """A viscoelastic solid with measured creep compliance.

    Parameters
    ----------
    time : ndarray, (n,)
        Since the step of stress [s], positive, rising.
    compliance : ndarray, (n,)
        J(t) [1/Pa], positive.
    poisson : float, optional
        nu [-].
    reading : str, optional
        How the file was read: the columns used, and the rows that were averaged.

    Raises
    ------
    InvalidInput
        If the rows differ in length, are too short, or have values that are not positive.

    Examples
    --------
    >>> t = np.geomspace(0.01, 10.0, 31)
    >>> fluid = CreepData(t, 1e-3 * (1.0 + t / 0.5))
    >>> bool(fluid.series_error < 1e-3)
    True
    """

    __words__ = words(compliance=("J", "1/Pa", "shear compliance, one number for each time"), reading=READING)

    time: Annotated[Array, Numbers(POSITIVE, FEWEST_ROWS, MEASURED_TIMES, "rising"), SORT_ADVICE]
    compliance: Annotated[Array, Numbers(POSITIVE, FEWEST_ROWS, MEASURED_TIMES)]
    poisson: PoissonRatio = 0.5
    reading: str = ""

    @property
    def _fitted(self) -> tuple[RelaxationSeries, float]:
        return _of_creep(self)


@value
class DynamicData(_MeasuredSolid):
    """A viscoelastic solid with measured storage and loss moduli.

    Parameters
    ----------
    angular_frequency : ndarray, (n,)
        omega [rad/s], positive, rising.
    storage_shear, loss_shear : ndarray, (n,)
        G' and G'' [Pa], positive.
    poisson : float, optional
        nu [-].
    reading : str, optional
        How the file was read: the columns used, and the rows that were averaged.

    Raises
    ------
    InvalidInput
        If the rows differ in length, are too short, or have values that are not positive.

    Examples
    --------
    >>> omega = np.geomspace(0.1, 100.0, 31)
    >>> power = 1e3 * (1j * omega) ** 0.2
    >>> bool(DynamicData(omega, power.real, power.imag).series_error < 0.05)
    True
    """

    __words__ = words(reading=READING)

    angular_frequency: Annotated[Array, Numbers(POSITIVE, FEWEST_ROWS, MEASURED_TIMES, "rising"), SORT_ADVICE]
    storage_shear: Annotated[Array, Numbers(POSITIVE, FEWEST_ROWS, MEASURED_TIMES)]
    loss_shear: Annotated[Array, Numbers(POSITIVE, FEWEST_ROWS, MEASURED_TIMES)]
    poisson: PoissonRatio = 0.5
    reading: str = ""

    @property
    def _times(self) -> Array:
        return 1.0 / self.angular_frequency[::-1]

    @property
    def _fitted(self) -> tuple[RelaxationSeries, float]:
        return _of_dynamic(self)


def _spread(time: Array) -> Array:
    """Return times from a little before the data to a little after, evenly spaced in their logarithm."""
    decades = math.log10(time[-1] / time[0])
    return np.geomspace(0.3 * time[0], 3.0 * time[-1], math.ceil(PER_DECADE * (decades + 1.0)) + 1)


def _fit(columns: Array, targets: Array) -> tuple[Array, float]:
    """Return non-negative strengths of the columns, and the greatest relative misfit."""
    from scipy.optimize import nnls

    scaled = columns / targets[:, None]
    size = np.max(scaled, axis=0)
    terms, _ = nnls(scaled / size, np.ones(targets.size))
    strengths = np.where(terms > ROUNDING_RATIO, terms, 0.0) / size
    return strengths, float(np.max(np.abs(scaled @ strengths - 1.0)))


@functools.lru_cache(maxsize=64)
def _of_relaxation(data: RelaxationData) -> tuple[RelaxationSeries, float]:
    times = _spread(data.time)
    columns = np.exp(-data.time[:, None] / np.append(times, math.inf))
    strengths, error = _fit(columns, data.shear)
    return RelaxationSeries(float(strengths[-1]), 0.0, *merged(strengths[:-1], times)), error


@functools.lru_cache(maxsize=64)
def _of_creep(data: CreepData) -> tuple[RelaxationSeries, float]:
    times = _spread(data.time)
    t = data.time[:, None]
    columns = np.hstack([-np.expm1(-t / times), np.ones(t.shape), t])
    strengths, error = _fit(columns, data.compliance)
    series = CreepSeries(float(strengths[-2]), float(strengths[-1]), *merged(strengths[:-2], times))
    return of_creep(series), error


@functools.lru_cache(maxsize=64)
def _of_dynamic(data: DynamicData) -> tuple[RelaxationSeries, float]:
    times = _spread(1.0 / data.angular_frequency[::-1])
    turns = 1j * data.angular_frequency[:, None] * times
    level = np.ones((data.angular_frequency.size, 1))
    terms = np.hstack([turns / (1.0 + turns), level, 1j * data.angular_frequency[:, None]])
    columns = np.vstack([terms.real, terms.imag])
    strengths, error = _fit(columns, np.concatenate([data.storage_shear, data.loss_shear]))
    return RelaxationSeries(float(strengths[-2]), float(strengths[-1]), *merged(strengths[:-2], times)), error
