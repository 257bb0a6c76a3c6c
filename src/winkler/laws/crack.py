r"""Rate-dependent work of adhesion: the energy that opens a crack along rubber rises with the speed of the crack.

The loss happens near the tip, where everything is fast, and is described by a work of opening that depends on the
speed,

.. math:: w(v) = w_0\left[1 + (v/v_0)^n\right] .

It tends to the work of adhesion of the surfaces, :math:`w_0`, when slow; rubbers have n between 0.1 and 0.8, often 0.6,
and :math:`v_0` rises with the temperature as their relaxation times fall.  A very fast crack finds a glass all around
it, and the work stays below :math:`w_\infty`, at most :math:`w_0` times the glassy over the relaxed modulus,

.. math:: w(v) = w_0 + (w_\infty - w_0)\,\frac{(v/v_0)^n}{1 + (v/v_0)^n} .
"""

from __future__ import annotations

from typing import Annotated

import numpy as np

from winkler.numerics.types import Array, ArrayLike
from winkler.values.checks.number_checks import Number, Positive
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

SMALLEST_EXPONENT = 1e-3
"""Of the exponents: below it the speed is zero or beyond all floating-point numbers, at works that hardly differ."""


EXPONENT_RANGE = Number(f"it must be a number from {SMALLEST_EXPONENT:g} to 1", SMALLEST_EXPONENT, 1.0)


@value
class RateDependentWork:
    """A work of opening that grows with a power of the crack speed (Gent and Schultz).

    Parameters
    ----------
    work : float
        w_0 [J/m^2] of slow opening, and of closing; positive.
    reference_speed : float
        v_0 [m/s], at which the work of opening is twice that at rest; positive.
    exponent : float
        n [-], from 0.001 to 1.

    Raises
    ------
    InvalidInput
        If a number is outside its range.

    References
    ----------
    A. N. Gent, J. Schultz, J. Adhesion 3 (1972) 281-294; D. Maugis, M. Barquins, J. Phys. D: Appl. Phys. 11 (1978)
    1989-2023, doi:10.1088/0022-3727/11/14/011

    Examples
    --------
    >>> law = RateDependentWork(work=0.05, reference_speed=1e-6, exponent=0.6)
    >>> law.opening([0.0, 1e-6, 1e-5]).round(4)
    array([0.05  , 0.1   , 0.2491])
    """

    __words__ = words(
        work=("w_0", "J/m^2", "work of slow opening, and of closing, per area"),
        exponent=("n", "", "exponent of the speed in the work of opening"),
    )

    work: Positive
    reference_speed: Positive
    exponent: Annotated[float, EXPONENT_RANGE]

    def opening(self, speed: ArrayLike) -> Array:
        """Return the work of opening w(v) [J/m^2] at speeds [m/s], not negative."""
        v = np.asarray(speed, dtype=float)
        return np.asarray(self.work * (1.0 + (v / self.reference_speed) ** self.exponent))

    def speed(self, release: ArrayLike) -> Array:
        """Return the crack speed [m/s] at energy release rates [J/m^2]; it is zero below w_0."""
        excess = np.maximum(np.asarray(release, dtype=float) / self.work - 1.0, 0.0)
        with np.errstate(over="ignore"):  # beyond all numbers it is infinite
            return np.asarray(self.reference_speed * excess ** (1.0 / self.exponent))


@value
class SaturatingWork:
    """A work of opening that grows with the crack speed up to a limit.

    The limits are those of a crack in a linear viscoelastic body; the form between them is an assumption.

    Parameters
    ----------
    work : float
        w_0 [J/m^2] of slow opening, and of closing; positive.
    fast_work : float
        w_inf [J/m^2], the limit for fast opening, more than `work`; a crack with a larger driving energy jumps.
    reference_speed : float
        v_0 [m/s], at which the work of opening is the mean of both limits; positive.
    exponent : float
        n [-], from 0.001 to 1.

    Raises
    ------
    InvalidInput
        If a number is outside its range.

    References
    ----------
    J. A. Greenwood, K. L. Johnson, Phil. Mag. A 43 (1981) 697-711

    Examples
    --------
    >>> law = SaturatingWork(work=0.05, fast_work=1.05, reference_speed=1e-3, exponent=0.5)
    >>> law.opening([0.0, 1e-3, 1e9]).round(4)
    array([0.05, 0.55, 1.05])
    """

    __words__ = RateDependentWork.__words__

    work: Positive
    fast_work: Positive
    reference_speed: Positive
    exponent: Annotated[float, EXPONENT_RANGE]

    def __post_init__(self) -> None:
        if self.fast_work <= self.work:
            raise InvalidInput(
                f"SaturatingWork: fast_work ({self.fast_work!r} J/m^2) is not above work ({self.work!r}); fast opening "
                "needs more than slow opening: give more, or use ShortRange."
            )

    def opening(self, speed: ArrayLike) -> Array:
        """Return the work of opening w(v) [J/m^2] at speeds [m/s], not negative."""
        ratio = (np.asarray(speed, dtype=float) / self.reference_speed) ** self.exponent
        return np.asarray(self.work + (self.fast_work - self.work) * ratio / (1.0 + ratio))

    def speed(self, release: ArrayLike) -> Array:
        """Return the crack speed [m/s] at energy release rates [J/m^2].

        It is zero below w_0 and infinite from w_inf on.
        """
        releases = np.asarray(release, dtype=float)
        excess, missing = np.maximum(releases - self.work, 0.0), np.maximum(self.fast_work - releases, 0.0)
        held = missing > 0.0
        ratio = np.where(held, excess / np.where(held, missing, 1.0), np.inf)
        with np.errstate(over="ignore"):  # beyond all numbers it is infinite
            return np.asarray(self.reference_speed * ratio ** (1.0 / self.exponent))


CrackLaw = RateDependentWork | SaturatingWork
"""What opening takes, at which speed."""
