"""Sums of profiles: the gap between two curved bodies, or a wave on a ball.  The transform is linear."""

from __future__ import annotations

from winkler.errors import InvalidInput
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile, Shape
from winkler.validity import Note
from winkler.values import value

__all__ = ["Sum"]


@value
class Sum(Shape):
    """The profile whose height is the sum of its parts; written ``a + b``.

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
        """Known if it is known of every part."""
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
