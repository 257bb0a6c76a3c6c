r"""Creepage: how much faster than mere rolling one body moves over the other, per distance rolled.

While a pair rolls with the speed V along +x, the second body slips over the first, at the place (x, y) of the contact
and were both rigid, with the velocity

.. math:: w_x = V\,(\xi - \varphi\,y), \qquad w_y = V\,(\eta + \varphi\,x) .

The traction with which the second body drags the first points in the direction of slip: a positive creepage makes a
positive force.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from winkler.numerics.types import ZERO, Array, PerLoad, Q, shaped
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words

LARGEST_CREEPAGE = {"longitudinal": 1e9, "lateral": 1e9, "spin": math.inf}
"""Beyond it nothing rolls any more; for spin only the size of the contact decides."""
UNITS = {"longitudinal": "", "lateral": "", "spin": " in 1/m"}


@value
class Creepage(PerLoad[Q]):
    """The creepages of a rolling pair: velocity of the second body relative to the first, over the rolling speed.

    Parameters
    ----------
    longitudinal : float or ndarray, optional
        xi [-] along the rolling direction; positive values give a traction on the first body along +x.
    lateral : float or ndarray, optional
        eta [-], across it.
    spin : float or ndarray, optional
        phi [1/m], rotation about the normal of the contact per distance rolled.

    All three may be arrays whose shapes broadcast; the results have the common shape.

    Raises
    ------
    InvalidInput
        If a number is not finite, a slip beyond 1e9, or the shapes do not broadcast.

    References
    ----------
    J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9
    """

    __words__ = words(
        longitudinal=(r"\xi", "", "creepage along the direction of rolling"),
        lateral=(r"\eta", "", "creepage across the direction of rolling"),
        spin=(r"\varphi", "1/m", "rotation about the normal per distance rolled"),
        shape=("", None, "the common shape of the three"),
    )

    longitudinal: Q = ZERO
    lateral: Q = ZERO
    spin: Q = ZERO

    def __post_init__(self) -> None:
        for word, unit in UNITS.items():
            prescribed = np.asarray(getattr(self, word))
            good = prescribed.dtype.kind in "fiu" and prescribed.size > 0 and np.all(np.isfinite(prescribed))
            if not good or np.any(np.abs(prescribed) > LARGEST_CREEPAGE[word]):
                most = f", of at most {LARGEST_CREEPAGE[word]:g}" if math.isfinite(LARGEST_CREEPAGE[word]) else ""
                shown = " ".join(repr(getattr(self, word)).split())  # arrays are written in lines
                raise InvalidInput(f"Creepage: {word} is {shown}; give a number{unit}, or an array of them{most}.")
        try:
            np.broadcast_shapes(*(np.shape(getattr(self, word)) for word in UNITS))
        except ValueError:
            shapes = ", ".join(f"{word} {np.shape(getattr(self, word))}" for word in UNITS)
            raise InvalidInput(f"Creepage: the shapes do not fit each other: {shapes}; give one shape.") from None

    @property
    def shape(self) -> tuple[int, ...]:
        """The common shape; empty for one creepage."""
        return np.broadcast_shapes(*(np.shape(getattr(self, word)) for word in UNITS))

    def broadcast(self) -> tuple[Array, Array, Array]:
        """Return xi, eta and phi, each ``(m,)``: the common shape, flattened."""
        along, across, turning = np.broadcast_arrays(
            *(np.asarray(part, dtype=float) for part in (self.longitudinal, self.lateral, self.spin))
        )
        return along.ravel(), across.ravel(), turning.ravel()


@value
class CreepageSolution(PerLoad[Q]):
    """The part of a solution that follows from its creepages and forces, each in the shape of the creepage.

    Parameters
    ----------
    problem
        The problem that was solved.
    longitudinal_force, lateral_force : float or ndarray
        F_x and F_y [N], with which the second body drags the first.
    """

    problem: Any
    longitudinal_force: Q
    lateral_force: Q

    @property
    def longitudinal_creepage(self) -> Q:
        """xi [-], in the shape of the results."""
        return shaped(np.broadcast_to(self.problem.creepage.longitudinal, self.problem.creepage.shape))

    @property
    def lateral_creepage(self) -> Q:
        """eta [-], in the shape of the results."""
        return shaped(np.broadcast_to(self.problem.creepage.lateral, self.problem.creepage.shape))

    @property
    def shear_force(self) -> Q:
        """The resultant of both forces [N]."""
        return shaped(np.hypot(self.longitudinal_force, self.lateral_force))

    @property
    def loss_per_distance(self) -> Q:
        """Energy lost per distance rolled [J/m]: creepage times force, never negative."""
        creep = self.problem.creepage
        lost = np.asarray(creep.longitudinal) * self.longitudinal_force + np.asarray(creep.lateral) * self.lateral_force
        return shaped(lost)
