r"""A height map that an elastic half-space attracts: approach and retraction, snap-in, pull-off and what they cost.

At every displacement d the surface rests in a minimum of the energy of bodies and surfaces,

.. math:: E = \tfrac12\int p\,u\,\mathrm dA + \int\phi(g)\,\mathrm dA , \qquad g = h - d + u \ge 0 ,

the one that it reaches from the displacement before without ever raising the energy.  Where this minimum ceases to
exist the surfaces jump to the next one, and what the energy falls by is lost.

The pull-off force of an attraction without range (JKR), from two attractions of short range.

Beside an edge that parts, an attraction acts over a zone of the length :math:`\ell = E^*w/\sigma^2`.  As long as it is
narrow, the pull-off force differs from that without range by about :math:`\ell^{4/5}`: of balls under the exponential
law by 3.6, 2.1 and 1.2 per cent at Tabor numbers of 2.5, 3.5 and 5, so that halving the zone takes off a factor of 1.7
to 1.8; as :math:`\ell` itself if the zone vanishes.  Two zones, the second twice as long, give the limit.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Iterator, Sequence
from typing import Annotated, ClassVar, NamedTuple

import numpy as np

from winkler.laws.adhesion import ShortRange
from winkler.laws.attraction import ExponentialAttraction
from winkler.loading.loads import Depth
from winkler.loading.path import numbers_of
from winkler.media.mapped import MappedMedium, layers_of
from winkler.numerics.attracted.attracted_surface import AttractedSurface
from winkler.numerics.attracted.attraction import RoundedStep
from winkler.numerics.attracted.elastic_surface import ElasticSurface, attracted_bytes
from winkler.numerics.pixels.contact_area import contact_area
from winkler.numerics.types import Array
from winkler.problems.answer import gather
from winkler.problems.assumptions.declared import ATTRACTED, BALANCED
from winkler.problems.last_cycle import Looped, PathLoop
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.rough.map_memory import refuse_too_large, state_memory
from winkler.problems.rough.mapped_medium import medium_notes
from winkler.problems.rough.surface_notes import surface_notes
from winkler.problems.surface_adhesion.law_on_grid import AttractionOnGrid, RangedLaw, attraction_on_grid, tabor_of_map
from winkler.problems.surface_adhesion.march import AdhesionMarch, Leapt
from winkler.problems.surface_adhesion.states import MapAdhesion, SurfaceAdhesionState, SurfaceJump
from winkler.profiles.rough.topography import Topography
from winkler.values.checks.number_checks import Advice, affordable, between
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.limits import MOST_NUMBERS
from winkler.values.validity import Assumption, Note, Standing, standing_left
from winkler.values.value import value, words

FAINT = 0.01
"""Part of the strength below which pixels count as not attracted."""
TOUCHING = 1e-6
"""Gap over the wall, in ranges, up to which pixels touch."""


@value
class SurfaceAdhesion:
    """A height map attracted by an elastic half-space under prescribed displacements, without friction.

    Parameters
    ----------
    topography : Topography
        Sum of the heights of both bodies, positive towards the other one; a periodic map repeats without end.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
        Both bodies.  If the surface of a body has another modulus than the material below, the cohesive zone follows
        from the surface modulus.
    law : ShortRange, Dugdale, ExponentialAttraction or LennardJones
        Law of attraction. ShortRange (JKR) is replaced by an exponential law with the shortest range that the pixels
        resolve. The stress of Dugdale's law decreases gradually over 0.8 of its range, not in a step.
    path : Depth
        Displacements d [m] in sequence. Zero is the first touch of the highest point without deformation (for
        `LennardJones` at the equilibrium spacing); negative values are separations. The bodies approach the first
        displacement from a large separation.
    tolerance : float, optional
        Maximum residual traction over the maximum traction for which a state counts as solved.

    Raises
    ------
    InvalidInput
        If heights are missing, the path is not a sequence, the work of opening exceeds that of closing, or the map is
        too large.
    OutsideValidity
        If the zone of attraction, E* w / strength^2, spans fewer pixels than the law needs, or a periodic map closes.

    References
    ----------
    V. Rey, G. Anciaux, J.-F. Molinari, Comput. Mech. 60 (2017) 69-81, doi:10.1007/s00466-017-1392-5;
    T. Steihaug, SIAM J. Numer. Anal. 20 (1983) 626-637, doi:10.1137/0720042

    Examples
    --------
    A ball of 1 m radius, E* = 1 Pa and w = 10 uJ/m^2, is torn off by nearly 3/2 pi R w = 47 uN.

    >>> import numpy as np
    >>> from winkler.laws.adhesion import ShortRange
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> x = np.linspace(-0.08, 0.08, 65)[:-1] + 0.00125
    >>> ball = Topography(-0.5 * (x[:, None] ** 2 + x**2), [0.16, 0.16])
    >>> path = Depth(np.linspace(0.0, -0.0012, 13))
    >>> sticky = SurfaceAdhesion(ball, HalfSpace(Elastic(1.0, 0.0)), ShortRange(1e-5), path).solve()
    >>> round(1e6 * sticky.pull_off_force)
    -49
    """

    topography: Topography
    medium: Annotated[MappedMedium, Advice("the boundary elements apply to no other")]
    law: RangedLaw
    path: Depth
    tolerance: Annotated[float, between(1e-10, 0.01)] = 1e-6

    references: ClassVar[tuple[str, ...]] = ("rey_2017", "steihaug_1983", "tabor_1977", "stanley_kato_1997")
    assumptions: ClassVar[frozenset[Assumption]] = ATTRACTED | BALANCED

    def __post_init__(self) -> None:
        check_adhesion(self.topography, self.path)
        self.on_grid()

    def on_grid(self) -> AttractionOnGrid:
        """Return the law that is used on this grid.

        Raises
        ------
        OutsideValidity
            If the grid does not resolve it.
        """
        return attraction_on_grid(self.law, self.medium.modulus, self.topography.pixel)

    @property
    def tabor(self) -> float:
        """Tabor's parameter [-] for a ball with the rms curvature of the map, with the law used on the grid."""
        return tabor_of_map(self.topography, self.medium.modulus, self.on_grid())

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for every displacement."""
        return int(numbers_of(self.path).size)

    def steps(self) -> Iterator[SurfaceAdhesionState]:
        """Yield the contact at every displacement.

        Raises
        ------
        InvalidInput
            If the map needs more memory than is free.
        NotConverged
            If no equilibrium is found to the tolerance.
        """
        rough, modulus, on_grid = self.topography, self.medium.modulus, self.on_grid()
        state_memory(rough.heights.shape, rough.periodic, "SurfaceAdhesion", memory_of(rough))
        (dx, dy), law, unit = rough.pixel, on_grid.law, on_grid.range
        shape = rough.heights.shape
        layers = layers_of(self.medium)
        below = layers.in_units_of(dx) if layers else None
        try:
            surface = ElasticSurface.of((shape[0], shape[1]), dy / dx, periodic=rough.periodic, layers=below)
        except (NotConverged, OutsideValidity) as error:
            raise type(error)(f"SurfaceAdhesion: {error}".rstrip(".") + ".") from None
        share = on_grid.work * dx / (modulus * unit * unit)
        attracted = AttractedSurface(surface, rough.gaps / unit + law.touch, law, share)
        force, energy = modulus * unit * dy, modulus * unit * unit * dy
        march: AdhesionMarch | None = None

        def touched(gap: Array) -> tuple[float, float]:
            return contact_area(gap <= law.touch + TOUCHING, rough.pixel, rough.periodic)

        def jump(leapt: Leapt) -> SurfaceJump:
            old, new = leapt.before, leapt.after
            return SurfaceJump(
                unit * new.depth, force * old.force, force * new.force, touched(old.rest.gap)[0],
                touched(new.rest.gap)[0], energy * leapt.loss,
                float(np.sum(law.terms(new.rest.gap)[0])) < float(np.sum(law.terms(old.rest.gap)[0])),
            )  # fmt: skip

        for index, depth in enumerate(numbers_of(self.path).tolist()):
            leaps: tuple[Leapt, ...] = ()
            try:
                if march is None:
                    march = AdhesionMarch(attracted, self.tolerance, depth / unit)
                else:
                    leaps = march.go(depth / unit)
            except NotConverged as error:
                raise NotConverged(f"SurfaceAdhesion: at index {index} of the path ({depth:.6g} m) {error}") from None
            stage = march.stage
            gap, rest = stage.rest.gap, stage.rest
            pulled = (law.terms(gap)[1] > FAINT * law.peak) & (gap > law.touch + TOUCHING)
            yield SurfaceAdhesionState(
                depth, force * stage.force, *touched(gap), float(np.count_nonzero(pulled)) * dx * dy,
                energy * rest.energy, energy * march.work, energy * march.lost, unit * float(np.mean(gap)),
                rest.residual, abs(march.lacking) / march.most if march.most else 0.0,
                modulus * unit / dx * rest.traction, unit * gap, tuple(jump(leapt) for leapt in leaps),
            )  # fmt: skip

    def pull_off_without_range(self) -> PullOffWithoutRange:
        """Return the pull-off force in the limit of zero range (JKR), extrapolated from two short ranges.

        Raises
        ------
        InvalidInput
            If the law is another one, or the lowest force is at an end of the path.
        NotConverged
            As `steps`.
        OutsideValidity
            If Tabor's parameter for the shorter range is below two for a ball with the curvature of the map.
        """
        rough = self.topography
        laws = two_ranges(self.law, self.medium.modulus, rough.pixel)
        refuse_long_ranges(dataclasses.replace(self, law=laws[0]).tabor)
        found = [dataclasses.replace(self, law=law).solve() for law in laws]
        cut = 0.0 if rough.periodic else cut_off(found[1].tightest.pressure, rough.pixel)
        return limit_of_two(laws, [greatest_pull(each.depth, each.force) for each in found], cut)

    def gathered(self, states: Iterable[SurfaceAdhesionState]) -> SurfaceAdhesionSolution:
        """Return the solution made of these states, of the whole path or of its first part."""
        reached = tuple(states)
        tightest = min(reached, key=lambda state: state.force)
        jumps = tuple(jump for state in reached for jump in state.jumps)
        return gather(SurfaceAdhesionSolution, self, reached, jumps=jumps, tightest=tightest)

    def solve(self) -> SurfaceAdhesionSolution:
        """Return the whole path.

        Raises
        ------
        NotConverged
            As `steps`.
        """
        return self.gathered(self.steps())


@value
class SurfaceAdhesionSolution(MapAdhesion[Array], Looped):
    """The solution of a `SurfaceAdhesion`, displacement by displacement; its numbers are those of `MapAdhesion`.

    Parameters
    ----------
    problem : SurfaceAdhesion
        The problem that was solved.
    last : SurfaceAdhesionState
        The contact at the last displacement, with its maps of pressure and separation.
    tightest : SurfaceAdhesionState
        The contact at the displacement with the lowest force.
    jumps : tuple of SurfaceJump
        All jumps in the order of the path.
    """

    __words__ = words(
        tightest=("", None, "the contact that pulls most"),
        pull_off_force=("F_c", "N", "lowest force of the path, tension negative"),
        pull_off_depth=("d_c", "m", "displacement at the lowest force"),
        pull_off_area=("A_c", "m^2", "area of what touches at the lowest force"),
    )

    problem: SurfaceAdhesion
    last: SurfaceAdhesionState
    tightest: SurfaceAdhesionState
    jumps: tuple[SurfaceJump, ...]

    @property
    def _loop(self) -> PathLoop:
        return PathLoop((numbers_of(self.problem.path),), self.depth, self.force, self.dissipation)

    @property
    def pull_off_force(self) -> float:
        """The lowest force [N]: the bodies separate under a dead load below this force."""
        return float(np.min(self.force))

    @property
    def pull_off_depth(self) -> float:
        """The displacement at the lowest force [m]."""
        return float(self.depth[int(np.argmin(self.force))])

    @property
    def pull_off_area(self) -> float:
        """Contact area at the lowest force [m^2]."""
        return float(self.area[int(np.argmin(self.force))])

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: law, grid, balance of tractions and energies, border, slopes."""
        stated = self.problem
        return (
            *surface_adhesion_notes(
                stated.topography, stated.medium, stated.law, stated.on_grid(), stated.tabor,
                float(np.max(self.residual)), float(self.energy_misfit[-1]), len(self.jumps),
            ),
            *unknown_yield(stated.medium, "the stresses below attracted surfaces are not searched"),
            *self._cycle_notes,
        )  # fmt: skip


