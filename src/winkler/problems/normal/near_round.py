r"""Bodies that are nearly round: force and contour of the contact, from the springs of every direction.

Along the direction phi the profile f(r, phi) has its own :math:`g_\varphi(x)`.  Betti's theorem with the pressure of a
nearly round flat punch (Fabrikant), and the largest force among all contours (Barber), give

.. math:: F = 2E^*\frac{\langle a I\rangle}{\langle a\rangle} , \qquad I = \int_0^a(d-g_\varphi)\,\mathrm dx , \qquad
          I + a\,(d-g_\varphi(a)) = \frac{F}{2E^*} \text{ in every direction} ,

with means over the directions; for round bodies the last equation is g(a) = d.

On layers, gradings and power laws the body, a spline from direction to direction, is pressed by pixels
(`winkler.problems.pressed_shape.pressed_map`).
"""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.foundation.bed import PressedSprings
from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth, Force
from winkler.loading.path import numbers_of
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HalfSpace, HomogeneousMedium
from winkler.media.mapped import MappedMedium
from winkler.numerics.equations.bracketing import between
from winkler.numerics.equations.roots import invert, rough_root
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.normal.elliptic import EDGE_ERROR
from winkler.problems.normal.greatest_stress import sharp_places
from winkler.problems.normal.map_yield import map_yield_notes
from winkler.problems.normal.solve_contact import at_depth
from winkler.problems.normal.strong_parts import strong_parts
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.normal.validity import steepness_note
from winkler.problems.pressed_shape.notes import pixel_notes
from winkler.problems.pressed_shape.pressed_map import PressedMap, edge_error, grid_error, pressed_levels
from winkler.problems.pressed_shape.rounded_body import RoundedBody
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.profiles.profile import Profile
from winkler.values.checks.field_checks import Condition
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

OVAL_RATIO = 1.5
"""Ratio of the largest to the smallest radius beyond which the contour is off by some per cent.

Where it would be more than about 3 the equations have no solution any more.
"""
BETWEEN_DIRECTIONS = Note(
    Assumption.SHAPE,
    Standing.APPROXIMATE,
    "Between the given directions the body is a periodic cubic spline. With 32 directions the spline follows an "
    "elliptic paraboloid within 1e-4 of its height. Compare with more directions.",
    "interpolation in the angle",
)
MEASURED = "exact ellipses, and boundary elements for pyramids and a square"


PRESSED_TOGETHER = Condition(
    lambda load: bool(np.all((load.force if isinstance(load, Force) else load.depth) > 0.0)),
    "give a positive Force or Depth, or an array of them",
)


