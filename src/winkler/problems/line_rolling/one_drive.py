"""What a rolling cylinder does under one drive, place by place: pressure, traction, slip and stresses."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from winkler.numerics.types import Array, ArrayLike, PerLoad, Q
from winkler.problems.line.indentation import LineSolution
from winkler.problems.line.stress import LineContact, LineFields, poisson_of
from winkler.problems.line_rolling.pressed import rolling_stresses
from winkler.problems.line_rolling.rolled_strip import RolledStrip, sliding_creepage
from winkler.problems.line_rolling.strip_stresses import strip_stresses
from winkler.problems.which_body import in_first_body
from winkler.values.checks.place_checks import common_places, finite_places
from winkler.values.errors import InvalidInput, OutsideValidity


class UnderOneDrive(PerLoad[Q]):
    """The part of the solution of a `LineRolling` that belongs to one force or creepage: fields by place."""

    problem: Any
    longitudinal_creepage: Q
    shear_force_per_length: Q
    stick_share: Q
    contact: LineSolution[float]
    strips: tuple[RolledStrip, ...]

    def traction(self, x: ArrayLike) -> Array:
        """Return the traction on the first body [Pa] under one drive, along the direction of rolling.

        Parameters
        ----------
        x : array_like
            Places on the surface [m], the leading edge at +a.

        Raises
        ------
        InvalidInput
            If an array was prescribed.
        """
        a, c, mu = self._one("traction")
        x = finite_places("LineRollingSolution.traction", "x", x)
        if self.strips:
            return np.asarray(self.problem.bed.medium.modulus * self._nodal(x, self.strips[0].traction))
        pressure = self.contact.pressure(x)
        inner = self.problem.bed.pressure(x - (a - c), c, 0.0) if c > 0.0 else np.zeros(x.shape)
        return mu * (pressure - inner)

    def slip(self, x: ArrayLike) -> Array:
        """Return how fast the second surface slips over the first, over the speed of rolling [-], under one drive.

        Parameters
        ----------
        x : array_like
            Places on the surface [m]; zero outside of the contact and where it sticks.

        Raises
        ------
        InvalidInput
            If an array was prescribed.
        """
        a, c, mu = self._one("slip")
        x = finite_places("LineRollingSolution.slip", "x", x)
        if self.strips:
            strip = self.strips[0]
            within = (strip.x[0] <= x / a) & (x / a <= strip.x[-1])
            return np.where(within, np.interp(x / a, 0.5 * (strip.x[1:] + strip.x[:-1]), strip.slip), 0.0)
        bed = self.problem.bed
        behind = np.maximum((a - x) * (a - 2.0 * c - x), 0.0)
        away = np.sqrt(behind + c * c)  # from the middle of what sticks
        opens = np.sqrt(behind) / bed.profile.curvature_radius if bed.hertzian else bed.opening(away, c)
        rate = opens * abs(mu) * bed.along_share
        beyond = abs(float(self.longitudinal_creepage)) - sliding_creepage(bed, a, abs(mu))
        rate += max(beyond, 0.0) if c == 0.0 else 0.0
        return np.asarray(np.sign(mu) * np.where((np.abs(x) <= a) & (x <= a - 2.0 * c), rate, 0.0))

    def pressure(self, x: ArrayLike) -> Array:
        """Return the pressure [Pa] under one drive, that of the contact unless pressure and traction are coupled.

        Parameters
        ----------
        x : array_like
            Places on the surface [m], the leading edge at +a.

        Raises
        ------
        InvalidInput
            If an array was prescribed.
        """
        self._one("pressure")
        x = finite_places("LineRollingSolution.pressure", "x", x)
        if not (self.strips and self.problem.coupled):
            return self.contact.pressure(x)
        return np.asarray(self.problem.bed.medium.modulus * self._nodal(x, self.strips[0].pressure))

    def _nodal(self, x: Array, row: Array) -> Array:
        """Return a row of the strip by place, straight between the nodes."""
        return np.asarray(np.interp(x / float(self.contact.half_width), self.strips[0].x, row))

    def stresses(self, x: ArrayLike, z: ArrayLike) -> LineFields:
        """Return the stresses below the surface under one drive, of pressure and traction.

        Parameters
        ----------
        x : array_like
            Places along the surface [m], the leading edge at +a.
        z : array_like
            Depths [m]: not negative in the first body, which is dragged along x by a positive force; negative in the
            second, of which -0.0 is the surface, dragged against it.  All in one of them; stresses are in the body's
            own axes, z into it.

        Raises
        ------
        InvalidInput
            If an array was prescribed, or the depths lie in both bodies.
        OutsideValidity
            If the body is rigid or not isotropic, or there are layers.
        """
        a, c, mu = self._one("stresses")
        if not self.problem.bed.hertzian:
            raise OutsideValidity(
                "LineRollingSolution: the stresses inside layers under the traction of rolling are not built in; those "
                "of a contact that slides everywhere are, with LineIndentation and stresses(x, z, friction=...)."
            )
        place, depth = common_places("LineRollingSolution.stresses", x=x, z=z)
        below, deep = in_first_body(depth, "LineRollingSolution"), np.abs(depth)
        poisson = poisson_of(self.problem.bed.medium, below)
        if self.strips:
            fields = strip_stresses(self.strips[0], a, self.problem.bed.medium.modulus, poisson, below, place, deep)
        else:
            contact = LineContact(self.problem.bed, a, 0.0, poisson, mu if below else -mu)
            fields = rolling_stresses(contact, c, place, deep)
        return dataclasses.replace(fields, z=depth)

    def _one(self, requested: str) -> tuple[float, float, float]:
        """Return a, c [m], and mu with the sign of the force."""
        if np.ndim(self.stick_share) > 0:
            raise InvalidInput(
                f"LineRollingSolution.{requested}: many forces or creepages were prescribed; solve for one of them."
            )
        a, sign = float(self.contact.half_width), float(np.sign(self.shear_force_per_length)) or 1.0
        return a, float(self.stick_share) * a, sign * self.problem.friction.coefficient
