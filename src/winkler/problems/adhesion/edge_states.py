r"""The states in which a round adhesive contact is in equilibrium: depth and force for every contact radius.

A law determines how the last springs are stretched, and so one depth and one force for every radius a.  Whether such a
state is stable depends on what holds the bodies: on a machine of the stiffness :math:`k_m` the radius responds to
:math:`D = d + F/k_m`, and a state is stable where D grows with a,

.. math:: \frac{k_m\,d'(a) + F'(a)}{k_m + k(a)} > 0 ,

fixed grips being :math:`k_m\to\infty`, a dead load :math:`k_m = 0`.
"""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings, StretchedSprings
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array
from winkler.problems.adhesion import griffith
from winkler.problems.normal.solve_contact import end_of
from winkler.values.value import value


class EdgeStates(Protocol):
    """The equilibria of a bed under a law of adhesion, as a law must define them. Arrays of radii in, arrays out."""

    def __hash__(self) -> int:
        """States are values."""

    @property
    def bed(self) -> Bed:
        """The springs."""

    def end(self) -> float:
        """The greatest contact radius of which something is known [m]."""

    def from_nothing(self) -> bool:
        """Whether contacts of vanishing radius are states like others; if not, they are known to be unstable."""

    def depth(self, radius: Array) -> Array:
        """d(a) [m]."""

    def load(self, radius: Array) -> Array:
        """What is taken from k(a) d to give the force, F = k d - load [N], also of an edge that is held."""

    def slopes(self, radius: Array) -> tuple[Array, Array]:
        """d'(a) [-] and F'(a) [N/m]; at a kink, the values just below it."""

    def scale(self, radius: Array) -> Array:
        """What d'(a) is measured against [-], positive: the stretch of the edge over the radius."""

    def pressed(self, depth: float, radius: float) -> PressedSprings:
        """The displacement of the springs, from which fields are restored."""


@value
class ShortStates:
    """Griffith's states.

    Parameters
    ----------
    bed : Bed
    work : float
        Work of adhesion [J/m^2].
    """

    bed: Bed
    work: float

    def end(self) -> float:
        """The rim, or up to where the profile is known [m]."""
        return end_of(self.bed)

    def from_nothing(self) -> bool:
        """A contact of vanishing radius runs away."""
        return False

    def depth(self, radius: Array) -> Array:
        """d(a) [m]."""
        return griffith.depth_of(self.bed, self.work, radius)

    def load(self, radius: Array) -> Array:
        """The gap load [N]."""
        return self.bed.gap_load(radius)

    def slopes(self, radius: Array) -> tuple[Array, Array]:
        """d'(a) and F'(a)."""
        bed = self.bed
        springs, stretch = bed.normal_stiffness(radius), griffith.stretch(bed, self.work, radius)
        relative_slope = bed.normal_stiffness_slope(radius) / springs
        depth = bed.gap_slope(radius) - 0.5 * stretch * (1.0 / radius - relative_slope)
        return depth, bed.stiffness(radius) * depth - 2.0 * springs * stretch

    def scale(self, radius: Array) -> Array:
        """Stretch over radius."""
        return np.asarray(griffith.stretch(self.bed, self.work, radius) / radius)

    def pressed(self, depth: float, radius: float) -> StretchedSprings:
        """The springs up to the contact radius."""
        return StretchedSprings(self.bed, depth, radius)


@value
class FarStates:
    """States without adhesion, under a force that the attraction of far surfaces adds.

    Parameters
    ----------
    bed : Bed
    pull : float
        2 pi R w [N].
    """

    bed: Bed
    pull: float

    def end(self) -> float:
        """The rim, or up to where the profile is known [m]."""
        return end_of(self.bed)

    def from_nothing(self) -> bool:
        """The contact starts as a point."""
        return True

    def depth(self, radius: Array) -> Array:
        """d(a) = g(a) [m]."""
        return self.bed.gap(radius)

    def load(self, radius: Array) -> Array:
        """The gap load and the pull [N]."""
        return self.bed.gap_load(radius) + self.pull

    def slopes(self, radius: Array) -> tuple[Array, Array]:
        """d'(a) and F'(a)."""
        slope = self.bed.gap_slope(radius)
        return slope, self.bed.stiffness(radius) * slope

    def scale(self, radius: Array) -> Array:
        """g(a) over a."""
        return np.asarray(np.maximum(np.abs(self.bed.gap(radius)), 1e-300) / radius)

    def pressed(self, depth: float, radius: float) -> PressedSprings:
        """The springs of the contact alone: what pulls from afar deforms nothing."""
        return PressedSprings(self.bed, depth, radius)


def force_under(states: EdgeStates, depth: Array, radius: Array) -> Array:
    """Return the force [N] at a depth, of edges in equilibrium or held."""
    return np.asarray(states.bed.stiffness(radius) * depth - states.load(radius))


def depth_under(states: EdgeStates, force: Array, radius: Array) -> Array:
    """Return the depth [m] under a force: it is less sensitive to rounding of the radius than g(a) at a steep flank."""
    stiffness = states.bed.stiffness(radius)
    held = stiffness > 0.0
    under_force = (force + states.load(radius)) / np.where(held, stiffness, 1.0)
    return np.where(held, under_force, states.depth(radius))


def force_of(states: EdgeStates, radius: Array) -> Array:
    """Return F(a) [N]."""
    return force_under(states, states.depth(radius), radius)


def margin(states: EdgeStates, machine_stiffness: float, radius: Array) -> Array:
    """Return how stable states are, in units of `scale`: positive where stable."""
    depth, force = states.slopes(radius)
    if machine_stiffness == 0.0:
        depth = force / states.bed.stiffness(radius)
    elif math.isfinite(machine_stiffness):
        depth = (machine_stiffness * depth + force) / (machine_stiffness + states.bed.stiffness(radius))
    return np.asarray(depth / states.scale(radius))


def position(states: EdgeStates, machine_stiffness: float, radius: Array) -> Array:
    """Return what rises along a stable branch: d [m] of fixed grips, else F + k_m d [N]."""
    depth = states.depth(radius)
    if math.isinf(machine_stiffness):
        return depth
    return np.asarray(force_under(states, depth, radius) + machine_stiffness * depth)


def stored_energy(bed: Bed, depth: Array, radius: Array) -> Array:
    """Return the elastic energy U of springs `(m,)` pressed to depths up to contact radii [J]."""
    edges = [b for b, _ in bed.kinks]
    squares = abel.integral(lambda x: 2.0 * bed.normal_stiffness(x) * bed.gap(x) ** 2, edges, radius)
    return np.asarray(0.5 * ((bed.stiffness(radius) * depth - 2.0 * bed.gap_load(radius)) * depth + squares))