@value
class NearlyRoundIndentation(PerLoad[Q]):
    """A nearly axisymmetric body pressed into a half-space or into layers.

    Parameters
    ----------
    profiles : tuple of Profile
        Profiles along equally spaced directions around the axis.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, SlidingFilm, StackedHalfSpace, \
DepthGradedHalfSpace or GradedHalfSpace
        Both bodies. Homogeneous bodies are solved with springs in every direction, others with pixels.
    load : Force or Depth
        The prescribed quantity, positive; its value may be an array.

    Raises
    ------
    InvalidInput
        If there are fewer than four directions, the medium is another one, or a load is not positive.

    References
    ----------
    V. L. Popov, Symmetry 14 (2022) 390, doi:10.3390/sym14020390

    Examples
    --------
    An elliptic paraboloid 0.4 x^2 + 0.6 y^2, E* = 1: exactly F = (4/3) 1.0276201^(1/2) d^(3/2).

    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> turns = np.arange(32) * 2.0 * np.pi / 32
    >>> bends = 0.4 * np.cos(turns) ** 2 + 0.6 * np.sin(turns) ** 2
    >>> body = tuple(Paraboloid(float(0.5 / bend)) for bend in bends)
    >>> oval = NearlyRoundIndentation(body, HalfSpace(Elastic(1.0, 0.0)), Depth(0.01)).solve()
    >>> round(oval.force / (4.0 / 3.0 * 1.0276201**0.5 * 0.01**1.5) - 1.0, 4)
    0.0
    """

    __words__ = words(profiles=("", None, "the profile along equally spaced directions"))

    profiles: tuple[Profile, ...]
    medium: MappedMedium
    load: Annotated[Force[Q] | Depth[Q], PRESSED_TOGETHER]

    references: ClassVar[tuple[str, ...]] = ("popov_2022", "barber_1974", "popov_hess_2015", "polonsky_keer_1999")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED

    def __post_init__(self) -> None:
        if len(self.profiles) < 4:
            raise InvalidInput(
                "NearlyRoundIndentation: profiles must be at least four, one for each of equally spaced directions."
            )

    def solve(self) -> NearlyRoundSolution[Q]:
        """Return force, depth and contour.

        Raises
        ------
        OutsideValidity
            If the body is too far from round, or its profiles are too short, to determine the contour.
        NotConverged
            If the iteration for the force or the pressures does not converge.
        """
        if not isinstance(self.medium, HomogeneousMedium):
            return self._by_pixels()
        prescribed, springs = numbers_of(self.load), Directions(self.profiles, self.medium)
        if isinstance(self.load, Force):
            forces = prescribed.ravel()
            depths = invert(
                lambda d: springs.pressed(d)[:2], forces, lower=0.0, upper=math.inf, guess=springs.shallow(forces)
            )
            _, stiffness, contours = springs.pressed(depths)
        else:
            depths = prescribed.ravel()
            forces, stiffness, contours = springs.pressed(depths)

        columns: list[Q] = [shaped(each, prescribed.shape) for each in (depths, forces, stiffness)]
        d, f, k = columns
        none: Q = shaped(np.zeros(prescribed.shape))
        return NearlyRoundSolution(self, d, f, k, contours.reshape((*prescribed.shape, -1)), none, none)

    def _by_pixels(self) -> NearlyRoundSolution[Q]:
        """Return the solution on layers, gradings and power laws, load by load."""
        assert not isinstance(self.medium, HomogeneousMedium)
        body, by_force, loads = RoundedBody(self.profiles), isinstance(self.load, Force), numbers_of(self.load)
        rows, contours = np.empty((5, loads.size)), np.empty((loads.size, len(self.profiles)))
        for number, load in enumerate(loads.ravel().tolist()):
            given = Force(load) if by_force else Depth(load)
            coarse, fine = pressed_body(body, self.medium, given)
            contours[number] = fine.contour(body.angles)
            body.refuse_beyond(contours[number], fine)
            errors = grid_error(coarse, fine), edge_error(coarse, fine, body.angles)
            rows[:, number] = fine.depth, fine.force, fine.stiffness, *errors
        columns: list[Q] = [shaped(row, loads.shape) for row in rows]
        d, f, k, grid, edge = columns
        return NearlyRoundSolution(self, d, f, k, contours.reshape((*loads.shape, -1)), grid, edge)


@value
class NearlyRoundSolution(PerLoad[Q]):
    """The solution of a `NearlyRoundIndentation`; quantities have the shape of the depth.

    Parameters
    ----------
    problem : NearlyRoundIndentation
        The problem that was solved.
    depth : float or ndarray
        d [m].
    force : float or ndarray
        F_N [N].
    stiffness : float or ndarray
        dF/dd [N/m], of a flat punch of this contour.
    contour : ndarray, (..., n)
        Radius of the contact [m] in every direction.
    grid_error : float or ndarray
        Relative change of depth, force and maximum pressure compared with half as many pixels along a side; zero for
        springs.
    edge_error : float or ndarray
        Relative error of stiffness and contour due to the pixels; zero for springs.
    """

    __words__ = words(edge_error=EDGE_ERROR)

    problem: NearlyRoundIndentation[Q]
    depth: Q
    force: Q
    stiffness: Q
    contour: Array
    grid_error: Q
    edge_error: Q

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        medium = self.problem.medium
        yielding = self._yield_notes()
        if not isinstance(medium, HomogeneousMedium):
            errors = float(np.max(self.grid_error)), float(np.max(self.edge_error))
            return (*pixel_notes(medium, *errors), BETWEEN_DIRECTIONS, steepness_note(self._slope), *yielding)
        ratio = float(np.max(np.max(self.contour, axis=-1) / np.min(self.contour, axis=-1)))
        if ratio <= OVAL_RATIO:
            accuracy = (
                "Compared with ellipses the force differs by at most 0.1 % and the radius by at most 1 %. "
                "Compared with bodies with edges they differ by 2 % and 7 %"
            )
        else:
            accuracy = (
                "The force differs by at most 4 per cent, area and radius by 15 per cent from those of "
                "comparable ellipses and pyramids"
            )
        note = Note(
            Assumption.RESPONSE,
            Standing.APPROXIMATE,
            f"The maximum contact radius is {ratio:.3g} times the minimum. {accuracy}.",
            MEASURED,
        )
        return (*medium.notes, steepness_note(self._slope), note, *yielding)

    def _yield_notes(self) -> tuple[Note, ...]:
        """Return whether the bodies stay elastic under the greatest load, by pixels."""
        medium = self.problem.medium
        if not strong_parts(medium):
            return ()
        return unknown_yield(medium, SHARP) if self._sharp else map_yield_notes(medium, self.surface_load)

    @property
    def _sharp(self) -> bool:
        contour = np.max(self.contour.reshape(-1, len(self.problem.profiles)), axis=0)
        return any(_is_sharp(profile, radius) for profile, radius in zip(self.problem.profiles, contour, strict=True))

    @property
    def surface_load(self) -> SurfaceLoad:
        """The pressures of pixels under the greatest load.

        Raises
        ------
        OutsideValidity
            If the pressure is infinite at a sharp tip, kink or rim.
        """
        if self._sharp:
            raise OutsideValidity(f"NearlyRoundIndentation: {SHARP}.")
        force, depth = float(np.max(self.force)), float(np.max(self.depth))
        load = Force(force) if isinstance(self.problem.load, Force) else Depth(depth)
        return pressed_body(RoundedBody(self.problem.profiles), self.problem.medium, load)[1].load()

    @property
    def _slope(self) -> float:
        """The steepest of the body within the contact [-]."""
        slope = 0.0
        for profile, radii in zip(self.problem.profiles, np.moveaxis(self.contour, -1, 0), strict=True):
            inside = np.ravel(radii)[:, np.newaxis] * np.linspace(0.0, 1.0, 17)[1:-1]
            slope = max(slope, float(np.max(np.abs(profile.slope(inside)))))
        return slope


