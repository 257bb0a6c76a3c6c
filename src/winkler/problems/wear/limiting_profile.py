r"""The limiting profile of fretting: the shape at which wear ends, because nothing that slips bears any more.

Under a steady depth d the core :math:`r<c` that sticks keeps its shape, and everything that slips wears until the
pressure on it is gone.  What bears in the end is the core alone, with the springs' displacement :math:`d-g_0(x)` up to
c and none beyond; the worn surface lies where the core's pressure leaves the other one,

.. math:: f_\infty(r) = d - u(r) = \frac2\pi\Big[\int_0^c\frac{g_0(x)\,\mathrm dx}{\sqrt{r^2-x^2}}
          + d\arccos\frac cr\Big] , \qquad c<r<a_\infty , \qquad f_\infty(a_\infty) = f_0(a_\infty) ,

whatever the law of wear (Popov).  The displacement u is the medium's own: the rule holds in every medium.
"""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import StretchedSprings
from winkler.foundation.foundation import Foundation
from winkler.laws.friction import Sliding
from winkler.loading.loads import Depth, Shift
from winkler.loading.path import numbers_of
from winkler.media.offers import PressedWaves, offers
from winkler.numerics.equations.bracketing import between
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array
from winkler.problems.assumptions.coupling import sticking_note
from winkler.problems.assumptions.declared import WORN
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.normal.yield_statement import SurfaceFriction
from winkler.problems.wear.round_core import StuckRadii, layered_core, spring_core
from winkler.problems.wear.validity import DEBRIS, core_notes, slip_note
from winkler.values.checks.field_checks import Condition
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

NODES = 64
SAMPLES = 513


ONE_DEPTH = Condition(
    lambda load: numbers_of(load).ndim == 0 and float(load.depth) > 0.0,
    "give Depth(d) with one positive number: under a steady force wear transfers the load to the stick zone, "
    "use FrettingWear",
)
ONE_SHIFT = Condition(
    lambda load: numbers_of(load).ndim == 0 and float(load.shift) > 0.0,
    "give Shift(U) with one positive number, how far to each side",
)


@value
class LimitingProfile:
    """The final profile and contact of fretting wear at constant depth and amplitude.

    Parameters
    ----------
    bed : Foundation
        Foundation(profile, medium) before wear.
    law : Coulomb
        Friction; its coefficient must be positive and finite.
    normal : Depth
        One positive number.
    amplitude : Shift
        Amplitude (half of the stroke): one positive number, small enough to leave a stick zone.

    Raises
    ------
    InvalidInput
        If the bed, the law, the load or the amplitude are not of these kinds.

    Notes
    -----
    On layers and graded bodies the stick zone follows from their normal and shear kernels. The final stick zone
    carries the whole load. If it would slip at its edge, it shrinks until it does not. Otherwise it grows while its
    surroundings wear, by an amount that depends on the law of wear; the stick zone before wear is then used.

    References
    ----------
    V. L. Popov, Sci. Rep. 4 (2014) 3749, doi:10.1038/srep03749;
    A. I. Dmitriev, L. B. Voll, S. G. Psakhie, V. L. Popov, Sci. Rep. 6 (2016) 23231, doi:10.1038/srep23231

    Examples
    --------
    A ball that sticks within half of its contact.

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> medium = HalfSpace(Elastic(young=1.0, poisson=0.0))
    >>> swing = Shift(0.5 * 0.75e-2 * medium.modulus / medium.shear_modulus)
    >>> limit = LimitingProfile(Foundation(Paraboloid(1.0), medium), Coulomb(0.5), Depth(0.01), swing).solve()
    >>> round(limit.stick_radius, 6), round(limit.radius, 7), round(limit.worn_volume * 1e4, 5)
    (0.05, 0.1229791, 0.7593)
    """

    __words__ = words(contact=("", None, "the contact before wear"), amplitude=("", None, "amplitude of the shift"))

    bed: Foundation
    law: Sliding
    normal: Annotated[Depth, ONE_DEPTH]
    amplitude: Annotated[Shift, ONE_SHIFT]

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "popov_2014", "dmitriev_2016")
    assumptions: ClassVar[frozenset[Assumption]] = WORN
    needs_round: ClassVar[str] = "wear, which follows the slip from place to place,"

    @property
    def contact(self) -> IndentationSolution:
        """The contact before wear."""
        return Indentation(self.bed, self.normal).solve()

    def solve(self) -> LimitingSolution:
        """Return the limiting profile.

        Returns
        -------
        LimitingSolution

        Raises
        ------
        OutsideValidity
            If everything slips, or on layers the stick zone shrinks to zero: such a contact wears without end.  If
            nothing slips.  If a layer slides on the material below.  If the worn contact ends beyond the known range of
            the profile.
        """
        contact = self.contact
        depth, radius = float(self.normal.depth), float(contact.radius)
        if radius == 0.0:
            raise OutsideValidity("LimitingProfile: the bodies do not touch at this depth; press them together.")
        core = StretchedSprings(self.bed, depth, self._stick_radius(depth, radius))
        return LimitingSolution(self, core, self._outer_radius(core))

    def _stick_radius(self, depth: float, radius: float) -> float:
        radii = self._stuck(depth, radius)
        moved = float(self.amplitude.shift)
        if radii.first == radius:
            raise OutsideValidity(
                f"LimitingProfile: with an amplitude of {moved:.6g} m nothing slips, and nothing wears."
            )
        core = min(radii)
        if core == 0.0:
            shrinks = radii.first > 0.0
            fate = "the stick zone vanishes as the surface around it wears" if shrinks else "everything slips"
            raise OutsideValidity(
                f"LimitingProfile: with an amplitude of {moved:.6g} m {fate}; such a contact wears without end: give a "
                "smaller amplitude, or use FrettingWear."
            )
        return core

    def _stuck(self, depth: float, radius: float) -> StuckRadii:
        """Return the radii of the core before wear and where it bears alone."""
        stated = (self.bed, self.law.coefficient, depth, radius, float(self.amplitude.shift))
        if offers(self.bed.medium, PressedWaves):
            return layered_core(*stated)
        core = spring_core(*stated)
        return StuckRadii(core, core)

    def _outer_radius(self, core: StretchedSprings) -> float:
        bed = self.bed

        def above(r: Array, _: Array) -> Array:
            return core.depth - bed.medium.displacement(core, r) - bed.height(r)

        low = core.radius * (1.0 + 1e-9)
        high = 2.0 * low
        while high < bed.reach and float(bed.height(np.array([high]))[0]) < core.depth:
            high *= 2.0
        end = min(bed.reach, bed.rim)
        high = min(high, end)
        if float(above(np.array([high]), np.zeros(1, dtype=int))[0]) > 0.0:
            if high == bed.rim:
                return high
            raise OutsideValidity(
                f"LimitingProfile: the worn contact ends beyond {high:.6g} m, as far as the profile is known; give one "
                "that is known farther out."
            )
        return float(between(above, np.array([low]), np.array([high]))[0])


