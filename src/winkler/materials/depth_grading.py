r"""Bodies whose stiffness changes with depth and settles far below: exponential, sigmoidal and tabulated gradings.

They state Young's modulus E(z) and Poisson's ratio at any depth below the surface, and how deep one must go until
nothing changes any more.
"""

from __future__ import annotations

import math
from typing import Annotated, Protocol

import numpy as np

from winkler.numerics.caching import rounded
from winkler.numerics.types import Array
from winkler.values.checks.contract import offered
from winkler.values.checks.number_checks import (
    NON_NEGATIVE,
    POISSON,
    POSITIVE,
    Advice,
    Numbers,
    PoissonRatio,
    Positive,
    PositiveNotTiny,
)
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words


@offered("a grading: ExponentialGrading, SigmoidalGrading or TabulatedGrading")
class DepthGrading(Protocol):
    """What a graded half-space must state, written for its implementer."""

    @property
    def breaks(self) -> tuple[float, ...]:
        """Depths [m] at which E or nu is not smooth, ascending."""

    @property
    def finest(self) -> float:
        """Depth [m] over which E changes most quickly."""

    def young_at(self, z: Array) -> Array:
        """E(z) [Pa]."""

    def poisson_at(self, z: Array) -> Array:
        """nu(z) [-]."""

    def settled_at(self, tolerance: float) -> float:
        """Depth [m] below which E differs from its last value by less than this part."""


class _SmoothGrading:
    """E goes over from one value at the surface to another far below; nu is the same everywhere."""

    surface_young: float
    deep_young: float
    poisson: float

    breaks = ()
    """None."""

    def poisson_at(self, z: Array) -> Array:
        """nu [-]."""
        return np.full(np.shape(z), self.poisson)

    def _lengths_to(self, tolerance: float) -> float:
        """Return after how many lengths of its exponential the difference is less than this part."""
        excess = abs(self.surface_young / self.deep_young - 1.0) / tolerance
        return math.log(max(excess, math.e))


@value
class ExponentialGrading(_SmoothGrading):
    """An exponential grading, E(z) = deep + (surface - deep) exp(-z / depth_scale).

    Parameters
    ----------
    surface_young, deep_young : float
        Young's modulus at the surface and far below [Pa].
    depth_scale : float
        Depth over which the difference from `deep_young` falls to 1/e [m].
    poisson : float
        Poisson's ratio [-], the same at every depth.
    """

    __words__ = words(depth_scale=("c_0", "m", "depth over which the difference of moduli falls to 1/e"))

    surface_young: PositiveNotTiny
    deep_young: PositiveNotTiny
    depth_scale: PositiveNotTiny
    poisson: PoissonRatio

    @property
    def finest(self) -> float:
        """Depth over which E changes most quickly [m]."""
        return self.depth_scale * min(1.0, self.surface_young / self.deep_young)

    def young_at(self, z: Array) -> Array:
        """E(z) [Pa]."""
        return self.deep_young + (self.surface_young - self.deep_young) * np.exp(-np.asarray(z) / self.depth_scale)

    def settled_at(self, tolerance: float) -> float:
        """Depth below which E is constant within rounding [m]."""
        return self.depth_scale * self._lengths_to(tolerance)

    def in_units(self, modulus: float, length: float) -> ExponentialGrading:
        """Return the same grading in units of a modulus [Pa] and a length [m]."""
        surface, deep = rounded(self.surface_young / modulus), rounded(self.deep_young / modulus)
        return ExponentialGrading(surface, deep, rounded(self.depth_scale / length), self.poisson)


