"""Measured forces of a contact that was pressed in at once and held at a constant depth."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from typing import Annotated

from winkler.numerics.types import Array
from winkler.problems.normal.indentation import IndentationSolution
from winkler.problems.poroelastic.held import HeldProfile, held_contact, shape_of
from winkler.values.checks.number_checks import POSITIVE, Advice, Numbers, Positive
from winkler.values.errors import InvalidInput
from winkler.values.limits import MEASURED_TIMES
from winkler.values.value import value, words

FEWEST_ROWS = 8


@value
class HeldForce:
    """A hold period: the indenter, its depth, and the force over time.

    Parameters
    ----------
    profile : Paraboloid, Sphere, Cone or FlatPunch
        The indenter.
    depth : float
        d [m], constant during the hold, positive.
    time : ndarray, (n,)
        Since the indenter reached the depth [s], positive, rising; leave out times shorter than that of pressing in.
    force : ndarray, (n,)
        F_N [N], positive, without its baseline.

    Raises
    ------
    InvalidInput
        If the rows differ in length, are too short, or contain a number that is not positive.
    """

    __words__ = words(
        time=("t", "s", "time since the depth was reached"),
        force=("F_N", "N", "force of the contact at each time"),
    )

    profile: HeldProfile
    depth: Positive
    time: Annotated[Array, Numbers(POSITIVE, FEWEST_ROWS, MEASURED_TIMES, "rising"), Advice("sort the rows")]
    force: Annotated[Array, Numbers(POSITIVE, FEWEST_ROWS, MEASURED_TIMES)]

    def __post_init__(self) -> None:
        if self.time.size != self.force.size:
            raise InvalidInput(
                f"HeldForce: time has {self.time.size} numbers and force {self.force.size}; give as many."
            )

    @functools.cached_property
    def elastic(self) -> IndentationSolution:
        """The contact on an incompressible body with a shear modulus of 1 Pa."""
        return held_contact(self.profile, self.depth, 1.0)

    @property
    def radius(self) -> float:
        """a [m]."""
        return float(self.elastic.radius)

    @property
    def unit_force(self) -> float:
        """Force at first of a body with a shear modulus of 1 Pa [N]."""
        return float(self.elastic.force)


def checked_holds(owner: str, holds: Sequence[HeldForce], fewest: int) -> tuple[HeldForce, ...]:
    """Return holds of one shape of indenter; refuse too few, or several shapes."""
    rows = tuple(holds)
    if len(rows) < fewest:
        raise InvalidInput(f"{owner}: {len(rows)} hold{'s' * (len(rows) != 1)}; give at least {fewest}.")
    shapes = sorted({shape_of(hold.profile) for hold in rows})
    if len(shapes) > 1:
        raise InvalidInput(f"{owner}: the indenters are {' and '.join(shapes)}; give holds of one shape.")
    return rows
