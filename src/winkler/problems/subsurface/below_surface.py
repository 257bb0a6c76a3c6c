"""Stresses below a map of loads: at places, on planes and at a depth, and the greatest of them."""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.foundation.sheared_fields import BodyFields
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.interior.map_peak import greatest_below
from winkler.media.interior.peak import StressSpot
from winkler.media.offers import LayerStack, offers
from winkler.numerics.caching import cached_by_value
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.normal.elliptic_fields import solid_below
from winkler.problems.normal.strong_parts import StrongPart, solid_parts
from winkler.problems.subsurface.surface_load import SurfaceLoad
from winkler.problems.which_body import in_first_body
from winkler.values.checks.place_checks import common_places, finite_places
from winkler.values.errors import InvalidInput, OutsideValidity

__all__ = ["BelowSurface", "fields_at", "fields_at_depth", "fields_on_plane", "greatest_in_parts", "greatest_stress"]


def fields_at(load: SurfaceLoad, solid: Elastic, places: tuple[Array, Array, Array]) -> BodyFields:
    """Return stresses and displacements at places x, y, z >= 0 [m] of one shape."""
    rows = np.stack([np.ravel(part) for part in places], axis=1) - np.append(load.corner, 0.0)
    found = load.field(solid.poisson).at_places(rows)
    return _scaled(places, found.reshape(-1, *places[0].shape), solid)


def fields_at_depth(load: SurfaceLoad, solid: Elastic, z: float) -> BodyFields:
    """Return stresses and displacements below the middles of all pixels at a depth z >= 0 [m]."""
    x, y = np.meshgrid(*load.places, indexing="ij")
    return _scaled((x, y, np.full(x.shape, z)), load.field(solid.poisson).at_depth(z), solid)


def fields_on_plane(load: SurfaceLoad, solid: Elastic, depths: Array, *, x: float, y: float) -> BodyFields:
    """Return stresses and displacements on the plane at x or at y [m], the other of them not a number."""
    field, across = load.field(solid.poisson), load.places[0]
    if math.isnan(y):
        found = fields_on_plane(load.turned(), solid, depths, x=math.nan, y=x)
        return BodyFields(
            found.y, found.x, found.z, found.yy_stress, found.xx_stress, found.zz_stress, found.xy_stress,
            found.yz_stress, found.xz_stress, found.y_displacement, found.x_displacement, found.z_displacement,
        )  # fmt: skip
    lines = np.stack([field.across(y - load.corner[1], float(z)) for z in depths], axis=-1)
    along, deep = np.meshgrid(across, depths, indexing="ij")
    return _scaled((along, np.full(along.shape, y), deep), lines, solid)


def _scaled(places: tuple[Array, Array, Array], found: Array, solid: Elastic) -> BodyFields:
    return BodyFields(*places, *found[:6], *(0.5 / solid.shear * found[6:]))


@functools.lru_cache(maxsize=16)
def greatest_stress(load: SurfaceLoad, solid: Elastic) -> StressSpot:
    """Return the greatest von Mises stress [Pa] in a half-space and its place [m], z >= 0."""
    found = greatest_below(load.field(solid.poisson), climbed=not load.periodic)
    return _placed(found.greatest[0], load)


@cached_by_value(maxsize=8)  # what is said of yielding and the summary ask for the same
def greatest_in_parts(load: SurfaceLoad, medium: object, parts: tuple[StrongPart, ...]) -> tuple[StressSpot, ...]:
    """Return the greatest von Mises stress [Pa] in each part of the bodies and its place [m], z into its body.

    Parameters
    ----------
    load : SurfaceLoad
        What acts on the first body.
    medium
        Homogeneous bodies, layers, or a grading, whose parts these are.
    parts : tuple of StrongPart
    """
    if not offers(medium, LayerStack):
        return tuple(greatest_stress(load if part.first else load.reversed(), part.solid) for part in parts)
    from winkler.media.layered.map_interior import MapInLayers  # loaded with layers

    inside = MapInLayers(medium, load.loads, load.pixel, periodic=load.periodic)
    return tuple(
        _placed(greatest_below(inside, top=part.top, bottom=part.bottom).greatest[0], load)
        if part.first
        else greatest_stress(load.reversed(), part.solid)
        for part in parts
    )


def _placed(spot: StressSpot, load: SurfaceLoad) -> StressSpot:
    return spot._replace(x=spot.x + float(load.corner[0]), y=spot.y + float(load.corner[1]))


