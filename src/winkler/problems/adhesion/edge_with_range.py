r"""What moves the edge of a contact whose attraction has a range, when the machine is in control.

One curve of equilibrium leads from apart through the approach, in which the surfaces attract each other without
touching, into the contact; a machine whose far end stands at :math:`D = d + F/k_\mathrm{m}` follows it where D rises
and jumps where it turns.  Before touch, Maugis' constant stress :math:`\sigma_0` pulls over a disc of the radius c,

.. math:: d = f(c) - \frac{4\sigma_0c}{\pi E^*} - \frac{w}{\sigma_0}, \qquad F = -\pi\sigma_0c^2 ,

and DMT's pull comes up at first touch.  Along the curve the stored energy, surfaces included, grows by F dd.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.adhesion import DerjaguinMullerToporov, Dugdale
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.equations.turning import Slopes
from winkler.numerics.panels.chebyshev import fit_panels, stationary
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array, Curve
from winkler.problems.adhesion.edge import DeadLoad, LoadingMachine, last_radius
from winkler.problems.adhesion.edge_states import EdgeStates, force_of, force_under, stored_energy
from winkler.problems.adhesion.expected_radius import expected_radius
from winkler.problems.adhesion.law_states import states_of
from winkler.problems.adhesion.layered_states import DiscOnLayers, LayeredStates
from winkler.problems.adhesion.maugis import CohesiveStates
from winkler.problems.adhesion.stability import branches
from winkler.problems.normal.solve_contact import end_of
from winkler.values.errors import OutsideValidity

__all__ = ["RangedEdge", "ranged_edge"]

PANEL_TOLERANCE = 1e-12


class SuddenPull(NamedTuple):
    """DMT: at first touch the whole pull comes up at once.  The approach goes from -extent to touch, at 0."""

    pull: float

    def extent(self) -> float:
        """Length of the approach, in a coordinate of its own."""
        return 1.0

    def depth(self, place: Array) -> Array:
        """Zero."""
        return np.zeros(np.shape(place))

    def force(self, place: Array) -> Array:
        """From nothing to -pull [N]."""
        return -self.pull * (1.0 + np.asarray(place))

    def energy(self, force: Array) -> Array:
        """Nothing: the bodies do not move while it comes up."""
        return np.zeros(np.shape(force))


class DiscOfStress(NamedTuple):
    """Maugis: the constant stress over a disc, as long as the middle does not touch."""

    bed: Bed
    law: Dugdale
    modulus: float
    touch: float

    def extent(self) -> float:
        """The radius of the disc when its middle touches [m]."""
        return self.touch

    def _sink(self) -> float:
        """Return by how much the rim of the disc rises per radius [-]."""
        return 4.0 * self.law.strength / (math.pi * self.modulus)

    def depth(self, place: Array) -> Array:
        """d [m]."""
        c = np.maximum(np.asarray(place) + self.touch, 0.0)
        return np.asarray(self.bed.height(c) - self._sink() * c - self.law.range)

    def force(self, place: Array) -> Array:
        """F [N]."""
        return -math.pi * self.law.strength * (np.asarray(place) + self.touch) ** 2

    def energy(self, force: Array) -> Array:
        """The integral of F dd [J], by parts: F d - Int d dF, Int f c dc by quadrature."""
        c = np.sqrt(np.maximum(-np.asarray(force), 0.0) / (math.pi * self.law.strength))
        edges = [b for b, _ in self.bed.kinks]
        moment = abel.integral(lambda r: self.bed.height(r) * r, edges, c)
        raised = 2.0 * moment - self.bed.height(c) * c * c + self._sink() * c**3 / 3.0
        return np.asarray(math.pi * self.law.strength * raised)


class RangedEdge(NamedTuple):
    """The curve of equilibrium, cut at its turning points; places below zero are those of the approach.

    Parameters
    ----------
    bed : Bed
    states : EdgeStates
        Of the contact.
    approach : SuddenPull, DiscOfStress or DiscOnLayers
    control : LoadingMachine or DeadLoad
    closing, opening : Slopes
        What must be prescribed, over the places: the same for an edge that advances and one that recedes.
    """

    bed: Bed
    states: EdgeStates
    approach: SuddenPull | DiscOfStress | DiscOnLayers
    control: LoadingMachine | DeadLoad
    closing: Slopes
    opening: Slopes

    def apart(self) -> float:
        """Return the place of bodies that do not attract each other."""
        return -self.approach.extent()

    def state(self, place: Array, level: Array) -> tuple[Array, Array, Array]:
        """Return d [m], F [N] and a [m] at places and what is prescribed."""
        radius = np.maximum(place, 0.0)
        depth = self.control.depth(self.bed.stiffness(radius), self.states.load(radius), level)
        force = force_under(self.states, depth, radius)
        touching = place > 0.0
        nowhere = place <= self.apart()
        before = np.minimum(place, 0.0)
        depth = np.where(touching, depth, self.approach.depth(before))
        force = np.where(touching, force, self.approach.force(before))
        first_attracted = float(self.approach.depth(np.array([self.apart()]))[0])
        free = level if isinstance(self.control, LoadingMachine) else np.full(np.shape(level), first_attracted)
        return np.where(nowhere, free, depth), np.where(nowhere, 0.0, force), radius

    def energy(self, depth: Array, force: Array, radius: Array) -> Array:
        """Return the energy of bodies and surfaces [J]; zero apart."""
        whole = _stored(self.states, radius)
        # an edge that a rim holds moves on along a straight line
        held = 0.5 * (force + force_of(self.states, radius)) * (depth - self.states.depth(radius))
        return np.where(radius > 0.0, whole + held, self.approach.energy(force))

    def hysteresis(self, start: float, end: float) -> float:
        """Return nothing: closing and opening cost the same [J]."""
        return 0.0


def ranged_edge(
    bed: Bed, law: Dugdale | DerjaguinMullerToporov, control: LoadingMachine | DeadLoad, highest: float
) -> RangedEdge:
    """Return the curve that the edge obeys, up to where `highest` is prescribed.

    Raises
    ------
    OutsideValidity
        If the law does not hold for the bed, or nothing is known of the approach.
    """
    states = states_of(bed, law)
    approach = _approach(bed, law, states)

    def level(place: Array) -> Array:
        radius, before = np.maximum(place, 0.0), np.minimum(place, 0.0)
        closed = control.level(states.depth(radius), force_of(states, radius))
        return np.asarray(np.where(place > 0.0, closed, control.level(approach.depth(before), approach.force(before))))

    high = last_radius(level, max(highest, 0.0), expected_radius(states), end_of(bed))
    limits = [limit for branch in branches(states, control.stiffness, high) for limit in branch]
    places = np.unique([*_turns(level, bed, approach.extent()), 0.0, *limits, high])
    curve = Slopes(level, places, level(places))
    return RangedEdge(bed, states, approach, control, curve, curve)


def _approach(
    bed: Bed, law: Dugdale | DerjaguinMullerToporov, states: EdgeStates
) -> SuddenPull | DiscOfStress | DiscOnLayers:
    if isinstance(law, DerjaguinMullerToporov):
        return SuddenPull(-float(force_of(states, np.zeros(1))[0]))
    if isinstance(states, LayeredStates) and bed.rising:
        return DiscOnLayers(states, states.touch())
    if not isinstance(bed.medium, HomogeneousMedium) or not bed.rising:
        raise OutsideValidity(
            "AdhesiveCycle: how bodies attract each other before they touch is known for Dugdale's law on homogeneous "
            "half-spaces and on layers, and for profiles that rise up to their end; use ShortRange(work), or "
            "Equilibrium and PullOff, which begin at touch."
        )
    modulus = bed.medium.modulus
    # at touch the middle of the disc has risen by 2 sigma c / E*
    length = float(-states.depth(np.zeros(1))[0]) * modulus / (2.0 * law.strength)
    return DiscOfStress(bed, law, modulus, length)


def _stored(states: EdgeStates, radius: Array) -> Array:
    """Return what bodies and surfaces store in equilibrium [J]: the integral of F dd from apart on."""
    if isinstance(states, CohesiveStates | LayeredStates):
        return states.energy(radius)
    depth = states.depth(radius)
    pull = force_of(states, np.zeros(1))
    return np.asarray(stored_energy(states.bed, depth, radius) + pull * depth)


def _turns(level: Curve, bed: Bed, length: float) -> list[float]:
    """Return where the approach begins and turns."""
    edges = np.unique([-length, *(b - length for b, _ in bed.kinks if 0.0 < b < length), 0.0])
    size = float(np.max(np.abs(level(edges))))
    panels = fit_panels(lambda p: level(p.ravel()).reshape(p.shape), edges, PANEL_TOLERANCE * size)
    return [-length, *stationary(panels).tolist(), *edges[1:-1].tolist()]
