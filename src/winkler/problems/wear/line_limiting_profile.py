r"""The limiting profile of a fretting line contact: the shape at which wear ends.

On half-planes what sticks is as wide as the contact under the load :math:`\gamma = P - Q/\mu`, and wear outside does
not change that: the core :math:`|x|<c` keeps its shape, and bears everything in the end.  Beside the pressure of that
narrower contact it bears :math:`Q/\mu` as a flat punch does,

.. math:: p_\infty(x) = p(x;\gamma) + \frac{Q/\mu}{\pi\sqrt{c^2-x^2}} , \qquad |x|<c ,

and the worn surface lies where that leaves the other one.  With the distance h beside the narrower contact

.. math:: \Delta f(x) = \frac{2Q}{\pi\mu E^*}\,\mathrm{arcosh}\frac xc - h(x;\gamma) , \qquad c<|x|<a_\infty , \qquad
          \Delta f(a_\infty) = 0 ,

for a cylinder :math:`\Delta f = [a^2\,\mathrm{arcosh}(x/c) - x\sqrt{x^2-c^2}]/2R`.  It is the line contact of what
Popov states for bodies of revolution; that the core of a plane contact stays was seen by Ciavarella and Hills.

On layers the core moves while its surroundings wear (`winkler.problems.wear.stuck_core`); what it bears beyond its own
load profile is the flat punch of the layers.
"""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.laws.friction import Sliding
from winkler.loading.path import OnePositiveLineForce, OnePositiveLineSwing
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.assumptions.declared import WORN
from winkler.problems.line.stress import Strip
from winkler.problems.line.strip import Stressed
from winkler.problems.wear.line_validity import line_limiting_notes
from winkler.problems.wear.stuck_core import stuck_core
from winkler.values.checks.place_checks import finite_places
from winkler.values.errors import OutsideValidity
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

NODES = 64
SAMPLES = 513


@value
class LineLimitingProfile:
    """The final profile and contact of fretting wear in a line contact.

    Parameters
    ----------
    bed : LineFoundation, LayeredLineFoundation or PowerLawLineFoundation
        Profile and bodies before wear: homogeneous, or layers through which shear reaches the base.
    law : Coulomb
        Friction; its coefficient must be positive and finite.
    normal : LineForce
        The steady normal force per length, one positive number.
    amplitude : LineShearForce
        Amplitude of the shear force per length: one positive number, below the friction limit.

    Raises
    ------
    InvalidInput
        If the bed, the law or the forces are not of these kinds.
    OutsideValidity
        If a layer slides on the material below, or the bodies are viscoelastic.

    Notes
    -----
    On layers the stick zone follows from their responses to pressure and to shear. The final stick zone carries the
    whole load. If it would slip at its edge, it shrinks until it does not. Otherwise it grows while its surroundings
    wear, by an amount that depends on the law of wear; the stick zone before wear is then used.

    References
    ----------
    M. Ciavarella, D. A. Hills, Eur. J. Mech. A Solids 18 (1999) 491-497;
    V. L. Popov, Sci. Rep. 4 (2014) 3749, doi:10.1038/srep03749

    Examples
    --------
    A cylinder that sticks within half of its contact.

    >>> from winkler.laws.friction import Coulomb
    >>> from winkler.loading.loads import LineForce, LineShearForce
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> steel = Elastic(210e9, 0.3)
    >>> bed = LineFoundation(Paraboloid(10e-3), HalfSpace.between(steel, steel))
    >>> limit = LineLimitingProfile(bed, Coulomb(0.5), LineForce(100e3), LineShearForce(37.5e3)).solve()
    >>> round(limit.stick_half_width * 1e6, 3), round(limit.half_width * 1e6, 3)  # micrometres
    (52.523, 139.426)
    """

    __words__ = words(
        bed=("", None, "profile and bodies of the line contact"),
        normal=("", None, "the steady normal force per length"),
        amplitude=("", None, "amplitude of the shear force per length"),
    )

    bed: LineFoundation | LayeredLineFoundation | PowerLawLineFoundation
    law: Sliding
    normal: OnePositiveLineForce
    amplitude: OnePositiveLineSwing

    references: ClassVar[tuple[str, ...]] = ("ciavarella_hills_1999", "popov_2014", "ciavarella_1998")
    assumptions: ClassVar[frozenset[Assumption]] = WORN

    def __post_init__(self) -> None:
        _ = self.bed.along_share

    def solve(self) -> LineLimitingSolution:
        """Return the limiting profile.

        Returns
        -------
        LineLimitingSolution

        Raises
        ------
        OutsideValidity
            If everything slips: such a contact has no stick zone, and wears without end.  If nothing slips.  If the
            worn contact ends beyond the known range of the profile.
        """
        core = stuck_core("LineLimitingProfile", self.bed, self.law, self.normal, self.amplitude)
        if core.half_width >= self.bed.rim:
            raise OutsideValidity("LineLimitingProfile: everything up to the rim sticks, and nothing wears.")
        kind = LayeredLineLimitingSolution if isinstance(self.bed, LayeredLineFoundation) else LineLimitingSolution
        return kind(self, core.half_width, core.excess, core.outer_half_width())