def pressed_body(body: RoundedBody, medium: MappedMedium, load: Force | Depth) -> tuple[PressedMap, PressedMap]:
    """Return a body pressed by pixels under one load, on a coarse grid and on a fine one."""
    start, limit = (body.start(load, medium.modulus),) * 2, (body.reach,) * 2
    return pressed_levels("NearlyRoundIndentation", body.gap, medium, load, start, limits=limit)


def _is_sharp(profile: Profile, radius: float) -> bool:
    """Return whether stresses are infinite below a profile that touches up to a radius [m]."""
    bed = Foundation(profile, HalfSpace(Elastic(1.0, 0.0)))
    a = min(radius, bed.reach * (1.0 - END_MARGIN))
    pressed = PressedSprings(bed, float(bed.gap(np.array([a]))[0]), a)
    return radius >= (1.0 - RIM) * bed.rim or any(sharp_places(pressed, 0.0, 0.0))


SHARP = "the elastic stress is infinite at a sharp tip, kink or rim"
MOST_ITERATIONS = 60
FORCE_TOLERANCE = 1e-13
DOUBLINGS = 60
END_MARGIN = 1e-12
RIM = 0.02
"""Distance from a rim within which a contour of pixels counts as on it, over its radius."""
LEAST_RATIO = 1e-9
"""Over the radius where g(a) = d, where a contour is no longer sought."""


