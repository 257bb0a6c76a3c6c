r"""Two bodies of given profiles pressed together: a wheel on a rail, a cam on a follower, a ball in a groove.

The upper body, turned by yaw and roll, is let down until it first touches and then farther, until it bears the load.
Where the undeformed bodies overlap, the gap is measured along the normals n of the lower profile, so that it is right
in deep grooves too, and the pressures p >= 0 on every place of contact are those of boundary elements,

.. math:: w = g_n + \frac{1}{\pi E^*}\int\frac{p\,\mathrm dA}{\rho} \ge 0 , \qquad p\,w = 0 , \qquad
          F_z = \int p\,n_z\,\mathrm dA ,

by the same solver as that of `winkler.problems.rough.surface_contact`.
"""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.loading.loads import Depth, Force
from winkler.media.mapped import MappedMedium
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.profile_pair.notes import pair_notes
from winkler.problems.profile_pair.patch import ProfilePatch
from winkler.problems.profile_pair.placing import Placing
from winkler.problems.profile_pair.pressed_pair import placed_bodies, pressed_pair
from winkler.problems.profile_pair.pressing import change_of, pressed_by_drop
from winkler.profiles.sections.cross_profile import CrossProfile
from winkler.values.checks.field_checks import Condition
from winkler.values.checks.number_checks import Advice, Finite, NonNegative, PositiveOrInfinite, Whole, between
from winkler.values.validity import Assumption, Note
from winkler.values.value import value, words

ONE_LOAD = Condition(
    lambda load: np.ndim(next(iter(vars(load).values()))) == 0 and float(next(iter(vars(load).values()))) > 0.0,
    "give Force(F) or Depth(d) with one positive number",
)
LARGEST_TURN = 0.5
"""Largest yaw and roll [rad]."""


@value
class ProfilePair:
    """Frictionless contact of two bodies with given profiles, one above the other.

    Parameters
    ----------
    first, second : CrossProfile
        Of the lower and of the upper body, each in its own axes: y across, z up.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, SlidingFilm, StackedHalfSpace, \
DepthGradedHalfSpace or GradedHalfSpace
        Both bodies; the first is the lower one.
    load : Force or Depth
        The vertical force [N], or the downward displacement of the upper body after first touch [m]; one positive
        number.
    lateral : float, optional
        Lateral position of y = 0 of the upper profile in the axes of the lower profile [m].
    yaw : float, optional
        Rotation of the upper body about the vertical [rad], positive if its front moves towards +y.
    roll : float, optional
        Rotation of the upper body about the longitudinal axis y = z = 0 of its profile [rad], positive if its side at
        +y moves downwards.
    first_radius, second_radius : float, optional
        Rolling radius at z = 0 [m]: the distance of the axis of revolution below the lower or above the upper profile.
        Infinite (the default) for a straight body such as a rail.
    rolled_radius : float, optional
        Rolling distance per radian of the upper body [m], for the creepages; by default (zero) its radius.
    pixels : int, optional
        Number of pixels along each side of every contact grid.
    tolerance : float, optional
        As in `SurfaceContact`.

    Raises
    ------
    InvalidInput
        If the profiles do not meet, first touch at an end, or both bodies are straight along the same direction.

    References
    ----------
    I. A. Polonsky, L. M. Keer, Wear 231 (1999) 206-219, doi:10.1016/S0043-1648(99)00113-1;
    J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, Kluwer 1990, doi:10.1007/978-94-015-7889-9

    Examples
    --------
    A ball of 10 mm on a flat, given as profiles, under 100 N: Hertz has 1371 MPa.

    >>> import numpy as np
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> y = np.linspace(-2e-3, 2e-3, 41)
    >>> ball = CrossProfile(y, 10e-3 - np.sqrt(10e-3**2 - y**2))
    >>> steel = Elastic(210e9, 0.3)
    >>> pair = ProfilePair(CrossProfile(y, 0.0 * y), ball, HalfSpace(steel, steel), Force(100.0), second_radius=10e-3)
    >>> round(pair.solve().peak_pressure / 1e6, -1)
    1370.0
    """

    __words__ = words(
        first=("", None, "profile of the lower body"),
        second=("", None, "profile of the upper body"),
        lateral=("y_2", "m", "where the upper profile stands across"),
        yaw=(r"\psi", "rad", "turn about the vertical"),
        roll=(r"\phi", "rad", "turn about the direction along"),
        first_radius=("R_1", "m", "radius of revolution of the lower body; infinite if it is straight"),
        second_radius=("R_2", "m", "radius of revolution of the upper body; infinite if it is straight"),
        rolled_radius=("R_0", "m", "distance rolled per turn by one radian; zero for the radius of the upper body"),
        placing=("", None, "distances of both bodies across, before the upper one is let down"),
        pixels=("n", "", "pixels along each side of a window of contact"),
    )

    first: CrossProfile
    second: CrossProfile
    medium: Annotated[MappedMedium, Advice("the boundary elements apply to no other")]
    load: Annotated[Force | Depth, ONE_LOAD]
    lateral: Finite = 0.0
    yaw: Annotated[float, between(-LARGEST_TURN, LARGEST_TURN)] = 0.0
    roll: Annotated[float, between(-LARGEST_TURN, LARGEST_TURN)] = 0.0
    first_radius: PositiveOrInfinite = math.inf
    second_radius: PositiveOrInfinite = math.inf
    rolled_radius: NonNegative = 0.0
    pixels: Annotated[int, Whole(16, 1024, "pixels")] = 96
    tolerance: Annotated[float, between(1e-12, 0.1)] = 1e-6

    references: ClassVar[tuple[str, ...]] = ("polonsky_keer_1999", "kalker_1990", "shackleton_iwnicki_2008")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED

    @property
    def placing(self) -> Placing:
        """The vertical distances of both profiles before contact."""
        return placed_bodies(self)[2]

    def solve(self) -> ProfilePairSolution:
        """Return the contact.

        Raises
        ------
        InvalidInput
            If the profiles do not meet, first touch at an end, or both bodies are straight along the same direction.
        OutsideValidity
            If the overlap of the bodies is smaller than rounding errors, or reaches beyond the profiles.
        NotConverged
            If the pressures or the force are not found.
        """
        placed = pressed_pair(self)
        pair, placing = placed.windows, placed.placing
        coarse = pressed_by_drop(
            placed.lower, placed.upper, placing, pair.drop, self.medium, self.pixels // 2, self.tolerance
        )
        patches = [patch for each in placed.patches for patch in each]
        across, up = pair.force.tolist()
        return ProfilePairSolution(
            problem=self,
            depth=pair.drop,
            force=up,
            lateral_force=across,
            peak_pressure=max(patch.peak_pressure for patch in patches),
            area=sum(patch.area for patch in patches),
            grid_error=change_of(coarse, pair),
            touch=float(placing.y[int(np.nanargmin(placing.gap))]),
            height=-float(np.nanmin(placing.gap)) - pair.drop,
            patches=tuple(sorted(patches, key=lambda patch: -patch.force)),
            cut=any(region.reaches_end() for region in pair.regions),
            windows=len(pair.regions),
        )


