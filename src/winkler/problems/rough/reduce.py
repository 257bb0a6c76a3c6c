r"""From a height map to springs: the bed that bears forces like it does, for every other problem.

At every depth the boundary elements give F and k = dF/dd.  A disc as stiff has the radius :math:`a=k/(2E^*)`, and
:math:`g(a)=d`: with k and g any problem of the line runs, exactly as long as it needs no more than F(d).

How stiff the contacts of a height map are along x and along y: springs in both directions from solved contacts.

In each contact whose depth differs enough the tractions are found that shift all its pixels alike, without slip:
:math:`K_x` and :math:`K_y` over the normal stiffness k are ratios that change slowly with k.  Between the contacts,
whose pixels make them jump, they are the parabola in ln k that meets them best, or a line or a number if these do as
well.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator
from typing import Annotated, ClassVar, cast

import numpy as np

from winkler.foundation.directional import DirectionalBed
from winkler.foundation.measured import MeasuredBed
from winkler.foundation.measured_profile import MeasuredPlaneProfile
from winkler.foundation.plane import PlaneFoundation
from winkler.loading.loads import Depth
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.mapped import MappedMedium
from winkler.media.medium import Medium
from winkler.media.offers import offers
from winkler.media.relaxing.relaxing_medium import RelaxingMedium
from winkler.numerics.surfaces.punched_grid import stuck_stiffness
from winkler.numerics.types import Array
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.rough.contact_springs import ContactPoints, force_uncertainty, springs_of
from winkler.problems.rough.surface_contact import SurfaceContact
from winkler.problems.rough.surface_states import SurfaceState
from winkler.profiles.rough.topography import Topography
from winkler.values.checks.number_checks import Advice, Positive, between
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing, standing_left
from winkler.values.value import value

BARBER = "J. R. Barber, J. Strain Anal. 9 (1974) 230-232, doi:10.1243/03093247V094230"
LEAST_PIXELS = 200
"""Least number of pixels of the deepest contact."""
DEPTH_FACTOR = 2.0
"""Depths are first divided by this, until forces are small."""
MOST_DIVISIONS = 16
SMALLEST_FORCE_SHARE, BETWEEN_SHARE, POINT_SHARE = 0.3, 0.8, 0.15
"""Parts of the tolerance: of the smallest force, of what may be missed between contacts, and at them."""
MOST_CONTACTS = 129
NARROWEST_RATIO = 1.01
"""Depths closer than this are not divided: between them pixels come into contact one by one."""
DEPTH_MARGIN = 1.0 + 1e-6
"""The bed reaches a little deeper than requested, so that the requested depth is inside."""

ContactRow = tuple[float, float, float, float]
"""Depth [m], force [N], stiffness [N/m] and pixels of a contact."""


@value
class Reduction:
    """Computation of a spring foundation with the force-depth curve of a height map.

    Parameters
    ----------
    topography : Topography
        A non-periodic map.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
        Both bodies.
    depth : float
        Maximum depth d [m] of the springs.
    tolerance : float, optional
        Maximum error of F, over the maximum F.  Contacts are computed until all convex curves through their forces and
        stiffnesses agree within this tolerance.

    Raises
    ------
    InvalidInput
        If the map is periodic, or a number is out of range; otherwise as `SurfaceContact`.

    References
    ----------
    J. R. Barber, J. Strain Anal. 9 (1974) 230-232, doi:10.1243/03093247V094230
    """

    topography: Topography
    medium: Annotated[MappedMedium, Advice("the boundary elements apply to no other")]
    depth: Positive
    tolerance: Annotated[float, between(1e-4, 0.1)] = 1e-3

    references: ClassVar[tuple[str, ...]] = ("barber_1974", "polonsky_keer_1999", "popov_hess_2015")
    assumptions: ClassVar[frozenset[Assumption]] = frozenset(
        (Assumption.RESPONSE, Assumption.ELASTIC, Assumption.SHAPE, Assumption.RESOLUTION)
    )

    def __post_init__(self) -> None:
        SurfaceContact(self.topography, self.medium, Depth(self.depth))  # refuses what it would refuse later
        if self.topography.periodic:
            raise InvalidInput(
                "Reduction: the map is periodic and has no finite stiffness radius; cut a part out with "
                "topography.cropped(...), or use a RoughContact."
            )

    @property
    def total(self) -> None:
        """Unknown: the number of states that `steps` yields depends on the tolerance."""

    def steps(self) -> Iterator[SurfaceState]:
        """Yield the computed contacts; depths are added where the force between them is too uncertain.

        Raises
        ------
        NotConverged
            If the tolerance is not met.
        """
        deepest = next(SurfaceContact(self.topography, self.medium, Depth(DEPTH_MARGIN * self.depth)).steps())
        yield deepest
        pixels = int(np.count_nonzero(deepest.pressure))
        if pixels < LEAST_PIXELS:
            raise OutsideValidity(
                f"reduce: at the depth {self.depth:.6g} m only {pixels} pixels touch, which determines too little of "
                f"the contacts before; press until at least {LEAST_PIXELS} do, or give the map more pixels."
            )
        done, allowed, state = [_row(deepest)], self.tolerance * deepest.force, deepest
        while state.force > SMALLEST_FORCE_SHARE * allowed and len(done) < MOST_DIVISIONS:
            state = next(SurfaceContact(self.topography, self.medium, Depth(state.depth / DEPTH_FACTOR)).steps())
            done.insert(0, _row(state))
            yield state
        while requested := self._between(done, BETWEEN_SHARE * allowed):
            if len(done) + len(requested) > MOST_CONTACTS:
                raise self._lost(done)
            for state in SurfaceContact(self.topography, self.medium, Depth(np.array(requested))).steps():
                done.append(_row(state))
                yield state
            done.sort()
        if self._springs(_points(done))[1] > self.tolerance:
            raise self._lost(done)

    @staticmethod
    def _between(done: list[ContactRow], allowed: float) -> list[float]:
        """Return depths between contacts between which the force is least determined."""
        pairs = zip(itertools.pairwise(row[0] for row in done), force_uncertainty(_points(done)).tolist(), strict=True)
        return [math.sqrt(low * high) for (low, high), left in pairs if left > allowed and high > NARROWEST_RATIO * low]

    def _lost(self, done: list[ContactRow]) -> NotConverged:
        return NotConverged(
            f"reduce: {len(done)} contacts do not determine F(d) to {self.tolerance:.3g} of the maximum force; "
            "give a larger tolerance, or give the map more pixels."
        )

    def _springs(self, points: ContactPoints) -> tuple[MeasuredBed, float]:
        """Return the springs behind contacts, and the bound on their misfit over the greatest force."""
        most = float(points.force[-1])
        bed, missed = springs_of(points, self.medium, POINT_SHARE * self.tolerance * most)
        return bed, (missed + max(float(np.max(force_uncertainty(points))), float(points.force[0]))) / most

    def gathered(self, states: Iterable[SurfaceState]) -> ReductionSolution:
        """Return the solution that consists of these contacts, all or the first of them.

        Raises
        ------
        OutsideValidity
            If there are too few contacts to define the springs.
        """
        rows, stuck = [], StuckContacts(self.medium, self.topography.pixel)
        for state in states:  # which are not kept, since their maps would fill the memory
            rows.append(_row(state))
            stuck.add(state)
        points = _points(sorted(rows))
        bed, misfit = self._springs(points)
        return ReductionSolution(self, stuck.turned_to(bed), misfit, points.depth, points.force, points.stiffness)

    def solve(self) -> ReductionSolution:
        """Return the springs.

        Raises
        ------
        NotConverged
            If the tolerance is not met.
        OutsideValidity
            If too few pixels touch.
        """
        return self.gathered(self.steps())


def _row(state: SurfaceState) -> ContactRow:
    return state.depth, state.force, state.stiffness, float(np.count_nonzero(state.pressure))


def _points(done: list[ContactRow]) -> ContactPoints:
    return ContactPoints(*np.array(done).T)


@value
class ReductionSolution:
    """The solution of a `Reduction`.

    Parameters
    ----------
    problem : Reduction
        The problem that was solved.
    bed : DirectionalBed
        The springs; `bed.scatter` is the root mean square deviation from the computed forces [N]. Shear forces act
        along x, for `bed.turned` along y.
    misfit : float
        Bound on the difference between the forces of springs and map at any depth, over the maximum force. Both force
        curves are convex, which leaves little uncertainty between computed contacts.
    depth, force, stiffness : ndarray, (n,)
        The computed contacts: depth [m], force [N], stiffness [N/m].
    """

    problem: Reduction
    bed: DirectionalBed
    misfit: float
    depth: Array
    force: Array
    stiffness: Array

    @property
    def validity(self) -> tuple[Note, ...]:
        """Accuracy of the forces of the springs, and quantities that the springs do not represent."""
        bodies = () if self.bed.homogeneous else cast(Medium, self.problem.medium).notes
        return (
            Note(
                Assumption.RESOLUTION,
                standing_left(self.misfit, Standing.ASYMPTOTIC),
                f"The springs represent a height map; they were fitted to {self.depth.size} contact solutions by "
                f"boundary elements. Between these solutions the force error is at most {self.misfit:.1g} of the "
                "maximum force (bounds of a convex curve). On rough maps and at a tolerance of 1e-3 the error of "
                "stiffness and conductance is at most 4 per cent, at light loads larger.",
                BARBER,
            ),
            *self.bed.notes[1:],
            *bodies,
            *unknown_yield(self.problem.medium, "the springs of a height map do not have its pressures"),
        )

    def on(self, medium: Medium) -> PlaneFoundation:
        """Return the same map on another half-space, elastic or viscoelastic: radii and g do not depend on the modulus.

        Parameters
        ----------
        medium : HalfSpace, TransverselyIsotropicHalfSpace, ViscoelasticHalfSpace or RelaxingInProportion
            Homogeneous.

        Raises
        ------
        InvalidInput
            If the medium is not homogeneous.
        """
        elastic = medium.elastic if offers(medium, RelaxingMedium) else medium
        if not self.bed.homogeneous:
            raise InvalidInput(
                f"Reduction: these springs are those of the map on a {type(self.problem.medium).__name__}, whose "
                "layers no other medium has; reduce the map on the medium itself."
            )
        if not isinstance(elastic, HomogeneousMedium):
            raise InvalidInput(
                f"Reduction: the medium is a {type(medium).__name__}; the springs of a map need homogeneous "
                "half-spaces: give HalfSpace or ViscoelasticHalfSpace."
            )
        return PlaneFoundation(MeasuredPlaneProfile(self.bed), medium)


def reduce(topography: Topography, medium: MappedMedium, depth: float, *, tolerance: float = 1e-3) -> DirectionalBed:
    """Return a spring foundation with the force-depth curve of a height map.

    Parameters
    ----------
    topography, medium, depth, tolerance
        As for `Reduction`.

    Returns
    -------
    DirectionalBed
        A foundation for problems that require only forces and depths. Shear forces act along x, for `turned` along y.

    Raises
    ------
    InvalidInput, OutsideValidity, NotConverged
        As `Reduction`.

    Examples
    --------
    A ball of 1 m radius, E* = 1 Pa, pressed to 0.04 m: F = 4/3 R^(1/2) d^(3/2) = 0.0107 N.

    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.problems.normal.indentation import Indentation
    >>> x = (np.arange(63) - 31) / 63.0
    >>> ball = Topography(-0.5 * (x[:, None] ** 2 + x**2), [1.0, 1.0])
    >>> bed = reduce(ball, HalfSpace(Elastic(1.0, 0.0)), 0.05)
    >>> round(Indentation(bed, Depth(0.04)).solve().force, 4)
    0.0107
    """
    return Reduction(topography, medium, depth, tolerance).solve().bed


FEWEST_PIXELS = 16
"""A contact of fewer determines its stiffnesses too poorly."""
LEAST_DEPTH_RATIO = 1.4
"""Contacts whose depths differ by less are as stiff in both directions."""
ALLOWED_MISFIT = 2e-3
"""Difference of a stiffness from the computed ones, over the greatest, at which a simpler curve is enough."""
GREATEST_DEGREE = 2
LEAST_POWER = -0.5
"""Of the ratio over k: K_x must rise with k."""
ISOTROPIC = 1e-12
"""Part of the compliance that depends on the direction, of bodies where it is rounding."""


class StuckContacts:
    """Contacts that are sheared without slip.

    Parameters
    ----------
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
        Both bodies.
    pixel : tuple of float
        Sides of a pixel [m].
    """

    def __init__(self, medium: MappedMedium, pixel: tuple[float, float]) -> None:
        self.medium, self.pixel = medium, pixel
        self.compliance = compliance_of(medium)
        self.depths: list[float] = []
        self.rows: list[tuple[float, float, float]] = []
        """Normal stiffness [N/m], K_x/k and K_y/k."""

    def add(self, state: SurfaceState) -> None:
        """Take a contact, unless one of nearly its depth has been taken, or its direction does not matter."""
        touching = state.pressure > 0.0
        near = any(1.0 / LEAST_DEPTH_RATIO < state.depth / depth < LEAST_DEPTH_RATIO for depth in self.depths)
        isotropic = abs(self.compliance.along) <= ISOTROPIC and not self.compliance.layers
        if near or isotropic or np.count_nonzero(touching) < FEWEST_PIXELS:
            return
        along, across = stuck_stiffness(touching, self.pixel, self.compliance)
        self.depths.append(state.depth)
        stiffness = state.stiffness / self.medium.modulus
        self.rows.append((state.stiffness, along / stiffness, across / stiffness))

    def turned_to(self, bed: MeasuredBed) -> DirectionalBed:
        """Return these springs with the stiffness of both directions."""
        count = bed.radii.size
        ratios = np.full((2, count), self.medium.shear_modulus / self.medium.modulus)
        if self.rows:
            stiffness, *computed = np.array(sorted(self.rows)).T
            for i in range(2):
                ratios[i] = _fitted(stiffness, computed[i], bed.stiffnesses)
        return DirectionalBed(
            bed.radii, bed.stiffnesses, bed.depths, bed.scatter, bed.mindlin_ratio, bed.disc,
            ratios_along=ratios[0], ratios_across=ratios[1],
            homogeneous=isinstance(self.medium, HomogeneousMedium),
        )  # fmt: skip


def _fitted(stiffness: Array, ratio: Array, places: Array) -> Array:
    """Return the ratio at other stiffnesses: the simplest polynomial in ln k that meets the computed ones."""
    weight, powers = stiffness / stiffness[-1], np.log(stiffness / stiffness[-1])
    curve = np.polynomial.Polynomial([np.average(ratio, weights=weight)])
    for degree in range(1, min(GREATEST_DEGREE, ratio.size - 2) + 1):
        if float(np.max(np.abs(curve(powers) - ratio) * weight)) <= ALLOWED_MISFIT:
            break
        bent = np.polynomial.Polynomial.fit(powers, ratio, degree, w=weight)
        if np.min(bent.deriv()(powers) / bent(powers)) < LEAST_POWER:
            break
        curve = bent
    with np.errstate(divide="ignore"):
        within = np.clip(np.log(places / stiffness[-1]), powers[0], powers[-1])
    return np.asarray(curve(within))