class BelowSurface:
    """What a solution offers whose pressures and tractions on the surface are known pixel by pixel."""

    @property
    def surface_load(self) -> SurfaceLoad:
        """What acts on the first body."""
        raise NotImplementedError

    @property
    def _medium(self) -> object:
        raise NotImplementedError

    def _on_body(self, below: bool) -> tuple[SurfaceLoad, Elastic]:
        load, medium = self.surface_load, self._medium
        if not isinstance(medium, HomogeneousMedium):
            raise OutsideValidity(
                f"{type(self).__name__}: the stress below the surface of a height map on a {type(medium).__name__} is "
                "not known at each place, greatest_stress() of layers is; give a HalfSpace."
            )
        return (load if below else load.reversed()), solid_below(medium, below)

    def stresses(self, x: ArrayLike, y: ArrayLike, z: ArrayLike) -> BodyFields:
        """Return stresses and displacements inside one body.

        Parameters
        ----------
        x, y : array_like
            Places along the surface [m]; those of the pixels are `places` of the `surface_load`.
        z : array_like
            Depths [m]: not negative in the first body, negative in the second, of which -0.0 is the surface.
            All in one of them.

        Raises
        ------
        InvalidInput
            If a place is not finite, or the depths lie in both bodies.
        OutsideValidity
            If the body is rigid or not isotropic.

        References
        ----------
        A. E. H. Love, Phil. Trans. R. Soc. A 228 (1929) 377-420, doi:10.1098/rsta.1929.0009
        """
        along, across, depth = common_places(type(self).__name__, x=x, y=y, z=z)
        load, solid = self._on_body(in_first_body(depth, type(self).__name__))
        return fields_at(load, solid, (along, across, np.abs(depth)))

    def stresses_at_depth(self, z: float) -> BodyFields:
        """Return stresses and displacements below the middles of all pixels at one depth, as arrays (nx, ny).

        Parameters
        ----------
        z : float
            Depth [m]: not negative in the first body, negative in the second.

        Raises
        ------
        InvalidInput, OutsideValidity
            As of `stresses`.
        """
        depth = finite_places(type(self).__name__, "z", z)
        if depth.ndim:
            raise InvalidInput(f"{type(self).__name__}: z has the shape {depth.shape}; give one depth in m.")
        load, solid = self._on_body(in_first_body(depth, type(self).__name__))
        return fields_at_depth(load, solid, abs(float(depth)))

    def stresses_on_plane(self, depths: ArrayLike, *, x: float = math.nan, y: float = math.nan) -> BodyFields:
        """Return stresses and displacements on a plane across the surface, as arrays (pixels, depths).

        Parameters
        ----------
        depths : array_like, (m,)
            [m]: not negative in the first body, negative in the second; all in one of them.
        x, y : float
            Where the plane stands [m]: one of the two.  Along the other the places are the middles of the pixels.

        Raises
        ------
        InvalidInput, OutsideValidity
            As of `stresses`; also if not one of x and y is given.
        """
        name = type(self).__name__
        deep = np.atleast_1d(finite_places(name, "depths", depths))
        given = [each for each in (x, y) if not (isinstance(each, float) and math.isnan(each))]
        if len(given) != 1 or deep.ndim != 1 or deep.size == 0:
            raise InvalidInput(f"{name}: a plane stands at one x or at one y [m] and has a row of depths; give these.")
        at = float(finite_places(name, "the plane", given[0]))
        load, solid = self._on_body(in_first_body(deep, name))
        at_x = isinstance(y, float) and math.isnan(y)
        return fields_on_plane(load, solid, np.abs(deep), x=at if at_x else math.nan, y=math.nan if at_x else at)

    def greatest_stress(self, *, below: bool = True) -> StressSpot:
        """Return the greatest von Mises stress [Pa] and its place x, y, z [m], z into the body.

        Parameters
        ----------
        below : bool
            Whether to search in the first body; otherwise the second is searched.

        Raises
        ------
        OutsideValidity
            If the body is rigid, graded or not isotropic.

        Notes
        -----
        In layers it is the greatest of all isotropic ones, in the middles of pixels.  The surface is examined in the
        middles of the pixels, and depths from half a pixel on: a greatest stress on the surface, at the edge of a
        contact that slides, changes with the pixels.
        """
        medium = self._medium
        parts = tuple(part for part in solid_parts(medium) if part.first == below)
        if not (parts and offers(medium, LayerStack)):
            return greatest_stress(*self._on_body(below))
        return max(greatest_in_parts(self.surface_load, medium, parts), key=lambda spot: spot.value)
