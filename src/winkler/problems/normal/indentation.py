r"""Normal contact without friction or adhesion: a bed pressed by a force, to a depth, or to a contact radius.

The springs at :math:`|x|<a` are compressed by :math:`d-g(x)`, the last one just touches, :math:`g(a)=d`, and

.. math:: F = k(a)\,d - \int_0^a k'(x)\,g(x)\,\mathrm dx, \qquad \frac{\mathrm dF}{\mathrm dd} = k(a), \qquad
          U = \tfrac12\int_0^a k'(x)\,(d-g(x))^2\,\mathrm dx .

At a vertical rim the contact is pinned: d then grows beyond g(a).

The greatest pressure of a contact without friction, wherever it is.

Where the body is smooth it is finite, for a paraboloid in the middle, :math:`p_0 = 3F/(2\pi a^2)`; at a pointed apex,
at a jump of the slope and at a sharp rim it is infinite.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import ClassVar

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings
from winkler.foundation.footprint import EllipticOutline
from winkler.loading.loads import Depth, Force, Radius
from winkler.numerics.equations.highest import highest_of_curve
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array, PerLoad, Q, like
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.normal.solve_contact import at_depth, at_force, at_radius
from winkler.problems.normal.validity import indentation_notes
from winkler.problems.normal.yield_statement import FRICTIONLESS, SurfaceFriction
from winkler.problems.one_load import picked, single
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value


@value
class Indentation(PerLoad[Q]):
    """A body pressed into another one.

    Parameters
    ----------
    bed : Bed
        The springs: Foundation(profile, medium) or PlaneFoundation(plane_profile, medium).
    load : Force, Depth or Radius
        The prescribed quantity. For an array the results have its shape.

    References
    ----------
    I. N. Sneddon, Int. J. Eng. Sci. 3 (1965) 47-57, doi:10.1016/0020-7225(65)90019-4

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(10e-3), HalfSpace.between(Elastic(210e9, 0.3)))
    >>> contact = Indentation(bed, Force(100.0)).solve()
    >>> round(contact.radius * 1e6, 4)  # (3 F R / (4 E*))^(1/3) in micrometres
    148.1248
    """

    bed: Bed
    load: Force[Q] | Depth[Q] | Radius[Q]

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "galin_1946", "sneddon_1965", "popov_2013")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED
    needs_round: ClassVar[str] = ""

    def solve(self) -> IndentationSolution[Q]:
        """Return depth, force and contact radius.

        Returns
        -------
        IndentationSolution

        Raises
        ------
        OutsideValidity
            If the load is tensile, is beyond the reach of the profile, or gives a contact that is not a disc. The
            message names the indices of an array.
        """
        solver: Callable[[Bed, Array], tuple[Array, Array]]
        match self.load:
            case Depth(prescribed):
                solver = at_depth
            case Force(prescribed):
                solver = at_force
            case Radius(prescribed):
                solver = at_radius
        load = np.asarray(prescribed, dtype=float)
        load = load if load.ndim == 1 else load.ravel()
        depth, radius = solver(self.bed, load)
        if solver is not at_force:
            load = self.bed.stiffness(radius) * depth - self.bed.gap_load(radius)
        if solver is at_depth:
            load = np.where(radius > 0.0, load, 0.0)
        for part in (depth, load, radius):
            part.flags.writeable = False  # the solution keeps them without a copy
        return IndentationSolution(self, *(like(part, prescribed) for part in (depth, load, radius)))


@value
class IndentationSolution(PerLoad[Q]):
    """The solution of an `Indentation`; every quantity has the shape of the load.

    Parameters
    ----------
    problem : Indentation
        The problem that was solved.
    depth : float or ndarray
        d [m].
    force : float or ndarray
        F_N [N], compression positive.
    radius : float or ndarray
        a [m], zero where there is no contact.
    """

    problem: Indentation[Q]
    depth: Q
    force: Q
    radius: Q

    per_load: ClassVar[str] = "depth"

    @property
    def stiffness(self) -> Q:
        """dF/dd = k(a) [N/m]."""
        return like(self.problem.bed.stiffness(np.asarray(self.radius)), self.radius)

    @property
    def mean_pressure(self) -> Q:
        """F over the area of the contact [Pa]; zero without contact.

        Raises
        ------
        OutsideValidity
            If the bed does not define the area.
        """
        area = np.asarray(self.problem.bed.footprint.area(np.asarray(self.radius)))
        return like(np.where(area > 0.0, self.force / np.where(area > 0.0, area, 1.0), 0.0), self.radius)

    @property
    def peak_pressure(self) -> Q:
        """The maximum pressure [Pa]: infinite at a sharp apex, kink or rim; zero without contact.

        Raises
        ------
        OutsideValidity
            If the bed does not define the pressure.
        """
        pairs = zip(*map(np.ravel, (self.depth, self.radius)), strict=True)
        peaks = [peak_pressure(PressedSprings(self.problem.bed, float(d), float(a))) for d, a in pairs]
        return like(np.array(peaks), self.depth)

    @property
    def energy(self) -> Q:
        """Elastic energy U [J]: the work of pressing the bodies together."""
        work = [_energy(self.problem.bed, d, a) for d, a in zip(*map(np.ravel, (self.depth, self.radius)), strict=True)]
        return like(np.array(work), self.depth)

    def line_load(self, x: Array) -> Array:
        """Load of the springs per length.

        Parameters
        ----------
        x : ndarray
            Positions along the one-dimensional foundation [m], on either side of the axis.

        Returns
        -------
        ndarray
            q(x) = c_N(x) (d - g(x)) [N/m], zero outside the contact.
        """
        pressed = self.pressed
        x = np.abs(np.asarray(x, dtype=float))
        inside = (x <= pressed.radius) & (pressed.radius > 0.0)
        bed = self.problem.bed
        place = np.where(inside, x, 0.0)
        return np.where(inside, bed.normal_stiffness(place) * pressed.value(place), 0.0)

    @property
    def pressed(self) -> PressedSprings:
        """The displacement of the springs, for computing fields; available for one load, not for an array."""
        return PressedSprings(self.problem.bed, single(self.depth, "line load or fields"), float(self.radius))

    def at(self, index: int | tuple[int, ...]) -> IndentationSolution[float]:
        """Return the solution of one load of an array.

        Parameters
        ----------
        index : int or tuple of int
            Which one.

        Raises
        ------
        InvalidInput
            If there is no such load.
        """
        load, depth, force, radius = picked(self.problem.load, index, self.depth, self.force, self.radius)
        return IndentationSolution(Indentation(self.problem.bed, load), depth, force, radius)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: assumptions, slopes, size of the body, onset of yield."""
        return self.notes_with(FRICTIONLESS)

    def notes_with(self, rubbing: SurfaceFriction) -> tuple[Note, ...]:
        """Return validity notes for this contact with sliding friction."""
        return indentation_notes(self.problem.bed, np.ravel(self.depth), np.ravel(self.radius), rubbing)


