r"""Carter's problem: a cylinder that rolls steadily and transmits a tangential force, in plane strain.

Of the bodies the first is dragged along x, the direction of rolling, by the traction q of the second, which slips over
it with the creepage xi.  They stick from the leading edge a back to a - 2 c and slip behind it,

.. math:: q = \mu p_0\Bigl[\sqrt{1-\tfrac{x^2}{a^2}} - \tfrac ca\sqrt{1-\tfrac{(x-a+c)^2}{c^2}}\,\Bigr] , \qquad
          \frac Q{\mu P} = 1-\frac{c^2}{a^2} , \qquad \xi = \frac{\mu(a-c)}R ,

the second root within the zone of stick only.  Behind it the slip is :math:`(\mu/R)\sqrt{(x-a+c)^2-c^2}` of the speed.

References
----------
F. W. Carter, Proc. R. Soc. A 112 (1926) 151-157, doi:10.1098/rspa.1926.0100;
K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 8.3, doi:10.1017/CBO9781139171731
"""

from __future__ import annotations

import dataclasses
from typing import ClassVar

import numpy as np

from winkler.checks.place_checks import common_places, finite_places
from winkler.errors import InvalidInput, OutsideValidity
from winkler.foundation.line import LineFoundation
from winkler.laws.friction import Sliding
from winkler.loading import LineShearForce
from winkler.numerics.types import Array, ArrayLike, Quantity, shaped
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.declared import SHEARED
from winkler.problems.line.indentation import LineSolution
from winkler.problems.line.stress import LineContact, LineFields, poisson_of
from winkler.problems.line.validity import line_notes
from winkler.problems.line_rolling.pressed import (
    OneLineLoad,
    refuse_unless_round,
    rolling_stresses,
    rolling_yield_notes,
    touching_strip,
)
from winkler.problems.rolling.creepage import Creepage
from winkler.problems.which_body import in_first_body
from winkler.validity import Assumption, Note, Standing
from winkler.values import value, words

__all__ = ["CARTER", "LineRolling", "LineRollingSolution", "refuse_unless_along", "sliding_creepage"]

SLIDING_TOLERANCE = 1e-12
"""A force beyond what friction bears by no more than this part of it is that of sliding."""

CARTER = Note(
    Assumption.SLIP,
    Standing.EXACT,
    "Coulomb friction, steady rolling in plane strain: the zones of stick and slip and the tractions are Carter's.",
    "F. W. Carter, Proc. R. Soc. A 112 (1926) 151-157, doi:10.1098/rspa.1926.0100",
)


@value
class LineRolling:
    """A cylinder that rolls steadily on another body and transmits a force along the direction of rolling.

    Parameters
    ----------
    bed : LineFoundation
        Its profile a Paraboloid, the relative radius of both bodies.
    friction : Coulomb
        Its coefficient positive and finite.
    drive : LineShearForce or Creepage
        What is prescribed, one number or an array: the force per length with which the second body drags the first
        along the direction of rolling, or the longitudinal creepage.
    load : LineForce, HalfWidth or MeanPressure
        The steady normal load, one number.

    Raises
    ------
    InvalidInput
        If the profile is not round, friction not Coulomb's with a positive, finite coefficient, or the load an array.
    OutsideValidity
        If a creepage is lateral or a spin: plane strain has none.

    References
    ----------
    F. W. Carter, Proc. R. Soc. A 112 (1926) 151-157, doi:10.1098/rspa.1926.0100

    Examples
    --------
    A locomotive wheel that pulls with 64 % of what friction bears.

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading import LineForce
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> steel = Elastic(young=2.56 * 82e9, poisson=0.28)
    >>> bed = LineFoundation(Paraboloid(0.5), HalfSpace.between(steel, steel))
    >>> wheel = LineRolling(bed, Coulomb(0.3), LineShearForce(0.64 * 0.3 * 178.9e3), LineForce(178.9e3)).solve()
    >>> round(1e3 * wheel.longitudinal_creepage, 6), round(wheel.stick_share, 9)
    (0.240003, 0.6)
    """

    __words__ = words(
        bed=("", None, "profile and bodies of the line contact"),
        drive=("", None, "what is prescribed along the direction of rolling: a force per length or a creepage"),
        load=("", None, "the normal load: a force per length, a half-width or a mean pressure"),
    )

    bed: LineFoundation
    friction: Sliding
    drive: LineShearForce | Creepage
    load: OneLineLoad

    references: ClassVar[tuple[str, ...]] = ("carter_1926", "johnson_1985")
    assumptions: ClassVar[frozenset[Assumption]] = SHEARED

    def __post_init__(self) -> None:
        refuse_unless_round("LineRolling", self.bed)
        refuse_unless_along("LineRolling", self.drive)

    def solve(self) -> LineRollingSolution:
        """Return force, creepage and the zone of stick.

        Raises
        ------
        OutsideValidity
            If the bodies do not touch, or a prescribed force is more than friction bears.
        """
        contact = touching_strip("LineRolling", self.bed, self.load)
        most = self.friction.coefficient * float(contact.force_per_length)
        limit = sliding_creepage(contact, self.friction.coefficient)
        if isinstance(self.drive, LineShearForce):
            force = np.asarray(self.drive.shear_force_per_length, dtype=float)
            if np.any(np.abs(force) > most * (1.0 + SLIDING_TOLERANCE)):
                raise OutsideValidity(
                    f"LineRolling: friction bears {most:.6g} N/m, less than the {np.max(np.abs(force)):.6g} N/m given: "
                    "the bodies slide; give less, or prescribe a creepage."
                )
            ratio = np.minimum(np.abs(force) / most, 1.0)
            share = np.sqrt(1.0 - ratio)
            creepage = np.sign(force) * limit * ratio / (1.0 + share)
        else:
            creepage = np.asarray(self.drive.longitudinal, dtype=float)
            used = np.minimum(np.abs(creepage) / limit, 1.0)
            share = 1.0 - used
            force = np.sign(creepage) * most * used * (2.0 - used)
        at, given, stick = (shaped(column, np.shape(force)) for column in (creepage, force, share))
        return LineRollingSolution(self, at, given, stick, contact)