@value
class SigmoidalGrading(_SmoothGrading):
    """A smooth step: E(z) goes over from surface to deep like a logistic curve.

    Parameters
    ----------
    surface_young, deep_young : float
        Young's modulus above and far below the transition [Pa]; at its middle E is their mean.
    transition_depth : float
        Depth of the middle of the transition [m].
    transition_width : float
        E = surface + (deep - surface) / (1 + exp(-(z - depth) / width)) [m].
    poisson : float
        Poisson's ratio [-], the same at every depth.
    """

    surface_young: PositiveNotTiny
    deep_young: PositiveNotTiny
    transition_depth: Positive
    transition_width: PositiveNotTiny
    poisson: PoissonRatio

    @property
    def finest(self) -> float:
        """Depth over which E changes most quickly [m]."""
        ratio = min(self.surface_young, self.deep_young) / max(self.surface_young, self.deep_young)
        return self.transition_width * min(1.0, 4.0 * math.sqrt(ratio))

    def young_at(self, z: Array) -> Array:
        """E(z) [Pa]."""
        step = 0.5 * (1.0 + np.tanh(0.5 * (np.asarray(z) - self.transition_depth) / self.transition_width))
        return np.asarray(self.surface_young + (self.deep_young - self.surface_young) * step)

    def settled_at(self, tolerance: float) -> float:
        """Depth below which E is constant within rounding [m]."""
        return self.transition_depth + self.transition_width * self._lengths_to(tolerance)

    def in_units(self, modulus: float, length: float) -> SigmoidalGrading:
        """Return the same grading in units of a modulus [Pa] and a length [m]."""
        surface, deep = rounded(self.surface_young / modulus), rounded(self.deep_young / modulus)
        depth, width = rounded(self.transition_depth / length), rounded(self.transition_width / length)
        return SigmoidalGrading(surface, deep, depth, width, self.poisson)


@value
class TabulatedGrading:
    """E and nu at given depths, linear in between and constant below the last.

    Parameters
    ----------
    depths : array_like, (n,)
        From 0 at the surface, ascending [m], at least two.
    youngs : array_like, (n,)
        E there [Pa], positive.
    poissons : array_like, (n,)
        nu there [-].

    Raises
    ------
    InvalidInput
        If the columns do not fit together.
    """

    depths: Annotated[Array, Numbers(NON_NEGATIVE, fewest=2, order="rising"), Advice("begin with 0, sort the table")]
    youngs: Annotated[Array, Numbers(POSITIVE, fewest=2)]
    poissons: Annotated[Array, Numbers(POISSON, fewest=2)]

    def __post_init__(self) -> None:
        sizes = self.depths.size, self.youngs.size, self.poissons.size
        if len(set(sizes)) != 1:
            raise InvalidInput(
                f"TabulatedGrading: there are {sizes[0]} depths, {sizes[1]} youngs and {sizes[2]} poissons; give three "
                "arrays of one length, at least two."
            )
        if self.depths[0] != 0.0:
            raise InvalidInput("TabulatedGrading: depths must begin with 0 and ascend; sort the table.")

    @property
    def breaks(self) -> tuple[float, ...]:
        """The depths of the table below the surface."""
        return tuple(float(z) for z in self.depths[1:])

    @property
    def finest(self) -> float:
        """Depth over which E changes most quickly [m]."""
        rate = np.max(np.abs(np.diff(np.log(self.youngs))) / np.diff(self.depths))
        return float(min(1.0 / rate if rate > 0.0 else math.inf, self.depths[-1]))

    def young_at(self, z: Array) -> Array:
        """E(z) [Pa]."""
        return np.interp(z, self.depths, self.youngs)

    def poisson_at(self, z: Array) -> Array:
        """nu(z) [-]."""
        return np.interp(z, self.depths, self.poissons)

    def settled_at(self, tolerance: float) -> float:
        """The last depth of the table [m]."""
        return float(self.depths[-1])

    def in_units(self, modulus: float, length: float) -> TabulatedGrading:
        """Return the same grading in units of a modulus [Pa] and a length [m]."""
        depths = np.array([rounded(depth / length) for depth in self.depths.tolist()])
        youngs = np.array([rounded(young / modulus) for young in self.youngs.tolist()])
        return TabulatedGrading(depths, youngs, self.poissons)
