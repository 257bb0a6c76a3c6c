r"""A surface pressed on a grid that is sheared, with Coulomb friction: one step of its path.

In the contact tractions are sought with \|q\| <= g that are at their bound, and along the slip s of the step, wherever
the surfaces slip:

.. math:: g\,|s| = q\cdot s, \qquad s = w - (G q - u_0) ,

where w is the rigid motion of the step, of which either an amount or its force is given, and u_0 the displacement
before it.  They are the minimum of q G q / 2 - q (w + u_0) over the discs \|q\| <= g, found by Newton's method: what
sticks is free in the plane, what slips along the circle, on which the bound bends the energy by \|s\|/g.  Each step of
Newton is made by conjugate gradients, preconditioned with the wave number and kept to the given forces.  The sum of
g \|s\| - q s is at once what the energy is above its least value: it certifies the solution.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.numerics.types import Array
from winkler.values.errors import NotConverged

MOST_ROUNDS = 100
"""Steps of Newton after which a surface has not converged; ten are usual."""
USUAL_ROUNDS = 12
"""Steps of Newton in single digits, after which each is preceded by one down the energy, and takes double ones."""
MOST_ITERATIONS = 100
"""Conjugate gradients of one step of Newton; four are usual."""
INNER_RATIO = 0.1
"""To what part of its residual a step of Newton is solved."""
AT_BOUND = 1.0 - 1e-10
"""Part of the bound from which on a traction is at it."""
FORCE_TOLERANCE = 1e-9
"""Largest error of a given force, over what friction bears."""
DEPENDENT = 1e-10
"""Motions that the free pixels resist by less than this part are not independent: what slips everywhere."""
FLAT = 1e-5
"""Curvature of the energy, over that of the preconditioner, that is none."""
MIDDLE_WAVE = 0.5 * math.pi
"""Wave number, times the size of a pixel, at which the preconditioner weighs the bound against the elasticity."""


STIFFEST = 1e15
"""Slip over bound, both in pixels times E*, beyond which a traction does not turn: more would leave single digits."""


class RigidStep(NamedTuple):
    """The rigid motion of one step.

    Parameters
    ----------
    modes
        Displacement under a unit of each motion, (modes, 2, nx, ny).
    given
        The amount of each, or the sum of the tractions times its mode, (modes,).
    by_force
        Which of both is given, (modes,).
    """

    modes: Array
    given: Array
    by_force: Array


class ShearedSurface(NamedTuple):
    """The surface after the step.

    Parameters
    ----------
    traction
        q / E*, (2, nx, ny).
    displacement
        G q, (2, nx, ny).
    slip
        s of the step, (2, nx, ny), also where nothing touches.
    motion
        Amount of each motion, (modes,).
    slipping
        Pixels at their bound that slip, (nx, ny).
    misfit
        Sum of g |s| - q s over that of g |s| and q G q, now and at the beginning of the step: zero if what slips is at
        its bound, along its slip.
    missing
        Greatest error of a given force over the sum of g, times its mode.
    rounds
        Steps of Newton.
    """

    traction: Array
    displacement: Array
    slip: Array
    motion: Array
    slipping: Array
    misfit: float
    missing: float
    rounds: int


def shear(
    grid: TractionGrid, bound: Array, before: Array, step: RigidStep, start: Array, *, tolerance: float = 1e-8
) -> ShearedSurface:
    """Solve one step.

    Parameters
    ----------
    grid
        The surface.
    bound
        g over E*, (nx, ny); zero where nothing touches.
    before
        u_0, (2, nx, ny): displacement before the step, less that by which pressures have drawn the surface since.
    step
        The rigid motion.
    start
        Tractions to begin with, over E*.
    tolerance
        Bound on `ShearedSurface.misfit`.

    Raises
    ------
    NotConverged
        If the bound is not met: often because friction does not bear the given forces together.
    """
    inside = bound > 0.0
    forced = np.flatnonzero(step.by_force)
    moved = np.where(step.by_force, 0.0, step.given)
    pushing = step.modes[forced] * inside
    borne = np.array([float(np.sum(bound * np.hypot(mode[0], mode[1]))) for mode in pushing])
    held = abs(float(np.sum(start * before)))  # if all of it is let go, what is left is small against it, not zero
    light = grid.in_single_digits()
    traction, gentle = within(start, bound), 1.0 / float(np.max(np.abs(grid.along)))
    for count in range(MOST_ROUNDS):
        under = grid.sheared(traction)
        slip = before + np.tensordot(moved, step.modes, 1) - under
        if count == 0 or count > USUAL_ROUNDS:  # down the energy itself: turns what slips far along its slip
            traction = within(traction + gentle * slip, bound)
            under = grid.sheared(traction)
            slip = before + np.tensordot(moved, step.modes, 1) - under
        size = np.hypot(traction[0], traction[1])
        normal = np.divide(traction, size, out=np.zeros_like(traction), where=size > 0.0)
        outward = np.sum(normal * slip, 0)
        slipping = inside & (size >= AT_BOUND * bound) & (outward > 0.0)
        lacking = step.given[forced] - np.array([float(np.sum(mode * traction)) for mode in pushing])
        most = float(np.sum(bound * np.hypot(slip[0], slip[1])))
        scale = most + float(np.sum(traction * under)) + held
        misfit = max(most - float(np.sum(traction * slip)), 0.0) / scale if scale > 0.0 else 0.0
        missing = float(np.max(np.abs(lacking) / borne, initial=0.0)) if np.all(borne > 0.0) else 0.0
        if count and misfit <= tolerance and missing <= FORCE_TOLERANCE:
            return ShearedSurface(traction, under, slip, moved, slipping, misfit, missing, count)
        stiffer = np.divide(outward, bound, out=np.zeros_like(bound), where=slipping)
        newton = _Newton(
            light if count <= USUAL_ROUNDS else grid, inside & ~slipping, slipping, normal, stiffer, pushing
        )
        change, more = newton.solved(slip, lacking)
        moved[forced] += more
        traction = traction + change
        size = np.hypot(traction[0], traction[1])
        onto = np.divide(bound, size, out=np.ones_like(bound), where=slipping & (size > 0.0))
        traction = within(traction * onto, bound)
    raise NotConverged(
        f"the contact of {int(np.count_nonzero(inside))} pixels slips with an error of {misfit:.3g} of the energy, and "
        f"given forces lack {missing:.3g} of the friction limit, after {MOST_ROUNDS} rounds; allowed are "
        f"{tolerance:.3g} and {FORCE_TOLERANCE:.0e}. If friction carries the forces together, use shorter steps"
    )


def within(traction: Array, bound: Array) -> Array:
    """Return tractions, those beyond their bound shortened to it."""
    size = np.hypot(traction[0], traction[1])
    return np.asarray(traction * np.divide(bound, size, out=np.where(bound > 0.0, 1.0, 0.0), where=size > bound))


class _Newton:
    """One step of Newton: the change of tractions that are free, and of the motions whose forces are given.

    It may be made in single digits: what it leaves wrong is found anew before the next.
    """

    def __init__(
        self, grid: TractionGrid, sticking: Array, slipping: Array, normal: Array, stiffer: Array, pushing: Array
    ):
        self.number = number = grid.along.dtype.type
        self.grid, self.sticking = grid, sticking
        self.stiffer = np.minimum(stiffer, STIFFEST).astype(number)
        self.tangent = (np.stack((-normal[1], normal[0])) * slipping).astype(number)
        self.weight = 1.0 / np.sqrt(1.0 + number(0.5 * MIDDLE_WAVE) * self.stiffer)
        self.pushing = np.array([self._free(mode.astype(number)) for mode in pushing])
        self.pushed = np.array([self._undone(mode) for mode in self.pushing])
        count = len(pushing)
        products = self.pushing.reshape(count, -1) @ self.pushed.reshape(count, -1).T if count else np.zeros((0, 0))
        self.inverse = np.linalg.pinv(products.astype(float), rcond=DEPENDENT, hermitian=True) if count else products

    def solved(self, slip: Array, lacking: Array) -> tuple[Array, Array]:
        """Return the change of the tractions and of the motions."""
        unit = float(np.max(np.abs(self._free(slip)), initial=0.0))
        unit = max(unit, float(np.max(np.abs(self.inverse @ lacking), initial=0.0))) or 1.0
        change: Array = np.zeros(slip.shape, dtype=self.number)
        left = self._free((slip / unit).astype(self.number))
        if lacking.size:
            change = self._summed(self.inverse @ lacking / unit)
            left = left - self._bent(change)
        down = self._kept(self._undone(left))
        along, product = down, float(np.sum(left * down))
        least = INNER_RATIO**2 * product
        for _ in range(MOST_ITERATIONS):
            if not product > 0.0:
                break
            bent = self._bent(along)
            curved = float(np.sum(along * bent))
            if curved <= FLAT * product:  # even traction on all of a periodic map displaces nothing: up to its bound
                change = change + self.number(1.0 / FLAT) * along
                break
            length = self.number(product / curved)
            change = change + length * along
            left = left - length * bent
            down = self._kept(self._undone(left))
            new = float(np.sum(left * down))
            if new <= least:
                break
            along, product = down + self.number(new / product) * along, new
        return unit * change.astype(float), -unit * (self.inverse @ self._sums(self.pushed, left))

    def _free(self, field: Array) -> Array:
        """Return the part of a field along which tractions are free."""
        turned = self.tangent[0] * field[0]
        turned += self.tangent[1] * field[1]
        return np.asarray(self.sticking * field + self.tangent * turned)

    def _bent(self, field: Array) -> Array:
        """Return the second derivative of the energy times a field."""
        return self._free(self.grid.sheared(field) + self.stiffer * field)

    def _undone(self, field: Array) -> Array:
        """Return a field that the second derivative roughly turns into this one."""
        return self._free(self.weight * self.grid.roughly_shearing(self.weight * field))

    def _kept(self, field: Array) -> Array:
        """Return a field that leaves the given forces as they are."""
        if not self.pushing.size:
            return field
        return field - self._summed(self.inverse @ self._sums(self.pushing, field))

    def _summed(self, factors: Array) -> Array:
        """Return the sum of what the motions push, times these factors."""
        return np.asarray(np.tensordot(factors.astype(self.number), self.pushed, 1))

    @staticmethod
    def _sums(modes: Array, field: Array) -> Array:
        return np.array([float(np.sum(mode * field)) for mode in modes])