def memory_of(rough: Topography) -> int:
    """Return the memory [byte] that a map takes at most."""
    return attracted_bytes(rough.heights.shape, rough.periodic)


def check_adhesion(rough: Topography, path: Depth) -> None:
    """Raise if a map cannot be brought through these displacements.

    Raises
    ------
    InvalidInput
        If heights are missing, the path is no row, or the map is too large.
    OutsideValidity
        If a periodic map closes.
    """
    around = 1 if rough.periodic else 4
    affordable("SurfaceAdhesion", "pixels with their surroundings", around * rough.heights.size, MOST_NUMBERS)
    refuse_too_large(rough.heights.shape, rough.periodic, "SurfaceAdhesion", memory_of(rough))
    if rough.missing:
        raise InvalidInput(
            f"SurfaceAdhesion: {rough.missing} of {rough.heights.size} heights are missing; fill them with "
            "topography.filled(), or cut a complete part out with topography.cropped(...)."
        )
    given = numbers_of(path)
    if given.ndim != 1 or not given.size:
        raise InvalidInput(
            f"SurfaceAdhesion: the path has the shape {given.shape}; give its displacements one after the other in "
            "one row."
        )
    whole = float(np.mean(rough.gaps))
    if rough.periodic and np.any(given >= whole):
        raise OutsideValidity(
            f"SurfaceAdhesion: the displacement {np.max(given):.6g} m closes the periodic map, whose mean planes "
            f"can approach by less than {whole:.6g} m; stay below it."
        )


