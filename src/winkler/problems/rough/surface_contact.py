r"""A height map pressed into an elastic body: the boundary-element method, the reference for approximate methods.

Pressures p >= 0 and gaps w >= 0 with p w = 0 in every pixel, and

.. math:: w(x,y) = h(x,y) - d + \frac{1}{\pi E^*}\int\frac{p(x',y')}{\sqrt{(x-x')^2+(y-y')^2}}\,\mathrm dA' ,

are found by preconditioned conjugate gradients (`winkler.numerics.surfaces.pressed_grid`); layers add a kernel
(`winkler.numerics.pixels.layered`).  The stiffness dF/dd is that of a flat punch of the shape of the contact.

Where the hardness limits the pressure of a height map: how many pixels, and the area F / H that follows.

If nearly all pixels in contact bear the hardness H, the area is :math:`A = F/H`, whatever the surface and the moduli
(Bowden and Tabor).  What flows needs a place to go: measured areas follow :math:`A/A_0 = W/(1+W)` with
:math:`W = F/(HA_0)` (Pullen and Williamson), so that cut pressures give 1 + W times too much.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Iterator
from types import ModuleType
from typing import Annotated, Any, ClassVar

import numpy as np

from winkler.loading.loads import Depth, Force
from winkler.loading.path import numbers_of
from winkler.media.mapped import MappedMedium, layers_of
from winkler.numerics.arrays import given, library_of, to_numpy
from winkler.numerics.pixels.contact_area import contact_area
from winkler.numerics.surfaces.pressed_box import ByDepth, ByLoad
from winkler.numerics.surfaces.pressed_grid import press
from winkler.numerics.surfaces.punched_grid import punch
from winkler.numerics.types import Array, PerLoad, Q, Quantity, shaped
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.normal.map_yield import greatest_share, map_yield_notes
from winkler.problems.normal.solve_contact import indices_of
from winkler.problems.normal.unknown_yield import unknown_yield
from winkler.problems.pressed_shape.force_at_yield import force_at_yield
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.problems.rough.map_memory import refuse_too_large, state_memory
from winkler.problems.rough.mapped_medium import medium_notes
from winkler.problems.rough.surface_notes import border_notes
from winkler.problems.rough.surface_states import SurfaceState
from winkler.problems.subsurface.below_surface import BelowSurface
from winkler.profiles.rough.topography import Topography
from winkler.values.checks.number_checks import Advice, PositiveOrInfinite, affordable, between
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.values.limits import MOST_NUMBERS
from winkler.values.validity import Assumption, Note, Standing, standing_of
from winkler.values.value import value

PULLEN = "J. Pullen, J. B. P. Williamson, Proc. R. Soc. A 327 (1972) 159-173"
TABOR = "F. P. Bowden, D. Tabor, Proc. R. Soc. A 169 (1939) 391-413"
AT_HARDNESS = 1.0 - 1e-9
"""Part of the hardness from which a pixel bears it."""
NEARLY_ALL, HARDLY_ANY = 0.9, 0.1
FLAT_SHARE = 0.9
"""Of the root mean square height that is left without a paraboloid: less, and the map is a curved body."""
LIGHT_LOAD, HEAVY_LOAD = 0.01, 0.3
"""Force over hardness times the area of the map."""


def hardened_share(pressure: Array, hardness: float) -> float:
    """Return which part of the pixels in contact bears the hardness."""
    touching = int(np.count_nonzero(pressure > 0.0))
    return float(np.count_nonzero(pressure >= AT_HARDNESS * hardness)) / touching if touching else 0.0


def hardness_notes(
    rough: Topography, hardness: float, force: Quantity, area: Quantity, hardened: Quantity
) -> tuple[Note, ...]:
    """Return what the hardness means for the contact; nothing of elastic bodies.

    Parameters
    ----------
    rough
        The map; of one that is curved nothing is said about where the metal goes, which is beside it.
    hardness
        [Pa].
    force, area, hardened
        Of every load [N], [m^2], [-].
    """
    if math.isinf(hardness):
        return ()
    last = int(np.argmax(np.ravel(np.asarray(force))))
    share = float(np.ravel(np.asarray(hardened))[last])
    greatest = float(np.ravel(np.asarray(force))[last])
    mean = greatest / float(np.ravel(np.asarray(area))[last]) / hardness
    if share >= NEARLY_ALL:
        regime = "the plastic limit A = F / H, in which the moduli have little influence"
    elif share <= HARDLY_ANY:
        regime = "elastic for the most part"
    else:
        regime = "between the elastic contact and the plastic limit A = F / H"
    limit = Note(
        Assumption.ELASTIC,
        Standing.APPROXIMATE,
        f"Under the maximum force {share:.0%} of the pixels in contact carry the hardness, and the mean pressure "
        f"is {mean:.0%} of it: {regime}.",
        TABOR,
    )
    if not rough.periodic and rough.detrended(2).rms_height < FLAT_SHARE * rough.rms_height:
        return (limit,)
    heavy = greatest / (hardness * rough.area)
    return (
        limit,
        Note(
            Assumption.ELASTIC,
            standing_of(heavy, LIGHT_LOAD, HEAVY_LOAD),
            f"The force is {heavy:.2g} of hardness times the area of the map. Displaced metal reduces measured "
            f"areas below those of pressures limited to the hardness: by about {heavy:.2g} for plastic contacts.",
            PULLEN,
        ),
    )


NEARBY_LOAD = 0.25
"""A load that differs by more than this part of it from the one before is begun on coarse grids: as fast."""
PUNCH_TOLERANCE = 3e-3
"""Error of the depth under the flat punch that gives the stiffness: its own error is of the square, below 1e-6."""


@value
class SurfaceContact(PerLoad[Q]):
    """A height map pressed into an elastic half-space, layered or not, without friction or adhesion.

    Parameters
    ----------
    topography : Topography
        Sum of the heights of both bodies, positive towards the other body; the medium is flat.  A non-periodic map
        ends at its border like a punch; a periodic one repeats without end.
    medium : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
        Both bodies.
    load : Force or Depth
        The prescribed quantity, compression positive. The loads of an array are computed one after the other, each
        from the solution before.  For a periodic map it is the force on one period.
    hardness : float, optional
        Upper limit of the pressure [Pa]; infinite (the default) for elastic bodies.
    tolerance : float, optional
        Maximum overlap over the depth, and pressure times gap over F d, at which a contact counts as solved.

    Raises
    ------
    InvalidInput
        If heights are missing or flat, the medium has the wrong type, or a load is not positive. If hardness or
        tolerance is out of range, or the map needs more memory than is free.

    References
    ----------
    I. A. Polonsky, L. M. Keer, Wear 231 (1999) 206-219, doi:10.1016/S0043-1648(99)00113-1; J. R. Barber, Proc. R. Soc.
    A 459 (2003) 53-66, doi:10.1098/rspa.2002.1038

    Examples
    --------
    A ball of 1 m radius, E* = 1 Pa, pressed to the depth of 1/8 m: F = 4/3 R^(1/2) d^(3/2) = 0.058926 N.

    >>> import numpy as np
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> x = np.linspace(-0.5, 0.5, 129)[:-1] + 1.0 / 256.0
    >>> ball = Topography(-0.5 * (x[:, None] ** 2 + x**2), [1.0, 1.0])
    >>> contact = SurfaceContact(ball, HalfSpace(Elastic(1.0, 0.0)), Depth(0.125)).solve()
    >>> round(contact.force, 3), round(contact.stiffness / 2.0, 2)
    (0.059, 0.35)
    """

    topography: Topography
    medium: Annotated[MappedMedium, Advice("the boundary elements apply to no other")]
    load: Force[Q] | Depth[Q]
    hardness: PositiveOrInfinite = math.inf
    tolerance: Annotated[float, between(1e-12, 0.1)] = 1e-6

    references: ClassVar[tuple[str, ...]] = (
        "polonsky_keer_1999", "stanley_kato_1997", "barber_2003", "yastrebov_2017", "almqvist_2007",
    )  # fmt: skip
    assumptions: ClassVar[frozenset[Assumption]] = MAPPED

    def __post_init__(self) -> None:
        around = (1 if self.topography.periodic else 4) * self.topography.heights.size  # padded to twice its lengths
        affordable("SurfaceContact", "pixels with their surroundings", around, MOST_NUMBERS)
        if missing := self.topography.missing:
            raise InvalidInput(
                f"SurfaceContact: {missing} of {self.topography.heights.size} heights are missing; fill them with "
                "topography.filled(), or cut a complete part out with topography.cropped(...)."
            )
        if float(np.ptp(self.topography.heights)) == 0.0 and self.topography.periodic:
            raise InvalidInput("SurfaceContact: the periodic map is flat and touches everywhere; give a rough one.")
        layers_of(self.medium)  # refuses what has no surface of its own
        refuse_too_large(self.topography.heights.shape, self.topography.periodic)
        check_loads(self.topography, self.load, self.hardness, self._compressible)

    @property
    def _loads(self) -> Array:
        return numbers_of(self.load).ravel()

    @property
    def _compressible(self) -> bool:
        """Whether a uniform pressure of all the surface has a depth: in layers on a rigid base."""
        layers = layers_of(self.medium)
        return layers is not None and layers.mean > 0.0

    @property
    def total(self) -> int:
        """Number of states that `steps` yields: one for every load."""
        return int(self._loads.size)

    def steps(self, arrays: ModuleType = np) -> Iterator[SurfaceState]:
        """Yield the contact under every load.

        Parameters
        ----------
        arrays : module, optional
            Library of arrays that computes: numpy, or another one of the array API such as cupy, on a graphics card.
            The states hold arrays of numpy.

        Raises
        ------
        InvalidInput
            If the map needs more memory than is free, or `arrays` needs array-api-compat, which is not installed.
        NotConverged
            If a contact is not solved to the tolerance, or the contrasts of the layers are too large.
        OutsideValidity
            If the pixels are too coarse for the layers.
        """
        rough, modulus, layers = self.topography, self.medium.modulus, layers_of(self.medium)
        xp, pixel, patch = library_of(arrays), rough.pixel, rough.pixel[0] * rough.pixel[1]
        state_memory(rough.heights.shape, rough.periodic)
        gaps, before, stiffness = xp.asarray(rough.gaps), math.inf, math.inf
        start: Any = ()
        under: Any = ()
        for load in self._loads.tolist():
            drive = ByDepth(load) if isinstance(self.load, Depth) else ByLoad(load / (modulus * patch))
            near = abs(load / before - 1.0) <= NEARBY_LOAD
            if near and given(under) and math.isinf(self.hardness):  # nearly a flat punch of the shape of the contact
                more = load - before if isinstance(self.load, Depth) else (load - before) / stiffness
                start = xp.clip(start + more * under, 0.0, math.inf)
            try:
                solved = press(
                    gaps, pixel, drive, periodic=rough.periodic, ceiling=self.hardness / modulus,
                    tolerance=self.tolerance, start=start if near else (), layers=layers,
                )  # fmt: skip
                start, before = solved.pressure, load
                touching = start > 0.0
                if bool(xp.all(touching)) and rough.periodic and not self._compressible:
                    stiffness, under = math.inf, ()
                else:
                    under = punch(
                        touching, pixel, periodic=rough.periodic, tolerance=PUNCH_TOLERANCE, start=under, layers=layers
                    )
                    stiffness = modulus * patch * float(xp.sum(under))
            except NotConverged as error:
                raise NotConverged(f"SurfaceContact: under the load {load:.6g}, {error}") from None
            except OutsideValidity as error:
                raise OutsideValidity(f"SurfaceContact: {error}") from None
            force = modulus * patch * float(xp.sum(start))
            yield SurfaceState(
                solved.depth, force, stiffness, *contact_area(to_numpy(touching), pixel, rough.periodic,
                force / self.hardness), hardened_share(to_numpy(modulus * start), self.hardness),
                max(float(xp.mean(solved.gap)), 0.0), solved.penetration, solved.work, to_numpy(modulus * start),
                to_numpy(xp.clip(solved.gap, 0.0, math.inf)),
            )  # fmt: skip

    def gathered(self, states: Iterable[SurfaceState]) -> SurfaceContactSolution[Q]:
        """Return the solution made of these states, of the whole path or of its first part."""
        reached, shape = list(states), numbers_of(self.load).shape
        whole = len(reached) == math.prod(shape)

        def column(word: str) -> Q:
            numbers = np.array([getattr(state, word) for state in reached])
            return shaped(numbers, shape if whole else numbers.shape)

        columns = {field.name: column(field.name) for field in dataclasses.fields(SurfaceContactSolution)[1:-1]}
        return SurfaceContactSolution(problem=self, **columns, last=reached[-1])

    def solve(self, arrays: ModuleType = np) -> SurfaceContactSolution[Q]:
        """Return the solution of all loads.

        Parameters
        ----------
        arrays : module, optional
            As in `steps`.

        Raises
        ------
        NotConverged
            If a contact is not solved to the tolerance.
        """
        return self.gathered(self.steps(arrays))


@value
class SurfaceContactSolution(BelowSurface, PerLoad[Q]):
    """The solution of a `SurfaceContact`; quantities have the shape of the load, stresses are those of the last one.

    Parameters
    ----------
    problem : SurfaceContact
        The problem that was solved.
    depth, force, stiffness, area, area_error, hardened_share, mean_gap, penetration, misfit : float or ndarray
        As in `SurfaceState`.
    last : SurfaceState
        The contact under the last load, with its maps of pressure and separation.
    """

    __words__ = SurfaceState.__words__

    problem: SurfaceContact[Q]
    depth: Q
    force: Q
    stiffness: Q
    area: Q
    area_error: Q
    hardened_share: Q
    mean_gap: Q
    penetration: Q
    misfit: Q
    last: SurfaceState

    @property
    def mean_pressure(self) -> Q:
        """F / A [Pa] over the pixels that touch; the hardness where it limits nearly all of them."""
        return shaped(np.asarray(self.force) / np.asarray(self.area))

    @property
    def surface_load(self) -> SurfaceLoad:
        """The pressures under the last load."""
        rough = self.problem.topography
        return SurfaceLoad(self.last.pressure, rough.lengths, periodic=rough.periodic)

    @property
    def _medium(self) -> MappedMedium:
        return self.problem.medium

    def yield_force(self) -> float:
        """Return the force at the onset of yield [N]; infinite without a strength.

        Raises
        ------
        NotConverged
            If a contact or the force is not found.
        """
        given, medium = self.problem, self._medium

        def share(force: float) -> float:
            pressed = SurfaceContact(given.topography, given.medium, Force(force), tolerance=given.tolerance)
            return greatest_share(medium, pressed.solve().surface_load)

        last = greatest_share(medium, self.surface_load)
        return force_at_yield(share, self.last.force, last) if last > 0.0 else math.inf

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: border, residual, slopes, pixels."""
        stated = self.problem
        blurred = float(np.max(np.asarray(self.area_error) / self.area))
        notes = (
            *medium_notes(stated.medium, stated.topography, stated.hardness, blurred, self.penetration, self.misfit),
            *hardness_notes(stated.topography, stated.hardness, self.force, self.area, self.hardened_share),
        )
        if float(np.max(self.depth)) > self.last.depth:
            why = "pressures are stored of the last load, which is not the greatest"
            return (*notes, *unknown_yield(stated.medium, why))
        return (*notes, *last_load_notes(stated.medium, self.surface_load))