@value
class LineLimitingSolution(Stressed):
    """The solution of a `LineLimitingProfile`.

    Parameters
    ----------
    problem : LineLimitingProfile
        The problem that was solved.
    stick_half_width : float
        c [m]: the final stick zone, which carries the whole load.
    excess_load : float
        Load per length over E* of the stick zone as a flat punch [m].
    half_width : float
        Outer radius a_inf of the worn zone [m].
    """

    __words__ = words(
        half_width=(r"a_\infty", "m", "half-width up to which the surfaces are worn"),
        stick_half_width=("c", "m", "half-width of the stick zone, which carries the whole load in the end"),
        excess_load=(r"Q/\mu E^*", "m", "load per length over E* that the stick zone carries as a flat punch"),
    )

    problem: LineLimitingProfile
    stick_half_width: float
    excess_load: float
    half_width: float

    def _strip(self, requested: str) -> Strip:
        return Strip(self.stick_half_width, self.excess_load)

    @property
    def force_per_length(self) -> float:
        """P [N/m]."""
        return float(self.problem.normal.force_per_length)

    @property
    def worn_volume_per_length(self) -> float:
        """Final wear volume per length of the line [m^2]."""
        # x^2 - c^2 = s^2: the worn depth begins like the root of the distance from the core
        c, end = self.stick_half_width, self.half_width
        nodes, weights = gauss_legendre(NODES)
        span = math.sqrt((end - c) * (end + c))
        x = np.hypot(c, span * nodes)
        return float(2.0 * span * np.sum(weights * span * nodes / x * self.worn(x)))

    @property
    def worn_depth(self) -> float:
        """The maximum worn depth [m]."""
        c, end = self.stick_half_width, self.half_width
        return float(np.max(self.worn(c + (end - c) * np.linspace(0.0, 1.0, SAMPLES) ** 2)))

    def worn(self, x: ArrayLike) -> Array:
        """Return the worn depth of both bodies together [m]: zero in the stick zone and outside the worn zone.

        Parameters
        ----------
        x : array_like
            Positions on the surface [m], on either side of the middle.
        """
        away = np.abs(finite_places("LineLimitingSolution.worn", "x", x))
        beside = (away > self.stick_half_width) & (away < self.half_width)
        worn = np.zeros(away.shape)
        apart = self.problem.bed.separation(away[beside], self.stick_half_width, self.excess_load)
        worn[beside] = np.maximum(-apart, 0.0)
        return worn

    def height(self, x: ArrayLike) -> Array:
        """Return the height of the limiting profile [m] at places [m].

        Parameters
        ----------
        x : array_like
            Positions on the surface [m], on either side of the middle.
        """
        away = np.abs(finite_places("LineLimitingSolution.height", "x", x))
        return np.asarray(self.problem.bed.profile.height(away) + self.worn(away))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        problem = self.problem
        core = stuck_core("LineLimitingProfile", problem.bed, problem.law, problem.normal, problem.amplitude)
        return line_limiting_notes(core, problem.law.coefficient, self.force_per_length)


@value
class LayeredLineLimitingSolution(LineLimitingSolution):
    """The solution of a `LineLimitingProfile` on layers, with stresses in the layers."""
