r"""The contract of a profile, and the base class of all shapes.

A profile is the axisymmetric gap :math:`f(r)` between the undeformed bodies, :math:`f(0)=0`.  The method of
dimensionality reduction replaces it by the equivalent plane profile

.. math:: g(x) = x \int_0^x \frac{f'(r)}{\sqrt{x^2-r^2}}\,\mathrm dr ,

which belongs to the shape alone as long as the medium is a homogeneous half-space.  A new shape is a frozen
value that subclasses `Shape` and gives `height`, `slope` and `curvature`; the transforms then follow by
spectrally accurate quadrature between the kinks.  Shapes with a closed form override `gap`, `gap_slope` and
`gap_integral`.  Profiles add up, and so do their transforms: the gap between two curved bodies, or a wave on a ball.
"""

from __future__ import annotations

import math
from typing import Protocol

from winkler.numerics.transforms import abel
from winkler.numerics.types import Array
from winkler.values.checks.contract import offered
from winkler.values.errors import InvalidInput
from winkler.values.validity import Note
from winkler.values.value import value

Kinks = tuple[tuple[float, float], ...]


@offered("a profile, such as Sphere or Cone")
class Profile(Protocol):
    """The contract of a body of revolution, written for its implementer.

    Lengths in [m].  `r` and `x` are arrays of radii, zero or positive and not beyond `reach`; results have their
    shape.  `kinks` lists ``(radius, jump)`` in ascending order: where f or one of its derivatives is not smooth,
    with the jump of the slope f' there (zero if only a higher derivative jumps).
    """

    @property
    def reach(self) -> float:
        """Radius up to which the shape is known [m]; infinite if everywhere."""

    @property
    def rim(self) -> float:
        """Radius of the first vertical wall [m], where the contact is pinned; infinite if there is none."""

    @property
    def size(self) -> float:
        """Radius of the body itself [m], against which the contact must be small; infinite if it has none."""

    @property
    def kinks(self) -> Kinks:
        """``(radius, jump of the slope)`` of every point where f is not smooth, ascending."""

    @property
    def rising(self) -> bool:
        """Whether g is known never to fall with x (a Laplacian of f that is nowhere negative suffices)."""

    @property
    def notes(self) -> tuple[Note, ...]:
        """What must be stated about the shape itself, e.g. that it stands for a pyramid or was smoothed."""

    def height(self, r: Array) -> Array:
        """f(r) [m]."""

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""

    def gap(self, x: Array) -> Array:
        """g(x) [m], the equivalent plane profile for a homogeneous half-space (theory T1)."""

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]; at a kink, the value just below it."""

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""


class Shape:
    """The part of `Profile` that follows from `height`, `slope` and `curvature`; subclass it for a new shape.

    ``a + b`` is the sum of two profiles: the gap between two curved bodies.
    """

    @property
    def reach(self) -> float:
        """Radius [m] up to which the profile is defined."""
        return math.inf

    @property
    def rim(self) -> float:
        """Radius of the first vertical wall [m]."""
        return math.inf

    @property
    def size(self) -> float:
        """Radius of the body itself [m]."""
        return math.inf

    @property
    def kinks(self) -> Kinks:
        """``(radius, jump of the slope)``, ascending."""
        return ()

    @property
    def rising(self) -> bool:
        """Whether g is known to increase with x everywhere; otherwise the solver checks it."""
        return False

    @property
    def notes(self) -> tuple[Note, ...]:
        """Validity notes about the shape."""
        return ()

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        raise NotImplementedError(f"{type(self).__name__} must give height(r).")

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""
        raise NotImplementedError(f"{type(self).__name__} must give slope(r).")

    def curvature(self, r: Array) -> Array:
        """f''(r) [1/m]."""
        raise NotImplementedError(f"{type(self).__name__} must give curvature(r), or gap_slope(x) itself.")

    def gap(self, x: Array) -> Array:
        """g(x) [m], the equivalent plane profile (T1)."""
        return abel.gap(self.slope, self._edges, x)

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        return abel.gap_slope(self.slope, self.curvature, self.kinks, x)

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2], by T7: of f r / sqrt(x^2 - r^2)."""
        return abel.gap_integral(self.height, self._edges, x)

    @property
    def _edges(self) -> tuple[float, ...]:
        return tuple(radius for radius, _ in self.kinks)

    def __add__(self, other: Profile) -> Sum:
        """Return the profile whose height is the sum of both."""
        return Sum((self, other))


class RisingShape(Shape):
    """A shape whose g rises everywhere."""

    rising = True
    """g rises everywhere."""


@value
class Sum(Shape):
    """The sum of profiles, written ``a + b``.

    Parameters
    ----------
    parts : tuple of Profile
        At least one.
    """

    parts: tuple[Profile, ...]

    def __post_init__(self) -> None:
        if not self.parts:
            raise InvalidInput("Sum: no parts were given; give at least one profile.")
        flat = [part.parts if isinstance(part, Sum) else (part,) for part in self.parts]
        object.__setattr__(self, "parts", tuple(part for parts in flat for part in parts))

    @property
    def reach(self) -> float:
        """The shortest of the parts [m]."""
        return min(part.reach for part in self.parts)

    @property
    def rim(self) -> float:
        """The innermost of the parts [m]."""
        return min(part.rim for part in self.parts)

    @property
    def size(self) -> float:
        """The smallest of the parts [m]."""
        return min(part.size for part in self.parts)

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """Those of all parts, jumps added."""
        jumps: dict[float, float] = {}
        for part in self.parts:
            for b, jump in part.kinks:
                jumps[b] = jumps.get(b, 0.0) + jump
        return tuple(sorted(jumps.items()))

    @property
    def rising(self) -> bool:
        """Whether g rises everywhere for every part."""
        return all(part.rising for part in self.parts)

    @property
    def notes(self) -> tuple[Note, ...]:
        """Those of all parts."""
        return tuple(note for part in self.parts for note in part.notes)

    def height(self, r: Array) -> Array:
        """f(r) [m]."""
        return self._total([part.height(r) for part in self.parts])

    def slope(self, r: Array) -> Array:
        """f'(r) [-]."""
        return self._total([part.slope(r) for part in self.parts])

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        return self._total([part.gap(x) for part in self.parts])

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        return self._total([part.gap_slope(x) for part in self.parts])

    def gap_integral(self, x: Array) -> Array:
        """The integral of g from 0 to x [m^2]."""
        return self._total([part.gap_integral(x) for part in self.parts])

    @staticmethod
    def _total(terms: list[Array]) -> Array:
        total = terms[0]
        for term in terms[1:]:
            total = total + term
        return total
