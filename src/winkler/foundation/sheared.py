r"""The springs of a sheared contact: their displacements along the surface.

Distinguished by the depth :math:`\gamma=g(x)` at which they touch, springs of one kind are stretched by

.. math:: u_t(\gamma) = \sum_j B_j\,(\gamma_j-\gamma)_+ + \sum_j J_j\,[\gamma<\gamma_j] .

Each ramp is the pressed contact of an earlier depth :math:`\gamma_j`, each step a flat punch of its radius: the
traction is a sum of pressures (Ciavarella, Jaeger).
"""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings
from winkler.media.medium import Displacement
from winkler.numerics.types import Array, Quantity
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words


@value
class ShearRamps:
    """Springs stretched by ramps, one component along the surface: a `Displacement`, with an edge at the last radius.

    Parameters
    ----------
    bed : Bed
    radii : ndarray, (m,)
        Contact radii at the depths [m], ascending.
    depths : ndarray, (m,)
        gamma_j [m].
    slopes : ndarray, (m,)
        B_j [-].
    jump : float
        Step at the last radius [m].
    """

    __words__ = words(
        depths=(r"\gamma_j", "m", "depths at which ramps of the springs' displacement end"),
        radii=("x_j", "m", "contact radii at these depths"),
        slopes=("B_j", "", "slopes of the ramps"),
        jump=("J", "m", "step at the last radius"),
    )

    bed: Bed
    radii: Array
    depths: Array
    slopes: Array
    jump: float

    @property
    def radius(self) -> float:
        """Where the stretched springs end [m]."""
        return float(self.radii[-1])

    def _sums(self, x: Array) -> tuple[Array, Array]:
        """Return the sums of B_j and of B_j gamma_j over the ramps that reach beyond x, or end where all do."""
        inner = self.radii < self.radius
        place = np.searchsorted(self.radii[inner], x, side="right")
        many = np.append(np.cumsum(self.slopes[::-1])[::-1], 0.0)
        deep = np.append(np.cumsum((self.slopes * self.depths)[::-1])[::-1], 0.0)
        return many[place], deep[place]

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """``(x, strength)``: those of the bed, and where ramps end."""
        own = {b: strength for b, strength in self.bed.kinks if b < self.radius}
        for b in self.radii[:-1]:
            if 0.0 < b < self.radius:
                own.setdefault(float(b), 0.0)
        places = sorted(own)
        many, _ = self._sums(np.array(places))
        return tuple((b, own[b] * float(part)) for b, part in zip(places, many, strict=True))

    @property
    def edge(self) -> float:
        """u_t(a-) [m]; exactly the step where the contact closes smoothly."""
        if self.radius < self.bed.rim:
            return self.jump
        return float(self.value(np.array([self.radius]))[0])

    def value(self, x: Array) -> Array:
        """u_t(x) [m]."""
        many, deep = self._sums(x)
        return np.asarray(deep - many * self.bed.gap(x) + self.jump)

    def slope(self, x: Array) -> Array:
        """u_t'(x) [-]."""
        many, _ = self._sums(x)
        return np.asarray(-many * self.bed.gap_slope(x))


@value
class ShearStep:
    """A flat punch of springs, all stretched alike: a `Displacement`.

    Parameters
    ----------
    radius : float
        [m].
    edge : float
        u_t [m].
    """

    __words__ = words(edge=("u_t", "m", "how far the springs are stretched"))

    radius: float
    edge: float

    kinks = ()
    """None."""

    def value(self, x: Array) -> Array:
        """u_t(x) [m]."""
        return np.full(np.shape(x), self.edge)

    def slope(self, x: Array) -> Array:
        """u_t'(x) = 0 [-]."""
        return np.zeros(np.shape(x))


@value
class ShearedSprings:
    """The springs of a contact that is pressed and moved along the surface.

    Parameters
    ----------
    pressed : PressedSprings
        Across the surface.
    mindlin_ratio : float
        c_T/c_N [-], the same for all springs.
    shift : float or ndarray, (2,)
        u_x [m], in the plane ``(u_x, u_y)``: how far the bodies are moved against each other.
    depths : ndarray, (m,)
        gamma_j [m], ascending, the last one not beyond that of the contact.
    radii : ndarray, (m,)
        Contact radii at these depths [m].
    slopes : ndarray, (m,) or (m, 2)
        B_j [-].
    steps : ndarray, (m,) or (m, 2)
        J_j [m].

    Raises
    ------
    InvalidInput
        If the shapes do not fit.
    """

    __words__ = words(
        depths=(r"\gamma_j", "m", "depths at which ramps of the springs' displacement end"),
        radii=("x_j", "m", "contact radii at these depths"),
        slopes=("B_j", "", "slopes of the ramps"),
        steps=("J_j", "m", "steps of the springs' displacement"),
    )

    pressed: PressedSprings
    mindlin_ratio: float
    shift: Quantity
    depths: Array
    radii: Array
    slopes: Array
    steps: Array

    def __post_init__(self) -> None:
        shape = (self.depths.size, *np.shape(self.shift))
        if self.radii.shape != self.depths.shape or self.slopes.shape != shape or self.steps.shape != shape:
            raise InvalidInput(
                f"ShearedSprings: {self.depths.size} depths and a shift of shape {np.shape(self.shift)} go with as "
                f"many radii, and slopes and steps of shape {shape}; given are {self.radii.shape}, "
                f"{self.slopes.shape} and {self.steps.shape}."
            )

    @property
    def in_plane(self) -> bool:
        """Whether the shift has two components."""
        return np.ndim(self.shift) == 1

    @property
    def components(self) -> tuple[tuple[Displacement, ...], ...]:
        """What is to be superposed, for every component of the shift."""
        if not self.in_plane:
            return (self._parts(self.slopes, self.steps),)
        return tuple(self._parts(self.slopes[:, i], self.steps[:, i]) for i in range(2))

    def _parts(self, slopes: Array, steps: Array) -> tuple[Displacement, ...]:
        if not self.radii.size or self.radii[-1] == 0.0 or not (np.any(slopes) or np.any(steps)):
            return ()
        end = float(self.radii[-1])
        outer = self.radii == end
        parts: list[Displacement] = []
        if np.any(slopes) or np.any(steps[outer]):
            parts.append(ShearRamps(self.pressed.bed, self.radii, self.depths, slopes, float(np.sum(steps[outer]))))
        inner = ~outer & (steps != 0.0) & (self.radii > 0.0)
        parts += [ShearStep(float(b), float(step)) for b, step in zip(self.radii[inner], steps[inner], strict=True)]
        return tuple(parts)
