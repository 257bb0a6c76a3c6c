r"""A rough body of revolution on the line: random heights of the spectrum :math:`C_1=\pi q\,C` on its g(x).

.. math:: z(x) = h(x) - g(|x|) , \qquad F(d) = E^*\int(d-z_\max+z)_+\,\mathrm dx .

Lightly pressed a ball bears on few peaks; pressed harder than its roughness it follows the smooth one.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from winkler.foundation.bed import Bed, PressedSprings
from winkler.loading.loads import Depth, Force
from winkler.loading.path import numbers_of
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium
from winkler.media.offers import PowerOfDepth, PressedWaves, offers
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.normal.solve_contact import at_force
from winkler.problems.rough.layered_lines import line_stiffnesses, slope_modulus
from winkler.problems.rough.line_solution import LineSprings, Realisations, RoughSolution, check_ensemble
from winkler.problems.rough.persson import area_fraction
from winkler.problems.rough.spring_line import RoughLine, ensemble, line_seeds
from winkler.profiles.rough.random_rough import random_lines
from winkler.profiles.rough.spectrum import Spectrum
from winkler.values.checks.number_checks import Positive, Seed
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

NODES = 64
POPOV = "V. L. Popov, M. Hess, Method of Dimensionality Reduction, Springer 2015, doi:10.1007/978-3-642-53876-6"


@value
class RoughIndentation(PerLoad[Q]):
    """A rough body pressed into a half-space, computed with one-dimensional foundations.

    Parameters
    ----------
    spectrum : Spectrum
        Combined spectrum of both surfaces: SelfAffine or PowerSpectrum.
    bed : Foundation
        The smooth body, on an elastic half-space, layered, graded or neither.
    length : float
        Length of the random profiles [m], larger than the contact. Longer waves are omitted.
    load : Force or Depth
        The prescribed quantity, positive. Depths are counted from the first touch of the highest point.
    realisations : int, optional
        Number of random profiles.
    count : int, optional
        Number of springs in each profile; waves shorter than two springs are omitted.
    seed : int, optional
        Seed of the random phases; equal seeds give equal results.

    Raises
    ------
    InvalidInput
        If a number is out of range, or the medium relaxes.

    References
    ----------
    R. Pohrt, V. L. Popov, Phys. Rev. Lett. 108 (2012) 104301, doi:10.1103/PhysRevLett.108.104301; V. L. Popov, M. Hess,
    Method of Dimensionality Reduction, Springer 2015, doi:10.1007/978-3-642-53876-6
    """

    __words__ = words(length=("L", "m", "length of the line"), count=("n", "", "springs of each line"))

    spectrum: Spectrum
    bed: Bed
    length: Positive
    load: Force[Q] | Depth[Q]
    realisations: Realisations = 50
    count: LineSprings = 4096
    seed: Seed = 0

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "pohrt_popov_2012", "persson_2001")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED | {Assumption.ROUGHNESS}
    needs_round: ClassVar[str] = "roughness on the springs of a line"

    def __post_init__(self) -> None:
        medium = getattr(self.bed, "medium", None)
        if not (isinstance(medium, HomogeneousMedium) or offers(medium, PressedWaves) or offers(medium, PowerOfDepth)):
            raise InvalidInput(
                "RoughIndentation: roughness is implemented for elastic half-spaces only, layered or not; give "
                "Foundation(profile, HalfSpace(...))."
            )
        check_ensemble("RoughIndentation", self.load, self.realisations, self.count)

    @property
    def medium(self) -> MappedMedium:
        """Both bodies."""
        return self.bed.medium  # type: ignore[return-value]

    @property
    def _places(self) -> Array:
        """The middles of the springs [m]."""
        return (np.arange(self.count) + 0.5 - 0.5 * self.count) * (self.length / self.count)

    def lines(self) -> Iterator[RoughLine]:
        """Yield the random profiles.

        Raises
        ------
        InvalidInput
            If the spectrum contains no wave that fits into the profile.
        OutsideValidity
            If the contact reaches the end of the line, or of what is known of the body.
        """
        place = np.abs(self._places)
        there = place <= min(self.bed.rim, self.bed.reach)
        smooth = self.bed.gap(place[there])
        part = self.length * smooth.size / self.count
        pinned = self.bed.rim <= min(self.bed.reach, 0.5 * self.length)
        rising = line_stiffnesses(self.medium, smooth.size, self.length / self.count)
        for heights in random_lines(self.spectrum, self.count, self.length, line_seeds(self.seed, self.realisations)):
            line = RoughLine(heights[there] - smooth, part, self.medium.modulus, rising)
            if not pinned:
                self._refuse_end(line)
            yield line

    def _refuse_end(self, line: RoughLine) -> None:
        """Refuse loads under which the last springs touch."""
        most = float(np.max(numbers_of(self.load)))
        deepest = float(line.depth(np.array(most))) if isinstance(self.load, Force) else most
        gap = float(np.max(line.heights) - max(line.heights[0], line.heights[-1]))
        if gap >= deepest:
            return
        where = f"RoughIndentation: under the load {most:.6g} the contact reaches"
        if 2.0 * self.bed.reach < self.length:
            raise OutsideValidity(
                f"{where} {self.bed.reach:.6g} m, beyond which nothing is known of the body; press less."
            )
        raise OutsideValidity(f"{where} the end of the line of {self.length:.6g} m; give a longer one, or press less.")

    def solve(self) -> RoughIndentationSolution[Q]:
        """Return force, depth and stiffness: medians of the random profiles, and bands with 80 % of them.

        Raises
        ------
        InvalidInput
            If the spectrum contains no wave that fits into the profile.
        OutsideValidity
            If the contact reaches the end of the one-dimensional foundation, or of the known range of the body.
        """
        return RoughIndentationSolution(self, **ensemble(self.lines(), self.load)._asdict())


@value
class RoughIndentationSolution(RoughSolution[Q]):
    """The solution of a `RoughIndentation`.

    Parameters
    ----------
    problem : RoughIndentation
        The problem that was solved.
    depth, force, stiffness : float or ndarray
        d [m], F [N], dF/dd [N/m]: the median of all random profiles, in the shape of the load.
    depth_band, force_band, stiffness_band : ndarray, (2, ...)
        Limits between which 80 % of the random profiles lie.
    """

    problem: RoughIndentation[Q]

    @property
    def smooth_stiffness(self) -> Q:
        """dF/dd [N/m] of the smooth body under the same forces."""
        _, radius = at_force(self.problem.bed, np.ravel(self.force))
        return shaped(self.problem.bed.stiffness(radius), np.shape(self.force))

    @property
    def area(self) -> Q:
        """True contact area [m^2]: Persson's, for each annulus with the pressure of the smooth body."""
        bed, steep = self.problem.bed, slope_modulus(self.problem.medium, self.problem.spectrum)
        depths, radii = at_force(bed, np.ravel(self.force))
        nodes, weights = gauss_legendre(NODES)
        # r = a sin: pressures of flat ends and of smooth edges are both tame in the angle
        angle = 0.5 * math.pi * nodes
        areas = []
        for depth, radius in zip(depths.tolist(), radii.tolist(), strict=True):
            pressure = self.problem.medium.pressure(PressedSprings(bed, depth, radius), radius * np.sin(angle))
            touching = area_fraction(pressure, steep, 1.0)
            areas.append(math.pi**2 * radius**2 * float(np.sum(weights * touching * np.sin(angle) * np.cos(angle))))
        return shaped(np.array(areas), np.shape(self.force))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        return (
            *self.problem.bed.notes,
            Note(
                Assumption.ROUGHNESS,
                Standing.APPROXIMATE,
                "A rough body on a one-dimensional foundation is exact where its smooth shape carries the load. "
                "Where single asperities carry it, only the scaling laws are correct: median stiffness and depth then "
                "differ by up to 25 per cent from boundary elements.",
                f"{POPOV}; own boundary elements",
            ),
            *self._line_notes,
            Note(
                Assumption.ROUGHNESS,
                Standing.APPROXIMATE,
                "The springs give no true contact area. The area stated here is Persson's for the pressure of "
                "the smooth body. Persson's area is up to a third too small; the error is smaller if roughness spreads "
                "the pressure of small loads. Use SurfaceContact to compute the area.",
                POPOV,
            ),
        )