@value
class LimitingSolution:
    """The solution of a `LimitingProfile`.

    Parameters
    ----------
    problem : LimitingProfile
        The problem that was solved.
    core : StretchedSprings
        The springs in contact.
    radius : float
        Outer radius a_inf of the worn zone [m].
    """

    __words__ = words(radius=(r"a_\infty", "m", "radius where the worn part ends"))

    problem: LimitingProfile
    core: StretchedSprings
    radius: float

    @property
    def depth(self) -> float:
        """d [m]."""
        return self.core.depth

    @property
    def stick_radius(self) -> float:
        """c [m]: the final stick zone, which carries the whole load."""
        return self.core.radius

    @property
    def force(self) -> float:
        """F_N [N], that of the stick zone."""
        bed, c = self.problem.bed, np.array([self.core.radius])
        return float(bed.stiffness(c)[0] * self.core.depth - bed.gap_load(c)[0])

    @property
    def worn_volume(self) -> float:
        """Final wear volume [m^3]."""
        # r^2 - c^2 = s^2: the worn depth begins like the root of the distance from the core
        c, end = self.core.radius, self.radius
        nodes, weights = gauss_legendre(NODES)
        span = math.sqrt((end - c) * (end + c))
        s = span * nodes
        worn = self.worn(np.hypot(c, s))
        return float(2.0 * np.pi * span * np.sum(weights * s * worn))

    @property
    def worn_depth(self) -> float:
        """The maximum worn depth [m]."""
        r = self.core.radius + (self.radius - self.core.radius) * np.linspace(0.0, 1.0, SAMPLES) ** 2
        return float(np.max(self.worn(r)))

    def height(self, r: Array) -> Array:
        """Height of the limiting profile.

        Parameters
        ----------
        r : ndarray
            Distances from the axis [m].

        Returns
        -------
        ndarray
            f(r) [m]; in the stick zone and outside the worn zone it is the profile before wear.
        """
        r = np.asarray(r, dtype=float)
        return np.asarray(self.problem.bed.height(r) + self.worn(r))

    def worn(self, r: Array) -> Array:
        """Worn depth [m] at distances from the axis [m]; zero in the stick zone and outside the worn zone."""
        r = np.asarray(r, dtype=float)
        ring = (r > self.core.radius) & (r < self.radius)
        worn = np.zeros(r.shape)
        if np.any(ring):
            bed = self.problem.bed
            worn[ring] = self.core.depth - bed.medium.displacement(self.core, r[ring]) - bed.height(r[ring])
        return np.maximum(worn, 0.0)

    def pressure(self, r: Array) -> Array:
        """Final pressure.

        Parameters
        ----------
        r : ndarray
            Distances from the axis [m].

        Returns
        -------
        ndarray
            p [Pa], zero outside the stick zone, infinite at its edge.
        """
        return self.problem.bed.medium.pressure(self.core, np.asarray(r, dtype=float))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        bed = self.problem.bed
        rubbing = SurfaceFriction(self.problem.law.coefficient)
        worn = (DEBRIS, slip_note(bed), sticking_note(bed.medium, self.problem.law.coefficient))
        contact = self.problem.contact
        radii = self.problem._stuck(self.core.depth, float(contact.radius))
        return (*contact.notes_with(rubbing), *worn, *core_notes(bed, *radii))