@value
class LineRollingSolution:
    """The solution of a `LineRolling`; each quantity has the shape of what was prescribed.

    Parameters
    ----------
    problem : LineRolling
        The problem that was solved.
    longitudinal_creepage : float or ndarray
        xi [-]; at a prescribed force at which all slides the least one.
    shear_force_per_length : float or ndarray
        Q [N/m], with which the second body drags the first along the direction of rolling.
    stick_share : float or ndarray
        Part of the width that sticks, c/a [-].
    contact : LineSolution
        The contact under its normal load.
    """

    __words__ = words(stick_share=("c/a", "", "part of the width that sticks"))

    problem: LineRolling
    longitudinal_creepage: Quantity
    shear_force_per_length: Quantity
    stick_share: Quantity
    contact: LineSolution

    @property
    def traction_ratio(self) -> Quantity:
        """Q / (mu P) [-]; one where the bodies slide."""
        most = self.problem.friction.coefficient * float(self.contact.force_per_length)
        return shaped(np.abs(np.asarray(self.shear_force_per_length)) / most)

    @property
    def loss_per_area(self) -> Quantity:
        """Energy lost per distance rolled and length of the cylinder, xi Q [J/m^2], never negative."""
        return shaped(np.asarray(self.longitudinal_creepage) * np.asarray(self.shear_force_per_length))

    def power(self, speed: float) -> Quantity:
        """Return the power that friction turns into heat [W/m] at a speed of rolling [m/s]."""
        return shaped(abs(speed) * np.asarray(self.loss_per_area))

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
        behind = np.maximum((a - x) * (a - 2.0 * c - x), 0.0)
        rate = np.sqrt(behind) * abs(mu) / self.problem.bed.profile.curvature_radius  # type: ignore[attr-defined]
        beyond = abs(float(self.longitudinal_creepage)) - sliding_creepage(self.contact, abs(mu))
        rate += max(beyond, 0.0) if c == 0.0 else 0.0
        return np.asarray(np.sign(mu) * np.where((np.abs(x) <= a) & (x <= a - 2.0 * c), rate, 0.0))

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
            If the body is rigid or not isotropic.
        """
        a, c, mu = self._one("stresses")
        place, depth = common_places("LineRollingSolution.stresses", x=x, z=z)
        below = in_first_body(depth, "LineRollingSolution")
        poisson = poisson_of(self.problem.bed.medium, below)
        contact = LineContact(self.problem.bed, a, 0.0, poisson, mu if below else -mu)
        fields = rolling_stresses(contact, c, place, np.abs(depth))
        return fields if below else dataclasses.replace(fields, z=-fields.z)

    def _one(self, requested: str) -> tuple[float, float, float]:
        """Return a, c [m], and mu with the sign of the force."""
        if np.ndim(self.stick_share) > 0:
            raise InvalidInput(
                f"LineRollingSolution.{requested}: many forces or creepages were prescribed; solve for one of them."
            )
        a, sign = float(self.contact.half_width), float(np.sign(self.shear_force_per_length)) or 1.0
        return a, float(self.stick_share) * a, sign * self.problem.friction.coefficient

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        bed, mu = self.problem.bed, self.problem.friction.coefficient
        index = int(np.argmax(np.abs(self.shear_force_per_length)))
        force, share = (float(np.ravel(column)[index]) for column in (self.shear_force_per_length, self.stick_share))
        strip = line_notes(bed, float(self.contact.half_width))
        yielding = rolling_yield_notes(self.contact, mu if force >= 0.0 else -mu, share)
        return (*strip, sticking_note(bed.medium, mu), CARTER, *yielding)  # type: ignore[arg-type]


def sliding_creepage(contact: LineSolution, coefficient: float) -> float:
    """Return the creepage from which all of a pressed cylinder slides, mu a / R [-]."""
    radius = contact.problem.bed.profile.curvature_radius  # type: ignore[attr-defined]
    return coefficient * float(contact.half_width) / float(radius)


def refuse_unless_along(owner: str, drive: LineShearForce | Creepage) -> None:
    """Refuse creepages that plane strain does not know.

    Raises
    ------
    OutsideValidity
    """
    if isinstance(drive, Creepage) and (np.any(np.asarray(drive.lateral) != 0.0) or np.any(np.asarray(drive.spin))):
        raise OutsideValidity(
            f"{owner}: the creepage has a lateral part or a spin, and a cylinder in plane strain has neither; give "
            "Creepage(longitudinal=...)."
        )