REY = "V. Rey, G. Anciaux, J.-F. Molinari, Comput. Mech. 60 (2017) 69-81, doi:10.1007/s00466-017-1392-5"
TABOR = "D. Tabor, J. Colloid Interface Sci. 58 (1977) 2-13, doi:10.1016/0021-9797(77)90366-6"
BALANCE = "work of the machine, change of the energy and losses in jumps, added up"


def surface_adhesion_notes(
    rough: Topography,
    medium: MappedMedium,
    law: RangedLaw,
    on_grid: AttractionOnGrid,
    tabor: float,
    residual: float,
    energy_misfit: float,
    count: int,
) -> tuple[Note, ...]:
    """Return what was assumed of an attracted map, and what the solver left.

    Parameters
    ----------
    rough : Topography
        The map.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
        Both bodies.
    law : RangedLaw
        As it was stated.
    on_grid : AttractionOnGrid
        As it was solved.
    tabor : float
        Tabor's parameter of a ball as curved as the map.
    residual, energy_misfit : float
        Greatest ones of all displacements.
    count : int
        Of jumps.
    """
    mapped = surface_notes(rough, math.inf, 0.0, 0.0, 0.0)
    number = "is flat" if math.isinf(tabor) else f"has a Tabor number of {tabor:.3g}"
    if isinstance(law, ShortRange):
        stated = (
            "The short-range attraction is replaced by an exponentially decaying one with a range of "
            f"{on_grid.range:.3g} m, the shortest that the grid resolves. The map {number}. Below 5 forces differ "
            "from those of short range by some per cent; pull_off_without_range() extrapolates the pull-off "
            "force."
        )
    elif isinstance(on_grid.law, RoundedStep):
        stated = (
            f"The constant stress decreases to zero over {2.0 * on_grid.law.half_width:.3g} of its range instead "
            f"of at once, so that the edge is not pinned by the grid. The map {number}."
        )
    else:
        stated = f"Gaps are treated as locally parallel (Derjaguin). The map {number}."
    return (
        *(note for note in medium_notes(medium, rough, math.inf, 0.0, 0.0, 0.0) if note not in mapped[2:]),
        Note(
            Assumption.RESOLUTION,
            standing_left(residual, Standing.ASYMPTOTIC),
            f"The cohesive zone at an edge spans {on_grid.span:.3g} pixels. The pull-off force of a ball then has "
            "an error of about one per cent; the edge moves in small jumps from pixel to pixel. Tractions are in "
            f"equilibrium within {residual:.1g} of their maximum.",
            REY,
        ),
        Note(Assumption.ADHESION, Standing.APPROXIMATE, stated, TABOR),
        Note(
            Assumption.EQUILIBRIUM,
            Standing.APPROXIMATE if energy_misfit > 0.01 else Standing.ASYMPTOTIC,
            f"The surfaces move slowly except in {count} jumps. In a jump all energy released is dissipated; the "
            f"energy balance has an error of {energy_misfit:.1g} of the maximum energy. Jumps of single pixels "
            "are included.",
            BALANCE,
        ),
        *mapped[3:],
    )


