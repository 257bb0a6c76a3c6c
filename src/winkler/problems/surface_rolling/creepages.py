r"""Creepages of a patch that rolls steadily: given, or sought for given forces.

Under creepages that are small against friction, forces are proportional to them; the more of the friction they use, the
less they grow.  With the part :math:`\rho` of it that the resultant uses, the numbers

.. math:: t = 3\,\bigl[1-(1-\rho)^{1/3}\bigr]\,\frac f\rho

of the forces f over the friction grow almost in proportion up to sliding (after Vermeulen and Johnson).  So Broyden's
method on t, begun with the stiffness of a patch that sticks, finds the creepages of given forces with some six rolls,
each begun with the tractions of the one before; where a roll comes no nearer the stiffness is measured.

From pixel to pixel tractions that stick grow towards the trailing edge: they act somewhat behind the middle of their
pixel, and the slip of a spin, which has made them, is that of a place ahead of it.  A quarter of a pixel is taken for
both: half a pixel, the whole distance, errs by as much to the other side as none.  With a quarter the coefficients of
spin keep one per cent on 72 pixels.

References
----------
C. G. Broyden, Math. Comp. 19 (1965) 577-593, doi:10.1090/S0025-5718-1965-0198670-6; P. J. Vermeulen, K. L. Johnson,
J. Appl. Mech. 31 (1964) 338-340, doi:10.1115/1.3629610
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.laws.friction import Coulomb
from winkler.laws.varying_friction import FallingFriction, greatest_coefficient
from winkler.numerics.surfaces.rolled_surface import RolledSurface, roll
from winkler.numerics.types import Array
from winkler.problems.surface_friction.borne import refuse_beyond
from winkler.problems.surface_rolling.falling import roll_under
from winkler.problems.surface_rolling.patch import RollingPatch
from winkler.values.errors import NotConverged

AHEAD = 0.25
"""How far ahead of the middle of a pixel the slip of a spin is taken, and how far behind what sticks acts [pixels]."""
MOST_ROLLS = 100
"""Rolls after which the creepages of given forces count as not found; six are usual."""
STALLED_ROLLS = 20
"""Rolls in which the distance from given forces must halve, unless all slides; where
friction does not bear them it hardly changes."""
FORCE_TOLERANCE = 1e-9
"""Least bound on the distance from a given force, over what friction bears."""
INNER_RATIO, LEAST_INNER = 0.01, 1e-12
"""Tolerance of a roll over that of the forces, which err by up to three times its misfit; and the least one."""
AHEAD_OF_FORCES = 1e-3
"""Part of the distance from given forces to which a roll on the way to them is exact: a step seldom gains more."""
STICKING_RATIO = 1e9
"""Coefficient of friction under which all sticks."""
FIRST_TOLERANCE, STUCK_TOLERANCE = 1e-4, 1e-2
"""Of the first rolls, far from given forces; and of a patch on which all sticks, with whose stiffness they begin."""
SMALL_CREEPAGE = 1e-6
"""Creepage of a patch on which all sticks; forces are proportional to it."""
SLIDING = 1.0 - 1e-9
"""Part of the friction from which on all slides."""
FARTHEST = 1.0
"""Greatest change of the creepages in one step, over them or what lets all slide, whichever is more."""
CHANGE_RATIO = 1e-3
"""Change of a creepage, over all of them, by which the growth of forces is measured."""
SHORTENED = 0.25
"""Length of a step over that of the one before, which came no nearer."""


class CreptPatch(NamedTuple):
    """A patch that rolls.

    Parameters
    ----------
    creeps
        xi, eta, phi [1/m], (3,).
    forces
        F_x, F_y [N], M_z [N m], (3,).
    surface
        Its tractions and slip.
    missing
        Greatest distance from a given force, over what friction bears.
    resistance
        What tractions lose per distance on what pressures draw along [N].
    """

    creeps: Array
    forces: Array
    surface: RolledSurface
    missing: float
    resistance: float

    @property
    def traction(self) -> Array:
        """q / E*, (2, nx, ny)."""
        return self.surface.traction


class CreepSearch:
    """A patch on which creepages are tried; what one case shows is used for the next.

    Parameters
    ----------
    patch : RollingPatch
        The pressed map.
    by_force : ndarray of bool, (3,)
        Which of F_x, F_y, M_z are given instead of xi, eta, phi.
    friction : Coulomb or FallingFriction
        Law of friction.
    speed : float
        Of rolling [m/s].
    tolerance : float
        As of `roll`, and of given forces.
    """

    def __init__(
        self,
        patch: RollingPatch,
        by_force: Array,
        friction: Coulomb | FallingFriction,
        speed: float,
        tolerance: float,
    ):
        self.patch, self.by_force, self.tolerance = patch, by_force, tolerance
        self.friction, self.speed, self.coefficient = friction, speed, greatest_coefficient(friction)
        self.falls = isinstance(friction, FallingFriction) and friction.kinetic_coefficient < self.coefficient
        self.inner = max(INNER_RATIO * tolerance, LEAST_INNER) if np.any(by_force) else tolerance
        self.first = max(FIRST_TOLERANCE, self.inner)
        p, self.shift = patch.pressure, AHEAD * patch.pixel[0]
        arm = float(np.sqrt(np.sum(p * patch.arms**2) / np.sum(p)))
        self.lengths = np.array([1.0, 1.0, arm])
        even, none = np.ones(p.shape), np.zeros(p.shape)
        self.modes = np.stack(
            (np.stack((even, none)), np.stack((none, even)), np.stack((-patch.y, patch.x + self.shift)))
        )
        nothing = np.zeros_like(self.modes[0])
        self.pressure, self.drawn, self.stretch, self.most = p, nothing, nothing, self.lengths
        still = RolledSurface(nothing, nothing, p < 0.0, 0.0, 0)
        self.rest = self.last = CreptPatch(np.zeros(3), np.zeros(3), still, 0.0, 0.0)
        self.stiffness, self.sliding, self.sought = np.zeros((0, 0)), 0.0, np.zeros(0)
        self.known = np.zeros(3, dtype=bool)

    def found(self, pressure: Array, given: Array, start: Array) -> CreptPatch:
        """Return the patch under creepages and forces.

        Parameters
        ----------
        pressure
            p over E*.
        given
            xi, eta, phi [1/m], or instead F_x, F_y [N], M_z [N m].
        start
            Tractions to begin with, over E*.

        Raises
        ------
        OutsideValidity
            If friction does not bear a force.
        NotConverged
            If stick and slip, or the creepages are not found to the tolerance.
        """
        borne, drawn = self.patch.unit * self.coefficient * pressure, self.patch.grid.drawn(pressure)
        self.pressure, self.most = pressure, float(np.sum(borne)) * self.lengths
        self.stretch = np.zeros_like(drawn)
        self.stretch[:, 1:-1] = 0.5 * (drawn[:, 2:] - drawn[:, :-2])
        self.drawn = np.zeros_like(drawn)
        self.drawn[:, :-1] = drawn[:, 1:] - drawn[:, :-1]
        forces = np.where(self.by_force, given, 0.0)
        refuse_beyond(float(np.hypot(forces[0], forces[1])), float(forces[2]), borne, self.patch.arms)
        self.last = self._sought(given, start) if np.any(self.by_force) else self._rolled(given, start, self.inner)
        return self.last

    def _sought(self, given: Array, start: Array) -> CreptPatch:
        varies = isinstance(self.friction, FallingFriction)
        if varies and not np.array_equal(given, self.sought):  # from the maximum of a creep curve no step leads on
            self.stiffness, self.last, start = np.zeros((0, 0)), self.rest, self.rest.traction
        self.sought = given
        if not self.stiffness.size:
            self.stiffness, self.known = np.zeros((3, 3)), np.zeros(3, dtype=bool)
        missing, allowed = np.inf, max(self.tolerance, FORCE_TOLERANCE)
        guess = np.where(self.by_force, self.last.creeps, given)
        for axis in np.flatnonzero((self.by_force | (guess != self.last.creeps)) & ~self.known).tolist():
            self.stiffness[:, axis], self.known[axis] = self._stuck(axis), True
        self.sliding = 3.0 / float(np.max(np.diag(self.stiffness)))
        behind = self._behind(given, self.last) - self.stiffness @ ((guess - self.last.creeps) * self.lengths)
        coarse = not self.falls  # rolls on the way to the forces are no more exact than they are near
        best = self._rolled(guess + self._step(behind), start, self.first if coarse else self.inner)
        length, lost, measured, rolls, earlier = 1.0, False, False, 0, np.inf
        for rolls in range(1, MOST_ROLLS + 1):
            missing = float(np.max(np.abs((given - best.forces) / self.most)[self.by_force]))
            if missing <= allowed and not coarse:
                return best._replace(missing=missing)
            if coarse and (lost or missing <= allowed):  # is it so once the roll is exact?
                coarse, best = False, self._rolled(best.creeps, best.traction, self.inner)
                continue
            exact = min(max(AHEAD_OF_FORCES * missing, self.inner), self.first) if coarse else self.inner
            if rolls % STALLED_ROLLS == 1:
                if missing > 0.5 * earlier and not self._slides(best):
                    break
                earlier = missing
            behind, slid = self._behind(given, best), self._slides(best)
            step = np.where(self.by_force, -0.5 * best.creeps, 0.0) if slid else length * self._step(behind, best)
            tried = self._rolled(best.creeps + step, best.traction, exact)
            left = np.where(self.by_force, behind - self._evened(tried.forces) + self._evened(best.forces), 0.0)
            if slid or (np.linalg.norm(left) < np.linalg.norm(behind) and not self._slides(tried)):
                moved, grown = self._between(best, tried)
                self.stiffness = self.stiffness + np.outer(grown - self.stiffness @ moved, moved) / (moved @ moved)
                best, length, measured = tried, 1.0, False
            elif coarse:
                lost = True
            elif measured:
                length *= SHORTENED
            else:
                self._measure(best)
                measured = True
        if self.last is not self.rest:  # what the case before has shown may not lead on: from rest
            self.stiffness, self.last = np.zeros((0, 0)), self.rest
            return self._sought(given, self.rest.traction)
        raise NotConverged(
            f"the given forces are missed by {missing:.3g} of the friction limit, after {rolls} rolls; allowed "
            f"are {allowed:.3g}; {self._why()}"
        )

    def _why(self) -> str:
        """Return what may be wrong with forces that are not met, and what to do."""
        if isinstance(self.friction, FallingFriction):
            return (
                "friction that falls with the velocity of slip carries less than the static coefficient says, and what "
                "is beyond the maximum of the creep curve has creepages only: give smaller forces, or a Creepage"
            )
        return "together they may exceed the friction limit: give smaller ones, or a Creepage"

    def _behind(self, given: Array, at: CreptPatch) -> Array:
        """Return what t lacks where forces are given."""
        return self._evened(np.where(self.by_force, given, at.forces)) - self._evened(at.forces)

    def _step(self, behind: Array, at: CreptPatch | None = None) -> Array:
        """Return the change of the creepages that are sought, were t to grow in proportion; from some, not too far."""
        step, sought = np.zeros(3), self.by_force
        step[sought] = np.linalg.lstsq(self.stiffness[np.ix_(sought, sought)], behind[sought], rcond=None)[0]
        if at is not None:
            longest = FARTHEST * max(float(np.linalg.norm(at.creeps * self.lengths)), self.sliding)
            step *= min(1.0, longest / max(float(np.linalg.norm(step)), longest))
        return np.asarray(step / self.lengths)

    def _rolled(self, creeps: Array, start: Array, tolerance: float) -> CreptPatch:
        rigid = np.tensordot(creeps, self.modes, 1) + self.drawn
        surface = roll_under(
            self.friction, self.speed, self.patch.grid, self.pressure, rigid, start, tolerance=tolerance
        )
        resistance = self.patch.unit * float(np.sum(surface.traction * self.stretch))
        return CreptPatch(creeps, self._forces(surface), surface, 0.0, resistance)

    def _forces(self, surface: RolledSurface) -> Array:
        q, at = surface.traction, self.patch.x - self.shift * ~surface.slipping
        moment = np.sum(at * q[1] - self.patch.y * q[0])
        return self.patch.unit * np.array([np.sum(q[0]), np.sum(q[1]), moment])

    def _slides(self, crept: CreptPatch) -> bool:
        return bool(np.hypot(crept.forces[0], crept.forces[1]) >= SLIDING * self.most[0])

    def _evened(self, forces: Array) -> Array:
        """Return t: numbers that grow almost in proportion to the creepages."""
        part = forces / self.most
        used = min(float(np.hypot(part[0], part[1])), SLIDING)
        return np.asarray(part * (3.0 * (1.0 - np.cbrt(1.0 - used)) / used if used > 0.0 else 1.0))

    def _between(self, one: CreptPatch, other: CreptPatch) -> tuple[Array, Array]:
        """Return by how much creepages and t of two differ."""
        return (other.creeps - one.creeps) * self.lengths, self._evened(other.forces) - self._evened(one.forces)

    def _stuck(self, axis: int) -> Array:
        """Return how t grows with one of the creepages where all sticks."""
        rigid = SMALL_CREEPAGE / self.lengths[axis] * self.modes[axis]
        bound = STICKING_RATIO * self.pressure
        surface = roll(self.patch.grid, bound, rigid, np.zeros_like(rigid), tolerance=STUCK_TOLERANCE)
        return np.asarray(self._forces(surface) / self.most / SMALL_CREEPAGE)

    def _measure(self, at: CreptPatch) -> None:
        """Find the stiffness by small changes of the creepages."""
        size = max(float(np.linalg.norm(at.creeps * self.lengths)), CHANGE_RATIO * self.sliding)
        for axis in np.flatnonzero(self.by_force):
            creeps = at.creeps.copy()
            creeps[axis] += CHANGE_RATIO * size / self.lengths[axis]
            moved, grown = self._between(at, self._rolled(creeps, at.traction, self.inner))
            self.stiffness[:, axis] = grown / moved[axis]