class Directions:
    """The springs of all directions, those of equal profiles once."""

    def __init__(self, profiles: tuple[Profile, ...], medium: HomogeneousMedium) -> None:
        indices: dict[Profile, int] = {}
        self.which = np.array([indices.setdefault(profile, len(indices)) for profile in profiles])
        self.beds = [Foundation(profile, medium) for profile in indices]  # type: ignore[arg-type]
        self.rims = np.array([bed.rim for bed in self.beds])[self.which]
        # where a profile ends without a rim its g may be infinite
        self.ends = np.array([min(bed.rim, bed.reach * (1.0 - END_MARGIN)) for bed in self.beds])[self.which]
        self.twice = 2.0 * medium.modulus

    def shallow(self, forces: Array) -> float:
        """Return a depth [m] where a search for these forces [N] may begin."""
        bed = self.beds[0]
        length = 0.01 * float(np.min(self.ends))
        if not math.isfinite(length):
            most = float(np.max(forces))
            length = rough_root(lambda a: bed.stiffness(a) * bed.gap(a) - bed.gap_load(a), most)
        place = np.array([length])
        return max(*(float(bed.gap(place)[0]) for bed in self.beds), 1e-6 * length)

    def pressed(self, depths: Array) -> tuple[Array, Array, Array]:
        """Return forces [N], stiffnesses [N/m] (m,) and contours [m] (m, n) at depths (m,)."""
        with np.errstate(divide="ignore", invalid="ignore"):  # next to where a profile ends
            return self._settled(depths)

    def _settled(self, depths: Array) -> tuple[Array, Array, Array]:
        touching = np.stack([at_depth(bed, depths)[1] for bed in self.beds], axis=1)[:, self.which]
        low = self._lows(depths, touching)
        radii = touching
        level = self._level(radii, depths)
        for _ in range(MOST_ITERATIONS):
            radii = self._contour(level, depths, low, touching)
            new = self._level(radii, depths)
            if np.all(np.abs(new - level) <= FORCE_TOLERANCE * np.abs(new)):
                mean = np.mean(radii, axis=1)
                return self.twice * new, self.twice * np.mean(radii**2, axis=1) / mean, radii
            level = new
        raise NotConverged(f"NearlyRoundIndentation: at the depth {depths[0]:.6g} m the force does not converge.")

    def _level(self, radii: Array, depths: Array) -> Array:
        """Return F / (2 E*) [m^2] of contours."""
        depth, every = np.broadcast_to(depths[:, None], radii.shape).ravel(), np.arange(radii.size)
        pressed = self._pressed(radii.ravel(), depth, every).reshape(radii.shape)
        return np.asarray(np.mean(radii * pressed, axis=1) / np.mean(radii, axis=1))

    def _bed_values(self, word: str, radii: Array, index: Array) -> Array:
        """Return a quantity of the bed of every direction at radii (k,), those at `index` of all (m n,)."""
        which, rows = self.which[index % self.which.size], np.empty(radii.size)
        for number, bed in enumerate(self.beds):
            here = which == number
            if here.any():
                rows[here] = getattr(bed, word)(radii[here])
        return rows

    def _pressed(self, radii: Array, depth: Array, index: Array) -> Array:
        """Return I, the integral of d - g up to the contour [m^2]."""
        return np.asarray(depth * radii - self._bed_values("gap_load", radii, index) / self.twice)

    def _balance(self, radii: Array, depth: Array, index: Array) -> Array:
        """Return I + a (d - g(a)), which falls where the contour may lie."""
        return np.asarray(self._pressed(radii, depth, index) + radii * (depth - self._bed_values("gap", radii, index)))

    def _lows(self, depths: Array, touching: Array) -> Array:
        """Return the radii from which on the balance falls; the rim where it never does."""
        depth = np.repeat(depths, self.which.size)

        def steepness(logarithm: Array, index: Array) -> Array:
            a = np.exp(logarithm)
            spring = depth[index] - self._bed_values("gap", a, index)
            return np.asarray(2.0 * spring - a * self._bed_values("gap_slope", a, index))

        high = np.log(touching).ravel()
        rising = steepness(high, np.arange(high.size)) >= 0.0
        log_radius = high.copy()
        places = np.flatnonzero(~rising)
        log_radius[places] = between(
            lambda at, index: steepness(at, places[index]), high[places] + math.log(LEAST_RATIO), high[places]
        )
        return np.asarray(np.exp(log_radius).reshape(touching.shape))

    def _contour(self, level: Array, depths: Array, low: Array, touching: Array) -> Array:
        """Return where the balance is `level` in every direction; the rim where it is more."""
        count = self.which.size
        depth, wanted = np.repeat(depths, count), np.repeat(level, count)

        def missing(logarithm: Array, index: Array) -> Array:
            return np.asarray(self._balance(np.exp(logarithm), depth[index], index) - wanted[index])

        bottom, top = np.log(low).ravel(), np.log(touching).ravel()
        every, end = np.arange(bottom.size), np.log(np.tile(self.ends, depths.size))
        bad = missing(bottom, every) < -FORCE_TOLERANCE * wanted
        if bad.any():
            raise OutsideValidity(
                f"NearlyRoundIndentation: at the depth {depth[bad][0]:.6g} m there is no contour, because the "
                "body is too far from round; use SurfaceContact."
            )
        above = every[missing(top, every) > 0.0]
        for _ in range(DOUBLINGS):
            above = above[top[above] < end[above]]
            if not above.size:
                break
            top[above] = np.minimum(top[above] + math.log(2.0), end[above])
            above = above[missing(top[above], above) > 0.0]
        pinned = missing(top, every) >= 0.0
        short = pinned & (np.tile(self.rims, depths.size) > np.exp(top))
        if short.any():
            raise OutsideValidity(
                f"NearlyRoundIndentation: the depth {depth[short][0]:.6g} m leads beyond the reach of the profile in "
                f"direction {np.flatnonzero(short)[0] % count}; press less."
            )
        free = every[~pinned]
        log_radius = top.copy()
        log_radius[free] = between(lambda at, index: missing(at, free[index]), np.minimum(bottom, top)[free], top[free])
        return np.asarray(np.exp(log_radius).reshape(low.shape))
