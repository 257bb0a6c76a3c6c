r"""Bodies whose stiffness changes with depth and settles far below: exponential, sigmoidal and tabulated gradings.

They tell Young's modulus E(z) and Poisson's ratio at any depth below the surface, and how deep one must go until
nothing changes any more.
"""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np

from winkler.errors import InvalidInput
from winkler.given import poisson_ratio, positive_fields
from winkler.numerics.types import Array
from winkler.values import frozen_array, value

__all__ = ["DepthGrading", "ExponentialGrading", "SigmoidalGrading", "TabulatedGrading"]


class DepthGrading(Protocol):
    """What a graded half-space must tell, spoken to its implementer."""

    @property
    def breaks(self) -> tuple[float, ...]:
        """Depths [m] at which E or nu is not smooth, ascending."""
        ...

    @property
    def finest(self) -> float:
        """Depth [m] over which E changes most quickly."""
        ...

    def young_at(self, z: Array) -> Array:
        """E(z) [Pa]."""
        ...

    def poisson_at(self, z: Array) -> Array:
        """nu(z) [-]."""
        ...

    def settled_at(self, tolerance: float) -> float:
        """Depth [m] below which E differs from its last value by less than this part."""
        ...


@value
class ExponentialGrading:
    """E(z) = deep + (surface - deep) exp(-z / depth_scale).

    Parameters
    ----------
    surface_young, deep_young : float
        At the surface and far below [Pa].
    depth_scale : float
        Over which the difference falls to 1/e [m].
    poisson : float
        The same everywhere [-].
    """

    surface_young: float
    deep_young: float
    depth_scale: float
    poisson: float

    def __post_init__(self) -> None:
        positive_fields(self, surface_young="Pa", deep_young="Pa", depth_scale="m")
        poisson_ratio("ExponentialGrading", self.poisson)

    @property
    def breaks(self) -> tuple[float, ...]:
        """None."""
        return ()

    @property
    def finest(self) -> float:
        """Depth over which E changes most quickly [m]."""
        return self.depth_scale * min(1.0, self.surface_young / self.deep_young)

    def young_at(self, z: Array) -> Array:
        """E(z) [Pa]."""
        return self.deep_young + (self.surface_young - self.deep_young) * np.exp(-np.asarray(z) / self.depth_scale)

    def poisson_at(self, z: Array) -> Array:
        """nu [-]."""
        return np.full(np.shape(z), self.poisson)

    def settled_at(self, tolerance: float) -> float:
        """Depth below which E is settled [m]."""
        excess = abs(self.surface_young / self.deep_young - 1.0) / tolerance
        return self.depth_scale * math.log(max(excess, math.e))


@value
class SigmoidalGrading:
    """A smooth step: E(z) goes over from surface to deep like a logistic curve.

    Parameters
    ----------
    surface_young, deep_young : float
        Above and far below the transition [Pa]; E = their mean at its middle.
    transition_depth : float
        Of the middle of the transition [m].
    transition_width : float
        E = surface + (deep - surface) / (1 + exp(-(z - depth) / width)) [m].
    poisson : float
        The same everywhere [-].
    """

    surface_young: float
    deep_young: float
    transition_depth: float
    transition_width: float
    poisson: float

    def __post_init__(self) -> None:
        positive_fields(self, surface_young="Pa", deep_young="Pa", transition_depth="m", transition_width="m")
        poisson_ratio("SigmoidalGrading", self.poisson)

    @property
    def breaks(self) -> tuple[float, ...]:
        """None."""
        return ()

    @property
    def finest(self) -> float:
        """Depth over which E changes most quickly [m]."""
        ratio = min(self.surface_young, self.deep_young) / max(self.surface_young, self.deep_young)
        return self.transition_width * min(1.0, 4.0 * math.sqrt(ratio))

    def young_at(self, z: Array) -> Array:
        """E(z) [Pa]."""
        step = 0.5 * (1.0 + np.tanh(0.5 * (np.asarray(z) - self.transition_depth) / self.transition_width))
        return np.asarray(self.surface_young + (self.deep_young - self.surface_young) * step)

    def poisson_at(self, z: Array) -> Array:
        """nu [-]."""
        return np.full(np.shape(z), self.poisson)

    def settled_at(self, tolerance: float) -> float:
        """Depth below which E is settled [m]."""
        excess = abs(self.surface_young / self.deep_young - 1.0) / tolerance
        return self.transition_depth + self.transition_width * math.log(max(excess, math.e))


@value
class TabulatedGrading:
    """E and nu measured at depths, straight lines in between, constant below the last.

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

    depths: Array
    youngs: Array
    poissons: Array

    def __post_init__(self) -> None:
        for word in ("depths", "youngs", "poissons"):
            try:
                column = frozen_array(np.asarray(getattr(self, word), dtype=float))
            except (TypeError, ValueError):
                raise InvalidInput(f"TabulatedGrading: {word} is no table of numbers; give an array.") from None
            object.__setattr__(self, word, column)
        sizes = {word: np.shape(getattr(self, word)) for word in ("depths", "youngs", "poissons")}
        if len(set(sizes.values())) != 1 or len(sizes["depths"]) != 1 or sizes["depths"][0] < 2:
            raise InvalidInput(
                f"TabulatedGrading: depths, youngs and poissons have the shapes {', '.join(map(str, sizes.values()))}; "
                "give three arrays of one length, at least two."
            )
        if not (self.depths[0] == 0.0 and np.all(np.diff(self.depths) > 0.0) and np.all(np.isfinite(self.depths))):
            raise InvalidInput("TabulatedGrading: depths must begin with 0 and ascend; sort the table.")
        if not (np.all(self.youngs > 0.0) and np.all(np.isfinite(self.youngs))):
            raise InvalidInput("TabulatedGrading: youngs must be positive and finite, in Pa.")
        if not np.all((self.poissons > -1.0) & (self.poissons <= 0.5)):
            raise InvalidInput("TabulatedGrading: poissons must be above -1 and at most 0.5.")

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
