r"""Carter's problem: a cylinder that rolls steadily and transmits a tangential force, in plane strain.

Of the bodies the first is dragged along x, the direction of rolling, by the traction q of the second, which slips over
it with the creepage xi.  They stick from the leading edge a back to a - 2 c and slip behind it,

.. math:: q = \mu p_0\Bigl[\sqrt{1-\tfrac{x^2}{a^2}} - \tfrac ca\sqrt{1-\tfrac{(x-a+c)^2}{c^2}}\,\Bigr] , \qquad
          \frac Q{\mu P} = 1-\frac{c^2}{a^2} , \qquad \xi = \frac{\mu(a-c)}R ,

the second root within the zone of stick only.  Behind it the slip is :math:`(\mu/R)\sqrt{(x-a+c)^2-c^2}` of the speed.
On bodies graded by a power k of the depth the pressures are those of this medium, and
:math:`Q/\mu P = 1-(c/a)^{2+k}`.
Bodies that are elastically dissimilar creep even without a force, and layers answer the traction in another manner
than the pressure: then the strip is divided into elements (`winkler.problems.line_rolling.rolled_strip`).

References
----------
F. W. Carter, Proc. R. Soc. A 112 (1926) 151-157, doi:10.1098/rspa.1926.0100;
K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 8.3, doi:10.1017/CBO9781139171731
"""

from __future__ import annotations

import functools
from typing import ClassVar

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.laws.friction import Sliding
from winkler.loading.loads import LineShearForce
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.declared import SHEARED
from winkler.problems.line.indentation import LineSolution
from winkler.problems.line_friction.validity import slid_yield_notes
from winkler.problems.line_rolling.one_drive import UnderOneDrive
from winkler.problems.line_rolling.pressed import (
    OneLineLoad,
    refuse_unless_along,
    refuse_unless_round,
    rolling_yield_notes,
    touching_strip,
)
from winkler.problems.line_rolling.rolled_strip import (
    RolledStrip,
    load_growth,
    loss_error,
    rolled_strip,
    sliding_creepage,
)
from winkler.problems.line_rolling.strip_stresses import FULL_COUPLING, rolled_yield_notes, strip_note
from winkler.problems.rolling.creepage import Creepage
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

SLIDING_TOLERANCE = 1e-12
"""A force beyond what friction bears by no more than this part of it is that of sliding."""

CARTER = Note(
    Assumption.SLIP,
    Standing.EXACT,
    "Coulomb friction, steady rolling in plane strain. Stick zone, slip zone and tractions are those of Carter.",
    "F. W. Carter, Proc. R. Soc. A 112 (1926) 151-157, doi:10.1098/rspa.1926.0100",
)
NOT_COUPLED = Note(
    Assumption.UNCOUPLED,
    Standing.EXACT,
    "The bodies are elastically similar: pressure and traction are uncoupled, and `coupled` has no effect.",
    "Dundurs' constant beta is zero",
)


