r"""A body that strikes metal obliquely: what friction does to its motion along the surface.

The normal motion is that of the straight impact, as shear is taken to leave the pressure alone.  Each spring at a
distance x from the axis bears :math:`E^* u(x)` at every moment, on first loading and on the dent, and is sheared with
:math:`\varrho` times its stiffness until friction holds it no longer,

.. math:: |u_x(x)| \le \frac{\mu}{\varrho}\,u(x), \qquad \dot w = -\kappa F_x, \qquad
          F_x = 2\varrho E^* \int_0^a u_x(x)\,\mathrm dx ,

with the velocity w of the touching points along the surface and their mobility :math:`\kappa`.  While everything slides
that is Coulomb's friction, exactly.  Otherwise the motion is marched over fixed steps of the normal motion, and w errs
by up to 5e-5 of itself at first touch, and 5e-4 if nothing slides: so it does of elastic bodies, against
`winkler.problems.impact.march`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.on_medium import UnderProfile
from winkler.numerics.types import Array
from winkler.problems.plastic.first_loading import FirstLoading, GreatestLoad

SPRINGS = 200
"""Along the greatest contact radius."""


class Sheared(NamedTuple):
    """How a body is sheared while it strikes.

    Parameters
    ----------
    ratio : float
        rho, tangential over normal stiffness of the springs.
    coefficient : float
        mu; infinite where nothing slides.
    mobility : float
        kappa [1/kg].
    """

    ratio: float
    coefficient: float
    mobility: float


class NormalMotion(NamedTuple):
    """The normal motion of n blows, in steps.

    Parameters
    ----------
    intervals : ndarray, (steps, n)
        How long each step lasts [s].
    states : list of GreatestLoad, (approach,)
        At the ends of steps while the bodies approach, each of `(n,)`.
    depths : ndarray, (rebound, n)
        From where the dents would just touch [m], at the ends of steps while the bodies part.
    """

    intervals: Array
    states: list[GreatestLoad]
    depths: Array


def sheared(curve: FirstLoading, rest: GreatestLoad, motion: NormalMotion, law: Sheared, velocity: Array) -> Array:
    """Return the velocities along the surface with which touching points part [m/s].

    Parameters
    ----------
    curve : FirstLoading
    rest : GreatestLoad
        The states of rest of n blows.
    motion : NormalMotion
    law : Sheared
    velocity : ndarray, (n,)
        At first touch [m/s].
    """
    x = rest.radius[:, None] * (np.arange(SPRINGS) + 0.5) / SPRINGS
    pressed = _Pressed(curve.bed, rest, x, (rest.radius > curve.onset)[:, None])
    stiffness = 2.0 * law.ratio * curve.bed.medium.modulus * rest.radius / SPRINGS  # type: ignore[attr-defined]
    sliding, shift, force = velocity.copy(), np.zeros_like(x), np.zeros_like(velocity)
    approach, before = len(motion.states), np.zeros_like(rest.radius)
    for step, interval in enumerate(motion.intervals):
        sliding -= 0.5 * interval * law.mobility * force
        share: Array | float = 1.0
        if step < approach:  # springs that the edge reaches in this step are sheared for the rest of it alone
            radius = motion.states[step].radius
            reached = (radius[:, None] - x) / np.maximum(radius - before, np.finfo(float).tiny)[:, None]
            share, before = np.clip(reached, 0.0, 1.0), radius
        shift += (sliding * interval)[:, None] * share
        borne = (
            pressed.under(motion.states[step]) if step < approach else pressed.let_go(motion.depths[step - approach])
        )
        if math.isinf(law.coefficient):
            shift[borne <= 0.0] = 0.0
        else:
            bound = law.coefficient / law.ratio * borne
            np.clip(shift, -bound, bound, out=shift)
        force = stiffness * np.sum(shift, axis=1)
        sliding -= 0.5 * interval * law.mobility * force
    return sliding


class _Pressed:
    """Displacements of springs at places x `(n, springs)` under n blows."""

    def __init__(self, bed: UnderProfile, rest: GreatestLoad, x: Array, dented: Array) -> None:
        self.bed, self.x, self.dented = bed, x, dented
        self.gap = bed.gap(x.ravel()).reshape(x.shape)
        recovery, share = rest.recovery[:, None], rest.elastic_share[:, None]
        even = np.sqrt(np.maximum(1.0 - (x / rest.radius[:, None]) ** 2, 0.0))
        whole = bed.gap(rest.radius)[:, None]
        left = recovery * (share * self.gap / whole + (1.0 - share) * (1.0 - even))
        self.left = np.where(dented, left, self.gap)

    def under(self, state: GreatestLoad) -> Array:
        """Return them on first loading [m]."""
        radius = state.radius[:, None]
        square = 1.0 - (self.x / np.maximum(radius, np.finfo(float).tiny)) ** 2
        whole = np.maximum(self.bed.gap(state.radius)[:, None], np.finfo(float).tiny)
        kept = state.elastic_share[:, None]
        shape = kept * (1.0 - self.gap / whole) + (1.0 - kept) * np.sqrt(np.maximum(square, 0.0))
        return np.where(square > 0.0, state.recovery[:, None] * shape, 0.0)

    def let_go(self, depth: Array) -> Array:
        """Return them on the dents at depths from where these would just touch [m]."""
        return np.asarray(np.maximum(depth[:, None] - self.left, 0.0))
