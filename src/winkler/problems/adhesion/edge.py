r"""What moves the edge of a contact with attraction of short range, when the machine is in control.

The stretch of the last springs is :math:`S = g(a) - d`.  The edge advances if :math:`S < \ell_\mathrm{c}(a)`, recedes
if :math:`S > \ell_\mathrm{o}(a)`, where :math:`\ell = \sqrt{4\pi a w/k'}` with the work of adhesion of closing and of
opening, and rests in between.  A machine of the stiffness :math:`k_\mathrm{m}` whose far end stands at
:math:`D = d + F/k_\mathrm{m}` meets these limits at

.. math:: D(a) = d(a) + F(a)/k_\mathrm{m}, \qquad d(a) = g(a)-\ell(a), \qquad
          F(a) = k\,d(a) - \int_0^a k'g\,\mathrm dx ,

a dead load at F(a).  S falls when D or F rises; so these two curves over the radius determine how the edge moves, and
an edge that loses its hold runs on, at a constant D or F, to the next radius at which the curve is as high again.
"""

from __future__ import annotations

import math
from typing import ClassVar, NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.adhesion import ShortRange
from winkler.numerics.equations.turning import Slopes
from winkler.numerics.types import Array, Curve
from winkler.problems.adhesion import griffith
from winkler.problems.adhesion.edge_states import EdgeStates, FarStates, ShortStates, stored_energy
from winkler.problems.adhesion.stability import branches, least_radius
from winkler.problems.normal.solve_contact import end_of, flat_radius
from winkler.values.errors import OutsideValidity
from winkler.values.value import value

OCTAVES = 400
BISECTIONS = 50


@value
class LoadingMachine:
    """A machine whose far end is moved.

    Parameters
    ----------
    compliance : float
        1/k_m [m/N], zero for fixed grips.
    """

    compliance: float

    @property
    def stiffness(self) -> float:
        """k_m [N/m]."""
        return 1.0 / self.compliance if self.compliance > 0.0 else math.inf

    def level(self, depth: Array, force: Array) -> Array:
        """D [m], where the far end stands."""
        return depth + self.compliance * force

    def depth(self, stiffness: Array, load: Array, level: Array) -> Array:
        """d [m] at a position D of the far end, of springs with F = k d - load."""
        return np.asarray((level + self.compliance * load) / (1.0 + self.compliance * stiffness))

    def energy(self, depth: Array, force: Array) -> Array:
        """What is stored in the machine [J]."""
        return 0.5 * self.compliance * force**2


@value
class DeadLoad:
    """A weight, or a machine that keeps the force."""

    stiffness: ClassVar[float] = 0.0

    def level(self, depth: Array, force: Array) -> Array:
        """F [N]."""
        return force

    def depth(self, stiffness: Array, load: Array, level: Array) -> Array:
        """d [m] under a force F = k d - load; zero without contact."""
        touching = stiffness > 0.0
        return np.where(touching, (level + load) / np.where(touching, stiffness, 1.0), 0.0)

    def energy(self, depth: Array, force: Array) -> Array:
        """Potential of the weight [J]."""
        return -force * depth


class AdhesiveEdge(NamedTuple):
    """The two curves that an edge obeys, cut at their turning points.

    Parameters
    ----------
    bed : Bed
    law : ShortRange
    control : LoadingMachine or DeadLoad
    closing, opening : Slopes
        What must be prescribed for the edge to advance, and to recede, over the contact radius.
    """

    bed: Bed
    law: ShortRange
    control: LoadingMachine | DeadLoad
    closing: Slopes
    opening: Slopes

    def apart(self) -> float:
        """Return the place of bodies that are apart: no radius."""
        return 0.0

    def state(self, place: Array, level: Array) -> tuple[Array, Array, Array]:
        """Return d [m], F [N] and a [m] at places, which are radii, and what is prescribed."""
        bed = self.bed
        depth = self.control.depth(bed.stiffness(place), bed.gap_load(place), level)
        if isinstance(self.control, DeadLoad):
            return depth, np.where(place > 0.0, level, 0.0), place
        return depth, griffith.force_at(bed, depth, place), place

    def energy(self, depth: Array, force: Array, radius: Array) -> Array:
        """Return elastic energy less what closing has gained, U - w_closing pi a^2 [J]."""
        return stored_energy(self.bed, depth, radius) - self.law.work_closing * np.pi * radius**2

    def hysteresis(self, start: float, end: float) -> float:
        """Return what opening costs more than closing gains, from a radius to a smaller one [J]."""
        return (self.law.work_opening - self.law.work_closing) * np.pi * (start - end) * (start + end)


def adhesive_edge(bed: Bed, law: ShortRange, control: LoadingMachine | DeadLoad, highest: float) -> AdhesiveEdge:
    """Return the curves that the edge obeys, up to where `highest` is prescribed.

    Raises
    ------
    OutsideValidity
        If the profile is too pointed to be held by attraction of vanishing range, has too many waves, or never meets
        what is prescribed.
    """

    def curve(work: float, radius: Array) -> Array:
        depth = griffith.depth_of(bed, work, radius)
        level = control.level(depth, griffith.force_at(bed, depth, radius))
        return np.asarray(np.where(radius > 0.0, level, 0.0))

    opening, closing = law.work_opening, law.work_closing
    start = least_radius(ShortStates(bed, opening))
    high = last_radius(lambda a: curve(opening, a), max(highest, 0.0), start, end_of(bed))
    parting = _slopes(lambda a: curve(opening, a), ShortStates(bed, opening), control, high)
    if closing == opening:
        return AdhesiveEdge(bed, law, control, parting, parting)
    states: EdgeStates = ShortStates(bed, closing) if closing > 0.0 else FarStates(bed, 0.0)
    if closing == 0.0 and bed.rising:
        places = np.unique([0.0, flat_radius(bed), high])
        meeting = Slopes(lambda a: curve(closing, a), places, curve(closing, places))
    else:
        meeting = _slopes(lambda a: curve(closing, a), states, control, high)
    return AdhesiveEdge(bed, law, control, meeting, parting)


def _slopes(curve: Curve, states: EdgeStates, control: LoadingMachine | DeadLoad, high: float) -> Slopes:
    """Return a curve cut where it turns: at the limits of the stable stretches."""
    limits = [limit for branch in branches(states, control.stiffness, high) for limit in branch]
    places = np.unique([0.0, *limits, high])
    return Slopes(curve, places, curve(places))


def last_radius(level: Curve, highest: float, start: float, end: float) -> float:
    """Return a radius whose level is above `highest`, or where the body ends."""

    def above(radius: float) -> bool:
        with np.errstate(all="ignore"):
            here = float(level(np.array([radius]))[0])
        return not here <= highest  # what is beyond all numbers is high

    radius = min(start, end)
    for _ in range(OCTAVES):
        if radius == end or above(radius):
            break
        radius = min(2.0 * radius, end)
    else:
        raise OutsideValidity(
            f"AdhesiveCycle: the contact grows without end before {highest:.6g} is reached, because the profile does "
            "not rise for good; give a profile that does, or less load."
        )
    if radius < end:
        return radius
    with np.errstate(all="ignore"):
        if np.isfinite(level(np.array([end]))[0]):
            return end
    for n in range(1, BISECTIONS):  # the profile becomes vertical at its end
        radius = end * (1.0 - 2.0**-n)
        if above(radius):
            break
    return radius
