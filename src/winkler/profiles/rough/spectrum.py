r"""Power spectra of isotropic rough surfaces: the density of the roughness over the wave number.

.. math:: C(q) = \frac{1}{(2\pi)^2}\int\langle h(\mathbf x)\,h(\mathbf 0)\rangle\,e^{-i\mathbf q\mathbf x}
          \,\mathrm d^2x , \qquad \langle h^2\rangle = 2\pi\int C\,q\,\mathrm dq , \quad
          \langle|\nabla h|^2\rangle = 2\pi\int C\,q^3\,\mathrm dq .

T. D. B. Jacobs, T. Junge, L. Pastewka, Surf. Topogr.: Metrol. Prop. 5 (2017) 013001, doi:10.1088/2051-672X/aa51f8, on
the measurement of spectra and its errors; their C is (2 pi)^2 times this one.
"""

from __future__ import annotations

import math
from typing import Annotated, Protocol

import numpy as np

from winkler.numerics.types import Array
from winkler.values.checks.contract import offered
from winkler.values.checks.number_checks import POSITIVE, Number, Numbers, Positive, PositiveOrInfinite
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

POINTS_PER_DECADE = 20
"""Bins of a measured spectrum, equal on a logarithmic axis."""


@offered("a spectrum: SelfAffine or PowerSpectrum")
class Spectrum(Protocol):
    """The contract of a spectrum, written for its implementer."""

    @property
    def smallest(self) -> float:
        """Wave number q [rad/m] below which there is nothing."""

    @property
    def greatest(self) -> float:
        """Wave number q [rad/m] above which there is nothing."""

    @property
    def rms_height(self) -> float:
        """Root mean square height [m]."""

    @property
    def rms_slope(self) -> float:
        """Root mean square gradient [-]."""

    def at(self, wave_number: Array) -> Array:
        """C(q) [m^4], zero outside."""


@value
class SelfAffine:
    """The spectrum of a self-affine surface: C(q) is proportional to q^(-2 (H + 1)), and constant below the roll-off.

    Parameters
    ----------
    hurst : float
        H [-], between 0 and 1.
    rms_height : float
        Root mean square height [m].
    longest : float
        Longest wavelength [m].
    shortest : float
        Shortest wavelength [m].
    roll_off : float, optional
        Wavelength [m] above which the spectrum is level; the longest one by default.

    Raises
    ------
    InvalidInput
        If a number is out of range, or the wavelengths are not in order.

    Examples
    --------
    >>> blasted = SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=1e-6, roll_off=1e-4)
    >>> round(blasted.rms_slope, 2)
    0.22
    """

    __words__ = words(
        longest=(r"\lambda_\mathrm{max}", "m", "longest wavelength"),
        shortest=(r"\lambda_\mathrm{min}", "m", "shortest wavelength"),
    )

    hurst: Annotated[float, Number("give a number above 0 and at most 1", 0.0, 1.0, (0.0,))]
    rms_height: Positive
    longest: Positive
    shortest: Positive
    roll_off: PositiveOrInfinite = math.inf

    def __post_init__(self) -> None:
        if not self.shortest < min(self.roll_off, self.longest):
            raise InvalidInput(
                f"SelfAffine: the wavelengths are not in order; give shortest ({self.shortest:.6g} m) below roll_off "
                f"({self.roll_off:.6g} m) and longest ({self.longest:.6g} m)."
            )

    @property
    def smallest(self) -> float:
        """2 pi over the longest wavelength [rad/m]."""
        return 2.0 * math.pi / self.longest

    @property
    def greatest(self) -> float:
        """2 pi over the shortest wavelength [rad/m]."""
        return 2.0 * math.pi / self.shortest

    @property
    def rms_slope(self) -> float:
        """Root mean square gradient [-]."""
        bend, density = self._level
        steep = 2.0 - 2.0 * self.hurst
        ratio = math.log(self.greatest / bend)
        falling = math.expm1(steep * ratio) / steep if steep > 0.0 else ratio
        level = 0.25 * (1.0 - (self.smallest / bend) ** 4)
        return math.sqrt(2.0 * math.pi * density * (level + falling)) * bend**2

    @property
    def _level(self) -> tuple[float, float]:
        """Where the level part ends [rad/m], and its density [m^4]."""
        bend = 2.0 * math.pi / min(self.roll_off, self.longest)
        ratio = math.log(self.greatest / bend)
        # mean square height under C = 1 on the level part, then under the falling part
        level = math.pi * (bend**2 - self.smallest**2)
        falling = -math.pi * bend**2 * math.expm1(-2.0 * self.hurst * ratio) / self.hurst
        return bend, self.rms_height**2 / (level + falling)

    def at(self, wave_number: Array) -> Array:
        """Return C(q) [m^4], zero outside."""
        q = np.asarray(wave_number, dtype=float)
        bend, density = self._level
        inside = (q >= self.smallest * (1.0 - 1e-12)) & (q <= self.greatest * (1.0 + 1e-12))
        return np.where(inside, density * np.maximum(q / bend, 1.0) ** (-2.0 * (self.hurst + 1.0)), 0.0)