@value
class ProfilePairSolution:
    """The solution of `ProfilePair`.

    Parameters
    ----------
    problem : ProfilePair
        The problem that was solved.
    depth : float
        Vertical displacement of the upper body since first touch, downwards positive [m].
    force, lateral_force : float
        Vertical and lateral force on the upper body [N].
    peak_pressure : float
        The maximum [Pa].
    area : float
        Of all patches [m^2].
    grid_error : float
        The maximum relative change of force and maximum pressure from half as many pixels along a side.
    touch : float
        Lateral position of first touch [m].
    height : float
        Height of z = 0 of the upper profile above z = 0 of the lower one [m].
    patches : tuple of ProfilePatch
        The patches of contact, that with the highest load first.
    cut : bool
        Whether a contact reaches the end of a profile.
    windows : int
        Number of separate grids; contacts on different grids are computed independently.
    """

    __words__ = words(
        depth=("d", "m", "how far the upper body has gone down since first touch"),
        force=("F_z", "N", "vertical force"),
        lateral_force=("F_y", "N", "force on the upper body, across"),
        grid_error=("", "", "change of force and greatest pressure from half as many pixels"),
        touch=("y", "m", "where across the bodies first touch"),
        height=("z", "m", "height of the upper profile's zero over that of the lower one"),
        patches=("", None, "contact patches, the one with the highest load first"),
        cut=("", None, "whether a contact reaches the end of a profile"),
        windows=("", None, "number of grids of elements"),
        angle=(r"\alpha", "rad", "contact angle of the patch with the highest load"),
        place=("y", "m", "lateral position of the centre of pressure, of the patch with the highest load"),
        longitudinal_creepage=(r"\xi", "", "longitudinal creepage of the patch with the highest load"),
        lateral_creepage=(r"\eta", "", "lateral creepage of the patch with the highest load"),
        spin=(
            r"\varphi",
            "1/m",
            "spin about the normal, of the patch with the highest load",
        ),
    )

    problem: ProfilePair
    depth: float
    force: float
    lateral_force: float
    peak_pressure: float
    area: float
    grid_error: float
    touch: float
    height: float
    patches: tuple[ProfilePatch, ...]
    cut: bool
    windows: int

    @property
    def angle(self) -> float:
        """Contact angle [rad] of the patch with the highest load."""
        return self.patches[0].angle

    @property
    def place(self) -> float:
        """Lateral position of its centre [m]."""
        return self.patches[0].y

    @property
    def longitudinal_creepage(self) -> float:
        """Its creepage along [-]."""
        return float(self.patches[0].creepage.longitudinal)

    @property
    def lateral_creepage(self) -> float:
        """Its creepage across [-]."""
        return float(self.patches[0].creepage.lateral)

    @property
    def spin(self) -> float:
        """Its spin [1/m]."""
        return float(self.patches[0].creepage.spin)

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: pixels, conformity, ends, yield."""
        return pair_notes(self.problem.medium, self.patches, self.grid_error, self.cut, self.windows)