SPANS = (3.0, 6.0)
"""Pixels in the zones: with three to six the grid changes the pull-off force of a ball by less than 0.1 per cent."""
LEAST_TABOR = 2.0
"""Of the shorter range on a ball as curved as the map: below it forces of both ranges come near to each other again, as
those without deformation do, and tell nothing of the limit."""
POWER = 0.8
"""Of the length of the zone, to which the force differs from that without range."""


class PullOffWithoutRange(NamedTuple):
    """The pull-off force without range.

    Parameters
    ----------
    force
        Lowest force [N], tension negative.
    error
        By how much the forces under both laws differ, and what the border of a map that stands alone cuts off [N]: of
        balls the limit is nearer than this.
    ranges
        Of both exponential laws [m].
    forces
        Lowest forces under them [N].
    """

    force: float
    error: float
    ranges: tuple[float, float]
    forces: tuple[float, float]


def two_ranges(law: object, modulus: float, pixel: tuple[float, float]) -> tuple[ExponentialAttraction, ...]:
    """Return exponential laws of two ranges in place of one without range.

    Raises
    ------
    InvalidInput
        If the law has a range of its own.
    """
    if not isinstance(law, ShortRange):
        raise InvalidInput(
            f"SurfaceAdhesion: {type(law).__name__} has a range, to which its pull-off force belongs; the limit "
            "without range is that of ShortRange(work)."
        )
    reach = [math.sqrt(span * max(pixel) * law.work / modulus) for span in SPANS]
    return tuple(ExponentialAttraction(law.work, each) for each in reach)


