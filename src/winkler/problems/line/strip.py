"""One strip of contact: pressure, distance of the surfaces, stresses and approach, from its half-width and edge load.

The edge bears a load per length beside that of the profile where a rim pins it (a push) or adhesion holds it (a pull):
that of a flat punch of the half-width a.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.media.offers import PlaneMedium, offers
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.line.approach import approach
from winkler.problems.line.layered_approach import layered_approach
from winkler.problems.line.layered_stress import fields_below
from winkler.problems.line.references import Reference
from winkler.problems.line.stress import LineFields, Strip, one_coefficient
from winkler.problems.which_body import in_first_body
from winkler.values.checks.place_checks import common_places, finite_places
from winkler.values.errors import OutsideValidity


class Stressed:
    """A solution whose pressures, and stresses below the surface, are known."""

    problem: Any

    @property
    def _bed(self) -> Any:
        """What `winkler.problems.line.stress.LineContact` takes for a bed."""
        return self.problem.bed

    def _strip(self, requested: str) -> Strip:
        """Return the strip of one load; refuse many."""
        raise NotImplementedError

    def pressure(self, x: ArrayLike) -> Array:
        """Return the pressure under one load [Pa], zero outside of the contact.

        Parameters
        ----------
        x : array_like
            Places on the surface [m], on either side of the middle.

        Raises
        ------
        InvalidInput
            If the solution has more than one load.
        """
        a, edge_load = self._strip("pressure")
        x = finite_places(f"{type(self).__name__}.pressure", "x", x)
        if a == 0.0:
            return np.zeros(x.shape)
        return np.asarray(self._bed.pressure(x, a, edge_load))

    def stresses(self, x: ArrayLike, z: ArrayLike, friction: float = 0.0) -> LineFields:
        """Return the stresses below the surface under one load.

        Parameters
        ----------
        x : array_like
            Places along the surface [m].
        z : array_like
            Depths [m]: not negative in the first body, negative in the second, of which -0.0 is the surface.
            All in one of them. A place on an interface of layers belongs to the upper one.
        friction : float
            mu [-] of a contact that slides everywhere: the body is dragged along x by mu p, against it if negative.

        Raises
        ------
        InvalidInput
            If the solution has more than one load, or the depths lie in both bodies.
        OutsideValidity
            If there is no contact, or the body is rigid, not isotropic or graded.
        """
        owner = type(self).__name__
        place, depth = common_places(f"{owner}.stresses", x=x, z=z)
        below, coefficient = in_first_body(depth, owner), one_coefficient(owner, friction)
        return fields_below(self._bed, self._touching("stresses"), place, depth, below, coefficient)

    def _touching(self, requested: str) -> Strip:
        """Return the strip of one load; refuse one without contact."""
        strip = self._strip(requested)
        if strip.half_width == 0.0:
            raise OutsideValidity("The bodies do not touch, so there are no stresses; press harder.")
        return strip


class OfStrip(Stressed):
    """The part of a solution that one strip determines."""

    def separation(self, x: ArrayLike) -> Array:
        """Return the distance of the deformed surfaces under one load [m], zero inside of the contact.

        Parameters
        ----------
        x : array_like
            Places on the surface [m], as of `pressure`.

        Raises
        ------
        InvalidInput
            As of `pressure`.
        OutsideValidity
            If the contact is pinned at a rim, beyond which the body has no surface.
        """
        a, edge_load = self._strip("separation")
        bed = self._bed
        away = np.abs(finite_places(f"{type(self).__name__}.separation", "x", x))
        if a >= bed.rim:
            raise OutsideValidity("The contact is pinned at the rim, beyond which the body has no surface.")
        return np.asarray(bed.separation(away, a, edge_load))

    def approach(self, first: float | Reference | None = None, second: float | Reference | None = None) -> float:
        """Return how far two points on the axis have come together under one load [m], one in each body.

        Parameters
        ----------
        first, second : float, RollerCentre or PlateBase
            Depths of the points below the surfaces of half-planes [m], or finite bodies; that in a rigid body may be
            left out. Below layers it is a depth in the body that carries them, counted from the surface.

        Raises
        ------
        InvalidInput
            If a reference is not stated: a line contact has no depth of its own; or if there are many loads.
        OutsideValidity
            If the medium is not a `HalfSpace`, or the strip is wider than a fifth of a finite body.
        """
        a, edge_load = self._strip("approach")
        measured = layered_approach if offers(self._bed.medium, PlaneMedium) else approach
        return measured(self._bed, a, edge_load, first, second)