def _energy(bed: Bed, depth: float, radius: float) -> float:
    """Return the integral of c_N (d - g)^2 over the contact.

    Towards the axis, where c_N may diverge, integrated by parts: half k (d - g)^2 at the end of that piece, and the
    integral of k (d - g) g'.
    """
    if radius == 0.0:
        return 0.0
    edges = [b for b, _ in bed.kinks]
    inner = 0.5 * min([radius, *edges])
    place = np.array([inner])
    start = 0.5 * float(bed.stiffness(place)[0]) * (depth - float(bed.gap(place)[0])) ** 2

    def stored(x: Array) -> Array:
        result = depth - bed.gap(x)
        near = x < inner
        result[~near] *= bed.normal_stiffness(x[~near]) * result[~near]
        result[near] *= bed.stiffness(x[near]) * bed.gap_slope(x[near])
        return result

    return start + float(abel.integral(stored, [inner, *edges], np.array(radius)))


def peak_pressure(pressed: PressedSprings) -> float:
    """Return the greatest pressure [Pa]: infinite at a sharp apex, kink or rim, zero without contact.

    Parameters
    ----------
    pressed : PressedSprings

    Raises
    ------
    OutsideValidity
        If the bed does not define the pressure, or the profile is too rough for its integral.
    """
    bed, a = pressed.bed, pressed.radius
    if a == 0.0:
        return 0.0
    outline = bed.footprint
    if isinstance(outline, EllipticOutline):
        radius = np.array([a])
        force = float((bed.stiffness(radius) * pressed.depth - bed.gap_load(radius))[0])
        return 1.5 * force / float(outline.area(radius)[0])
    if outline.unlike_disc:
        raise OutsideValidity(f"The pressure is not known: {outline.unlike_disc}.")

    def pressure(r: Array) -> Array:
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.asarray(bed.medium.pressure(pressed, r))

    kinks = np.array([place for place, strength in pressed.kinks if strength != 0.0 and place < a])
    try:
        if pressed.edge > 0.0 or np.any(np.isposinf(pressure(kinks))):
            return math.inf
        return highest_of_curve(pressure, a)
    except NotConverged as error:
        raise OutsideValidity(f"The maximum pressure is not known: {error}") from None