def refuse_long_ranges(tabor: float) -> None:
    """Refuse ranges that are too long for the limit.

    Parameters
    ----------
    tabor : float
        Tabor's parameter of a ball as curved as the map under the shorter range [-].

    Raises
    ------
    OutsideValidity
        If it is below two.
    """
    if tabor < LEAST_TABOR:
        raise OutsideValidity(
            f"SurfaceAdhesion: the shortest range that these pixels resolve has a Tabor number of {tabor:.3g} on a "
            f"ball as curved as the map. The pull-off force without range follows from {LEAST_TABOR:g} on: use "
            f"pixels of at most {(tabor / LEAST_TABOR) ** 2:.2g} times this size."
        )


def greatest_pull(depth: Array, force: Array) -> float:
    """Return the lowest force of a path, on the parabola through the lowest of its forces and those on both sides.

    Raises
    ------
    InvalidInput
        If the lowest force is at an end of the path.
    """
    k = int(np.argmin(force))
    if not 0 < k < force.size - 1:
        raise InvalidInput(
            f"SurfaceAdhesion: the lowest force is at the {'end' if k else 'beginning'} of the path, at the "
            f"displacement {depth[k]:.6g} m; give displacements on both sides of the pull-off."
        )
    x, y = depth[k - 1 : k + 2] - depth[k], force[k - 1 : k + 2] - force[k]
    if not x[0] * x[2] < 0.0:  # the path turns here
        return float(force[k])
    slopes = y[0] / x[0], y[2] / x[2]
    curvature = (slopes[1] - slopes[0]) / (x[2] - x[0])
    slope = slopes[0] - curvature * x[0]
    return float(force[k] - 0.25 * slope * slope / curvature) if curvature > 0.0 else float(force[k])


def cut_off(pressure: Array, pixel: tuple[float, float]) -> float:
    """Return about what a map that stands alone lacks beyond its border [N]: the pull there over the longer zone.

    Parameters
    ----------
    pressure : ndarray, (nx, ny)
        p [Pa] of the strongest pull, tension negative.
    pixel : tuple of float
        (dx, dy) [m].
    """
    edges = float(np.sum(pressure[[0, -1]])) + float(np.sum(pressure[:, [0, -1]]))
    return SPANS[1] * abs(min(edges, 0.0)) * pixel[0] * pixel[1]


def limit_of_two(
    laws: Sequence[ExponentialAttraction], forces: Sequence[float], cut: float = 0.0
) -> PullOffWithoutRange:
    """Return the limit of the forces under both laws, and its error with what the border cuts off."""
    short, long = forces
    change, ratio = short - long, SPANS[1] / SPANS[0]
    limit = short + change / (ratio**POWER - 1.0)
    return PullOffWithoutRange(limit, abs(change) + cut, (laws[0].range, laws[1].range), (short, long))
