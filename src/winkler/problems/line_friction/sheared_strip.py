"""What sheared line contacts have in common: the pressure of their half-width, and where stresses are computed."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.foundation.line_bed import LineBed
from winkler.numerics.types import Array, ArrayLike, ComplexArray, PerLoad, Q
from winkler.problems.line.peak_pressure import rim_load
from winkler.problems.line.stress import LineFields, Strip, fields_of, poisson_of, potential_of
from winkler.problems.which_body import in_first_body
from winkler.values.checks.place_checks import common_places, finite_places
from winkler.values.errors import OutsideValidity
from winkler.values.value import value


@value
class LineSlip(PerLoad[Q]):
    """A sheared line contact at a point, or at all points of its path.

    Parameters
    ----------
    force_per_length, half_width : float or ndarray, (points,)
        P [N/m], a [m].
    shear_force_per_length, bulk_stress : float or ndarray, (points,)
        Q [N/m] along x on the first body; stress along x in it far from the contact [Pa].
    slip_shift : float or ndarray, (points,)
        By how much the second body is shifted along x beyond what Q causes where the present strip sticks [m]: by slip,
        and because the strip was narrower before.
    dissipation_per_length : float or ndarray, (points,)
        Energy lost since the beginning, per length [J/m].
    """

    force_per_length: Q
    half_width: Q
    shear_force_per_length: Q
    bulk_stress: Q
    slip_shift: Q
    dissipation_per_length: Q


class ShearedStrip(LineSlip[float]):
    """The part of a sheared line contact at one point of its path that no friction alters, and its stresses."""

    bed: LineBed

    def pressure(self, x: ArrayLike) -> Array:
        """Return the pressure [Pa] at places x [m], zero outside of the contact."""
        x = finite_places(f"{type(self).__name__}.pressure", "x", x)
        if self.half_width == 0.0:
            return np.zeros(x.shape)
        return self.bed.pressure(x, self.half_width, rim_load(self.bed, self.force_per_length, self.half_width))

    def stresses(self, x: ArrayLike, z: ArrayLike) -> LineFields:
        """Return the stresses below the surface: of pressure and traction, and in the first body the bulk stress.

        Parameters
        ----------
        x : array_like
            Places along the surface [m].
        z : array_like
            Depths [m]: not negative in the first body, negative in the second, of which -0.0 is the surface.
            All in one of them.

        Raises
        ------
        InvalidInput
            If the depths lie in both bodies.
        OutsideValidity
            If there is no contact, or the body is rigid.
        """
        owner = type(self).__name__
        along, depth = common_places(f"{owner}.stresses", x=x, z=z)
        below = in_first_body(depth, owner)
        if self.half_width == 0.0:
            raise OutsideValidity("The bodies do not touch, so there are no stresses; press harder.")
        self._refuse_stresses()
        poisson, bulk = poisson_of(self.bed.medium, below), self.bulk_stress if below else 0.0
        deep, strip = np.abs(depth), Strip(self.half_width, rim_load(self.bed, self.force_per_length, self.half_width))
        pressed = potential_of(self.bed, strip, along, deep)
        dragged = self._dragged(along, deep, pressed)
        if dragged is not None and not below:
            dragged = -dragged
        return dataclasses.replace(fields_of(along, deep, pressed, poisson, dragged, bulk), z=depth)

    def _refuse_stresses(self) -> None:
        """Refuse stresses that are not computed."""

    def _dragged(self, x: Array, deep: Array, pressed: ComplexArray) -> ComplexArray | None:
        """Return F and z F' [Pa] of the traction on the first body at these distances from the surface, if any."""
        raise NotImplementedError
