r"""Rough surfaces on the line: independent springs under random heights of the spectrum :math:`C_1=\pi q\,C`.

A square of the side L is as stiff as a line of 1.1523 L when everything touches.  Stiffness, and with it conductance,
scale with the force as those of the surface; the length of the springs in contact is no area, and the line has no mean
gap: both are Persson's here.
"""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Iterator
from typing import Annotated, ClassVar

import numpy as np

from winkler.loading.loads import Depth, Force
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium
from winkler.numerics.types import PerLoad, Q, shaped
from winkler.problems.rough.layered_lines import line_stiffnesses, moduli_of_waves, slope_modulus
from winkler.problems.rough.line_solution import LineSprings, Realisations, RoughSolution, check_ensemble
from winkler.problems.rough.persson import area_fraction, separation_under
from winkler.problems.rough.spring_line import RoughLine, ensemble, line_seeds
from winkler.profiles.rough.random_rough import random_lines
from winkler.profiles.rough.spectrum import Spectrum
from winkler.values.checks.number_checks import Advice, Positive, Seed
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

LIGHT = 0.2
"""Pressures [E* h'] up to which Persson's mean gap was found within 20 per cent of boundary elements."""
LINE_OVER_SIDE = 1.1523
"""Length of the line over the side of a square surface, by which both are as stiff when everything touches."""
LYASHENKO = "I. A. Lyashenko, L. Pastewka, B. N. J. Persson, Tribol. Lett. 52 (2013) 223-229"
POHRT = "R. Pohrt, V. L. Popov, Phys. Rev. Lett. 108 (2012) 104301, doi:10.1103/PhysRevLett.108.104301"

HOMOGENEOUS_LINES = Note(
    Assumption.ROUGHNESS,
    Standing.APPROXIMATE,
    "Force, depth and stiffness of a rough surface on a one-dimensional foundation follow the scaling laws of "
    "the surface. Median stiffnesses are 0.8 to 1.3 times those of boundary elements, median "
    "depths 0.85 to 1.25 times.",
    f"{POHRT}; own boundary elements, Hurst exponents from 0.3 to 0.8",
)
NO_AREA = Note(
    Assumption.ROUGHNESS,
    Standing.OUTSIDE,
    "The springs are independent and give no true contact area and no mean gap. The values stated here are "
    "Persson's. The area is up to a third too small; the gap is accurate to 20 per cent for pressures up to 0.2 "
    "E* h'. Use SurfaceContact to compute area and gap.",
    LYASHENKO,
)
LAYERED_LINES = Note(
    Assumption.ROUGHNESS,
    Standing.APPROXIMATE,
    "On layers the spring stiffness is that of a flat punch as wide as the sum of all contact lengths. "
    "Median stiffnesses are 0.7 to 1.35 times those of boundary elements, median depths 0.8 to 1.25 times. The "
    "comparison covers layers 0.25 to 20 times as stiff as the base and 0.02 to 0.3 side lengths thick.",
    "own boundary elements, four maps of 64 x 64 pixels each, Hurst exponents of 0.4 and 0.8",
)


@value
class RoughContact(PerLoad[Q]):
    """A rough square on a flat half-space, computed with one-dimensional foundations.

    Parameters
    ----------
    spectrum : Spectrum
        Combined spectrum of both surfaces: SelfAffine or PowerSpectrum.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
        Both bodies.
    side : float
        Side of the square [m]; waves longer than the profile line of 1.1523 sides are omitted.
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

    __words__ = words(
        length=("L", "m", "length of the line"),
        side=("L", "m", "side of the square"),
        count=("n", "", "springs of each line"),
    )

    spectrum: Spectrum
    medium: Annotated[MappedMedium, Advice("roughness is not implemented for others")]
    side: Positive
    load: Force[Q] | Depth[Q]
    realisations: Realisations = 50
    count: LineSprings = 4096
    seed: Seed = 0

    references: ClassVar[tuple[str, ...]] = ("popov_hess_2015", "pohrt_popov_2012", "persson_2001", "yang_persson_2008")
    assumptions: ClassVar[frozenset[Assumption]] = frozenset(
        (Assumption.RESPONSE, Assumption.ELASTIC, Assumption.ROUGHNESS, Assumption.RESOLUTION)
    )

    def __post_init__(self) -> None:
        check_ensemble("RoughContact", self.load, self.realisations, self.count)

    @property
    def length(self) -> float:
        """Length of the profiles [m]."""
        return LINE_OVER_SIDE * self.side

    def lines(self) -> Iterator[RoughLine]:
        """Yield the random profiles.

        Raises
        ------
        InvalidInput
            If the spectrum contains no wave that fits into the profile.
        """
        rising = line_stiffnesses(self.medium, self.count, self.length / self.count)
        for heights in random_lines(self.spectrum, self.count, self.length, line_seeds(self.seed, self.realisations)):
            yield RoughLine(heights, self.length, self.medium.modulus, rising)

    def solve(self) -> RoughContactSolution[Q]:
        """Return force, depth and stiffness: medians of the random profiles, and bands with 80 % of them.

        Raises
        ------
        InvalidInput
            If the spectrum contains no wave that fits into the profile.
        """
        return RoughContactSolution(self, **ensemble(self.lines(), self.load)._asdict())


@value
class RoughContactSolution(RoughSolution[Q]):
    """The solution of a `RoughContact`.

    Parameters
    ----------
    problem : RoughContact
        The problem that was solved.
    depth, force, stiffness : float or ndarray
        d [m], F [N], dF/dd [N/m]: the median of all random profiles, in the shape of the load.
    depth_band, force_band, stiffness_band : ndarray, (2, ...)
        Limits between which 80 % of the random profiles lie.
    """

    problem: RoughContact[Q]

    @property
    def area(self) -> Q:
        """True contact area after Persson [m^2]; the one-dimensional foundation gives no area."""
        square = self.problem.side**2
        steep = slope_modulus(self.problem.medium, self.problem.spectrum)
        fraction = area_fraction(np.asarray(self.force) / square, steep, 1.0)
        return shaped(square * fraction)

    @property
    def mean_gap(self) -> Q:
        """Mean distance of the surfaces [m], after Persson."""
        square = self.problem.side**2
        pressure = np.asarray(self.force) / square
        moduli = functools.partial(moduli_of_waves, self.problem.medium)
        return shaped(separation_under(pressure, moduli, self.problem.spectrum))

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        bodies = self.problem.medium.notes
        pressure = float(np.max(np.asarray(self.force), initial=0.0)) / self.problem.side**2
        light = pressure <= LIGHT * slope_modulus(self.problem.medium, self.problem.spectrum)
        return (
            *(note for note in bodies if note.standing is not Standing.EXACT),  # of one round contact
            HOMOGENEOUS_LINES if isinstance(self.problem.medium, HomogeneousMedium) else LAYERED_LINES,
            *self._line_notes,
            dataclasses.replace(NO_AREA, standing=Standing.APPROXIMATE if light else Standing.OUTSIDE),
        )
