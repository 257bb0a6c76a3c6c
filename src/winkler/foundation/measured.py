r"""A bed from measurements: stiffness and depth of the contact as functions of the contact radius.

Two functions are enough, k(a) and g(a), and both can be measured: k is the slope dF/dd, the contact radius is read
from a microscope or, on a medium of known modulus, from the stiffness itself, :math:`a = k/(2E^*)`, and g(a) is the
depth.  Between the points ln g and ln k are splines of ln x: power laws, which most contacts nearly are, come out
exactly.  With them every other load on the same bed can be solved; but the shape of the body and the pressure
do not follow from a force curve.
"""

from __future__ import annotations

import functools
import math
from typing import Annotated, Any

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.footprint import DISC, Footprint, UnknownOutline
from winkler.foundation.force_curve import FEWEST_POINTS, bed_points
from winkler.numerics.panels.power_splines import PowerSplines
from winkler.numerics.transforms import abel
from winkler.numerics.types import Array, ArrayLike
from winkler.values.checks.number_checks import NON_NEGATIVE, Advice, NonNegative, Numbers
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.limits import MEASURED_PLACES
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

LEAST_RADIUS_RATIO = 1e-6
"""Where slopes at the axis are taken, relative to the first radius."""
UNKNOWN_OUTLINE = UnknownOutline(
    "measured or computed stiffnesses",
    "for a height map use SurfaceContact or SurfaceConduction, for a contact that is known to be a disc give "
    "MeasuredBed(..., disc=True) or Foundation(profile, medium)",
)
BARBER = "J. R. Barber, Determining the contact area in elastic-indentation problems, J. Strain Anal. 9 (1974) 230-232"


RISING_ADVICE = Advice("radius, stiffness and depth must grow together: smooth the data, or use MeasuredBed.from_curve")


@value
class MeasuredMedium:
    """The medium under a `MeasuredBed`: its stiffness is known, nothing else; requesting more raises the reason.

    Parameters
    ----------
    bed : Bed
        What was measured.
    """

    bed: Bed

    def _unknown(self, *_: Any, **__: Any) -> Any:
        """Refused."""
        raise OutsideValidity(
            "MeasuredBed: gaps of other bodies, pressures, displacements and stresses cannot be restored from measured "
            "stiffness and depth, since neither the body nor the medium is known; give Foundation(profile, medium) for "
            "fields."
        )

    gap = gap_slope = gap_load = kinks = punch_pressure = punch_facts = pressure = displacement = interior = _unknown

    @property
    def notes(self) -> tuple[Note, ...]:
        """As the bed."""
        return self.bed.notes

    def punch_stiffness(self, radius: Array) -> Array:
        """k(a) [N/m]."""
        return self.bed.stiffness(radius)

    def normal_stiffness(self, x: Array) -> Array:
        """c_N(x) [Pa]."""
        return self.bed.normal_stiffness(x)

    def normal_stiffness_slope(self, x: Array) -> Array:
        """c_N'(x) [Pa/m]."""
        return self.bed.normal_stiffness_slope(x)

    def tangential_stiffness(self, x: Array) -> Array:
        """c_T(x) [Pa]."""
        return self.bed.tangential_stiffness(x)


