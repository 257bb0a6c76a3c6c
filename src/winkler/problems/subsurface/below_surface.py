"""Stresses below a map of loads: at places, on planes and at a depth, and the greatest of them."""

from __future__ import annotations

import math

import numpy as np

from winkler.foundation.sheared_fields import BodyFields
from winkler.materials.elastic import Elastic
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.interior.peak import StressSpot
from winkler.media.interior.rectangle import STRESSES
from winkler.media.offers import LayerStack, offers
from winkler.numerics.types import Array, ArrayLike
from winkler.problems.normal.elliptic_fields import solid_below
from winkler.problems.normal.map_yield import Body, field_below, greatest_in_parts, greatest_stress
from winkler.problems.normal.strong_parts import solid_parts
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.problems.which_body import in_first_body
from winkler.values.checks.place_checks import common_places, finite_places
from winkler.values.errors import InvalidInput, OutsideValidity

BESIDE = 1e-9
"""Rounding of places at the border of a map, over its sides."""


def fields_at(load: SurfaceLoad, body: Body, places: tuple[Array, Array, Array]) -> BodyFields:
    """Return stresses and displacements at places x, y, z >= 0 [m] of one shape."""
    rows = np.stack([np.ravel(part) for part in places], axis=1) - np.append(load.corner, 0.0)
    field, unit = field_below(load, body)
    if not (isinstance(body, Elastic) or load.periodic):
        sides = np.array(load.lengths)
        if np.any((rows[:, :2] < -BESIDE * sides) | (rows[:, :2] > (1.0 + BESIDE) * sides)):
            raise OutsideValidity(
                "A place lies beside the map of pressures, outside of which stresses in layers are not summed; "
                "request places below the map, or give a larger map."
            )
    return _scaled(places, field.at_places(rows).reshape(-1, *places[0].shape), unit)


def fields_at_depth(load: SurfaceLoad, body: Body, z: float) -> BodyFields:
    """Return stresses and displacements below the middles of all pixels at a depth z >= 0 [m]."""
    x, y = np.meshgrid(*load.places, indexing="ij")
    field, unit = field_below(load, body)
    return _scaled((x, y, np.full(x.shape, z)), field.at_depth(z), unit)


def fields_on_plane(load: SurfaceLoad, body: Body, depths: Array, *, x: float, y: float) -> BodyFields:
    """Return stresses and displacements on the plane at x or at y [m], the other of them not a number."""
    if math.isnan(y):
        found = fields_on_plane(load.turned(), body, depths, x=math.nan, y=x)
        return BodyFields(
            found.y, found.x, found.z, found.yy_stress, found.xx_stress, found.zz_stress, found.xy_stress,
            found.yz_stress, found.xz_stress, found.y_displacement, found.x_displacement, found.z_displacement,
        )  # fmt: skip
    field, unit = field_below(load, body)
    lines = np.stack([field.across(y - load.corner[1], float(z)) for z in depths], axis=-1)
    along, deep = np.meshgrid(load.places[0], depths, indexing="ij")
    return _scaled((along, np.full(along.shape, y), deep), lines, unit)


def _scaled(places: tuple[Array, Array, Array], found: Array, unit: float) -> BodyFields:
    return BodyFields(*places, *found[:STRESSES], *(unit * found[STRESSES:]))


class BelowSurface:
    """What a solution offers whose pressures and tractions on the surface are known pixel by pixel."""

    @property
    def surface_load(self) -> SurfaceLoad:
        """What acts on the first body."""
        raise NotImplementedError

    @property
    def _medium(self) -> object:
        raise NotImplementedError

    def _on_body(self, below: bool) -> tuple[SurfaceLoad, Body]:
        load, medium = self.surface_load, self._medium
        if offers(medium, LayerStack):
            if below:
                return load, medium
            if isinstance(medium.second, Elastic):
                return load.reversed(), medium.second
        elif not isinstance(medium, HomogeneousMedium):
            raise OutsideValidity(
                f"{type(self).__name__}: the stress below the surface of a height map on a {type(medium).__name__} is "
                "not known; give a HalfSpace or layers."
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
            If the body is rigid, graded or not isotropic, or a place in layers lies beside a map that stands alone.

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
            load, body = self._on_body(below)
            return greatest_stress(load, body if isinstance(body, Elastic) else solid_below(medium, below))
        return max(greatest_in_parts(self.surface_load, medium, parts), key=lambda spot: spot.value)