@value
class PowerSpectrum:
    """A power spectrum given at points, with power laws between them.

    Parameters
    ----------
    wave_numbers : array_like, (n,)
        q [rad/m], positive and rising.
    densities : array_like, (n,)
        C(q) [m^4], positive.

    Raises
    ------
    InvalidInput
        If they do not fit one another, do not rise, or are not positive.
    """

    wave_numbers: Annotated[Array, Numbers(POSITIVE, fewest=2, order="rising")]
    densities: Annotated[Array, Numbers(POSITIVE, fewest=2)]

    def __post_init__(self) -> None:
        if self.wave_numbers.size != self.densities.size:
            raise InvalidInput(
                f"PowerSpectrum: there are {self.wave_numbers.size} wave_numbers and {self.densities.size} densities; "
                "give as many of each."
            )

    @property
    def smallest(self) -> float:
        """The first wave number [rad/m]."""
        return float(self.wave_numbers[0])

    @property
    def greatest(self) -> float:
        """The last wave number [rad/m]."""
        return float(self.wave_numbers[-1])

    @property
    def rms_height(self) -> float:
        """Root mean square height [m]."""
        return math.sqrt(self._mean_square(0))

    @property
    def rms_slope(self) -> float:
        """Root mean square gradient [-]."""
        return math.sqrt(self._mean_square(2))

    def _mean_square(self, power: int) -> float:
        """Return 2 pi times the integral of q^(1 + power) C(q), which is a power of q between the numbers."""
        steps = np.log1p(np.diff(self.wave_numbers) / self.wave_numbers[:-1])  # not a difference of two logarithms
        rise = (2 + power) * steps + np.diff(np.log(self.densities))
        parts = self.wave_numbers[:-1] ** (2 + power) * self.densities[:-1] * steps
        small = np.abs(rise) < 1e-8
        return float(2.0 * np.pi * np.sum(parts * np.where(small, 1.0, np.expm1(rise) / np.where(small, 1.0, rise))))

    def at(self, wave_number: Array) -> Array:
        """Return C(q) [m^4], zero outside."""
        q = np.asarray(wave_number, dtype=float)
        inside = (q >= self.smallest * (1.0 - 1e-12)) & (q <= self.greatest * (1.0 + 1e-12))
        logs = np.interp(np.log(np.where(inside, q, self.smallest)), np.log(self.wave_numbers), np.log(self.densities))
        return np.where(inside, np.exp(logs), 0.0)

    def joined(self, other: PowerSpectrum) -> PowerSpectrum:
        """Return this spectrum joined with that of another instrument; in the common range it is a mean.

        Raises
        ------
        InvalidInput
            If the other one is no PowerSpectrum.
        """
        if not isinstance(other, PowerSpectrum):
            raise InvalidInput(f"PowerSpectrum: joined is given a {type(other).__name__}; give another PowerSpectrum.")
        q = np.unique(np.concatenate([self.wave_numbers, other.wave_numbers]))
        first, second = self._weight(q), other._weight(q)
        own, others = np.log(np.maximum(self.at(q), 1e-300)), np.log(np.maximum(other.at(q), 1e-300))
        finite = first + second > 0.0
        q, first, second, own, others = (part[finite] for part in (q, first, second, own, others))
        return PowerSpectrum(q, np.exp((first * own + second * others) / (first + second)))

    def _weight(self, q: Array) -> Array:
        """Return how far inside the measured range a wave number lies, zero outside."""
        low, high, place = math.log(self.smallest), math.log(self.greatest), np.log(q)
        inside = (place >= low - 1e-12) & (place <= high + 1e-12)
        return np.where(inside, np.minimum(place - low, high - place) / (high - low) + 1e-6, 0.0)


def wave_numbers_for(spectrum: Spectrum, count: int, crowded: float = 1.0) -> Array:
    """Return wave numbers [rad/m] for sums over a spectrum: all of a measured one, and so many over its range.

    Parameters
    ----------
    spectrum : Spectrum
    count : int
        How many, even on a logarithmic axis.
    crowded : float, optional
        Power by which they crowd towards the smallest one.
    """
    low, high = math.log(spectrum.smallest), math.log(spectrum.greatest)
    even = np.exp(low + (high - low) * np.linspace(0.0, 1.0, count) ** crowded)
    if not isinstance(spectrum, PowerSpectrum):
        return np.asarray(even)
    inside = even[(even > spectrum.smallest) & (even < spectrum.greatest)]
    return np.union1d(inside, spectrum.wave_numbers)