@value
class LineRolling(PerLoad[Q]):
    """A cylinder that rolls steadily on another body and transmits a force along the direction of rolling.

    Parameters
    ----------
    bed : LineFoundation, LayeredLineFoundation or PowerLawLineFoundation
        A foundation with a Paraboloid of the relative radius of both bodies; on layers that transmit shear to the base,
        or on a body graded with depth.
    friction : Coulomb
        Friction; its coefficient must be positive and finite.
    drive : LineShearForce or Creepage
        One number or an array: the force per length on the first body along the rolling direction, or the longitudinal
        creepage.
    load : LineForce, HalfWidth or MeanPressure
        The steady normal load, one number.
    coupled : bool, optional
        Whether the coupling of pressure and traction is included, for dissimilar bodies and for layers. If False it is
        neglected (Carter).  On layers, and for coupled bodies, the strip is divided into 400 elements, dense at both
        edges, with the normal load of the frictionless contact.

    Raises
    ------
    InvalidInput
        If the profile is not round, friction not Coulomb's with a positive, finite coefficient, or the load an array.
    OutsideValidity
        If the creepage has a lateral or spin component, which plane strain excludes. If a layer slides on the material
        below, or the bodies are viscoelastic.

    References
    ----------
    F. W. Carter, Proc. R. Soc. A 112 (1926) 151-157, doi:10.1098/rspa.1926.0100

    Examples
    --------
    A locomotive wheel that pulls with 64 % of what friction bears.

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading.loads import LineForce
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
        coupled=("", None, "whether pressure and traction of dissimilar bodies act on each other"),
    )

    bed: LineFoundation | LayeredLineFoundation | PowerLawLineFoundation
    friction: Sliding
    drive: LineShearForce[Q] | Creepage[Q]
    load: OneLineLoad
    coupled: bool = False

    references: ClassVar[tuple[str, ...]] = ("carter_1926", "johnson_1985", "bentall_johnson_1967")
    assumptions: ClassVar[frozenset[Assumption]] = SHEARED

    def __post_init__(self) -> None:
        refuse_unless_round("LineRolling", self.bed)
        refuse_unless_along("LineRolling", self.drive)
        _ = self.bed.along_share

    def solve(self) -> LineRollingSolution[Q]:
        """Return force, creepage and stick zone.

        Raises
        ------
        OutsideValidity
            If the bodies do not touch, or a prescribed force exceeds the friction limit.
        NotConverged
            If pressure and traction are not found.
        """
        contact = touching_strip("LineRolling", self.bed, self.load)
        most = self.friction.coefficient * float(contact.force_per_length)
        by_elements = not self.bed.sheared_as_pressed or (self.coupled and not self.bed.similar)
        growth = load_growth(self.bed, float(contact.half_width))
        limit = sliding_creepage(self.bed, float(contact.half_width), self.friction.coefficient)
        if isinstance(self.drive, LineShearForce):
            force = np.asarray(self.drive.shear_force_per_length, dtype=float)
            if np.any(np.abs(force) > most * (1.0 + SLIDING_TOLERANCE)):
                raise OutsideValidity(
                    f"LineRolling: the friction limit is {most:.6g} N/m, less than the given "
                    f"{np.max(np.abs(force)):.6g} N/m: the bodies slide; give less, or prescribe a creepage."
                )
            if by_elements:
                return self._by_nodes(contact, np.clip(force, -most, most))
            ratio = np.minimum(np.abs(force) / most, 1.0)
            with np.errstate(divide="ignore"):
                used = -np.expm1(np.log1p(-ratio) / growth)
            share, creepage = 1.0 - used, np.sign(force) * limit * used
        elif by_elements:
            return self._by_nodes(contact, np.asarray(self.drive.longitudinal, dtype=float))
        else:
            creepage = np.asarray(self.drive.longitudinal, dtype=float)
            used = np.minimum(np.abs(creepage) / limit, 1.0)
            share = 1.0 - used
            with np.errstate(divide="ignore"):
                force = np.sign(creepage) * most * -np.expm1(growth * np.log1p(-used))
        columns: list[Q] = [shaped(column, np.shape(force)) for column in (creepage, force, share)]
        at, given, stick = columns
        return LineRollingSolution(self, at, given, stick, contact)

    def _by_nodes(self, contact: LineSolution[float], drives: Array) -> LineRollingSolution[Q]:
        """Return the solution on elements."""
        a, modulus = float(contact.half_width), self.bed.medium.modulus
        by_force = isinstance(self.drive, LineShearForce)
        strip = functools.partial(
            rolled_strip, self.bed, a, self.friction.coefficient, coupled=self.coupled and not self.bed.similar
        )
        strips = tuple(
            strip(force=one / (modulus * a)) if by_force else strip(creepage=one) for one in np.ravel(drives).tolist()
        )
        rows = zip(*((strip.creepage, modulus * a * strip.force, strip.stick_share) for strip in strips), strict=True)
        columns: list[Q] = [shaped(np.array(row), np.shape(drives)) for row in rows]
        at, force, stick = columns
        force = shaped(drives) if by_force else force  # that of the elements misses it by rounding
        return LineRollingSolution(self, at, force, stick, contact, strips)


@value
class LineRollingSolution(UnderOneDrive[Q]):
    """The solution of a `LineRolling`; each quantity has the shape of the prescribed one.

    Parameters
    ----------
    problem : LineRolling
        The problem that was solved.
    longitudinal_creepage : float or ndarray
        xi [-]. At a prescribed force equal to the friction limit it is the smallest possible creepage.
    shear_force_per_length : float or ndarray
        Q [N/m] on the first body along the rolling direction.
    stick_share : float or ndarray
        Width of the stick zone over that of the contact, c/a [-].
    contact : LineSolution
        The contact under its normal load.
    strips : tuple of RolledStrip
        For coupled bodies and layers: pressure and traction at the nodes, for every prescribed force or creepage.
    """

    __words__ = words(
        stick_share=("c/a", "", "part of the width that sticks"),
        loss_error=(r"\Delta w", "J/m^2", "bound of the error of the energy lost per area"),
        strips=("", None, "pressure and traction of coupled bodies and layers, node by node"),
    )

    problem: LineRolling[Q]
    longitudinal_creepage: Q
    shear_force_per_length: Q
    stick_share: Q
    contact: LineSolution[float]
    strips: tuple[RolledStrip, ...] = ()

    @property
    def traction_ratio(self) -> Q:
        """Q / (mu P) [-]; one where the bodies slide."""
        most = self.problem.friction.coefficient * float(self.contact.force_per_length)
        return shaped(np.abs(np.asarray(self.shear_force_per_length)) / most)

    @property
    def loss_per_area(self) -> Q:
        """Dissipated energy per rolling distance and length of the cylinder [J/m^2]: xi Q for similar bodies."""
        if self.strips:
            unit = self.problem.bed.medium.modulus * float(self.contact.half_width)
            losses = np.array([unit * strip.loss for strip in self.strips])
            return shaped(losses, np.shape(self.longitudinal_creepage))
        return shaped(np.asarray(self.longitudinal_creepage) * np.asarray(self.shear_force_per_length))

    @property
    def loss_error(self) -> Q:
        """Bound of the error of `loss_per_area` [J/m^2]; zero for uncoupled half-planes (closed form)."""
        found = np.zeros(np.shape(self.longitudinal_creepage))
        if self.strips:
            unit, slope = self.problem.bed.medium.modulus * float(self.contact.half_width), self._slope
            found = np.reshape([unit * loss_error(strip, slope) for strip in self.strips], found.shape)
        return shaped(found)

    @property
    def _slope(self) -> float:
        """a/R [-] of the contact without friction."""
        return float(self.contact.half_width) / float(self.problem.bed.profile.curvature_radius)  # type: ignore[attr-defined]

    def power(self, speed: float) -> Q:
        """Return the power that friction turns into heat [W/m] at a speed of rolling [m/s]."""
        return shaped(abs(speed) * np.asarray(self.loss_per_area))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        bed, mu = self.problem.bed, self.problem.friction.coefficient
        index = int(np.argmax(np.abs(self.shear_force_per_length)))
        force, share = (float(np.ravel(column)[index]) for column in (self.shear_force_per_length, self.stick_share))
        bodies = tuple(note for note in self.contact.validity if note.assumption is not Assumption.ELASTIC)
        coupling = (FULL_COUPLING,) if self.strips and self.problem.coupled else (sticking_note(bed.medium, mu),)  # type: ignore[arg-type]
        if self.strips:
            rolled = self.strips[index]
            return (*bodies, *coupling, strip_note(rolled, self._slope), *self._yield_notes(rolled))
        yielding = rolling_yield_notes(self.contact, mu if force >= 0.0 else -mu, share)
        similar = (NOT_COUPLED,) if self.problem.coupled else ()
        return (*bodies, *coupling, *similar, CARTER, *yielding)

    def _yield_notes(self, strip: RolledStrip) -> tuple[Note, ...]:
        """Return whether the bodies stay elastic; of layers, whose stresses are not known, if all slid."""
        if self.problem.bed.hertzian:
            return rolled_yield_notes(self.contact, strip)
        return slid_yield_notes(self.contact, self.problem.friction, 0.0)