@value
class MeasuredBed:
    """A spring foundation (`bed`) with measured or computed stiffness and gap.

    Parameters
    ----------
    radii : array_like, (n,)
        Contact radii a [m], rising; for a contact that is not a disc, those of the disc of equal stiffness.
    stiffnesses : array_like, (n,)
        k = dF/dd [N/m] at these radii, rising.
    depths : array_like, (n,)
        d = g(a) [m] at these radii, rising; zero at the first point only: a flat end of that radius.
    scatter : float, optional
        Root mean square misfit [N] of the force curve behind the points; zero if there is none.
    mindlin_ratio : float, optional
        c_T/c_N = G*/E* [-], for tangential problems; 2 (1 - nu) / (2 - nu) for a homogeneous body against a rigid
        one. Zero (the default) if it is not known.
    disc : bool, optional
        Whether the contact is known to be a disc of these radii. Problems that need a disc, such as adhesion, require
        True.

    Raises
    ------
    InvalidInput
        If the arrays do not fit one another, or do not rise.
    """

    __words__ = words(
        radii=("a_i", "m", "contact radii, those of discs of equal stiffness"),
        depths=("d_i", "m", "indentation depths, one for each contact radius"),
    )

    radii: Annotated[Array, Numbers(NON_NEGATIVE, FEWEST_POINTS, MEASURED_PLACES, "rising"), RISING_ADVICE]
    stiffnesses: Annotated[Array, Numbers(NON_NEGATIVE, FEWEST_POINTS, MEASURED_PLACES, "rising"), RISING_ADVICE]
    depths: Annotated[Array, Numbers(NON_NEGATIVE, FEWEST_POINTS, MEASURED_PLACES, "rising"), RISING_ADVICE]
    scatter: NonNegative = 0.0
    mindlin_ratio: NonNegative = 0.0
    disc: bool = False

    def __post_init__(self) -> None:
        sizes = self.radii.size, self.stiffnesses.size, self.depths.size
        if len(set(sizes)) > 1:
            raise InvalidInput(
                f"MeasuredBed: there are {sizes[0]} radii, {sizes[1]} stiffnesses and {sizes[2]} depths; give three "
                "one-dimensional arrays of equal length."
            )

    @classmethod
    def from_curve(
        cls, depth: ArrayLike, force: ArrayLike, modulus: float, *, mindlin_ratio: float = 0.0, disc: bool = False
    ) -> MeasuredBed:
        """Return the spring foundation that reproduces one measured or computed force curve.

        A convex curve is fitted (`winkler.numerics.panels.convex_spline`), k is its slope, and a = k / (2 modulus).

        Parameters
        ----------
        depth, force : array_like, (n,)
            d [m] and F [N] of the loading, from first touch on, in any order, at least six different depths.
        modulus : float
            E* [Pa]. The modulus affects only the radii; forces and stiffnesses at given depths do not depend on it.
        mindlin_ratio, disc : optional
            As for the class.

        Raises
        ------
        InvalidInput
            If the data are too few or not finite, do not start at first touch, or deviate too much from every convex
            curve.
        """
        points = bed_points(depth, force, modulus)
        rows = (points.radii, points.stiffnesses, points.depths)
        return cls(*rows, scatter=points.scatter, mindlin_ratio=mindlin_ratio, disc=disc)

    @property
    def footprint(self) -> Footprint:
        """A disc, if the contact is known to be one."""
        return DISC if self.disc else UNKNOWN_OUTLINE

    @property
    def medium(self) -> MeasuredMedium:
        """A medium with known stiffness and no other property."""
        return MeasuredMedium(self)

    @property
    def reach(self) -> float:
        """The maximum measured radius [m]."""
        return float(self.radii[-1])

    rim = math.inf
    """Infinite: a pinned contact does not widen with the load, so none was measured."""

    size = math.inf
    """Infinite: the body is not known."""

    @property
    def kinks(self) -> tuple[tuple[float, float], ...]:
        """The measured points, where one cubic meets the next."""
        first = 0 if self.depths[0] == 0.0 and self.radii[0] > 0.0 else 1
        return tuple((float(x), 0.0) for x in self.radii[first:-1] if x > 0.0)

    rising = True
    """It was checked that the depth rises with the radius."""

    certain = True
    """The points are of real contacts, whatever their shape: there is nothing to check."""

    @property
    def notes(self) -> tuple[Note, ...]:
        """A note on the origin of the points and the quality of the fit."""
        how = f"; the force curve is met within {self.scatter:.3g} N (root mean square)" if self.scatter else ""
        return (
            Note(
                Assumption.RESPONSE,
                Standing.APPROXIMATE if self.scatter else Standing.ASYMPTOTIC,
                f"Stiffness and depth were given at {self.radii.size} contact radii{how}. Results are as accurate "
                "as these values, for bodies of any shape.",
                BARBER,
            ),
            Note(
                Assumption.SHAPE,
                Standing.ASYMPTOTIC,
                "Radii are those of discs of equal stiffness. Slopes are those of the body of revolution that "
                "would have this stiffness on a homogeneous half-space. The true body and its pressure are not "
                "known.",
                "V. L. Popov, M. Hess, Method of Dimensionality Reduction, Springer 2015, "
                "doi:10.1007/978-3-642-53876-6",
            ),
        )

    def height(self, r: Array) -> Array:
        """f(r) [m] of the body of revolution that a homogeneous half-space would need for these springs."""
        return self._restored(r, times_exponent=False)

    def slope(self, r: Array) -> Array:
        """f'(r) [-] of that body."""
        r = np.asarray(r, dtype=float)
        return np.where(r > 0.0, self._restored(r, times_exponent=True) / np.where(r > 0.0, r, 1.0), 0.0)

    def _restored(self, r: Array, *, times_exponent: bool) -> Array:
        """Return the transform of g, or of x g', to the body.

        Below the first point g is a power, often a broken one that no quadrature integrates: its part is in closed
        form.
        """
        from scipy.special import beta, betainc

        r = np.asarray(r, dtype=float)
        first = float(self.radii[0] if self.radii[0] > 0.0 else self.radii[1])
        level, rise = (float(part[0]) for part in _springs(self).gap(np.array([0.5 * first])))
        power = 0.5 * first * rise / level if level > 0.0 else 0.0  # none under a flat end

        def above(x: Array) -> Array:
            return np.where(x > first, x * self.gap_slope(x) if times_exponent else self.gap(x), 0.0)

        # (2/pi) times the integral of x^n / sqrt(r^2 - x^2) from 0 to the first point, or to r if that comes before
        half = 0.5 * power + 0.5
        share = (first / np.maximum(r, first)) ** 2
        strength = level * (power if times_exponent else 1.0) * beta(half, 0.5) / math.pi
        below = strength * (2.0 * r / first) ** power * betainc(half, 0.5, share)
        edges = sorted({first, *(b for b, _ in self.kinks)})
        return np.asarray(abel.surface(above, edges, r) + below)

    def gap(self, x: Array) -> Array:
        """g(x) [m]."""
        return _springs(self).gap(np.asarray(x, dtype=float))[0]

    def gap_slope(self, x: Array) -> Array:
        """g'(x) [-]."""
        return _springs(self).gap(self._off_axis(x))[1]

    def gap_bend(self, x: Array) -> Array:
        """g''(x) [1/m], for x > 0; of a spline between few points, so not more accurate than they are."""
        return _springs(self).gap_bend(self._off_axis(x))

    def gap_load(self, radius: Array) -> Array:
        """The integral of k'(x) g(x) from 0 to `radius` [N]."""
        return _springs(self).load(np.asarray(radius, dtype=float))

    def stiffness(self, radius: Array) -> Array:
        """k(a) [N/m]."""
        return _springs(self).stiffness(np.asarray(radius, dtype=float))[0]

    def normal_stiffness(self, x: Array) -> Array:
        """c_N(x) = k'(x)/2 [Pa]; at x = 0 that close to it, since no points give the power there exactly."""
        return np.asarray(0.5 * _springs(self).stiffness(self._off_axis(x))[1])

    def _off_axis(self, x: Array) -> Array:
        x = np.asarray(x, dtype=float)
        first = self.radii[0] if self.radii[0] > 0.0 else self.radii[1]
        return np.where(x > 0.0, x, LEAST_RADIUS_RATIO * first)

    def normal_stiffness_slope(self, x: Array) -> Array:
        """c_N'(x) [Pa/m], for x > 0; of a spline between few points, so not more accurate than they are."""
        return np.asarray(0.5 * _springs(self).stiffness_bend(np.asarray(x, dtype=float)))

    def tangential_stiffness(self, x: Array) -> Array:
        """c_T(x) [Pa], the Mindlin ratio times c_N(x)."""
        if self.mindlin_ratio == 0.0:
            raise OutsideValidity(
                "MeasuredBed: a normal force curve does not determine the tangential stiffness; give mindlin_ratio = "
                "G*/E*, 2 (1 - nu) / (2 - nu) for a homogeneous body."
            )
        return np.asarray(self.mindlin_ratio * self.normal_stiffness(x))


@functools.lru_cache(maxsize=64)
def _springs(bed: MeasuredBed) -> PowerSplines:
    return PowerSplines(bed.radii, bed.stiffnesses, bed.depths)
