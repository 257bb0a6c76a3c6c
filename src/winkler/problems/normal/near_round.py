r"""Bodies that are nearly round: force and contour of the contact, from the springs of every direction.

Along the direction phi the profile f(r, phi) has its own :math:`g_\varphi(x)`.  Betti's theorem with the pressure of a
nearly round flat punch (Fabrikant), and the largest force among all contours (Barber), give

.. math:: F = 2E^*\frac{\langle a I\rangle}{\langle a\rangle} , \qquad I = \int_0^a(d-g_\varphi)\,\mathrm dx , \qquad
          I + a\,(d-g_\varphi(a)) = \frac{F}{2E^*} \text{ in every direction} ,

with means over the directions; for round bodies the last equation is g(a) = d.
"""

from __future__ import annotations

import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.checks.field_checks import Condition
from winkler.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.foundation.foundation import Foundation
from winkler.loading import Depth, Force
from winkler.media.halfspace import HomogeneousMedium
from winkler.numerics.equations.bracketing import between
from winkler.numerics.equations.roots import invert, rough_root
from winkler.numerics.types import Array, Quantity, shaped
from winkler.problems.assumptions.declared import PRESSED
from winkler.problems.normal.solve_contact import at_depth
from winkler.problems.normal.validity import steepness_note
from winkler.problems.normal.yield_statement import unknown_yield
from winkler.profiles.profile import Profile
from winkler.validity import Assumption, Note, Standing
from winkler.values import value, words

__all__ = ["NearlyRoundIndentation", "NearlyRoundSolution"]

MOST_ITERATIONS = 60
FORCE_TOLERANCE = 1e-13
DOUBLINGS = 60
END_MARGIN = 1e-12
LEAST_RATIO = 1e-9
"""Over the radius where g(a) = d, where a contour is no longer sought."""
OVAL_RATIO = 1.5
"""Ratio of the largest to the smallest radius beyond which the contour is off by some per cent.

Where it would be more than about 3 the equations have no solution any more.
"""
MEASURED = "exact ellipses, and boundary elements for pyramids and a square"


PRESSED_TOGETHER = Condition(
    lambda load: bool(np.all((load.force if isinstance(load, Force) else load.depth) > 0.0)),
    "give a positive Force or Depth, or an array of them",
)


@value
class NearlyRoundIndentation:
    """A body that is nearly one of revolution, pressed into a half-space.

    Parameters
    ----------
    profiles : tuple of Profile
        The profile along equally spaced directions, around the axis.
    medium : HalfSpace
        Both bodies, homogeneous.
    load : Force or Depth
        What is prescribed, positive; its value may be an array.

    Raises
    ------
    InvalidInput
        If there are fewer than four directions, the medium is not homogeneous, or a load is not positive.

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
    medium: HomogeneousMedium
    load: Annotated[Force | Depth, PRESSED_TOGETHER]

    references: ClassVar[tuple[str, ...]] = ("popov_2022", "barber_1974", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = PRESSED

    def __post_init__(self) -> None:
        if len(self.profiles) < 4:
            raise InvalidInput(
                "NearlyRoundIndentation: profiles must be at least four, one for each of equally spaced directions."
            )

    @property
    def _prescribed(self) -> Array:
        return np.asarray(self.load.force if isinstance(self.load, Force) else self.load.depth, dtype=float)

    def solve(self) -> NearlyRoundSolution:
        """Return force, depth and contour.

        Raises
        ------
        OutsideValidity
            If the body is so far from round, or known so little of, that there is no contour.
        NotConverged
            If the force does not settle.
        """
        prescribed = self._prescribed
        springs = _Directions(self.profiles, self.medium)
        if isinstance(self.load, Force):
            forces = prescribed.ravel()
            depths = invert(
                lambda d: springs.pressed(d)[:2], forces, lower=0.0, upper=math.inf, guess=springs.shallow(forces)
            )
            _, stiffness, contours = springs.pressed(depths)
        else:
            depths = prescribed.ravel()
            forces, stiffness, contours = springs.pressed(depths)

        return NearlyRoundSolution(
            self,
            shaped(depths, prescribed.shape),
            shaped(forces, prescribed.shape),
            shaped(stiffness, prescribed.shape),
            contours.reshape((*prescribed.shape, -1)),
        )


class _Directions:
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
        raise NotConverged(f"NearlyRoundIndentation: at the depth {depths[0]:.6g} m the force does not settle.")

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
                f"NearlyRoundIndentation: at the depth {depth[bad][0]:.6g} m there is no contour, the body is too far "
                "from round; use SurfaceContact."
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


@value
class NearlyRoundSolution:
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
    """

    problem: NearlyRoundIndentation
    depth: Quantity
    force: Quantity
    stiffness: Quantity
    contour: Array

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted."""
        ratio = float(np.max(np.max(self.contour, axis=-1) / np.min(self.contour, axis=-1)))
        if ratio <= OVAL_RATIO:
            accuracy = "forces within 0.1 and radii within 1 per cent of ellipses; of bodies with edges within 2 and 7"
        else:
            accuracy = "forces within 4, areas and radii within 15 per cent of ellipses and pyramids like this"
        note = Note(
            Assumption.RESPONSE,
            Standing.APPROXIMATE,
            f"The widest radius of the contact is {ratio:.3g} times the smallest: {accuracy}.",
            MEASURED,
        )
        slope = 0.0
        for profile, radii in zip(self.problem.profiles, np.moveaxis(self.contour, -1, 0), strict=True):
            inside = np.ravel(radii)[:, np.newaxis] * np.linspace(0.0, 1.0, 17)[1:-1]
            slope = max(slope, float(np.max(np.abs(profile.slope(inside)))))
        medium = self.problem.medium
        yielding = unknown_yield(medium, "the stresses under a contact that is not round are not computed")
        return (*medium.notes, steepness_note(slope), note, *yielding)