def last_load_notes(medium: MappedMedium, load: SurfaceLoad) -> tuple[Note, ...]:
    """Return what the border bears, and whether bodies stay elastic."""
    return (*border_notes(load.pressure, load.periodic), *map_yield_notes(medium, load))


def check_loads(rough: Topography, load: Force | Depth, hardness: float, compressible: bool) -> None:
    """Refuse loads that do not press, depths that close a periodic map, and forces that its hardness does not bear.

    Parameters
    ----------
    rough : Topography
    load : Force or Depth
        What is prescribed of a `SurfaceContact`.
    hardness : float
        Greatest pressure [Pa].
    compressible : bool
        Whether a uniform pressure of all the surface has a depth.

    Raises
    ------
    InvalidInput
        Of a load that is not positive.
    OutsideValidity
        Of one that is too great.
    """
    flat = numbers_of(load).ravel()
    bad = ~(flat > 0.0)
    if bad.any():
        name, unit = ("force", "N") if isinstance(load, Force) else ("depth", "m")
        raise InvalidInput(
            f"SurfaceContact: a {name} of {flat[bad][0]:.6g} {unit}{indices_of(bad)} does not press; without adhesion "
            "give positive loads."
        )
    most = float(np.max(flat))
    whole = float(np.mean(rough.gaps))
    if rough.periodic and not compressible and isinstance(load, Depth) and most >= whole:
        raise OutsideValidity(
            f"SurfaceContact: the depth {most:.6g} m closes the periodic map, whose mean planes can "
            f"approach by less than {whole:.6g} m; prescribe a Force."
        )
    if isinstance(load, Force) and most >= hardness * rough.area:
        raise OutsideValidity(
            f"SurfaceContact: the force {most:.6g} N is more than hardness times the area of the map, "
            f"{hardness * rough.area:.6g} N; press less."
        )
